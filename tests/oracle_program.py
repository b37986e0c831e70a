"""Bridge between the oracles' cases and the program's public face."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import hophoop as hh
from oracles.cases import Case

DATA = Path(__file__).resolve().parent / "data"
STATE = ("x", "height", "angle", "vx", "vy", "omega")


def scenario_of(case: Case, **plane: Any) -> hh.Scenario:
    """The scenario of a case."""
    hoop = {name: getattr(case, name) for name in ("radius", "mass", "eccentricity", "inertia_ratio")}
    surface = {name: getattr(case, name) for name in hh.Plane.model_fields if name != "mu"} | plane
    if case.rolling:
        start = hh.Start.rolling(speed=case.vx, angle=case.angle, x=case.x)
    else:
        start = hh.Start(**{name: getattr(case, name) for name in STATE})
    return hh.Scenario(hoop=hh.Hoop(**hoop), plane=hh.Plane(**surface), start=start, duration=case.duration)


def simulate(case: Case, duration: float | None = None) -> hh.Trajectory:
    """The program's motion for a case."""
    scenario = scenario_of(case)
    return hh.simulate(scenario.replace("duration", duration) if duration else scenario)


def reference(name: str, number: Callable[[str], Any] = float) -> dict[str, Any]:
    """A reference motion, its numbers as floats or as something with more digits."""

    def numbers(thing: Any) -> Any:
        if isinstance(thing, dict):
            return {key: numbers(item) for key, item in thing.items()}
        if isinstance(thing, list):
            return [numbers(item) for item in thing]
        try:
            return number(thing) if isinstance(thing, str) else thing
        except ValueError:
            return thing

    document: dict[str, Any] = numbers(json.loads((DATA / f"{name}.json").read_text(encoding="utf-8")))
    return document


def highest_apexes(events: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The same events with the oracles' apexes, all maxima of the gap, only the highest of each flight.

    A flight that is highest at its own beginning has no apex.
    """
    kept: list[dict[str, Any]] = []
    apex: dict[str, Any] | None = None
    begin = 0.0
    for event in events:
        if event["kind"] == "apex":
            if event["height"] > (apex["height"] if apex else begin):
                apex = event
            continue
        if apex:
            kept.append(apex)
        apex, begin = None, event["height"]
        kept.append(event)
    return [*kept, apex] if apex else kept


def essential(events: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Events without the marks of beginning and end and without notes that leave the motion as it is.

    The apex of a flight that the end of the run cuts short is left out: the highest point is not yet known.
    """
    kept = [event for event in events if event["kind"] not in ("start", "kane_gain", "bounce_limit")]
    if kept and kept[-1]["kind"] == "end":
        kept.pop()
        if kept and kept[-1]["kind"] == "apex":
            kept.pop()
    return kept


def program_events(motion: hh.Trajectory) -> list[dict[str, Any]]:
    """The program's events in the oracles' form."""
    velocities = ("vx", "vy", "omega")
    names = ("t", *STATE, "kind", "friction", "impact_normal", "impact_tangential", "collision")
    return [
        {
            **{name: getattr(event, name) for name in names},
            "from": event.from_mode,
            "to": event.to_mode,
            "before": {name: getattr(event.before, name) for name in velocities},
            "impulse": {"normal": event.impulse_normal, "tangential": event.impulse_tangential},
        }
        for event in motion.events
    ]
