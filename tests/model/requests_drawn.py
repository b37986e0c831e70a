"""Requests of every kind drawn at random, allowed and not, as a page would send them: the seed alone tells which."""

from __future__ import annotations

import math
import random
import re
from typing import Any
from urllib.parse import quote_plus

import hophoop as hh
from hophoop.lab.site.presets import presets
from hophoop.scenario import paths
from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import RANGES

SECTIONS = {
    "hoop": ["radius", "mass", "load_fraction", "eccentricity", "inertia_ratio", "parts"],
    "plane": list(hh.Plane.model_fields),
    "start": ["x", "height", "angle", "speed", "vx", "vy", "omega"],
    "contact": [
        "model", "stiffness", "damping", "restitution", "law", "friction", "slip_speed", "tangential_stiffness", "rtol",
        "max_events",
    ],
}  # fmt: skip
WORDS = {
    "impact_law": list(LAW_CODES),
    "painleve": ["flight", "impact"],
    "model": ["rigid", "compliant"],
    "law": ["kelvin-voigt", "hunt-crossley"],
    "friction": ["tanh", "linear", "bristle"],
}
ODD = [
    None, True, False, "high", "inf", "nan", "1.5", "", "it's", 'a "b"', "caf\u00e9 \u200b\n", [1, 2.5, "x"],
    {"a": 1.5, "b": None}, -1, 0, 0.5, 1e-300, 1e300, 123456789012345680000, 1e21, "x" * 80, 2.5, 1.0000000000000002, -0.0, [],
]  # fmt: skip
ODD_KEYS = ["gama", "radious", "Radius", "speeds", "__proto__", "constructor", "mu static", "x" * 70, "h\u00f6he", "toString"]
NUMBERS = [
    "1",
    "0.5",
    "-0",
    "1e3",
    " 2 ",
    "+3.25",
    ".5",
    "5.",
    "Infinity",
    "-inf",
    "nan",
    "0x10",
    "1e",
    "",
    "abc",
    "1e400",
]


def plain(value: Any) -> Any:
    """As JSON of a page has it: no number without a fraction has a point."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e21:
        return int(value)
    return value


def number(draw: random.Random, name: str) -> float:
    """A number of a field, mostly one that is allowed."""
    path = next((path for path in RANGES if path.endswith(f".{name}") or path == name), None)
    allowed = RANGES["plane.mu"] if name.startswith("mu") else RANGES[path] if path else RANGES["start.speed"]
    if name in ("vx", "vy"):
        allowed = RANGES["start.speed"]
    kind = draw.random()
    if kind < 0.55:
        usual = {"load_fraction": 0.8, "eccentricity": 0.6, "inertia_ratio": 0.7, "duration": 4.0, "rolling_resistance": 0.01}
        return round(draw.uniform(0.2, 1.4) * usual.get(name, 1.0), draw.choice([1, 2, 17]))
    if kind < 0.8:
        low, high = max(allowed.least, -1e3), min(allowed.most, 1e3)
        return draw.uniform(low, high)
    if kind < 0.93:
        return draw.choice([allowed.least, allowed.most, *(value for value in allowed.also if math.isfinite(value))])
    return draw.choice([-1.0, allowed.most * 1.5, allowed.least * 0.9 - 1e-9, 1e300, -3e-7])


def value(draw: random.Random, section: str, name: str, odd: float) -> Any:
    """A value of a field, with some chance one that has no business there."""
    if draw.random() < odd:
        return draw.choice(ODD)
    if (section, name) == ("hoop", "parts"):
        return [part(draw, odd) for _ in range(draw.choice([0, 1, 2, 2, 3]))]
    if name in WORDS and (name, section) != ("friction", "plane"):
        return draw.choice(WORDS[name])
    if name == "max_events":
        return draw.choice([1, 7, 100, 100_000, 10_000_000, 0, 2.5, 10_000_001])
    if name.startswith("mu") and draw.random() < 0.1:
        return "inf"
    return number(draw, name)


def part(draw: random.Random, odd: float) -> Any:
    """A part of a hoop, mostly within a rim of a metre."""
    if draw.random() < odd:
        return draw.choice(ODD)
    mass, size, at = draw.uniform(0.1, 2.0), draw.uniform(0.05, 1.0), draw.uniform(-0.5, 0.5)
    kinds: dict[str, dict[str, Any]] = {
        "ring": {"mass": mass, "inner_radius": size * draw.uniform(0.5, 1.01), "outer_radius": size},
        "disk": {"mass": mass, "radius": 0.5 * size, "at": at},
        "point_mass": {"mass": mass, "at": at},
        "rod": {"mass": mass, "length": size, "at": at, "direction": draw.choice(["radial", "tangential"])},
    }
    shape = draw.choice(list(kinds))
    keys = [("shape", shape), *kinds[shape].items()]
    if draw.random() < 0.3:
        keys.remove(draw.choice(keys))
    if draw.random() < odd:
        keys.append((draw.choice(ODD_KEYS), 1.0))
    draw.shuffle(keys)
    return dict(keys)


def section(draw: random.Random, name: str, odd: float) -> Any:
    """The keys of a section, in any order; mostly such as go together."""
    if draw.random() < 0.3 * odd:
        return draw.choice(ODD)
    if draw.random() < 0.85:
        ways: dict[str, list[list[str]]] = {
            "hoop": [["radius", "mass", "load_fraction"], ["eccentricity", "inertia_ratio"], ["parts"], ["radius", "parts"]],
            "plane": [["mu", "slope"], ["mu_static", "mu_kinetic", "gravity"], ["mu", "restitution", "impact_law"],
                      ["painleve"], ["rolling_resistance", "mu"]],
            "start": [["speed", "angle"], ["speed"], ["x", "height", "vx"], ["vx", "omega", "angle"],
                      ["vy", "height", "omega"]],
            "contact": [["model"], ["max_events"], ["model", "stiffness", "law"], ["model", "damping", "friction"]],
        }  # fmt: skip
        names = list(draw.choice(ways[name]))
    else:
        names = draw.sample(SECTIONS[name], draw.randint(0, min(4, len(SECTIONS[name]))))
    keys = {one: value(draw, name, one, odd) for one in names}
    if name == "contact" and len(names) > 1 and draw.random() < 0.9:
        keys["model"] = "compliant"
    if draw.random() < 0.5 * odd:
        keys[draw.choice(ODD_KEYS)] = 1.0
    shuffled = list(keys.items())
    draw.shuffle(shuffled)
    return dict(shuffled)


def scenario(draw: random.Random, odd: float) -> Any:
    """The keys of a scenario."""
    names = draw.sample([*SECTIONS, "duration"], draw.randint(0, 5))
    keys = {name: number(draw, "duration") if name == "duration" else section(draw, name, odd) for name in names}
    if draw.random() < 0.3 * odd:
        keys[draw.choice([*ODD_KEYS, "hop", "Plane"])] = {}
    return keys


def flat(keys: Any, path: str = "") -> list[tuple[str, Any]]:
    """The leaves of nested keys, as a link has them."""
    if isinstance(keys, dict):
        return [leaf for key, one in keys.items() for leaf in flat(one, f"{path}.{key}" if path else key)]
    if isinstance(keys, list):
        return [leaf for index, one in enumerate(keys) for leaf in flat(one, f"{path}.{index}")]
    return [(path, keys)]


def query(draw: random.Random, odd: float) -> str:
    """A link, mostly one that can be read."""
    leaves = flat(scenario(draw, odd))
    # JavaScript puts keys that are whole numbers in their order
    pairs = [(path, str(one)) for path, one in leaves if path and not re.search(r"\.\d", path.replace("hoop.parts.", ""))]
    if draw.random() < 0.3:
        draw.shuffle(pairs)
    if draw.random() < 2.0 * odd:
        pairs.append(
            (draw.choice(["plane.mu", "start", "hoop.parts.0.at", "hoop.parts.x.mass", "a.b.c", ""]), draw.choice(NUMBERS))
        )
    if pairs and draw.random() < odd:
        pairs.append(draw.choice(pairs))
    if pairs and draw.random() < 0.2:
        place = draw.randrange(len(pairs))
        pairs[place] = (pairs[place][0], draw.choice(NUMBERS))
    text = "&".join(f"{quote_plus(path)}={quote_plus(one)}" for path, one in pairs)
    return draw.choice(["", "?", "?"]) + text + draw.choice(["", "", "&", "&plane.mu", "%ff=%zz"] if odd else [""])


def changes(draw: random.Random, odd: float) -> Any:
    """Changes to a scenario."""
    known = [*paths(), "hoop.parts", "hoop.parts.0.mass", "hoop.parts.1.at", "hoop", "plane", "start"]
    made = []
    for _ in range(draw.choice([0, 1, 1, 2, 3])):
        path = draw.choice(known)
        if draw.random() < 0.3 * odd:
            path = draw.choice(
                ["foo", "foo.bar", "duration.x", "plane.", "hoop.radius.x", "hoop.parts.9.mass", "start.__proto__"]
            )
        name, _, rest = path.partition(".")
        if not rest and name in SECTIONS:
            made.append([path, section(draw, name, odd)])
        else:
            made.append([path, value(draw, name, path.rpartition(".")[2], odd)])
    return made


def request(seed: int) -> dict[str, Any]:
    """A request; of every three two are meant to be allowed."""
    draw = random.Random(seed)
    odd = draw.choice([0.0, 0.0, 0.25])
    body: dict[str, Any] = {}
    kind = draw.random()
    if kind < 0.45:
        body["scenario"] = scenario(draw, odd)
    elif kind < 0.75:
        body["query"] = query(draw, odd)
    elif kind < 0.85:
        body["query"] = draw.choice(presets()).scenario.to_query()
    elif kind < 0.95:
        body["scenario"] = draw.choice(presets()).scenario.to_dict()
    if draw.random() < 0.5:
        body["changes"] = changes(draw, odd)
    return plain(body)


def given_of(scenario: hh.Scenario) -> dict[str, Any]:
    """A scenario as the page hands it to the kernel (`Given` of web/types.d.ts)."""
    hoop, plane, start, contact = scenario.hoop, scenario.plane, scenario.start, scenario.contact
    state = start.state(hoop)
    bound: dict[str, Any] | None = None
    if contact.model == "compliant":
        names = ("stiffness", "damping", "restitution", "law", "friction", "slip_speed", "tangential_stiffness", "rtol")
        bound = {name: getattr(contact, name) for name in names}
    numbers = {
        **{name: getattr(hoop, name) for name in ("radius", "mass", "eccentricity", "inertia_ratio")},
        "ideal": hoop.load_fraction is not None,
        **{name: getattr(plane, name) for name in SECTIONS["plane"] if name != "mu"},
        **state._asdict(),
        "mode": start.mode,
        "rolling": start.speed is not None,
        "duration": scenario.duration,
        "max_events": contact.max_events,
        "contact": bound,
    }
    return {name: "inf" if one == math.inf else one for name, one in numbers.items()}
