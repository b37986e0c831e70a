"""The record of a motion as a CSV file, which any program can write, and the conventions that it must keep."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass, field

import numpy as np
from task import SPACING, Floats, States, Task

HEADER = ("t", "x", "y", "theta", "vx", "vy", "omega")
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
RATES = {"x": "vx", "y": "vy", "theta": "omega"}
AGREE = (0.5, 2.0)  # by how much a quantity may change, relative to the integral of its rate
# m or rad: least integral of a rate that is judged; of vy that of a flight, as engines correct the depth of a contact
CHANGE = {"x": 0.05, "y": 0.2, "theta": 0.05}
JUMP = 0.3  # rad, from a whole turn


@dataclass(frozen=True)
class Record:
    """States of one run; its wall time without the start of the engine [s], its number of steps, further lines of the file."""

    states: States
    wall_seconds: float | None = None
    steps: int | None = None
    notes: dict[str, str] = field(default_factory=dict)


def read_record(text: str, name: str = "the record") -> Record:
    """Read lines ``# key: value``, the header ``t,x,y,theta,vx,vy,omega``, and one line per state."""
    notes: dict[str, str] = {}
    lines = []
    for line in text.lstrip("\ufeff").splitlines():
        if line.startswith("#"):
            key, _, value = line[1:].partition(":")
            notes[key.strip()] = value.strip()
        elif line.strip():
            lines.append(line)
    try:
        rows = list(csv.reader(io.StringIO("\n".join(lines))))
    except csv.Error as error:
        raise ValueError(f"{name} is not CSV: {error}.") from None
    if not rows or tuple(cell.strip() for cell in rows[0]) != HEADER:
        found = f"; it starts with {','.join(rows[0])[:60]!r}" if rows else ""
        raise ValueError(f"{name} must start with the header {','.join(HEADER)}{found}.")
    for number, row in enumerate(rows[1:], start=1):
        if len(row) != len(HEADER):
            raise ValueError(f"{name} has {len(row)} numbers in state {number}; a state has {len(HEADER)}.")
    try:
        table = np.array(rows[1:], dtype=float).reshape(-1, len(HEADER))
    except ValueError as error:
        raise ValueError(f"{name} has a cell that is not a number: {error}.") from None
    wall, steps = notes.pop("wall_seconds", None), notes.pop("steps", None)
    try:
        return Record(States(*table.T), float(wall) if wall else None, int(steps) if steps else None, notes)
    except ValueError:
        raise ValueError(f"{name}: wall_seconds = {wall!r} and steps = {steps!r} must be numbers.") from None


def record_text(record: Record) -> str:
    """Return a record as text for `read_record`."""
    notes: dict[str, object] = dict(record.notes)
    if record.wall_seconds is not None:
        notes["wall_seconds"] = record.wall_seconds
    if record.steps is not None:
        notes["steps"] = record.steps
    head = [f"# {key}: {value}" for key, value in notes.items()]
    rows = [",".join(repr(float(value)) for value in row) for row in zip(*record.states, strict=True)]
    return "\n".join([*head, ",".join(HEADER), *rows]) + "\n"


def thin(states: States) -> States:
    """Thin a record to at most one state per 1/2048 s, so that all records are comparable; an invalid one is a ValueError."""
    t = states.t
    if len(t) < 3:
        raise ValueError(f"the record has {len(t)} states; it needs at least 3.")
    for name, column in zip(HEADER, states, strict=True):
        if not np.isfinite(column).all():
            raise ValueError(f"{name} must be finite; state {int(np.argmin(np.isfinite(column)))} is not.")
    if abs(t[0]) > 1e-9 or not (np.diff(t) > 0).all():
        raise ValueError("t must start at 0 and increase.")
    if np.diff(t).min() >= SPACING * (1 - 1e-6):
        return states
    kept, last = [0], t[0]
    for i, now in enumerate(t):
        if now - last >= SPACING * (1 - 1e-6):
            kept.append(i)
            last = now
    return States(*(column[kept] for column in states))


def check_start(task: Task, exact: States, states: States) -> None:
    """Refuse a record that starts in another state than its motion.

    The exact motion starts in another state than the task where an impact comes at once.
    """
    if abs(states.y[0] - task.height - task.radius) < NEAR * task.radius:
        raise ValueError(
            f"the record begins at y = {states.y[0]:.6g} m, the height of the centre; y must be the gap between rim and plane: "
            f"subtract the radius, {task.radius:g} m."
        )
    starts = (task.x, task.height, task.angle, task.vx, task.vy, task.omega)
    for (name, meaning), value, right, column in zip(MEANINGS.items(), starts, exact[1:], states[1:], strict=True):
        if min(abs(column[0] - value), abs(column[0] - right[0])) > NEAR:
            raise ValueError(
                f"the record starts with {name} = {column[0]:.6g}, the motion {task.name!r} with {value:.6g}; "
                f"{name} is {meaning}."
            )


def check_rates(states: States) -> None:
    """Refuse columns whose sign or unit differs from that of their rate, and θ wrapped into one revolution."""
    columns = dict(zip(HEADER, states, strict=True))
    for name, rate in RATES.items():
        speed = columns[rate]
        change, integral = np.diff(columns[name]), 0.5 * (speed[1:] + speed[:-1]) * np.diff(states.t)
        if name == "theta":
            _check_unwrapped(states.t, change - integral)
        judged = np.abs(integral).sum() > CHANGE[name]
        ratio = float(change @ integral) / float(integral @ integral) if judged else 1.0
        if not AGREE[0] < ratio < AGREE[1]:
            raise ValueError(
                f"{name} changes by {ratio:.3g} times the integral of {rate} over t; both need the same sign and SI units, "
                "angles in rad, t in s."
            )


def _check_unwrapped(t: Floats, off: Floats) -> None:
    turns = np.round(off / (2.0 * np.pi))
    jumps = np.flatnonzero((turns != 0.0) & (np.abs(off - 2.0 * np.pi * turns) < JUMP))
    if len(jumps):
        first = jumps[0]
        raise ValueError(
            f"theta jumps by {off[first]:.3g} rad after t = {t[first]:.6g} s; it must count on through full turns, unwrapped."
        )
