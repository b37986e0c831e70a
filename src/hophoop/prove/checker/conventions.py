"""The conventions of a statement in addition to the equations: each is bounded here and named with the verdict."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

from hophoop.prove._flint import Ball, rational
from hophoop.prove.checker.intervals import require
from hophoop.prove.checker.scenarios import readable

SCHEMA = "hophoop-proof/1"
CLOSING = "1e-12"  # bounces are closed when their rest takes less than this part of the time so far
GAIN_FLOOR = "1e-14"  # relative to the energy of an impact: a smaller gain is no event
UNTIL = {"duration": "up to the end of its duration", "revolution": "up to a whole turn, a turning point or a take-off"}
MOST_BITS = 20_000
MOST_DIGITS = 200
MOST_EVENTS = 10_000_000
OWN_EVENTS = 100_000  # the limit of a scenario that names none
USUAL_EVENTS = 4000  # the limit of a certificate that names none
WIDEST = 3  # a radius in units of 10^−digits, relative to its number or the unit of that
LONGEST, LARGEST_EXPONENT = 1000, 10_000  # of a decimal number: more only takes time

KEYS = {
    "schema", "version", "scenario", "until", "closing", "bits", "digits", "max_events", "sequence", "status", "ending",
    "events", "phases",
}  # fmt: skip
EVENT_KEYS = {"kind", "from", "to", "t", "x", "height", "angle", "vx", "vy", "omega"}


@dataclass(frozen=True)
class Conventions:
    """A certificate's conventions, within their bounds.

    Attributes
    ----------
    scenario : dict
        As a scenario file has it.
    until : str
        'duration' or 'revolution'.
    digits : int
        That every enclosure determines [1].
    max_events : int
        With so many events the motion ends with status 'event_limit' [1].
    bits : int
        The checker works with [1].
    """

    scenario: dict[str, Any]
    until: str
    digits: int
    max_events: int
    bits: int

    @classmethod
    def of(cls, certificate: dict[str, Any]) -> Conventions:
        """Read them; one that is out of its bounds refuses the certificate."""
        require(certificate.get("schema") == SCHEMA, f"the format is {SCHEMA}")
        require(set(certificate) <= KEYS, "the certificate states nothing but what is checked")
        bits = _whole(certificate["bits"], 30, MOST_BITS, "the working precision")
        digits = _whole(certificate["digits"], 0, MOST_DIGITS, "the number of digits")
        until = certificate["until"]
        require(isinstance(until, str) and until in UNTIL, "until is duration or revolution")
        closing = str(certificate["closing"])
        require(closing == CLOSING, f"bounces are closed at {CLOSING} of the time so far, as the model has it")
        readable(certificate["scenario"])
        own = _whole(certificate["scenario"].get("contact", {}).get("max_events", OWN_EVENTS), 1, MOST_EVENTS, "max_events")
        limit = _whole(certificate.get("max_events", min(USUAL_EVENTS, own)), 1, own, "the limit of events")
        found = len(certificate["events"])
        if certificate["status"] == "event_limit":
            require(found == limit, f"the motion ends at its limit of {limit} events")
        require(found <= limit, f"there are no more than {limit} events")
        for event in certificate["events"]:
            require(set(event) == EVENT_KEYS, "an event states nothing but what is checked")
        return cls(certificate["scenario"], until, digits, limit, bits)

    def lines(self) -> tuple[str, ...]:
        """Each in words."""
        return (
            f"the motion is followed {UNTIL[self.until]}, and for {self.max_events} events at most",
            f"every number is enclosed to {self.digits} digits, relative to itself or to its unit made of R and g",
            f"bounces are closed when what is left of them takes less than {CLOSING} of the time so far",
            f"a gain of energy below {GAIN_FLOOR} of an impact's energy is no event",
            "an apex is the highest top of the gap in a flight; where the highest are equal, there is none",
        )

    def encloses(self, claim: list[str], value: Ball, unit: Ball) -> bool:
        """Return True if [middle − radius, middle + radius] holds all of a ball, and is as narrow as the digits require."""
        require(len(claim) == 2, "an enclosure is a middle and a radius")
        middle, radius = (rational(decimal(text)) for text in claim)
        if radius.is_zero():
            return bool((value - middle).is_zero())
        widest = WIDEST * abs(middle).max(unit) * rational(Fraction(1, 10**self.digits))
        require(self.digits == 0 or bool(radius <= widest), f"every enclosure determines {self.digits} digits")
        return bool(abs(value - middle) <= radius)


def decimal(text: str) -> Fraction:
    """A decimal number exactly, unless it is too long to be one."""
    require(isinstance(text, str) and len(text) <= LONGEST, "a number is a text of sensible length")
    number = Decimal(text)
    require(number.is_finite() and abs(number.adjusted()) <= LARGEST_EXPONENT, "a number is finite and of sensible size")
    return Fraction(number)


def _whole(value: Any, least: int, most: int, what: str) -> int:
    whole = isinstance(value, int) and not isinstance(value, bool)
    require(whole and least <= value <= most, f"{what} is a whole number from {least} to {most}")
    return int(value)
