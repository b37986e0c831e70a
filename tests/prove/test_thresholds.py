"""Thresholds: proved numbers against closed forms and the kernel."""

from decimal import Decimal, getcontext
from fractions import Fraction

import pytest

import hophoop as hh
from hophoop.prove import thresholds

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


@pytest.mark.slow
def test_the_border_of_the_hop():
    found = {one.key: one.enclosure for one in thresholds(hh.Scenario(), 20, ("first_hop_speed",))}
    kernel = float(hh.theory.first_hop_speed(hh.Hoop.ideal(0.75)))
    assert found["first_hop_speed"].distance(kernel) < 1e-14
    assert found["first_hop_speed"].radius < Fraction(1, 10**19)


def test_a_massless_hoop_is_refused():
    with pytest.raises(ValueError, match=r"mass in its ring"):
        thresholds(hh.Scenario(hoop=hh.Hoop.ideal(1.0)))
