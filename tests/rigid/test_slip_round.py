"""Slip that goes on for more than a turn passes two hilltops, and what comes to rest at the one does not at the other."""

import numpy as np
import pytest

import hophoop as hh


def test_slow_slip_round_to_the_next_hilltop():
    hoop, plane = hh.Hoop.ideal(0.02), hh.Plane(mu=1.253973103890006e-05)
    motion = hh.simulate(hoop, plane, hh.Start.rolling(0.0379), duration=22.0)
    reversal = motion.find("slip_reversal")[0]
    # in 30 digits
    assert reversal.t == pytest.approx(18.766863665208465, rel=1e-12)
    assert reversal.angle == pytest.approx(6.19008528543195, rel=1e-12)
    assert reversal.omega == pytest.approx(0.04016475066857652, rel=1e-10)
    assert abs(motion.ledger.residual) < 1e-14


@pytest.mark.compiled
def test_ledgers_of_slow_slip_on_little_friction():
    rng = np.random.default_rng(8)
    for _ in range(40):
        hoop = hh.Hoop.ideal(float(rng.choice([0.1, 0.48, 0.75, 0.9])))
        plane = hh.Plane(mu=float(10.0 ** rng.uniform(-6.0, -3.0)))
        start = hh.Start.rolling(float(10.0 ** rng.uniform(-4.0, -1.0)))
        motion = hh.simulate(hoop, plane, start, duration=30.0)
        assert abs(motion.ledger.residual) < 1e-12, (hoop, plane, start)
