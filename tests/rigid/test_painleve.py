r"""Painlevé's paradox: slip for which no contact force exists, or several; and the dynamic jam.

In skid (σ = +1) the load on the rim is N = −f_n/p with m κ p = κ + ε sin θ (ε sin θ + μ (1 + ε cos θ)), all derived again here
from the contact's answer to a unit force: an impulse (−μ, 1) changes θ̇ by (ε sin θ + μ (1 + ε cos θ))/(κ m R) and
lifts the rim by 1/m minus the lever ε R sin θ times that, with the sign of docs/model.md#coordinates.
"""

from __future__ import annotations

import math

import pytest

import hophoop as hh
from random_scenarios import AT_PAINLEVE, at_painleve

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


def start_of(mu, painleve="flight", way=1, restitution=0.0, **state):
    plane = hh.Plane(mu=mu, painleve=painleve, restitution=restitution)
    return hh.simulate(HOOP, plane, hh.Start(**{name: way * value for name, value in state.items()}), duration=0.5)


@pytest.mark.parametrize("way", [1, -1])
def test_inconsistent_slip_is_an_impact_without_collision(way):
    """No force can carry this slip: it is recorded, and an impact at t = 0 stops the slip."""
    assert lift_of_a_push(HOOP, SKID["angle"], 1.2, 1) < 0 > free_lift(HOOP, SKID["angle"], SKID["omega"])
    motion = start_of(1.2, way=way, restitution=0.5, **SKID)
    assert [event.kind for event in motion.events[:3]] == ["start", "painleve_inconsistent", "impact"]
    impact = motion.events[2]
    assert (impact.t, impact.collision, impact.slip, impact.to_mode) == (0.0, False, 0.0, "H")
    assert impact.impact_tangential > 0.0
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range


@pytest.mark.parametrize("way", [1, -1])
def test_indeterminate_slip_follows_the_planes_choice(way):
    """Flight or impact are both solutions: the plane says which, and either is recorded."""
    assert lift_of_a_push(HOOP, FAST["angle"], 1.2, 1) < 0 < free_lift(HOOP, FAST["angle"], FAST["omega"])
    flies = start_of(1.2, "flight", way, **FAST)
    assert [event.kind for event in flies.events[:2]] == ["start", "painleve_indeterminate"]
    assert flies.events[1].to_mode == flies.sequence[0] == "H"
    strikes = start_of(1.2, "impact", way, **FAST)
    assert [event.kind for event in strikes.events[:3]] == ["start", "painleve_indeterminate", "impact"]
    assert (strikes.events[2].collision, strikes.events[2].slip) == (False, 0.0)
    assert all(abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range for motion in (flies, strikes))


def test_the_impact_is_the_limit_of_ordinary_slip():
    """As μ comes up to the threshold the slip stops in less and less time, with the impact's impulse at last."""
    mu = float(hh.theory.painleve_threshold(-0.7, HOOP))
    sticks = [start_of(mu * (1 - step), **SKID).events[1] for step in (1e-3, 1e-5, 1e-7)]
    impact = start_of(mu * (1 + 1e-9), **SKID).find("impact")[0]
    assert sticks[0].t > sticks[1].t > sticks[2].t
    assert abs(sticks[2].omega - impact.omega) < 0.2 * abs(sticks[0].omega - impact.omega) + 1e-9


def test_jam():
    """p and f_n go to zero together: recorded with the angle, and the run ends with a status that says so."""
    plane = hh.Plane(mu=1.219)
    motion = hh.simulate(HOOP, plane, hh.Start(angle=-2.312, vx=30.37, omega=5.654), duration=1.0)
    assert (motion.status, motion.ok) == ("jammed", False)
    (jam,) = motion.find("jam")
    assert jam.t == motion.duration
    assert jam.slip > 0.0
    assert lift_of_a_push(HOOP, jam.angle, 1.219, 1) == pytest.approx(0.0, abs=1e-5)
    assert free_lift(HOOP, jam.angle, jam.omega) == pytest.approx(0.0, abs=1e-3)
    states = [state for state in hh.theory.jam_states(HOOP, plane) if state.mode == "K"]
    assert min(abs(math.remainder(jam.angle - state.angle, 2 * math.pi)) for state in states) < 1e-5
    # up to there the motion is as good as any
    half, begin = motion.at(0.5 * motion.duration), motion.at(0.0)
    assert half.total + half.friction == pytest.approx(begin.total, abs=1e-12 * motion.ledger.range)


@pytest.mark.parametrize(("hoop", "mu"), [(HOOP, 1.0), (hh.Hoop(radius=0.7, eccentricity=0.9, inertia_ratio=0.1), 0.7)])
def test_energy_keeps_rolling_hoops_from_the_jam(hoop, mu):
    """The bound is the energy of rolling where f_n = 0, above the speed of the immediate hop."""
    plane, e, kap = hh.Plane(mu=mu), hoop.eccentricity, hoop.inertia_ratio
    c = math.cos(max(state.angle for state in hh.theory.jam_states(hoop, plane) if state.mode == "S"))
    rolling = (1 + kap + e**2 + 2 * e * c) / (2 * e * c) - e * (1 - c)
    by_hand = math.sqrt(2 * 9.81 * hoop.radius * rolling / ((1 + e) ** 2 + kap))
    assert hh.theory.least_jam_speed(hoop, plane) == pytest.approx(by_hand, rel=1e-12)
    assert by_hand > hh.theory.immediate_hop_speed(hoop)
    with pytest.raises(ValueError, match=r"plane\.slope"):
        hh.theory.least_jam_speed(hoop, hh.Plane(slope=0.1))


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


@pytest.mark.parametrize("index", AT_PAINLEVE)
def test_a_start_at_the_threshold_is_in_doubt(index):
    """Within 4 units in the last place of it the sign of κ p_σ decides whether it jams, turns, or is thrown up by 1e-9."""
    motion = hh.simulate(at_painleve(index))
    assert motion.doubt == 0.0
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range


def test_slow_slip_away_from_the_threshold_is_in_doubt():
    """θ̇² changes by its own size over less than the narrowest panel: 20 digits find that it slips on, doubles a jam."""
    start = hh.Start(vx=-8.68, omega=-0.043)
    assert hh.simulate(hh.Hoop.ideal(1.0 - 4.1e-11), hh.Plane(mu=0.71), start, duration=1.25).doubt == 0.0


@pytest.mark.parametrize("factor", [1.0 - 1e-9, 1.0 + 1e-9])
def test_a_start_beside_the_threshold_is_not(factor):
    """Slip has an answer below the friction of the paradox alone."""
    mu = float(hh.theory.painleve_threshold(-0.7, HOOP)) * factor
    motion = hh.simulate(HOOP, hh.Plane(mu=mu), hh.Start(**SKID), duration=0.1)
    assert motion.doubt > 0.0
    assert bool(motion.find("painleve_inconsistent")[:1]) is (factor > 1.0)
