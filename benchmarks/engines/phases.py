"""Phases of a record by one rule, the same for the truth and every engine.

1. The record is thinned to at most one state in 1/2048 s.
2. N, the mean normal force over 5 ms (over one interval of coarser records), follows from the change of the
   velocity of the centre of gravity; v̄, the mean slip velocity, from the same 5 ms.
3. An interval is flight (H) if N < 0.01 m g; else roll (R) if abs(v̄) ≤ 0.01 m/s; else slip, K for v̄ > 0 and S for v̄ < 0.
4. Intervals with one letter are a run. The shortest run below 20 ms is removed and its time divided between its neighbours,
   until no such run remains. Removed runs are counted as chatter.
"""

from __future__ import annotations

from itertools import groupby
from typing import NamedTuple

import numpy as np
from task import Floats, States, Task

WINDOW = 0.005  # s
FREE = 0.01  # of m g
SLIP = 0.01  # m/s
SHORT = 0.020  # s


class Phase(NamedTuple):
    """A phase of one kind of contact: R roll, S and K slip with v_t < 0 and > 0, H flight; from begin to end [s]."""

    letter: str
    begin: float
    end: float


def slip_velocity(task: Task, states: States) -> Floats:
    """Return the velocity of the rim's lowest point along the plane [m/s]."""
    return states.vx - task.radius * states.omega


def normal_force(task: Task, states: States, window: float = 0.0) -> tuple[Floats, Floats]:
    """Return the middle of each interval [s], and the mean normal force over it or over a longer window about it [N]."""
    middle, begin, end = _windows(states.t, window)
    rise = states.vy - task.arm * states.omega * np.sin(states.angle)  # of the centre of gravity
    change = (np.interp(end, states.t, rise) - np.interp(begin, states.t, rise)) / (end - begin)
    return middle, task.mass * (change - task.pull[1])


def phases(task: Task, states: States) -> tuple[list[Phase], int]:
    """Divide a thinned record into phases by the rule above; return the number of removed runs, too."""
    t = states.t
    _, force = normal_force(task, states, WINDOW)
    _, begin, end = _windows(t, WINDOW)
    slip = slip_velocity(task, states)
    slid = np.concatenate([[0.0], np.cumsum(0.5 * (slip[1:] + slip[:-1]) * np.diff(t))])
    mean = (np.interp(end, t, slid) - np.interp(begin, t, slid)) / (end - begin)
    sliding = np.where(np.abs(mean) <= SLIP, "R", np.where(mean > 0.0, "K", "S"))
    letters = np.where(force < FREE * task.mass * task.gravity, "H", sliding).tolist()
    runs = []
    for letter, group in groupby(range(len(letters)), key=letters.__getitem__):
        places = list(group)
        runs.append(Phase(letter, float(t[places[0]]), float(t[places[-1] + 1])))
    return _without_short_runs(runs)


def _windows(t: Floats, window: float) -> tuple[Floats, Floats, Floats]:
    """Middle, begin and end of each interval, widened to the window within the record."""
    middle, half = 0.5 * (t[1:] + t[:-1]), 0.5 * np.maximum(np.diff(t), window)
    return middle, np.maximum(middle - half, t[0]), np.minimum(middle + half, t[-1])


def _without_short_runs(runs: list[Phase]) -> tuple[list[Phase], int]:
    chatter = 0
    while len(runs) > 1:
        lengths = [run.end - run.begin for run in runs]
        k = int(np.argmin(lengths))
        if lengths[k] >= SHORT:
            break
        chatter += 1
        gone = runs.pop(k)
        if k == 0:
            runs[0] = runs[0]._replace(begin=gone.begin)
        elif k == len(runs):
            runs[-1] = runs[-1]._replace(end=gone.end)
        elif runs[k - 1].letter == runs[k].letter:
            runs[k - 1 : k + 1] = [runs[k - 1]._replace(end=runs[k].end)]
        else:
            border = 0.5 * (gone.begin + gone.end)
            runs[k - 1 : k + 1] = [runs[k - 1]._replace(end=border), runs[k]._replace(begin=border)]
    return runs, chatter
