"""Ends of a motion before its duration: after so many revolutions or landings, at an angle, at a take-off or a reversal."""

from __future__ import annotations

import math

from hophoop.kernel.records import STOP_AT_TAKEOFF, STOP_AT_TURN, Until
from hophoop.scenario import InputError
from hophoop.vocabulary.names import number_after

UNTILS = ("revolutions:N", "landings:N", "angle:RADIANS", "takeoff", "reversal")
NOTHING = Until(stop=0, landings=0, revolutions=math.nan, angle=math.nan)


def read_until(text: str) -> Until:
    """Return what ends a motion, by its name.

    text: ``revolutions:N`` (θ has changed by so many revolutions in either direction), ``landings:N`` (just after the N-th
    landing), ``angle:RADIANS`` (the next time that θ is this angle, or differs from it by whole revolutions), ``takeoff`` or
    ``reversal``.

    Examples
    --------
    >>> read_until("landings:2").landings
    2
    """
    if text in ("takeoff", "reversal"):
        return NOTHING._replace(stop=STOP_AT_TAKEOFF if text == "takeoff" else STOP_AT_TURN)
    revolutions, landings, angle = (number_after(word, text) for word in ("revolutions", "landings", "angle"))
    if revolutions > 0.0:
        return NOTHING._replace(revolutions=revolutions)
    if landings > 0.0 and landings.is_integer():
        return NOTHING._replace(landings=int(min(landings, 1e15)))
    if abs(angle) <= 1e6:
        return NOTHING._replace(angle=angle)
    known = f"one of {', '.join(UNTILS)}, with N above 0 (a whole number of landings)"
    raise InputError.of_field("until", text, known)
