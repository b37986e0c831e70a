"""Phases of a record by one rule, the same for the truth and every engine.

1. The record is thinned to at most one state in 1/2048 s.
2. N, the mean normal force over 5 ms (over one interval of coarser records), follows from the change of the
   velocity of the centre of gravity; v̄, the mean slip velocity, from the same 5 ms.
3. An interval is flight (H) if N < 0.01 m g; else roll (R) if abs(v̄) ≤ 0.01 m/s; else slip, K for v̄ > 0 and S for v̄ < 0.
4. Intervals with one letter are a run. The shortest run below 20 ms is removed and its time divided between its neighbours,
   until no such run remains. Removed runs are counted as chatter.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np

from hophoop.engines.task import SPACING, Floats, States, Task
from hophoop.scenario import InputError

WINDOW = 0.005  # s
FREE = 0.01  # of m g
SLIP = 0.01  # m/s
SHORT = 0.020  # s


@dataclass(frozen=True)
class Phase:
    """A phase of one kind of contact.

    Attributes
    ----------
    letter : str
        R roll, S and K slip with v_t < 0 and > 0, H flight.
    begin, end : float
        [s].
    """

    letter: str
    begin: float
    end: float


def thin(states: States) -> States:
    """Thin a record to at most one state per 1/2048 s, so that all records are comparable.

    Parameters
    ----------
    states : States

    Returns
    -------
    states : States

    Raises
    ------
    ValueError
        If there are fewer than three states, a number is not finite, or the times do not increase from 0.
    """
    t = states.t
    if len(t) < 3:
        raise InputError(f"the record has {len(t)} states; it needs at least 3.")
    for name, column in zip(states._fields, states, strict=True):
        if len(column) != len(t):
            raise InputError(f"{name} has {len(column)} numbers and t has {len(t)}.")
        if not np.isfinite(column).all():
            raise InputError(f"{name} must be finite; state {int(np.argmin(np.isfinite(column)))} is not.")
    if abs(t[0]) > 1e-9 or not (np.diff(t) > 0).all():
        raise InputError("t must start at 0 and increase.")
    if np.diff(t).min() >= SPACING * (1 - 1e-6):
        return states
    kept, last = [0], t[0]
    for i, now in enumerate(t):
        if now - last >= SPACING * (1 - 1e-6):
            kept.append(i)
            last = now
    return States(*(column[kept] for column in states))


def slip_velocity(task: Task, states: States) -> Floats:
    """Return the velocity of the rim's lowest point along the plane.

    Parameters
    ----------
    task : Task
    states : States

    Returns
    -------
    slip : ndarray
        v_t [m/s].
    """
    result: Floats = states.vx - task.radius * states.omega
    return result


def rise(task: Task, states: States) -> Floats:
    """Return the velocity of the centre of gravity away from the plane.

    Parameters
    ----------
    task : Task
    states : States

    Returns
    -------
    rise : ndarray
        [m/s].
    """
    result: Floats = states.vy - task.arm * states.omega * np.sin(states.angle)
    return result


def normal_force(task: Task, states: States, window: float = 0.0) -> tuple[Floats, Floats]:
    """Return the mean normal force about the middle of each interval.

    Parameters
    ----------
    task : Task
    states : States
    window : float, default 0
        Averaging time; at least the interval [s].

    Returns
    -------
    middle, force : ndarray
        [s] and [N].
    """
    t = states.t
    middle, half = 0.5 * (t[1:] + t[:-1]), 0.5 * np.maximum(np.diff(t), window)
    begin, end = np.maximum(middle - half, t[0]), np.minimum(middle + half, t[-1])
    speed = rise(task, states)
    change = (np.interp(end, t, speed) - np.interp(begin, t, speed)) / (end - begin)
    force: Floats = task.mass * (change - task.pull[1])
    return middle, force


def phases(task: Task, states: States) -> tuple[list[Phase], int]:
    """Divide a record into phases by the rule above.

    Parameters
    ----------
    task : Task
    states : States
        Result of `thin`.

    Returns
    -------
    phases : list of Phase
    chatter : int
        Number of removed runs.
    """
    t = states.t
    middle, force = normal_force(task, states, WINDOW)
    half = 0.5 * np.maximum(np.diff(t), WINDOW)
    slip = slip_velocity(task, states)
    slid = np.concatenate([[0.0], np.cumsum(0.5 * (slip[1:] + slip[:-1]) * np.diff(t))])
    begin, end = np.maximum(middle - half, t[0]), np.minimum(middle + half, t[-1])
    mean = (np.interp(end, t, slid) - np.interp(begin, t, slid)) / (end - begin)
    weight = task.mass * task.gravity
    letters = np.where(
        force < FREE * weight, "H", np.where(np.abs(mean) <= SLIP, "R", np.where(mean > 0.0, "K", "S"))
    ).tolist()  # fmt: skip
    runs: list[list[object]] = []
    for letter, group in groupby(range(len(letters)), key=letters.__getitem__):
        places = list(group)
        runs.append([letter, float(t[places[0]]), float(t[places[-1] + 1])])
    return _merge_short_runs(runs)


def _merge_short_runs(runs: list[list[object]]) -> tuple[list[Phase], int]:
    chatter = 0
    while len(runs) > 1:
        lengths = [float(run[2]) - float(run[1]) for run in runs]  # type: ignore[arg-type]
        k = int(np.argmin(lengths))
        if lengths[k] >= SHORT:
            break
        chatter += 1
        _, begin, end = runs.pop(k)
        if k == 0:
            runs[0][1] = begin
        elif k == len(runs):
            runs[-1][2] = end
        elif runs[k - 1][0] == runs[k][0]:
            runs[k - 1][2] = runs[k][2]
            runs.pop(k)
        else:
            border = 0.5 * (float(begin) + float(end))  # type: ignore[arg-type]
            runs[k - 1][2] = runs[k][1] = border
    return [Phase(str(a), float(b), float(c)) for a, b, c in runs], chatter  # type: ignore[arg-type]
