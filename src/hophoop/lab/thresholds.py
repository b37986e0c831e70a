"""What theory says about the hoop of a scenario, as the page lists it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from hophoop import theory
from hophoop.lab.words import degrees
from hophoop.scenario import Plane, Scenario


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
    known = {quantity.key: quantity for quantity in theory.summary(scenario)}
    found: list[dict[str, Any]] = []

    def add(key: str, label: str, quantity: str, say: Callable[[float], str]) -> None:
        there = known.get(quantity)
        if there is None or there.value is None:
            return
        value = there.value if math.isfinite(there.value) else None
        found.append({"key": key, "label": label, "value": value, "unit": there.unit, "text": say(there.value)})

    if plane.gravity <= 0.0:
        add("painleve", PARADOX_LABEL, "painleve_friction", lambda mu: _painleve(mu, known, plane))
        return found
    if hoop.massless:
        loss = theory.massless_loss(scenario.start.speed or 0.0, hoop.radius, plane)
        why = "friction is used up" if loss.by_friction else "the contact force is gone"
        add("loss", "End of rolling", "massless_loss_angle", lambda angle: f"at {degrees(angle)} {why}")
        return found
    if plane.slope >= 0.0:
        push = "any push is enough"
        add("first_slip", "Slips", "first_slip_speed", lambda speed: _above(speed, "would slip", push))
        add("first_hop", "Hops", "first_hop_speed", lambda speed: _above(speed, "would hop in its first turn", push))
        at_once = "would hop at once"
        add("immediate_hop", "Hops at once", "immediate_hop_speed", lambda speed: _above(speed, at_once, "at any speed"))
    else:
        # uphill the speed changes with every turn: there is no one speed from which on it happens in the first
        found.append({"key": "uphill", "label": "Slips, hops", "value": None, "unit": "", "text": UPHILL})
    add("needed_friction", "Friction for pure rolling", "needed_friction", lambda mu: _needed(mu, plane))
    add("painleve", PARADOX_LABEL, "painleve_friction", lambda mu: _painleve(mu, known, plane))
    jams = [quantity for key, quantity in known.items() if key.startswith("jam_angle")]
    places = ", ".join(degrees(jam.value) for jam in jams if jam.value is not None)
    add("jam", "Dynamic jam", "jam_angle", lambda angle: f"can end a slip at {places}")
    if hoop.eccentricity > 0.0:
        add("rest", "Rests stably", "stable_angle", lambda angle: f"with the load at {degrees(angle)}")
    return found


LEAST_SPEED = 1e-9  # m/s
UPHILL = "no threshold uphill (β < 0): whether it slips or hops hangs on where it turns back; the map shows it"
PARADOX_LABEL = "Painlevé’s paradox"


def _above(speed: float, would: str, always: str) -> str:
    if speed < LEAST_SPEED:  # a number that is no speed but the least that doubles hold
        return f"{would}: {always}"
    if not math.isfinite(speed):
        return "never, at any speed"
    return f"{would} above {speed:.4g} m/s"


def _needed(mu: float, plane: Plane) -> str:
    if not math.isfinite(mu):
        return "no friction keeps it rolling"
    return f"μ = {mu:.3g} would keep it rolling ({'enough here' if mu <= plane.mu_static else 'more than there is'})"


def _painleve(mu: float, known: Mapping[str, theory.Quantity], plane: Plane) -> str:
    angle = known["painleve_angle"].value
    whether = "possible here" if mu <= plane.mu_kinetic else "not here"
    return "never" if angle is None else f"from μ = {mu:.3g} on, at {degrees(angle)}: {whether}"
