"""Scenarios over the whole of the supported ranges: magnitudes log-uniform, and the values at which things vanish.

A draw takes its numbers from Python's generator, of which the seed tells the scenario, or from hypothesis', which makes a
scenario that fails as plain as it can.
"""

import math
from random import Random

from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS, Range

ANGLES = (0.0, math.pi / 2, math.pi, -math.pi, 2 * math.pi, math.nextafter(math.pi, 4.0), 1e-9, -1e-300, 3.0, 100.0, 1e6)
TINY = 1e-300


class Extreme(Random):
    """Draws every magnitude, the ends of ranges, and the next doubles to them."""


def magnitude(random, least, most):
    """A positive number, log-uniform."""
    return min(max(10.0 ** random.uniform(math.log10(least), math.log10(most)), least), most)


def share(random):
    """A number from 0 to 1, of any magnitude."""
    return random.choice([0.0, 1.0, random.uniform(0.0, 1.0), magnitude(random, TINY, 1.0)])


def of_range(random, allowed, usual):
    """A number of a range or a parameter: an end, a special value, one of any magnitude, or one like the usual one."""
    allowed = RANGES[allowed] if isinstance(allowed, str) else allowed
    usually = ["usual", "usual", "near", "near", "any", "any", "special"]
    kind = random.choice(["any", "any", "any", "special", "edge"] if isinstance(random, Extreme) else usually)
    if kind == "usual":
        return usual
    sign = random.choice([1.0, -1.0]) if allowed.least < 0.0 else 1.0
    if kind == "near":
        value = sign * (abs(usual) or 1.0) * magnitude(random, 0.1, 10.0)
    elif kind == "any":
        least = allowed.least if allowed.least > 0.0 else random.choice([TINY, 1e-6])
        value = sign * magnitude(random, least, allowed.most)
    elif kind == "edge":
        value = math.nextafter(*random.choice([(allowed.least, 1.0), (allowed.most, 1.0), (1.0, 0.0), (0.0, 1.0)]))
    else:
        value = random.choice([allowed.least, allowed.most, *allowed.also, 1.0])
    return value if allowed.holds(value) else min(max(value, allowed.least), allowed.most)


def parts(random, radius):
    """Parts of a hoop that lie within its radius; the first is a ring with inertia, which bodies of points have not."""
    found = [{"shape": "ring", "mass": magnitude(random, 1e-3, 1e3), "inner_radius": 0.9 * radius, "outer_radius": radius}]
    for _ in range(random.choice(range(5))):
        shape = random.choice(["ring", "disk", "point_mass", "rod"])
        size = radius * random.uniform(1e-3, 1.0)
        at = random.uniform(-1.0, 1.0) * (radius if shape == "point_mass" else radius - size)
        kinds = {
            "ring": {"inner_radius": size * random.uniform(0.0, 1.0), "outer_radius": size},
            "disk": {"radius": size, "at": at},
            "point_mass": {"at": at},
            "rod": {"length": 2.0 * size, "at": at, "direction": random.choice(["radial", "tangential"])},
        }
        found.append({"shape": shape, "mass": magnitude(random, 1e-3, 1e3), **kinds[shape]})
    return found


def hoop(random):
    """Ideal, of any (ε, κ), nearly massless and massless hoops."""
    keys = {"radius": of_range(random, "hoop.radius", 1.0), "mass": of_range(random, "hoop.mass", 1.0)}
    kind = random.choice(["ideal", "ideal", "general", "light", "massless"])
    if kind == "ideal":
        keys["load_fraction"] = random.choice([0.0, 0.5, 0.75, random.uniform(0.0, 0.999)])
    elif kind == "general":
        keys["eccentricity"] = share(random)
        keys["inertia_ratio"] = of_range(random, Range(1e-12, 1e6), 0.4)
    elif kind == "light":
        keys["load_fraction"] = 1.0 - magnitude(random, 1e-12, 1e-2)
    else:
        keys |= {"eccentricity": 1.0, "inertia_ratio": 0.0}
    return keys


def plane(random, massless, compliant):
    """Without gravity and with a lot, smooth, rough and infinitely rough, level and steep."""
    static = of_range(random, "plane.mu", 1.0)
    if compliant and math.isinf(static):
        static = 1.0
    slopes = [0.0, 0.0, random.uniform(-1.2, 1.2), random.uniform(-1.57, 1.57), magnitude(random, TINY, 1.0)]
    keys = {
        "gravity": of_range(random, "plane.gravity", 9.81),
        "slope": 0.0 if massless else random.choice(slopes),
        "mu_static": static,
        "mu_kinetic": static * random.choice([1.0, 1.0, 0.0, random.uniform(0.0, 1.0)]) if math.isfinite(static) else static,
        "restitution": random.choice([0.0, share(random)]),
        "impact_law": random.choice(list(LAW_CODES)),
        "painleve": random.choice(["flight", "impact"]),
    }
    resistance = [0.0, 0.0, 0.0, 0.0, random.uniform(0.0, 0.1), of_range(random, "plane.rolling_resistance", 0.01)]
    return keys if massless else {**keys, "rolling_resistance": random.choice(resistance)}


def start(random):
    """Rolling, slipping, flying, striking and at rest."""
    angle = random.choice([random.uniform(-4.0, 4.0), random.choice(ANGLES), of_range(random, "start.angle", 1.0)])
    keys = {"x": random.choice([0.0, 0.0, of_range(random, "start.x", 1.0)]), "angle": angle}
    kind = random.choice(["rolling", "rolling", "contact", "contact", "air", "strike", "rest"])
    if kind == "rest":
        return keys
    if kind == "rolling":
        return {**keys, "speed": of_range(random, "start.speed", 3.1)}
    keys |= {"vx": of_range(random, "start.speed", 3.1), "omega": of_range(random, "start.omega", 3.1)}
    if kind == "contact":
        return keys
    vy = of_range(random, "start.speed", 1.0)
    return {**keys, "vy": -abs(vy)} if kind == "strike" else {**keys, "vy": vy, "height": of_range(random, "start.height", 1.0)}


def contact(random, compliant, body, where):
    """Rigid, or compliant with any law, of a stiffness that goes with the hoop."""
    limit = random.choice([1, 7, 400, 400, 2000, 2000])
    if not compliant:
        return {"model": "rigid", "max_events": limit}
    keys = {
        "model": "compliant",
        "max_events": limit,
        "law": random.choice(["kelvin-voigt", "hunt-crossley"]),
        "friction": random.choice(["tanh", "linear", "bristle"]),
        "rtol": random.choice([None, None, 1e-6, magnitude(random, 1e-10, 1e-3)]),
    }
    second = math.sqrt(body["radius"] / (where["gravity"] or 1.0))
    spring = body["mass"] / second**2
    usual = {
        "stiffness": (RELATIVE_STIFFNESS, 1e6, spring),
        "slip_speed": (RELATIVE_SLIP_SPEED, 1e-4, body["radius"] / second),
        "tangential_stiffness": (RELATIVE_STIFFNESS, 1e6, spring),
    }
    for name, (relative, value, unit) in usual.items():
        if random.choice([True, False]):
            most = RANGES[f"contact.{name}"]
            keys[name] = min(max(of_range(random, relative, value) * unit, most.least), most.most)
    damping = random.choice([None, "damping", "restitution"])
    if damping:
        keys[damping] = of_range(random, "contact.damping", 100.0) if damping == "damping" else share(random)
    return {name: value for name, value in keys.items() if value is not None}


def scenario(random, share_compliant=3, turns=None):
    """The keys of a scenario; one in so many is compliant, and `turns` bounds the work by a shorter duration."""
    body, begin = hoop(random), start(random)
    massless = body.get("inertia_ratio") == 0.0
    compliant = not massless and random.choice(range(share_compliant)) == 0
    where = plane(random, massless, compliant)
    bound = contact(random, compliant, body, where)
    duration = random.choice([1.0, 6.0, of_range(random, "duration", 6.0)])
    if turns is not None:
        rate = abs(begin.get("omega", 0.0)) + (abs(begin.get("speed", 0.0)) + abs(begin.get("vx", 0.0))) / body["radius"]
        rate += 10.0 * math.sqrt(where["gravity"] / body["radius"])
        rate += 0.01 * math.sqrt(bound.get("stiffness", 0.0) / body["mass"])
        most = 2.0 * math.pi * turns / rate if rate > 0.0 else math.inf
        duration = min(duration, max(most, RANGES["duration"].least))
    return {"hoop": body, "plane": where, "start": begin, "duration": duration, "contact": bound}
