"""simulate(hoop, plane, start, …) → Trajectory, with either contact model."""

from __future__ import annotations

import math
import os
import struct
import threading
from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, overload

import numpy as np

import hophoop
from hophoop._native import compiled
from hophoop.arbitration import MOST, NO_SCRIPT, Budget, latest, script_until, steps_allowed
from hophoop.physics.body import Body, Status
from hophoop.records.layout import CELL, EVENT, MOST_PANELS, SEGMENT, Tables, first_rows
from hophoop.scenario import Compliant, Hoop, InputError, Plane, Rigid, Scenario, Start
from hophoop.scenario.scenario import cell_of
from hophoop.trajectory import Trajectory

if TYPE_CHECKING:
    from hophoop.derivatives.sensitivity import Sensitivity
    from hophoop.precise import PreciseMotion

FIRST_EVENTS, FIRST_SEGMENTS = 64, 256
BUFFER = int(Status.BUFFER)
# Read once: a look at the environment takes a tenth of a motion.
CHECKED = os.environ.get("HOPHOOP_CHECK", "0") not in ("", "0")


@overload
def simulate(scenario: Scenario, /) -> Trajectory: ...


@overload
def simulate(scenario: Scenario, /, *, digits: int) -> PreciseMotion: ...


@overload
def simulate(
    hoop: Hoop,
    plane: Plane | None = ...,
    start: Start | None = ...,
    duration: float | None = ...,
    contact: Rigid | Compliant | None = ...,
) -> Trajectory: ...


@overload
def simulate(
    hoop: Hoop,
    plane: Plane | None = ...,
    start: Start | None = ...,
    duration: float | None = ...,
    contact: Rigid | Compliant | None = ...,
    *,
    digits: int,
) -> PreciseMotion: ...


def simulate(
    hoop: Hoop | Scenario,
    plane: Plane | None = None,
    start: Start | None = None,
    duration: float | None = None,
    contact: Rigid | Compliant | None = None,
    *,
    digits: int | None = None,
) -> Trajectory | PreciseMotion:
    """Compute a motion.

    Parameters
    ----------
    hoop : Hoop or Scenario
        The hoop, with the four arguments that follow; or a whole scenario, without them. To change a part of a scenario, call
        `Scenario.replace` or `Scenario.with_values` first.
    plane : Plane, optional
        The reference plane by default.
    start : Start, optional
        At rest with the load at the top by default.
    duration : float, optional
        Above 0; 6 s by default [s].
    contact : Rigid or Compliant, optional
        Rigid() by default.
    digits : int, optional
        Solve in so many digits, 15 to 1000, by another method than the kernel's; the given doubles are taken as exact
        numbers. Takes some tenths of a second [1].

    Returns
    -------
    motion : Trajectory or PreciseMotion
        Also where the motion has no answer: see its `status`. With `digits` it is a `PreciseMotion`, with events only.

    Raises
    ------
    ValueError
        If the duration is not positive, the parts do not go together, a scenario is given with another part, or digits is out
        of range or asked for with a compliant contact.

    Examples
    --------
    >>> import hophoop as hh
    >>> motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    >>> motion.sequence
    'RKRSHR'
    >>> round(motion.find("takeoff")[0].t, 9)
    1.044713027
    >>> exact = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0, digits=30)
    >>> exact.find("takeoff")[0].t
    Decimal('1.04471302680335833630776765131')
    """
    if isinstance(hoop, Scenario):
        scenario = hoop
        if plane is not None or start is not None or duration is not None or contact is not None:
            _refuse_parts(plane=plane, start=start, duration=duration, contact=contact)
    else:
        scenario = Scenario(
            hoop=hoop,
            plane=Plane() if plane is None else plane,
            start=Start() if start is None else start,
            duration=6.0 if duration is None else duration,
            contact=Rigid() if contact is None else contact,
        )
    if digits is not None:
        motion: PreciseMotion = import_module("hophoop.precise").simulate_precisely(scenario, digits, hophoop.__version__)
        return motion
    return simulate_watched(scenario)


def _refuse_parts(**parts: Any) -> None:
    given = [name for name, part in parts.items() if part is not None]
    what = f"{given[0]} is" if len(given) == 1 else f"{', '.join(given[:-1])} and {given[-1]} are"
    how = (
        f'scenario.replace("{given[0]}", …)'
        if len(given) == 1
        else "scenario.with_values({" + ", ".join(f'"{name}": …' for name in given) + "})"
    )
    raise InputError(f"{what} part of the scenario and cannot be given as well: simulate {how} instead.")


def simulate_watched(scenario: Scenario, reached: np.ndarray | None = None) -> Trajectory:
    """`simulate`, for who shows from another thread how far a compliant motion is.

    Parameters
    ----------
    scenario : Scenario
    reached : ndarray, shape (1,), optional
        Is given the share of the duration that is computed, again and again, with a compliant contact [1].

    Returns
    -------
    motion : Trajectory
    """
    doubt = None
    if isinstance(scenario.contact, Compliant):
        status, events, segments = import_module("hophoop.compliant.kernel").simulate_compliant(scenario, reached)
    else:
        status, events, segments, _, doubt = _simulate_rigid(scenario, scenario.contact)
    motion = Trajectory(scenario, status, events, segments, hophoop.__version__, doubt)
    if CHECKED:
        import_module("hophoop.invariants").check(motion)
    return motion


def sensitivity(scenario: Scenario, of: str | Sequence[str], wrt: str | Sequence[str]) -> Sensitivity:
    """Derivatives of quantities of a motion with respect to parameters, through all events.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.
    of, wrt : str or sequence of str
        Quantities such as ``"takeoff.angle"`` and paths such as ``"plane.mu"``, as `Trajectory.sensitivity` takes them.

    Returns
    -------
    sensitivity : Sensitivity
        Derivatives in SI units; nan, with the reason, where there is none.

    Raises
    ------
    ValueError
        If a name is unknown, the motion has no such event, or its contact is compliant.

    Examples
    --------
    >>> import hophoop as hh
    >>> result = hh.sensitivity(hh.Scenario(duration=2.0), of="hop.height", wrt=["start.speed", "plane.mu"])
    >>> [round(float(rate), 6) for rate in result.derivatives[0]]
    [1.511834, -0.328315]
    """
    return simulate(scenario).sensitivity(of, wrt)


def script_of(scenario: Scenario, contact: Rigid) -> np.ndarray:
    """The first events of a motion that more digits have to decide.

    Parameters
    ----------
    scenario : Scenario
    contact : Rigid
        Its contact.

    Returns
    -------
    script : ndarray of records.EVENT, shape (n,)
        In kernel units; of length 0 where doubles decide everything [1].
    """
    return _simulate_rigid(scenario, contact)[3]


class _Own(threading.local):
    """What the motions of this thread are written into first, and copied from."""

    def __init__(self) -> None:
        self.tables = Tables(np.empty((len(CELL), 1)), np.empty(FIRST_EVENTS, EVENT), np.empty(FIRST_SEGMENTS, SEGMENT))


_own = _Own()
_run = compiled("hophoop.rigid.kernel.run_cell")
_fill = struct.Struct(f"{len(CELL)}d").pack_into  # a fifth of the time of an assignment


def _simulate_rigid(scenario: Scenario, contact: Rigid) -> tuple[int, np.ndarray, np.ndarray, np.ndarray, float]:
    """Status, events, segments, the script of what was decided in more digits, and when doubles first were in doubt."""
    tables = _own.tables
    _fill(tables.cell, 0, *cell_of(scenario))
    most_events = contact.max_events
    script = NO_SCRIPT
    decisions = 0
    budget: Budget | None = None
    doubt = math.inf
    while True:
        status, count, pieces, doubted, doubt_until, events_full, panels_used = _run(tables, script)
        if not script.size and not math.isnan(doubted):
            doubt = doubted
        if status == BUFFER:
            length = min(16 * len(tables.segments), MOST_PANELS)
            tables = Tables(tables.cell, tables.events, np.empty(length, SEGMENT))
        elif events_full and len(tables.events) < most_events:  # not where the panels are used up
            length = min(4 * len(tables.events), most_events)
            tables = Tables(tables.cell, np.empty(length, EVENT), tables.segments)
        elif panels_used:
            if not script.size:
                break
            script, decisions = NO_SCRIPT, MOST  # the last of its events may lie beyond what the panels reach
        elif decisions < MOST and not math.isnan(doubt_until) and doubt_until <= latest(scenario):
            # later doubts are decided together, so that each is not solved for from the start anew
            decisions += 1
            budget = Budget(steps_allowed(scenario)) if budget is None else budget
            until = min(doubt_until * (1.0 if decisions == 1 else 1.5), latest(scenario))
            found = script_until(scenario, until, budget)
            if not found.size or len(found) > most_events:
                break
            script = found
        else:
            break
    events, segments = first_rows(tables.events, count), first_rows(tables.segments, pieces)
    if len(script) > 1:
        segments = np.concatenate((segments_of_script(scenario.to_body(), script), segments))
        pieces = len(segments)
    if pieces == 0:  # the motion ends at its start: a piece of no length holds its state
        segments = np.empty(1, SEGMENT)
        _hold_at(events[count - 1], segments[0])
    return status, events, segments, script, doubt


def segments_of_script(body: Body, script: np.ndarray) -> np.ndarray:
    """The segments of the phases between the events of a script.

    Parameters
    ----------
    body : Body
    script : ndarray of records.EVENT, shape (n,)
        In kernel units [1].

    Returns
    -------
    segments : ndarray of records.SEGMENT, shape (k,)
        In kernel units [1]; `run` does not write them when it repeats the script.
    """
    from hophoop.records.scratch import new_scratch
    from hophoop.rigid.script import fill_script

    length = FIRST_SEGMENTS
    while True:
        segments = np.empty(length, SEGMENT)
        with np.errstate(all="ignore"):
            count = fill_script(body, script, segments, new_scratch())
        if count >= 0:
            return first_rows(segments, count)
        length *= 16


def _hold_at(event: np.void, segment: np.void) -> None:
    from hophoop.panels.panel import FLY

    for name in segment.dtype.names or ():
        segment[name] = event[name] if name in (event.dtype.names or ()) else 0
    segment["t_end"] = event["t"]
    segment["mode"] = event["after_mode"]
    segment["kind"] = FLY  # as it is, without forces: what they would be is not known
