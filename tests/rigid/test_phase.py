"""The start of a phase: derivatives of the gap and of the slip that vanish there, and doubts about what follows."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

import hophoop as hh
from contact_tools import body_of
from hophoop.kernel.native import forced
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import new_log
from hophoop.kernel.rigid import phase as phases
from hophoop.kernel.rigid.contact_phase import vanishing_slip_derivatives
from hophoop.kernel.rigid.flight_phase import flight_start
from hophoop.kernel.rigid.phase import Ending
from hophoop.kernel.rigid.transitions import undecided


def state_of(angle=0.5, vt=0.0, om=1.0, time=0.0):
    return start_state(0.0, 0.0, angle, vt, 0.0, om)._replace(t=time)


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
    found, vanishing = flight_start(body, state_of(angle, om=math.sqrt(u)), False)
    assert vanishing == count
    assert found == (0.0 if count == 3 else pytest.approx(opening, rel=0.1))


def test_a_lift_off_from_slip_begins_with_the_third_derivative_of_the_gap():
    body, angle = body_of(), 0.7
    om = math.sqrt(body.gn / (body.eps * math.cos(angle)))
    state = state_of(angle, vt=-0.5, om=om)
    th, spin = mpf(angle), mpf(om)

    def gap(tau):
        return body.eps * (mp.cos(th) - mp.cos(th + spin * tau) - spin * tau * mp.sin(th)) - body.gn * tau**2 / 2

    assert flight_start(body, state, True) == (0.0, leading_zeros(gap))


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
    phase = phases.begin_phase(Mode.SKID, state_of(), Ending.CONE_FORWARD)
    assert vanishing_slip_derivatives(motion.scenario.to_body(), phase) == pytest.approx(power, abs=0.01)


@pytest.mark.parametrize(("speed", "vanishing"), [(0.0, 1), (1.0, 0), (-1.0, 0), (1e-300, 0)])
def test_slip_after_a_jump_begins_at_its_speed_or_with_zero(speed, vanishing):
    state = state_of(vt=speed)
    found = phases.begin_phase(Mode.SKID, state, Ending.CONTINUES)
    assert found == phases.Phase(Mode.SKID, state, True, phases.START_LEVEL, Ending.CONTINUES, phases.GOING)
    assert vanishing_slip_derivatives(body_of(), found) == vanishing


@pytest.mark.parametrize(("mu", "doubtful"), [(0.5, True), (math.inf, False)])
def test_where_nothing_is_decided_more_digits_may_tell(mu, doubtful):
    """Not where no friction is too much: there the model itself has no answer."""
    scratch = new_scratch()
    state = state_of(time=3.0)
    mode, after = undecided(body_of(mu=mu), state, new_log(np.empty(0, EVENT), np.empty(0, SEGMENT), scratch))
    assert (mode, after) == (UNDECIDED, state)
    assert phases.begin_phase(mode, after, Ending.CONTINUES).status == phases.UNDETERMINED
    assert np.array_equal(scratch.doubt, [3.0] if doubtful else [math.nan], equal_nan=True)


def test_a_phase_that_goes_on_or_ends_keeps_what_it_has():
    first, later = state_of(), state_of(om=2.0, time=1.0)
    phase = phases.Phase(Mode.SKID, first, True, 7, Ending.CONTINUES, phases.GOING)
    assert phases.continue_phase(phase, later, 8, Ending.LIFT_OFF) == phase._replace(
        state=later, begins=False, level=8, ending=Ending.LIFT_OFF
    )
    ended = phases.end_motion(phase, Mode.FLIGHT, later, Ending.LIFT_OFF, phases.UNDETERMINED)
    assert ended == phase._replace(
        mode=Mode.FLIGHT, state=later, begins=False, ending=Ending.LIFT_OFF, status=phases.UNDETERMINED
    )
