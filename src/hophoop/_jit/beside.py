"""The process beside that compiles kernels, and waiting for it. Numba is not imported here."""

from __future__ import annotations

import atexit
import contextlib
import os
import pickle
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from functools import cached_property
from multiprocessing import parent_process
from pathlib import Path
from typing import IO, Any

from hophoop._jit.kernels import Source
from hophoop._jit.store import folder_of, is_ready, reachable, root_folder
from hophoop._processes import python_beside

Wanted = Sequence[tuple[Source, Any]]

POLLS = 0.1  # seconds


class Job:
    """A process that compiles kernels."""

    def __init__(self, process: subprocess.Popen[bytes] | None, wanted: Wanted, progress: Path) -> None:
        self._process = process
        self._wanted = wanted
        self._progress = progress

    @property
    def done(self) -> bool:
        """Whether all that it compiles is on disk."""
        return all(is_ready(kernel, kinds) for kernel, kinds in self._wanted)

    @property
    def failed(self) -> bool:
        """Whether it ended, or could not even be started, with something not compiled."""
        return (self._process is None or self._process.poll() is not None) and not self.done

    @cached_property
    def total(self) -> int:
        """How many functions it compiles."""
        return len({part for kernel, _ in self._wanted for part in reachable(kernel)})

    @property
    def progress(self) -> tuple[int, int]:
        """How many functions are compiled, of how many."""
        with contextlib.suppress(OSError, ValueError):
            return min(int(self._progress.read_text()), self.total), self.total
        return 0, self.total

    def wait(self, report: Callable[[int, int], None] | None = None) -> bool:
        """Wait until it is done or has failed; whether it is done."""
        while not self.done:
            if self.failed:
                return False
            if report is not None:
                report(*self.progress)
            time.sleep(POLLS)
        return True

    def leave(self) -> None:
        """Let it go on by itself; what it compiles is for the next time."""
        if self._process is not None and self._process.returncode is None:
            self._process.returncode = 0  # else Python would warn of a process that still runs


_jobs: dict[tuple[Source, Any], Job] = {}
_lock = threading.RLock()
START = "from hophoop._jit.dispatchers import main; main()"


def start(wanted: Wanted) -> Job:
    """Compile in a process beside; one that is on it already is not started again."""
    with _lock:
        new = [item for item in wanted if item not in _jobs]
        if new or not wanted:
            job = _start(new)
            _jobs.update(dict.fromkeys(new, job))
        return _jobs[wanted[-1]]


def busy() -> bool:
    """Whether a process that this one has started compiles now."""
    return any(not job.done and not job.failed for job in set(_jobs.values()))


def launch(code: str, stdin: int = subprocess.DEVNULL) -> subprocess.Popen[bytes]:
    """Start Python on code that compiles kernels into the folder of this process; it goes on when this one ends.

    Raises
    ------
    OSError
        If no process can be started.
    """
    environment = {name: value for name, value in os.environ.items() if name != "NUMBA_DISABLE_JIT"}
    environment |= {"NUMBA_CACHE_DIR": str(root_folder()), "HOPHOOP_KERNELS": "compiled"}
    return python_beside(
        code,
        stdin=stdin,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=environment,
        start_new_session=True,
    )


def _start(wanted: Wanted) -> Job:
    folder = folder_of(wanted[0][0])
    progress = folder / f"{os.getpid()}-{len(_jobs)}.progress"
    request = pickle.dumps(
        (
            [(part.py_func.__module__, part.py_func.__qualname__, kinds) for part, kinds in wanted],
            str(progress),
        )
    )
    process = None
    with contextlib.suppress(OSError, ValueError):
        folder.mkdir(parents=True, exist_ok=True)
        process = launch(START, stdin=subprocess.PIPE)
        pipe = process.stdin
        assert pipe is not None
        with contextlib.suppress(OSError), pipe:
            pipe.write(request)
    return Job(process, wanted, progress)


@atexit.register
def _leave() -> None:
    for job in set(_jobs.values()):
        job.leave()


def _forget() -> None:
    global _lock
    _leave()
    _jobs.clear()  # they are the parent's
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


class Waiting:
    """Tells a person how far compiling is: a terminal on a line that is taken away again, any other stream once a process.

    A worker of another process is silent, since several of them wait for the same code.
    """

    told = False

    def __init__(self, stream: IO[str] | None) -> None:
        self._stream = None if parent_process() is not None else stream
        self._live = stream is not None and stream.isatty()
        self._shown = False

    def __enter__(self) -> Waiting:
        return self

    def report(self, done: int, total: int) -> None:
        """How many functions are compiled, of how many."""
        if self._stream is None:
            return
        if self._live:
            self._shown = True
            self._stream.write(f"\r\x1b[Khophoop compiles its kernel, this once: {done} of {total} functions")
        elif not Waiting.told:
            Waiting.told = True
            self._stream.write("hophoop compiles its kernel; this happens once and takes about a quarter of a minute.\n")
        self._stream.flush()

    def __exit__(self, *_: object) -> None:
        if self._shown and self._stream is not None:
            self._stream.write("\r\x1b[K")
            self._stream.flush()
