"""Rolling resistance: motions against an independent integrator, and what must hold for all of them."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import hophoop as hh
from hophoop.kernel.physics.contact import kappa_p_sigma, most_resistance, resistance_arm
from hophoop.precise.agreement import compare
from oracle_program import essential, highest_apexes, program_events, simulate
from oracles import hybrid
from oracles.cases import JAM, Case, rolling

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


@st.composite
def resisted(draw: st.DrawFn) -> hh.Scenario:
    """Random hoops, planes and starts with rolling resistance."""
    eps = draw(st.floats(0.0, 0.9))
    kap = draw(st.floats(0.1, 1.0))
    most = min(1.0, 0.9 * most_resistance(eps, kap))
    plane = hh.Plane(
        mu=draw(st.sampled_from([0.0, 0.1, 0.4, 1.0, 3.0, math.inf])),
        slope=draw(st.sampled_from([0.0, 0.0, -0.3, 0.1])),
        restitution=draw(st.sampled_from([0.0, 0.0, 0.5])),
        rolling_resistance=draw(st.sampled_from([1e-6, 1e-3, 0.02, 0.3, 1.0])) * most,
    )
    if draw(st.booleans()):
        start = hh.Start.rolling(draw(st.floats(-5.0, 5.0)), angle=draw(st.floats(-3.0, 3.0)))
    else:
        start = hh.Start(
            height=draw(st.sampled_from([0.0, 0.2])), angle=draw(st.floats(-3.0, 3.0)),
            vx=draw(st.floats(-4.0, 4.0)), omega=draw(st.floats(-7.0, 7.0)),
        )  # fmt: skip
    hoop = hh.Hoop(eccentricity=eps, inertia_ratio=kap)
    return hh.Scenario(hoop=hoop, plane=plane, start=start, duration=2.0, contact=hh.Rigid(max_events=300))


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(scenario=resisted())
def test_the_ledger_closes_and_the_couple_opposes_the_rotation(scenario: hh.Scenario) -> None:
    motion = hh.simulate(scenario)
    ledger = motion.ledger
    assert abs(ledger.residual) <= 1e-10 * ledger.range
    sample = motion.at(motion.times(200))
    assert np.all(np.diff(sample.rolling_resistance) >= -1e-12 * ledger.range)
    touching = sample.mode != "H"
    assert np.all(sample.normal_force[touching] >= -1e-9 * 9.81)
    mu = scenario.plane.mu_static
    if math.isfinite(mu):
        assert np.all(np.abs(sample.friction_force) <= mu * sample.normal_force * (1.0 + 1e-9) + 1e-9)
    if motion.status == "at_rest":
        rest = motion.events[-2]
        need = scenario.hoop.eccentricity * math.sin(rest.angle + scenario.plane.slope) + math.sin(scenario.plane.slope)
        assert abs(need) <= scenario.plane.rolling_resistance * math.cos(scenario.plane.slope) + 1e-9


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(scenario=resisted(), factor=st.sampled_from([0.01, 3.0]))
def test_mirror_and_units(scenario: hh.Scenario, factor: float) -> None:
    motion = hh.simulate(scenario)
    if motion.status == "event_limit" or scenario.plane.mu_kinetic == 0.0:
        return
    state = scenario.start.state(scenario.hoop)
    turned = scenario.with_values({"plane.slope": -scenario.plane.slope})
    start = hh.Start(x=-state.x, height=state.height, angle=-state.angle, vx=-state.vx, vy=state.vy, omega=-state.omega)
    if state.slip == 0.0 and state.height == 0.0:
        start = hh.Start.rolling(-state.vx, angle=-state.angle)
    mirrored = hh.simulate(turned.model_copy(update={"start": start.to_dict()}))
    assert mirrored.sequence == motion.sequence.translate(str.maketrans("SK", "KS"))
    assert mirrored.ledger.rolling_resistance == pytest.approx(motion.ledger.rolling_resistance, rel=1e-8, abs=1e-9)
    # lengths times a factor, times the root of it
    second = math.sqrt(factor)
    start = hh.Start(
        height=state.height * factor, angle=state.angle, vx=state.vx * second, vy=state.vy * second, omega=state.omega / second
    )
    if state.slip == 0.0 and state.height == 0.0:
        start = hh.Start.rolling(state.vx * second, angle=state.angle)
    hoop = hh.Hoop(radius=factor, mass=2.0, eccentricity=scenario.hoop.eccentricity, inertia_ratio=scenario.hoop.inertia_ratio)
    other = hh.simulate(
        hh.Scenario(hoop=hoop, plane=scenario.plane, start=start, duration=2.0 * second, contact=scenario.contact)
    )
    assert other.sequence == motion.sequence
    assert other.ledger.rolling_resistance == pytest.approx(2.0 * factor * motion.ledger.rolling_resistance, rel=1e-8, abs=1e-9)


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


def test_steep_rest_slides_without_turning() -> None:
    # held against turning, but not against sliding: μ < tan β, and the couple of friction is within reach
    hoop, plane = hh.Hoop(eccentricity=0.1, inertia_ratio=0.9), hh.Plane(slope=0.3, mu=0.1, rolling_resistance=0.9)
    motion = hh.simulate(hoop, plane, hh.Start(), duration=1.0)
    assert motion.sequence == "K"
    rate = 9.81 * (math.sin(0.3) - 0.1 * math.cos(0.3))
    assert motion.at(1.0).vx == pytest.approx(rate, rel=1e-14)
    assert motion.at(1.0).omega == 0.0


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


def test_an_undetermined_start_stays_in_its_mode() -> None:
    """The end said that it rolls, while it slips at 1.4 m/s."""
    hoop, plane = hh.Hoop(eccentricity=0.15, inertia_ratio=0.0045), hh.Plane(mu=0.21, rolling_resistance=1.0)
    motion = hh.simulate(hoop, plane, hh.Start(vx=2.4, omega=1.0, angle=-213.57), duration=1.0)
    assert motion.status == "undetermined"
    assert motion.events[-1].slip > 1.0
    assert [event.to_mode for event in motion.events] == ["K", "K"]
    assert motion.sequence == motion.at(0.0).mode == "K"
    assert hh.simulate(motion.scenario, digits=20).sequence == "K"


@pytest.mark.parametrize("f", [0.0, 0.05])
def test_slip_without_friction_reverses_where_the_hoop_turns(f: float) -> None:
    """The turn changed the mode with rolling resistance, and the sequence was SSSS."""
    motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=0.0, rolling_resistance=f), hh.Start(angle=2.0), duration=4.0)
    times = [event.t for event in motion.events]
    modes = [motion.at(0.5 * (a + b)).mode for a, b in pairwise(times) if b - a > 1e-9]
    assert motion.sequence == "".join(modes) == "SKSKS"[: len(modes)]
    for event in motion.events:
        assert event.kind != "turn" or event.from_mode == event.to_mode
        assert event.kind != "slip_reversal" or event.slip == 0.0
    assert hh.simulate(motion.scenario, digits=20).sequence == motion.sequence


def test_slip_that_ends_where_the_hoop_turns_is_rolling() -> None:
    """Both come at once beside μ = 0; the turn led into rolling, and the sequence was S."""
    hoop = hh.Hoop(eccentricity=0.0, inertia_ratio=1.0, radius=1e-6, mass=1e-12)
    plane = hh.Plane(gravity=41889.74986649628, mu=5e-324, rolling_resistance=0.026536075109437098)
    motion = hh.simulate(hoop, plane, hh.Start(vx=-1.2e-233, omega=1.0), duration=6.1e-4)
    assert motion.status == "at_rest"
    for event in motion.events:
        assert event.kind != "turn" or event.from_mode == event.to_mode


def test_a_rotation_below_all_doubles_is_none_after_an_impact() -> None:
    """Its square is 0, and the couple that it has would only slow it down; friction drove the hoop up to 5e-6 m/s."""
    hoop, plane = hh.Hoop.ideal(0.0), hh.Plane(mu_static=0.0013, mu_kinetic=0.001, rolling_resistance=0.004)
    motion = hh.simulate(hoop, plane, hh.Start(vy=-1e-197, omega=1e-222), duration=1.0)
    assert motion.status == "at_rest"
    assert motion.sequence == "R"
    assert motion.events[-1].vx == 0.0


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
    for case, _ in CASES[5:8]:
        motion = simulate(case)
        precise = hh.simulate(motion.scenario, digits=20)
        found = compare(motion, precise)
        assert not found.difference, case.name
        assert found.least > 11.0, case.name
        assert abs(precise.energy["residual"]) < 1e-18
        assert float(precise.energy["rolling_resistance"]) == pytest.approx(motion.ledger.rolling_resistance, rel=1e-12)


def test_a_jam_with_resistance_agrees_with_more_digits() -> None:
    motion = hh.simulate(simulate(JAM).scenario.with_values({"plane.rolling_resistance": 1e-3}))
    precise = hh.simulate(motion.scenario, digits=20)
    assert not compare(motion, precise).difference
    assert float(precise.energy["rolling_resistance"]) == pytest.approx(motion.ledger.rolling_resistance, rel=1e-6)


def test_refusals() -> None:
    with pytest.raises(ValueError, match=r"plane.rolling_resistance = 0.1 must be 0 for the massless hoop"):
        hh.Scenario(hoop=hh.Hoop.ideal(1.0), plane=hh.Plane(rolling_resistance=0.1))
    with pytest.raises(ValueError, match=r"plane.rolling_resistance = 0.5 must be below 0.284985 for this hoop"):
        hh.Scenario(hoop=hh.Hoop.ideal(0.99), plane=hh.Plane(rolling_resistance=0.5))


def test_files_and_links_keep_it(tmp_path: Path) -> None:
    scenario = hh.Scenario(plane=hh.Plane(rolling_resistance=0.01))
    assert hh.Scenario.from_query(scenario.to_query()) == scenario
    scenario.save(tmp_path / "hop.toml")
    assert hh.Scenario.load(tmp_path / "hop.toml") == scenario
    assert "rolling_resistance" not in hh.Scenario().to_toml()


@pytest.mark.parametrize(("gamma", "resistance", "slope", "offset"), [(0.75, 0.02, 0.0, 1e-6), (0.6, 0.05, 0.1, 1e-9)])
def test_beside_the_edge_of_where_it_can_rest_the_solver_keeps_its_digits(gamma, resistance, slope, offset) -> None:
    """Pushed over the edge, let go beyond it, and swinging; the start has no more digits than its angle, beside the offset."""
    hoop, plane = hh.Hoop.ideal(gamma), hh.Plane(mu=20.0, rolling_resistance=resistance, gravity=1.0, slope=slope)
    rise = math.asin((resistance * math.cos(slope) - math.sin(slope)) / gamma)
    hilltop, valley = rise - slope, math.pi - rise - slope
    digits = 4.0 * math.ulp(hilltop) / offset
    for start in (hh.Start.rolling(offset, angle=hilltop), hh.Start(angle=hilltop + offset), hh.Start(angle=valley - offset)):
        motion = hh.simulate(hoop, plane, start, duration=40.0)
        exact = hh.simulate(hoop, plane, start, duration=40.0, digits=25)
        for event, true in zip(motion.events, exact.events, strict=True):
            assert event.kind == true.kind
            for name in ("t", "angle", "omega"):
                assert getattr(event, name) == pytest.approx(float(getattr(true, name)), rel=digits, abs=digits)
