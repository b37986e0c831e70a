"""Scenarios over the whole of the supported ranges: magnitudes log-uniform, and the values at which things vanish.

A draw takes its numbers from a `Source`: NumPy's generator at night, where (seed, index) tells which scenario it is, or
hypothesis, which makes one that fails as plain as it can.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS, Range

ANGLES = (0.0, math.pi / 2, math.pi, -math.pi, 2 * math.pi, math.nextafter(math.pi, 4.0), 1e-9, -1e-300, 3.0, 100.0, 1e6)
TINY = 1e-300


USUAL = ("usual", "usual", "near", "near", "any", "any", "special")
EXTREME = ("any", "any", "any", "special", "edge")  # every magnitude, the ends, and the next doubles to them


class Source(Protocol):
    """Where numbers are drawn from."""

    kinds: tuple[str, ...]  # of numbers, as `of_range` chooses among them

    def between(self, least: float, most: float) -> float:
        """A number, both ends included."""

    def choice(self, values: Sequence[Any]) -> Any:
        """One of the values."""


class Seeded:
    """A source for which (seed, index) tells everything."""

    def __init__(self, seed: int, index: int, kinds: tuple[str, ...] = USUAL) -> None:
        self._random = np.random.default_rng([seed, index])
        self.kinds = kinds

    def between(self, least: float, most: float) -> float:
        return float(self._random.uniform(least, most))

    def choice(self, values: Sequence[Any]) -> Any:
        return values[int(self._random.integers(len(values)))]


def magnitude(source: Source, least: float, most: float) -> float:
    """A positive number, log-uniform."""
    return min(max(10.0 ** source.between(math.log10(least), math.log10(most)), least), most)


def of_range(source: Source, allowed: Range, usual: float) -> float:
    """A number of a range: an end, a special value, one of any magnitude, or one like the usual one."""
    kind = source.choice(source.kinds)
    if kind == "usual":
        return usual
    sign = source.choice([1.0, -1.0]) if allowed.least < 0.0 else 1.0
    if kind == "near":
        value = sign * (abs(usual) or 1.0) * magnitude(source, 0.1, 10.0)
    elif kind == "any":
        value = sign * magnitude(source, allowed.least if allowed.least > 0.0 else TINY, allowed.most)
        if allowed.least <= 0.0 and source.choice([True, False]):
            value = sign * magnitude(source, 1e-6, allowed.most)
    elif kind == "edge":
        value = math.nextafter(*source.choice([(allowed.least, 1.0), (allowed.most, 1.0), (1.0, 0.0), (0.0, 1.0)]))
    else:
        value = source.choice([allowed.least, allowed.most, *allowed.also, 1.0])
    return value if allowed.holds(value) else min(max(value, allowed.least), allowed.most)


def hoop(source: Source) -> dict[str, Any]:
    """Ideal, of any (ε, κ), nearly massless and massless hoops."""
    keys: dict[str, Any] = {
        "radius": of_range(source, RANGES["hoop.radius"], 1.0),
        "mass": of_range(source, RANGES["hoop.mass"], 1.0),
    }
    kind = source.choice(["ideal", "ideal", "general", "light", "massless"])
    if kind == "ideal":
        keys["load_fraction"] = source.choice([0.0, 0.5, 0.75, source.between(0.0, 0.999)])
    elif kind == "general":
        keys["eccentricity"] = source.choice([0.0, 1.0, source.between(0.0, 1.0), magnitude(source, TINY, 1.0)])
        keys["inertia_ratio"] = of_range(source, Range(1e-12, 1e6), 0.4)
    elif kind == "light":
        keys["load_fraction"] = 1.0 - magnitude(source, 1e-12, 1e-2)
    else:
        keys |= {"eccentricity": 1.0, "inertia_ratio": 0.0}
    return keys


def plane(source: Source, massless: bool, compliant: bool) -> dict[str, Any]:
    """Without gravity and with a lot, smooth, rough and infinitely rough, level and steep."""
    static = of_range(source, RANGES["plane.mu"], 1.0)
    if compliant and math.isinf(static):
        static = 1.0
    ratio = source.choice([1.0, 1.0, 0.0, source.between(0.0, 1.0)]) if math.isfinite(static) else 1.0
    slope = source.choice([0.0, 0.0, source.between(-1.2, 1.2), source.between(-1.57, 1.57), magnitude(source, TINY, 1.0)])
    return {
        "gravity": of_range(source, RANGES["plane.gravity"], 9.81),
        "slope": 0.0 if massless else slope,
        "mu_static": static,
        "mu_kinetic": static * ratio,
        "restitution": source.choice([0.0, 0.0, 1.0, source.between(0.0, 1.0), magnitude(source, TINY, 1.0)]),
        "impact_law": source.choice(list(LAW_CODES)),
        "painleve": source.choice(["flight", "impact"]),
    }


def start(source: Source) -> dict[str, Any]:
    """Rolling, slipping, flying, striking and at rest."""
    angle = source.choice([source.between(-4.0, 4.0), source.choice(ANGLES), of_range(source, RANGES["start.angle"], 1.0)])
    keys = {"x": source.choice([0.0, 0.0, of_range(source, RANGES["start.x"], 1.0)]), "angle": angle}
    kind = source.choice(["rolling", "rolling", "contact", "contact", "air", "strike", "rest"])
    speed = RANGES["start.speed"]
    if kind == "rest":
        return keys
    if kind == "rolling":
        return {**keys, "speed": of_range(source, speed, 3.1)}
    keys |= {"vx": of_range(source, speed, 3.1), "omega": of_range(source, RANGES["start.omega"], 3.1)}
    if kind == "contact":
        return keys
    keys["vy"] = of_range(source, speed, 1.0)
    if kind == "strike":
        return {**keys, "vy": -abs(keys["vy"])}
    return {**keys, "height": of_range(source, RANGES["start.height"], 1.0)}


def contact(source: Source, compliant: bool, body: dict[str, Any], where: dict[str, Any]) -> dict[str, Any]:
    """Rigid, or compliant with any law, of a stiffness that goes with the hoop."""
    limit = source.choice([1, 7, 400, 400, 2000, 2000])
    if not compliant:
        return {"model": "rigid", "max_events": limit}
    keys: dict[str, Any] = {
        "model": "compliant",
        "max_events": limit,
        "law": source.choice(["kelvin-voigt", "hunt-crossley"]),
        "friction": source.choice(["tanh", "linear", "bristle"]),
        "rtol": source.choice([None, None, 1e-6, magnitude(source, 1e-10, 1e-3)]),
    }
    second = math.sqrt(body["radius"] / (where["gravity"] or 1.0))
    spring = body["mass"] / second**2
    usual = {
        "stiffness": (RELATIVE_STIFFNESS, 1e6, spring),
        "slip_speed": (RELATIVE_SLIP_SPEED, 1e-4, body["radius"] / second),
        "tangential_stiffness": (RELATIVE_STIFFNESS, 1e6, spring),
    }
    for name, (relative, value, unit) in usual.items():
        if source.choice([True, False]):
            most = RANGES[f"contact.{name}"]
            keys[name] = min(max(of_range(source, relative, value) * unit, most.least), most.most)
    damping = source.choice(["none", "damping", "restitution"])
    if damping == "damping":
        keys["damping"] = of_range(source, RANGES["contact.damping"], 100.0)
    elif damping == "restitution":
        keys["restitution"] = source.choice([0.0, 1.0, source.between(0.0, 1.0), magnitude(source, TINY, 1.0)])
    return {name: value for name, value in keys.items() if value is not None}


def scenario(source: Source, share_compliant: int = 3, turns: float | None = None) -> dict[str, Any]:
    """The keys of a scenario; one in so many is compliant, and `turns` bounds the work by a shorter duration."""
    body = hoop(source)
    massless = body.get("inertia_ratio") == 0.0
    compliant = not massless and source.choice(range(share_compliant)) == 0
    where = plane(source, massless, compliant)
    begin = start(source)
    keys = {
        "hoop": body,
        "plane": where,
        "start": begin,
        "duration": source.choice([1.0, 6.0, of_range(source, RANGES["duration"], 6.0)]),
        "contact": contact(source, compliant, body, where),
    }
    if not massless:  # drawn last, so that all else of an index is as it was before there was such a thing
        resistance = [0.0, 0.0, 0.0, 0.0, source.between(0.0, 0.1), of_range(source, RANGES["plane.rolling_resistance"], 0.01)]
        where["rolling_resistance"] = source.choice(resistance)
    if turns is not None:
        rate = abs(begin.get("omega", 0.0)) + (abs(begin.get("speed", 0.0)) + abs(begin.get("vx", 0.0))) / body["radius"]
        rate += 10.0 * math.sqrt(where["gravity"] / body["radius"])
        if compliant:
            rate += 0.01 * math.sqrt(keys["contact"].get("stiffness", 0.0) / body["mass"])
        most = 2.0 * math.pi * turns / rate if rate > 0.0 else math.inf
        keys["duration"] = min(keys["duration"], max(most, RANGES["duration"].least))
    return keys
