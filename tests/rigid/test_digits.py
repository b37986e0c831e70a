"""Motions that ask much of doubles, most of them once wrong: they have the events of extended precision, and their digits."""

import pytest

import hophoop as hh
from hophoop.precise import compare
from oracle_program import simulate
from oracles.cases import JAM

EDGE = "duration=40&plane.gravity=1&plane.mu=20"  # of where the couple holds the hoop, on a plane that it does not slip on
# links, and how many digits of each number of each event are those of extended precision
MOTIONS = {
    "slip began 3.5e-5 rad late: θ̇² has a pole beside the panel that its time does not show": (
        "duration=5.6&hoop.radius=2.9187782259074893&hoop.load_fraction=0.9999999999947039&plane.slope=1.0477444190108247"
        "&plane.mu=5.023971645620162&plane.impact_law=poisson&plane.painleve=impact&start.height=0.26753390053627724"
        "&start.angle=-1.699552771179441&start.vx=-3.4159197269511616&start.vy=9.686080268892754&start.omega=1.0012097754532543",
        11.5,
    ),
    "v_t lost 1e-11 a turn: the height of G past the bottom, 1 − ε and a little, had no digits": (
        "duration=1&hoop.radius=0.42219130057251236&hoop.load_fraction=0.9999999999988125&plane.mu=0.05139206596958353"
        "&start.angle=-3.4201374398357167&start.vx=-0.7424647863712743&start.omega=7.7201557759886805",
        13.5,
    ),
    "at the top the singular angle is 1e-12 rad away, and the arm of the normal force is zero": (
        "duration=1.25&hoop.load_fraction=0.9999999999986&plane.mu=2.36&start.vx=-1.6&start.omega=-0.48", 11.5,
    ),
    "the same, thrown": (
        "duration=1.25&hoop.radius=1.033069641828321&hoop.mass=4.611411676610286&hoop.load_fraction=0.9999999999976574"
        "&plane.slope=-0.7396073216713517&plane.mu=0.57791866516764&plane.impact_law=poisson&plane.painleve=impact"
        "&start.vx=-2.434263341914896&start.vy=1.4017369727992153&start.omega=-1.846214099227036",
        14.5,
    ),
    "a light ring that the load lifts: rolling ends on the cone where a panel does not resolve the forces": (
        "hoop.load_fraction=0.9997&plane.gravity=1&plane.mu=2&start.angle=-0.6&start.vx=-0.6", 14.5,
    ),
    "the ledger was off by half: what comes to rest at one hilltop does not do so at the next one": (
        "hoop.load_fraction=0.5&plane.slope=0.24&plane.mu=0.0132&start.vx=4&start.omega=0.8", 14.5,
    ),
    "the same on the level": ("hoop.load_fraction=0.5&plane.mu=0.02&start.vx=8&start.omega=1.6", 14.5),
    "the same to the other side": (
        "hoop.load_fraction=0.5&plane.slope=-0.2&plane.mu=0.01&start.vx=-6&start.omega=-1.2", 14.0,
    ),
    "slip that all but turns: θ̇ was 1e-8 off from a turning point on that a wide panel sees from afar": (
        "duration=0.5&hoop.radius=0.16626324744599907&hoop.mass=0.21584739661929603&hoop.load_fraction=0.8937595148137446"
        "&plane.slope=-0.20733827155436935&plane.mu=0.5018648227533329&start.angle=0.41739713482464946"
        "&start.vx=0.49603212084478177&start.omega=4.184181065559784",
        14.5,
    ),
    "an impact on infinite friction, in which an impulse along the plane changes v_t by 10¹² times itself": (
        "duration=0.05&hoop.load_fraction=0.999999999999&plane.mu=inf&plane.restitution=0.5&start.angle=-2&start.vx=1.5"
        "&start.vy=-2&start.omega=-1",
        14.5,
    ),
    "what comes to rest at one hilltop does not do so at the other": (
        "duration=22&hoop.load_fraction=0.02&plane.mu=1.253973103890006e-5&start.speed=0.0379", 13.5,
    ),
    "thrown down in free space with spin: the gap has tops on its way, none as high as the start, which are no apex": (
        "duration=7.6&hoop.radius=1.4183860456955892&hoop.eccentricity=0.28770369934905493&hoop.inertia_ratio=0.26132841846141935"
        "&plane.gravity=0&plane.mu=0&start.height=0.9771388712089832&start.angle=-3.983657756686453&start.vx=1.8"
        "&start.vy=-1.4800663946968728&start.omega=-3.517763724036154",
        14.5,
    ),
    # beside an edge the start has no more digits than its angle, over the offset: 1e-6 rad/s, 1e-6 rad and 1e-9 rad
    "pushed over the edge": (f"{EDGE}&plane.rolling_resistance=0.02&start.angle=0.026669828172280148&start.speed=1e-6", 12.5),
    "let go beyond the edge": (f"{EDGE}&plane.rolling_resistance=0.02&start.angle=0.02667082817228015", 12.0),
    "let go beyond the edge of a valley on a slope": (
        f"{EDGE}&plane.rolling_resistance=0.05&hoop.load_fraction=0.6&plane.slope=0.1&start.angle=3.12516190470141", 8.0,
    ),
}  # fmt: skip
TAKES_LONG = ("slip began 3.5e-5", "v_t lost 1e-11", "at the top", "the same, thrown")


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
    link, least = MOTIONS[name]
    agree(hh.Scenario.from_query(link), least)


def test_a_jam_with_resistance():
    agree(simulate(JAM).scenario.with_values({"plane.rolling_resistance": 1e-3}), 3.0)
