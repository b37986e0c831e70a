"""Derivatives of single pieces of a motion, each against differences of the same piece of two motions beside it."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.events import massless
from hophoop.derivatives.events.impact import (
    CLOSE,
    JUMP,
    Blow,
    d_pull_back,
    distance,
    impact_change,
    is_between_courses,
    pull_back,
    tangent_from,
)
from hophoop.derivatives.layout import (
    BEFORE_VN,
    BEFORE_VT,
    END,
    EPS,
    EVENT_ROWS,
    GN,
    GT,
    IMPACT_N,
    IMPACT_T,
    KAP,
    MU_K,
    MU_S,
    OM,
    P_N,
    P_T,
    PARAMETERS,
    RESIST,
    REST,
    ROLLING_LOSS,
    STATE_ROWS,
    STILL,
    TH,
    VN,
    VT,
    Reason,
    T,
    X,
    Y,
    body_tangent,
)
from hophoop.derivatives.pieces import flight_and_rest as moving
from hophoop.kernel.physics.body import Body, ImpactLaw
from hophoop.kernel.physics.closed_forms import flight_displacement, flight_gap, skim_duration, skim_state, strike
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impact import impact, slip_rates, stick_rates
from hophoop.kernel.records.state import start_state

STEP = 1e-6
NAMES = {EPS: "eps", KAP: "kap", MU_S: "mu_s", MU_K: "mu_k", GN: "gn", GT: "gt", REST: "rest", RESIST: "resist"}
BODY = Body(0.6, 0.5, 0.4, 0.3, 0.9, 0.3, 0.5, 2, False, 0.3)


def state_of(**values):
    named = {"x": 0.0, "y": 0.0, "angle": 0.0, "vt": 0.0, "vn": 0.0, "om": 0.0} | values
    return start_state(*named.values())


def directions():
    """One for each parameter and each component of the state: (changes, z)."""
    count = PARAMETERS + STATE_ROWS
    changes, z = np.zeros((PARAMETERS, count)), np.zeros((STATE_ROWS, count))
    changes[:, :PARAMETERS] = np.eye(PARAMETERS)
    z[:, PARAMETERS:] = np.eye(STATE_ROWS)
    return changes, z


def beside(body, state, changes, z, k, way):
    """Body and state a step along a direction."""
    step = way * STEP
    values = {name: getattr(body, name) + step * changes[row, k] for row, name in NAMES.items()}
    rows = {"t": T, "x": X, "y": Y, "th": TH, "om": OM, "vt": VT, "vn": VN, "impact_n": IMPACT_N, "impact_t": IMPACT_T}
    moved = {name: getattr(state, name) + step * z[row, k] for name, row in rows.items()}
    return body._replace(**values), state._replace(**moved)


def slopes(piece, body, state, changes, z):
    """Central differences of what a piece gives, one column a direction."""
    columns = []
    for k in range(z.shape[1]):
        after, before = (np.array(piece(*beside(body, state, changes, z, k, way))) for way in (1.0, -1.0))
        columns.append((after - before) / (2.0 * STEP))
    return np.array(columns).T


# --- impacts ----------------------------------------------------------------------------------------


def changed(blow, changes, z, k):
    """How a body and its impact change in a direction."""
    d_blow = Blow(changes[REST, k], blow.c * z[TH, k], -blow.s * z[TH, k], z[VT, k], z[VN, k])
    return body_tangent(changes, k), d_blow


def struck(body, state):
    vt, vn, spin, p_n, p_t, loss_n, loss_t = impact(body, body.rest, math.sin(state.th), math.cos(state.th), state.vt, state.vn)
    return vt, vn, spin, p_n, p_t, loss_n, loss_t


@pytest.mark.parametrize("law", ImpactLaw)
@pytest.mark.parametrize(("mu", "rest"), [(0.3, 0.5), (0.05, 0.8), (1.2, 0.3), (math.inf, 0.5), (0.0, 1.0)])
@pytest.mark.parametrize(("th", "vt"), [(0.7, 0.4), (-0.7, 0.4), (2.0, -1.5), (-1.2, -0.05), (2.6, 0.02)])
def test_an_impact(law, mu, rest, th, vt):
    body = BODY._replace(law=law, mu_s=mu, mu_k=mu, rest=rest)
    state = state_of(angle=th, vt=vt, vn=-1.1, om=0.4)
    changes, z = directions()
    if math.isinf(mu) or mu == 0.0:  # of no or infinite friction nothing changes
        changes[[MU_S, MU_K]] = 0.0
    changes[MU_S] = changes[MU_K]
    changes[END] = 0.0
    expected = slopes(struck, body, state, changes, z)
    blow = Blow(rest, math.sin(th), math.cos(th), vt, -1.1)
    assert not is_between_courses(body, blow)
    for k in range(z.shape[1]):
        found, reason = impact_change(body, blow, *changed(blow, changes, z, k))
        assert reason == Reason.NONE
        assert list(found) == pytest.approx(expected[:, k].tolist(), rel=2e-7, abs=2e-8)


def test_an_impact_that_stops_a_slip_that_has_just_begun():
    """From v_t = 0 either way: the impulse that stops it is there at once, the same to first order."""
    body = BODY._replace(mu_s=1.0, mu_k=1.0, rest=0.0)
    changes, z = np.zeros((PARAMETERS, 1)), np.zeros((STATE_ROWS, 1))
    s, c = math.sin(0.7), math.cos(0.7)
    for way in (1.0, -1.0):
        z[VT, 0] = way
        blow = Blow(0.0, s, c, 0.0, -1.1)
        found, reason = impact_change(body, blow, *changed(blow, changes, z, 0))
        assert reason == -1  # holds to this side
        state = state_of(angle=0.7, vn=-1.1)
        after, before = (np.array(struck(body, state._replace(vt=step))) for step in (way * STEP, 0.0))
        assert list(found) == pytest.approx(((after - before) / STEP).tolist(), rel=1e-5, abs=2e-5)


@pytest.mark.parametrize("vt", [0.4, -0.4])
def test_an_impact_without_friction_changes_by_a_little_friction(vt):
    """The friction that comes acts against the slip."""
    body = BODY._replace(mu_s=0.0, mu_k=0.0)
    changes, z = directions()
    blow = Blow(body.rest, math.sin(0.7), math.cos(0.7), vt, -1.1)
    found, _ = impact_change(body, blow, *changed(blow, changes, z, MU_K))
    state = state_of(angle=0.7, vt=vt, vn=-1.1)
    after, before = (np.array(struck(body._replace(mu_s=mu, mu_k=mu), state)) for mu in (STEP, 0.0))
    assert list(found) == pytest.approx(((after - before) / STEP).tolist(), rel=1e-5, abs=2e-5)


def test_what_has_no_derivative_of_an_impact():
    changes, z = directions()
    s, c = math.sin(0.7), math.cos(0.7)
    blow = Blow(0.0, s, c, 0.4, -1.1)
    assert impact_change(BODY._replace(rest=0.0), blow, *changed(blow, changes, z, REST))[1] == Reason.PLASTIC
    # friction that just holds the stick
    arm, lever = contact_arms(BODY, s, c)
    needed = abs(stick_rates(BODY, arm, lever)[0])
    for more, between in ((0.0, True), (1e-11, True), (1e-9, False)):
        body = BODY._replace(mu_s=needed + more, mu_k=needed + more)
        assert is_between_courses(body, Blow(0.5, s, c, 0.0, -1.1)) == between


def slip_that_just_stops(body, th):
    """The slip with which an impact's slip stops as the compression ends."""
    low, high = 0.0, 2.0
    for _ in range(80):
        vt = 0.5 * (low + high)
        rate = slip_rates(body, *contact_arms(body, math.sin(th), math.cos(th)), -body.mu_k)
        stops = -vt / rate[1]
        low, high = (vt, high) if stops < 1.1 / rate[2] else (low, vt)
    return vt


@pytest.mark.parametrize("th", [0.7, 1e-3, 3e-6, 1e-9])
def test_a_derivative_that_jumps_is_found(th):
    """The slip stops just as the compression ends. Both courses become one as θ → 0, and with it the jump."""
    body = BODY._replace(mu_s=0.9, mu_k=0.3)
    vt = slip_that_just_stops(body, th)
    blow = Blow(body.rest, math.sin(th), math.cos(th), vt, -1.1)
    by_slip = Blow(0.0, 0.0, 0.0, 1.0, 0.0)
    below, above = (tangent_from(body, blow, vt * (1.0 + side * 1e-12), STILL, by_slip)[1] for side in (-1.0, 1.0))
    jump = distance(below, above)
    assert is_between_courses(body, blow) == (jump > JUMP)
    for side in (-1.0, 1.0):
        assert not is_between_courses(body, blow._replace(vt=vt * (1.0 + side * 20.0 * CLOSE)))


def test_a_rim_that_is_pulled_back():
    body = BODY._replace(mu_s=math.inf, mu_k=math.inf)
    state = state_of(angle=0.7, vn=0.4)
    changes, z = directions()
    changes[[MU_S, MU_K]] = 0.0

    def pulled(body, state):
        return pull_back(body, math.sin(state.th), math.cos(state.th), state.vn)

    expected = slopes(pulled, body, state, changes, z)
    s, c = math.sin(0.7), math.cos(0.7)
    for k in range(z.shape[1]):
        found = d_pull_back(body, s, c, 0.4, body_tangent(changes, k), c * z[TH, k], -s * z[TH, k], z[VN, k])[1]
        assert list(found) == pytest.approx(expected[:, k].tolist(), rel=1e-7, abs=1e-9)


# --- flight and rest ----------------------------------------------------------------------------------


def flown(body, state, tau):
    s, c = math.sin(state.th), math.cos(state.th)
    opening = -body.gn + body.eps * c * state.om**2
    y, vn = flight_gap(body, s, c, state.om, state.y, state.vn, opening, tau)
    along, vt = flight_displacement(body, state.vt, state.om, s, c, tau)
    return state._replace(x=state.x + along, y=y, th=state.th + state.om * tau, vt=vt, vn=vn), opening


@pytest.mark.parametrize("om", [1.3, -2.5])
@pytest.mark.parametrize("tau", [0.3, 2.0])
def test_a_flight(om, tau):
    begin = state_of(y=0.3, angle=0.7, vt=0.4, vn=0.8, om=om)
    changes, z = directions()
    _, opening = flown(BODY, begin, tau)
    rows = [X, Y, TH, OM, VT, VN]

    def components(body, state):
        after = flown(body, state, tau)[0]
        return after.x, after.y, after.th, after.om, after.vt, after.vn

    expected = slopes(components, BODY, begin, changes, z)
    moving.follow_flight(BODY, opening, begin, tau, changes, z)
    assert z[rows].ravel().tolist() == pytest.approx(expected.ravel().tolist(), rel=1e-7, abs=1e-8)


@pytest.mark.parametrize("stiffness", [2.0, -2.0, 1e-9, -1e-9])
@pytest.mark.parametrize("tau", [1e-3, 0.5, 3.0])
def test_a_disturbed_equilibrium(stiffness, tau):
    """δθ̈ = k δθ + b by power series."""
    angle, rate, drive = 0.3, -0.7, 0.9
    terms = [angle, rate, 0.5 * (stiffness * angle + drive)]
    for n in range(3, 60):
        terms.append(stiffness * terms[n - 2] / (n * (n - 1)))
    there = sum(term * tau**n for n, term in enumerate(terms))
    speed = sum(n * term * tau ** (n - 1) for n, term in enumerate(terms) if n)
    assert moving.perturbed_rest(stiffness, drive, angle, rate, tau) == pytest.approx((there, speed), rel=1e-13)


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_rates_of_a_state_are_those_of_its_motion(sigma):
    """A step along the motion: by the changes of a short motion itself."""
    mode = {0: 0, 1: 2, -1: 1}[sigma]
    hoop, plane = hh.Hoop(eccentricity=0.6, inertia_ratio=0.5), hh.Plane(gravity=1.0, mu_static=3.0, mu_kinetic=0.3, slope=0.2)
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    state = state_of(angle=1.7, vt=0.8 * sigma, om=0.7)
    start = hh.Start(angle=1.7, vx=0.8 * sigma + 0.7, omega=0.7) if sigma else hh.Start.rolling(0.7, angle=1.7)
    after = hh.simulate(hoop, plane, start, duration=1e-4).at(1e-4)
    turning, along, away, lost = moving.accelerations(body, mode, state, 0.0)
    assert after.omega - 0.7 == pytest.approx(1e-4 * turning, rel=1e-3)
    assert after.slip - 0.8 * sigma == pytest.approx(1e-4 * along, rel=1e-3, abs=1e-15)
    assert (away, lost) == (0.0, 0.0)
    z = np.zeros((STATE_ROWS, 1))
    moving.step_along(z, 0, 0.5, state, (turning, along, 0.25, 0.125))
    assert z[:, 0].tolist() == pytest.approx(
        [0.5, 0.5 * (state.vt + 0.7), 0.0, 0.35, 0.5 * turning, 0.5 * along, 0.125, 0.0, 0.0, 0.0625]
    )
    assert (T, X, Y, TH, OM, VT, VN, ROLLING_LOSS) == (0, 1, 2, 3, 4, 5, 6, 9)


# --- the massless hoop ----------------------------------------------------------------------------------

MASSLESS = Body(1.0, 0.0, 0.5, 0.25, 1.0, 0.0, 0.0, 2, False, 0.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_skimming_hoop(side):
    begin = state_of(angle=side * 1.1, om=side * 0.6)
    tau = 0.4

    def skimmed(body, state):
        way = math.copysign(1.0, state.om)
        return skim_state(body, state.x, state.th, state.vt, state.om, way, tau)

    changes, z = directions()
    changes[:] = 0.0
    z[Y] = z[VN] = 0.0
    expected = slopes(skimmed, MASSLESS, begin, changes, z)
    x, th, vt, om = skimmed(MASSLESS, begin)
    end = begin._replace(x=x, th=th, vt=vt, om=om)
    massless.follow_skim(MASSLESS, begin, side, tau, z)
    assert z[[X, TH, VT, OM]].ravel().tolist() == pytest.approx(expected.ravel().tolist(), rel=1e-6, abs=1e-7)
    turning, along, _, _ = massless.skim_rates(MASSLESS, end)
    beside_it = [np.array(skim_state(MASSLESS, 0.0, begin.th, 0.0, begin.om, side, tau + d)) for d in (1e-5, -1e-5)]
    rates = (beside_it[0] - beside_it[1]) / 2e-5
    assert (along, turning) == pytest.approx((rates[2], rates[3]), rel=1e-6)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("mu", [0.05, 3.0])
def test_the_blow_of_a_load(side, mu):
    """With friction that stops it, and with less."""
    body = MASSLESS._replace(mu_s=mu, mu_k=mu)
    begin = state_of(angle=side * 1.1, vt=side * 0.2, om=side * 0.6)

    def blown(body, state):
        s, c = math.sin(state.th), math.cos(state.th)
        tau = skim_duration(body, 1.0 + c, s * state.om)
        sink, speed = s * state.om + body.gn * tau, state.vt + state.om * (1.0 + c)
        after, p_n, p_t = strike(body, speed, -sink)
        x = state.x + s + speed * tau
        lost_n = state.impact_n + 0.5 * sink * sink
        lost_t = state.impact_t + 0.5 * (speed * speed - after * after)
        return state.t + tau, x, after, lost_n, lost_t, speed, -sink, p_n, p_t

    changes, z = directions()
    changes[[EPS, KAP, MU_S, GN, GT, REST, END, RESIST]] = 0.0
    z[Y] = z[VN] = z[ROLLING_LOSS] = 0.0
    expected = slopes(blown, body, begin, changes, z)
    kept = np.zeros((EVENT_ROWS, z.shape[1]))
    massless.follow_strike(body, begin, changes, z, kept)
    found = np.concatenate([z[[T, X, VT, IMPACT_N, IMPACT_T]], kept[[BEFORE_VT, BEFORE_VN, P_N, P_T]]])
    assert found.ravel().tolist() == pytest.approx(expected.ravel().tolist(), rel=1e-6, abs=1e-7)
    assert (z[[TH, OM, VN]] == 0.0).all()
