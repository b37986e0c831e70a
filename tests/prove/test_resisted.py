"""Proofs with rolling resistance: against closed forms, many digits and the kernel."""

import math
from fractions import Fraction

import pytest

import hophoop as hh
from hophoop.prove import prove, thresholds

pytest.importorskip("flint")


def scenario(f, mu=1.0, gamma=0.75, start=None, duration=3.0, **plane):
    return hh.Scenario(
        hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu, rolling_resistance=f, **plane),
        start=start or hh.Start.rolling(3.1), duration=duration,
    )  # fmt: skip


# --- motions ---------------------------------------------------------------------------------------


def test_a_balanced_hoop_comes_to_rest():
    """v̇ = −f g/(1 + κ): after v² (1 + κ)/(2 f g), at v (1 + κ)/(f g)."""
    proof = prove(scenario(0.125, gamma=0.0, start=hh.Start.rolling(1.0), duration=9.0), 20)
    assert (proof.verdict, proof.sequence, proof.status) == ("proved", "R", "at_rest")
    rest = next(event for event in proof.events if event.kind == "rest")
    pull = Fraction(9.81) / 8
    assert rest.x.holds(1 / pull)
    assert rest.t.holds(2 / pull)
    assert rest.x.radius < Fraction(1, 10**19)


def test_a_hoop_slides_without_turning():
    """ε = 0 and f > μ: no moment turns it, and gravity and friction along the slope are all that is left."""
    start = hh.Start(vx=3.0, omega=0.0)
    proof = prove(scenario(0.25, mu=0.125, gamma=0.0, start=start, duration=9.0), 20)
    assert (proof.verdict, proof.sequence, proof.status) == ("proved", "KR", "at_rest")
    stick = next(event for event in proof.events if event.kind == "stick")
    assert stick.t.holds(24 / Fraction(9.81))
    assert stick.x.holds(36 / Fraction(9.81))


def test_slip_without_rotation_begins_and_goes_on():
    """On a slope steeper than μ a hoop at rest slides; that held for f = 0 and no friction too, and was undecided."""
    for f, mu in ((0.3, 0.1), (0.0, 0.0)):
        start = hh.Start(vx=0.0, omega=0.0)
        proof = prove(scenario(f, mu=mu, gamma=0.0, start=start, duration=2.0, slope=0.5), 12)
        assert (proof.verdict, proof.sequence) == ("proved", "K"), proof.why
        assert proof.events[-1].omega.middle == 0
        pull = 9.81 * (math.sin(0.5) - mu * math.cos(0.5))
        assert proof.events[-1].x.distance(2 * pull) < 1e-14


def test_rest_is_proved():
    """At the top and wherever the couple holds it; beside that it turns."""
    still = hh.Start(vx=0.0, omega=0.0, angle=0.0)
    assert prove(hh.Scenario(start=still, duration=1.0), 10).status == "at_rest"
    edge = math.asin(0.2 / 0.75)
    for angle, status in ((edge - 1e-9, "at_rest"), (edge + 1e-5, "completed")):
        proof = prove(scenario(0.2, start=hh.Start(vx=0.0, omega=0.0, angle=angle), duration=0.5), 10)
        assert (proof.verdict, proof.status) == ("proved", status), proof.why


def test_a_hoop_on_infinite_friction_turns_and_rests():
    proof = prove(scenario(0.2, mu=math.inf, start=hh.Start.rolling(0.5), duration=30.0), 10)
    assert (proof.verdict, proof.status) == ("proved", "at_rest"), proof.why
    assert "turn" in [event.kind for event in proof.events]


def test_thresholds_say_what_they_do_not_prove():
    """A hop at once from √(gR/γ): θ̈ = 0 at the top where N = 0."""
    found = thresholds(scenario(0.1), 20)
    assert [one.key for one in found] == ["immediate_hop_speed"]
    assert found[0].enclosure.distance(math.sqrt(9.81 / 0.75)) < 1e-15
