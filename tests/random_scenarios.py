"""Random scenarios, of which (seed, index) tells which: the rigid ones of data/bits, and hoops that roll."""

import copy
import json
import math
from functools import cache
from random import Random

import numpy as np

import bits_tools
import hophoop as hh

EVENTS = 2000  # beyond these an elastic or nearly elastic bouncing is cut off


@cache
def shuffled(seed):
    """Their sections, in an order of the seed."""
    told = json.loads(bits_tools.SCENARIOS.read_text(encoding="utf-8"))["scenarios"]
    found = [{name: part for name, part in one.items() if name != "kind"} for one in told if one["kind"] == "rigid"]
    Random(seed).shuffle(found)
    return found


def draw(seed, index):
    """The sections of a scenario."""
    return copy.deepcopy(shuffled(seed)[index % len(shuffled(seed))])


def scenario_of(sections, max_events=EVENTS):
    """The sections as a scenario for `simulate`."""
    return hh.Scenario.from_dict({**sections, "contact": {"max_events": max_events}})


def rolling(seed, index):
    """An ideal hoop that begins to roll, on the level, gentle and steep slopes, in units of R and g."""
    random = np.random.default_rng([seed, index])
    plane = hh.Plane(
        gravity=1.0,
        slope=float(random.choice([0.0, random.uniform(0.0, 0.1), random.uniform(0.0, 0.6)])),
        mu=float(random.uniform(0.02, 2.0)),
        restitution=float(random.choice([0.0, random.uniform(0.0, 0.9)])),
        rolling_resistance=float(random.choice([0.0, random.uniform(0.0, 0.1)])),
    )
    hoop = hh.Hoop.ideal(float(random.uniform(0.05, 0.95)))
    angle = float(random.uniform(-math.pi, math.pi))
    return hh.Scenario(hoop=hoop, plane=plane, start=hh.Start.rolling(float(random.uniform(-4.0, 4.0)), angle=angle))


# Within a few units in the last place of the least friction of Painlevé's paradox.
AT_PAINLEVE = {
    4: "duration=0.7367954901555048&hoop.radius=0.1479314194504262&hoop.load_fraction=0.8318031491260817"
    "&plane.mu=0.9725845191785851&plane.restitution=0.5&start.angle=-1.3034488895533536&start.vx=4.86585664866092&start.omega=-0.07225713233882392",
    85: "duration=0.740904393256069&hoop.radius=0.14958596468532417&hoop.load_fraction=0.5439849113543163"
    "&plane.mu=1.5427173964255714&plane.restitution=0.5&start.angle=-1.0098724691982583&start.vx=5.789802622269975&start.omega=-0.5312660387373578",
    107: "duration=0.9958586980181741&hoop.radius=0.27024766389902843&hoop.load_fraction=0.9673270562731567"
    "&plane.mu=0.37813439377225244&start.angle=-0.6193086413103464&start.vx=5.426592435214699&start.omega=0.3852278731861678",
    157: "duration=0.8243820944889603&hoop.radius=0.18519259077706635&hoop.load_fraction=0.7483387031889013"
    "&plane.mu=0.9091582820233786&plane.restitution=0.5&start.angle=-0.8880343061842895&start.vx=5.018927744575728&start.omega=2.424272104658745",
    288: "duration=0.9968820551785423&hoop.radius=0.270803369202831&hoop.load_fraction=0.9711389550633973"
    "&plane.mu=0.2675360849480689&plane.restitution=0.5&start.angle=-0.3640786547216399&start.vx=3.1698351206561166&start.omega=1.9560361655613203",
    446: "duration=1.414356707410574&hoop.radius=0.545110334104759&hoop.load_fraction=0.5589938187642365"
    "&plane.mu=1.61236047824937&plane.restitution=0.5&start.angle=-0.6760456763985696&start.vx=4.952534647430263&start.omega=0.775101697375653",
    15449: "duration=1.065341856701236&hoop.radius=0.3092747665218011&hoop.load_fraction=0.9149983682727839"
    "&plane.mu=0.4967316955323331&plane.restitution=0.5&start.angle=-0.25472236125154785&start.vx=4.0257994864771565&start.omega=1.0432549952400532",
    111379: "duration=1.4636964025021915&hoop.radius=0.5838059507451662&hoop.load_fraction=0.5350384527333153"
    "&plane.mu=1.6652682583282867&plane.restitution=0.5&start.angle=-0.7541737505596022&start.vx=1.704598028090001&start.omega=-0.6906381903050716",
    458239: "duration=0.8603691026415098&hoop.radius=0.20171403553259276&hoop.load_fraction=0.9088046673860785"
    "&plane.mu=0.4936624413227851&plane.restitution=0.5&start.angle=-0.29509350263791406&start.vx=2.810750639399257&start.omega=1.9338153564986085",
}


def at_painleve(index):
    """A scenario that starts at the threshold of Painlevé's paradox."""
    return hh.Scenario.from_query(f"{AT_PAINLEVE[index]}&contact.max_events={EVENTS}")
