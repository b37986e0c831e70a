"""How much work a motion with compliant contact is, told before it starts."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hophoop.scenario import Scenario

PART = 0.05  # of the motion is tried
MANY = 100_000  # steps, about a second: fewer are not worth a word


def work_ahead(scenario: Scenario) -> str | None:
    """A sentence on the steps that a compliant motion needs, from those of its first part; None where they are few."""
    if scenario.contact.model != "compliant":
        return None
    from hophoop.compliant.kernel import MAX_STEPS
    from hophoop.simulation import simulate

    first = simulate(scenario.replace("duration", max(PART * scenario.duration, 1e-9)))
    steps = len(first.tables["segments"])
    share = first.duration / scenario.duration
    if first.status == "at_rest" or share <= 0.0 or steps / share < MANY:
        return None
    words = f"The first {100 * share:.2g} % of the motion take {steps:,} steps: about {steps / share:,.0f} in all"
    if steps / share <= MAX_STEPS:
        return words + "."
    fewer = "a shorter duration, a lower contact.stiffness or more damping needs fewer"
    return f"{words}, of which {MAX_STEPS:,} are computed; {fewer}."
