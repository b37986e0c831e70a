r"""Painlevé's paradox: slip for which no contact force exists, or several; and the dynamic jam.

In skid (σ = +1) the load on the rim is N = −f_n/p with m κ p = κ + ε sin θ (ε sin θ + μ (1 + ε cos θ)), all derived again here
from the contact's answer to a unit force: an impulse (−μ, 1) changes θ̇ by (ε sin θ + μ (1 + ε cos θ))/(κ m R) and
lifts the rim by 1/m minus the lever ε R sin θ times that, with the sign of docs/model.md#coordinates.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced
from random_scenarios import draw_beside_a_border, scenario_of

HOOP = hh.Hoop.ideal(0.75)
SKID = {"angle": -0.7, "vx": 3.0, "omega": 1.0}  # f_n < 0: pressed down
FAST = {"angle": -0.7, "vx": 8.0, "omega": 5.0}  # f_n > 0: about to lift


def lift_of_a_push(hoop, angle, mu, sigma):
    """Acceleration of the rim's lowest point off the plane per unit normal force with friction −σ μ, times m."""
    arm = hoop.eccentricity * math.sin(angle)
    height = 1 + hoop.eccentricity * math.cos(angle)
    spin = (arm + sigma * mu * height) / hoop.inertia_ratio
    return 1 + arm * spin


def free_lift(hoop, angle, omega, gravity=9.81):
    """f_n: acceleration of the lowest point off the plane without any contact force."""
    return -gravity + hoop.eccentricity * hoop.radius * omega**2 * math.cos(angle)


def start_of(mu, painleve="flight", restitution=0.0, law="stronge", duration=0.5, **state):
    plane = hh.Plane(mu=mu, painleve=painleve, restitution=restitution, impact_law=law)
    return hh.simulate(HOOP, plane, hh.Start(**state), duration=duration)


def mirror(state):
    return {name: -value for name, value in state.items()}


@pytest.mark.parametrize("state", [SKID, mirror(SKID)])
@pytest.mark.parametrize("law", ["newton", "poisson", "stronge"])
def test_inconsistent_slip_is_an_impact_without_collision(state, law):
    """No force can carry this slip: it is recorded, and an impact at t = 0 stops the slip."""
    sigma = 1 if state["vx"] > 0 else -1
    assert lift_of_a_push(HOOP, state["angle"], 1.2, sigma) < 0 > free_lift(HOOP, state["angle"], state["omega"])
    motion = start_of(1.2, restitution=0.5, law=law, **state)
    kinds = [event.kind for event in motion.events[:3]]
    assert kinds == ["start", "painleve_inconsistent", "impact"]
    impact = motion.events[2]
    assert impact.t == 0.0
    assert impact.collision is False
    assert impact.slip == 0.0
    assert impact.impulse_normal > 0.0
    assert impact.impact_tangential > 0.0
    if law == "newton":
        assert impact.vy == 0.0
    else:
        assert impact.vy > 0.0
        assert impact.to_mode == "H"
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range


@pytest.mark.parametrize("state", [FAST, mirror(FAST)])
def test_indeterminate_slip_follows_the_planes_choice(state):
    """Flight or impact are both solutions: the plane says which, and either is recorded."""
    sigma = 1 if state["vx"] > 0 else -1
    assert lift_of_a_push(HOOP, state["angle"], 1.2, sigma) < 0 < free_lift(HOOP, state["angle"], state["omega"])
    flies = start_of(1.2, "flight", **state)
    assert [event.kind for event in flies.events[:2]] == ["start", "painleve_indeterminate"]
    assert flies.events[1].to_mode == "H"
    assert flies.sequence.startswith("H")
    strikes = start_of(1.2, "impact", **state)
    assert [event.kind for event in strikes.events[:3]] == ["start", "painleve_indeterminate", "impact"]
    impact = strikes.events[2]
    assert impact.collision is False
    assert impact.slip == 0.0
    for motion in (flies, strikes):
        assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range


def test_the_impact_is_the_limit_of_ordinary_slip():
    """As μ comes up to the threshold the slip stops in less and less time, with the impact's impulse at last.

    An impact at fixed position: κ θ̇ grows by the torque of (−μ, 1) per unit impulse until v_t = 0.
    """
    mu = float(hh.theory.painleve_threshold(-0.7, HOOP))
    results = []
    for step in (1e-3, 1e-5, 1e-7):
        motion = start_of(mu * (1 - step), **SKID)
        stick = motion.events[1]
        results.append((stick.t, stick.omega))
        assert stick.kind in ("stick", "slip_reversal", "takeoff")
    impact = start_of(mu * (1 + 1e-9), **SKID).find("impact")[0]
    errors = [abs(omega - impact.omega) for _, omega in results]
    assert results[0][0] > results[1][0] > results[2][0]
    assert errors[2] < 0.2 * errors[0] + 1e-9


@pytest.mark.parametrize("omega", [20.0, 30.0, 37.0, 45.0])
@pytest.mark.parametrize("speed", [10.0, 30.0, 39.0])
def test_the_impact_closes_the_ledger_where_the_moment_of_inertia_is_small(omega, speed):
    """The impulse has no normal work; from q/κ it would have, as the last panel ends 1e-14 rad before p = 0."""
    hoop = hh.Hoop(eccentricity=0.9128464310036214, inertia_ratio=0.00013391426767761817)
    start = hh.Start(angle=-3.32, vx=speed, omega=omega)
    motion = hh.simulate(hoop, hh.Plane(mu=0.9864259833341639), start, duration=6.0)
    assert motion.find("painleve_inconsistent")
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range


def test_jam():
    """p and f_n go to zero together: recorded with the angle, and the run ends with a status that says so."""
    plane = hh.Plane(mu=1.219)
    motion = hh.simulate(HOOP, plane, hh.Start(angle=-2.312, vx=30.37, omega=5.654), duration=1.0)
    assert motion.status == "jammed"
    assert not motion.ok
    (jam,) = motion.find("jam")
    assert jam.t == motion.duration
    assert lift_of_a_push(HOOP, jam.angle, 1.219, 1) == pytest.approx(0.0, abs=1e-5)
    assert free_lift(HOOP, jam.angle, jam.omega) == pytest.approx(0.0, abs=1e-3)
    states = [state for state in hh.theory.jam_states(HOOP, plane) if state.mode == "K"]
    assert min(abs(math.remainder(jam.angle - state.angle, 2 * math.pi)) for state in states) < 1e-5
    assert jam.slip > 0.0
    # up to there the motion is as good as any
    half = motion.at(0.5 * motion.duration)
    begin = motion.at(0.0)
    assert half.total + half.friction == pytest.approx(begin.total, abs=1e-12 * motion.ledger.range)
    document = motion.to_dict()
    assert document["status"] == "jammed"
    assert document["events"][-2]["kind"] == "jam"


def test_without_the_paradox_nothing_is_recorded():
    """Below the hoop's least friction no start meets it."""
    random = np.random.default_rng(8)
    for _ in range(60):
        motion = start_of(
            0.88,
            duration=1.0,
            angle=float(random.uniform(-4, 4)),
            vx=float(random.normal() * 8),
            omega=float(random.normal() * 8),
        )
        for kind in ("painleve_inconsistent", "painleve_indeterminate", "jam"):
            assert not motion.find(kind)


def test_energy_keeps_rolling_hoops_from_the_jam():
    """The bound by hand for γ = 3/4, μ = 1; above the speed of the immediate hop for all bodies; below every jam found."""
    upper = max(state.angle for state in hh.theory.jam_states(HOOP) if state.mode == "S")
    c = math.cos(upper)
    by_hand = math.sqrt(9.81 * ((1 + 0.75 * c) / (0.75 * c) - 0.75 * (1 - c)) / 1.75)
    assert hh.theory.least_jam_speed(HOOP) == pytest.approx(by_hand, rel=1e-12)
    random = np.random.default_rng(2)
    finite = 0
    for _ in range(200):
        eccentricity = float(random.uniform(0.2, 0.999))
        share = float(random.uniform(0.01, 1.0))
        hoop = hh.Hoop(radius=0.7, mass=1.0, eccentricity=eccentricity, inertia_ratio=share * (1 - eccentricity**2))
        speed = hh.theory.least_jam_speed(hoop, hh.Plane(mu=float(random.uniform(0.05, 3.0))))
        assert speed > hh.theory.immediate_hop_speed(hoop)
        finite += math.isfinite(speed)
    assert finite > 20
    with pytest.raises(ValueError, match=r"plane\.slope"):
        hh.theory.least_jam_speed(HOOP, hh.Plane(slope=0.1))


def test_force_at_the_threshold():
    """As doubles compute κ p_σ it is negative there, and so would be N."""
    scenario = scenario_of(draw_beside_a_border(2026, 111379)[1])
    forces = hh.simulate(scenario).at(0.0)
    assert forces.mode in ("S", "K")
    assert forces.normal_force > 0.0
    sign = -1.0 if forces.slip > 0.0 else 1.0
    assert forces.friction_force == pytest.approx(sign * scenario.plane.mu_kinetic * forces.normal_force, rel=1e-14)


def test_slip_that_begins_at_the_singular_angle_is_at_its_end():
    """κ = 10⁻¹², ε = 1 and μ = 1: p = 0 at 3π/2, where rolling uses up its friction; there is no slip to be stopped."""
    motion = hh.simulate(
        hh.Hoop(eccentricity=1.0, inertia_ratio=1e-12, radius=9.57061204309192),
        hh.Plane(mu=1.0, gravity=15.113836368357711, restitution=1.0, impact_law="newton"),
        hh.Start(angle=1.3621702201520565),
        duration=1e3,
        contact=hh.Rigid(max_events=150),
    )
    assert motion.status == "event_limit"
    assert not motion.find("jam")
    assert abs(motion.ledger.residual) <= 1e-10 * motion.ledger.range


@pytest.mark.compiled
@pytest.mark.parametrize("index", [15449, 458239])
def test_slip_that_begins_at_the_threshold_is_followed_to_its_end(index):
    """Panels whose tails are rounding were foreseen to be ever narrower: half a million of them came to 10⁻¹⁴ s."""
    with forced("compiled"):
        motion = hh.simulate(scenario_of(draw_beside_a_border(2026, index)[1]))
    assert motion.status == "completed"
    assert len(motion.tables["segments"]) < 20_000
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range
