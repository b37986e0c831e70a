"""Rolling resistance: motions against an independent integrator."""

import hophoop as hh
from oracle_program import compare
from oracles.cases import Case, rolling

# each kind of event, to both sides, on the level and on slopes, to the end at rest
CASES = (
    rolling("slow", 0.5, 1.0, duration=5.0, rolling_resistance=0.02),
    rolling("hops", 3.1, 1.0, duration=2.6, rolling_resistance=0.001),
    rolling("comes to rest", 2.0, 1.0, duration=6.0, rolling_resistance=0.3),
    rolling("slips to rest", 3.1, 0.2, duration=6.0, rolling_resistance=0.3),
    rolling("slope", 1.0, 0.6, slope=0.1, angle=0.4, duration=3.0, rolling_resistance=0.05),
    rolling("back", -2.5, 0.5, slope=0.05, duration=3.0, rolling_resistance=0.1),
    Case("skids", vx=3.0, omega=-2.0, angle=1.0, mu_static=0.5, mu_kinetic=0.4, duration=2.0, rolling_resistance=0.05),
    Case("spins", vx=0.0, omega=9.0, angle=2.0, mu_static=0.3, mu_kinetic=0.3, duration=2.0, rolling_resistance=0.08),
    Case("slides without turning", vx=2.0, angle=0.3, eccentricity=0.5, inertia_ratio=0.6,
         mu_static=0.2, mu_kinetic=0.2, duration=3.0, rolling_resistance=0.9),
    Case("lands", height=0.3, vx=1.0, omega=3.0, angle=0.5, eccentricity=0.3, inertia_ratio=0.7,
         mu_static=0.6, mu_kinetic=0.5, duration=2.0, rolling_resistance=0.06),
    Case("scaled", radius=0.35, mass=2.2, eccentricity=0.6, inertia_ratio=0.3, vx=1.3, rolling=True, gravity=1.6,
         mu_static=0.4, mu_kinetic=0.3, duration=4.0, rolling_resistance=0.04),
    Case("steep, from rest", slope=0.5, angle=-0.9, mu_static=0.4, mu_kinetic=0.3, duration=1.5,
         rolling_resistance=0.02),
)  # fmt: skip


def test_agrees_with_an_integrator_in_time():
    kinds = {event.kind for case in CASES for event in compare(case).events}
    assert kinds >= {"turn", "rest", "slip_start", "stick", "takeoff", "impact", "slip_reversal"}


def test_where_only_the_couple_makes_the_paradox_the_model_has_no_answer():
    """κ p_σ = κ + ε sin θ (q − ρ) is negative with ρ, positive without."""
    hoop, start = hh.Hoop(eccentricity=0.9, inertia_ratio=0.2), hh.Start(angle=0.5, vx=-4.0, omega=0.2)
    for resistance, status in ((0.5, "undetermined"), (0.0, "completed")):
        plane = hh.Plane(mu=0.4, rolling_resistance=resistance)
        assert hh.simulate(hoop, plane, start, duration=1.0).status == status
