"""Thresholds of theory for the hoop of a scenario, as the page lists them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from hophoop import theory
from hophoop.lab.words import degrees
from hophoop.scenario import Plane, Scenario
from hophoop.vocabulary.sentences import LEAST_SPEED, THEORY


def thresholds(scenario: Scenario) -> list[dict[str, Any]]:
    """Return the thresholds of theory for the hoop of a scenario.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    thresholds : list of dict
        `key`, `label`, `value` (None if there is none), `unit` and `text`.
    """
    hoop, plane = scenario.hoop, scenario.plane
    known = {quantity.key: quantity for quantity in theory.summary(scenario)}
    found: list[dict[str, Any]] = []

    def add(key: str, quantity: str, say: Callable[[float], str]) -> None:
        there = known.get(quantity)
        if there is None or there.value is None:
            return
        value = there.value if math.isfinite(there.value) else None
        found.append({"key": key, "label": THEORY[key], "value": value, "unit": there.unit, "text": say(there.value)})

    if plane.gravity <= 0.0:
        add("painleve", "painleve_friction", lambda mu: _painleve(mu, known, plane))
        return found
    if hoop.massless:
        loss = theory.massless_loss(scenario.start.speed or 0.0, hoop.radius, plane)
        why = "loss_by_friction" if loss.by_friction else "loss_of_contact"
        add("loss", "massless_loss_angle", lambda angle: THEORY[why].format(where=degrees(angle)))
        return found
    if plane.slope >= 0.0:
        add("first_slip", "first_slip_speed", lambda speed: _above(speed, "would_slip", "any_push"))
        add("first_hop", "first_hop_speed", lambda speed: _above(speed, "would_hop", "any_push"))
        add("immediate_hop", "immediate_hop_speed", lambda speed: _above(speed, "would_hop_at_once", "any_speed"))
    else:
        # uphill the speed changes with every revolution: no single speed is the threshold for the first one
        found.append({"key": "uphill", "label": THEORY["uphill"], "value": None, "unit": "", "text": THEORY["no_threshold"]})
    add("needed_friction", "needed_friction", lambda mu: _needed(mu, plane))
    add("painleve", "painleve_friction", lambda mu: _painleve(mu, known, plane))
    jams = [quantity for key, quantity in known.items() if key.startswith("jam_angle")]
    places = ", ".join(degrees(jam.value) for jam in jams if jam.value is not None)
    add("jam", "jam_angle", lambda angle: THEORY["jam_at"].format(places=places))
    if hoop.eccentricity > 0.0:
        add("rest", "stable_angle", lambda angle: THEORY["rest_at"].format(where=degrees(angle)))
    return found


def _above(speed: float, would: str, always: str) -> str:
    if speed < LEAST_SPEED:  # not a physical speed but the smallest double
        return THEORY[always].format(would=THEORY[would])
    if not math.isfinite(speed):
        return THEORY["no_speed"]
    return THEORY["above"].format(would=THEORY[would], speed=f"{speed:.4g}")


def _needed(mu: float, plane: Plane) -> str:
    if not math.isfinite(mu):
        return THEORY["no_friction"]
    return THEORY["friction_enough" if mu <= plane.mu_static else "friction_short"].format(mu=f"{mu:.3g}")


def _painleve(mu: float, known: Mapping[str, theory.Quantity], plane: Plane) -> str:
    angle = known["painleve_angle"].value
    if angle is None:
        return THEORY["never"]
    return THEORY["paradox_here" if mu <= plane.mu_kinetic else "paradox_not_here"].format(mu=f"{mu:.3g}", where=degrees(angle))
