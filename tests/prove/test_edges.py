"""Motions at whose edges a bound is easily missed: ends of the time, ties, roundings and roots at round places."""

import math
from fractions import Fraction

import pytest

import hophoop as hh
from hophoop.prove import prove

pytest.importorskip("flint")

from hophoop.precise.problem import Problem
from hophoop.prove import contact
from hophoop.prove.contact import Contact, Step, advance
from hophoop.prove.motion import Run
from hophoop.prove.numbers import Unclear, arb, ball, rational, raw, setting
from hophoop.prove.roots import bracket, first_root

BALANCED = hh.Hoop(load_fraction=0.0)


def run_of(scenario):
    """One motion at the present precision."""
    return Run(Problem.of(scenario), rational(Fraction(1, 10**14)), False, 100, lambda: None)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_flight_that_cannot_begin_is_not_proved(side):
    """In flight by its mode, with the free acceleration a little below zero, the rim enters the plane at once."""
    omega = math.sqrt(9.81 / (0.75 * math.cos(0.3)) * (1.0 + side * 3e-10))
    start = hh.Start(angle=-0.3, omega=omega, vx=omega + 1.0, slip=1.0, mode="H")
    proof = prove(hh.Scenario(start=start, duration=0.3), 18)
    assert proof.proved == (side > 0)
    assert proof.proved or "opens" in proof.why


@pytest.mark.parametrize("before", [2.0**-51, 2.0**-48])
def test_bounces_that_outlast_the_time_are_not_closed(before):
    """They would end after exactly 3 s, which is after the motion."""
    plane = hh.Plane(gravity=2.0, restitution=0.5)
    proof = prove(hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=plane, start=hh.Start(height=1.0), duration=3.0 - before), 10)
    assert not {"bounce_limit", "rest"} & {event.kind for event in proof.events}
    assert proof.status in ("", "completed")


@pytest.mark.parametrize("bits", [60, 128])
def test_a_rate_that_is_rounded_at_the_start_of_a_step_stays_in_its_ball(bits):
    """The θ̇ of a balanced hoop is constant."""
    with setting(bits):
        run = run_of(hh.Scenario(hoop=BALANCED, plane=hh.Plane(gravity=1.0), start=hh.Start.rolling(0.3), duration=1.0))
        begin = run.body.start()._replace(om=ball((arb(1) / 300).mid()))
        _, after = advance(run.body, 0, begin, 0, run.t_end, None)
        assert raw(after.om).contains(raw(begin.om))


@pytest.mark.parametrize("late", [1e-17, 1e-14])
def test_an_event_that_may_come_after_the_end_is_unclear(late):
    """Slip that ends half a unit after a start that is known to `late`, where the time is over after half a unit."""
    with setting(100):
        plane = hh.Plane(gravity=1.0, mu=0.5)
        run = run_of(hh.Scenario(hoop=BALANCED, plane=plane, start=hh.Start(vx=0.5), duration=0.5))
        begin = run.body.start()._replace(t=ball(arb(0, late)), vt=rational(Fraction(1, 2) - Fraction(5, 10**18)))
        with pytest.raises(Unclear, match="end of the time"):
            advance(run.body, 1, begin, 0, run.t_end, None)


@pytest.mark.parametrize("duration", [0.45, 0.5, 0.6, 3.0])
def test_the_apex_is_the_highest_point_up_to_the_landing(duration):
    """As in the kernel and in many digits, also where the time ends between two tops."""
    scenario = hh.Scenario(
        plane=hh.Plane(gravity=1.0), start=hh.Start(angle=-0.85, omega=20.0, vx=20.5, height=0.3, vy=1.0), duration=duration
    )
    kinds = [[event.kind for event in found.events] for found in (prove(scenario, 12), hh.simulate(scenario))]
    assert kinds[0][:3] == kinds[1][:3]


def test_a_margin_that_may_only_touch_zero_is_unclear(monkeypatch):
    with setting(100):
        run = run_of(hh.Scenario(start=hh.Start.rolling(3.1), duration=2.0))
        step = Step(Contact(run.body, 0, run.body.start(), 0, None), None, arb(0.5))
        place = (arb(0.25), arb(0.25) + arb(2) ** -80)
        monkeypatch.setattr(contact, "first_root", lambda model, begin, end: place if model is step.models[0] else None)
        for slope, found in ((arb(-1, 0.5), True), (arb(-1, 2), False)):
            monkeypatch.setattr(step, "taylor", lambda k, x, terms, slope=slope: [arb(0), slope])
            if found:
                assert step.first_event([0] * len(step.models), arb(1))[0] == 0
            else:
                with pytest.raises(Unclear, match="touch"):
                    step.first_event([0] * len(step.models), arb(1))


@pytest.mark.parametrize(("restitution", "duration"), [(0.0, 2.0), (0.0, 4.0), (0.5, 3.1)])
def test_landings_at_round_times_are_proved(restitution, duration):
    """The hoop falls for 1 s: at a place that halves an interval, or next to its end."""
    plane = hh.Plane(gravity=2.0, restitution=restitution)
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=plane, start=hh.Start(height=1.0), duration=duration)
    proof = prove(scenario, 10)
    assert proof.proved, proof.why
    assert next(event for event in proof.events if event.kind == "impact").t.holds(1)


@pytest.mark.parametrize("bits", [128, 256])
@pytest.mark.parametrize("root", [0.5, 0.25, 0.999999, 1e-9])
def test_a_root_is_found_wherever_it_is(root, bits):
    with setting(bits):

        def function(x, terms):
            return [1 - (x / root) ** 3, -3 * x * x / root**3][:terms]

        low, high = first_root(function, arb(0), arb(1))
        assert low <= root <= high
        assert high - low < 1e-20
        assert bracket(function, arb(root) / 4, arb(1))[0] <= root


def test_a_root_where_one_precision_divides_is_found_with_another():
    """(root − x)(3 − 8 x + 8 x²), whose slope has no certain sign on [0, 1]."""
    root = 0.5 - 1.0 / 128.0

    def function(x, terms):
        bowl = 3 - 8 * x + 8 * x * x
        return [(root - x) * bowl, (root - x) * (16 * x - 8) - bowl][:terms]

    with setting(128), pytest.raises(Unclear):
        first_root(function, arb(0), arb(1))
    with setting(256):
        low, high = first_root(function, arb(0), arb(1))
        assert low <= root <= high


def test_no_turn_is_counted_backwards():
    """A revolution that ends within rounding of the end of the time."""
    with setting(80):
        run = run_of(hh.Scenario(hoop=BALANCED, start=hh.Start.rolling(1.0), duration=1.0))
        begin = run.body.start()
        phase = Contact(run.body, 0, begin, 0, begin.th)
        after = begin._replace(t=ball(arb(1, 1e-10)), th=begin.th + 6.28)
        assert contact._whole_turn(phase, after, ball(1)).t < 1.5


# hops of 7·10⁻⁸ s, just above the speed from which there is one, and of 1.8·10⁻⁸ s, with a centripetal force just above g
SHORT_HOPS = {
    "threshold": hh.Scenario(start=hh.Start.rolling(2.9081602262491906), duration=1.7),
    "start": hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.5),
        plane=hh.Plane(mu=0.3, gravity=8.0),
        start=hh.Start(vx=2.0, omega=4.000000000000001),
        duration=5.0,
    ),
}


@pytest.mark.parametrize("name", sorted(SHORT_HOPS))
def test_a_very_short_hop_is_proved(name):
    found = prove(SHORT_HOPS[name])
    assert found.proved, found.why
    assert "H" in found.sequence


@pytest.mark.parametrize("above", [1e-6, 1e-8, 1e-10, 1e-12])
def test_a_very_short_slip_is_proved(above):
    """Just above the speed from which the hoop slips in its first turn, v_t stays small."""
    found = prove(hh.Scenario(start=hh.Start.rolling(2.0431739123746087 * (1 + above)), duration=1.2), 10)
    assert (found.verdict, found.sequence) == ("proved", "RKRSR"), found.why
