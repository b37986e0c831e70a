"""The motions of the benchmark hophoop-bench/1 and their exact solution, from decimal strings in data/hophoop-bench-1.json."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from measures import Measures
from task import States, Task

BENCHMARK = "hophoop-bench/1"
DATA = Path(__file__).parent / "data" / "hophoop-bench-1.json"


@dataclass(frozen=True)
class Truth:
    """One motion of the benchmark with its exact solution.

    `entry` is the motion in the file: title, reason, events and energies as decimal strings. `scored` is False where rigid
    contact has no one answer, or all but none. `lossless_until` is the time from the start without loss of energy [s].
    """

    task: Task
    scored: bool
    measures: Measures
    states: States
    lossless_until: float
    entry: dict[str, Any]


def read_document() -> dict[str, Any]:
    """Read the file, after checking its checksum."""
    content = DATA.read_bytes()
    if hashlib.sha256(content).hexdigest() != DATA.with_suffix(".sha256").read_text(encoding="utf-8").split()[0]:
        raise ValueError(f"{DATA.name} does not match its checksum.")
    document: dict[str, Any] = json.loads(content)
    return document


@cache
def truths() -> dict[str, Truth]:
    """Return the motions by name, with those that are not scored last."""
    return {name: _truth(entry) for name, entry in read_document()["scenarios"].items()}


def scored() -> list[str]:
    """Return the names of the motions that count."""
    return [name for name, truth in truths().items() if truth.scored]


def job(task: Task, dt: float, settings: dict[str, Any]) -> dict[str, Any]:
    """Return what an adapter reads: the task as in the file, the step [s], steps per written state, settings of the engine."""
    return truths()[task.name].entry["task"] | {"dt": dt, "every": task.every(dt), "settings": settings}


def task_of(given: dict[str, Any]) -> Task:
    """Return the task of an entry or of a job."""
    return Task(**{name: given[name] for name in Task.__dataclass_fields__})


def _truth(entry: dict[str, Any]) -> Truth:
    measures = dict(entry["measures"])
    until = measures.pop("lossless_until")
    columns = (np.array([float(value) for value in entry["states"][name]]) for name in States._fields)
    return Truth(task_of(entry["task"]), entry["scored"], Measures(**measures), States(*columns), until, entry)
