"""The colours in use: those of Okabe and Ito (2008), distinct with every kind of colour blindness, and two grays."""

from __future__ import annotations

from typing import Final

BLACK: Final = "#000000"
ORANGE: Final = "#E69F00"
SKY: Final = "#56B4E9"
GREEN: Final = "#009E73"
YELLOW: Final = "#F0E442"
BLUE: Final = "#0072B2"
VERMILION: Final = "#D55E00"
PURPLE: Final = "#CC79A7"

GRAY: Final = "#6E6E6E"
LIGHT_GRAY: Final = "#D9D9D9"
