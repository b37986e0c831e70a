"""Certificates changed at random: what the checker still accepts must be true of the scenario that it then names.

What decides is the motion in more digits, a Taylor series in time, of which nothing is in a proof.
"""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Callable, Sequence
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import hophoop as hh
from hophoop.prove import check, prove
from prove_tools import BOUNCING, NUMBERS, read_again

pytest.importorskip("flint")

KEPT = Path(__file__).parent.parent / "data" / "proofs"
NAMES = ("R-revolutions", "RKRSH-takeoff", "RKRSR-reversal", "RSKSR-revolutions", "RSRKRSRKR-revolutions")
STATED = ("schema", "until", "closing", "digits", "max_events", "sequence", "status", "ending", "events", "scenario")
WORDS = ("completed", "at_rest", "event_limit", "duration", "revolution", "takeoff", "R", "S", "K", "H", "stick", "impact",
         "apex", "turn", "end", "limit", "newton", "flight")  # fmt: skip
Certificate = dict[str, Any]

PROVED = {"hop": (hh.Scenario(duration=2.0), 12, 4000), "limited": (BOUNCING, 8, 5)}
QUICK = ("R-revolutions", "RKRSH-takeoff", "limited")


@cache
def made(name: str) -> Certificate:
    """A kept certificate, or that of a hop with its apex, or of a motion that its limit ends."""
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


def other_text(text: str, dice: random.Random) -> str:
    first, *others = text.split(" ")
    if others:  # coefficients
        return " ".join([dice.choice(["0", first + "0", first.lstrip("-")[:-1] or "1", "-" + first.lstrip("-")]), *others])
    try:
        number = Decimal(text)
    except ArithmeticError:
        return dice.choice(WORDS)
    return str(dice.choice([-number, number + dice.choice([-1, 1]) * Decimal(10).scaleb(dice.randint(-20, 1))]))


def other(value: Any, dice: random.Random) -> Any:
    if isinstance(value, bool) or value is None:
        return dice.choice([True, None, 1, "R", "0.5"])
    if isinstance(value, int):
        return value + dice.choice([-1000, -40, -5, -2, -1, 1, 2, 5, 40])
    if isinstance(value, float):
        return dice.choice([value * (1 + 10 ** dice.uniform(-15, 0)), -value, value / 2, 0.0, value + 1.0])
    return other_text(value, dice) if isinstance(value, str) else []


def change_a_leaf(name: str) -> Callable[[Certificate, random.Random], None]:
    def change(certificate: Certificate, dice: random.Random) -> None:
        *path, last = dice.choice(leaves(certificate[name]) or [()]) or [0]
        holder = certificate[name]
        for key in path:
            holder = holder[key]
        if holder:
            holder[last] = other(holder[last], dice)

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


def cut_short(certificate: Certificate, dice: random.Random) -> None:
    count = dice.randrange(1, len(certificate["events"]) + 1)
    del certificate["events"][count:]
    del certificate["phases"][dice.randrange(len(certificate["phases"]) + 1) :]
    certificate |= {"status": "event_limit", "ending": "event_limit"}
    certificate["sequence"] = certificate["sequence"][: dice.randint(1, len(certificate["sequence"]))]


CHANGES: list[Callable[[Certificate, random.Random], None]] = [
    *(change_a_leaf(name) for name in ("events", "events", "scenario", "phases")),
    change_a_convention, change_a_convention, leave_out, cut_short,
]  # fmt: skip


def stated(certificate: Certificate) -> str:
    return json.dumps([certificate.get(name) for name in STATED], sort_keys=True)


UNTIL = {"revolutions": "revolutions:1", "takeoff": "takeoff", "reversal": "reversal"}


def is_true(certificate: Certificate) -> bool:
    """Whether the motion in more digits has the same events, in the enclosures of the certificate."""
    digits, claims = certificate["digits"], certificate["events"]
    limit, limited = certificate.get("max_events", 4000), certificate["status"] == "event_limit"
    if not 0 <= digits <= 200 or Decimal(certificate["closing"]) != Decimal("1e-12") or len(claims) > limit:
        return False
    scenario = hh.Scenario.from_dict(certificate["scenario"])
    if limited:
        scenario = scenario.replace("contact.max_events", min(limit, scenario.contact.max_events))
    ends: dict[str, str | None] = {"duration": None}
    if certificate["until"] == "revolution":  # which has no limit of time
        scenario, ends = scenario.replace("duration", 60.0), dict(UNTIL)
    ending = min(ends, key=lambda each: hh.simulate(scenario, until=ends[each]).duration)
    motion = hh.simulate(scenario, digits=digits + 30, until=ends[ending])
    said = certificate["status"], certificate["ending"], certificate["sequence"]
    known = motion.status, motion.status if limited else ending, motion.sequence + "H" * (ending == "takeoff")
    if said != known or len(claims) != len(motion.events):
        return False
    return all(is_enclosed(claim, event, digits) for claim, event in zip(claims, motion.events, strict=True))


def is_enclosed(claim: dict[str, Any], event: Any, digits: int) -> bool:
    """Whether an event is the one that is claimed, in its enclosures, and these are as narrow as the digits say."""
    modes = (event.from_mode, event.to_mode) if event.kind != "start" else (claim["from"], event.to_mode)
    if (claim["kind"], claim["from"], claim["to"]) != (event.kind, *modes):
        return False
    for name in NUMBERS:
        middle, reach = map(Decimal, claim[name])
        close = 10 * max(abs(middle), 1) / Decimal(10) ** digits
        if (digits and reach > close) or abs(getattr(event, name) - middle) > reach + close * Decimal("1e-8"):
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
    assert untrue([*NAMES, *PROVED], 240, 1000) == ([], 240)
