"""Closed forms and thresholds: against the simulation from both sides, the oracles, SciPy and mpmath."""

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

import hophoop as hh
from hophoop import theory
from hophoop.kernel.physics.closed_forms import rolling_u
from hophoop.scenario import to_body
from hophoop.theory.kernels import arcs
from oracles import elliptic
from oracles.cases import case_of
from strategies import hoops

TURN = 2.0 * math.pi
REFERENCE = hh.Hoop.ideal(0.75)
GENERAL = hh.Hoop(radius=0.35, mass=2.2, eccentricity=0.6, inertia_ratio=0.3)
LIGHT = hh.Hoop.ideal(0.2, radius=2.0, mass=0.5)
DOWNHILL = hh.Plane(slope=0.15, mu=0.9, gravity=3.7)
BESIDE = 1e-9


def modes_of_first_turn(hoop, plane, speed):
    """Letters of the simulated motion within the first turn."""
    motion = hh.simulate(hoop, plane, hh.Start.rolling(speed), duration=20.0)
    return {event.to_mode for event in motion.events if event.angle <= TURN}


# --- rolling ---------------------------------------------------------------------------------------


def test_the_articles_angular_velocity():
    gamma, speed, g = 0.75, 2.0, 9.81
    theta = np.append(np.linspace(-10.0, 10.0, 201), math.pi)
    expected = np.sqrt((gamma * g * (1 - np.cos(theta)) + speed**2 * (1 + gamma)) / (1 + gamma * np.cos(theta)))
    for way in (1.0, -1.0):
        np.testing.assert_allclose(theory.rolling_speed(theta, REFERENCE, way * speed), way * expected, rtol=1e-14)
    assert theory.max_rolling_speed(REFERENCE, speed) == pytest.approx(expected[-1], rel=1e-15)


@pytest.mark.parametrize(
    ("hoop", "plane", "speed"),
    [(REFERENCE, hh.Plane(mu=20.0), 2.0), (GENERAL, hh.Plane(mu=20.0), 0.9), (LIGHT, DOWNHILL, 1.0)],
)
def test_rolling_is_the_simulated_motion(hoop, plane, speed):
    motion = hh.simulate(hoop, plane, hh.Start.rolling(speed), duration=1.5)
    assert set(motion.sequence) == {"R"}
    sample = motion.at(motion.times(40))
    close = {"rtol": 1e-12, "atol": 1e-12}
    np.testing.assert_allclose(theory.rolling_speed(sample.angle, hoop, speed, plane), sample.omega, **close)
    np.testing.assert_allclose(theory.rolling_time(sample.angle, hoop, speed, plane), sample.t, **close)
    forces = theory.rolling_forces(sample.angle, hoop, speed, plane)
    np.testing.assert_allclose(forces.friction, sample.friction_force, rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(forces.normal, sample.normal_force, rtol=1e-11, atol=1e-11)
    energies = theory.rolling_energies(sample.angle, hoop, speed, plane)
    np.testing.assert_allclose(energies.kinetic, sample.kinetic, rtol=1e-11)
    np.testing.assert_allclose(energies.potential, sample.potential, rtol=1e-11, atol=1e-11)
    utilization = theory.friction_utilization(sample.angle, hoop, speed, plane)
    np.testing.assert_allclose(utilization, sample.utilization(plane), rtol=1e-9, atol=1e-12)


def test_uphill_the_hoop_turns_back():
    plane = hh.Plane(slope=-0.2)
    motion = hh.simulate(REFERENCE, hh.Plane(slope=-0.2, mu=50.0), hh.Start.rolling(1.0), duration=5.0)
    farthest = motion.find("turn")[0]
    angles = farthest.angle + np.array([-1e-9, 1e-9, TURN])
    found = theory.rolling_speed(angles, REFERENCE, 1.0, plane)
    assert found[0] > 0
    forces, times = (quantity(angles, REFERENCE, 1.0, plane) for quantity in (theory.rolling_forces, theory.rolling_time))
    for missing in (found, times, forces.normal):
        np.testing.assert_array_equal(np.isnan(missing), [False, True, True])
    assert math.isnan(theory.rolling_period(REFERENCE, 1.0, plane))
    times = farthest.t - np.array([2.0, 1.0, 1e-2, 1e-4])
    np.testing.assert_allclose(theory.rolling_time(motion.at(times).angle, REFERENCE, 1.0, plane), times, rtol=1e-10)
    # beyond a valley further downhill the same energy is enough again, but the hoop does not get there
    assert math.isnan(theory.rolling_speed(-3.0 * TURN, REFERENCE, 0.5, hh.Plane(slope=0.1)))


# --- friction that rolling needs -------------------------------------------------------------------


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_far_uphill_no_hilltop_is_looked_at_one_by_one(way):
    """Each hilltop is higher than the last: once the search took a step a turn, and 10¹⁸ rad had no end."""
    hoop, speed = hh.Hoop.ideal(0.3), 3.0
    reach = 1.3 * speed**2 / (9.81 * 1e-12)  # R = 1 m: so far on, all of v² (1 + γ) has become height
    found = theory.rolling_speed(way * reach * np.array([0.9, 1.1, 1e6]), hoop, way * speed, hh.Plane(slope=-way * 1e-12))
    np.testing.assert_array_equal(np.isnan(found), [False, True, True])
    # where they are few, one by one
    body, w = to_body(hoop, hh.Plane(slope=-way * 1e-3)), speed**2 / 9.81
    place = arcs.next_of(arcs.first_maximum(body), 0.0, way)
    while rolling_u(body, 0.0, w, place) >= 0.0:
        place += way * TURN
    assert arcs.blocking(body, 0.0, w, way * 1e5) == pytest.approx(place, rel=1e-12)
    assert math.isnan(arcs.blocking(body, 0.0, w, place - way * TURN))


def test_needed_friction_of_the_literature():
    needed = theory.needed_friction(REFERENCE, 0.1)
    assert needed.mu == pytest.approx(0.38, abs=0.005)  # the article: 38 %
    assert theory.needed_friction(REFERENCE, 2.0).mu < 1.0 < theory.needed_friction(REFERENCE, 2.1).mu
    assert theory.needed_friction(REFERENCE, 3.7).mu == math.inf
    assert theory.needed_friction(hh.Hoop.ideal(1.0), 0.1).mu == math.inf
    assert theory.needed_friction(hh.Hoop.ideal(0.0), 1.0).mu == 0.0


@given(hoops, st.floats(0.0, 0.9), st.floats(-0.4, 0.4))
@settings(max_examples=40)
def test_needed_friction_is_the_largest_ratio(hoop, part, slope):
    plane = hh.Plane(slope=slope)
    speed = part * theory.immediate_hop_speed(hoop, plane)
    mu, angle = theory.needed_friction(hoop, speed, plane)
    friction, normal = theory.rolling_forces(np.linspace(0.0, TURN, 4001), hoop, speed, plane)
    reached = np.cumsum(np.isnan(normal)) == 0
    friction, normal = friction[reached], normal[reached]
    if mu == math.inf:  # N may be negative between two points of the grid
        assert np.min(normal) < 1e-4 * np.max(normal)
        return
    assert np.min(normal) > 0.0
    assert mu >= np.max(np.abs(friction) / normal) * (1 - 1e-12)
    at = theory.rolling_forces(angle, hoop, speed, plane)
    assert abs(at.friction) / at.normal == pytest.approx(mu, rel=1e-12)


# --- times -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [1e-12, 1e-6, 0.4, 2.0])
@pytest.mark.parametrize("hoop", [GENERAL, hh.Hoop.ideal(0.5)])
def test_times_are_elliptic_integrals(hoop, speed):
    angles = np.array([1e-9, 0.3, 2.0, math.pi, 4.0, TURN - 1e-3, TURN, 20.0])
    with mp.workdps(40):
        *expected, whole = (
            float(elliptic.rolling_time(case_of(hoop, hh.Plane(), vx=speed), mpf(angle))) for angle in (*angles, 2 * mp.pi)
        )
    found = theory.rolling_time(angles, hoop, speed)
    # near 2π an angle has only 1e-15 to say how far the top is
    np.testing.assert_allclose(found[:5], expected[:5], rtol=2e-13, atol=1e-16)
    if speed >= 1e-6:
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-16)
    assert theory.rolling_period(hoop, speed) == pytest.approx(whole, rel=2e-13)
    assert theory.rolling_period(hoop, -speed) == theory.rolling_period(hoop, speed)
    assert theory.rolling_time(-angles[1], hoop, speed) == -found[1]


def test_a_hoop_that_leaves_the_plane_has_no_time_of_rolling():
    """At once, without gravity or from an immediate hop on; on the way, where the plane would have to pull it; in rocking."""
    hop = theory.immediate_hop_speed(REFERENCE)
    assert np.isnan(theory.rolling_period(REFERENCE, [1.001 * hop, -1.001 * hop, 10.0 * hop])).all()
    assert math.isnan(theory.rolling_time(0.5, REFERENCE, 1.0, hh.Plane(gravity=0.0)))
    light, late = hh.Hoop.ideal(0.97), np.array([1.0, 2.5, TURN])
    pulls = theory.rolling_forces(np.linspace(0.0, math.pi, 200), light, 1.0).normal < 0.0
    assert pulls.any()
    np.testing.assert_array_equal(np.isnan(theory.rolling_time(late, light, 1.0)), [False, True, True])
    assert math.isnan(theory.rocking_period(0.1, light))


def test_rest_and_start_from_rest():
    assert theory.rolling_time(1.0, REFERENCE, 0.0) == math.inf
    assert theory.rolling_time(0.0, REFERENCE, 0.0) == 0.0
    assert math.isnan(theory.rolling_time(-0.5, REFERENCE, 0.0, hh.Plane(slope=0.3)))


def test_rocking_at_its_limits():
    stable = next(rest for rest in theory.equilibria(GENERAL, DOWNHILL) if rest.stable)
    small = theory.rocking_period(stable.angle + 1e-5, GENERAL, DOWNHILL)
    assert small == pytest.approx(stable.period, rel=1e-9)
    assert theory.rocking_period(0.0, REFERENCE) == math.inf
    # from beside the hilltop downhill the hoop rolls away
    assert math.isnan(theory.rocking_period(0.5, REFERENCE, hh.Plane(slope=0.2)))
    assert math.isnan(theory.rocking_period(1.0, hh.Hoop.ideal(0.1), hh.Plane(slope=0.5)))


# --- critical speeds -------------------------------------------------------------------------------

CASES = [
    (REFERENCE, hh.Plane(mu=1.0)),
    (REFERENCE, hh.Plane(mu_static=0.8, mu_kinetic=0.5)),
    (hh.Hoop.ideal(0.4, radius=0.1, mass=3.0), hh.Plane(mu=0.3, gravity=1.6)),
    (LIGHT, hh.Plane(mu=0.9, slope=0.1)),
    (hh.Hoop(eccentricity=0.03862, inertia_ratio=0.00104), hh.Plane(mu=0.07533)),  # slips at 0.8° from the top
]


@pytest.mark.parametrize(("hoop", "plane"), CASES)
def test_critical_speeds_from_both_sides(hoop, plane):
    slip, hop, immediate = theory.critical_speeds(hoop, plane)
    assert 0.0 < slip < hop <= immediate
    assert theory.needed_friction(hoop, slip, plane).mu == pytest.approx(plane.mu_static, rel=1e-11)
    for side in (-1, 1):
        assert bool(modes_of_first_turn(hoop, plane, slip * (1 + side * BESIDE)) & {"S", "K"}) == (side > 0)
        assert ("H" in modes_of_first_turn(hoop, plane, hop * (1 + side * BESIDE))) == (side > 0)
        motion = hh.simulate(hoop, plane, hh.Start.rolling(immediate * (1 + side * BESIDE)), duration=0.01)
        assert (motion.sequence[0] == "H") == (side > 0)


def test_critical_speeds_at_their_limits():
    assert theory.first_slip_speed(REFERENCE, hh.Plane(mu=0.37)) == 0.0  # any push: the article's μ ≥ 0.38
    assert theory.first_slip_speed(REFERENCE, hh.Plane(mu=math.inf)) == math.inf
    assert theory.first_slip_speed(REFERENCE, hh.Plane(mu=0.0)) == 0.0
    assert theory.critical_speeds(hh.Hoop.ideal(0.0)) == (math.inf, math.inf, math.inf)
    assert theory.first_hop_speed(REFERENCE, turns=4) <= theory.first_hop_speed(REFERENCE)


@given(hoops, st.floats(0.05, 2.0), st.floats(0.3, 1.0))
@settings(max_examples=10)
def test_hops_begin_at_one_speed(hoop, mu, ratio):
    """Below the critical speed there is no hop, above it always one, also at speeds not tried."""
    plane = hh.Plane(mu_static=mu, mu_kinetic=mu * ratio)
    slip, hop, immediate = theory.critical_speeds(hoop, plane)
    speeds = immediate * np.linspace(0.0137, 0.9973, 23)
    seen = ~np.isnan(theory.hop_angle(hoop, speeds, plane))
    np.testing.assert_array_equal(seen, speeds >= hop)
    slides = ~np.isnan(theory.slip_angle(hoop, speeds, plane))
    if slip > 0.0:  # else the smallest push slips, but a faster hoop may not
        np.testing.assert_array_equal(slides, speeds >= slip)
    else:
        assert not math.isnan(theory.slip_angle(hoop, 1e-9 * immediate, plane))


def test_angles_are_where_the_forces_say():
    speeds = np.array([2.8, 3.1])
    assert math.isnan(theory.slip_angle(REFERENCE, 2.0))
    used = theory.friction_utilization(theory.slip_angle(REFERENCE, speeds), REFERENCE, speeds)
    np.testing.assert_allclose(used, 1.0, rtol=1e-12)
    hops = np.degrees(theory.hop_angle(REFERENCE, speeds))
    assert hops == pytest.approx([math.nan, 315.6], abs=0.05, nan_ok=True)


# --- arrays and errors -----------------------------------------------------------------------------


def test_numbers_broadcast():
    table = theory.rolling_speed(np.linspace(0, 6, 4)[:, None], REFERENCE, [1.0, 2.0, 3.0])
    assert table.shape == (4, 3)
    assert table[1, 2] == theory.rolling_speed(2.0, REFERENCE, 3.0)
    assert isinstance(theory.rolling_speed(1.0, REFERENCE, 1.0), float)
    assert theory.massless_loss([[0.1], [0.2]], [1.0, 2.0, 3.0]).angle.shape == (2, 3)
    assert theory.rolling_speed([], REFERENCE, 1.0).shape == (0,)


def region(gamma, resistance):
    return theory.painleve_region(0.7, 1.0, hh.Hoop.ideal(gamma), rolling_resistance=resistance, omega=1.0)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: theory.rolling_speed(math.nan, REFERENCE, 1.0), "theta = nan must be a finite number."),
        (lambda: theory.rolling_speed("a", REFERENCE, 1.0), "theta = 'a' must be a number"),
        (lambda: theory.rolling_speed(1.0, 0.75, 1.0), "hoop = 0.75 must be a Hoop"),
        (
            lambda: theory.rolling_speed([1.0, 2.0], REFERENCE, [1.0, 2.0, 3.0]),
            "do not go together: theta (2,), v0 (3,).",
        ),
        (lambda: theory.max_rolling_speed(REFERENCE, 1.0, DOWNHILL), "plane.slope must be 0"),
        (lambda: theory.first_slip_speed(hh.Hoop.ideal(1.0)), "hoop.inertia_ratio = 0.0 must be above 0"),
        (lambda: theory.first_hop_speed(REFERENCE, hh.Plane(slope=-0.1)), "plane.slope must be at least 0"),
        (lambda: theory.first_hop_speed(REFERENCE, turns=0), "turns = 0 must be a whole number"),
        (lambda: theory.painleve_region(1.0, -0.5, REFERENCE), "mu = -0.5 must be at least 0."),
        (lambda: theory.painleve_region(0.7, 1.0, REFERENCE, rolling_resistance=0.1), "omega = None must be given"),
        (lambda: region(0.75, -0.1), "rolling_resistance = -0.1 must be from 0 to 1"),
        (lambda: region(0.9, 0.98), "rolling_resistance = 0.98 must be below 0.968"),
        (lambda: region(1.0, 0.1), "rolling_resistance = 0.1 must be 0 for the massless hoop"),
        (lambda: theory.jam_states(hh.Hoop.ideal(1.0)), "hoop.inertia_ratio = 0 must be above 0"),
        (lambda: theory.massless_loss(1.0, plane=DOWNHILL), "plane.slope must be 0"),
        (lambda: theory.massless_loss(1.0, radius=-1.0), "hoop.radius = -1.0 must be from 1e-06 to 1e+06 m."),
    ],
)
def test_bad_arguments_get_a_sentence(call, sentence):
    with pytest.raises(ValueError, match=re.escape(sentence)):
        call()
