"""Certificates of gaits and chaos: what is so is accepted, what is not is refused, each in a clear sentence."""

from __future__ import annotations

import copy
import json
import math
import random
from decimal import Decimal
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.prove import check, prove_chaos, prove_gait
from hophoop.scenario import InputError

flint = pytest.importorskip("flint")

KEPT = Path(__file__).parent.parent / "data" / "proofs" / "maps"
CHAOS = [(3.2, 3.375), (3.43, 3.522)]
GAIT = 3.0327793633868812786, 0.548110306670  # θ̇ and multiplier, by 30 digits and their differences


def slope(degrees, gamma, **plane):
    plane = {"gravity": 1.0, "slope": math.radians(degrees)} | (plane if "mu_static" in plane else {"mu": 1.0} | plane)
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane))


def read_again(certificate):
    return json.loads(json.dumps(certificate))


@pytest.fixture(scope="module")
def gait():
    found = prove_gait(slope(5.0, 0.25), 3.02, 3.05, certify=True)
    assert found.proved
    return read_again(found.certificate)


@pytest.fixture(scope="module")
def chaos():
    return json.loads((KEPT / "chaos-4-degrees.json").read_text(encoding="utf-8"))


# --- what is so -----------------------------------------------------------------------------------


def test_a_gait_is_accepted(gait):
    verdict = check(gait)
    assert verdict.accepted
    assert verdict.events == 4 * (len(gait["boxes"]) + 1)  # of RSHR
    assert verdict.conventions[0] == "the return map takes all θ̇ from 3.02 to 3.05 rad/s into that interval"
    assert "so that one gait attracts all" in verdict.conventions[1]
    for number, (place, radius) in zip(GAIT, (gait["gait"]["omega"], gait["gait"]["multiplier"]), strict=True):
        assert abs(float(place) - number) < 1e-11
        assert 0 < float(radius) < 1e-11
    assert GAIT[1] < float(gait["contraction"]) < 1


@pytest.mark.long
def test_chaos_on_four_degrees_is_accepted(chaos):
    verdict = check(chaos)
    assert verdict.accepted
    assert verdict.conventions[-1] == "its topological entropy is 0.481211 a revolution at least"
    assert "it takes interval 0 over interval 1, counted from 0" in verdict.conventions
    assert chaos["intervals"] == [list(ends) for ends in CHAOS]
    assert sum(len(boxes) for boxes in chaos["boxes"]) < 200


@pytest.mark.slow
def test_chaos_on_four_degrees_is_certified(chaos):
    found = prove_chaos(slope(4.0, 0.75), CHAOS, certify=True)
    assert found.proved
    for name in ("intervals", "coverings", "entropy", "words", "claim", "schema"):
        assert read_again(found.certificate)[name] == chaos[name]


def test_without_certify_there_is_none(tmp_path):
    found = prove_gait(slope(5.0, 0.25), 3.03, 3.035)
    assert found.certificate is None
    with pytest.raises(InputError, match="There is no certificate to write: certify=True was not given"):
        found.save(tmp_path / "gait.json")


def test_a_certificate_is_saved(tmp_path):
    path = tmp_path / "gait.json"
    found = prove_gait(slope(5.0, 0.25), 3.03, 3.035, certify=True)
    found.save(path)
    assert check(json.loads(path.read_text(encoding="utf-8"))).accepted


def test_what_the_checker_does_not_cover_is_not_proved_with_a_certificate():
    scenario = slope(5.0, 0.25, rolling_resistance=0.001)
    assert prove_gait(scenario, 3.015, 3.045).proved
    found = prove_gait(scenario, 3.015, 3.045, certify=True)
    assert not found.proved
    assert found.certificate is None
    assert "there is no rolling resistance, which boxes do not cover" in found.why


# --- what is not ----------------------------------------------------------------------------------


def widen(certificate):
    certificate["interval"][0] = 3.019


def widen_above(certificate):
    certificate["interval"][1] = 3.051


def shift(certificate):
    certificate["interval"] = [3.025, 3.055]


def shift_with_boxes(*ends):
    """To where the gait is not."""

    def change(certificate):
        inside = [one for one in certificate["boxes"] if one["from"][0] < ends[1] and one["from"][1] > ends[0]]
        inside[0]["from"][0], inside[-1]["from"][1] = ends
        certificate["interval"], certificate["boxes"] = list(ends), inside

    return change


def overlap_boxes(certificate):
    certificate["boxes"][0]["from"][1] += 1e-9


def widen_a_box(certificate):
    """So wide that its motions are not all enclosed."""
    certificate["boxes"] = [certificate["boxes"][0] | {"from": [3.02, 3.05]}]


def remove_a_box(certificate):
    del certificate["boxes"][1]


def leave_a_gap(certificate):
    certificate["boxes"][0]["from"][1] -= 1e-12


def swap_the_word(certificate):
    certificate["words"] = ["RSHKR"]


def name_one_word_more(certificate):
    certificate["words"].append("R")


def swap_a_phase(certificate):
    certificate["boxes"][0]["phases"][1][0] = "K"


def leave_the_hop_out(certificate):
    for one in certificate["boxes"]:
        del one["phases"][1:3]


def end_slip_otherwise(certificate):
    certificate["boxes"][0]["phases"][1][1] = "stop"


def move_a_bracket(place):
    def change(certificate):
        one = certificate["boxes"][0]["phases"][place]
        one[2:] = [one[2] + 0.3, one[3] + 0.3]

    return change


def other_multiplier(middle):
    def change(certificate):
        certificate["gait"]["multiplier"] = [middle, "1e-12"]

    return change


def other_place(certificate):
    middle, radius = certificate["gait"]["omega"]
    certificate["gait"]["omega"] = [str(Decimal(middle) + 3 * Decimal(radius)), radius]


def place_outside(certificate):
    certificate["gait"]["omega"] = ["3.06", "1e-3"]


def less_contraction(certificate):
    certificate["contraction"] = "0.56"


def no_contraction(certificate):
    certificate["contraction"] = "1"


def other(section, name, value):
    def change(certificate):
        certificate["scenario"][section][name] = value

    return change


def other_format(certificate):
    certificate["schema"] = "hophoop-map-proof/2"


def other_claim(certificate):
    certificate["claim"] = "runaway"


def chaos_of_a_gait(certificate):
    certificate["claim"] = "chaos"


def state_more(certificate):
    certificate["entropy"] = "0.1"


GAIT_CHANGES = [
    (widen, "the boxes cover the interval from end to end"),
    (shift, "the boxes cover the interval from end to end"),
    (widen_above, "the boxes cover the interval from end to end"),
    (shift_with_boxes(3.04, 3.05), "the return map leads into the interval, for θ̇ = 3.04"),
    (shift_with_boxes(3.02, 3.03), "the return map leads into the interval, for θ̇ = 3.02"),
    (overlap_boxes, "each box begins where the one before it ends"),
    (widen_a_box, "for θ̇ = 3.02 to 3.05 rad/s"),
    (remove_a_box, "each box begins where the one before it ends"),
    (leave_a_gap, "each box begins where the one before it ends"),
    (swap_the_word, "the phases from an interval are those that are named, not RSHR"),
    (name_one_word_more, "the phases from an interval are those that are named"),
    (swap_a_phase, "phase 2 has the mode that is said, not S"),
    (leave_the_hop_out, "phase 2 has the mode that is said, not S"),
    (end_slip_otherwise, "slip ends (stop)"),
    (move_a_bracket(0), "rolling goes on up to its end (ahead)"),
    (move_a_bracket(1), "slip goes on"),
    (move_a_bracket(2), "the gap is positive in flight"),
    (other_multiplier("0.548110306680"), "the multiplier is where it is said to be"),
    (other_multiplier("0.548110306660"), "the multiplier is where it is said to be"),
    (other_place, "θ̇ of the gait is where it is said to be"),
    (place_outside, "θ̇ of the gait is in the interval"),
    (less_contraction, "the slope of the return map is 0.56 or less in size"),
    (no_contraction, "the slope of the return map is below 1 in size"),
    (other("plane", "slope", math.radians(5.0) + 1e-5), ", for θ̇ = "),
    (other("plane", "slope", math.radians(5.0) + 1e-12), "where it is said to be"),
    (other("hoop", "load_fraction", 0.2500001), ", for θ̇ = "),
    (other("hoop", "load_fraction", 0.25 + 1e-12), "where it is said to be"),
    (other("plane", "mu", 1.0 + 1e-12), "where it is said to be"),
    (other("plane", "gravity", 1.0 + 1e-12), "where it is said to be"),
    (other("plane", "restitution", 0.5), "there is no restitution"),
    (other("plane", "gravity", 0.0), "there is gravity"),
    (other("plane", "rolling_resistance", 0.001), "there is no rolling resistance"),
    (other("plane", "mu", "inf"), "the friction is finite"),
    (other("plane", "wind", 1.0), "every entry of the plane is one that the equations have"),
    (other("contact", "model", "compliant"), "contact.model is one that the equations have"),
    (other_format, "the format is hophoop-proof/1 or hophoop-map-proof/1"),
    (other_claim, "the claim is gait or chaos"),
    (chaos_of_a_gait, "the certificate states nothing but what is checked"),
    (state_more, "the certificate states nothing but what is checked"),
]


@pytest.mark.parametrize(("change", "said"), GAIT_CHANGES)
def test_a_gait_that_is_not_so_is_refused(gait, change, said):
    certificate = copy.deepcopy(gait)
    change(certificate)
    verdict = check(certificate)
    assert not verdict.accepted
    assert said in verdict.why
    assert not verdict.conventions


@pytest.mark.parametrize(("away", "accepted"), [(-1.2, False), (-0.8, True), (0.8, True), (1.2, False)])
def test_a_wider_enclosure_holds_the_gait_or_does_not(gait, away, accepted):
    certificate = copy.deepcopy(gait)
    certificate["gait"] |= {"omega": [repr(GAIT[0] + away * 1e-6), "1e-6"], "multiplier": ["0.548", "0.01"]}
    for one in certificate["gait"]["phases"]:
        one[2:] = [one[2] - 1e-4, one[3] + 1e-4]
    verdict = check(certificate)
    assert verdict.accepted == accepted
    assert accepted or verdict.why == "θ̇ of the gait is where it is said to be"


def overlap(certificate):
    certificate["intervals"][0][1] = 3.44


def remove_one_of_many(certificate):
    del certificate["boxes"][0][20]


def higher_entropy(certificate):
    certificate["entropy"] = "0.481212"  # ln((1 + √5)/2) = 0.4812118…


def no_entropy(certificate):
    certificate["entropy"] = "0"


def one_covering_more(certificate):
    certificate["coverings"].append([0, 0])
    certificate["entropy"] = "0.69"


def covering_of_none(certificate):
    certificate["coverings"][0] = [0, 2]


def swap_words(certificate):
    certificate["words"] = certificate["words"][::-1]


def swap_intervals(certificate):
    """The coverings are then those of the other one."""
    for name in ("intervals", "boxes", "words"):
        certificate[name] = certificate[name][::-1]


def shorten(index, low, high):
    """An interval, so much that the image of one end is no longer beyond the other interval."""

    def change(certificate):
        boxes = [one for one in certificate["boxes"][index] if low <= one["from"][0] and one["from"][1] <= high]
        certificate["boxes"][index] = boxes
        certificate["intervals"][index] = [boxes[0]["from"][0], boxes[-1]["from"][1]]

    return change


CHAOS_CHANGES = [
    (overlap, "no interval meets another"),
    (remove_one_of_many, "each box begins where the one before it ends"),
    (higher_entropy, "the coverings have the entropy that is said"),
    (no_entropy, "the entropy is above 0"),
    (one_covering_more, "interval 0 is taken over interval 0"),
    (covering_of_none, "coverings name intervals by their numbers, from 0"),
    (swap_words, "are those that are named, not RSRKR"),
    (swap_intervals, "interval 1 is taken over interval 1"),
    (shorten(0, 3.22, 3.375), "interval 0 is taken over interval 1"),
    (shorten(0, 3.2, 3.355), "interval 0 is taken over interval 1"),
    (shorten(1, 3.467, 3.522), "interval 1 is taken over interval 1"),
    (shorten(1, 3.43, 3.5165), "interval 1 is taken over interval 0"),
    (other("plane", "slope", math.radians(4.01)), ""),
    (other("hoop", "load_fraction", 0.74), ""),
]


@pytest.mark.parametrize(("change", "said"), CHAOS_CHANGES)
def test_chaos_that_is_not_so_is_refused(chaos, change, said):
    certificate = copy.deepcopy(chaos)
    change(certificate)
    verdict = check(certificate)
    assert not verdict.accepted
    assert said in verdict.why


@pytest.mark.parametrize("text", ["{}", '{"schema": "hophoop-map-proof/1"}', '{"schema": "hophoop-map-proof/1", "claim": 3}'])
def test_what_cannot_be_read_is_refused(text):
    assert not check(json.loads(text)).accepted


def leaves(value, path=()):
    if isinstance(value, dict | list) and value:
        pairs = value.items() if isinstance(value, dict) else enumerate(value)
        return [found for key, one in pairs for found in leaves(one, (*path, key))]
    return [path]


def another(value, dice):
    if isinstance(value, bool) or value is None:
        return 1
    if isinstance(value, float):
        return dice.choice([value * (1 + 10 ** dice.uniform(-15, 0)), value / 2, -value, value + 1e-9, math.nan, math.inf])
    if isinstance(value, int):
        return value + dice.choice([-1, 1])
    try:
        return str(Decimal(value) + Decimal(dice.choice([-1, 1])).scaleb(dice.randint(-22, 0)))
    except ArithmeticError:
        return dice.choice(["R", "S", "K", "H", "stop", "lift", "land", "span", "newton", "impact", ""])


def is_true(certificate, gait):
    """Whether a certificate says of the same gait what holds, however it was changed."""
    other = {"mass", "impact_law", "painleve"}  # which do not matter where e = 0 and no paradox is met
    parts = [{name: value for name, value in one["scenario"][part].items() if name not in other} for one in (certificate, gait)
             for part in ("hoop", "plane")]  # fmt: skip
    same = parts[:2] == parts[2:]
    true = []
    for name, number in zip(("omega", "multiplier"), GAIT, strict=True):
        middle, radius = map(float, certificate["gait"][name])
        true.append(abs(middle - number) <= radius + 1e-11)
    within = 3.02 <= certificate["interval"][0] < certificate["interval"][1] <= 3.05
    return same and within and all(true) and 0.55 < float(certificate["contraction"]) < 1


def untrue(gait, count, seed):
    dice, found = random.Random(seed), []
    paths = [path for path in leaves(gait) if path[0] not in ("version", "schema")]
    for _ in range(count):
        certificate = copy.deepcopy(gait)
        path = dice.choice(paths)
        holder = certificate
        for key in path[:-1]:
            holder = holder[key]
        holder[path[-1]] = another(holder[path[-1]], dice)
        if check(certificate).accepted and not is_true(certificate, gait):
            found.append(path)
    return found


def test_no_change_at_random_that_is_not_true_passes(gait):
    assert untrue(gait, 60, 4) == []


@pytest.mark.slow
def test_none_of_a_thousand_changes_that_is_not_true_passes(gait):
    assert untrue(gait, 1000, 5) == []
