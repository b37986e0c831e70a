"""Bridge between the oracles' cases and the program's public face."""

import json
import math
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp

import hophoop as hh
from checkout import DATA
from hophoop.vocabulary.names import LAW_CODES
from oracles import hybrid
from oracles.cases import Case

STATE = ("x", "height", "angle", "vx", "vy", "omega")


def scenario_of(case, **plane):
    """The scenario of a case."""
    hoop = {name: getattr(case, name) for name in ("radius", "mass", "eccentricity", "inertia_ratio")}
    surface = {name: getattr(case, name) for name in hh.Plane.model_fields if name != "mu"} | plane
    if case.rolling:
        start = hh.Start.rolling(speed=case.vx, angle=case.angle, x=case.x)
    else:
        start = hh.Start(**{name: getattr(case, name) for name in STATE})
    return hh.Scenario(hoop=hh.Hoop(**hoop), plane=hh.Plane(**surface), start=start, duration=case.duration)


def simulate(case, duration=None):
    """The program's motion for a case."""
    scenario = scenario_of(case)
    return hh.simulate(scenario.replace("duration", duration) if duration else scenario)


def reference(name, number=float):
    """A reference motion, its numbers as floats or as something with more digits."""

    def numbers(thing):
        if isinstance(thing, dict):
            return {key: numbers(item) for key, item in thing.items()}
        if isinstance(thing, list):
            return [numbers(item) for item in thing]
        try:
            return number(thing) if isinstance(thing, str) else thing
        except ValueError:
            return thing

    return numbers(json.loads((DATA / f"{name}.json").read_text(encoding="utf-8")))


def highest_apexes(events):
    """The same events with the oracles' apexes, all maxima of the gap, only the highest of each flight.

    A flight that is highest at its own beginning has no apex.
    """
    kept, apex, begin = [], None, 0.0
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


def essential(events):
    """Events without the marks of beginning and end and without notes that leave the motion as it is.

    The apex of a flight that the end of the run cuts short is left out: the highest point is not yet known. A turn after which
    the hoop slips at once is one event.
    """
    kept = []
    for event in events:
        if event["kind"] == "slip_start" and kept and (kept[-1]["kind"], kept[-1]["t"]) == ("turn", event["t"]):
            kept[-1] = kept[-1] | {"to": event["to"]}
        elif event["kind"] not in ("start", "kane_gain", "bounce_limit"):
            kept.append(event)
    if kept and kept[-1]["kind"] == "end":
        kept.pop()
        if kept and kept[-1]["kind"] == "apex":
            kept.pop()
    return kept


def program_events(motion):
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


def compare_events(motion, true, digits, names=("t", "x", "height", "angle", "omega"), since=-1):
    """Assert that the first events of a motion, from a time on, have so many digits of the true ones."""
    ours = essential([event for event in program_events(motion) if event["t"] > since])
    for mine, right in zip(ours, essential(highest_apexes(true)), strict=False):
        assert mine["kind"] == right["kind"], (mine, right["kind"])
        for name in names:
            with mp.workdps(50):
                known = Fraction(mp.nstr(mp.mpf(right[name]), 50))
            off = abs(Fraction(mine[name]) - known)
            assert off <= Fraction(1, 10**digits) * max(1, abs(known)), (right["kind"], name, float(off))


def draw(seed):
    """A scenario of any mode, law and slope."""
    random = np.random.default_rng(seed)
    eccentricity = float(random.uniform(0.0, 0.95))
    mu = float(random.choice([0.0, random.uniform(0.05, 1.5)], p=[0.1, 0.9]))
    radius = float(random.choice([1.0, random.uniform(0.1, 2.0)]))
    speed = math.sqrt(9.81 * radius)
    values = {
        "radius": radius,
        "mass": float(random.choice([1.0, random.uniform(0.1, 5.0)])),
        "eccentricity": eccentricity,
        "inertia_ratio": float(random.uniform(0.05, 1.0) * (1.0 - eccentricity**2)),
        "slope": float(random.choice([0.0, random.uniform(-0.5, 0.5)])),
        "mu_static": mu * float(random.choice([1.0, random.uniform(1.0, 1.5)])),
        "mu_kinetic": mu,
        "restitution": float(random.choice([0.0, 0.0, 0.3])),
        "impact_law": str(random.choice(sorted(LAW_CODES))),
        "angle": float(random.uniform(-math.pi, math.pi)),
        "vx": float(random.normal() * speed),
        "omega": float(random.normal() * 1.5 * speed / radius),
    }
    kind = random.choice(["roll", "slip", "drop"], p=[0.5, 0.25, 0.25])
    if kind == "roll":
        values["rolling"] = True
    elif kind == "drop":
        values["height"] = float(random.uniform(0.01, 0.6) * radius)
        values["vy"] = float(random.normal() * 0.3 * speed)
    return Case(f"random {seed}", **values, duration=2.5, max_events=12)


def compare(case):
    """Check that SciPy's integration has the same events, and the same state between them, to what DOP853 can give."""
    truth, motion = hybrid.solve(case), simulate(case)
    assert abs(motion.ledger.residual) <= 1e-11 * motion.ledger.range
    true, ours = essential(highest_apexes(truth.events)), essential(program_events(motion))
    if truth.status == "event_limit":
        ours = ours[: len(true)]
    elif motion.status == truth.status == "at_rest" and true[-1]["kind"] == "stick":
        assert ours.pop()["kind"] == "rest"  # where slip stops for good the integrator notes one event
    assert [event["kind"] for event in ours] == [event["kind"] for event in true], case
    for mine, right in zip(ours, true, strict=True):
        for name in ("t", *STATE):
            assert mine[name] == pytest.approx(right[name], rel=1e-9, abs=1e-9), (case, right["kind"], name)
        if not right["kind"].startswith("painleve"):
            assert mine["to"] == right["to"], (case, right["t"])
    for part in (0.131, 0.377, 0.522, 0.716, 0.943):
        t = part * truth.end
        sample, right = motion.at(t), truth.at(t)
        assert sample.mode == right["mode"]
        right["rolling_resistance"] = right["rolling"]
        for name in (*STATE, "rolling_resistance"):
            assert getattr(sample, name) == pytest.approx(right[name], rel=1e-9, abs=1e-9), (case, t, name)
    return motion
