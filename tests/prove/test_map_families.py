"""What the checker of gaits and chaos computes: families of motions, and the entropy of coverings."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import pytest

import hophoop as hh
from hophoop.prove._flint import arb, precision, rational
from hophoop.prove.checker.equations import Equations, Refused
from hophoop.prove.checker.family import Family, middle
from hophoop.prove.checker.maps import BITS, MapCheck, _entropy
from hophoop.prove.checker.passages import Motions
from hophoop.prove.deadline import Deadline
from hophoop.prove.return_map import ReturnMap

flint = pytest.importorskip("flint")


def slope(degrees, gamma, **plane):
    plane = {"gravity": 1.0, "slope": math.radians(degrees)} | (plane if "mu_static" in plane else {"mu": 1.0} | plane)
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane))


# --- the families of motions ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("degrees", "gamma", "plane", "omega", "word"),
    [
        (0.5, 0.75, {}, 3.3143604633366742, "RSRKR"),
        (3.0, 0.5, {}, 2.77150688780492, "RSHKR"),
        (5.0, 0.25, {}, 3.03277936338688, "RSHR"),
        (4.0, 0.75, {}, 3.4, "RSRKR"),
        (5.0, 0.25, {"mu_static": 1.02, "mu_kinetic": 1.0}, 3.03, "RSHR"),
    ],
)
def test_motions_and_their_derivative_are_those_of_others(degrees, gamma, plane, omega, word):
    """θ̇ at the next passage by the kernel; its derivative by the prover, and by the kernel's differences."""
    scenario = slope(degrees, gamma, **plane)
    returns, wide = ReturnMap(scenario), 1e-6
    piece = returns.piece(omega - wide, omega + wide)
    found, image = MapCheck({"scenario": returns.scenario.to_dict()}, Deadline()).image(
        Fraction(omega - wide), Fraction(omega + wide), piece.phases
    )

    def kernel(place):
        start = hh.Start.rolling(place, angle=math.pi)
        return hh.passages(scenario.model_copy(update={"start": start}), 1)

    assert found == piece.word == kernel(omega).sequences[0] == word
    assert abs(float(image.at.mid()) - float(kernel(omega).omega[0])) < 1e-10
    step = 1e-5
    difference = (float(kernel(omega + step).omega[0]) - float(kernel(omega - step).omega[0])) / (2 * step)
    with precision(BITS):
        assert image.by.overlaps(piece.slope)
        assert image.by.rad() < 0.05
        assert image.by.overlaps(arb(difference, 1e-3))


@pytest.mark.parametrize(
    ("degrees", "gamma", "plane", "omega"),
    [
        (1.0, 0.75, {}, 3.408),
        (3.0, 0.5, {}, 2.7715),
        (5.0, 0.25, {"mu_static": 1.02, "mu_kinetic": 1.0}, 3.03),
        (3.0, 0.5, {"mu_static": 1.02, "mu_kinetic": 1.0, "gravity": 9.81}, 2.7715 * math.sqrt(9.81)),
    ],
)
def test_each_number_of_a_family_varies_as_its_derivative_says(degrees, gamma, plane, omega):
    """By the mean value theorem: the differences between both ends of a box, after each phase, which thin boxes have."""
    returns, wide = ReturnMap(slope(degrees, gamma, **plane)), 1e-6
    low, high = Fraction(omega - wide), Fraction(omega + wide)
    phases = returns.piece(float(low), float(high)).phases
    with precision(128):
        equations = Equations(returns.scenario.to_dict())
        whole, first, last = (Motions(equations, a, b, 32) for a, b in ((low, high), (low, low), (high, high)))
        varied = 0
        for phase in phases:
            for motions in (whole, first, last):
                motions.pass_phase(*phase)
            for name in ("th", "vt", "vn", "om"):
                number, *ends = (getattr(one.state, name) for one in (whole, first, last))
                if not isinstance(number, Family):
                    continue
                a, b = (middle(end) for end in ends)
                difference = (b - a) / (rational(high) - rational(low))
                assert number.over.contains(a)
                assert number.over.contains(b)
                assert number.by.contains(difference), (phase[:2], name)
                assert number.by.rad() < 0.1 * abs(difference).mid() + 1e-3
                varied += 1
            if whole.mode == "R":
                a, b = (middle(one.energy) for one in (first, last))
                assert whole.energy.by.contains((b - a) / (rational(high) - rational(low)))
        assert varied >= 8


@pytest.mark.parametrize(
    ("degrees", "gamma", "mu", "omega", "kinds", "said"),
    [
        (3.0, 0.5, 0.15, 2.0, ["slip_start", "stick", "slip_start", "stick"], "an event comes before the next passage"),
        (5.0, 0.25, 1.0, 3.6, ["slip_start", "takeoff", "impact"], "a landing comes before the next passage"),
        (5.0, 0.25, 1.0, 3.03, [], "rolling goes on to the next passage"),
    ],
)
def test_a_passage_is_not_passed_in_slip_or_in_flight(degrees, gamma, mu, omega, kinds, said):
    """Brackets of events as the kernel has them, up to rolling again; with none, of rolling all the way."""
    scenario = slope(degrees, gamma, mu=mu)
    motion = hh.simulate(scenario.model_copy(update={"start": hh.Start.rolling(omega, angle=math.pi)}))
    events = [event for event in motion.events if event.kind not in ("apex", "turn")][: len(kinds) + 1]
    assert [event.kind for event in events[1:]] == kinds
    phases = []
    for before, event in pairwise(events):
        ends = {"stick": "stop", "takeoff": "lift", "impact": "land", "slip_start": "ahead" if event.to_mode == "S" else "back"}
        place = event.t - before.t if event.kind == "impact" else event.angle
        phases.append([before.to_mode, ends[event.kind], place - 1e-6, place + 1e-6])
    phases.append(["R", "span", 9.4, 9.5])
    assert not kinds or events[-1].angle > 3 * math.pi
    place = Fraction(omega)
    with pytest.raises(Refused, match=said):
        MapCheck({"scenario": scenario.to_dict()}, Deadline()).image(place, place, phases)


# --- the entropy of coverings ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("coverings", "count", "growth"),
    [
        ([(0, 1), (1, 0), (1, 1)], 2, (1 + math.sqrt(5)) / 2),
        ([(0, 0), (0, 1), (1, 0), (1, 1)], 2, 2.0),
        ([(0, 1), (1, 2), (2, 0), (2, 1)], 3, 1.3247179572447460),
        ([(0, 0), (1, 1), (0, 1), (2, 3), (3, 2), (3, 3)], 4, (1 + math.sqrt(5)) / 2),
    ],
)
def test_the_entropy_is_that_of_the_largest_eigenvalue(coverings, count, growth):
    largest = Fraction(math.log(growth))
    _entropy(largest - Fraction(1, 10**9), set(coverings), count)
    with pytest.raises(Refused):
        _entropy(largest + Fraction(1, 10**9), set(coverings), count)


@pytest.mark.parametrize("coverings", [[(0, 1), (1, 0)], [(0, 0), (1, 1), (0, 1)], []])
def test_one_loop_has_no_entropy(coverings):
    with pytest.raises(Refused):
        _entropy(Fraction(1, 10**6), set(coverings), 2)
