"""Estimate of the work of a motion with compliant contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hophoop.scenario import Scenario

PART = 0.05  # share of the motion that is tried
MANY = 100_000  # steps, about 1 s; shorter motions are not announced


def work_ahead(scenario: Scenario) -> str | None:
    """Return a sentence on the steps of a compliant motion, estimated from its first part; None for few steps."""
    if scenario.contact.model != "compliant":
        return None
    from hophoop.kernel.compliant.run import MAX_STEPS
    from hophoop.simulation.simulate import simulate

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
