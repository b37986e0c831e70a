"""Kernels over other numbers."""

from __future__ import annotations

from fractions import Fraction

import pytest
from mpmath import mp

import hophoop as hh
from hophoop.kernel.physics import contact
from hophoop.kernel.physics.body import Body, Mode
from hophoop.precise.kernels import Kernels, numbers_of
from hophoop.precise.motion import Run
from hophoop.precise.problem import Problem
from hophoop.precise.series import MorePrecision
from newton_euler import BODIES, STATES, accelerations


def test_constants_and_names_are_others_in_all_called_kernels():
    """1/3 is exact in fractions, though the kernel writes 1.0, and a replaced name counts two calls deep."""
    body = Body(*(Fraction(1, 3),) * 6, Fraction(0), 0, False, Fraction(0))
    arm, lever = Kernels(Fraction, {})(contact.contact_arms)(body, Fraction(3, 5), Fraction(4, 5))
    assert (arm, lever) == (Fraction(19, 15), Fraction(1, 5))
    low = Kernels(Fraction, {"load_height": lambda s, c: Fraction(0)})
    found = [kernels(contact.rolling_acceleration)(body, 0, 1, 1, 0) for kernels in (low, Kernels(Fraction, {}))]
    assert found[0] != found[1]
    assert contact.contact_arms(BODIES[0], 0.6, 0.8)[0] == pytest.approx(1.6)  # the kernel itself is as it was


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("state", STATES)
def test_forces_in_sixty_digits(body, state):
    """The kernel's forces over extended precision, against Newton's and Euler's equations in doubles."""
    kernels = Kernels(mp.mpf, numbers_of(mp))
    th, om = map(mp.mpf, state)
    s, c = mp.sin(th), mp.cos(th)
    friction, normal = kernels(contact.rolling_forces)(body, s, c, om * om, mp.mpf(0))
    assert isinstance(friction, mp.mpf)
    assert [float(friction), float(normal)] == pytest.approx(accelerations(body, *state, "roll")[3:], rel=1e-12, abs=1e-12)


def test_what_a_motion_replaces_is_there():
    """Every name that extended precision replaces is one that the kernel's steps read."""
    run = Run(Problem.of(hh.Scenario(start=hh.Start.rolling(3.1))), 110, False, 1e-20)
    run.run()
    read = {name for copy in run.kernels._copies.values() for name in copy.__code__.co_names}
    assert set(run.kernels._names) - read == {"sine", "sine_cosine_change"}  # of energies and flight, by the body's own copies


def test_a_tie_asks_for_more_digits_until_there_are_none():
    """At √(gR/γ) N is zero at the start: only at the last precision the derivative decides."""
    start = hh.Start.rolling(2.0)
    scenario = hh.Scenario(plane=hh.Plane(gravity=3.0), start=start, duration=0.2)
    with pytest.raises(MorePrecision):
        Run(Problem.of(scenario), 150, False, 1e-20).run()
    assert Run(Problem.of(scenario), 150, True, 1e-20).run().records[0].after_mode == Mode.SKID
