"""Bridge between the oracles' cases, exact reference data and motions in many digits."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from mpmath import mp, mpf

import hophoop as hh
from oracles.cases import Case

DATA = Path(__file__).resolve().parent / "data"
HOOP = hh.Hoop.ideal(0.75)
STATE = ("x", "height", "angle", "vx", "vy", "omega")


def scenario_of(case: Case, **plane: Any) -> hh.Scenario:
    """The scenario of a case."""
    hoop = hh.Hoop(radius=case.radius, mass=case.mass, eccentricity=case.eccentricity, inertia_ratio=case.inertia_ratio)
    names = ("gravity", "slope", "mu_static", "mu_kinetic", "restitution", "impact_law", "painleve")
    surface = hh.Plane(**{**{name: getattr(case, name) for name in names}, **plane})
    if case.rolling:
        start = hh.Start.rolling(speed=case.vx, angle=case.angle, x=case.x)
    else:
        start = hh.Start(x=case.x, height=case.height, angle=case.angle, vx=case.vx, vy=case.vy, omega=case.omega)
    return hh.Scenario(hoop=hoop, plane=surface, start=start, duration=case.duration)


def stored(name: str) -> dict[str, Any]:
    """Reference data with all of their digits."""

    def numbers(thing: Any) -> Any:
        if isinstance(thing, dict):
            return {key: numbers(item) for key, item in thing.items()}
        if isinstance(thing, list):
            return [numbers(item) for item in thing]
        try:
            return mpf(thing) if isinstance(thing, str) else thing
        except ValueError:
            return thing

    with mp.workdps(60):
        return numbers(json.loads((DATA / f"{name}.json").read_text(encoding="utf-8")))


def events_of(motion: Any) -> list[dict[str, Any]]:
    """A precise motion's events in the oracles' form, as mpf."""
    listed = []
    with mp.workdps(60):
        for event in motion.events:
            listed.append(
                {
                    "kind": event.kind,
                    "from": event.from_mode,
                    "to": event.to_mode,
                    **{name: mpf(str(getattr(event, name))) for name in ("t", *STATE)},
                }
            )
    return listed


def precise(hoop=HOOP, plane=None, start=None, duration=2.0, digits=30):
    return hh.simulate(hoop, plane or hh.Plane(), start or hh.Start(), duration=duration, digits=digits)


def rolling(speed, mu=1.0, hoop=HOOP, angle=0.0, **rest):
    return precise(hoop, hh.Plane(mu=mu), hh.Start.rolling(speed, angle=angle), **rest)
