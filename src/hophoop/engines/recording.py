"""The record of an engine: states and costs, and its file, which any language can write."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from hophoop.engines.task import States
from hophoop.scenario import InputError

HEADER = ("t", "x", "y", "theta", "vx", "vy", "omega")


@dataclass(frozen=True)
class Recording:
    """States of one run.

    Attributes
    ----------
    states : States
    wall_seconds : float or None
        Time for setup and steps, without the start of the engine [s].
    steps : int or None
        Number of steps.
    notes : dict of str to str
        Further lines of the file: engine, version, settings, scenario.
    """

    states: States
    wall_seconds: float | None = None
    steps: int | None = None
    notes: dict[str, str] = field(default_factory=dict)


def read_csv(text: str, name: str = "the record") -> Recording:
    """Read a record: lines ``# key: value``, the header ``t,x,y,theta,vx,vy,omega``, and one line per state.

    Parameters
    ----------
    text : str
    name : str, default 'the record'
        Name in error messages.

    Returns
    -------
    recording : Recording

    Raises
    ------
    ValueError
        If the header or a line has another format.
    """
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
        raise InputError(f"{name} is not CSV: {error}.") from None
    if not rows or tuple(cell.strip() for cell in rows[0]) != HEADER:
        found = f"; it starts with {','.join(rows[0])[:60]!r}" if rows else ""
        raise InputError(f"{name} must start with the header {','.join(HEADER)}{found}.")
    for number, row in enumerate(rows[1:], start=1):
        if len(row) != len(HEADER):
            raise InputError(f"{name} has {len(row)} numbers in state {number}; a state has {len(HEADER)}.")
    try:
        table = np.array(rows[1:], dtype=float).reshape(-1, len(HEADER))
    except ValueError as error:
        raise InputError(f"{name} has a cell that is not a number: {error}.") from None
    wall, steps = notes.pop("wall_seconds", None), notes.pop("steps", None)
    try:
        return Recording(States(*table.T), float(wall) if wall else None, int(steps) if steps else None, notes)
    except ValueError:
        raise InputError(f"{name}: wall_seconds = {wall!r} and steps = {steps!r} must be numbers.") from None


def load_csv(path: str | Path) -> Recording:
    """Read a record from a file.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    recording : Recording

    Raises
    ------
    ValueError
        If it is not a record.
    OSError
        If it cannot be read.
    """
    try:
        return read_csv(Path(path).read_text(encoding="utf-8"), str(path))
    except UnicodeDecodeError:
        raise InputError(f"{path} is not a text file in UTF-8.") from None


def to_csv(recording: Recording) -> str:
    """Return a record as text for `read_csv`.

    Parameters
    ----------
    recording : Recording

    Returns
    -------
    text : str
    """
    notes = dict(recording.notes)
    if recording.wall_seconds is not None:
        notes["wall_seconds"] = repr(recording.wall_seconds)
    if recording.steps is not None:
        notes["steps"] = str(recording.steps)
    head = [f"# {key}: {value}" for key, value in notes.items()]
    rows = [",".join(repr(float(value)) for value in row) for row in zip(*recording.states, strict=True)]
    return "\n".join([*head, ",".join(HEADER), *rows]) + "\n"
