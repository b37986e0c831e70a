"""Certificates changed at random: what the checker still accepts must be true of the scenario that it then names.

What decides is the tests' oracle: it integrates the scenario of an accepted change in time, in mpmath, to more digits.
"""

from __future__ import annotations

import copy
import json
import math
import random
from collections.abc import Callable, Sequence
from dataclasses import replace
from decimal import Decimal
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.prove import check, prove
from oracle_program import highest_apexes
from oracles.cases import Case
from oracles.precise import solve
from prove_tools import BOUNCING, NUMBERS, read_again

pytest.importorskip("flint")

KEPT = Path(__file__).parent.parent / "data" / "proofs"
NAMES = ("H-takeoff", "R-revolutions", "RKRSH-takeoff", "RKRSR-reversal", "RSKSR-revolutions", "RSRKRSRKR-revolutions")
STATED = ("schema", "until", "closing", "digits", "max_events", "sequence", "status", "ending", "events", "scenario")
SHORTEST = 12  # digits, so that bounces are closed where they are
FASTEST = 50  # of the rates of all numbers, in SI units
WORDS = (
    "completed", "at_rest", "event_limit", "undetermined", "duration", "revolution", "revolutions", "takeoff", "reversal",
    "R", "S", "K", "H", "start", "slip_start", "stick", "impact", "bounce_limit", "apex", "turn", "end", "limit", "span",
    "stop", "lift", "back", "ahead", "newton", "poisson", "stronge", "flight",
)  # fmt: skip
Certificate = dict[str, Any]


PROVED = {"hop": (hh.Scenario(duration=2.0), 12, 4000), "bounces": (BOUNCING, 8, 4000), "limited": (BOUNCING, 8, 5)}
QUICK = ("H-takeoff", "RKRSH-takeoff", "limited")  # for the oracle


@cache
def made(name: str) -> Certificate:
    """A kept certificate, or that of a hop with its apex, of bounces that are closed, of a motion that its limit ends."""
    if name in NAMES:
        kept: Certificate = json.loads((KEPT / f"{name}.json").read_text(encoding="utf-8"))
        return kept
    scenario, digits, most = PROVED[name]
    return read_again(prove(scenario, digits, max_events=most).certificate)


# --- changes at random --------------------------------------------------------------------------


def leaves(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    if isinstance(value, dict | list) and value:
        pairs = value.items() if isinstance(value, dict) else enumerate(value)
        return [found for key, one in pairs for found in leaves(one, (*path, key))]
    return [path]


def within(value: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        value = value[key]
    return value


def other_text(text: str, dice: random.Random) -> str:
    words = text.split(" ")
    if len(words) > 3:  # coefficients
        place = dice.randrange(len(words))
        words[place] = dice.choice(
            ["0", words[place] + "0", words[place].lstrip("-")[:-1] or "1", "-" + words[place].lstrip("-")]
        )
        return " ".join(words)
    try:
        number = Decimal(text)
    except ArithmeticError:
        return dice.choice(WORDS)
    if dice.random() < 0.3:
        return str(-number)
    return str(number + Decimal(dice.choice([-1, 1])) * Decimal(10).scaleb(dice.randint(-20, 1)))


def other(value: Any, dice: random.Random) -> Any:
    if isinstance(value, bool) or value is None:
        return dice.choice([True, None, 1, "R", "0.5"])
    if isinstance(value, int):
        return value + dice.choice([-1000, -40, -5, -2, -1, 1, 2, 5, 40])
    if isinstance(value, float):
        return dice.choice([value * (1 + 10 ** dice.uniform(-15, 0)), -value, value / 2, 0.0, value + 1.0])
    return other_text(value, dice) if isinstance(value, str) else []


def change_a_leaf(section: Callable[[Certificate], Any]) -> Callable[[Certificate, random.Random], None]:
    def change(certificate: Certificate, dice: random.Random) -> None:
        part = section(certificate)
        paths = [path for path in leaves(part) if path]
        if paths:
            path = dice.choice(paths)
            holder = within(part, path[:-1])
            holder[path[-1]] = other(holder[path[-1]], dice)

    return change


def change_a_convention(certificate: Certificate, dice: random.Random) -> None:
    name = dice.choice(["closing", "digits", "max_events", "until", "status", "ending", "sequence", "bits", "schema"])
    value = certificate.get(name, 4000)
    if name == "sequence":
        place = dice.randrange(len(value))
        certificate[name] = value[:place] + dice.choice(["", *"RSKH"]) + value[place + dice.randint(0, 1) :]
    else:
        certificate[name] = other(value, dice)


def leave_out(certificate: Certificate, dice: random.Random) -> None:
    holder = certificate[dice.choice(["events", "phases"])]
    if holder:
        del holder[dice.randrange(len(holder))]


def leave_out_together(certificate: Certificate, dice: random.Random) -> None:
    """An apex from the events and from its phase."""
    apexes = [k for k, event in enumerate(certificate["events"]) if event["kind"] == "apex"]
    flights = [phase for phase in certificate["phases"] if phase["mode"] == "H" and phase["apex"] is not None]
    if apexes:
        k = dice.randrange(len(apexes))
        del certificate["events"][apexes[k]]
        flights[k]["apex"] = None
    else:
        leave_out(certificate, dice)


def cut_short(certificate: Certificate, dice: random.Random) -> None:
    count = dice.randrange(1, len(certificate["events"]) + 1)
    del certificate["events"][count:]
    del certificate["phases"][dice.randrange(len(certificate["phases"]) + 1) :]
    certificate |= {"status": "event_limit", "ending": "event_limit"}
    certificate["sequence"] = certificate["sequence"][: dice.randint(1, len(certificate["sequence"]))]


def repeat_or_swap(certificate: Certificate, dice: random.Random) -> None:
    holder = certificate["events" if dice.random() < 0.7 else "phases"]
    if holder:
        a, b = (dice.randrange(len(holder)) for _ in range(2))
        if dice.random() < 0.5:
            holder[a], holder[b] = holder[b], holder[a]
        else:
            holder.insert(a, copy.deepcopy(holder[b]))


CHANGES: list[Callable[[Certificate, random.Random], None]] = [
    change_a_leaf(lambda certificate: certificate["events"]), change_a_leaf(lambda certificate: certificate["events"]),
    change_a_leaf(lambda certificate: certificate["scenario"]), change_a_leaf(lambda certificate: certificate["phases"]),
    change_a_convention, change_a_convention, leave_out, leave_out_together, cut_short, repeat_or_swap,
]  # fmt: skip


def stated(certificate: Certificate) -> str:
    return json.dumps([certificate.get(name) for name in STATED], sort_keys=True)


def is_true(certificate: Certificate) -> bool:
    """Whether the oracle has the same events of the scenario, in the enclosures of the certificate."""
    digits, claims = certificate["digits"], certificate["events"]
    if not 0 <= digits <= 200 or Decimal(certificate["closing"]) != Decimal("1e-12"):
        return False
    try:
        scenario = hh.Scenario.from_dict(certificate["scenario"])
    except ValueError:
        return False
    limited = certificate["status"] == "event_limit"
    limit = certificate.get("max_events", 4000)
    if len(claims) > limit or (limited and len(claims) < limit):
        return False
    precise = max(digits, SHORTEST) + 20
    with mp.workdps(precise + 10):
        case = case_of(scenario, certificate)
        found = highest_apexes(motion_of(case, precise))
        if certificate["until"] == "revolution":
            found, ending = first_revolution(found, case.angle)
            said = certificate["status"], certificate["ending"]
            if said != ("completed", ending):
                return False
            end = {**found[-1], "kind": "end", "from": found[-1]["to"]}
            if ending == "revolutions":
                end = motion_of(replace(case, duration=claims[-1]["t"][0]), precise)[-1]
            found.append(end)
        elif not limited and (certificate["status"], certificate["ending"]) != ("completed", "duration"):
            return False
        found = found[: len(claims)]
        if len(found) != len(claims) or certificate["sequence"] != sequence_of(found, certificate["ending"]):
            return False
        return all(is_enclosed(claim, event, scenario, digits) for claim, event in zip(claims, found, strict=True))


def case_of(scenario: hh.Scenario, certificate: Certificate) -> Case:
    """The oracle's case."""
    hoop, plane, start, claims = scenario.hoop, scenario.plane, scenario.start, certificate["events"]
    shared = {name: getattr(plane, name) for name in ("gravity", "slope", "mu_static", "mu_kinetic", "restitution")}
    turning = certificate["until"] == "revolution"
    return Case(
        "changed", radius=hoop.radius, mass=hoop.mass, eccentricity=hoop.eccentricity, inertia_ratio=hoop.inertia_ratio,
        **shared, impact_law=plane.impact_law, painleve=plane.painleve, x=start.x, height=start.height, angle=start.angle,
        vx=start.speed if start.speed is not None else start.vx, vy=start.vy, omega=start.omega or 0.0,
        rolling=start.speed is not None, duration=1.1 * float(claims[-1]["t"][0]) + 0.01 if turning else scenario.duration,
        max_events=3 * len(claims) + 20,
    )  # fmt: skip


@cache
def motion_of(case: Case, digits: int) -> list[dict[str, Any]]:
    """The oracle's events; bounces that would take less than 1e-12 of the time so far are closed, as the model does."""
    with mp.workdps(digits + 10):
        events = solve(case, digits).events
        impacts = [one for one in events if one["kind"] == "impact"]
        for before, one in pairwise(impacts):
            if 0 < one["vy"] < before["vy"] and closes(case, one, one["vy"] / before["vy"]):  # the oracle closes below a speed
                return solve(replace(case, rest_below=1.5 * float(before["vy"])), digits).events
    return events


def closes(case: Case, impact: dict[str, Any], ratio: mpf) -> bool:
    """Whether the bounces after an impact take less than 1e-12 of the time so far."""
    spin = case.eccentricity * case.radius * impact["omega"] ** 2 * mp.cos(impact["angle"])
    fall = case.gravity * math.cos(case.slope) - spin
    left = 2 * impact["vy"] / (fall * (1 - ratio))
    return bool(fall > 0 and left < 1e-12 * max(impact["t"], math.sqrt(case.radius / case.gravity)))


def first_revolution(events: list[dict[str, Any]], origin: float) -> tuple[list[dict[str, Any]], str]:
    """Events up to the first of a whole turn, a turning point and a take-off; and which of them it is."""
    for k, event in enumerate(events):
        if abs(event["angle"] - origin) > 2 * mp.pi:
            return events[:k], "revolutions"
        if event["kind"] == "turn" or event["to"] == "H":
            return events[: k + 1], "reversal" if event["kind"] == "turn" else "takeoff"
    return events[:-1], "revolutions"


def sequence_of(events: list[dict[str, Any]], ending: str) -> str:
    """One letter per phase."""
    marks = [one for one in events if one["kind"] not in ("apex", "turn", "end")]
    pairs = pairwise([*marks, events[-1]])
    letters = "".join(one["to"] for one, following in pairs if one["t"] < following["t"])
    return letters + "H" * (ending == "takeoff") or marks[-1]["to"]


def is_enclosed(claim: dict[str, Any], event: dict[str, Any], scenario: hh.Scenario, digits: int) -> bool:
    """Whether an event is the one that is claimed, in its enclosures, and these are as narrow as the digits say."""
    kind = "impact" if claim["kind"] == "bounce_limit" else claim["kind"]
    if (kind, claim["to"]) != (event["kind"], event["to"]) or (kind != "start" and claim["from"] != event["from"]):
        return False
    radius, gravity = scenario.hoop.radius, scenario.plane.gravity or 1.0
    time, speed = (radius / gravity) ** 0.5, (radius * gravity) ** 0.5
    units = dict(zip(NUMBERS, (time, radius, radius, 1.0, speed, speed, 1 / time), strict=True))
    late = mpf(claim["t"][1]) if kind == "end" else 0  # the oracle was asked for the time in the middle
    for name in NUMBERS:
        middle, reach = (mpf(text) for text in claim[name])
        wide = digits and reach > 4 * max(abs(middle), units[name]) / mpf(10) ** digits
        if wide or abs(event[name] - middle) > reach + FASTEST * late + mpf(10) ** (-digits - 8) * units[name]:
            return False
    return True


def untrue(names: Sequence[str], count: int, seed: int) -> tuple[list[str], int]:
    """(accepted changes that are not true, how many changes stated something else)."""
    dice, found, others = random.Random(seed), [], 0
    while others < count:
        before = made(dice.choice(names))
        after = copy.deepcopy(before)
        change = dice.choice(CHANGES)
        change(after, dice)
        if stated(after) == stated(before):
            if dice.random() < 0.8:
                continue  # another certificate of the same statement
            check(after)
            continue
        others += 1
        if check(after).accepted and not is_true(after):
            found.append(f"{before['sequence']}: {change.__name__}")
    return found, others


def test_no_change_that_states_something_else_passes():
    assert untrue(QUICK, 60, 31) == ([], 60)


@pytest.mark.long
def test_none_of_many_changes_that_states_something_else_passes():
    assert untrue([*NAMES, *PROVED], 520, 1000) == ([], 520)
