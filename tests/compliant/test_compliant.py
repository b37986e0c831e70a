"""Compliant motions: oracle, ledger, limits and their orders, static hold, symmetries."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import hophoop as hh
from hophoop.simulation.compliant import to_compliance
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
@pytest.mark.parametrize(
    ("friction", "resistance"), [("tanh", 0.0), ("tanh", 0.2), ("linear", 0.0), ("bristle", 0.0), ("bristle", 0.2)]
)
def test_against_scipy_on_rederived_equations(law, friction, resistance):
    """The Lagrangian's equations in SI units, with forces and losses that are functions of the state; μs = μk."""
    hoop = hh.Hoop(radius=0.6, mass=2.0, eccentricity=0.75, inertia_ratio=0.4375)
    plane = hh.Plane(mu=0.9, slope=0.05, rolling_resistance=resistance)
    start = hh.Start(height=0.02, angle=0.4, vx=1.5, omega=3.0, vy=0.1)
    motion = run(
        duration=0.25, plane=plane, hoop=hoop, start=start, stiffness=500.0, law=law, friction=friction, restitution=0.3,
        slip_speed=0.05,
    )  # fmt: skip
    _, comp, _, _ = to_compliance(motion.scenario)
    second = math.sqrt(0.6 / 9.81)
    stiffness, bristle_damping = 500.0 * 2.0 * 9.81 / 0.6, 0.9 * 2.0 * 9.81 / 0.05
    linear, nonlinear = (comp.c * 2.0 / second, 0.0) if law == "kelvin-voigt" else (0.0, comp.d * second / 0.6)
    case = Case("drop", radius=0.6, mass=2.0, slope=0.05)

    def rates(_, u):
        _, height, angle, vx, vy, omega, stretch = u[:7]
        slip, spring = vx - 0.6 * omega, -stiffness * min(height, 0.0)
        load = max(spring * (1.0 - nonlinear * vy) - linear * vy, 0.0) if height < 0.0 else 0.0
        stretching = 0.0
        if friction == "bristle":  # its foot slides where spring and damper pull more than Coulomb's friction
            drag = np.clip(-stiffness * stretch - bristle_damping * slip, -0.9 * load, 0.9 * load)
            stretching = -(drag + stiffness * stretch) / bristle_damping
        else:
            drag = -0.9 * load * (math.tanh(slip / 0.05) if friction == "tanh" else np.clip(slip / 0.05, -1.0, 1.0))
        couple = -resistance * 0.6 * load * math.tanh(0.6 * omega / 0.05)
        force = mechanics.applied_forces(case, angle, omega) + mechanics.contact_jacobian(case).T @ [drag, load]
        force[2] += couple
        acceleration = np.linalg.solve(mechanics.mass_matrix(case, angle), force)
        lost = -drag * slip - stiffness * stretch * stretching
        return [*u[3:6], *acceleration, stretching, lost, (spring - load) * vy, -couple * omega]

    t = np.linspace(0.0, 0.25, 40)
    begin = [0.0, 0.02, 0.4, 1.5, 0.1, 3.0, 0.0, 0.0, 0.0, 0.0]
    rows = solve_ivp(rates, (0.0, 0.25), begin, t_eval=t, method="DOP853", rtol=1e-10, atol=1e-12, max_step=1e-3).y
    assert len(motion.find("impact")) >= 1
    ours = motion.at(t)
    for row, name, scale in (
        (0, "x", 1.0), (1, "height", 0.1), (2, "angle", 1.0), (3, "vx", 10.0), (5, "omega", 10.0),
        (7, "friction", 10.0), (8, "damping", 10.0), (9, "rolling_resistance", 10.0),
    ):  # fmt: skip
        np.testing.assert_allclose(getattr(ours, name), rows[row], rtol=0, atol=1e-7 * scale)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("stiffness", [1.0, 1e6, 1e12])
def test_ledger_closes_from_soft_to_stiff(law, friction, stiffness):
    for mu, speed in ((1.0, 3.1), (0.3, 0.1)):
        motion = run(speed, 3.0, hh.Plane(mu=mu), stiffness=stiffness, law=law, friction=friction)
        assert motion.status == "completed"
        assert abs(motion.ledger.residual) < 1e-9 * motion.ledger.range
        sample = motion.at(motion.times(300))
        book = sample.total + sample.spring + sample.friction + sample.damping
        assert np.ptp(book) < 1e-8 * motion.ledger.range
        assert np.all(np.diff(sample.friction) > -1e-8)
        assert np.all(np.diff(sample.damping) > -1e-8)
        assert np.all(sample.normal_force >= 0.0)
        assert np.all(np.abs(sample.friction_force) <= mu * sample.normal_force * (1 + 1e-6) + 1e-6)


def test_events_of_the_hop():
    motion = run()
    rigid = hh.simulate(HOOP, hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    kinds = " ".join(event.kind for event in motion.events)
    assert kinds == "start slip_start stick slip_start takeoff apex impact stick end"
    touch = motion.find("impact")[0]
    assert touch.collision is True
    assert touch.height == 0.0
    assert touch.vy < 0.0
    for kind in ("takeoff", "apex", "impact"):
        assert motion.find(kind)[0].t == pytest.approx(rigid.find(kind)[0].t, abs=1e-4)
    left, right = motion.at(touch.t, side="left"), motion.at(touch.t)
    assert left.normal_force == 0.0 < right.normal_force


@pytest.mark.parametrize(("contact", "expected"), [({"friction": "bristle"}, 1.0), ({"law": "hunt-crossley"}, 1.1)])
def test_converges_to_rolling_and_slip_with_its_order(contact, expected):
    rigid = hh.simulate(HOOP, hh.Plane(), hh.Start.rolling(2.8), duration=2.0)
    t = rigid.times(100)
    ladder = [1e4, 1e5, 1e6, 1e7]
    errors = [np.max(np.abs(run(2.8, stiffness=k, **contact).at(t).angle - rigid.at(t).angle)) for k in ladder]
    order = -np.polyfit(np.log(ladder), np.log(errors), 1)[0]
    assert order == pytest.approx(expected, abs=0.2)
    assert errors[-1] < 1e-3


def test_landing_converges_to_the_plastic_impact():
    rigid = hh.simulate(HOOP, hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    impact = rigid.find("impact")[0]
    ladder = [1e6, 1e8]
    errors = []
    for k in ladder:
        soft = run(stiffness=k)
        lost = soft.at(1.82).damping - soft.at(1.8).damping
        assert lost == pytest.approx(impact.impact_normal, rel=30.0 / math.sqrt(k))
        errors.append(abs(soft.at(2.0).omega - rigid.at(2.0).omega))
    assert 25.0 < errors[0] / errors[1] < 250.0  # about linear in 1/k


def test_inconsistent_slip_becomes_the_impact_without_collision():
    start = hh.Start(angle=-math.acos(0.75), vx=1.0)
    rigid = hh.simulate(HOOP, hh.Plane(), start, duration=0.3)
    assert rigid.find("painleve_inconsistent")
    errors = [abs(run(start=start, duration=0.3, stiffness=k).at(0.3).omega - rigid.at(0.3).omega) for k in (1e5, 1e7)]
    assert errors[0] > 10 * errors[1]


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
    assert held.at(20.0).friction_force == pytest.approx(-9.81 * math.sin(slope), rel=1e-6)


def test_rest_on_top_lasts():
    motion = run(start=hh.Start(), duration=5.0)
    assert motion.status == "at_rest"
    assert motion.find("rest")[0].stable is False


@pytest.mark.parametrize("friction", FRICTIONS)
def test_mirrored_motion_is_the_mirrored_motion(friction):
    one, two = (
        run(
            plane=hh.Plane(mu=0.6, slope=0.1 * way), friction=friction,
            start=hh.Start(height=0.1, angle=0.4 * way, vx=0.7 * way, vy=-0.2, omega=4.0 * way),
        )
        for way in (1, -1)
    )  # fmt: skip
    t = one.times(50)
    np.testing.assert_array_equal(one.at(t).angle, -two.at(t).angle)
    np.testing.assert_array_equal(one.at(t).height, two.at(t).height)
    assert one.sequence == two.sequence.translate(str.maketrans("SK", "KS"))


def test_free_flight_and_no_gravity():
    floating = run(plane=hh.Plane(gravity=0.0), start=hh.Start(height=0.2, vy=-0.1, omega=1.0), duration=8.0)
    assert floating.find("impact")
    assert abs(floating.ledger.residual) < 1e-9


def test_rolling_resistance_converges_to_the_rigid_one():
    scenario = hh.Scenario(plane=hh.Plane(mu=0.5, rolling_resistance=0.05), start=hh.Start.rolling(1.0), duration=1.5)
    rigid = hh.simulate(scenario)
    errors = []
    for stiffness in (1e4, 1e5, 1e6):
        motion = hh.simulate(scenario.replace("contact", hh.Compliant(stiffness=stiffness, friction="bristle")))
        ledger = motion.ledger
        assert abs(ledger.residual) < 1e-9 * ledger.range
        assert ledger.rolling_resistance == pytest.approx(rigid.ledger.rolling_resistance, rel=20.0 / stiffness)
        errors.append(abs(motion.at(1.4).angle - rigid.at(1.4).angle))
    assert errors[2] < 0.2 * errors[1] < 0.04 * errors[0]
