"""Motions that ask much of doubles, most of them once wrong: they have the events of extended precision, and their digits."""

import math
from typing import NamedTuple

import pytest

import hophoop as hh
from hophoop.precise import compare
from oracle_program import simulate
from oracles.cases import JAM


class Asked(NamedTuple):
    """A motion, and how many digits of each number of each event it shares with extended precision."""

    hoop: hh.Hoop
    plane: hh.Plane
    start: hh.Start
    duration: float
    least: float


# of almost no ring: θ̇ and the force grow without bound at the bottom
RESISTED = hh.Plane(mu=20.0, rolling_resistance=0.02, gravity=1.0)
SLOPING = RESISTED.model_copy(update={"rolling_resistance": 0.05, "slope": 0.1})
MOTIONS = {
    "slip began 3.5e-5 rad late: θ̇² has a pole beside the panel that its time does not show": Asked(
        hh.Hoop.ideal(0.9999999999947039, radius=2.9187782259074893),
        hh.Plane(mu=5.023971645620162, slope=1.0477444190108247, impact_law="poisson", painleve="impact"),
        hh.Start(
            angle=-1.699552771179441, height=0.26753390053627724,
            vx=-3.4159197269511616, vy=9.686080268892754, omega=1.0012097754532543,
        ), 5.6, 11.5,
    ),
    "v_t lost 1e-11 a turn: the height of G past the bottom, 1 − ε and a little, had no digits": Asked(
        hh.Hoop.ideal(0.9999999999988125, radius=0.42219130057251236), hh.Plane(mu=0.05139206596958353),
        hh.Start(angle=-3.4201374398357167, height=0.0, vx=-0.7424647863712743, omega=7.7201557759886805), 1.0, 13.5,
    ),
    "at the top the singular angle is 1e-12 rad away, and the arm of the normal force is zero": Asked(
        hh.Hoop.ideal(1.0 - 1.4e-12), hh.Plane(mu=2.36), hh.Start(vx=-1.6, omega=-0.48), 1.25, 11.5,
    ),
    "the same, thrown": Asked(
        hh.Hoop.ideal(0.9999999999976574, radius=1.033069641828321, mass=4.611411676610286),
        hh.Plane(mu=0.57791866516764, slope=-0.7396073216713517, impact_law="poisson", painleve="impact"),
        hh.Start(vx=-2.434263341914896, omega=-1.846214099227036, vy=1.4017369727992153), 1.25, 14.5,
    ),
    "a light ring that the load lifts: rolling ends on the cone where a panel does not resolve the forces": Asked(
        hh.Hoop.ideal(0.9997), hh.Plane(mu=2.0, gravity=1.0), hh.Start(angle=-0.6, vx=-0.6, omega=0.0), 6.0, 14.5,
    ),
    "the ledger was off by half: what comes to rest at one hilltop does not do so at the next one": Asked(
        hh.Hoop.ideal(0.5), hh.Plane(mu=0.0132, slope=0.24), hh.Start(vx=4.0, omega=0.8), 6.0, 14.5,
    ),
    "the same on the level": Asked(hh.Hoop.ideal(0.5), hh.Plane(mu=0.02), hh.Start(vx=8.0, omega=1.6), 6.0, 14.5),
    "the same to the other side": Asked(
        hh.Hoop.ideal(0.5), hh.Plane(mu=0.01, slope=-0.2), hh.Start(vx=-6.0, omega=-1.2), 6.0, 14.0,
    ),
    "slip that all but turns: θ̇ was 1e-8 off from a turning point on that a wide panel sees from afar": Asked(
        hh.Hoop.ideal(0.8937595148137446, radius=0.16626324744599907, mass=0.21584739661929603),
        hh.Plane(slope=-0.20733827155436935, mu=0.5018648227533329),
        hh.Start(angle=0.41739713482464946, vx=0.49603212084478177, omega=4.184181065559784), 0.5, 14.5,
    ),
    "an impact on infinite friction, in which an impulse along the plane changes v_t by 10¹² times itself": Asked(
        hh.Hoop.ideal(1.0 - 1e-12), hh.Plane(mu=math.inf, restitution=0.5),
        hh.Start(angle=-2.0, vx=1.5, vy=-2.0, omega=-1.0), 0.05, 14.5,
    ),
    # beside the edge of where the couple holds the hoop: the start has no more digits than its angle, beside the offset
    "pushed over the edge": Asked(
        hh.Hoop.ideal(0.75), RESISTED, hh.Start.rolling(1e-6, angle=math.asin(0.02 / 0.75)), 40.0, 12.5,
    ),
    "let go beyond the edge": Asked(hh.Hoop.ideal(0.75), RESISTED, hh.Start(angle=math.asin(0.02 / 0.75) + 1e-6), 40.0, 12.0),
    "let go beyond the edge of a valley on a slope": Asked(
        hh.Hoop.ideal(0.6), SLOPING,
        hh.Start(angle=math.pi - math.asin((0.05 * math.cos(0.1) - math.sin(0.1)) / 0.6) - 0.1 - 1e-9), 40.0, 8.0,
    ),
}  # fmt: skip
TAKES_LONG = ("v_t lost 1e-11", "at the top", "the same, thrown")


def agree(scenario, least):
    motion = hh.simulate(scenario)
    found = compare(motion, hh.simulate(scenario, digits=20))
    assert found.difference == ""
    assert found.least > least
    assert len(found.rows) > 1
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long if name.startswith(TAKES_LONG) else ()) for name in MOTIONS]
)
def test_digits(name):
    asked = MOTIONS[name]
    agree(hh.Scenario(**dict(zip(("hoop", "plane", "start", "duration"), asked, strict=False))), asked.least)


def test_a_jam_with_resistance():
    agree(simulate(JAM).scenario.with_values({"plane.rolling_resistance": 1e-3}), 3.0)
