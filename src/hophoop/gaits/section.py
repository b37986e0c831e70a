"""Derivatives of the return map: how a passage of the section changes with the state at an earlier one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import cast

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.layout import OM, PARAMETERS, REASONS, STATE_ROWS, TH, VN, VT, Reason
from hophoop.derivatives.parameters import Directions, directions_of
from hophoop.derivatives.pieces.flight_and_rest import accelerations
from hophoop.derivatives.results.propagation import propagated
from hophoop.derivatives.workspace import KnownMotion
from hophoop.gaits.computing import check, passages
from hophoop.gaits.kernels.layout import COLUMNS
from hophoop.gaits.results import Lyapunov, Passages
from hophoop.kernel.native import compiled
from hophoop.kernel.panels.anchor import NONE
from hophoop.kernel.physics.body import MODE_LETTERS, Event, Mode
from hophoop.kernel.records.layout import EVENT, SEGMENT, thread_scratch
from hophoop.kernel.records.state import State
from hophoop.kernel.records.writing import state_of
from hophoop.kernel.rigid.run import run
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario

Floats = NDArray[np.float64]
MOST_EVENTS, MOST_SEGMENTS = 1024, 8192  # of one passage to the next
BEYOND = 1e-6  # relative time by which a passage to a landing is computed further
ON_SECTION = 1e-9  # rad: within it a start is on the section
BATCHES = 20
TRANSIENT = 0.1  # share of the passages that is left out of the Lyapunov exponent

NO_CHANGES = np.zeros((PARAMETERS, 0))

# Coordinates of the section: row of the derivatives, name and quantity.
_ROWS = {"omega": OM, "slip": VT, "angle": TH, "vy": VN}


@dataclass(frozen=True)
class SectionDerivative:
    """Derivative of the state at a passage with respect to the state at an earlier one.

    Attributes
    ----------
    matrix : ndarray, shape (rows, columns)
        In SI units; towards larger values of the coordinates where both sides differ. nan where there is none.
    backward : ndarray, shape (rows, columns)
        The same towards smaller values; equal to `matrix` except at corners of the map.
    rows : tuple of str
        Coordinates of the later passage: 'omega' [rad/s] in rolling at the bottom, with 'slip' [m/s] in slip; at a landing
        'angle' [rad], 'omega', 'slip' and 'vy' [m/s], as far as its mode leaves them free.
    columns : tuple of str
        Those of the earlier one.
    reason : str
        Why there is no derivative; empty if there is one.
    """

    matrix: Floats
    backward: Floats
    rows: tuple[str, ...]
    columns: tuple[str, ...]
    reason: str

    @property
    def one_sided(self) -> bool:
        """Whether the map has a corner here."""
        return not np.array_equal(self.matrix, self.backward, equal_nan=True)

    @cached_property
    def multipliers(self) -> Floats | NDArray[np.complex128]:
        """Eigenvalues, the largest modulus first, complex only in pairs; for a whole period of a gait its multipliers.

        Raises
        ------
        ValueError
            If both passages have different coordinates.
        """
        if self.rows != self.columns:
            raise InputError(f"multipliers need equal coordinates at both passages, not {self.columns} and {self.rows}.")
        if not np.isfinite(self.matrix).all():
            return np.full(len(self.rows), math.nan)
        found = cast("Floats | NDArray[np.complex128]", np.linalg.eigvals(self.matrix))
        return found[np.argsort(-np.abs(found), kind="stable")]


def coordinates(section: str, mode: int) -> tuple[str, ...]:
    """Return the names of the coordinates that a passage leaves free, by section and mode."""
    free = ("omega",) if section == "bottom" else ("angle", "omega")
    if mode == Mode.ROLL:
        return free
    return (*free, "slip", "vy") if mode == Mode.FLIGHT else (*free, "slip")


def change_of(found: Passages, index: int, names: tuple[str, ...], before: Floats) -> Floats:
    """Return the coordinates of a passage less others, both in units of R and √(R/g), angles within half a revolution."""
    unit = Units.of_scenario(found.scenario)
    off: Floats = np.array([float(getattr(found, name)[index]) / unit.of(name) for name in names]) - before
    if names[0] == "angle":
        off[0] = math.remainder(off[0], 2.0 * math.pi)
    return off


def derivative(scenario: Scenario, passages_on: int = 1, *, section: str = "bottom") -> SectionDerivative:
    """Return the derivative of the return map at a scenario's start.

    Parameters
    ----------
    scenario : Scenario
        Its start is on the section: the load at the bottom (θ = π) in contact, or a state just after a landing.
    passages_on : int, default 1
        How many passages further [1].
    section : {'bottom', 'landing'}, default 'bottom'
        As in `hophoop.passages`.

    Returns
    -------
    derivative : SectionDerivative

    Raises
    ------
    ValueError
        If the start is not on the section, or the motion has no such passage.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> start = hh.Start.rolling(3.4081869457017134, angle=math.pi)
    >>> gait = hh.Scenario(plane=hh.Plane(slope=math.radians(1), gravity=1.0), start=start)
    >>> round(float(hh.gaits.derivative(gait).matrix[0, 0]), 9)
    0.610983568
    """
    check(scenario, section)
    start = scenario.start.state(scenario.hoop)
    off = math.remainder(start.angle - math.pi, 2.0 * math.pi)
    if section == "bottom" and (abs(off) > ON_SECTION or start.height != 0.0 or start.vy != 0.0):
        raise InputError("start.angle must be pi, with start.height = start.vy = 0: the section is the load at the bottom.")
    if section == "landing" and start.height != 0.0:
        raise InputError.of_field("start.height", start.height, "0: the section is just after a landing")
    if section == "landing" and start.vy < 0.0:
        raise InputError.of_field("start.vy", start.vy, "at least 0: the section is just after a landing")
    found = passages(scenario, passages_on, section=section)
    if len(found) < passages_on:
        raise InputError(f"passages_on = {passages_on} must be at most {len(found)}: the motion passes its section no more.")
    return _over(found, -1, passages_on)


def derivative_over(found: Passages, index: int, further: int) -> SectionDerivative:
    """Return how the passage `further` ones after one changes with the state there; refuse passages that are not computed."""
    if further < 1 or not 0 <= index < len(found) - further:
        raise InputError(f"passages from {index} on by {further} must be among the {len(found)} computed.")
    return _over(found, index, further)


def _over(found: Passages, index: int, further: int) -> SectionDerivative:
    """The product of the derivatives from passage to passage, in SI units; index −1 is the start."""
    forward, rows, columns, reason = _product(found, index, further, 1.0)
    backward = _product(found, index, further, -1.0)[0]
    unit = Units.of_scenario(found.scenario)
    scale = np.array([unit.of(name) for name in rows])[:, None] / np.array([unit.of(name) for name in columns])
    return SectionDerivative(forward * scale, backward * scale, rows, columns, reason)


def _product(found: Passages, index: int, further: int, sign: float) -> tuple[Floats, tuple[str, ...], tuple[str, ...], str]:
    """Return what `_step` does, over several passages; a corner further on is passed on the side that the change leads to."""
    matrix, rows, columns, reason = _step(found, index, sign)
    for k in range(index + 1, index + further):
        side = math.copysign(1.0, sign * matrix[0, 0]) if matrix.size == 1 else 1.0
        step, rows, _, why = _step(found, k, side)
        matrix, reason = step @ matrix, reason or why
    return matrix, rows, columns, reason


def parameter_rates(found: Passages, path: str) -> tuple[Floats, Floats]:
    """Return the rates of the coordinates at the last passage by those at the start, and by a parameter, or nan.

    In units of R and √(R/g), by the parameter per SI unit.
    """
    directions = check_no_unit(found.scenario, path)
    matrix, rates = np.eye(1), np.zeros(1)
    for index in range(-1, len(found) - 1):
        step, _, columns, _ = _step(found, index, 1.0, directions.parameter_tangents)
        before, change = step[:, : len(columns)], step[:, len(columns)]
        matrix, rates = (before, change) if index < 0 else (before @ matrix, before @ rates + change)
    return matrix, rates


def check_no_unit(scenario: Scenario, path: str) -> Directions:
    """Return the direction of a parameter in which derivatives are taken; refuse one that changes the units R and √(R/g)."""
    directions = directions_of(scenario, [path])
    if directions.units.any():
        raise InputError.of_field("path", path, "a parameter other than hoop.radius, hoop.mass and plane.gravity")
    return directions


def _row_of(found: Passages, index: int) -> Floats:
    return found.first if index < 0 else found.numbers[index]


def _state_of(row: Floats) -> State:
    """Return the state of a passage, at t = 0."""
    x, y, turns, th, th_low, vt, vn, om = (
        float(row[COLUMNS.index(name)]) for name in ("x", "height", "turns", "theta", "theta_low", "slip", "vy", "omega")
    )
    return State(0.0, 0.0, x, 0.0, y, turns, th, th_low, vt, vn, om, 0.0, 0.0, 0.0, 0.0, NONE)


def _mode_of(found: Passages, index: int) -> int:
    if index >= 0:
        return int(found.numbers[index, COLUMNS.index("mode")])
    if found.scenario.start.mode is not None:
        return MODE_LETTERS.index(found.scenario.start.mode)
    return MODE_LETTERS.index(found.sequences[0][0]) if len(found) and found.sequences[0] else 0


def _step(
    found: Passages, index: int, sign: float, changes: Floats = NO_CHANGES
) -> tuple[Floats, tuple[str, ...], tuple[str, ...], str]:
    """Return (matrix in kernel units, its rows, its columns, why it does not exist) from a passage to the next one.

    Behind the columns of the state, the matrix has one for each column of `changes` of the parameters.
    """
    body, landing = found.scenario.to_body(), found.section == "landing"
    before, after = _row_of(found, index), found.numbers[index + 1]
    mode, last_mode = _mode_of(found, index), int(after[COLUMNS.index("mode")])
    clock, low = COLUMNS.index("t"), COLUMNS.index("t_low")
    lasts = (after[clock] - before[clock]) + (after[low] - before[low])
    t_end = lasts * (1.0 + BEYOND) if landing else lasts
    events, segments, scratch = np.empty(MOST_EVENTS, EVENT), np.empty(MOST_SEGMENTS, SEGMENT), thread_scratch()
    _, count, pieces = _run(body, _state_of(before), mode, t_end, math.nan, 0, events, segments, scratch)
    events, segments = events[:count], segments[:pieces]
    if landing:
        collided = (events["kind"] == Event.BOUNCE_LIMIT) | ((events["kind"] == Event.IMPACT) & (events["collision"] == 1))
        events = events[: int(np.flatnonzero(collided)[-1]) + 1] if collided.any() else events[:0]
    columns, rows = coordinates(found.section, mode), coordinates(found.section, last_mode)
    width = len(columns) + changes.shape[1]
    if not len(events):  # it lands as it starts, in bounces that vanish
        return np.full((len(rows), width), math.nan), rows, columns, REASONS[Reason.GRAZE]
    tangents, parameters = np.zeros((STATE_ROWS, width)), np.zeros((PARAMETERS, width))
    for place, name in enumerate(columns):
        tangents[_ROWS[name], place] = sign
    parameters[:, len(columns) :] = sign * changes
    solution = propagated(body, KnownMotion(events, segments, float(events["t"][-1]), math.inf), parameters, tangents)
    last = sign * solution.at_events[-1]
    if not landing:
        state = state_of(events[-1])
        turning, along, *_ = accelerations(body, last_mode, state, math.copysign(1.0, state.om))
        dt = -last[TH] / state.om
        last = last.copy()
        last[OM] += turning * dt
        last[VT] += along * dt
    failed = [REASONS[Reason(why)] for why in solution.reasons.tolist() if why > 0]
    return np.array([last[_ROWS[name]] for name in rows]), rows, columns, failed[0] if failed else ""


def lyapunov_of(found: Passages) -> Lyapunov:
    """Return the mean rate at which near motions separate, by the derivatives from passage to passage; nan without two."""
    first = int(TRANSIENT * len(found))
    vector: Floats | None = None
    growth = []
    for index in range(first, len(found) - 1):
        matrix, _, columns, _ = _step(found, index, 1.0)
        if vector is None or len(vector) != len(columns):
            vector = np.ones(len(columns)) / math.sqrt(len(columns))
        changed = matrix @ vector
        size = float(np.linalg.norm(changed))
        if not 0.0 < size < math.inf:
            vector = None
            continue
        growth.append(math.log(size))
        vector = changed / size
    if len(growth) < 2:
        return Lyapunov(math.nan, math.nan, len(growth))
    batches = [float(np.mean(batch)) for batch in np.array_split(growth, min(BATCHES, len(growth)))]
    return Lyapunov(float(np.mean(growth)), float(np.std(batches, ddof=1)) / math.sqrt(len(batches)), len(growth))


_run = compiled(run)
