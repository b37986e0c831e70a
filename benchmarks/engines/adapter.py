"""Run one adapter in Python in this process: the job as JSON on standard input, the record as CSV on standard output.

    python benchmarks/engines/adapter.py mujoco < job.json > record.csv

run.py starts it. Scripts in JavaScript, adapters/*.mjs, read and write the same.
"""

from __future__ import annotations

import json
import os
import sys
import time
from dataclasses import replace
from importlib import import_module

from record import Record, record_text, thin
from truth import task_of

WARM = 20  # steps of a run before the timed one, which compiles and loads


def main() -> None:
    """Warm up, then run as often as the job asks; the record has the least wall time."""
    given = json.load(sys.stdin)
    output = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # engines may print
    run = import_module(f"adapters.{sys.argv[1]}").run
    task, dt, settings = task_of(given), given["dt"], given["settings"]
    run(replace(task, duration=min(task.duration, WARM * dt)), dt, **settings)
    walls = []
    for _ in range(given.get("runs", 1)):
        began = time.perf_counter()
        states = run(task, dt, **settings)
        walls.append(time.perf_counter() - began)
    output.write(record_text(Record(thin(states), min(walls), task.steps(dt))))
    output.close()


if __name__ == "__main__":
    main()
