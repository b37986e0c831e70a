"""What a phase knows of its begin: how often the gap or the slip is zero there, and whether doubles tell what follows."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.scratch import new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import phase as phases
from hophoop.kernel.rigid.ending import Ending
from hophoop.kernel.rigid.panel_choice import START_LEVEL


def body_of(gamma=0.75, mu=0.5, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu, **plane)).to_body()


def state_of(angle=0.5, vt=0.0, om=1.0, time=0.0):
    return start_state(0.0, 0.0, angle, vt, 0.0, om)._replace(t=time)


def before(state):
    """A phase of rolling that has gone on for some panels."""
    return phases.Phase(Mode.ROLL, state, False, 0, 0.0, 7, Ending.CONTINUES, phases.GOING)


def leading_zeros(function):
    """How many derivatives of a function vanish at 0, that itself counted."""
    with mp.workdps(40):
        terms = mp.taylor(function, 0, 5)
    return next(k for k, term in enumerate(terms) if abs(term) > 1e-12)


@pytest.mark.parametrize("angle", [0.3, -1.2])
@pytest.mark.parametrize(("part", "count"), [(0.0, 3), (0.25, 3), (4.0, 2), (1e3, 2)])
def test_the_gap_that_opens_by_rounding_alone_opens_like_the_cube_of_time(angle, part, count):
    """Free of the plane, f_n = ε θ̇² cos θ − g_n is a part of 10⁻¹³ of g_n + θ̇² or less: that is rounding, and is left out."""
    body = body_of()
    opening = part * 1e-13
    for _ in range(3):  # θ̇² is on both sides
        u = (body.gn + opening) / (body.eps * math.cos(angle))
        opening = part * 1e-13 * (body.gn + u)
    found, zeros = phases.opening_of(body, state_of(angle, om=math.sqrt(u)))
    assert zeros == count
    assert found == (0.0 if count == 3 else pytest.approx(opening, rel=0.1))


def test_a_lift_off_from_slip_begins_with_the_third_derivative_of_the_gap():
    body, angle = body_of(), 0.7
    om = math.sqrt(body.gn / (body.eps * math.cos(angle)))
    state = state_of(angle, vt=-0.5, om=om)
    flight = phases.begin_flight_after_slip(state, Ending.LIFT_OFF)
    th, spin = mpf(angle), mpf(om)

    def gap(tau):
        return body.eps * (mp.cos(th) - mp.cos(th + spin * tau) - spin * tau * mp.sin(th)) - body.gn * tau**2 / 2

    assert flight == phases.Phase(Mode.FLIGHT, state, True, leading_zeros(gap), 0.0, START_LEVEL, Ending.LIFT_OFF, phases.GOING)


@pytest.mark.parametrize("kinetic", [0.5, 0.4])
def test_slip_from_the_friction_cone_begins_as_often_with_zero_as_its_motion_says(kinetic):
    """Like t², where friction changes nothing as slip begins; like t, where it falls."""
    plane = hh.Plane(mu_static=0.5, mu_kinetic=kinetic)
    with forced("interpreted"):
        motion = hh.simulate(hh.Hoop.ideal(0.75), plane, hh.Start.rolling(3.1), duration=0.5)
    slip = motion.find("slip_start")[0]
    tau = 1e-4 * motion.units.time
    speeds = [abs(motion.at(slip.t + k * tau).slip) for k in (1.0, 2.0)]
    power = math.log2(speeds[1] / speeds[0])
    state = state_of()
    found = phases.begin_slip_after_roll(motion.scenario.to_body(), Mode.SKID, state, Ending.CONE_FORWARD)
    assert found.zeros == pytest.approx(power, abs=0.01)
    assert found == phases.Phase(Mode.SKID, state, True, found.zeros, 0.0, START_LEVEL, Ending.CONE_FORWARD, phases.GOING)


@pytest.mark.parametrize(("speed", "zeros"), [(0.0, 1), (1.0, 0), (-1.0, 0), (1e-300, 0)])
def test_slip_after_a_jump_begins_at_its_speed_or_with_zero(speed, zeros):
    state = state_of(vt=speed)
    found = phases.begin_phase(body_of(), Mode.SKID, state, Ending.CONTINUES, new_scratch())
    assert found == phases.Phase(Mode.SKID, state, True, zeros, 0.0, START_LEVEL, Ending.CONTINUES, phases.GOING)


@pytest.mark.parametrize(("gamma", "mu", "doubtful"), [(0.75, 0.5, True), (0.75, math.inf, False), (1.0, 0.5, False)])
def test_where_nothing_is_decided_more_digits_may_tell(gamma, mu, doubtful):
    """Not where the model itself has no answer: without a mass in the rim, or where no friction is too much."""
    scratch = new_scratch()
    state = state_of(time=3.0)
    found = phases.begin_phase(body_of(gamma, mu), UNDECIDED, state, Ending.CONTINUES, scratch)
    assert found.status == phases.UNDETERMINED
    assert np.array_equal(scratch.doubt, [3.0] if doubtful else [math.nan], equal_nan=True)


def test_a_phase_that_goes_on_or_ends_keeps_what_it_has():
    first, later = state_of(), state_of(om=2.0, time=1.0)
    phase = phases.Phase(Mode.SKID, first, True, 2, 0.5, 7, Ending.CONTINUES, phases.GOING)
    assert phases.continue_phase(phase, later, 8, Ending.LIFT_OFF) == phase._replace(
        state=later, begins=False, level=8, what=Ending.LIFT_OFF
    )
    ended = phases.end_motion(phase, Mode.FLIGHT, later, Ending.LIFT_OFF, phases.UNDETERMINED)
    assert ended == phase._replace(
        mode=Mode.FLIGHT, state=later, begins=False, what=Ending.LIFT_OFF, status=phases.UNDETERMINED
    )
