"""Rigid motions: from a scenario to the kernel's tables, and states at any time."""

from __future__ import annotations

import math
import struct
import threading
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from hophoop.kernel.model import Status, slip_direction
from hophoop.kernel.native import compiled
from hophoop.kernel.records import (
    CELL,
    COLUMNS,
    EVENT,
    FLY,
    MOST_PANELS,
    SEGMENT,
    Outcome,
    Tables,
    Until,
    first_rows,
    new_table,
)
from hophoop.scenario import Scenario
from hophoop.scenario.scenario import cell_of, to_body
from hophoop.simulation.until import NOTHING

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
_run: Callable[[Tables, Until], Outcome] = compiled("hophoop.kernel.rigid.run.run_cell")
_sample = compiled("hophoop.kernel.rigid.sampling.sample")
_fill = struct.Struct(f"{len(CELL)}d").pack_into  # 5 times as fast as assignment


class RigidMotion(NamedTuple):
    """A motion in units of R, m and √(R/g)."""

    status: int
    events: np.ndarray
    segments: np.ndarray
    doubt: float  # time from which double precision does not suffice; inf if it always does


def simulate_rigid(scenario: Scenario, until: Until = NOTHING) -> RigidMotion:
    """Compute the motion of a scenario with rigid contact, in larger tables until they are long enough.

    until: What ends the motion before its duration.
    """
    tables = _own.tables
    _fill(tables.cell.base, 0, *cell_of(scenario))
    while True:
        outcome = _run(tables, until)
        if outcome.status == Status.BUFFER:
            tables = tables._replace(segments=new_table(min(16 * len(tables.segments), MOST_PANELS), SEGMENT))
        elif outcome.events_full and len(tables.events) < scenario.contact.max_events:
            tables = tables._replace(events=new_table(min(4 * len(tables.events), scenario.contact.max_events), EVENT))
        else:
            break
    events, segments = first_rows(tables.events, outcome.events), first_rows(tables.segments, outcome.segments)
    doubt = math.inf if math.isnan(outcome.doubt) else outcome.doubt
    if not len(segments):  # a limit ended the motion before any time passed
        segments = _end_of(events)
    return RigidMotion(outcome.status, events, segments, doubt)


def _end_of(events: np.ndarray) -> np.ndarray:
    """Return a segment of zero length with the state after the last event, shape (1,), as `kernel.rigid.run.write_end` does."""
    last = np.zeros(1, SEGMENT)
    for name in set(SEGMENT.names or ()).intersection(EVENT.names or ()) - {"kind"}:
        last[name] = events[name][-1]
    mode = int(events["after_mode"][-1])
    last["t_end"], last["mode"], last["sigma"], last["kind"] = events["t"][-1], mode, slip_direction(mode), FLY
    last["direction"] = np.sign(last["omega"])
    return last


def sampled(scenario: Scenario, segments: np.ndarray, times: np.ndarray, left: bool = False) -> np.ndarray:
    """Sample the motion of a scenario into a new array."""
    out = np.empty((times.size, len(COLUMNS)))
    _sample(to_body(scenario.hoop, scenario.plane), segments, times, left, out)
    return out
