"""The checker refuses what is not so: each row changes one thing of a certificate that it accepts."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from decimal import Decimal
from functools import cache
from typing import Any

import pytest

import hophoop as hh
from hophoop.prove import check, prove
from hophoop.prove.checker import scenarios
from hophoop.vocabulary.parameters import RANGES
from prove_tools import BOUNCING, read_again

pytest.importorskip("flint")

Change = Callable[[Any], None]
NO_OTHER_APEX = "the flight has no other apex than is said"


def resisted(f: float, start: hh.Start, duration: float, **plane: float) -> hh.Scenario:
    hoop = hh.Hoop.ideal(0.0 if "mu" in plane else 0.75)
    return hh.Scenario(hoop=hoop, plane=hh.Plane(rolling_resistance=f, **plane), start=start, duration=duration)


MOTIONS = {
    "hop": (hh.Scenario(duration=2.0), 12, 4000),
    # slip with a turning point, rolling with one, a phase that the end of the time cuts
    "turning": (hh.Scenario(plane=hh.Plane(mu=0.1), start=hh.Start(vx=-1.0, omega=1.5, angle=2.0), duration=3.0), 12, 4000),
    "bouncing": (BOUNCING, 8, 4000),
    "limited": (BOUNCING, 8, 5),
    "limited by the scenario": (BOUNCING.with_values({"contact.max_events": 7}), 8, 4000),
    "resisted hop": (resisted(0.001, hh.Start.rolling(3.1), 1.5), 10, 4000),
    "rocking": (resisted(0.3, hh.Start.rolling(1.0), 4.0), 10, 4000),
    "sliding": (resisted(0.25, hh.Start(vx=3.0, omega=0.0), 9.0, mu=0.125), 10, 4000),
}
STATUS = {"limited": "event_limit", "limited by the scenario": "event_limit", "rocking": "at_rest", "sliding": "at_rest"}


@cache
def certificate(name: str) -> str:
    scenario, digits, most = MOTIONS[name]
    proof = prove(scenario, digits, max_events=most)
    assert proof.proved, proof.why
    return json.dumps(proof.certificate)


@pytest.mark.parametrize("name", MOTIONS)
def test_it_accepts_what_is_so(name):
    found = json.loads(certificate(name))
    verdict = check(found)
    assert verdict.accepted, verdict.why
    assert found["status"] == STATUS.get(name, "completed")
    assert found["scenario"]["plane"].get("rolling_resistance", 0.0) == MOTIONS[name][0].plane.rolling_resistance
    assert ("turn" in [one["kind"] for one in found["events"]]) == (name in ("turning", "rocking"))
    said = ["1e-12 of the time so far", f"{MOTIONS[name][1]} digits", f"for {found['max_events']} events at most"]
    assert all(any(one in line for line in verdict.conventions) for one in said)
    assert len(found["events"]) == verdict.events


# --- changes; a key of a path that is a dict stands for the first item with these entries


def at(holder: Any, key: Any) -> Any:
    return next(k for k, one in enumerate(holder) if key.items() <= one.items()) if isinstance(key, dict) else key


def with_holder(path: tuple[Any, ...], change: Callable[[Any, Any], None]) -> Change:
    def changing(found: Any) -> None:
        for key in path[:-1]:
            found = found[at(found, key)]
        change(found, at(found, path[-1]))

    return changing


def put(*path: Any) -> Change:
    return with_holder(path[:-1], lambda holder, key: holder.__setitem__(key, path[-1]))


def drop(*path: Any) -> Change:
    return with_holder(path, lambda holder, key: holder.__delitem__(key))


def shift(by: str, *path: Any) -> Change:
    def moved(value: Any) -> Any:
        return [moved(one) for one in value] if isinstance(value, list) else str(Decimal(value) + Decimal(by))

    return with_holder(path, lambda holder, key: holder.__setitem__(key, moved(holder[key])))


def grow(factor: float, *path: Any) -> Change:
    return with_holder(path, lambda holder, key: holder.__setitem__(key, holder[key] * factor))


def spoil(*path: Any) -> Change:
    """The second coefficient of a polynomial."""

    def spoilt(text: str) -> str:
        first, second, *rest = text.split()
        return " ".join([first, second[:-9] + ("z" * 9 if second[-9:] != "z" * 9 else "0" * 9), *rest])

    return with_holder(path, lambda holder, key: holder.__setitem__(key, spoilt(holder[key])))


def together(*changes: Change) -> Change:
    def changing(found: Any) -> None:
        for change in changes:
            change(found)

    return changing


def shift_links(found: Any) -> None:
    for phase in found["phases"]:
        for panel in phase.get("panels", []):
            if "link" in panel:
                shift("1e-4", "link", "bracket")(panel)


def early_rest(found: Any) -> None:
    """At the first turning point, where the couple does not hold it."""
    events = found["events"]
    turn = events[at(events, {"kind": "turn"})]
    found["events"] = [events[0], {**turn, "kind": "rest"}, {**turn, "kind": "end", "t": events[-1]["t"]}]
    found["phases"] = found["phases"][:1]


def pass_turn(found: Any) -> None:
    """A turning point that is passed as if there were no couple."""
    found["phases"][0]["panels"] += found["phases"].pop(1)["panels"]


def cut(events: int) -> Change:
    """As if the limit of events came then."""
    ends = (put(name, "event_limit") for name in ("status", "ending"))
    rest = drop("events", slice(events, None)), drop("phases", slice(max(0, events - 2), None))
    return together(*rest, *ends, put("sequence", "H"))


ROLL, SLIP, FLIGHT = ({"mode": mode} for mode in "RKH")
FRICTION = "scenario", "plane", "rolling_resistance"
CHANGES: list[tuple[str, Change, str]] = [
    *(("hop", change, "") for change in (
        shift("1e-11", "events", {"kind": "slip_start"}, "t", 0), shift("1e-10", "events", {"kind": "takeoff"}, "angle", 0),
        shift("-1e-9", "events", {"kind": "impact"}, "omega", 0), shift("1e-10", "events", {"kind": "stick"}, "x", 0),
        shift("1e-9", "events", {"kind": "end"}, "vx", 0), put("events", {"kind": "takeoff"}, "angle", 1, "1E-40"),
        put("events", {"kind": "slip_start"}, "to", "S"), drop("events", slice(2, 4)), drop("events", slice(4, None)),
        # the sequence says more than is shown
        together(drop("events", slice(4, None)), put("status", "event_limit")), drop("phases", 1),
        put("sequence", "RKRSH"), put("status", "at_rest"), put("bits", 31), put("schema", "hophoop-proof/0"),
        spoil("phases", SLIP, "panels", 0, "u"), spoil("phases", SLIP, "panels", 0, "t"),
        shift("0.001", "phases", ROLL, "angle"), shift("0.01", "phases", FLIGHT, "to"),
        shift("1.0", "phases", ROLL, "angle", 1),  # where the margin to the cone is negative already
        put("scenario", "plane", "mu", 1.0000001), put("scenario", "start", "speed", 3.1000001),
        put("scenario", "start", "speed", 2.8),  # across a border of classes
        # what the equations do not read, or cannot be
        put("scenario", "contact", "model", "compliant"), put("scenario", "plane", "painleve", "none"),
        put("scenario", "plane", "impact_law", "other"), put("scenario", "plane", "restitution", 1.5),
        put("scenario", "plane", "mu", -1.0), put("scenario", "plane", "wind", 1.0), put("scenario", "start", "vx", 1.0),
        put("scenario", "hoop", "load_fraction", True), put("scenario", "hoop", "eccentricity", 0.5),
    )),
    ("hop", together(drop("events", {"kind": "apex"}), put("phases", FLIGHT, "apex", None)), NO_OTHER_APEX),
    ("hop", put("energy", 3), "nothing but what is checked"),
    ("hop", put("events", 0, "energy", ["3", "0"]), "nothing but what is checked"),
    ("turning", shift_links, ""),
    *(("bouncing", put("closing", one), "bounces are closed at 1e-12")
      for one in ("0.3", "1e-11", "1e-13", "0", "-1", "nan", 0.3, None)),
    *(("bouncing", put("digits", one), "digits") for one in (9, 100, 201, -1, 8.0, "8", True)),
    *(("bouncing", cut(events), "limit of 4000 events") for events in (1, 4, 20)),
    ("bouncing", put("max_events", 5), "no more than 5 events"),
    ("bouncing", put("scenario", "contact", "max_events", 7), ""),
    ("limited", put("max_events", 6), ""),
    *(("resisted hop", change, "") for change in (
        grow(1.0000001, *FRICTION), put(*FRICTION, 0.0), put("phases", ROLL, "what", "ahead"),
        put("phases", ROLL, "what", "limit"), drop("phases", 0),
        spoil("phases", ROLL, "panels", 0, "u"), spoil("phases", ROLL, "panels", 0, "t"),
        shift("1e-4", "phases", ROLL, "panels", -1, "bracket"),
    )),
    *(("rocking", change, "") for change in (
        grow(1.0000001, *FRICTION), put(*FRICTION, 0.0), drop("events", {"kind": "rest"}), early_rest, pass_turn,
        shift("1e-3", "phases", 0, "panels", -1, "link", "bracket"),
    )),
    *(("sliding", change, "") for change in (
        put("phases", 0, "what", "limit"), drop("phases", 0, "slides"),
        grow(0.48, *FRICTION),  # less than μ does not keep it from turning
    )),
]  # fmt: skip


@pytest.mark.parametrize(("name", "change", "why"), CHANGES)
def test_it_refuses_what_is_not(name, change, why):
    found = json.loads(certificate(name))
    change(found)
    verdict = check(found)
    assert json.dumps(found) != certificate(name)
    assert not verdict.accepted
    assert verdict.why
    assert why in verdict.why
    assert not verdict.conventions


def test_it_refuses_what_it_cannot_read():
    for text in ("{}", '{"schema": "hophoop-proof/1"}', '{"schema": "hophoop-proof/1", "bits": 80, "events": 3}'):
        assert not check(json.loads(text)).accepted


# --- the apex of a flight


def test_an_apex_is_the_highest_top():
    """A hoop that turns fast in flight has many tops; a lower one is not the apex."""
    proof = prove(hh.Scenario(start=hh.Start(height=0.5, omega=60.0, vy=1.0), duration=0.3), 8)
    assert proof.proved
    found = read_again(proof.certificate)
    turn = 2 * math.pi / 60 * 9.81**0.5  # in units of √(R/g), as the brackets of a flight are
    for end, by in ((0, turn - 0.002), (1, turn + 0.002)):
        shift(str(by), "phases", FLIGHT, "apex", end)(found)
    assert check(found).why == NO_OTHER_APEX


@pytest.mark.parametrize(("omega", "apexes"), [(0.0, 0), (5.0, 1), (8.0, 1), (12.0, 0), (40.0, 0)])
def test_tops_that_are_equal_are_no_apex(omega, apexes):
    """Without gravity and with G at a constant height all tops are as high; a single one is the apex."""
    scenario = hh.Scenario(plane=hh.Plane(gravity=0.0), start=hh.Start(height=3.0, omega=omega), duration=1.0)
    proof = prove(scenario, 8)
    assert proof.proved
    assert sum(event.kind == "apex" for event in proof.events) == apexes


def test_the_ranges_are_those_of_a_scenario():
    for path, ends in scenarios.NUMBERS.items():
        if path in RANGES:
            allowed = RANGES[path]
            assert ends == (allowed.least, allowed.most, *allowed.also)
