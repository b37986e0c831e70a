"""A command as an engine: the task as JSON on its standard input, the record as CSV on its standard output."""

from __future__ import annotations

import json
import re
import subprocess
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from hophoop._support.stopping import child
from hophoop.engines.recording import Recording, read_csv
from hophoop.engines.task import Task


def job_text(task: Task, dt: float, settings: Mapping[str, Any]) -> str:
    """Return the input of a command: the task, the time step, the number of steps per written state, the settings.

    Parameters
    ----------
    task : Task
    dt : float
        [s].
    settings : mapping

    Returns
    -------
    text : str
        JSON.
    """
    return json.dumps({**task.to_dict(), "dt": dt, "every": task.every(dt), "settings": dict(settings)})


def run_command(
    command: Sequence[str],
    task: Task,
    dt: float,
    settings: Mapping[str, Any] | None = None,
    folder: Path | None = None,
    limit: float = 120.0,
) -> Recording:
    """Run a command on a task.

    Parameters
    ----------
    command : sequence of str
    task : Task
    dt : float
        [s].
    settings : mapping, optional
    folder : Path, optional
        Working folder.
    limit : float, default 120
        Maximum time [s].

    Returns
    -------
    recording : Recording
        With the wall time stated by the command, otherwise that of the whole command.

    Raises
    ------
    RuntimeError
        If the command cannot be run, fails, or takes too long.
    ValueError
        If its output is not a record.
    """
    began = time.perf_counter()
    pipe = subprocess.PIPE
    try:
        with child(subprocess.Popen(list(command), stdin=pipe, stdout=pipe, stderr=pipe, text=True, cwd=folder)) as process:
            written, said = process.communicate(job_text(task, dt, settings or {}), limit)
    except FileNotFoundError:
        raise RuntimeError(f"{command[0]} is not installed.") from None
    except subprocess.TimeoutExpired:
        raise RuntimeError(f"it took more than {limit:g} s.") from None
    took = time.perf_counter() - began
    if process.returncode != 0:
        lines = [line for line in said.strip().splitlines() if line.strip()]
        named = [line for line in lines if re.match(r"\s*[\w.]*(Error|Exception)\b.*:", line)]
        last = (named or lines[-1:] or ["nothing"])[0].strip()
        raise RuntimeError(f"{command[0]} ended with status {process.returncode}: {last}")
    record = read_csv(written, "what the command wrote")
    if record.wall_seconds is None:
        return Recording(record.states, took, record.steps or task.steps(dt), record.notes)
    return record
