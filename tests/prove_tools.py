"""What a proof and the kernel say of the same motion, side by side."""

from fractions import Fraction

import hophoop as hh
from hophoop.prove import prove

NUMBERS = ("t", "x", "height", "angle", "vx", "vy", "omega")
KERNEL = 1e-8  # of the number, or of 0.001 of its SI unit


def contradiction(scenario, most):
    """How a proof of `most` events at most and the kernel contradict each other, '' where they do not."""
    proof, motion = prove(scenario, 10, max_events=most), hh.simulate(scenario)
    events, facts = list(motion.events), list(proof.events)
    closed = next((k for k, event in enumerate(events) if event.kind == "bounce_limit"), len(events))
    while closed < len(events) and facts[closed : closed + 1] and facts[closed].kind in ("impact", "apex"):
        del facts[closed]  # a proof closes endless bounces later
    if closed < len(events) and len(facts) == closed:
        return ""  # or has too many events before
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


LOSSES = ("friction", "impact_normal", "impact_tangential", "rolling_resistance")


def are_enclosed(proof, true, rounded):
    """Count the numbers of events of another computation, as dicts, that lie in the enclosures of a proof; all have to.

    `rounded` is how far a true number may be from the given one, relative to itself or to 1. An oracle's events end where its
    own treatment of endless bounces begins.
    """
    if [event["kind"] for event in true[-2:]] == ["apex", "end"] and proof.events[-2].kind != "apex":
        true = [*true[:-2], true[-1]]  # the oracle's highest top up to the end, and a higher one would come after it
    kinds = {event["kind"] for event in true}
    found = [event for event in proof.events if event.kind in kinds]
    if true[0]["kind"].startswith("painleve"):
        true = [{"kind": "start", "to": found[0].to_mode}, *true] if found[0].kind == "start" else true
    count = 0
    for event, one in zip(found, true, strict=False):
        if "bounce_limit" in (event.kind, one["kind"]) or (one["kind"] == "end" and event.kind in ("impact", "apex")):
            break  # bounces that are closed at different places, or a list of the first few
        if one["kind"] == "impact" and event.kind == "impact" and event.to_mode == "H" != one["to"]:
            break  # the oracle closes bounces by a plastic impact
        assert event.kind == one["kind"]
        assert event.to_mode == one["to"] or event.kind.startswith("painleve")
        names = (*NUMBERS, *LOSSES, "gain") if "rolling_resistance" in one else NUMBERS
        numbers = {name: (getattr(event, name), one[name]) for name in names if name in one}
        for name, value in (one.get("before") or {}).items():
            numbers[f"before {name}"] = getattr(event.before, name), value
        for name, value in (one.get("impulse") or {}).items():
            numbers[f"impulse {name}"] = getattr(event, f"impulse_{name}"), value
        for name, (known, value) in numbers.items():
            exact = Fraction(value)
            assert abs(Fraction(known.middle) - exact) <= Fraction(known.radius) + rounded * max(1, abs(exact)), (
                one["kind"],
                name,
            )
        count += len(numbers)
    return count
