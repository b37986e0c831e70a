"""Compliant motions: oracle, ledger, limits and their orders, static hold, symmetries."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import hophoop as hh
from hophoop.simulation.compliant import to_compliance
from oracles import compliant as oracle
from oracles import mechanics
from oracles.cases import Case

HOOP = hh.Hoop.ideal(0.75)
LAWS = ("kelvin-voigt", "hunt-crossley")
FRICTIONS = ("tanh", "linear", "bristle")


def run(speed=3.1, duration=2.0, plane=None, hoop=HOOP, start=None, stiffness=1e6, **contact):
    """A motion on a contact whose stiffness is over m g / R."""
    plane = hh.Plane() if plane is None else plane
    start = hh.Start.rolling(speed) if start is None else start
    force = hoop.mass * (plane.gravity or 1.0) / hoop.radius
    return hh.simulate(hoop, plane, start, duration, hh.Compliant(stiffness=stiffness * force, **contact))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("friction", FRICTIONS)
def test_against_scipy_on_rederived_equations(law, friction):
    hoop = hh.Hoop(radius=0.6, mass=2.0, eccentricity=0.75, inertia_ratio=0.4375)
    plane = hh.Plane(mu=0.9, slope=0.05)
    start = hh.Start(height=0.02, angle=0.4, vx=1.5, omega=3.0, vy=0.1)
    duration, stiffness, slip_speed = 0.25, 500.0, 0.05
    motion = run(
        duration=duration, plane=plane, hoop=hoop, start=start, stiffness=stiffness,
        law=law, friction=friction, restitution=0.3, slip_speed=slip_speed,
    )  # fmt: skip
    _, comp, _, _ = to_compliance(motion.scenario)
    second = math.sqrt(0.6 / 9.81)
    contact = oracle.Contact(
        stiffness=stiffness * 2.0 * 9.81 / 0.6,
        damping=comp.c * 2.0 / second if law == "kelvin-voigt" else comp.d * second / 0.6,
        slip_speed=slip_speed,
        law=law,
        friction=friction,
        tangential_stiffness=stiffness * 2.0 * 9.81 / 0.6,
        tangential_damping=0.9 * 2.0 * 9.81 / slip_speed,
    )
    case = Case("drop", radius=0.6, mass=2.0, mu_static=0.9, mu_kinetic=0.9, slope=0.05)
    t = np.linspace(0.0, duration, 40)
    rows = oracle.motion(case, contact, [0.0, 0.02, 0.4, 1.5, 0.1, 3.0, 0.0, 0.0, 0.0], False, duration, t)
    assert len(motion.find("impact")) >= 1
    ours = motion.at(t)
    for column, name, scale in (
        (0, "x", 1.0), (1, "height", 0.1), (2, "angle", 1.0), (3, "vx", 10.0), (5, "omega", 10.0),
        (7, "friction", 10.0), (8, "damping", 10.0),
    ):  # fmt: skip
        np.testing.assert_allclose(getattr(ours, name), rows[:, column], rtol=0, atol=1e-7 * scale)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("stiffness", [1.0, 1e3, 1e6, 1e9, 1e12])
def test_ledger_closes_from_soft_to_stiff(law, friction, stiffness):
    for mu, speed in ((1.0, 3.1), (0.3, 0.1)):
        motion = run(speed, 3.0, hh.Plane(mu=mu), stiffness=stiffness, law=law, friction=friction)
        assert motion.status == "completed"
        assert abs(motion.ledger.residual) < 1e-9 * motion.ledger.range
        sample = motion.at(motion.times(300))
        book = sample.total + sample.spring + sample.friction + sample.damping
        assert np.ptp(book) < 1e-8 * motion.ledger.range
        # friction and the damper only ever take
        assert np.all(np.diff(sample.friction) > -1e-8)
        assert np.all(np.diff(sample.damping) > -1e-8)
        assert np.all(sample.normal_force >= 0.0)
        assert np.all(np.abs(sample.friction_force) <= mu * sample.normal_force * (1 + 1e-6) + 1e-6)


def test_events_of_the_hop():
    motion = run()
    rigid = hh.simulate(HOOP, hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    kinds = [event.kind for event in motion.events]
    assert kinds == [
        "start",
        "slip_start",
        "stick",
        "slip_start",
        "takeoff",
        "apex",
        "impact",
        "stick",
        "end",
    ]
    touch = motion.find("impact")[0]
    assert touch.collision is True
    assert touch.height == 0.0
    assert touch.vy < 0.0
    assert touch.before.vy == touch.vy  # a spring takes its time: nothing jumps
    for kind in ("takeoff", "apex", "impact"):
        assert motion.find(kind)[0].t == pytest.approx(rigid.find(kind)[0].t, abs=1e-4)
    left, right = motion.at(touch.t, side="left"), motion.at(touch.t)
    assert left.normal_force == 0.0 < right.normal_force
    assert motion.at(motion.find("takeoff")[0].t, side="left").normal_force == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(
    ("contact", "expected"),
    [
        ({}, 1.0),
        ({"friction": "bristle"}, 1.0),
        ({"slip_speed": "root"}, 0.5),
        ({"law": "hunt-crossley"}, 1.1),
    ],
)
def test_converges_to_rolling_and_slip_with_its_order(contact, expected):
    rigid = hh.simulate(HOOP, hh.Plane(), hh.Start.rolling(2.8), duration=2.0)
    t = rigid.times(100)
    ladder = [1e4, 1e5, 1e6, 1e7]
    errors = []
    for k in ladder:
        options = dict(contact)
        if options.get("slip_speed") == "root":
            options["slip_speed"] = math.sqrt(9.81 / k)
        soft = run(2.8, 2.0, stiffness=k, **options)
        errors.append(np.max(np.abs(soft.at(t).angle - rigid.at(t).angle)))
    order = -np.polyfit(np.log(ladder), np.log(errors), 1)[0]
    assert order == pytest.approx(expected, abs=0.2)
    assert errors[-1] < 1e-3


def test_landing_converges_to_the_plastic_impact():
    rigid = hh.simulate(HOOP, hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    impact = rigid.find("impact")[0]
    ladder = [1e6, 1e7, 1e8, 1e9]
    errors = []
    for k in ladder:
        soft = run(stiffness=k)
        lost = soft.at(1.82).damping - soft.at(1.8).damping
        assert lost == pytest.approx(impact.impact_normal, rel=30.0 / math.sqrt(k))
        errors.append(abs(soft.at(2.0).omega - rigid.at(2.0).omega))
    order = -np.polyfit(np.log(ladder), np.log(errors), 1)[0]
    assert 0.7 < order < 1.2


def test_inconsistent_slip_becomes_the_impact_without_collision():
    start = hh.Start(angle=-math.acos(0.75), vx=1.0)
    rigid = hh.simulate(HOOP, hh.Plane(), start, duration=0.3)
    assert rigid.find("painleve_inconsistent")
    errors = [abs(run(start=start, duration=0.3, stiffness=k).at(0.3).omega - rigid.at(0.3).omega) for k in (1e5, 1e7, 1e9)]
    assert errors[0] > 10 * errors[1] > 100 * errors[2]


@pytest.mark.parametrize("painleve", ["flight", "impact"])
def test_indeterminate_slip_follows_the_choice(painleve):
    start = hh.Start(angle=-math.acos(0.75), vx=6.0, omega=5.0)
    plane = hh.Plane(painleve=painleve)
    rigid = hh.simulate(HOOP, plane, start, duration=0.3)
    soft = run(plane=plane, start=start, duration=0.3, stiffness=1e9)
    assert soft.at(0.3).angle == pytest.approx(rigid.at(0.3).angle, abs=1e-4)


def test_bristle_holds_a_load_that_creep_lets_go():
    slope = 0.2
    angle = math.pi + math.asin(math.sin(slope) / 0.75) - slope  # ε sin(θ + β) = −sin β
    plane, start = hh.Plane(mu=0.5, slope=slope), hh.Start(angle=angle)
    held = run(plane=plane, start=start, duration=20.0, friction="bristle")
    creeping = run(plane=plane, start=start, duration=20.0, friction="tanh", slip_speed=1e-3)
    assert abs(held.at(20.0).x) < 1e-9
    assert creeping.at(20.0).x > 1e-3
    force = held.at(20.0)
    assert force.friction_force == pytest.approx(-9.81 * math.sin(slope), rel=1e-6)
    assert force.normal_force == pytest.approx(9.81 * math.cos(slope), rel=1e-6)
    assert force.spring > 0.0


def test_rest_on_top_lasts():
    motion = run(start=hh.Start(), duration=5.0)
    assert motion.status == "at_rest"
    assert motion.find("rest")[0].stable is False
    assert motion.at(5.0).angle == 0.0


@pytest.mark.parametrize("friction", FRICTIONS)
def test_mirrored_motion_is_the_mirrored_motion(friction):
    start = hh.Start(height=0.1, angle=0.4, vx=0.7, vy=-0.2, omega=4.0)
    mirrored = hh.Start(height=0.1, angle=-0.4, vx=-0.7, vy=-0.2, omega=-4.0)
    one = run(plane=hh.Plane(mu=0.6, slope=0.1), start=start, friction=friction)
    two = run(plane=hh.Plane(mu=0.6, slope=-0.1), start=mirrored, friction=friction)
    t = one.times(50)
    np.testing.assert_array_equal(one.at(t).angle, -two.at(t).angle)
    np.testing.assert_array_equal(one.at(t).height, two.at(t).height)
    assert one.sequence == two.sequence.translate(str.maketrans("SK", "KS"))


@pytest.mark.parametrize("law", LAWS)
def test_units_scale(law):
    small = run(duration=1.9, law=law, friction="bristle")
    hoop = hh.Hoop.ideal(0.75, radius=0.25, mass=3.0)
    plane = hh.Plane(gravity=9.81 / 4.0)
    large = run(3.1 / 4.0, 1.9, plane, hoop, law=law, friction="bristle")
    assert large.sequence == small.sequence
    assert large.at(1.9).angle == pytest.approx(small.at(1.9).angle, abs=1e-7)
    assert large.ledger.damping == pytest.approx(small.ledger.damping * 3.0 / 16.0, rel=1e-6)


def test_sampling_is_replay():
    motion = run()
    t = motion.times(500)
    again = run()
    np.testing.assert_array_equal(motion.at(t).angle, again.at(t).angle)
    one_by_one = [motion.at(value).height for value in t[::50]]
    np.testing.assert_array_equal(motion.at(t[::50]).height, one_by_one)
    for event in motion.events:
        assert motion.at(event.t).angle == pytest.approx(event.angle, abs=1e-9)


def test_free_flight_and_no_gravity():
    floating = run(plane=hh.Plane(gravity=0.0), start=hh.Start(height=0.2, vy=-0.1, omega=1.0), duration=8.0)
    assert floating.status == "completed"
    assert len(floating.find("impact")) >= 1
    assert abs(floating.ledger.residual) < 1e-9


def test_limits_end_with_their_status():
    cut = run(max_events=3)
    assert cut.status == "event_limit"
    assert not cut.ok
    assert len(cut.events) == 3
    assert math.isfinite(cut.at(0.0).kinetic)


@pytest.mark.parametrize("friction", ["tanh", "bristle"])
def test_rolling_resistance_converges_to_the_rigid_one(friction):
    scenario = hh.Scenario(plane=hh.Plane(mu=0.5, rolling_resistance=0.05), start=hh.Start.rolling(1.0), duration=1.5)
    rigid = hh.simulate(scenario)
    errors = []
    for stiffness in (1e4, 1e5, 1e6):
        motion = hh.simulate(scenario.replace("contact", hh.Compliant(stiffness=stiffness, friction=friction)))
        ledger = motion.ledger
        assert abs(ledger.residual) < 1e-9 * ledger.range
        assert ledger.rolling_resistance == pytest.approx(rigid.ledger.rolling_resistance, rel=20.0 / stiffness)
        errors.append(abs(motion.at(1.4).angle - rigid.at(1.4).angle))
    assert errors[2] < 0.2 * errors[1] < 0.04 * errors[0]


def test_rolling_resistance_by_another_integrator():
    """The couple −f N tanh(Rθ̇/v_s) in the Lagrangian's equations, by SciPy's Radau."""
    f, stiffness, damping, slow = 0.2, 3e3, 20.0, 0.05
    case = Case("soft", eccentricity=0.6, inertia_ratio=0.5, mu_static=0.4, mu_kinetic=0.4)
    contact = oracle.Contact(stiffness, damping, slow)
    hoop, plane = hh.Hoop(eccentricity=0.6, inertia_ratio=0.5), hh.Plane(mu=0.4, rolling_resistance=f)
    model = hh.Compliant(stiffness=stiffness, damping=damping, slip_speed=slow, friction="tanh", rtol=1e-10)
    motion = hh.simulate(hoop, plane, hh.Start(angle=1.0, vx=0.5, omega=-1.5), duration=0.6, contact=model)
    first = motion.at(0.0)
    assert set(motion.sequence) <= set("RSK")

    def right(_, state):
        load = oracle.normal(contact, state[1], state[4])
        drag = oracle.friction(case, contact, 0, load, state[3] - state[5], 0.0)
        couple = -f * load * np.tanh(state[5] / slow)
        force = mechanics.applied_forces(case, state[2], state[5]) + mechanics.contact_jacobian(case).T @ [drag, load]
        force[2] += couple
        return [*state[3:6], *np.linalg.solve(mechanics.mass_matrix(case, state[2]), force), -couple * state[5]]

    begin = [first.x, first.height, first.angle, first.vx, first.vy, first.omega, 0.0]
    exact = solve_ivp(right, (0.0, 0.6), begin, method="Radau", rtol=1e-9, atol=1e-11).y[:, -1]
    last = motion.at(0.6)
    found = [last.x, last.height, last.angle, last.vx, last.vy, last.omega, last.rolling_resistance]
    assert found == pytest.approx(exact, rel=1e-6, abs=1e-7)
    assert last.rolling_resistance > 0.1
