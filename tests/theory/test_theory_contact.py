"""Where contact ends or has no answer: regions of the (θ, θ̇) plane, Painlevé and the jam, rest, no mass."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import optimize

import hophoop as hh
from hophoop import theory
from hophoop.kernel.physics.contact import free_acceleration, kappa_p_sigma, resistance_arm, slip_motion
from hophoop.scenario import to_body
from oracles import mechanics
from oracles.cases import case_of
from strategies import hoops

TURN = 2.0 * math.pi
REFERENCE = hh.Hoop.ideal(0.75)
BESIDE = 1e-9


# --- the (θ, θ̇) plane ------------------------------------------------------------------------------


@given(
    hoops,
    st.floats(-7.0, 7.0),
    st.floats(0.05, 2.0),
    st.floats(0.2, 1.0),
    st.floats(-0.5, 0.5),
    st.sampled_from([-1.0, 1.0]),
)
@settings(max_examples=60)
def test_regions_have_these_borders(hoop, theta, mu, ratio, slope, way):
    plane = hh.Plane(mu_static=mu, mu_kinetic=mu * ratio, slope=slope)
    low, high = theory.rolling_range(theta, hoop, plane)
    lift = theory.lift_off_speed(theta, hoop, plane)
    scale = math.sqrt(plane.gravity / hoop.radius)
    for border in (low, high, lift):
        if not 1e-3 * scale < border < 1e3 * scale:
            continue
        for omega in (border * (1 - 1e-7), border * (1 + 1e-7)):
            mode = theory.mode_of(theta, way * omega, hoop, plane)
            if low <= omega <= high:
                assert mode == "R"
            else:
                assert mode == ("H" if omega >= lift else mode)
                assert mode != "R"
                if omega < lift * (1 - 1e-12):
                    assert mode in "SK"


@given(hoops, st.floats(-7.0, 7.0), st.floats(-8.0, 8.0), st.floats(0.05, 2.0), st.floats(-0.5, 0.5))
@settings(max_examples=40)
def test_the_mode_is_the_one_the_motion_starts_in(hoop, theta, omega, mu, slope):
    plane = hh.Plane(mu=mu, slope=slope)
    motion = hh.simulate(hoop, plane, hh.Start.rolling(omega * hoop.radius, angle=theta), duration=1e-4)
    assert theory.mode_of(theta, omega, hoop, plane) == motion.events[0].to_mode


def test_modes_without_mass_and_without_answer():
    massless = hh.Hoop.ideal(1.0)
    assert theory.mode_of(0.5, 1.0, massless, hh.Plane(mu=2.0)) == "R"
    assert theory.mode_of(1.5, 4.0, massless, hh.Plane(mu=2.0)) == "M"
    assert theory.mode_of(-1.5, 4.0, massless, hh.Plane(mu=2.0)) == "?"


# --- Painlevé and the jam --------------------------------------------------------------------------


@given(hoops, st.floats(-7.0, 7.0))
@settings(max_examples=60)
def test_at_the_painleve_threshold_p_is_zero(hoop, theta):
    mu = theory.painleve_threshold(theta, hoop)
    if not mu < 1e6:
        return
    direction = -1.0 if math.sin(theta) > 0 else 1.0
    plane = hh.Plane(mu=mu)
    response = mechanics.normal_response(case_of(hoop, plane), theta, direction)
    scale = (1 + (1 + mu) * (1 + hoop.eccentricity) ** 2 / hoop.inertia_ratio) / hoop.mass
    assert response == pytest.approx(0.0, abs=1e-13 * scale)
    assert theory.painleve_region(theta, mu * (1 - BESIDE), hoop) == 0
    assert theory.painleve_region(theta, mu * (1 + BESIDE), hoop) == direction


def test_painleve_minimum_of_the_ideal_hoop():
    gammas = np.array([0.1, 0.5, 0.75, 0.99])
    mu, angle = np.transpose([theory.painleve_minimum(hh.Hoop.ideal(gamma)) for gamma in gammas])
    np.testing.assert_allclose(mu, np.sqrt(1 - gammas**2) / gammas, rtol=1e-14)
    np.testing.assert_allclose(angle, np.arccos(gammas), rtol=1e-13)
    assert mu[2] == pytest.approx(0.882, abs=5e-4)
    assert theory.painleve_minimum(hh.Hoop.ideal(0.0)).mu == math.inf


@given(hoops)
@settings(max_examples=30)
def test_painleve_minimum_is_the_smallest_threshold(hoop):
    mu, angle = theory.painleve_minimum(hoop)
    found = optimize.minimize_scalar(
        lambda theta: theory.painleve_threshold(float(theta), hoop),
        bounds=(1e-3, math.pi - 1e-3),
        options={"xatol": 1e-10},
    )
    assert mu == pytest.approx(found.fun, rel=1e-12)
    assert theory.painleve_threshold(angle, hoop) == mu
    assert mu <= np.min(theory.painleve_threshold(np.linspace(0.01, 6.27, 500), hoop))


@pytest.mark.parametrize(
    ("angle", "omega", "vx"),
    [
        (4.967679362866822, 6.38732389612413, 8.510443465043668),
        (1.47209158663742, -5.372362477422549, -9.86687359897479),
    ],
)
def test_a_motion_jams_in_a_jam_state(angle, omega, vx):
    plane = hh.Plane(mu=1.1)
    start = hh.Start(angle=angle, omega=omega, vx=vx)
    motion = hh.simulate(REFERENCE, plane, start, duration=1.0)
    assert motion.status == "jammed"
    jam = motion.find("jam")[0]
    near = min(theory.jam_states(REFERENCE, plane), key=lambda state: abs(state.angle - jam.angle))
    assert near.mode == jam.from_mode
    assert near.angle == pytest.approx(jam.angle, abs=1e-9)
    assert near.omega == pytest.approx(abs(jam.omega), rel=1e-4)


@given(hoops, st.floats(0.1, 5.0), st.floats(-0.5, 0.5))
@settings(max_examples=40)
def test_jam_states_have_neither_p_nor_f(hoop, mu, slope):
    plane = hh.Plane(mu=mu, slope=slope)
    body = to_body(hoop, plane)
    states = theory.jam_states(hoop, plane)
    if mu < theory.painleve_minimum(hoop).mu:
        assert states == ()
    unit = math.sqrt(hoop.radius / plane.gravity)
    for state in states:
        s, c = math.sin(state.angle), math.cos(state.angle)
        u = (state.omega * unit) ** 2
        assert kappa_p_sigma(body, s, c, 1 if state.mode == "K" else -1, 0.0) == pytest.approx(0.0, abs=1e-12 * (1 + mu))
        assert free_acceleration(body, s, c, u)[1] == pytest.approx(0.0, abs=1e-13 * (1 + u))


# --- rest, and no mass -----------------------------------------------------------------------------


@pytest.mark.parametrize("slope", [0.0, 0.2, -0.2])
def test_equilibria_last(slope):
    plane = hh.Plane(slope=slope)
    places = theory.equilibria(REFERENCE, plane)
    assert [place.stable for place in places] == [False, True]
    for place in places:
        assert math.sin(place.angle + slope) * 0.75 == pytest.approx(-math.sin(slope), abs=1e-15)
        assert place.holds
    stable = places[1]
    motion = hh.simulate(REFERENCE, plane, hh.Start.rolling(0.0, angle=stable.angle), duration=3.0)
    assert motion.at(3.0).angle == pytest.approx(stable.angle, abs=1e-14)
    motion = hh.simulate(REFERENCE, plane, hh.Start.rolling(0.0, angle=stable.angle + 1e-4), duration=6.0)
    assert motion.find("turn")[1].t == pytest.approx(stable.period, rel=1e-8)


def test_equilibria_that_do_not_hold_or_do_not_exist():
    steep = hh.Plane(slope=0.5, mu=0.3)
    assert [place.holds for place in theory.equilibria(REFERENCE, steep)] == [False, False]
    assert theory.equilibria(hh.Hoop.ideal(0.3), steep) == ()
    assert theory.equilibria(hh.Hoop.ideal(0.0)) == ()
    assert theory.equilibria(REFERENCE, hh.Plane(gravity=0.0)) == ()


@pytest.mark.parametrize(("speed", "mu"), [(0.5, 2.0), (2.0, 2.0), (0.5, 0.7), (-1.0, 2.0)])
def test_the_massless_hoop_loses_its_force_here(speed, mu):
    plane = hh.Plane(mu=mu)
    loss = theory.massless_loss(speed, 1.3, plane)
    motion = hh.simulate(hh.Hoop.ideal(1.0, radius=1.3), plane, hh.Start.rolling(speed), duration=5.0)
    skim = motion.find("skim")[0]
    assert loss.angle == pytest.approx(skim.angle, rel=1e-12)
    assert loss.omega == pytest.approx(skim.before.omega, rel=1e-11)
    assert loss.by_friction == (mu < 1.0)


def test_littlewoods_ninety_degrees():
    loss = theory.massless_loss(0.0, plane=hh.Plane(mu=1.5))
    assert loss.angle == pytest.approx(math.pi / 2, rel=1e-15)
    speeds = np.linspace(0.1, 3.0, 7)
    by_normal = theory.massless_loss(speeds, plane=hh.Plane(mu=50.0))
    np.testing.assert_allclose(by_normal.omega, math.sqrt(9.81), rtol=1e-12)  # θ̇ = √(g/R) always
    assert theory.massless_loss(3.2).angle == 0.0
    # friction is first unless v0²/(gR) > (1 − μ²)/(1 + μ²)
    mu = 0.6
    border = math.sqrt(9.81 * (1 - mu**2) / (1 + mu**2))
    first = theory.massless_loss(border * np.array([1 - BESIDE, 1 + BESIDE]), plane=hh.Plane(mu=mu))
    assert first.by_friction.tolist() == [True, False]


@pytest.mark.parametrize("slope", [0.0, 0.2, -0.3])
@pytest.mark.parametrize("eps", [0.0, 0.25, 0.75])
def test_rest_ranges_are_where_the_couple_is_enough(slope, eps):
    hoop = hh.Hoop(eccentricity=eps, inertia_ratio=0.5)
    for f in (0.01, 0.19, 0.3, 0.9):
        found = theory.rest_ranges(hoop, hh.Plane(slope=slope, rolling_resistance=f))
        for angle in np.linspace(0.003, 2.0 * np.pi, 157):
            need = abs(eps * np.sin(angle) * np.cos(slope) + (1.0 + eps * np.cos(angle)) * np.sin(slope))
            inside = any(rest.low <= angle <= rest.high or rest.low <= angle + 2.0 * np.pi <= rest.high for rest in found)
            assert inside == (need <= f * np.cos(slope)), (f, angle)
        assert all(0.0 <= rest.low < 2.0 * np.pi and rest.low < rest.high <= rest.low + 2.0 * np.pi for rest in found)


def test_closed_forms_are_refused_with_rolling_resistance():
    plane = hh.Plane(rolling_resistance=0.05)
    hoop = hh.Hoop.ideal(0.75)
    for asked in (
        lambda: theory.rolling_speed(1.0, hoop, 2.0, plane),
        lambda: theory.needed_friction(hoop, 2.0, plane),
        lambda: theory.first_slip_speed(hoop, plane),
        lambda: theory.jam_states(hoop, plane),
        lambda: theory.equilibria(hoop, plane),
        lambda: theory.rolling_range(1.0, hoop, plane),
    ):
        with pytest.raises(ValueError, match=r"plane.rolling_resistance = 0.05 must be 0 here"):
            asked()
    told = {quantity.key: quantity for quantity in theory.summary(hh.Scenario(plane=plane))}
    assert told["needed_friction"].value is None
    assert told["painleve_friction"].value is None
    assert told["immediate_hop_speed"].value == theory.immediate_hop_speed(hoop)
    assert told["rest_from"].value == theory.rest_ranges(hoop, plane)[0].low


def test_the_mode_with_rolling_resistance():
    # at rest within reach it rolls on as it is; beside a steep friction cone the couple decides
    plane = hh.Plane(rolling_resistance=0.3, mu=0.2)
    modes = theory.mode_of([0.1, 0.6, 2.0], [0.0, 0.0, 3.0], hh.Hoop.ideal(0.75), plane)
    for angle, omega, mode in zip([0.1, 0.6, 2.0], [0.0, 0.0, 3.0], modes, strict=True):
        start = hh.Start.rolling(omega, angle=angle)
        motion = hh.simulate(hh.Hoop.ideal(0.75), plane, start, duration=1e-3)
        assert motion.sequence[0] == mode


def region_by_forces(plane, hoop, theta, omega):
    """σ of the slip whose normal force has the sign of f_n, so that p_σ < 0; 2 for both directions."""
    body = to_body(hoop, plane)
    s, c = math.sin(theta), math.cos(theta)
    opening = free_acceleration(body, s, c, omega * omega)[1]
    normals = {
        sigma: slip_motion(body, s, c, omega * omega, sigma, resistance_arm(body, s, c, omega, sigma))[1] for sigma in (-1, 1)
    }
    pulls = [sigma for sigma, normal in normals.items() if normal * opening > 0.0]
    return pulls[0] if len(pulls) == 1 else len(pulls)


@pytest.mark.parametrize(("gamma", "mu", "resistance"), [(0.75, 0.9, 0.1), (0.75, 1.0, 0.0), (0.9, 0.05, 0.95), (0.9, 2, 0.01)])
def test_the_region_of_the_paradox_is_where_the_kernels_forces_change_sign(gamma, mu, resistance):
    hoop, plane = hh.Hoop.ideal(gamma), hh.Plane(mu=mu, rolling_resistance=resistance)
    theta, omega = np.linspace(-3.1, 3.1, 125), np.array([-0.8, -1e-3, 0.0, 1e-3, 0.8])[:, None]
    second = math.sqrt(hoop.radius / plane.gravity)
    found = theory.painleve_region(theta, mu, hoop, rolling_resistance=resistance, omega=omega / second)
    expected = [[region_by_forces(plane, hoop, float(angle), float(rate)) for angle in theta] for rate in omega[:, 0]]
    assert np.array_equal(found, expected)
    assert len(np.unique(found)) > 1
    # the mirror image: θ and θ̇ change their sign, spin is skid, both stay both
    mirrored = theory.painleve_region(-theta, mu, hoop, rolling_resistance=resistance, omega=-omega / second)
    assert np.array_equal(mirrored, np.where(found == 2, 2, -found))
