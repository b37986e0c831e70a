"""The truth of the benchmark, read from decimal strings in a file of the package."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from typing import Any

import numpy as np

from hophoop.engines.measures import Measures
from hophoop.engines.task import States, Task

FILE = "hophoop-bench-1.json"
SCHEMA = "hophoop-bench-1.schema.json"


@dataclass(frozen=True)
class Truth:
    """The exact motion of one scenario.

    Attributes
    ----------
    task : Task
    measures : Measures
    states : States
        At the times of the file.
    events : tuple of dict
        Events of the file, with times and states as decimal strings.
    energy : dict of float
        Energies at the end, and losses [J].
    lossless_until : float
        Time from the start without loss of energy [s].
    """

    task: Task
    measures: Measures
    states: States
    events: tuple[dict[str, Any], ...]
    energy: dict[str, float]
    lossless_until: float


def truth_text() -> str:
    """Return the text of the file with the truth, after checking its checksum.

    Returns
    -------
    text : str
        JSON.

    Raises
    ------
    ValueError
        If the file does not match its checksum.
    """
    data = files("hophoop.engines").joinpath("data")
    content = data.joinpath(FILE).read_bytes()
    line = data.joinpath(FILE.replace(".json", ".sha256")).read_text(encoding="utf-8")
    if hashlib.sha256(content).hexdigest() != line.split()[0]:
        raise ValueError(f"{FILE} does not match its checksum.")
    return content.decode("utf-8")


def schema() -> dict[str, Any]:
    """JSON schema of the file with the truth.

    Returns
    -------
    schema : dict
    """
    text = files("hophoop.engines").joinpath("data", SCHEMA).read_text(encoding="utf-8")
    result: dict[str, Any] = json.loads(text)
    return result


@lru_cache(maxsize=1)
def truths() -> dict[str, Truth]:
    """Return the exact motions by name of their scenarios.

    Returns
    -------
    truths : dict of str to Truth

    Raises
    ------
    ValueError
        If the file is damaged.
    """
    return {name: _truth(entry) for name, entry in json.loads(truth_text())["scenarios"].items()}


def _truth(entry: dict[str, Any]) -> Truth:
    given, measures = entry["task"], dict(entry["measures"])
    until = measures.pop("lossless_until")
    columns = entry["states"]
    return Truth(
        task=Task(**{name: given[name] for name in Task.__dataclass_fields__}),
        measures=Measures(**measures),
        states=States(*(np.array([float(value) for value in columns[name]]) for name in States._fields)),
        events=tuple(entry["events"]),
        energy={name: float(value) for name, value in entry["energy"].items()},
        lossless_until=until,
    )
