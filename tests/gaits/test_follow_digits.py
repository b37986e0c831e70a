"""Border collisions and the top of the hill against motions in 30 digits, which share nothing with the kernel."""

import math
from decimal import Decimal

import mpmath as mp
import pytest

import hophoop as hh

pytestmark = pytest.mark.long

STEP = 2.0**-24  # of θ̇, for one-sided differences
LOAD = 0.75


def first(degrees, near, period=1):
    case = hh.Scenario(hoop=hh.Hoop.ideal(LOAD), plane=hh.Plane(slope=math.radians(degrees), gravity=1.0))
    return next(gait for gait in hh.gaits.find(case, period, near=near) if gait.stable)


def followed(gait, low, high):
    return gait.follow("plane.slope", (math.radians(low), math.radians(high)))


def precise(special, shift=0.0):
    """One period in 30 digits, from θ̇ of a special point and a shift."""
    omega = special.omega + shift
    start = hh.Start(angle=math.pi, vx=omega, omega=omega, slip=0.0, mode="R")
    case = special.gait.scenario.replace("start", start).replace("duration", 300.0)
    return hh.simulate(case, digits=30, until=f"revolutions:{special.gait.revolutions}")


def image(motion):
    return motion.events[-1].omega


def one_sided(special, sign, middle):
    """Derivative of the map on one side, by differences extrapolated once."""
    near, far = (image(precise(special, sign * k * STEP)) - middle for k in (1, 2))
    return float((4 * near - far) / (2 * Decimal(sign * STEP)))


def landings(motion):
    """Friction's impulse that is not used up at each landing (μ = 1), and the slip after it."""
    impacts = [event for event in motion.events if event.kind == "impact"]
    return [(float(one.impulse_normal - abs(one.impulse_tangential)), abs(float(one.slip))) for one in impacts]


@pytest.fixture(scope="module")
def corners():
    """Border collisions of the gaits of one and four revolutions at which the landing just stops the slip."""
    one = followed(first(1.0, 3.408), 0.9, 1.2).special
    corner = next(special for special in one if special.event.startswith("impact: slip just stops"))
    second = followed(corner.switch(), 1.02, 1.25)
    doubling = next(special for special in second.special if special.kind == "period doubling")
    fourth = followed(doubling.switch(), 1.19, 1.25)
    return corner, next(special for special in fourth.special if special.event.startswith("impact: slip just stops"))


@pytest.mark.parametrize(("number", "revolutions"), [(0, 1), (1, 4)])
def test_border_collisions(corners, number, revolutions):
    """The map returns θ̇, its slopes are the multipliers, and the slip just stops: friction is used up and no slip is left."""
    special = corners[number]
    assert special.gait.revolutions == revolutions
    motion = precise(special)
    assert abs(image(motion) - Decimal(special.omega)) < Decimal("3e-14")
    met = landings(motion)
    which = min(range(len(met)), key=lambda k: sum(met[k]))
    unused, slip = met[which]
    assert unused < 1e-13
    assert slip < 1e-13
    sides = [landings(precise(special, sign * STEP))[which] for sign in (-1.0, 1.0)]
    assert max(unused for unused, _ in sides) > 1e-9
    assert max(slip for _, slip in sides) > 1e-9
    assert all(min(side) < 1e-13 for side in sides)
    sides = {one_sided(special, sign, image(motion)) for sign in (-1.0, 1.0)}
    assert sorted(sides) == pytest.approx(sorted(special.multipliers), abs=1e-6)


def spare_energy(special):
    """Energy over that of rest on the next hilltop after the last landing of the period, from the masses alone."""
    motion = precise(special)
    assert abs(image(motion) - Decimal(special.omega)) < Decimal("1e-12")
    impact = next(event for event in motion.events if event.kind == "impact")
    assert impact.to_mode == "R"
    with mp.workdps(30):
        slope, omega, angle = (mp.mpf(str(one)) for one in (special.gait.scenario.plane.slope, impact.omega, impact.angle))

        def potential(at):
            return LOAD * mp.cos(at) * mp.cos(slope) - mp.sin(slope) * (at + LOAD * mp.sin(at))

        def torque(at):
            return LOAD * mp.sin(at) * mp.cos(slope) + mp.sin(slope) * (1 + LOAD * mp.cos(at))

        top = mp.findroot(torque, 2 * mp.pi * mp.ceil(angle / (2 * mp.pi)) - slope)
        kinetic = omega**2 * (1 + LOAD * mp.cos(angle))
        return float(kinetic + potential(angle) - potential(top))


def test_the_top_of_the_hill():
    """At the point the hoop comes over the hilltop with next to no energy left, and with more on a steeper slope."""
    branch = followed(first(15.2, 3.14, 2), 15.0, 15.3)
    special = branch.special[0]
    assert special.kind == "top of the hill"
    spare = spare_energy(special)
    assert 0.0 < spare < 1e-10
    steeper = branch.gait(next(k for k, slope in enumerate(branch.parameter) if slope > special.parameter + 1e-5))
    beyond = special._replace(parameter=steeper.scenario.plane.slope, omega=steeper.state.omega, gait=steeper)
    rate = (spare_energy(beyond) - spare) / (beyond.parameter - special.parameter)
    exact = special.parameter - spare / rate
    assert math.degrees(exact) == pytest.approx(math.degrees(special.parameter), abs=1e-8)
