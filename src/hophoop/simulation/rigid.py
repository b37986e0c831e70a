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
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.cells import CELL
from hophoop.kernel.records.layout import COLUMNS, EVENT, MOST_PANELS, SEGMENT, Outcome, Tables, first_rows, new_table
from hophoop.scenario import Scenario
from hophoop.scenario.scenario import cell_of, to_body
from hophoop.simulation.until import Until, cut, end_of

FIRST_EVENTS, FIRST_SEGMENTS = 64, 256


class _Own(threading.local):
    """Tables of this thread into which every motion is written first; the results are copied from them."""

    def __init__(self) -> None:
        self.tables = Tables(
            np.ndarray((len(CELL), 1), float, bytearray(8 * len(CELL))),
            new_table(FIRST_EVENTS, EVENT),
            new_table(FIRST_SEGMENTS, SEGMENT),
        )


_own = _Own()
_run: Callable[[Tables], Outcome] = compiled("hophoop.kernel.rigid.run.run_cell")
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

    until: What ends the motion before its duration.
    """
    return _simulated(scenario) if until is None else _simulated_until(scenario, until)


def _simulated_until(scenario: Scenario, until: Until) -> RigidMotion:
    """Compute as many events as are needed, and cut the motion."""
    whole, most = scenario.contact.max_events, FIRST_EVENTS
    while True:
        brief = scenario if whole <= most else scenario.replace("contact.max_events", most)
        motion = _simulated(brief)
        found = cut(until, motion.events, motion.segments, partial(sampled, scenario, motion.segments))
        if found is not None:
            doubt = motion.doubt if motion.doubt <= found[0]["t"][-1] else math.inf
            return RigidMotion(Status.COMPLETED, found[0], found[1], doubt)
        if not (motion.status == Status.EVENT_LIMIT and len(motion.events) == most < whole):
            return motion
        most = min(4 * most, whole)


def _simulated(scenario: Scenario) -> RigidMotion:
    """Run the kernel, with larger tables until they are long enough."""
    tables = _own.tables
    _fill(tables.cell.base, 0, *cell_of(scenario))
    while True:
        outcome = _run(tables)
        if outcome.status == Status.BUFFER:
            tables = tables._replace(segments=new_table(min(16 * len(tables.segments), MOST_PANELS), SEGMENT))
        elif outcome.events_full and len(tables.events) < scenario.contact.max_events:
            tables = tables._replace(events=new_table(min(4 * len(tables.events), scenario.contact.max_events), EVENT))
        else:
            break
    events, segments = first_rows(tables.events, outcome.events), first_rows(tables.segments, outcome.segments)
    doubt = math.inf if math.isnan(outcome.doubt) else outcome.doubt
    return RigidMotion(outcome.status, events, segments if len(segments) else end_of(events, False), doubt)


def sampled(scenario: Scenario, segments: np.ndarray, times: np.ndarray, left: bool = False) -> np.ndarray:
    """Sample the motion of a scenario into a new array."""
    out = np.empty((times.size, len(COLUMNS)))
    _sample(to_body(scenario.hoop, scenario.plane), segments, times, left, out)
    return out
