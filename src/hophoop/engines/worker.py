"""Run engines in a separate process, so that a crash, a hang or a conflict between libraries costs one row only."""

from __future__ import annotations

import multiprocessing
import os
import shutil
import sys
import time
from collections.abc import Mapping
from contextlib import ExitStack
from multiprocessing.connection import Connection
from typing import Any

from hophoop._support.stopping import ignored_by_children, undoing
from hophoop.engines.adapters.npm import npm_folder
from hophoop.engines.external import run_command
from hophoop.engines.phases import thin
from hophoop.engines.recording import Recording
from hophoop.engines.registry import Engine, engine
from hophoop.engines.task import States, Task

WARM = 20  # steps of a run before the timed one, which compiles and loads


def run_here(one: Engine, task: Task, dt: float, settings: Mapping[str, Any]) -> Recording:
    """Run an engine in this process and time it.

    Parameters
    ----------
    one : Engine
    task : Task
    dt : float
        [s].
    settings : mapping

    Returns
    -------
    recording : Recording

    Raises
    ------
    RuntimeError
        If a command fails.
    ImportError
        If the engine is not installed.
    """
    if one.run is None:
        return run_command(one.command, task, dt, settings, npm_folder())
    began = time.perf_counter()
    states = States(*one.run(task, dt, **settings))
    return Recording(states, time.perf_counter() - began, task.steps(dt), {"version": one.version})


class Worker:
    """A process that runs one engine on several tasks.

    Parameters
    ----------
    one : Engine
    """

    def __init__(self, one: Engine) -> None:
        self.engine = one
        self._process: Any = None
        self._pipe: Connection | None = None
        self._undoing = ExitStack()

    def run(self, task: Task, dt: float, settings: Mapping[str, Any], limit: float) -> Recording:
        """Run the engine; all failures are RuntimeErrors with one sentence.

        Parameters
        ----------
        task : Task
        dt : float
            [s].
        settings : mapping
        limit : float
            Maximum time [s].

        Returns
        -------
        recording : Recording

        Raises
        ------
        RuntimeError
            If the engine is not installed, fails, crashes or takes too long.
        """
        if self.engine.run is None:
            if not self.engine.installed and shutil.which(self.engine.command[0]):
                raise RuntimeError(f"{self.engine.package} is not in the folder of --npm: npm install --prefix FOLDER.")
            record = run_command(self.engine.command, task, dt, settings, npm_folder(), limit)
            return Recording(thin(record.states), record.wall_seconds, record.steps, record.notes)
        if self._process is None or not self._process.is_alive():
            self._start()
        assert self._pipe is not None
        try:
            self._pipe.send((task, dt, dict(settings)))
            if not self._pipe.poll(limit):
                self.close()
                raise RuntimeError(f"it took more than {limit:g} s.")
            answer = self._pipe.recv()
        except (EOFError, BrokenPipeError, ConnectionResetError):
            self.close()
            raise RuntimeError("its process crashed.") from None
        if isinstance(answer, str):
            raise RuntimeError(answer)
        assert isinstance(answer, Recording)
        return answer

    def close(self) -> None:
        """End the process."""
        self._undoing.close()
        if self._process is not None:
            self._process.join()
        if self._pipe is not None:
            self._pipe.close()
        self._process = self._pipe = None

    def _start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._pipe, theirs = context.Pipe()
        process = context.Process(target=_serve, args=(theirs, self.engine.name), daemon=True)
        with ignored_by_children():
            process.start()
        self._process = process
        self._undoing = ExitStack()
        self._undoing.enter_context(undoing(process.kill))
        theirs.close()


def _serve(pipe: Connection, name: str) -> None:
    os.environ["HOPHOOP_KERNELS"] = "compiled"  # interpreted kernels must not be timed
    silent = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):  # engines may print
        os.dup2(silent, stream)
    sys.stdout = sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    one = engine(name)
    warmed: set[str] = set()
    while True:
        try:
            task, dt, settings = pipe.recv()
        except EOFError:
            return
        try:
            key = repr(sorted(settings.items()))
            if key not in warmed:
                warmed.add(key)
                run_here(one, _shorten(task, WARM * dt), dt, settings)
            record = run_here(one, task, dt, settings)
            pipe.send(Recording(thin(record.states), record.wall_seconds, record.steps, record.notes))
        except Exception as error:
            text = " ".join(str(error).split()) or type(error).__name__
            pipe.send(text[:400])


def _shorten(task: Task, duration: float) -> Task:
    return Task(**{**task.__dict__, "duration": min(task.duration, duration)})
