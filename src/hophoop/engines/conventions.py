"""Whether a record keeps the conventions of the benchmark: its start, its signs and its units."""

from __future__ import annotations

import numpy as np

from hophoop.engines.task import Floats, States, Task
from hophoop.scenario import InputError

# an engine that starts 0.1 m off is scored; farther off it means another quantity
NEAR = 0.1
MEANINGS = {
    "x": "the position of the rim's centre, in m",
    "y": "the gap between rim and plane, in m",
    "theta": "in rad, 0 with the load at the top, and grows as the hoop rolls towards +x",
    "vx": "the velocity of the rim's centre along the plane, in m/s",
    "vy": "the velocity of the rim's centre away from the plane, in m/s",
    "omega": "in rad/s, and positive as the hoop rolls towards +x",
}
RATES = {"x": "vx", "theta": "omega"}
AGREE = (0.5, 2.0)  # by how much a quantity may change, relative to the integral of its rate
CHANGE = 0.05  # m or rad: least integral of a rate that is judged
JUMP = 0.3  # rad, from a whole turn


def check_start(task: Task, exact: States, states: States) -> None:
    """Raise an error if a record starts in another state than its motion.

    Parameters
    ----------
    task : Task
    exact : States
        The exact motion; it differs from the task at t = 0 where an impact comes at once.
    states : States

    Raises
    ------
    ValueError
        If a coordinate or velocity is more than 0.1 off [SI, rad].
    """
    if abs(states.y[0] - task.height - task.radius) < NEAR * task.radius:
        raise InputError(
            f"the record begins at y = {states.y[0]:.6g} m, the height of the centre; y must be the gap between rim and plane: "
            f"subtract the radius, {task.radius:g} m."
        )
    starts = (task.x, task.height, task.angle, task.vx, task.vy, task.omega)
    for (name, meaning), value, right, column in zip(MEANINGS.items(), starts, exact[1:], states[1:], strict=True):
        if min(abs(column[0] - value), abs(column[0] - right[0])) > NEAR:
            raise InputError(
                f"the record starts with {name} = {column[0]:.6g}, the motion {task.name!r} with {value:.6g}; "
                f"{name} is {meaning}."
            )


def check_rates(states: States) -> None:
    """Raise an error if positions do not change as their rates say.

    Parameters
    ----------
    states : States

    Raises
    ------
    ValueError
        If a sign or unit differs between a column and its rate, or θ is wrapped into one turn.
    """
    columns = dict(zip(("t", *MEANINGS), states, strict=True))
    for name, rate in RATES.items():
        change, integral = np.diff(columns[name]), _integrals(states.t, columns[rate])
        if name == "theta":
            _check_unwrapped(states.t, change - integral)
        weight = float(integral @ integral)
        ratio = float(change @ integral) / weight if np.abs(integral).sum() > CHANGE else 1.0
        if not AGREE[0] < ratio < AGREE[1]:
            raise InputError(
                f"{name} changes by {ratio:.3g} times the integral of {rate} over t; both need the same sign and SI units, "
                "angles in rad, t in s."
            )


def _integrals(t: Floats, rate: Floats) -> Floats:
    return 0.5 * (rate[1:] + rate[:-1]) * np.diff(t)


def _check_unwrapped(t: Floats, off: Floats) -> None:
    turns = np.round(off / (2.0 * np.pi))
    jumps = np.flatnonzero((turns != 0.0) & (np.abs(off - 2.0 * np.pi * turns) < JUMP))
    if len(jumps):
        first = jumps[0]
        raise InputError(
            f"theta jumps by {off[first]:.3g} rad after t = {t[first]:.6g} s; it must count on through full turns, unwrapped."
        )
