"""The checker refuses what is not so: each test changes one thing of a certificate that it accepts."""

from __future__ import annotations

import copy
import json
from decimal import Decimal

import pytest

import hophoop as hh
from hophoop.prove import check, prove

pytest.importorskip("flint")


@pytest.fixture(scope="module")
def hop():
    return json.loads(json.dumps(prove(hh.Scenario(duration=2.0), 12).certificate))


@pytest.fixture(scope="module")
def rocking():
    """Slip with a turning point, rolling with one, a phase that the end of the time cuts."""
    scenario = hh.Scenario(plane=hh.Plane(mu=0.1), start=hh.Start(vx=-1.0, omega=1.5, angle=2.0), duration=3.0)
    proof = prove(scenario, 12)
    assert "turn" in {event.kind for event in proof.events}
    return json.loads(json.dumps(proof.certificate))


def moved(text, by):
    return str(Decimal(text) + Decimal(by))


def event(kind):
    return lambda certificate: next(one for one in certificate["events"] if one["kind"] == kind)


def shift(kind, name, by):
    def change(certificate):
        one = event(kind)(certificate)
        one[name] = [moved(one[name][0], by), one[name][1]]

    return change


def narrow(certificate):
    one = event("takeoff")(certificate)
    one["angle"][1] = "1E-40"


def drop(certificate):
    del certificate["events"][2:4]


def rename(certificate):
    event("slip_start")(certificate)["to"] = "S"


def wrong_sequence(certificate):
    certificate["sequence"] = "RKRSH"


def other_friction(certificate):
    certificate["scenario"]["plane"]["mu"] = 1.0000001


def other_speed(certificate):
    certificate["scenario"]["start"]["speed"] = 3.1000001


def other_status(certificate):
    certificate["status"] = "at_rest"


def cut(certificate):
    certificate["events"] = certificate["events"][:4]


def cut_and_call_it_a_limit(certificate):
    del certificate["events"][4:]
    certificate["status"] = "event_limit"  # the sequence says more than is shown


def no_record(certificate):
    del certificate["phases"][1]


def slip_panel(certificate):
    return next(phase for phase in certificate["phases"] if phase["mode"] in "SK")["panels"][0]


def other_polynomial(certificate):
    panel = slip_panel(certificate)
    numbers = panel["u"].split()
    numbers[1] = numbers[1][:-8] + ("zzzzzzzz" if numbers[1][-8:] != "zzzzzzzz" else "00000000")
    panel["u"] = " ".join(numbers)


def other_times(certificate):
    panel = slip_panel(certificate)
    numbers = panel["t"].split()
    panel["t"] = " ".join([numbers[0], numbers[1][:-8] + "zzzzzzzz", *numbers[2:]])


def other_bracket(certificate):
    phase = next(phase for phase in certificate["phases"] if phase["mode"] == "R")
    phase["angle"] = [moved(end, "0.001") for end in phase["angle"]]


def late_bracket(certificate):
    """Where the margin to the cone is negative already."""
    phase = next(phase for phase in certificate["phases"] if phase["mode"] == "R")
    phase["angle"] = [phase["angle"][0], moved(phase["angle"][1], "1.0")]


def later_landing(certificate):
    phase = next(phase for phase in certificate["phases"] if phase["mode"] == "H")
    phase["to"] = [moved(end, "0.01") for end in phase["to"]]


def few_bits(certificate):
    certificate["bits"] = 31


def other_law(certificate):
    certificate["schema"] = "hophoop-proof/0"


CHANGES = [
    shift("slip_start", "t", "1e-11"), shift("takeoff", "angle", "1e-10"), shift("impact", "omega", "-1e-9"),
    shift("stick", "x", "1e-10"), shift("end", "vx", "1e-9"), narrow, drop, rename, wrong_sequence, other_friction,
    other_speed, other_status, cut, cut_and_call_it_a_limit, no_record, other_polynomial, other_times, other_bracket,
    late_bracket, later_landing, few_bits, other_law,
]  # fmt: skip


def test_it_accepts_what_is_so(hop, rocking):
    assert check(hop).accepted
    assert check(rocking).accepted


@pytest.mark.parametrize("change", CHANGES)
def test_it_refuses_what_is_not(hop, change):
    certificate = copy.deepcopy(hop)
    change(certificate)
    verdict = check(certificate)
    assert not verdict.accepted
    assert verdict.why


def test_it_refuses_a_turning_point_elsewhere(rocking):
    certificate = copy.deepcopy(rocking)
    for phase in certificate["phases"]:
        for panel in phase.get("panels", []):
            if "link" in panel:
                panel["link"]["bracket"] = [moved(end, "1e-4") for end in panel["link"]["bracket"]]
    if certificate != rocking:
        assert not check(certificate).accepted


def test_it_refuses_what_it_cannot_read():
    for text in ("{}", '{"schema": "hophoop-proof/1"}', '{"schema": "hophoop-proof/1", "bits": 80, "events": 3}'):
        assert not check(json.loads(text)).accepted


def test_a_motion_with_a_hop_is_no_motion_without(hop):
    """The certificate of a motion says nothing about its neighbour across a border of classes."""
    certificate = copy.deepcopy(hop)
    certificate["scenario"]["start"]["speed"] = 2.8
    assert not check(certificate).accepted
