"""What theory says about the hoop of a scenario, as the page lists it."""

from __future__ import annotations

import math
from typing import Any

from hophoop import theory
from hophoop.lab.words import degrees
from hophoop.scenario import Scenario


def thresholds(scenario: Scenario) -> list[dict[str, Any]]:
    """What theory says about the hoop of a scenario.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    thresholds : list of dict
        `key`, `label`, `value` (None where there is none), `unit` and `text`.
    """
    hoop, plane = scenario.hoop, scenario.plane
    found: list[dict[str, Any]] = []

    def add(key: str, label: str, value: float, unit: str, text: str) -> None:
        finite = float(value) if math.isfinite(value) else None
        found.append({"key": key, "label": label, "value": finite, "unit": unit, "text": text})

    speed = scenario.start.speed
    if hoop.massless:
        if plane.gravity > 0.0:
            loss = theory.massless_loss(speed or 0.0, hoop.radius, plane)
            why = "friction is used up" if loss.by_friction else "the contact force is gone"
            add("loss", "End of rolling", loss.angle, "rad", f"at {degrees(float(loss.angle))} {why}")
        return found
    if plane.gravity > 0.0 and plane.slope >= 0.0:
        _add_speeds(scenario, add)
    if speed is not None and plane.gravity > 0.0:
        need = theory.needed_friction(hoop, speed, plane)
        mu = float(need[0])
        whether = "enough here" if mu <= plane.mu_static else "more than there is"
        said = (
            f"μ = {mu:.3g} would keep it rolling ({whether})"
            if math.isfinite(mu)
            else "no friction keeps it rolling"
        )
        add("needed_friction", "Friction for pure rolling", mu, "1", said)
    least, angle = theory.painleve_minimum(hoop)
    if math.isfinite(least):
        beyond = float(least) <= plane.mu_kinetic
        add(
            "painleve", "Painlevé’s paradox", float(least), "1",
            f"from μ = {float(least):.3g} on, at {degrees(float(angle))}: "
            + ("possible here" if beyond else "not here"),
        )  # fmt: skip
    states = theory.jam_states(hoop, plane) if plane.gravity > 0.0 else ()
    if states:
        places = ", ".join(f"{degrees(state.angle)} ({state.mode})" for state in states)
        add("jam", "Dynamic jam", float(states[0].angle), "rad", f"can end a slip at {places}")
    _add_rest(scenario, add)
    return found


def _add_speeds(scenario: Scenario, add: Any) -> None:
    hoop, plane = scenario.hoop, scenario.plane
    critical = theory.critical_speeds(hoop, plane)
    slip, hop, immediate = (float(value) for value in critical)
    add("first_slip", "Slips", slip, "m/s", _above(slip, "would slip", "any push is enough"))
    add("first_hop", "Hops", hop, "m/s", _above(hop, "would hop in its first turn", "any push is enough"))
    add(
        "immediate_hop",
        "Hops at once",
        immediate,
        "m/s",
        _above(immediate, "would hop at once", "at any speed"),
    )


def _above(speed: float, would: str, always: str) -> str:
    if speed == 0.0:
        return f"{would}: {always}"
    if not math.isfinite(speed):
        return "never, at any speed"
    return f"{would} above {speed:.4g} m/s"


def _add_rest(scenario: Scenario, add: Any) -> None:
    if scenario.plane.gravity <= 0.0 or scenario.hoop.eccentricity == 0.0:
        return
    stable = [place for place in theory.equilibria(scenario.hoop, scenario.plane) if place.stable]
    if stable:
        angle = float(stable[0].angle)
        add("rest", "Rests stably", angle, "rad", f"with the load at {degrees(angle)}")
