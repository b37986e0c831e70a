"""Motions with compliant contact: from a scenario to the kernel's tables, and states at any time."""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.compliant import (
    COLUMNS,
    FIRST,
    FLY,
    KIND,
    MAX_STEPS,
    MODE,
    OM,
    REGIME,
    RESTING,
    REVOLUTIONS,
    RTOL,
    SEGMENT,
    SIZE,
    STAGES,
    TH,
    VN,
    VT,
    WIDTH,
    X,
    Y,
    compliance_of,
    load_contact,
    run,
    sample,
)  # fmt: skip
from hophoop.kernel.model import Body, Compliance, Mode, Status
from hophoop.kernel.native import compiled
from hophoop.kernel.records import EVENT
from hophoop.scenario import Compliant, Scenario
from hophoop.scenario.scenario import contact_of, time_unit, to_body

FIRST_EVENTS = 256
FIRST_ROWS = 20_000  # 9 MB, of which the system only provides the part that is written


def simulate_compliant(scenario: Scenario, reached: np.ndarray | None = None) -> tuple[int, np.ndarray, np.ndarray]:
    """Compute the motion of a scenario with compliant contact.

    scenario: Its contact is Compliant; reached: shape (1,), Progress: the computed fraction of the duration is written here
    repeatedly [1]; status: A Status; segments: Both in units of R, m and √(R/g).
    """
    body, comp, t_end, rtol = to_compliance(scenario)
    start, touching = to_start(scenario, body, comp)
    limit = scenario.contact.max_events
    size = min(FIRST_EVENTS, limit)
    reached = np.zeros(1) if reached is None else reached
    room = FIRST_ROWS
    while True:
        events = np.empty(size, EVENT)
        rows = np.empty((room, WIDTH))
        status, count, pieces = compiled(run)(body, comp, start, touching, t_end, rtol, MAX_STEPS, events, rows, reached)
        if pieces > room:
            room = MAX_STEPS
            continue
        if status != Status.EVENT_LIMIT or count < size or size == limit:
            break
        size = min(8 * size, limit)
    if pieces == 0:  # the limit was reached before any time passed: a segment of zero length holds the start
        pieces = 1
        rows[0] = 0.0
        last = events[count - 1]
        rows[0, KIND] = RESTING if touching else FLY
        rows[0, MODE] = mode = last["after_mode"]
        rows[0, REGIME] = float(mode == Mode.SKID) - float(mode == Mode.SPIN)
        rows[0, REVOLUTIONS] = last["revolutions"]
        rows[0, FIRST :: STAGES + 1] = start
        rows[0, FIRST + TH * (STAGES + 1)] = last["theta"]
    segments = np.ascontiguousarray(rows[:pieces]).view(SEGMENT)[:, 0]
    return status, events[:count].copy(), segments


def to_compliance(scenario: Scenario) -> tuple[Body, Compliance, float, float]:
    """Return the kernel's parameters of a scenario with compliant contact.

    scenario: Its contact is Compliant; compliance: With all defaults filled in; rtol: All in units of R, m and √(R/g).
    """
    contact, hoop, plane = scenario.contact, scenario.hoop, scenario.plane
    assert isinstance(contact, Compliant)
    second = time_unit(hoop, plane)
    body = to_body(hoop, plane)
    law, friction, *given, rtol = contact_of(contact)
    compliance: Compliance = compliance_of(body, hoop.radius, second, hoop.mass, int(law), int(friction), *given)
    return body, compliance, scenario.duration / second, RTOL if math.isnan(rtol) else rtol


def to_start(scenario: Scenario, body: Body, comp: Compliance) -> tuple[np.ndarray, bool]:
    """Return the start in kernel units, and whether the contact acts there.

    start: shape (SIZE,).
    """
    hoop = scenario.hoop
    second = time_unit(hoop, scenario.plane)
    speed = hoop.radius / second
    given = scenario.start.state(hoop)
    start = np.zeros(SIZE)
    start[X] = given.x / hoop.radius
    start[Y] = given.height / hoop.radius
    start[TH] = given.angle
    start[VT] = given.slip / speed
    start[VN] = given.vy / speed
    start[OM] = given.omega * second
    touching: bool = load_contact(body, comp, start)
    return start, touching


def sampled(scenario: Scenario, segments: np.ndarray, times: np.ndarray, left: bool) -> np.ndarray:
    """Sample the motion of a scenario into a new array."""
    body, comp, _, _ = to_compliance(scenario)
    rows = np.ascontiguousarray(segments).view(np.float64).reshape(len(segments), WIDTH)
    out = np.empty((times.size, len(COLUMNS)))
    compiled(sample)(body, comp, rows, times, left, out)
    return out
