"""Motions of very many turns: time goes on, and every machine finds the same."""

import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest

import hophoop as hh
from bits_tools import event_rows
from hophoop.kernel.native import forced
from hophoop.kernel.numerics.arithmetic import PI, nearest_whole, revolutions_and_rest
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import run as kernel

# Each runs away on a steep slope. The compiled kernel counted whole turns in 64 bits: time ran backward at the last flight.
AWAY = (
    "duration=712318824.915487&hoop.radius=0.004470088799800991&hoop.mass=0.023138567841474025"
    "&hoop.load_fraction=0.9999725603332458&plane.gravity=305899.0373948422&plane.slope=-1.57&plane.mu=30.65299827956939"
    "&plane.restitution=1&plane.impact_law=poisson&start.height=17.798085658390445&start.angle=-462.0077615332058"
    "&start.vx=-2.2189907187507642e-07&start.vy=4.58386176908718e-12&start.omega=400350.46919733577",
    "duration=332691056.3383982&hoop.radius=0.004500391931004981&hoop.mass=830.2077068043925"
    "&hoop.load_fraction=0.5025790402911456&plane.gravity=346364.9125068795&plane.slope=-1.57&plane.mu=23.126189362876783"
    "&plane.impact_law=newton&plane.rolling_resistance=0.0005217482099466863&start.angle=0.23933516373233255"
    "&start.vx=18.408869365084726&start.vy=3.375014098903909e-09&start.omega=3038.5648303768494",
    "duration=137312285.26223806&hoop.radius=0.0003781869107183112&hoop.mass=0.0015229396962818137"
    "&hoop.load_fraction=0.9999999999631946&plane.gravity=1000000&plane.slope=1.57&plane.mu=135.7259827821292"
    "&plane.restitution=5e-324&plane.impact_law=newton&start.x=518145.29136697383&start.height=8.362016236642248e-15"
    "&start.angle=-9308.916718708471&start.vx=-2.6142940578517115e-11&start.vy=3.843462463600127e-10"
    "&start.omega=3930.8385369231155",
)


@pytest.mark.parametrize("away", AWAY)
def test_time_goes_on(away):
    """The same bits with compiled and interpreted kernels."""
    scenario = hh.Scenario.from_query(f"{away}&contact.max_events=2000")
    motion = hh.simulate(scenario)
    assert motion.status == "event_limit"
    assert max(abs(event.angle) for event in motion.events) > 1e8
    assert all(a.t <= b.t for a, b in pairwise(motion.events))
    assert np.isfinite(motion.at(motion.times(200)).omega).all()
    assert abs(motion.ledger.residual) < 1e-9 * (motion.ledger.kinetic + abs(motion.ledger.potential))
    with forced("interpreted"):
        found = event_rows(hh.simulate(scenario).tables["events"])
    assert found.tobytes() == event_rows(motion.tables["events"]).tobytes()


def test_whole_turns_of_any_angle():
    random = np.random.default_rng(10)
    for exponent in (10, 17, 19, 25, 40, 140):
        for angle in (random.uniform(-1.0, 1.0, 20) * 10.0**exponent).tolist():
            turns, high, low = revolutions_and_rest(angle)
            assert turns == nearest_whole(turns)
            assert abs(high) <= PI * (1.0 + 1e-12)
            assert nearest_whole(angle) == mpmath.nint(mpmath.mpf(angle)) or abs(nearest_whole(angle) - angle) == 0.5
            with mpmath.workdps(60):
                apart = abs(mpmath.mpf(angle) - high - low) / (2 * mpmath.pi)
                assert exponent > 25 or abs(apart - mpmath.nint(apart)) < 10.0 ** (exponent - 30)
    assert math.isnan(revolutions_and_rest(math.nan)[1])
    assert math.isnan(revolutions_and_rest(math.inf)[1])


def test_numbers_whose_squares_overflow_end_the_motion():
    """At the last state that can be reckoned with, not at infinity or before its start."""
    before = start_state(0.0, 1.0, 0.0, 0.0, 0.0, 1.0)._replace(t=1.0)

    def follows(**values):
        return kernel.can_follow(before, before._replace(**values), 5.0)

    assert follows()
    assert follows(t=2.0)
    assert not follows(t=math.nextafter(1.0, 0.0))
    assert kernel.can_follow(before._replace(t=math.nextafter(5.0, 6.0)), before._replace(t=5.0), 5.0)  # the end of time
    for name in ("t", "x", "y", "revolutions", "vt", "vn", "om", "friction", "impact_n", "impact_t", "rolling_loss"):
        assert not follows(**{name: math.nan})
        assert name == "t" or not (follows(**{name: math.inf}) or follows(**{name: 1e301}))
