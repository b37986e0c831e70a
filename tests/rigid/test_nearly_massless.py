"""Hoops whose ring weighs almost nothing: at the bottom θ̇ and the force grow without bound."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.precise import solve


def against_digits(scenario):
    """The motion, and (its event, the same in 30 digits) for each event."""
    motion = hh.simulate(scenario)
    truth = solve(scenario, 30).records
    assert [int(row["kind"]) for row in motion._events] == [record.kind for record in truth]
    return motion, list(zip(motion._events, truth, strict=True))


def test_friction_that_runs_out_on_the_way_to_the_bottom():
    """θ̇² has a pole beside the panel that its time does not show: slip began 3.5e-5 rad late."""
    scenario = hh.Scenario(
        hoop=hh.Hoop.ideal(0.9999999999947039, radius=2.9187782259074893),
        plane=hh.Plane(mu=5.023971645620162, slope=1.0477444190108247, impact_law="poisson", painleve="impact"),
        start=hh.Start(
            angle=-1.699552771179441, height=0.26753390053627724,
            vx=-3.4159197269511616, vy=9.686080268892754, omega=1.0012097754532543,
        ),
        duration=6.5,
    )  # fmt: skip
    motion, pairs = against_digits(scenario)
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range
    for row, record in pairs:
        assert float(row["t"] - record.state.t) == pytest.approx(0.0, abs=1e-13)
        assert float(row["omega"]) == pytest.approx(float(record.state.om), rel=1e-10)


@pytest.mark.long
def test_slip_past_the_bottom():
    """The height of G there is 1 − ε and a little: written as 1 + ε cos θ it had no digits, and v_t lost 1e-11 a turn."""
    scenario = hh.Scenario(
        hoop=hh.Hoop.ideal(0.9999999999988125, radius=0.42219130057251236),
        plane=hh.Plane(mu=0.05139206596958353),
        start=hh.Start(angle=-3.4201374398357167, height=0.0, vx=-0.7424647863712743, omega=7.7201557759886805),
        duration=1.0,
    )
    motion, pairs = against_digits(scenario)
    assert len(pairs) > 4
    assert abs(motion.ledger.residual) < 1e-13 * motion.ledger.range
    for row, record in pairs:
        assert float(row["slip"] - record.state.vt) == pytest.approx(0.0, abs=1e-13)


def test_energy_where_the_rounding_of_the_angle_is_seen():
    scenario = hh.Scenario(
        hoop=hh.Hoop.ideal(0.9999999999981695, radius=0.1261883706837947),
        plane=hh.Plane(mu=0.0, restitution=0.7551024975353393),
        start=hh.Start.rolling(-1.1188285639882818),
        duration=0.6804973105496462,
    )
    motion = hh.simulate(scenario)
    assert abs(motion.events[-1].omega) > 1e6
    assert math.cos(motion.events[-1].angle) < -0.999999
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range
    sample = motion.at(motion.duration)
    first = motion.at(0.0)
    assert sample.kinetic + sample.potential == pytest.approx(first.kinetic + first.potential, rel=1e-12)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(("start", "spare", "turns"), [(1e-40, 4e-9, None), (-1e-4, -1e-3, 7)])
def test_hardly_any_friction_on_the_way_back_to_the_hilltop(start, spare, turns, way):
    """θ̇² loses digits on the way round and regains them beside the hilltop: v_t has to follow, or energy is made.

    (κ + ε² sin² θ) θ̇² is what rounding keeps, so that θ̇² on a hilltop has the condition 1/κ, 9e8. A hoop that has 4e-9 g/R to
    spare there passes or not as one rounding says, once it has been round; one that lacks 1e-3 g/R turns back each time.
    """
    hoop, gravity = hh.Hoop.ideal(1.0 - 5.757953e-10), 9.81
    eps, kap = hoop.load_fraction, hoop.inertia_ratio
    u = (kap * spare + 4.0 * eps * math.sin(0.5 * start) ** 2) / (kap + (eps * math.sin(start)) ** 2)
    scenario = hh.Scenario(
        hoop=hoop,
        plane=hh.Plane(mu=1e-200, gravity=gravity),
        start=hh.Start(angle=way * start, vx=way * 12.0, omega=way * math.sqrt(gravity * u)),
        duration=3.0 if turns is None else 8.0,
    )
    motion = hh.simulate(scenario)
    assert motion.status == "completed"
    turned = motion.events[1:-1]
    assert turns is None or len(turned) == turns
    for event in turned:
        assert event.kind == "turn"
        assert abs(math.remainder(event.angle, 2.0 * math.pi)) < 1e-5
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range
    sample = motion.at(motion.times(500))
    along = sample.vx + sample.omega * scenario.hoop.load_fraction * np.cos(sample.angle)
    assert along == pytest.approx(along[0], rel=1e-9)
