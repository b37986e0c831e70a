"""Prove a bound of the errors of the benchmark's truth, and write it into the file.

    python benchmarks/engines/prove_truth.py            # all motions
    python benchmarks/engines/prove_truth.py NAME …     # some

For each motion every event is enclosed, and the state at each time of the grid by a proof of the motion up to it. `radius`
becomes the largest distance of a number of the file from the far end of its enclosure, in SI units; where a proof stays
undecided it becomes null, and the reason is printed. To be run after make_truth.py.
"""

from __future__ import annotations

import json
import sys
from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction
from typing import Any

from adapters.hophoop import scenario_of
from make_truth import NAMES, STATE, write
from truth import DATA, task_of

from hophoop.prove import Enclosure, prove

DIGITS = 28


class Unproved(Exception):
    """A motion, or its beginning, that stays undecided."""


def distance(text: str, enclosure: Enclosure) -> Fraction:
    """How far a number may be from the true one."""
    return abs(Fraction(text) - Fraction(enclosure.middle)) + Fraction(enclosure.radius)


def proved_events(scenario: Any) -> Any:
    """The enclosed events of a motion."""
    proof = prove(scenario, DIGITS)
    if not proof.proved:
        raise Unproved(f"{proof.why}, after {len(proof.events)} events")
    return proof.events


def radius_of(truth: dict[str, Any]) -> Fraction:
    """The largest possible error of the truth of one motion."""
    found = []
    scenario = scenario_of(task_of(truth["task"]))
    proved = proved_events(scenario)
    mine = [(event["kind"], event["from"], event["to"]) for event in truth["events"]]
    if mine != [(event.kind, event.from_mode, event.to_mode) for event in proved]:
        raise Unproved("its events are not those of the file")
    for event, enclosed in zip(truth["events"], proved, strict=True):
        found.append(distance(event["t"], enclosed.t))
        found += [distance(event[name], getattr(enclosed, field)) for name, field in zip(NAMES, STATE, strict=True)]
    states = truth["states"]
    for k, time in enumerate(states["t"]):
        # at the start the state is the one that goes on, which an impact at once may have made
        last = proved_events(scenario.replace("duration", float(time)))[-1] if float(time) else state_at_start(proved)
        found += [distance(states[name][k], getattr(last, field)) for name, field in zip(NAMES, STATE, strict=True)]
    return max(found)


def state_at_start(events: Any) -> Any:
    """The last event at t = 0."""
    return [event for event in events if event.t.middle == 0 and event.t.radius == 0][-1]


def rounded_up(bound: Fraction) -> str:
    """Two digits that are not smaller."""
    number = Context(prec=2, rounding=ROUND_CEILING).divide(Decimal(bound.numerator), Decimal(bound.denominator))
    return f"{number:.1e}"


def main() -> None:
    """Write the bounds and the checksum."""
    scenarios = json.loads(DATA.read_text(encoding="utf-8"))["scenarios"]
    for name in sys.argv[1:] or list(scenarios):
        try:
            scenarios[name]["radius"] = rounded_up(radius_of(scenarios[name]))
        except Unproved as why:
            scenarios[name]["radius"] = None
            print(f"{name}: undecided: {why}", flush=True)
        else:
            print(f"{name}: {scenarios[name]['radius']}", flush=True)
    write(scenarios)


if __name__ == "__main__":
    main()
