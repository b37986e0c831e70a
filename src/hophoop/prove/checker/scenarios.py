"""The allowed fields of a certificate's scenario: a field that the checker does not read is not proved, so it is refused."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from hophoop.prove.checker.intervals import require

INFINITE = float("inf")
_LENGTH, _MASS, _SPEED = (1e-12, 1e6), (1e-12, 1e12), (-1e6, 1e6)
# least, most; then single values besides. In SI units.
NUMBERS: dict[str, tuple[float, ...]] = {
    "duration": (1e-9, 1e9),
    "hoop.radius": (1e-6, 1e6), "hoop.mass": _MASS, "hoop.load_fraction": (0.0, 1.0),
    "hoop.eccentricity": (0.0, 1.0), "hoop.inertia_ratio": (1e-12, 1e6, 0.0),
    "part.mass": _MASS, "part.at": (-1e6, 1e6), "part.inner_radius": (0.0, 1e6), "part.outer_radius": _LENGTH,
    "part.radius": _LENGTH, "part.length": _LENGTH,
    "plane.gravity": (1e-6, 1e6, 0.0), "plane.slope": (-1.57, 1.57), "plane.mu": (0.0, 1e6, INFINITE),
    "plane.mu_static": (0.0, 1e6, INFINITE), "plane.mu_kinetic": (0.0, 1e6, INFINITE),
    "plane.restitution": (0.0, 1.0), "plane.rolling_resistance": (0.0, 1.0),
    "start.x": (-1e9, 1e9), "start.height": (0.0, 1e6), "start.angle": (-1e6, 1e6), "start.speed": _SPEED,
    "start.vx": _SPEED, "start.vy": _SPEED, "start.omega": (-1e9, 1e9),
    "contact.max_events": (1, 1e7),
}  # fmt: skip
WORDS = {
    "plane.impact_law": {"newton", "poisson", "stronge"},
    "plane.painleve": {"flight", "impact"},
    "contact.model": {"rigid"},
    "part.shape": {"ring", "disk", "rod", "point_mass"},
    "part.direction": {"radial", "tangential"},
}
PARTS: dict[str, tuple[set[str], set[str]]] = {  # what a part has in addition to its mass, and what it may have
    "ring": ({"inner_radius", "outer_radius"}, set()),
    "disk": ({"radius"}, {"at"}),
    "rod": ({"length"}, {"at", "direction"}),
    "point_mass": ({"at"}, set()),
}
PLANE = {"gravity", "slope", "restitution", "impact_law", "painleve"}


def readable(scenario: dict[str, Any]) -> None:
    """Refuse a scenario with anything that the equations do not know, or outside its range."""
    _keys("scenario", scenario, {"duration", "hoop", "plane", "start"}, {"contact"})
    _value("duration", scenario["duration"])
    hoop, plane, start = scenario["hoop"], scenario["plane"], scenario["start"]
    if "parts" in hoop:
        _keys("hoop", hoop, {"radius", "parts"})
        for part in hoop["parts"]:
            needed, allowed = PARTS[part["shape"]]
            _keys("part", part, {"shape", "mass"} | needed, allowed)
            _values("part", part)
    elif "load_fraction" in hoop:
        _keys("hoop", hoop, {"radius", "mass", "load_fraction"})
    else:
        _keys("hoop", hoop, {"radius", "mass", "eccentricity", "inertia_ratio"})
    _values("hoop", {name: value for name, value in hoop.items() if name != "parts"})
    friction = {"mu"} if "mu" in plane else {"mu_static", "mu_kinetic"}
    _keys("plane", plane, PLANE | friction, {"rolling_resistance"})
    _values("plane", plane)
    if "mu" not in plane:
        require(float(plane["mu_kinetic"]) <= float(plane["mu_static"]), "kinetic friction is not above static friction")
    if "speed" in start:
        _keys("start", start, {"speed"}, {"x", "angle"})
    else:
        _keys("start", start, set(), {"x", "height", "angle", "vx", "vy", "omega"})
    _values("start", start)
    contact = scenario.get("contact", {})
    _keys("contact", contact, set(), {"model", "max_events"})
    _values("contact", contact)


def _keys(name: str, table: dict[str, Any], needed: set[str], allowed: set[str] | None = None) -> None:
    known = needed | (allowed or set())
    require(set(table) <= known and needed <= set(table), f"every entry of the {name} is one that the equations have")


def _values(section: str, table: dict[str, Any]) -> None:
    for name, value in table.items():
        _value(f"{section}.{name}", value)


def _value(path: str, value: Any) -> None:
    if path in WORDS:
        require(isinstance(value, str) and value in WORDS[path], f"{path} is one that the equations have")
        return
    least, most, *also = NUMBERS[path]
    if value == "inf" and INFINITE in also:
        return
    is_number = isinstance(value, int | float | Fraction) and not isinstance(value, bool) and not math.isnan(value)
    require(is_number and (least <= value <= most or value in also), f"{path} is a number in its range")
