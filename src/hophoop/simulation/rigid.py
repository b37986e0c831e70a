"""Rigid motions: from a scenario to the kernel's tables, and states at any time."""

from __future__ import annotations

import math
import struct
import threading
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from hophoop.kernel.native import compiled
from hophoop.kernel.physics.body import Body, Status
from hophoop.kernel.records.layout import CELL, EVENT, MOST_PANELS, SEGMENT, Outcome, Tables, first_rows, new_table
from hophoop.kernel.rigid.columns import COLUMNS
from hophoop.scenario import Scenario
from hophoop.scenario.scenario import cell_of, to_body
from hophoop.simulation.exact_start import NO_SCRIPT, Decisions
from hophoop.simulation.until import Until, cut

FIRST_EVENTS, FIRST_SEGMENTS = 64, 256
BUFFER, EVENT_LIMIT, COMPLETED = (int(status) for status in (Status.BUFFER, Status.EVENT_LIMIT, Status.COMPLETED))


class _Own(threading.local):
    """Tables of this thread into which every motion is written first; the results are copied from them."""

    def __init__(self) -> None:
        self.tables = Tables(
            np.ndarray((len(CELL), 1), float, bytearray(8 * len(CELL))),
            new_table(FIRST_EVENTS, EVENT),
            new_table(FIRST_SEGMENTS, SEGMENT),
        )


_own = _Own()
_run: Callable[[Tables, np.ndarray], Outcome] = compiled("hophoop.kernel.rigid.run.run_cell")
_sample = compiled("hophoop.kernel.rigid.sampling.sample")
_fill = struct.Struct(f"{len(CELL)}d").pack_into  # 5 times as fast as assignment


class RigidMotion(NamedTuple):
    """A motion in units of R, m and √(R/g)."""

    status: int
    events: np.ndarray
    segments: np.ndarray
    doubt: float  # time from which double precision does not suffice; inf if it always does


def simulate_rigid(scenario: Scenario, until: Until | None = None) -> RigidMotion:
    """Compute the motion of a scenario with rigid contact.

    Parameters
    ----------
    scenario : Scenario
    until : Until, optional
        What ends the motion before its duration.

    Returns
    -------
    motion : RigidMotion
    """
    return _simulated(scenario) if until is None else _simulated_until(scenario, until)


def _simulated_until(scenario: Scenario, until: Until) -> RigidMotion:
    """Compute as many events as are needed, and cut the motion; only doubts before its end are decided."""
    whole, most = scenario.contact.max_events, FIRST_EVENTS
    decides = False
    while True:
        brief = scenario if whole <= most else scenario.replace("contact.max_events", most)
        motion = _simulated(brief, decides)
        found = cut(until, motion.events, motion.segments, partial(sampled, scenario, motion.segments))
        if found is None and motion.status == EVENT_LIMIT and len(motion.events) == most < whole:
            most = min(4 * most, whole)
        elif not decides and motion.doubt <= (motion.events if found is None else found[0])["t"][-1]:
            decides = True
        elif found is None:
            return motion
        else:
            events, segments = found
            end = events["t"][-1]
            return RigidMotion(
                COMPLETED,
                events,
                segments if len(segments) else _held(events),
                motion.doubt if motion.doubt <= end else math.inf,
            )


def _simulated(scenario: Scenario, decides: bool = True) -> RigidMotion:
    if scenario.start.mode is not None:
        return _continued(scenario, decides)
    outcome, tables, script = _ran(scenario, NO_SCRIPT)
    doubt = math.inf if math.isnan(outcome.doubt) else outcome.doubt
    if decides and not (math.isnan(outcome.doubt_until) or outcome.panels_used):
        outcome, tables, script = _decided(scenario, outcome, tables)
    return _finished(scenario, (outcome, tables, script), doubt)


def _finished(scenario: Scenario, found: tuple[Outcome, Tables, np.ndarray], doubt: float) -> RigidMotion:
    """Return a motion from the tables of the kernel and the script that it was given."""
    outcome, tables, script = found
    events, segments = first_rows(tables.events, outcome.events), first_rows(tables.segments, outcome.segments)
    if len(script) > 1:
        segments = np.concatenate((segments_of_script(scenario.to_body(), script), segments))
    if not len(segments):
        segments = _held(events)
    return RigidMotion(outcome.status, events, segments, doubt)


def _continued(scenario: Scenario, decides: bool) -> RigidMotion:
    """Compute a motion that goes on from another one; if a doubt is to be decided, in extended precision from the state."""
    from hophoop.simulation.restart import continued

    found = continued(scenario)
    segments = found.segments if len(found.segments) else _held(found.events)
    motion = RigidMotion(found.status, found.events, segments, math.inf if math.isnan(found.doubt) else found.doubt)
    if decides and not math.isnan(found.doubt_until):
        script = Decisions(scenario).script(found.doubt_until)
        if script is not None:
            return _finished(scenario, _ran(scenario, script), motion.doubt)
    return motion


def _ran(scenario: Scenario, script: np.ndarray) -> tuple[Outcome, Tables, np.ndarray]:
    """Run the kernel, with larger tables until they are long enough."""
    tables = _own.tables
    _fill(tables.cell.base, 0, *cell_of(scenario))
    while True:
        outcome = _run(tables, script)
        if outcome.status == BUFFER:
            tables = tables._replace(segments=new_table(min(16 * len(tables.segments), MOST_PANELS), SEGMENT))
        elif outcome.events_full and len(tables.events) < scenario.contact.max_events:  # not if the panels are used up
            tables = tables._replace(events=new_table(min(4 * len(tables.events), scenario.contact.max_events), EVENT))
        else:
            return outcome, tables, script


def _decided(scenario: Scenario, outcome: Outcome, tables: Tables) -> tuple[Outcome, Tables, np.ndarray]:
    """Decide the doubts of a motion in extended precision, one after the other."""
    found = outcome, tables, NO_SCRIPT
    decisions = Decisions(scenario)
    while (script := decisions.script(found[0].doubt_until)) is not None:
        found = _ran(scenario, script)
        if found[0].panels_used:  # the last event may be beyond the reach of the panels
            return _ran(scenario, NO_SCRIPT)
    return found


def script_of(scenario: Scenario) -> np.ndarray:
    """Return the first events of a motion that double precision does not decide.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.

    Returns
    -------
    script : ndarray of records.EVENT, shape (n,)
        In kernel units; length 0 if double precision decides everything [1].
    """
    outcome, tables, script = _ran(scenario, NO_SCRIPT)
    if math.isnan(outcome.doubt_until) or outcome.panels_used:
        return script
    return _decided(scenario, outcome, tables)[2]


def segments_of_script(body: Body, script: np.ndarray) -> np.ndarray:
    """Return the segments of the phases between the events of a script.

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
    from hophoop.kernel.records.scratch import new_scratch
    from hophoop.kernel.rigid.script import fill_script

    length = FIRST_SEGMENTS
    while True:
        segments = new_table(length, SEGMENT)
        with np.errstate(all="ignore"):
            count = fill_script(body, script, segments, new_scratch())
        if count >= 0:
            return first_rows(segments, count)
        length *= 16


def _held(events: np.ndarray) -> np.ndarray:
    """Return a segment of zero length with the state of a motion that ends at its start."""
    from hophoop.kernel.panels.panel import FLY

    segments = np.empty(1, SEGMENT)
    event, segment = events[-1], segments[0]
    for name in segment.dtype.names or ():
        segment[name] = event[name] if name in (event.dtype.names or ()) else 0
    segment["t_end"] = event["t"]
    segment["mode"] = event["after_mode"]
    segment["kind"] = FLY  # flight has no contact forces; those of the true mode are not known
    return segments


def sampled(scenario: Scenario, segments: np.ndarray, times: np.ndarray, left: bool = False) -> np.ndarray:
    """Sample the motion of a scenario into a new array."""
    out = np.empty((times.size, len(COLUMNS)))
    _sample(to_body(scenario.hoop, scenario.plane), segments, times, left, out)
    return out
