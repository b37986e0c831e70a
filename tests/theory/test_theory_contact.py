"""Where contact ends or has no answer: regions of the (θ, θ̇) plane, Painlevé and the jam, rest, no mass."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import hophoop as hh
from hophoop import theory
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
        for omega in (border * (1 - 1e-7), border * (1 + 1e-7)):
            if 1e-3 * scale < border < 1e3 * scale:
                mode = theory.mode_of(theta, way * omega, hoop, plane)
                assert (mode == "R") == (low <= omega <= high)
                assert mode == "R" or (mode == "H") == (omega >= lift) or omega == pytest.approx(lift, rel=1e-12)


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
    response = mechanics.normal_response(case_of(hoop, hh.Plane(mu=mu)), theta, direction)
    scale = (1 + (1 + mu) * (1 + hoop.eccentricity) ** 2 / hoop.inertia_ratio) / hoop.mass
    assert response == pytest.approx(0.0, abs=1e-13 * scale)


@given(hoops)
@settings(max_examples=30)
def test_painleve_minimum_is_the_smallest_threshold(hoop):
    assert theory.painleve_minimum(hh.Hoop.ideal(0.0)).mu == math.inf
    mu, angle = theory.painleve_minimum(hoop)
    assert theory.painleve_threshold(angle, hoop) == mu
    near = theory.painleve_threshold(angle + np.linspace(-1e-3, 1e-3, 101), hoop)
    assert mu <= min(np.min(near) * (1 + 1e-14), np.min(theory.painleve_threshold(np.linspace(0.01, 6.27, 500), hoop)))


@given(hoops, st.floats(0.1, 5.0), st.floats(-0.5, 0.5))
@settings(max_examples=40)
def test_jam_states_have_neither_p_nor_f(hoop, mu, slope):
    plane = hh.Plane(mu=mu, slope=slope)
    states = theory.jam_states(hoop, plane)
    assert mu >= theory.painleve_minimum(hoop).mu or states == ()
    case, scale = case_of(hoop, plane), (1 + mu) / (hoop.mass * hoop.inertia_ratio)
    for state in states:
        response = mechanics.normal_response(case, state.angle, 1 if state.mode == "K" else -1)
        assert response == pytest.approx(0.0, abs=1e-12 * scale)
        lift = mechanics.free_normal_acceleration(case, state.angle, state.omega)
        assert lift == pytest.approx(0.0, abs=1e-12 * (plane.gravity + hoop.radius * state.omega**2))


def test_jams_come_in_pairs_for_each_direction_of_slip():
    assert [state.mode for state in theory.jam_states(REFERENCE, hh.Plane(mu=1.1))] == ["S", "S", "K", "K"]


# --- rest, and no mass -----------------------------------------------------------------------------


@pytest.mark.parametrize("slope", [0.0, 0.2, -0.2])
def test_equilibria_last(slope):
    plane = hh.Plane(slope=slope)
    places = theory.equilibria(REFERENCE, plane)
    assert [(place.stable, place.holds) for place in places] == [(False, True), (True, True)]
    for place in places:
        assert math.sin(place.angle + slope) * 0.75 == pytest.approx(-math.sin(slope), abs=1e-15)
    stable = places[1]
    still, rocking = (
        hh.simulate(REFERENCE, plane, hh.Start.rolling(0.0, angle=stable.angle + off), duration=6.0) for off in (0.0, 1e-4)
    )
    assert still.at(3.0).angle == pytest.approx(stable.angle, abs=1e-14)
    assert rocking.find("turn")[1].t == pytest.approx(stable.period, rel=1e-8)


def test_equilibria_that_do_not_hold_or_do_not_exist():
    steep = hh.Plane(slope=0.5, mu=0.3)
    assert [place.holds for place in theory.equilibria(REFERENCE, steep)] == [False, False]
    assert theory.equilibria(hh.Hoop.ideal(0.3), steep) == ()
    assert theory.equilibria(hh.Hoop.ideal(0.0)) == ()
    assert theory.equilibria(REFERENCE, hh.Plane(gravity=0.0)) == ()


def test_littlewoods_ninety_degrees():
    assert theory.massless_loss(0.0, plane=hh.Plane(mu=1.5)).angle == pytest.approx(math.pi / 2, rel=1e-15)
    by_normal = theory.massless_loss(np.linspace(0.1, 3.0, 7), plane=hh.Plane(mu=50.0))
    np.testing.assert_allclose(by_normal.omega, math.sqrt(9.81), rtol=1e-12)  # θ̇ = √(g/R) always
    assert theory.massless_loss(3.2).angle == 0.0
    # friction is first unless v0²/(gR) > (1 − μ²)/(1 + μ²)
    border = math.sqrt(9.81 * (1 - 0.6**2) / (1 + 0.6**2))
    first = theory.massless_loss(border * np.array([1 - BESIDE, 1 + BESIDE]), plane=hh.Plane(mu=0.6))
    assert first.by_friction.tolist() == [True, False]


@pytest.mark.parametrize("slope", [0.0, 0.2, -0.3])
@pytest.mark.parametrize("eps", [0.0, 0.25, 0.75])
def test_rest_ranges_are_where_the_couple_is_enough(slope, eps):
    hoop, angles = hh.Hoop(eccentricity=eps, inertia_ratio=0.5), np.linspace(0.003, TURN, 157)
    need = np.abs(eps * np.sin(angles) * np.cos(slope) + (1.0 + eps * np.cos(angles)) * np.sin(slope))
    for f in (0.01, 0.19, 0.3, 0.9):
        found = theory.rest_ranges(hoop, hh.Plane(slope=slope, rolling_resistance=f))
        inside = np.zeros(157, bool)
        for low, high in ((rest.low, rest.high) for rest in found):
            assert 0.0 <= low < TURN
            assert low < high <= low + TURN
            inside |= ((low <= angles) & (angles <= high)) | (angles + TURN <= high)
        np.testing.assert_array_equal(inside, need <= f * np.cos(slope))


def test_closed_forms_are_refused_with_rolling_resistance():
    plane, hoop = hh.Plane(rolling_resistance=0.05), hh.Hoop.ideal(0.75)
    for asked in (
        lambda: theory.rolling_speed(1.0, hoop, 2.0, plane),
        lambda: theory.first_slip_speed(hoop, plane),
        lambda: theory.jam_states(hoop, plane),
        lambda: theory.equilibria(hoop, plane),
    ):
        with pytest.raises(ValueError, match=r"plane.rolling_resistance = 0.05 must be 0 here"):
            asked()
    told = {quantity.key: quantity.value for quantity in theory.summary(hh.Scenario(plane=plane))}
    assert told["needed_friction"] is told["painleve_friction"] is None
    assert told["immediate_hop_speed"] == theory.immediate_hop_speed(hoop)
    assert told["rest_from"] == theory.rest_ranges(hoop, plane)[0].low


@pytest.mark.parametrize(("angle", "omega"), [(0.1, 0.0), (0.6, 0.0), (2.0, 3.0)])
def test_the_mode_with_rolling_resistance(angle, omega):
    # at rest within reach it rolls on as it is; beside a steep friction cone the couple decides
    plane = hh.Plane(rolling_resistance=0.3, mu=0.2)
    motion = hh.simulate(REFERENCE, plane, hh.Start.rolling(omega, angle=angle), duration=1e-3)
    assert theory.mode_of(angle, omega, REFERENCE, plane) == motion.sequence[0]


@pytest.mark.parametrize(("gamma", "mu", "resistance"), [(0.75, 0.9, 0.1), (0.75, 1.0, 0.0), (0.9, 0.05, 0.95), (0.9, 2, 0.01)])
def test_the_region_of_the_paradox_is_where_the_plane_cannot_push(gamma, mu, resistance):
    """σ of the slip for which a normal force does not push the hoop off; 2 for both directions."""
    hoop, theta, omega = hh.Hoop.ideal(gamma), np.linspace(-3.1, 3.1, 125), np.array([-0.8, 1e-3])[:, None]
    case = case_of(hoop, hh.Plane(mu=mu), rolling_resistance=resistance)
    found = theory.painleve_region(theta, mu, hoop, rolling_resistance=resistance, omega=omega)
    pulls = [
        [[mechanics.normal_response(case, angle, sigma, way) < 0.0 for angle in theta] for way in (-1, 1)] for sigma in (-1, 1)
    ]
    assert np.array_equal(found, np.where(np.all(pulls, axis=0), 2, np.subtract(pulls[1], pulls[0], dtype=int)))
    assert len(np.unique(found)) > 1
