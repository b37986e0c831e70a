"""Bounds of what the lab computes at once: of a motion and a map."""

from __future__ import annotations

from typing import Final

from hophoop.maps.grid.axes import TWO_AXES
from hophoop.scenario import Scenario

DURATION: Final = 600.0  # of a motion [s]
EVENTS: Final = 20_000  # of a motion [1]
PARTS: Final = 64  # of a hoop [1]
SAMPLES: Final = 20_001  # rows of a table of states [1]
CELL_EVENTS: Final = 2000  # of a motion in a map [1]

LAB: Final[dict[str, str]] = {
    "too_long": "duration = {duration:g} must be at most {most:g} s in the lab; the library itself has no such limit.",
    "too_many_parts": "hoop.parts has {parts} parts and must have at most {most} in the lab.",
    "two_axes": TWO_AXES,
    "rigid_maps": "contact.model = 'compliant' must be 'rigid' for a map.",
    "doubt": "After {time} s doubles cannot decide what happens next. Run it with `--digits 30` for the exact answer.",
    "compliant_changes": "With a compliant contact no derivatives are computed: choose the rigid contact model.",
}
"""Refusals of the lab, filled by Python and by the page as by `str.format`. What the page says of a motion is in lab/words."""


def within(scenario: Scenario) -> Scenario:
    """Return the scenario with its number of events bounded, as the page does; the page refuses what is too long."""
    if scenario.contact.max_events > EVENTS:
        return scenario.replace("contact.max_events", EVENTS)
    return scenario
