"""Gaits and chaos: the return map against the kernel and against differences, and claims that do not hold."""

from __future__ import annotations

import math
from decimal import Decimal

import numpy as np
import pytest

import hophoop as hh
from hophoop.prove import prove_chaos, prove_gait
from hophoop.prove._flint import Undecided, precision
from hophoop.prove.enclosures.mean_value_form import parameter
from hophoop.prove.gaits import _covers, _entropy, _loops
from hophoop.prove.return_map import ReturnMap
from hophoop.scenario import InputError

flint = pytest.importorskip("flint")

CHAOS = [(3.2, 3.375), (3.43, 3.522)]


def slope(degrees, gamma, **plane):
    plane = {"mu": 1.0, "gravity": 1.0, "slope": math.radians(degrees)} | plane
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane))


def next_passage(scenario, omega):
    """θ̇ at the next passage, by the kernel."""
    start = hh.Start.rolling(omega * scenario.hoop.radius, angle=math.pi)
    found = hh.passages(scenario.model_copy(update={"start": start}), 1)
    return float(found.omega[0]), found.sequences[0]


MOTIONS = [
    (0.5, 0.75, 3.3143604633366742, "RSRKR"),
    (1.0, 0.75, 3.4081869457017134, "RSRKR"),
    (3.0, 0.5, 2.77150688780492, "RSHKR"),
    (5.0, 0.25, 3.03277936338688, "RSHR"),
    (4.0, 0.75, 3.4749691880849047, "RSHKR"),
]


@pytest.mark.parametrize(("degrees", "gamma", "omega", "word"), MOTIONS)
def test_values_are_those_of_the_kernel(degrees, gamma, omega, word):
    scenario = slope(degrees, gamma)
    found, value = ReturnMap(scenario).point(omega)
    expected, kernel_word = next_passage(scenario, omega)
    assert found == word == kernel_word
    assert float(value) == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize(("degrees", "gamma", "omega", "word"), MOTIONS)
def test_slopes_are_those_of_differences(degrees, gamma, omega, word):
    """Exact starts 2⁻⁶⁰ apart, at 256 bits, differ by the derivative that a narrow box has."""
    returns, wide = ReturnMap(slope(degrees, gamma)), 1e-9
    piece = returns.piece(omega - wide, omega + wide)
    with precision(256):
        step = flint.arb(2) ** -60
        ends = [returns._run(flint.arb(omega) + way * step).state.om for way in (-1, 1)]
        difference = (ends[1] - ends[0]) / (2 * step)
        assert piece.word == word
        assert piece.slope.overlaps(difference)
        assert piece.slope.rad() < 1e-4


def test_the_angle_at_the_next_passage_does_not_vary_over_a_box():
    with precision(80):
        run = ReturnMap(slope(5.0, 0.25))._run(parameter(3.03, 3.03125, 0, 1))
        assert (run.state.th - 3 * flint.arb.pi()).contains(0)
        assert getattr(run.state.th, "by", ()) == ()


@pytest.mark.parametrize(
    ("degrees", "gamma", "low", "high", "omega", "multiplier"),
    [
        (0.5, 0.75, 3.3141, 3.3146, 3.3143604633366742, 0.783248837804),
        (3.0, 0.5, 2.7714, 2.7716, 2.77150688780492, -0.768024),
        (5.0, 0.25, 3.02, 3.05, 3.03277936338688, 0.548110),
        pytest.param(1.0, 0.75, 3.408, 3.4084, 3.4081869457017134, 0.610983567588, marks=pytest.mark.slow),
    ],
)
def test_gaits(degrees, gamma, low, high, omega, multiplier):
    """Point and multiplier are those of the search by derivatives in doubles, and starts inside stay inside."""
    scenario, shares = slope(degrees, gamma), []
    found = prove_gait(scenario, low, high, progress=shares.append)
    assert found.proved
    assert not found.why
    assert len(shares) == found.boxes
    assert shares[-1] == pytest.approx(1.0)
    assert found.omega.distance(omega) < 1e-13
    assert found.omega.radius < Decimal("1e-17")
    assert found.multiplier.distance(multiplier) < 1e-6
    assert found.multiplier.radius < Decimal("1e-8")
    assert abs(found.contraction.middle) + found.contraction.radius < 1
    assert low < found.image.middle - found.image.radius
    assert found.image.middle + found.image.radius < high
    for start in np.linspace(low, high, 9):
        value, word = next_passage(scenario, float(start))
        assert found.image.distance(value) < 1e-11
        assert word in found.words


def test_units():
    """With another radius and gravity θ̇ changes as √(g/R) and the multiplier does not."""
    one = prove_gait(slope(5.0, 0.25), 3.03, 3.035)
    plane = hh.Plane(mu=1.0, gravity=9.81, slope=math.radians(5.0))
    scale = math.sqrt(9.81 / 0.3)
    other = prove_gait(hh.Scenario(hoop=hh.Hoop.ideal(0.25, radius=0.3), plane=plane), 3.03 * scale, 3.035 * scale)
    assert other.proved
    assert other.omega.distance(float(one.omega.middle) * scale) < 1e-12
    assert other.multiplier.distance(float(one.multiplier.middle)) < 1e-9


@pytest.mark.parametrize(
    ("degrees", "gamma", "low", "high", "why"),
    [
        (3.0, 0.5, 2.7716, 2.7718, "leads out of the interval"),  # the gait is just below
        (4.0, 0.75, 3.4749, 3.475, "the derivative of the return map is 1 or more"),  # its gait is unstable
        (10.0, 0.75, 3.4, 3.41, "for θ̇ = "),  # no gait at all
        (0.0, 0.75, 0.6, 0.61, "the hoop turns back"),  # too slow for the hilltop
    ],
)
def test_claims_that_do_not_hold(degrees, gamma, low, high, why):
    found = prove_gait(slope(degrees, gamma), low, high, seconds=30.0)
    assert not found.proved
    assert why in found.why
    assert found.omega is None


def test_an_unstable_gait_is_not_said_to_attract():
    """The interval holds a fixed point, and its ends move away from it."""
    scenario = slope(4.0, 0.75)
    ends = [next_passage(scenario, omega)[0] for omega in (3.4749, 3.475)]
    assert ends[0] > 3.475
    assert ends[1] < 3.4749
    assert not prove_gait(scenario, 3.4749, 3.475).proved


@pytest.mark.slow
def test_chaos_on_four_degrees():
    found = prove_chaos(slope(4.0, 0.75), CHAOS)
    assert found.proved
    assert found.coverings == ((0, 1), (1, 0), (1, 1))
    assert found.words == (("RSRKR",), ("RSHKR",))
    golden = math.log((1 + math.sqrt(5)) / 2)
    assert golden - 1e-5 < found.entropy < golden
    for ends, images in zip(CHAOS, found.images, strict=True):
        for omega, image in zip(ends, images, strict=True):
            assert image.distance(next_passage(slope(4.0, 0.75), omega)[0]) < 1e-11


@pytest.mark.parametrize(
    ("intervals", "coverings"),
    [
        ([(3.25, 3.375), (3.43, 3.522)], ((1, 1),)),  # 3.25 is taken into the second interval, not below it
        ([(3.2, 3.375), (3.43, 3.45)], ((0, 1),)),
    ],
)
def test_coverings_that_do_not_hold(intervals, coverings):
    found = prove_chaos(slope(4.0, 0.75), intervals)
    assert not found.proved
    assert found.entropy == 0
    assert "no two different loops" in found.why
    assert set(found.coverings) <= {(0, 1), (1, 0), (1, 1)}
    assert found.coverings != ((0, 1), (1, 0), (1, 1))


def test_an_interval_across_a_border_is_not_proved():
    """Near 3.4102 the hoop begins to hop."""
    scenario = slope(4.0, 0.75)
    assert [next_passage(scenario, omega)[1] for omega in (3.4101, 3.4104)] == ["RSRKR", "RSHSRKR"]
    with pytest.raises(Undecided, match=r"for θ̇ = 3\.410"):
        list(ReturnMap(scenario, 60.0).pieces(3.4101, 3.4104))


def test_coverings():
    with precision(64):
        ends = flint.arb(1), flint.arb(2)
        assert _covers(ends, (1.1, 1.9))
        assert _covers(ends[::-1], (1.1, 1.9))
        assert not _covers(ends, (1.0, 1.9))
        assert not _covers(ends, (0.9, 1.9))
        assert not _covers(ends, (1.1, 2.1))
        assert not _covers((flint.arb(1), flint.arb(2, 0.2)), (1.1, 1.9))


@pytest.mark.parametrize(
    ("coverings", "count", "expected"),
    [
        (((0, 1), (1, 0), (1, 1)), 2, (1 + math.sqrt(5)) / 2),
        (((0, 0), (0, 1), (1, 0), (1, 1)), 2, 2.0),
        (((0, 1), (1, 2), (2, 0), (2, 1)), 3, 1.3247179572447460),  # the real root of x³ = x + 1
        (((0, 1), (1, 0)), 2, None),  # one loop of two
        (((0, 0), (1, 1), (0, 1)), 2, None),  # two loops, and no way back
    ],
)
def test_loops_and_their_entropy(coverings, count, expected):
    loops = _loops(coverings, count)
    if expected is None:
        assert not loops
    else:
        assert len(loops) == 1
        assert math.log(expected) - 1e-5 < _entropy(coverings, loops[0]) <= math.log(expected)


def test_time_is_kept():
    found = prove_chaos(slope(4.0, 0.75), CHAOS, seconds=0.5)
    assert not found.proved
    assert found.why == "there was no time for it"


@pytest.mark.parametrize(
    ("call", "field"),
    [
        (lambda: prove_gait(slope(3.0, 0.5), 2.8, 2.7), "interval"),
        (lambda: prove_gait(slope(3.0, 0.5), -1.0, 2.7), "interval"),
        (lambda: prove_gait(slope(3.0, 0.5, gravity=0.0), 2.6, 2.7), "plane.gravity"),
        (lambda: prove_gait(slope(3.0, 0.5), 2.6, 2.7, seconds=0.0), "seconds"),
        (lambda: prove_chaos(slope(3.0, 0.5), [(2.6, 2.7)]), "intervals"),
        (lambda: prove_chaos(slope(3.0, 0.5), [(2.6, 2.7), (2.7, 2.8)]), "intervals"),
        (lambda: prove_chaos(slope(3.0, 0.5), [(2.6, 2.7), (2.9, 2.8)]), "intervals[1]"),
    ],
)
def test_input(call, field):
    with pytest.raises(InputError) as error:
        call()
    assert error.value.field == field


def test_compliant_contact():
    with pytest.raises(InputError, match="rigid"):
        prove_gait(slope(3.0, 0.5).model_copy(update={"contact": hh.Compliant()}), 2.6, 2.7)
