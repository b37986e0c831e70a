"""Gaits at slopes and loads that no page has, against Newton's method on motions of the tests' own oracle in many digits."""

import pytest
from mpmath import mp, mpf

import hophoop as hh
from oracles import precise
from oracles.cases import case_of
from slopes import on_slope

pytestmark = pytest.mark.long

DIGITS = 28
STEP = mpf(10) ** -9  # of central differences

# Slope in degrees, load, θ̇ near which to look, phases, revolutions.
GAITS = [
    (0.7, 0.81, 3.66, "RSRKR", 1),
    (1.7, 0.45, 4.289, "RSHHKR", 2),
    (2.3, 0.62, 2.98, "RSHKR", 1),
    (3.6, 0.22, 3.10, "RSHR", 1),
    (4.4, 0.33, 4.61, "RSHR", 2),
]


def at_bottom(gait, omega):
    """Return θ̇ with the load at the bottom again, from a start in rolling at the bottom, after the gait's revolutions."""
    scenario = gait.scenario
    case = case_of(scenario.hoop, scenario.plane, angle=+mp.pi, vx=omega, rolling=True, duration=1.001 * gait.time)
    motion = precise.solve(case, DIGITS)
    t = mpf(gait.time)
    for _ in range(6):
        state = motion.at(t)
        t -= (state["angle"] - mp.pi * (1 + 2 * gait.revolutions)) / state["omega"]
    return motion.at(t)["omega"]


@pytest.mark.parametrize(("degrees", "gamma", "near", "sequence", "revolutions"), GAITS)
def test_gaits_of_an_independent_solver(degrees, gamma, near, sequence, revolutions):
    found = hh.gaits.find(on_slope(degrees, gamma), near=near)
    gait = next(one for one in found if (one.sequence, one.revolutions) == (sequence, revolutions))
    with mp.workdps(DIGITS + 10):
        omega = mpf(gait.state.omega)
        slope = (at_bottom(gait, omega + STEP) - at_bottom(gait, omega - STEP)) / (2 * STEP)
        for _ in range(2):
            step = (at_bottom(gait, omega) - omega) / (1 - slope)
            omega += step
        assert abs(step) < mpf(10) ** -20
        assert gait.state.omega == pytest.approx(float(omega), rel=3e-15)
    assert gait.multipliers == pytest.approx([float(slope)], rel=1e-9)
