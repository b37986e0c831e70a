"""The massless hoop step by step: when it lets go, how its load falls, and the blow, by a particle in free fall."""

from __future__ import annotations

import itertools
import math

import pytest
from mpmath import mp, mpf

import hophoop as hh
from contact_tools import log_of
from hophoop.kernel.panels.panel import FLY, SKIMMING
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.layout import EVENTS, SEGMENTS
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import flight_phase
from hophoop.kernel.rigid.phase import GOING, Ending, begin_phase, limits_of


def body_of(mu=0.5, restitution=0.0, gravity=9.81):
    plane = hh.Plane(mu=mu, restitution=restitution, gravity=gravity)
    return hh.Scenario(hoop=hh.Hoop.ideal(1.0), plane=plane).to_body()


def state_of(angle, om=0.0, vt=0.0, x=0.0):
    return start_state(x, 0.0, angle, vt, 0.0, om)


def let_go(body, state):
    """(mode, state, events)."""
    log, scratch = log_of()
    mode, after = flight_phase.begin_skim(body, state, log)
    return mode, after, log.events[: scratch.counts[EVENTS]]


@pytest.mark.parametrize("angle", [0.5, 2.0, 3.0, -0.5, -2.0, -3.0])
@pytest.mark.parametrize("om", [2.0, 1.0, 0.25, 0.0, -0.25, -1.0, -2.0])
def test_where_the_load_sinks_or_is_about_to_the_rim_skims(angle, om):
    """A load that rises leaves open how the rim turns."""
    state = state_of(angle, om, vt=0.25)
    mode, after, events = let_go(body_of(), state)
    assert after == state
    if math.sin(angle) * om < 0.0:
        assert (mode, len(events)) == (UNDECIDED, 0)
    else:
        assert mode == Mode.SKIM
        assert [(row["kind"], row["before_mode"], row["after_mode"]) for row in events] == [(Event.SKIM, Mode.ROLL, Mode.SKIM)]


@pytest.mark.parametrize("gravity", [9.81, 0.0])
@pytest.mark.parametrize("om", [2.0, 1.5, -1.5, -2.0])
def test_at_the_top_the_rim_takes_the_rate_of_the_falling_load(om, gravity):
    """1 − cos θ = g t²/2 makes θ̇ = √g there; the load, 2 R above the plane, keeps its speed v_t + 2 θ̇ along it."""
    body = body_of(gravity=gravity)
    state = state_of(0.0, om, vt=0.25)
    mode, after, events = let_go(body, state)
    assert mode == Mode.SKIM
    assert after.om == math.copysign(math.sqrt(body.gn), om)
    assert after.vt + 2.0 * after.om == pytest.approx(0.25 + 2.0 * om, rel=1e-15)
    assert after._replace(om=om, vt=0.25) == state
    assert [(row["kind"], row["omega"], row["slip"]) for row in events] == [(Event.SKIM, after.om, after.vt)]


@pytest.mark.parametrize(("angle", "om"), [(1e-9, -2.0), (-1e-9, 2.0), (1e-9, 2.0)])
def test_beside_the_top_the_load_passes_it(angle, om):
    """Where the cosine is 1 the load has no height to rise."""
    mode, after, _ = let_go(body_of(), state_of(angle, om))
    assert (mode, after.om) == (Mode.SKIM, om)


def skim(body, state, t_end):
    """(whether it strikes, state, v_n of the load, segment)."""
    log, scratch = log_of()
    ending, after, vn = flight_phase.skim(body, state, limits_of(state, t_end, math.nan, 0, 0), log)
    assert scratch.counts[:2].tolist() == [0, 1]
    assert ending in (Ending.LOAD_STRIKE, Ending.TIME_LIMIT)
    return ending == Ending.LOAD_STRIKE, after, vn, log.segments[0]


def fall(body, state):
    """(time, v_n) of the load's strike, by its parabola."""
    with mp.workdps(30):
        height, sink = 1 + mp.cos(mpf(state.th)), mp.sin(mpf(state.th)) * state.om
        gn = mpf(body.gn)
        tau = (mp.sqrt(sink**2 + 2 * gn * height) - sink) / gn if gn else height / sink
        return float(tau), -float(sink + gn * tau)


FALLS = [
    (side * angle, side * om, vt)
    for side, (angle, om), vt in itertools.product(
        (1.0, -1.0), ((0.0, 1.0), (0.5, 0.0), (0.5, 0.75), (2.0, 0.0), (2.0, 1.5), (3.0, 0.25)), (0.0, 0.25, -0.5)
    )
]


@pytest.mark.parametrize(("angle", "om", "vt"), FALLS)
@pytest.mark.parametrize("gt", [0.0, 0.25])
def test_the_load_falls_on_a_parabola_and_the_rim_goes_with_it(angle, om, vt, gt):
    """Up to the blow, and up to a time before it; also where something pulls along the plane."""
    body, state = body_of()._replace(gt=gt), state_of(angle, om, vt, x=0.75)._replace(t=2.0)
    side = math.copysign(1.0, angle if angle else om)
    duration, v_n = fall(body, state)
    along = vt + om * (1.0 + math.cos(angle))  # of the load
    strikes, after, found, segment = skim(body, state, 99.0)
    assert strikes
    assert after.t == pytest.approx(2.0 + duration, rel=1e-15)
    assert after.x == pytest.approx(0.75 + math.sin(angle) + along * duration + 0.5 * gt * duration**2, rel=1e-13, abs=1e-14)
    assert (after.x_low, after.y, after.revolutions, after.th, after.th_low) == (0.0, 0.0, 0.0, side * math.pi, 0.0)
    assert after.vt == pytest.approx(along + gt * duration, rel=1e-13, abs=1e-15)
    assert (after.vn, found) == (0.0, pytest.approx(v_n, rel=1e-14))
    assert (segment["mode"], segment["kind"], segment["direction"]) == (Mode.SKIM, SKIMMING, side)
    assert (segment["t"], segment["t_end"]) == (2.0, after.t)

    t_end = 2.0 + 0.5 * duration
    strikes, after, found, segment = skim(body, state, t_end)
    tau = t_end - 2.0
    assert not strikes
    assert (after.t, after.t_low, segment["t_end"]) == (t_end, 0.0, t_end)
    height = 1.0 + math.cos(angle) - math.sin(angle) * om * tau - 0.5 * body.gn * tau**2
    assert 1.0 + math.cos(after.th) == pytest.approx(height, rel=1e-13)
    assert after.th * side > 0.0
    assert math.sin(after.th) * after.om == pytest.approx(math.sin(angle) * om + body.gn * tau, rel=1e-13)
    assert after.x + math.sin(after.th) == pytest.approx(0.75 + math.sin(angle) + along * tau + 0.5 * gt * tau**2, rel=1e-13)
    assert after.vt + after.om * (1.0 + math.cos(after.th)) == pytest.approx(along + gt * tau, rel=1e-13, abs=1e-14)
    assert after.vn == 0.0


def test_a_strike_at_the_very_end_is_one():
    state = state_of(2.0)
    _, after, _, _ = skim(body_of(), state, 99.0)
    assert skim(body_of(), state, after.t)[0]
    assert not skim(body_of(), state, math.nextafter(after.t, 0.0))[0]


@pytest.mark.parametrize("angle", [1e-160, -1e-160, 1e-9, -1e-9])
def test_without_gravity_a_load_at_the_top_strikes_in_the_future_or_never(angle):
    """Its rise of 1e-160 counted as a fall that had been over for 1e160 units of time."""
    strikes, after, _, segment = skim(body_of(gravity=0.0), state_of(angle, om=1.5), 7.0)
    assert not strikes
    assert (after.t, segment["t_end"]) == (7.0, 7.0)


def test_without_gravity_a_load_at_rest_never_strikes():
    strikes, after, _, _ = skim(body_of(gravity=0.0), state_of(2.0, vt=0.25), 7.0)
    assert (strikes, after.t, after.x) == (False, 7.0, pytest.approx(7.0 * 0.25))
    assert after.th == pytest.approx(2.0)


def step(body, state, t_end=99.0):
    log, scratch = log_of()
    phase = begin_phase(int(Mode.SKIM), state, Ending.LOAD_STRIKE)
    given = limits_of(state, t_end, math.nan, 0, 0)
    after = flight_phase.skim_step(body, phase, given, log)
    return phase, after, log.events[: scratch.counts[EVENTS]], log.segments[: scratch.counts[SEGMENTS]]


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
@pytest.mark.parametrize(
    ("mu", "speed", "sticks"), [(0.5, 0.5, True), (0.5, 1.0, False), (0.25, 0.5, False), (0.25, 0.0, True)]
)
def test_the_blow_is_that_of_a_particle_with_friction(side, restitution, mu, speed, sticks):
    """It takes m v_n, and μ of it along the plane, or what stops the load if that is less; nothing turns the rim."""
    body = body_of(mu, restitution)
    state = state_of(side * 2.0, 0.0, vt=side * speed)._replace(friction=0.25, impact_n=0.5, impact_t=0.75)
    _, v_n = fall(body, state)
    _, after, events, segments = step(body, state)
    left = 0.0 if sticks else side * (speed - mu * -v_n)
    mode = Mode.ROLL if sticks else Mode.SKID if side > 0.0 else Mode.SPIN
    if restitution:
        mode = Mode.FLIGHT
    assert len(events) == 1
    blow = events[0]
    assert (blow["kind"], blow["before_mode"], blow["after_mode"]) == (Event.IMPACT, Mode.SKIM, mode)
    assert (blow["before_slip"], blow["before_vy"]) == (pytest.approx(side * speed, rel=1e-14), pytest.approx(v_n, rel=1e-14))
    assert math.isnan(blow["before_omega"])  # it had no bound
    assert (blow["slip"], blow["vy"], blow["omega"]) == (pytest.approx(left, rel=1e-13), 0.0, 0.0)
    assert blow["impulse_normal"] == pytest.approx(-v_n, rel=1e-14)
    assert blow["impulse_tangential"] == pytest.approx(left - side * speed, rel=1e-13)
    assert (blow["gain"], blow["collision"], blow["stable"]) == (0.0, 1, -1)
    losses = [after.state.friction, after.state.impact_n, after.state.impact_t]
    assert losses == pytest.approx([0.25, 0.5 + 0.5 * v_n**2, 0.75 + 0.5 * (speed**2 - left**2)], rel=1e-13)
    assert (after.state.vt, after.state.vn, after.state.om) == (blow["slip"], 0.0, 0.0)
    assert (after.mode, after.ending) == (mode, Ending.LOAD_STRIKE)
    assert (after.status, after.begins) == ((Status.UNDETERMINED, False) if restitution else (GOING, True))
    if restitution:
        end = segments[1]
        assert (end["mode"], end["kind"], end["t"], end["t_end"]) == (mode, FLY, after.state.t, after.state.t)
        assert (end["omega"], end["slip"]) == (0.0, after.state.vt)
    assert len(segments) == (2 if restitution else 1)


def test_a_fall_that_is_not_over_ends_the_motion():
    _, after, events, segments = step(body_of(), state_of(2.0), 0.5)
    assert (after.mode, after.state.t, after.ending, after.status) == (Mode.SKIM, 0.5, Ending.TIME_LIMIT, Status.COMPLETED)
    assert (len(events), len(segments)) == (0, 1)
