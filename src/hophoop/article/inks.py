"""SVG figures for light and dark pages, with colours that follow the reader's preference."""

from __future__ import annotations

import re

from hophoop.plots.style import ON_COLOR, ON_PAPER
from hophoop.vocabulary import colors

PAPER, INK = "#14171B", "#ECEEF0"  # of dark pages
GRAY_LEVEL = 12  # maximum difference of red, green and blue in a gray
A_SCALE = 24  # with more colours there is a colour scale, whose bar is an image: colours stay
_INK = re.compile(r"(fill|stroke): (#[0-9a-fA-F]{6})")


def for_both(svg: str) -> str:
    """Replace the colours of Matplotlib's SVG by variables, with values for light and for dark pages.

    A drawing with colours that fade into white paper stays on paper.
    """
    body = svg[svg.index("<svg") :]
    if f'id="{ON_PAPER}"' in body:
        return body
    found = sorted({match[2].lower() for match in _INK.finditer(body)} | {"#000000"})
    body = _INK.sub(lambda match: f"{match[1]}: var(--i{match[2][1:].lower()})", body)
    light = "".join(f"--i{color[1:]}:{color};" for color in found)
    scale = sum(not _gray(color) for color in found) > A_SCALE
    dark = "".join(f"--i{color[1:]}:{color if scale and not _gray(color) else in_the_dark(color)};" for color in found)
    style = (
        f"<style>svg{{{light}fill:var(--i000000)}}"
        f"@media (prefers-color-scheme:dark){{svg{{{dark}}}}}"
        # text on a colour keeps its ink, since the colour stays
        f"[id^='{ON_COLOR}']{{{light}fill:#000000}}</style>"
    )
    start = body.index(">") + 1
    return body[:start] + style + body[start:]


def in_the_dark(color: str) -> str:
    """Return a colour for dark pages: grays are inverted, other colours lightened."""
    if not _gray(color):
        return colors.on_dark(color)
    share = sum(colors.rgb(color)) / (3 * 255.0)
    dark, light = colors.rgb(PAPER), colors.rgb(INK)
    return "#" + "".join(f"{round(b + share * (a - b)):02X}" for a, b in zip(dark, light, strict=True))


def _gray(color: str) -> bool:
    parts = colors.rgb(color)
    return max(parts) - min(parts) <= GRAY_LEVEL
