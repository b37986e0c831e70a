"""Requests drawn at random, allowed and not, as a page would send them: the seed alone tells which."""

import math
from random import Random
from urllib.parse import quote_plus

from fuzz import draws
from hophoop.lab.presets import presets

ODD = [
    None, True, False, "high", "inf", "nan", "1.5", "", "it's", 'a "b"', "caf\u00e9 \u200b\n", [1, 2.5, "x"],
    {"a": 1.5, "b": None}, -1, 0, 0.5, 1e-300, 1e300, 123456789012345680000, 1e21, "x" * 80, 2.5, 1.0000000000000002, -0.0, [],
]  # fmt: skip
ODD_KEYS = ["gama", "radious", "Radius", "speeds", "__proto__", "constructor", "mu static", "x" * 70, "h\u00f6he", "toString"]
NUMBERS = [
    "1", "0.5", "-0", "1e3", " 2 ", "+3.25", ".5", "5.", "Infinity", "-inf", "nan", "0x10", "1e", "", "abc", "1e400",
]  # fmt: skip


def plain(value):
    """As JSON of a page has it: no number without a fraction has a point."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float) and math.isinf(value):
        return "inf"
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e21:
        return int(value)
    return value


def some(random, keys):
    """Some of the keys, in any order."""
    return {name: keys[name] for name in random.sample(list(keys), random.randint(0, len(keys)))}


def scenario(random, odd):
    """The keys of a scenario, or of a part of one, with some chance of something that has no business there."""
    keys = draws.scenario(random)
    if random.random() < 0.3:
        keys["hoop"] = {"radius": random.choice([1.0, 1.0, 0.9]), "parts": draws.parts(random, 1.0)}
    if keys["contact"]["model"] == "compliant" and random.random() < 0.1:
        keys["contact"] |= {"damping": 3.0, "restitution": 0.5}
    if random.random() < 0.5:
        keys["plane"] = {"mu": keys["plane"]["mu_static"]} | some(random, {**keys["plane"], "mu_static": 0.0})
    if random.random() < 0.3:
        keys |= {name: some(random, keys[name]) for name in ("plane", "start", "contact")}
    keys = some(random, keys)
    while keys and random.random() < odd:
        spoil(random, keys)
    return keys


def spoil(random, keys):
    """Put something odd, or a key that there is not, somewhere into keys; or leave one out."""
    name = random.choice(list(keys) if isinstance(keys, dict) else range(len(keys)))
    if isinstance(keys[name], dict | list) and keys[name] and random.random() < 0.8:
        spoil(random, keys[name])
    elif isinstance(keys, dict) and random.random() < 0.4:
        keys[random.choice([*ODD_KEYS, "duration", "parts", "speed"])] = 1.0
    elif random.random() < 0.2:
        del keys[name]
    else:
        keys[name] = random.choice(ODD)


def flat(keys, path=""):
    """The leaves of nested keys, as a link has them."""
    items = keys.items() if isinstance(keys, dict) else enumerate(keys) if isinstance(keys, list) else None
    if items is None:
        return [(path, keys)]
    return [leaf for key, one in items for leaf in flat(one, f"{path}.{key}" if path else key)]


def query(random, odd):
    """A link, mostly one that can be read."""
    pairs = [(path, str(one)) for path, one in flat(scenario(random, odd))]
    if random.random() < 0.2:
        random.shuffle(pairs)
    if random.random() < odd:
        path = random.choice(["plane.mu", "start", "hoop.parts.0.at", "hoop.parts.x.mass", "a.b.c", "", *dict(pairs)])
        pairs.append((path, random.choice(NUMBERS)))
    if pairs and random.random() < 0.2:
        place = random.randrange(len(pairs))
        pairs[place] = (pairs[place][0], random.choice(NUMBERS))
    text = "&".join(f"{quote_plus(path)}={quote_plus(one)}" for path, one in pairs)
    return random.choice(["", "?"]) + text + random.choice(["", "", "&", "&plane.mu", "%ff=%zz"] if odd else [""])


def changes(random, odd):
    """Changes as sliders, choices and the table of parts make them, with some chance of an odd value."""
    keys = {"duration": 1.0, **scenario(random, 0.0)}
    known = [
        (f"{section}.{name}", one) for section, table in keys.items() if isinstance(table, dict) for name, one in table.items()
    ]
    known.append(("duration", keys["duration"]))
    made = random.sample(known, min(len(known), random.choice([1, 1, 2, 3])))
    return [[path, random.choice(ODD) if random.random() < 0.3 * odd else one] for path, one in made]


def request(seed):
    """A request; of every three two are meant to be allowed."""
    random = Random(seed)
    odd = random.choice([0.0, 0.0, 0.5])
    preset = random.choice(presets()).scenario
    bodies = [{}, {"query": preset.to_query()}, {"scenario": preset.to_dict()}]
    bodies += 3 * [{"scenario": scenario(random, odd)}, {"query": query(random, odd)}]
    body = random.choice(bodies)
    return plain({**body, "changes": changes(random, odd)} if random.random() < 0.5 else body)
