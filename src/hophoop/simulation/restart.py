"""Motions that go on from a state of another one: the phase of the state is computed again from its start, bit for bit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.double_double import TWO_PI, add
from hophoop.kernel.physics.body import PASSING, Event, Status
from hophoop.kernel.records.cells import second_of, start_of
from hophoop.kernel.records.layout import EVENT, EVENTS, MOST_PANELS, SEGMENT, first_rows, new_table
from hophoop.kernel.records.scratch import thread_scratch
from hophoop.kernel.records.state import whole_angle
from hophoop.kernel.records.writing import state_of, write_state
from hophoop.kernel.rigid.columns import COLUMNS
from hophoop.kernel.rigid.continued import continue_motion
from hophoop.kernel.rigid.sampling import sample
from hophoop.results.records import Side
from hophoop.results.units import Units
from hophoop.scenario import Scenario, cell_of, time_unit
from hophoop.scenario.start import PHASE_START
from hophoop.vocabulary.modes import MODE_LETTERS

if TYPE_CHECKING:
    from hophoop.simulation.trajectory import Trajectory

IMPACT, BOUNCE_LIMIT, SLIP_REVERSAL, START, END = (
    int(kind) for kind in (Event.IMPACT, Event.BOUNCE_LIMIT, Event.SLIP_REVERSAL, Event.START, Event.END)
)
BUFFER, COMPLETED, AT_REST = (int(status) for status in (Status.BUFFER, Status.COMPLETED, Status.AT_REST))
PARADOXES = (int(Event.PAINLEVE_INCONSISTENT), int(Event.PAINLEVE_INDETERMINATE))
FIRST_EVENTS, FIRST_SEGMENTS = 64, 256
ROUNDED = 1e-11  # relative: differences of states that are rounding
LOSSES = ("friction", "impact_normal", "impact_tangential", "rolling_resistance")
STATE = ("x", "height", "angle", "vx", "vy", "omega", "slip")


class Continued(NamedTuple):
    """A motion that goes on from a state, in units of R, m and √(R/g)."""

    status: int
    events: np.ndarray
    segments: np.ndarray
    doubt: float  # time from which double precision does not suffice; nan if it always does
    doubt_until: float


def at_event(motion: Trajectory, index: int) -> dict[str, Any]:
    """Return slip, mode and exact of the start that goes on from an event.

    Parameters
    ----------
    motion : Trajectory
    index : int
        Of the event.

    Returns
    -------
    given : dict
        Arguments of `Start`; empty for a compliant motion, which starts from any state.
    """
    row = motion.tables["events"][index]
    return _restart(motion, index, int(row["after_mode"]), (float(row["t"]), float(row["t_low"])), float(row["slip"]))


def at_time(motion: Trajectory, t: float, side: Side) -> dict[str, Any]:
    """Return slip, mode and exact of the start that goes on from a time.

    Parameters
    ----------
    motion : Trajectory
    t : float
        [s].
    side : {'right', 'left'}
        At an event: after all events of that instant, or before the first one.

    Returns
    -------
    given : dict
        As `at_event`.
    """
    if motion.scenario.contact.model != "rigid":
        return {}
    events, segments = motion.tables["events"], motion.tables["segments"]
    at = float(motion.units.kernel_times(segments, np.array([t]))[0])
    before = events["t"] < at if side == "left" else events["t"] <= at
    before[0] = True
    last = int(np.flatnonzero(before)[-1])
    while last > 0 and events["kind"][last] == END:
        last -= 1
    found = motion.at(t, side)
    return _restart(motion, last, MODE_LETTERS.index(found.mode), (at, 0.0), found.slip / motion.units.of("slip"))


def _restart(motion: Trajectory, index: int, mode: int, t: tuple[float, float], slip: float) -> dict[str, Any]:
    """Return slip, mode and exact of the start that goes on after an event, at a time and in a mode."""
    if motion.scenario.contact.model != "rigid":
        return {}
    events, before = motion.tables["events"], motion.scenario.start.exact
    given = {"slip": slip * motion.units.of("slip"), "mode": MODE_LETTERS[mode]}
    if int(events["kind"][index]) in PARADOXES:  # what follows at the same instant starts the phase
        return {"slip": given["slip"]}
    same_phase = {*PASSING, END}
    if motion.scenario.plane.mu_kinetic == 0.0:  # what is conserved without friction is so in both directions of slip
        same_phase.add(SLIP_REVERSAL)
    first = index
    while first > 0 and int(events["kind"][first]) in same_phase:
        first -= 1
    landings = np.flatnonzero(np.isin(events["kind"][1 : first + 1], (IMPACT, BOUNCE_LIMIT)))
    bounce = before[_BOUNCE] if before is not None else 0.0
    if landings.size:
        bounce = float(events["vy"][1 + landings[-1]])
    numbers = tuple(float(events[name][first]) for name in PHASE_START)
    passed = float(index - first)
    if first == 0 and before is not None:  # still in the phase of the start
        numbers, passed = before[:_BOUNCE], passed + before[-1]
        t = add(before[_BOUNCE + 1 : _BOUNCE + 3], t)
    return given | {"exact": (*numbers, bounce, *t, passed)}


_STATE_COLUMNS = set(COLUMNS).intersection(EVENT.fields or ())
_BOUNCE = len(PHASE_START)  # its place in Start.exact


def from_state(motion: Trajectory) -> Trajectory:
    """Return a motion that goes on from another one, computed from the state of its start: for derivatives.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    motion : Trajectory
        The same within rounding, with segments that begin at its start.
    """
    from hophoop.simulation.simulate import simulate

    start = motion.scenario.start.model_copy(update={"exact": None})
    return simulate(motion.scenario.with_values({"start": start}), until=motion.until)


def continued(scenario: Scenario) -> Continued:
    """Compute a motion whose start goes on from another motion.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact, and a start with a mode.

    Returns
    -------
    motion : Continued
        From the start of its phase, if that leads to the state within rounding; else from the state in this mode.
    """
    start = scenario.start
    if start.exact is not None:
        given = dict(zip(PHASE_START, start.exact, strict=False))
        bounce, t, t_low, passed = start.exact[len(PHASE_START) :]
        first = np.zeros(1, EVENT)
        for name, value in given.items():
            first[name] = value
        found = _run(scenario, first, bounce, t)
        begin = _state_at(scenario, found, int(passed), (t, t_low))
        if begin is not None and _agree(scenario, begin):
            return _onward(scenario, found, begin, int(passed), (t, t_low))
    first = row_of_start(scenario)
    return _onward(scenario, _run(scenario, first, 0.0, 0.0), first, 0, (0.0, 0.0))


def row_of_start(scenario: Scenario) -> np.ndarray:
    """Return the state of a start with a mode as a START event.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    row : ndarray of records.EVENT, shape (1,)
        In kernel units [1].
    """
    cells = np.array(cell_of(scenario), float).reshape(-1, 1)
    state = start_of(cells, 0, second_of(cells, 0))
    row = np.zeros(1, EVENT)
    write_state(row[0], state)
    row["kind"], row["after_mode"] = START, MODE_LETTERS.index(str(scenario.start.mode))
    return row


def _run(scenario: Scenario, first: np.ndarray, bounce: float, begin: float) -> Continued:
    """Run the kernel from an event that starts a phase, with larger tables until they are long enough."""
    most, unit = scenario.contact.max_events, time_unit(scenario.hoop, scenario.plane)
    lengths = [FIRST_EVENTS, FIRST_SEGMENTS]
    scratch = thread_scratch()
    for name in ("vx", "angle"):
        first[name] = first["slip"] + first["omega"] if name == "vx" else whole_angle(state_of(first[0]))
    while True:
        events, segments = new_table(lengths[0], EVENT), new_table(lengths[1], SEGMENT)
        status, count, pieces = _continue(
            scenario.to_body(), bounce, begin + scenario.duration / unit, events, segments, scratch, np.append(first, first)
        )
        if status == BUFFER:
            lengths[1] = min(16 * lengths[1], MOST_PANELS)
        elif scratch.counts[EVENTS] < 0 and lengths[0] < most:
            lengths[0] = min(4 * lengths[0], most)
        else:
            return Continued(
                status,
                first_rows(events, count),
                first_rows(segments, pieces),
                float(scratch.doubt[0]),
                float(scratch.doubt[1]),
            )


def _state_at(scenario: Scenario, motion: Continued, passed: int, t: tuple[float, float]) -> np.ndarray | None:
    """Return the state of a motion at a time, after so many events, as a START event; None if it does not last so long."""
    events, segments = motion.events, motion.segments
    if passed >= len(events) or not len(segments) or not 0.0 <= t[0] <= segments["t_end"][-1]:
        return None
    row = events[passed : passed + 1].copy()
    if (row["t"][0], row["t_low"][0]) != t:
        found = np.empty((1, len(COLUMNS)))
        left = passed + 1 < len(events) and bool(events["t"][passed + 1] == t[0])
        _sample(scenario.to_body(), segments, np.array([t[0]]), left, found)
        for name, value in zip(COLUMNS, found[0].tolist(), strict=True):
            if name in _STATE_COLUMNS:
                row[name] = value
        row["turns"] = np.round((row["angle"] - row["theta"]) / TWO_PI)
        row["x_low"] = 0.0
    row["kind"], row["before_mode"], row["collision"], row["stable"] = START, -1, -1, -1
    return row


def _agree(scenario: Scenario, row: np.ndarray) -> bool:
    """Return True if a state is that of the scenario's start, within rounding.

    A state at the very end of a motion differs in its last bits, because the last panel is fitted to the end.
    """
    start, unit = scenario.start, Units.of_scenario(scenario)
    for name in STATE:
        found, wanted = float(row[name][0]), getattr(start, name) / unit.of(name)
        if not abs(found - wanted) <= ROUNDED * (1.0 + abs(wanted)):
            return False
    return MODE_LETTERS[int(row["after_mode"][0])] == start.mode


def _onward(scenario: Scenario, motion: Continued, begin: np.ndarray, passed: int, t: tuple[float, float]) -> Continued:
    """Return the part of a motion after a state, with times and losses counted from there."""
    events = np.append(begin, motion.events[passed + 1 :])
    events["t"][0], events["t_low"][0] = t
    for name in ("vx", "vy", "omega", "slip"):
        events[f"before_{name}"][0] = events[name][0]
    for name in ("impulse_normal", "impulse_tangential", "gain"):
        events[name][0] = 0.0
    segments = motion.segments[motion.segments["t_end"] > t[0]] if len(motion.segments) else motion.segments
    last = events["t"][-1] == t[0] + scenario.duration / time_unit(scenario.hoop, scenario.plane)
    lost = {name: float(begin[name][0]) for name in LOSSES}
    for table in (events, segments):
        for name, value in lost.items():
            table[name] -= value
        _shift(table, "t", t)
        if table is segments:
            table["t_end"] -= t[0]
    if last and motion.status in (COMPLETED, AT_REST):
        whole = scenario.duration / time_unit(scenario.hoop, scenario.plane)
        events["t"][-1], events["t_low"][-1] = whole, 0.0
        segments["t_end"][-1:] = whole
    return Continued(motion.status, events, segments, motion.doubt - t[0], motion.doubt_until - t[0])


def _shift(table: np.ndarray, name: str, by: tuple[float, float]) -> None:
    """Subtract a double-double from a column of them."""
    high, low = add((table[name], table[f"{name}_low"]), (-by[0], -by[1]))
    table[name], table[f"{name}_low"] = high, low


_continue, _sample = compiled(continue_motion), compiled(sample)
