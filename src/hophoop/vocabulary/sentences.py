"""Refusals of the lab, filled by Python and by the page. What the page says of a motion is in web/words."""

from __future__ import annotations

from typing import Final

LEAST_SPEED: Final = 1e-9
"""Critical speeds below this are not shown as speeds [m/s]."""

LAB: Final[dict[str, str]] = {
    "too_long": "duration = {duration:g} must be at most {most:g} s in the lab; the library itself has no such limit.",
    "too_many_parts": "hoop.parts has {parts} parts and must have at most {most} in the lab.",
    "too_many_changes": "changes has {pairs} pairs and must have at most {most} in the lab.",
    "too_many_cells": "x.cells times y.cells = {cells} must be at most {most} in the lab.",
    "equal_axes": "x.path and y.path are both {path!r} and must differ.",
    "two_axes": "{one} and {other} cannot both be axes: they say the same thing in two ways.",
    "rigid_maps": "contact.model = 'compliant' must be 'rigid' for a map.",
    "doubt": "After {time} s doubles cannot decide what happens next. Run it with `--digits 30` for the exact answer.",
    "compliant_changes": "With a compliant contact no derivatives are computed: choose the rigid contact model.",
    "film_too_long": "duration = {duration:g} must be at most {most:g} s for a film from the lab.",
}
"""Refusals of the lab, filled as by `str.format`."""
