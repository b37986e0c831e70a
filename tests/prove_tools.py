"""What a proof and the kernel say of the same motion, side by side."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import hophoop as hh
from hophoop.prove import prove

NUMBERS = ("t", "x", "height", "angle", "vx", "vy", "omega")
BOUNCING = hh.Scenario(plane=hh.Plane(restitution=0.3), start=hh.Start(height=0.5, vx=1.0, omega=3.0, vy=2.0), duration=2.0)
KERNEL = 1e-8  # of the number, or of 0.001 of its SI unit


def contradiction(scenario: hh.Scenario, most: int) -> str:
    """How a proof of `most` events at most and the kernel contradict each other, '' where they do not."""
    proof, motion = prove(scenario, 10, max_events=most), hh.simulate(scenario)
    # the top of a flight changes no mode, and the kernel does not name one where the end of the time cuts the flight off
    events = [event for event in motion.events if event.kind != "apex"]
    facts = [event for event in proof.events if event.kind != "apex"]
    for fact, event in zip(facts, events, strict=False):
        if (fact.kind, fact.from_mode, fact.to_mode) != (event.kind, event.from_mode, event.to_mode):
            return f"{fact.kind} is proved where the kernel has {event.kind} at {event.t}"
        for name in NUMBERS:
            value = getattr(event, name)
            if getattr(fact, name).distance(value) > KERNEL * max(abs(value), 1e-3):
                return f"{name} of {event.kind} at {event.t} is off"
    if proof.proved and proof.status != "event_limit" and len(facts) != len(events):
        return f"{len(facts)} events are proved, {len(events)} computed"
    return "" if proof.proved else proof.why


def are_enclosed(proof: Any, true: Any) -> None:
    """Events of another computation, as dicts, lie in the enclosures of a proof."""
    assert proof.proved, proof.why
    found = [event for event in proof.events if event.kind not in ("apex", "rest")]
    expected = [event for event in true if event["kind"] not in ("apex", "rest")]
    for event, one in zip(found, expected, strict=False):
        modes = (event.from_mode if event.kind != "start" else one["from"], event.to_mode)
        assert (event.kind, *modes) == (one["kind"], one["from"], one["to"])
        for name in NUMBERS:
            assert getattr(event, name).holds(Fraction(one[name])), (event.kind, name)


def read_again(certificate: Any) -> dict[str, Any]:
    """A certificate as its file has it."""
    found: dict[str, Any] = json.loads(json.dumps(certificate))
    return found
