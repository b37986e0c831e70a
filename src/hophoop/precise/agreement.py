"""Compare the kernel's events with those of a precise motion: the same ones, and the correct digits of each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from hophoop._support import tables
from hophoop.precise.result import PreciseMotion
from hophoop.results.records import EventRecord, Motion
from hophoop.scenario.scenario import time_unit

PLACES = ("t", "angle", "x")
NUMBERS = ("t", "angle", "x", "vx", "omega")
MOST_DIGITS = 17


@dataclass(frozen=True)
class Row:
    """One event in both motions: its kind, its time [s] and the digits that are right of each number [1]."""

    kind: str
    t: float
    digits: dict[str, float]


@dataclass(frozen=True)
class Agreement:
    """The comparison of two computations of one motion.

    Attributes
    ----------
    rows : tuple of Row
        Events that both have, in order, up to the first difference.
    difference : str
        A sentence, empty where the motions have the same events.
    """

    rows: tuple[Row, ...]
    difference: str

    def __repr__(self) -> str:
        rows = [(row.kind, f"t = {row.t:.9g} s", f"{min(row.digits.values()):.1f} digits") for row in self.rows]
        return tables.report(f"Agreement of {len(rows)} events", rows, [self.difference] if self.difference else [])

    @property
    def least(self) -> float:
        """Digits that are right of every number of every event [1]."""
        return min((min(row.digits.values()) for row in self.rows), default=math.nan)


def compare(motion: Motion, precise: PreciseMotion) -> Agreement:
    """Compare a motion of the kernel with the precise one of the same scenario.

    Three things are no difference: endless bounces, of which the precise motion counts more before it closes them; the
    apex of a flight that the end of the motion cuts short; and slip that ends within 1e-14 rad of p_σ = 0, which the
    kernel counts as an impulse at a fixed angle (`painleve_inconsistent` and an `impact`).

    Parameters
    ----------
    motion : Trajectory
        As `hophoop.simulate` gives it.
    precise : PreciseMotion
        As `hophoop.simulate` gives it with ``digits=``.

    Returns
    -------
    agreement : Agreement
        Digits are counted relative to the number itself or its unit made of R and g, whichever is larger.
    """
    scenario = precise.scenario
    second, length = time_unit(scenario.hoop, scenario.plane), scenario.hoop.radius
    units = {"t": second, "angle": 1.0, "x": length, "vx": length / second, "omega": 1.0 / second}
    rows: list[Row] = []
    ours, theirs = _uncut(motion.events), _uncut(precise.events)
    theirs = _as_many_bounces(ours, theirs)
    ours = _without_impulses(ours, theirs)
    for mine, right in zip(ours, theirs, strict=False):
        if _change(mine) != _change(right) and not _is_impulse(mine, right):
            return Agreement(
                tuple(rows),
                f"The motions differ from t = {float(right.t):.12g} s on: the kernel has {_words(mine)}, "
                f"{precise.digits} digits have {_words(right)}.",
            )
        # an impulse goes through the speeds that the turning point in it has not
        names = PLACES if _is_impulse(mine, right) else NUMBERS
        digits = {name: _digits(getattr(mine, name), getattr(right, name), units[name]) for name in names}
        rows.append(Row(right.kind, float(right.t), digits))
    if "event_limit" in (motion.status, precise.status):
        return Agreement(tuple(rows), "")  # endless bounces fill the two lists differently
    if len(ours) != len(theirs):
        return Agreement(tuple(rows), f"The kernel has {len(ours)} events and {precise.digits} digits have {len(theirs)}.")
    if motion.status != precise.status:
        return Agreement(tuple(rows), f"The kernel ends {motion.status}, and {precise.digits} digits end {precise.status}.")
    return Agreement(tuple(rows), "")


def _change(event: Any) -> tuple[str, str | None, str]:
    return event.kind, event.from_mode, event.to_mode


def _words(event: Any) -> str:
    return f"{event.kind} ({event.from_mode or '–'} → {event.to_mode})"


def _digits(value: float, true: Decimal, unit: float) -> float:
    """Digits that are right, at most what a double has."""
    if not (math.isfinite(value) and true.is_finite()):
        return float(MOST_DIGITS) if str(value) == str(float(true)) else 0.0
    size = max(abs(float(true)), unit)
    error = float(abs(Decimal(value) - true)) / size
    digits = -math.log10(error) if error else math.inf  # noqa: TID251 - how many to print
    return max(0.0, min(float(MOST_DIGITS), digits))


def _is_impulse(mine: Any, right: EventRecord[Decimal]) -> bool:
    """Return True if the kernel's impact without collision is the end of a slip that nearly reaches p_σ = 0."""
    ends = ("stick", "slip_reversal", "takeoff", "turn")
    same = (mine.from_mode, mine.to_mode) == (right.from_mode, right.to_mode)
    return bool(mine.kind == "impact" and mine.collision is False and right.kind in ends and same)


def _without_impulses(ours: Sequence[Any], theirs: Sequence[EventRecord[Decimal]]) -> list[Any]:
    """The kernel's events without the paradox before such an impact."""
    kept: list[Any] = []
    for place, event in enumerate(ours):
        following = ours[place + 1] if place + 1 < len(ours) else None
        paradox = event.kind == "painleve_inconsistent" and following is not None and len(kept) < len(theirs)
        if not (paradox and _is_impulse(following, theirs[len(kept)])):
            kept.append(event)
    return kept


def _uncut(events: Sequence[Any]) -> list[Any]:
    """Without the apex of a flight that is not over."""
    kept = list(events)
    if kept and kept[-1].kind == "apex":  # the limit of events came in a flight
        kept.pop()
    if len(kept) > 1 and kept[-1].kind == "end" and kept[-2].kind == "apex":
        del kept[-2]
    return kept


def _as_many_bounces(ours: Sequence[Any], theirs: Sequence[EventRecord[Decimal]]) -> list[EventRecord[Decimal]]:
    """The precise events without the bounces that the kernel has closed already."""
    kept: list[EventRecord[Decimal]] = []
    place = 0
    for event in ours:
        if event.kind == "bounce_limit":
            while place < len(theirs) and theirs[place].kind in ("impact", "apex", "kane_gain"):
                place += 1
        if place >= len(theirs):
            break
        kept.append(theirs[place])
        place += 1
    return kept + list(theirs[place:])
