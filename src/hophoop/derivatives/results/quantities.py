"""The quantities of a motion that have derivatives, by name: of events, of hops, of times, of maps."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np

from hophoop.derivatives.results.propagation import FIELDS, TangentSolution, WithDerivatives, unit_of
from hophoop.kernel.model import EVENT_NAMES, Event, Mode
from hophoop.kernel.numerics.elementwise import cosine, sine
from hophoop.results.records import Motion
from hophoop.scenario import InputError
from hophoop.vocabulary.names import phase_starts

HOP = {  # units
    "height": "m", "distance": "m", "duration": "s", "takeoff_time": "s", "takeoff_angle": "rad", "landing_angle": "rad",
    "load_up": "1", "loss": "J",
}  # fmt: skip
# What a map calls the same of the first hop, and of the whole motion.
MAPPED = {
    "takeoff_time": "hop.takeoff_time",
    "takeoff_angle": "hop.takeoff_angle",
    "hop_height": "hop.height",
    "flight_time": "hop.duration",
    "flight_distance": "hop.distance",
    "landing_angle": "hop.landing_angle",
    "landing_loss": "hop.loss",
    "end_angle": "end.angle",
    "end_speed": "end.vx",
    "time": "end.t",
}
_NAME = re.compile(r"(?P<what>[a-z_]+)(?:\[(?P<place>-?\d+)\])?\.(?P<field>[a-z_.]+)")
_AT = re.compile(r"at\((?P<time>[^()]+)\)\.(?P<field>[a-z_]+)")
AT_TIMES = tuple(name for name in FIELDS if not name.startswith(("before", "impulse")) and name != "t")


class NotInMotion(InputError):
    """A quantity that other motions have: this one lacks the event that it is read at."""


@lru_cache(maxsize=256)
def unit_of_quantity(name: str) -> str:
    """SI unit of a quantity by its name.

    Parameters
    ----------
    name : str
        As `quantity` takes it.

    Returns
    -------
    unit : str
    """
    name = MAPPED.get(name, name)
    if name in WHOLE:
        return WHOLE[name][1]
    field = name.split(").")[-1] if name.startswith("at(") else name.partition(".")[2]
    return HOP[field] if name.startswith("hop") else unit_of(field)


def quantity(motion: Motion, name: str) -> Callable[[TangentSolution], WithDerivatives]:
    """Return the function that reads a quantity from a motion with its derivatives.

    Parameters
    ----------
    motion : Motion
        Which says what there is.
    name : str
        ``"takeoff.angle"``, ``"impact[1].t"`` (of the second, from 0; from −1 backwards), ``"hop.height"``,
        ``"at(0.8).angle"`` (the time in s), ``"end.x"``, or a map's name such as ``"hop_height"``.

    Returns
    -------
    read : callable

    Raises
    ------
    ValueError
        If there is no such quantity, or the motion has no such event.
    """
    known = MAPPED.get(name, name)
    if known in WHOLE:
        if known == "revolutions_to_rolling" and _rolling_since(motion) < 0:
            raise NotInMotion(f"of = {name!r}: this motion does not end in rolling.", field="of", value=name)
        return WHOLE[known][0]
    match = _AT.fullmatch(known) if known.startswith("at(") else None
    if match:
        return _at_time(motion, name, match["time"], match["field"])
    what, place, field = _parsed(known) or ("", 0, "")
    if not what:
        raise InputError(f"of = {name!r} is no quantity; there are {_known()}.", field="of", value=name)
    if what == "hop":
        if field not in HOP:
            raise InputError(f"of = {name!r}: a hop has {', '.join(HOP)}.", field="of", value=name)
        return _of_hop(motion, name, place, field)
    if what not in EVENT_NAMES:
        raise InputError(f"of = {name!r} is no quantity; there are {_known()}.", field="of", value=name)
    if field not in FIELDS:
        raise InputError(f"of = {name!r}: an event has {', '.join(FIELDS)}.", field="of", value=name)
    found = np.flatnonzero(motion.tables["events"]["kind"] == EVENT_NAMES.index(what))
    index = _chosen(name, what, found, place)
    return lambda solution: solution.at_event(index, field)


@lru_cache(maxsize=256)
def _parsed(name: str) -> tuple[str, int, str] | None:
    match = _NAME.fullmatch(name)
    return (match["what"], int(match["place"] or 0), match["field"]) if match else None


def _known() -> str:
    return "takeoff.angle, impact.x and the like, hop.height, at(0.8).angle and " + ", ".join([*WHOLE, *MAPPED])


def _chosen(name: str, what: str, found: np.ndarray, place: int) -> int:
    if not -len(found) <= place < len(found):
        count = f"{len(found) or 'no'} {what}{'' if len(found) == 1 else 's'}"
        raise NotInMotion(f"of = {name!r}: this motion has {count}.", field="of", value=name)
    return int(found[place])


def _at_time(motion: Motion, name: str, text: str, field: str) -> Callable[[TangentSolution], WithDerivatives]:
    try:
        time = float(text)
    except ValueError:
        raise InputError(f"of = {name!r}: {text!r} is no time in seconds.", field="of", value=name) from None
    if not 0.0 <= time <= motion.duration:
        raise InputError(
            f"of = {name!r}: the time must be from 0 to the motion's end at {motion.duration!r} s.", field="of", value=name
        )
    if field not in AT_TIMES:
        raise InputError(f"of = {name!r}: a time has {', '.join(AT_TIMES)}.", field="of", value=name)

    def read(solution: TangentSolution) -> WithDerivatives:
        values, rates = solution.at_times(np.array([time]), [field])[field]
        return WithDerivatives(float(values[0]), rates[0])

    return read


def hops_of(motion: Motion) -> list[tuple[int, int, int]]:
    """The flights of a motion.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    hops : list of (int, int, int)
        Indices of the events that a flight begins, is highest and ends with; −1 where there is none.
    """
    if motion not in _hops:
        _hops[motion] = _find_hops(motion.tables["events"])
    return _hops[motion]


_hops: WeakKeyDictionary[Motion, list[tuple[int, int, int]]] = WeakKeyDictionary()


def _find_hops(events: np.ndarray) -> list[tuple[int, int, int]]:
    kinds, heights, times, after = (events[name].tolist() for name in ("kind", "height", "t", "after_mode"))
    hops = []
    for begin, end in pairwise(phase_starts(kinds)):
        if after[begin] == Mode.FLIGHT and times[end] > times[begin]:
            apexes = (k for k in range(begin, end) if kinds[k] == Event.APEX)
            top = max(apexes, key=lambda k: heights[k], default=-1)
            hops.append((begin, top, end if kinds[end] != Event.END else -1))
    return hops


def _of_hop(motion: Motion, name: str, place: int, field: str) -> Callable[[TangentSolution], WithDerivatives]:
    hops = hops_of(motion)
    begin, top, end = hops[_chosen(name, "hop", np.arange(len(hops)), place)]
    if end < 0 and not field.startswith("takeoff") and not (field == "height" and top >= 0):
        raise NotInMotion(f"of = {name!r}: the motion ends before this hop does.", field="of", value=name)

    def read(solution: TangentSolution) -> WithDerivatives:
        if field == "height":
            return solution.at_event(begin if top < 0 else top, "height")
        if field.startswith("takeoff"):
            return solution.at_event(begin, "t" if field == "takeoff_time" else "angle")
        if field in ("landing_angle", "load_up"):
            angle = solution.at_event(end, "angle")
            return angle if field == "landing_angle" else WithDerivatives(cosine(angle.value), -sine(angle.value) * angle.rates)
        if field == "loss":
            return _impact_loss(solution, end) - _impact_loss(solution, begin)
        of = "x" if field == "distance" else "t"
        return solution.at_event(end, of) - solution.at_event(begin, of)

    return read


def _impact_loss(solution: TangentSolution, index: int) -> WithDerivatives:
    return solution.at_event(index, "impact_normal") + solution.at_event(index, "impact_tangential")


def _last(solution: TangentSolution) -> int:
    return len(solution.motion.tables["events"]) - 1


def _way(solution: TangentSolution) -> WithDerivatives:
    return solution.at_event(_last(solution), "x") - solution.at_event(0, "x")


def _lost(solution: TangentSolution) -> WithDerivatives:
    last = _last(solution)
    return solution.at_event(last, "friction") + solution.at_event(last, "rolling_resistance") + _impact_loss(solution, last)


def _way_rolled(solution: TangentSolution) -> WithDerivatives:
    """The lengths of what is rolled, between events; it turns round at events alone."""
    rolled = solution.at_event(0, "x") - solution.at_event(0, "x")
    for index, row in enumerate(solution.motion.tables["events"][:-1]):
        if row["after_mode"] == Mode.ROLL:
            piece = solution.at_event(index + 1, "x") - solution.at_event(index, "x")
            rolled += piece if piece.value >= 0.0 else -piece
    return rolled


def _rolling_since(motion: Motion) -> int:
    """The event at which the last phase began, where that is rolling, or −1."""
    since = -1
    for k in phase_starts(motion.tables["events"]["kind"].tolist()):
        rolls = motion.tables["events"]["after_mode"][k] == Mode.ROLL
        since = -1 if not rolls else k if since < 0 else since
    return since


def _revolutions(solution: TangentSolution) -> WithDerivatives:
    turned = solution.at_event(_rolling_since(solution.motion), "angle") - solution.at_event(0, "angle")
    turned = turned if turned.value >= 0.0 else -turned
    return WithDerivatives(turned.value / (2.0 * math.pi), turned.rates / (2.0 * math.pi))


# Of the whole motion: how they are read, and their units; in maps they are called the same.
WHOLE: dict[str, tuple[Callable[[TangentSolution], WithDerivatives], str]] = {
    "distance": (_way, "m"),
    "distance_rolled": (_way_rolled, "m"),
    "revolutions_to_rolling": (_revolutions, "1"),
    "energy_lost": (_lost, "J"),
    "greatest_utilization": (lambda solution: solution.friction_utilization(), "1"),
}
