"""Refusals of the lab, filled by Python and by the page. What the page says of a motion is in web/words."""

from __future__ import annotations

from typing import Final

LEAST_SPEED: Final = 1e-9
"""Critical speeds below this are not shown as speeds [m/s]."""

LAB: Final[dict[str, str]] = {
    "too_long": "duration = {duration:g} must be at most {most:g} s in the lab; the library itself has no such limit.",
    "too_many_parts": "hoop.parts has {parts} parts and must have at most {most} in the lab.",
    "too_many_turns": (
        "duration = {duration:g} s at this speed and radius is about {turns:.0e} revolutions and must be at most {most:.0e} "
        "in the lab; the library itself has no such limit."
    ),
    "too_stiff": (
        "contact.stiffness, contact.slip_speed and duration need about {steps:.0e} steps of integration and must need at "
        "most {most:.0e} in the lab."
    ),
    "too_many_changes": "changes has {pairs} pairs and must have at most {most} in the lab.",
    "too_many_cells": "x.cells times y.cells = {cells} must be at most {most} in the lab.",
    "equal_axes": "x.path and y.path are both {path!r} and must differ.",
    "two_axes": "{one} and {other} cannot both be axes: they say the same thing in two ways.",
    "rigid_maps": "contact.model = 'compliant' must be 'rigid' for a map.",
    "cell_turns": "A cell of this map is about {turns:.0e} revolutions and must be at most {most:.0e} in the lab.",
    "map_turns": (
        "x and y make {cells} cells of about {turns:.2g} revolutions in all, and must be at most {most:.0e} in the lab; take "
        "fewer cells, lower speeds or a shorter duration."
    ),
    "doubt": (
        "After {time} s the motion depends on more digits than this page computes. Run it in hophoop lab or Python for the "
        "exact result."
    ),
    "compliant_changes": "With a compliant contact no derivatives are computed: choose the rigid contact model.",
    "not_a_pair": "changes holds {change}, which is not a pair of path and value.",
    "film_too_long": "duration = {duration:g} must be at most {most:g} s for a film from the lab.",
    # one value, after the field and how it was given
    "window": "must be four numbers, θ from and to [rad], θ̇ from and to [rad/s], each pair rising",
    "times": "must be two times, from and to [s], rising from 0",
    "number_path": "must be a number's path, not that of a word",
    "one_of": "must be one of {known}",
}
"""Refusals of the lab, filled as by `str.format`."""
