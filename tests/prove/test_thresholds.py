"""Thresholds, statements and boxes: proved numbers against closed forms, the kernel and each other."""

from __future__ import annotations

from decimal import Decimal, getcontext
from fractions import Fraction

import pytest

import hophoop as hh
from hophoop.prove import prove_box, prove_map, statements, thresholds
from hophoop.prove._flint import precision
from hophoop.prove.statements import _energies

pytest.importorskip("flint")


@pytest.fixture(scope="module")
def numbers():
    """Without the border of the hop, which takes many motions."""
    keys = ("first_slip_speed", "immediate_hop_speed", "painleve_friction", "needed_friction")
    found = thresholds(hh.Scenario(start=hh.Start.rolling(1.0)), 30, keys)
    assert [one.key for one in found] == list(keys)
    return {one.key: one.enclosure for one in found}


def test_closed_forms_lie_in_their_enclosures(numbers):
    """√(gR/γ), and √(1 − γ²)/γ for Painlevé's paradox of an ideal hoop, in decimal arithmetic."""
    getcontext().prec = 60
    hop = (Decimal.from_float(9.81) / Decimal("0.75")).sqrt()
    painleve = Decimal("0.4375").sqrt() / Decimal("0.75")
    assert numbers["immediate_hop_speed"].holds(hop)
    assert numbers["painleve_friction"].holds(painleve)
    assert numbers["painleve_friction"].radius < Fraction(1, 10**29)


def test_the_kernel_agrees(numbers):
    for key, value in (
        ("first_slip_speed", hh.theory.first_slip_speed(hh.Hoop.ideal(0.75))),
        ("needed_friction", hh.theory.needed_friction(hh.Hoop.ideal(0.75), 1.0).mu),
    ):
        assert numbers[key].distance(float(value)) < 4e-15
        assert numbers[key].radius < Fraction(1, 10**28)


def test_motions_beside_the_first_slip(numbers):
    """A proved motion on each side of a proved threshold."""
    speed = float(numbers["first_slip_speed"].middle)
    found = [
        hh.prove.prove(hh.Scenario(start=hh.Start.rolling(speed * (1 + way * 1e-3))), 3, until="revolution").sequence
        for way in (-1, 1)
    ]
    assert found[0] == "R"
    assert found[1] != "R"


@pytest.mark.slow
def test_the_border_of_the_hop():
    found = {one.key: one.enclosure for one in thresholds(hh.Scenario(), 20, ("first_hop_speed",))}
    kernel = float(hh.theory.first_hop_speed(hh.Hoop.ideal(0.75)))
    assert found["first_hop_speed"].distance(kernel) < 1e-14
    assert found["first_hop_speed"].radius < Fraction(1, 10**19)


@pytest.mark.slow
def test_the_article():
    found = statements()
    assert [one.key for one in found if not one.proved] == []
    assert len({one.key for one in found}) == 16


def test_energies_of_proved_events_are_those_of_the_kernel():
    """Balls of some digits about what the kernel's ledger says at the same events."""
    scenario = hh.Scenario(duration=2.0)
    motion = hh.simulate(scenario)
    with precision(100):
        for event, computed in zip(hh.prove.prove(scenario, 12).events, motion.events, strict=True):
            sample = motion.at(computed.t)
            for ball, value in zip(_energies(event), (sample.kinetic, sample.potential), strict=True):
                assert abs(float(ball.mid()) - value) < 1e-9
                assert float(ball.rad()) < 1e-8


def test_boxes():
    rolls = prove_box(hh.Scenario(), {"plane.mu": (1.2, 1.3), "start.speed": (1.1, 1.2)})
    hops = prove_box(hh.Scenario(), {"plane.mu": (1.25, 1.3), "start.speed": (3.7, 3.8)})
    slips = prove_box(hh.Scenario(), {"plane.mu": (1.12995, 1.13005), "start.speed": (3.26985, 3.27015)})
    assert [(box.sequence, box.ending) for box in (rolls, hops, slips)] == [
        ("R", "revolutions"), ("H", "takeoff"), ("RKRSH", "takeoff"),
    ]  # fmt: skip
    across = prove_box(hh.Scenario(), {"start.speed": (2.0, 2.1)})  # the first slip is at 2.0432 m/s
    assert not across.proved


def test_a_map_covers_its_window_and_agrees_with_the_kernel():
    window = {"plane.mu": (0.8, 1.4), "start.speed": (0.5, 1.7)}
    found = prove_map(hh.Scenario(), window, depth=3)
    assert sum(map(found.area, found.cells)) == pytest.approx(0.6 * 1.2)
    assert found.share() == pytest.approx(found.share("R"))
    assert found.share() > 0.5
    for cell in found.cells:
        if cell.proved:
            middle = {path: 0.5 * (low + high) for path, (low, high) in cell.ranges.items()}
            motion = hh.simulate(hh.Scenario(duration=0.5).with_values(middle))
            assert motion.sequence == "R"


def test_bad_boxes_are_refused():
    for ranges, word in (({}, "at least one"), ({"hoop.mass": (1, 2)}, "hoop.mass"), ({"plane.mu": (2, 1)}, "least")):
        with pytest.raises(ValueError, match=word):
            prove_box(hh.Scenario(), ranges)
    with pytest.raises(ValueError, match="depth"):
        prove_map(hh.Scenario(), {"plane.mu": (1, 2)}, depth=-1)
    with pytest.raises(ValueError, match=r"mass in its ring"):
        thresholds(hh.Scenario(hoop=hh.Hoop.ideal(1.0)))
