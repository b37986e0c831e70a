"""Rolling resistance: motions against an independent integrator, and what must hold for all of them."""

from __future__ import annotations

import math

import pytest

import hophoop as hh
from hophoop.kernel.physics.contact import kappa_p_sigma, resistance_arm
from hophoop.precise.agreement import compare
from oracle_program import essential, highest_apexes, program_events, simulate
from oracles import hybrid
from oracles.cases import Case, rolling

# (case, sequence): each kind of event, to both sides, on the level and on slopes, to the end at rest
CASES = [
    (rolling("slow", 0.5, 1.0, duration=5.0, rolling_resistance=0.02), "R"),
    (rolling("hops", 3.1, 1.0, duration=2.6, rolling_resistance=0.001), None),
    (rolling("comes to rest", 2.0, 1.0, duration=6.0, rolling_resistance=0.3), None),
    (rolling("slips to rest", 3.1, 0.2, duration=6.0, rolling_resistance=0.3), None),
    (rolling("slope", 1.0, 0.6, slope=0.1, angle=0.4, duration=3.0, rolling_resistance=0.05), None),
    (rolling("back", -2.5, 0.5, slope=0.05, duration=3.0, rolling_resistance=0.1), None),
    (Case("skids", vx=3.0, omega=-2.0, angle=1.0, mu_static=0.5, mu_kinetic=0.4, duration=2.0, rolling_resistance=0.05), None),
    (Case("spins", vx=0.0, omega=9.0, angle=2.0, mu_static=0.3, mu_kinetic=0.3, duration=2.0, rolling_resistance=0.08), None),
    (Case("slides without turning", vx=2.0, angle=0.3, eccentricity=0.5, inertia_ratio=0.6,
          mu_static=0.2, mu_kinetic=0.2, duration=3.0, rolling_resistance=0.9), None),
    (Case("lands", height=0.3, vx=1.0, omega=3.0, angle=0.5, eccentricity=0.3, inertia_ratio=0.7,
          mu_static=0.6, mu_kinetic=0.5, duration=2.0, rolling_resistance=0.06), None),
    (Case("scaled", radius=0.35, mass=2.2, eccentricity=0.6, inertia_ratio=0.3, vx=1.3, rolling=True, gravity=1.6,
          mu_static=0.4, mu_kinetic=0.3, duration=4.0, rolling_resistance=0.04), None),
    (Case("steep, from rest", slope=0.5, angle=-0.9, mu_static=0.4, mu_kinetic=0.3, duration=1.5,
          rolling_resistance=0.02), None),
]  # fmt: skip


def sizes(case: Case) -> dict[str, float]:
    """Natural sizes of the numbers of a motion."""
    second = math.sqrt(case.radius / case.gravity)
    speed = case.radius / second
    return {"t": second, "x": case.radius, "height": case.radius, "angle": 1.0, "vx": speed, "vy": speed,
            "omega": 1.0 / second, "energy": case.mass * speed**2}  # fmt: skip


@pytest.mark.parametrize(("case", "sequence"), CASES, ids=[case.name for case, _ in CASES])
def test_agrees_with_an_integrator_in_time(case: Case, sequence: str) -> None:
    exact, motion = hybrid.solve(case), simulate(case)
    size = sizes(case)
    ours, true = essential(program_events(motion)), essential(highest_apexes(exact.events))
    assert motion.status == exact.status
    assert motion.sequence == exact.sequence == (sequence or exact.sequence)
    if motion.status == "at_rest" and true[-1]["kind"] == "stick":
        assert ours.pop()["kind"] == "rest"  # where slip stops for good the integrator notes one event
    assert [event["kind"] for event in ours] == [event["kind"] for event in true]
    for event, right in zip(ours, true, strict=False):
        for name in ("t", "x", "height", "angle", "vx", "vy", "omega"):
            assert event[name] == pytest.approx(right[name], rel=1e-9, abs=2e-10 * size[name]), (event["kind"], name)
        assert event["to"] == right["to"]
    assert motion.ledger.rolling_resistance == pytest.approx(exact.events[-1]["rolling"], rel=1e-9, abs=1e-10 * size["energy"])
    assert abs(exact.residual) < 1e-9 * size["energy"]
    assert abs(motion.ledger.residual) < 1e-11 * motion.ledger.range
    middle = 0.37 * motion.duration
    if middle < exact.end:
        sample, right = motion.at(middle), exact.at(middle)
        for name in ("x", "height", "angle", "vx", "vy", "omega"):
            assert getattr(sample, name) == pytest.approx(right[name], rel=1e-9, abs=2e-10 * size[name]), name
        assert sample.rolling_resistance == pytest.approx(right["rolling"], rel=1e-9, abs=1e-10 * size["energy"])


def test_events_of_the_cases_cover_the_kinds() -> None:
    kinds = {event.kind for case, _ in CASES for event in simulate(case).events}
    assert kinds >= {"turn", "rest", "slip_start", "stick", "takeoff", "impact", "slip_reversal"}


# --- what must hold for all -------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [0.5, 2.5])
def test_the_limit_of_no_resistance_is_reached_linearly(speed: float) -> None:
    def end(f: float) -> float:
        plane = hh.Plane(rolling_resistance=f)
        return float(hh.simulate(hh.Scenario(plane=plane, start=hh.Start.rolling(speed), duration=1.2)).at(1.2).angle)

    plain = end(0.0)
    first, second = (end(f) - plain for f in (1e-4, 1e-6))
    assert first < 0.0
    assert second == pytest.approx(first / 100.0, rel=2e-3)


def test_a_balanced_hoop_slows_down_evenly_and_rests() -> None:
    f, speed, kap = 0.05, 1.5, 0.6
    hoop = hh.Hoop(eccentricity=0.0, inertia_ratio=kap)
    motion = hh.simulate(hoop, hh.Plane(rolling_resistance=f), hh.Start.rolling(speed), duration=20.0)
    slowing = f * 9.81 / (1.0 + kap)
    assert motion.status == "at_rest"
    rest = motion.find("rest")[0]
    assert rest.t == pytest.approx(speed / slowing, rel=1e-13)
    assert rest.x == pytest.approx(speed**2 / (2.0 * slowing), rel=1e-13)
    assert rest.stable is True
    assert motion.at(1.0).omega == pytest.approx(speed - slowing, rel=1e-13)
    assert motion.ledger.rolling_resistance == pytest.approx(f * 9.81 * rest.x, rel=1e-13)


def test_rest_is_rest_within_reach_and_not_beyond() -> None:
    f = 0.2
    plane = hh.Plane(rolling_resistance=f)
    for rest in hh.theory.rest_ranges(hh.Hoop.ideal(0.75), plane):
        for angle, rests in (
            (rest.low - 1e-6, False),
            (rest.low + 1e-6, True),
            (rest.high - 1e-6, True),
            (rest.high + 1e-6, False),
        ):
            motion = hh.simulate(hh.Hoop.ideal(0.75), plane, hh.Start(angle=angle), duration=1.0)
            first = motion.events[1]
            assert (first.kind == "rest" and first.t == 0.0) == rests
            if rests:
                assert [event.kind for event in motion.events] == ["start", "rest", "end"]
                assert motion.at(0.7).friction_force == 0.0
                assert motion.at(0.7).normal_force == pytest.approx(9.81, rel=1e-15)
                assert motion.ledger.rolling_resistance == 0.0


def test_where_only_the_couple_makes_the_paradox_the_model_has_no_answer() -> None:
    # κ p_σ = κ + ε sin θ (q − ρ) is negative with ρ, positive without
    hoop = hh.Hoop(eccentricity=0.9, inertia_ratio=0.2)
    plane = hh.Plane(mu=0.4, rolling_resistance=0.5)
    start = hh.Start(angle=0.5, vx=-4.0, omega=0.2)
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    s, c = math.sin(0.5), math.cos(0.5)
    with_couple = kappa_p_sigma(body, s, c, -1, resistance_arm(body, s, c, 0.2, -1))
    without = kappa_p_sigma(body._replace(resist=0.0), s, c, -1, resistance_arm(body._replace(resist=0.0), s, c, 0.2, -1))
    assert with_couple < 0.0 < without
    assert hh.simulate(hoop, plane, start, duration=1.0).status == "undetermined"
    assert hh.simulate(hoop, plane.model_copy(update={"rolling_resistance": 0.0}), start, duration=1.0).status == "completed"


def test_impacts_are_as_without() -> None:
    start = hh.Start(height=0.3, vx=1.0, omega=3.0, angle=0.5)
    plain, rough = (
        hh.simulate(hh.Hoop.ideal(0.6), hh.Plane(restitution=0.4, mu=0.3, rolling_resistance=f), start, duration=0.5).find(
            "impact"
        )[0]
        for f in (0.0, 0.3)
    )
    assert (plain.omega, plain.vx, plain.impulse_normal) == (rough.omega, rough.vx, rough.impulse_normal)
    assert rough.rolling_resistance == 0.0


def test_more_digits_say_the_same() -> None:
    for case, _ in CASES[6:8]:
        motion = simulate(case)
        precise = hh.simulate(motion.scenario, digits=20)
        found = compare(motion, precise)
        assert not found.difference, case.name
        assert found.least > 11.0, case.name
        assert abs(precise.energy["residual"]) < 1e-18
        assert float(precise.energy["rolling_resistance"]) == pytest.approx(motion.ledger.rolling_resistance, rel=1e-12)
