"""Ends of a motion before its duration: after so many revolutions or landings, at an angle, at a take-off or a reversal."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from hophoop.kernel.numerics.arithmetic import TWO_PI
from hophoop.kernel.panels.panel import FLY, LINEAR
from hophoop.kernel.physics.body import PASSING, Event, Mode
from hophoop.kernel.physics.modes import slip_direction
from hophoop.kernel.records.layout import COLUMNS, EVENT, SEGMENT
from hophoop.scenario import InputError
from hophoop.vocabulary.names import number_after

UNTILS = ("revolutions:N", "landings:N", "angle:RADIANS", "takeoff", "reversal")
ROUNDS = 80  # of the search for a passage; most need 4


class Until(NamedTuple):
    """What ends a motion before its duration.

    Attributes
    ----------
    word : str
        'revolutions', 'landings', 'angle', 'takeoff' or 'reversal'.
    number : float
        How many revolutions or landings [1], or the angle [rad].
    """

    word: str
    number: float


def read_until(text: str) -> Until:
    """Return what ends a motion, by its name.

    text: ``revolutions:N`` (θ has changed by so many revolutions in either direction), ``landings:N`` (just after the N-th
    landing), ``angle:RADIANS`` (the next time that θ is this angle, or differs from it by whole revolutions), ``takeoff`` or
    ``reversal``.

    Examples
    --------
    >>> read_until("landings:2")
    Until(word='landings', number=2.0)
    """
    if text in ("takeoff", "reversal"):
        return Until(text, 1.0)
    for word in ("revolutions", "landings", "angle"):
        number = number_after(word, text)
        fits = abs(number) <= 1e6 if word == "angle" else number > 0.0
        if fits and (word != "landings" or number.is_integer()):
            return Until(word, number)
    known = f"one of {', '.join(UNTILS)}, with N above 0 (a whole number of landings)"
    raise InputError.of_field("until", text, known)


def is_met(until: Until, kind: int, after_mode: int, height: float, vy: float, collision: int | bool | None) -> bool:
    """Return True if an event is one of those that `until` counts.

    until: Of 'landings', 'takeoff' or 'reversal'; kind, after_mode: Codes of the event and of the mode after it; height, vy:
    Gap and velocity of separation just after it, in any unit; collision: Of an impact: whether the rim approached the plane.
    """
    if until.word == "landings":
        return kind == Event.BOUNCE_LIMIT or (kind == Event.IMPACT and collision == 1)
    if until.word == "reversal":
        return kind == Event.TURN
    return (
        until.word == "takeoff"
        and kind not in PASSING
        and kind != Event.END
        and after_mode == Mode.FLIGHT
        and height == 0.0
        and not vy < 0.0
    )


def first_met(until: Until, events: np.ndarray) -> int | None:
    """Return the row of the event that ends the motion, or None.

    row: Of a landing Kane's gain, if there is one, is included.
    """
    left = until.number
    columns = (events[name].tolist() for name in ("kind", "after_mode", "height", "vy", "collision"))
    for row, numbers in enumerate(zip(*columns, strict=True)):
        if is_met(until, *numbers):
            left -= 1.0
            if left <= 0.0:
                gained = row + 1 < len(events) and events[row + 1]["kind"] == Event.KANE_GAIN
                return row + 1 if gained else row
    return None


def distances(angle: float, start: float) -> tuple[float, float]:
    """Return the rotations, forward and backward, from a start to the next passages of an angle.

    angle, start: [rad]; ahead, back: Above 0 and at most 2π [rad].
    """
    ahead = (angle - start) % TWO_PI
    if ahead == 0.0:
        return TWO_PI, TWO_PI
    return ahead, TWO_PI - ahead


Sampled = Callable[[np.ndarray], np.ndarray]  # samples at some times, shape (m, len(COLUMNS)), in kernel units


def cut(until: Until, events: np.ndarray, segments: np.ndarray, sampled: Sampled) -> tuple[np.ndarray, np.ndarray] | None:
    """Return events and segments of a motion that ends where `until` is met, or None if it is not.

    events, segments: Of the motion that goes on, in kernel units; sampled: Returns the samples of the motion at some times,
    shape (m, len(COLUMNS)), in kernel units.
    """
    if until.word not in ("revolutions", "angle"):
        row = first_met(until, events)
        return None if row is None else _cut_at_event(events, segments, row)
    start = float(events["angle"][0])
    ahead = back = TWO_PI * until.number
    if until.word == "angle":
        ahead, back = distances(until.number, start)
    beyond = np.flatnonzero((events["angle"] >= start + ahead) | (events["angle"] <= start - back))
    if not beyond.size:
        return None
    row = int(beyond[0])
    target = start + ahead if events["angle"][row] >= start + ahead else start - back
    if events["angle"][row] == target and events["kind"][row] != Event.END:
        return _cut_at_event(events, segments, row)
    return _cut_at_passage(events, segments, row - 1, target, sampled)


def _cut_at_event(events: np.ndarray, segments: np.ndarray, row: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the motion up to just after an event."""
    kept = np.append(events[: row + 1], events[row : row + 1])
    _make_end(kept[row + 1 :], int(events["after_mode"][row]))
    last = events[row]
    before = (segments["t"] < last["t"]) | ((segments["t"] == last["t"]) & (segments["t_low"] < last["t_low"]))
    return kept, np.append(segments[before], end_of(kept, True))


def end_of(events: np.ndarray, forces: bool) -> np.ndarray:
    """Return a segment of zero length with the state after the last event, as `kernel.rigid.run.write_end` does.

    forces: Whether the contact forces of its mode are known; segments: shape (1,).
    """
    last = np.zeros(1, SEGMENT)
    for name in set(SEGMENT.names or ()).intersection(EVENT.names or ()) - {"kind"}:
        last[name] = events[name][-1]
    mode = int(events["after_mode"][-1])
    last["t_end"], last["mode"], last["sigma"] = events["t"][-1], mode, slip_direction(mode)
    last["kind"] = LINEAR if forces and mode in (Mode.ROLL, Mode.SPIN, Mode.SKID) else FLY
    last["direction"] = np.sign(last["omega"])
    return last


def _cut_at_passage(
    events: np.ndarray, segments: np.ndarray, row: int, target: float, sampled: Sampled
) -> tuple[np.ndarray, np.ndarray]:
    """Return the motion up to where θ is `target`, between an event and the next one; there θ is monotone."""
    way = 1.0 if events["angle"][row + 1] > events["angle"][row] else -1.0
    t = _time_of_passage(float(events["t"][row]), float(events["t"][row + 1]), way, target, sampled)
    (found,) = sampled(np.array([t]))
    state = dict(zip(COLUMNS, found.tolist(), strict=True))
    kept = events[: row + 2].copy()
    last = kept[row + 1 :]
    for name in _SAMPLED:
        last[name] = state[name]
    last["t"], last["t_low"], last["x_low"] = t, 0.0, 0.0
    last["revolutions"] = round((state["angle"] - state["theta"]) / TWO_PI)
    _make_end(last, int(state["mode"]))
    pieces = segments[segments["t"] < t].copy()
    if len(pieces):
        pieces["t_end"][-1] = t
    return kept, pieces


def _time_of_passage(low: float, high: float, way: float, target: float, sampled: Sampled) -> float:
    """Return when θ, which is monotone from `low` to `high`, is `target`: by Newton's method, kept inside by bisection."""
    t = 0.5 * (low + high)
    angle, rate = COLUMNS.index("angle"), COLUMNS.index("omega")
    for _ in range(ROUNDS):
        (found,) = sampled(np.array([t]))
        ahead = way * (target - found[angle])
        low, high = (t, high) if ahead > 0.0 else (low, t)
        nearer = t + ahead / abs(found[rate]) if found[rate] != 0.0 else math.inf
        if not low <= nearer <= high:
            nearer = 0.5 * (low + high)
        if nearer == t:
            break
        t = nearer
    return t


def _make_end(rows: np.ndarray, mode: int) -> None:
    """Make the END of a motion from a row, in its state."""
    rows["kind"], rows["before_mode"], rows["after_mode"] = Event.END, mode, mode
    for name in ("vx", "vy", "omega", "slip"):
        rows[f"before_{name}"] = rows[name]
    for name in ("impulse_normal", "impulse_tangential", "gain"):
        rows[name] = 0.0
    rows["collision"], rows["stable"] = -1, -1


_SAMPLED = (
    "x", "height", "angle", "vx", "vy", "omega", "slip", "theta", "theta_low",
    "friction", "impact_normal", "impact_tangential", "rolling_resistance",
)  # fmt: skip
