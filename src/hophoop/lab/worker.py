"""A process that computes for the lab and can be stopped: jobs arrive on standard input, answers go to standard output.

A motion cannot be stopped inside the kernel; it runs to its end. A process can be stopped. It is first told which job to
cancel, which stops a map, a film or a file at once and keeps the process. A process inside a long motion does not react, and is
ended.

Jobs are numbered, and every job has exactly one answer with its number. So whenever a job is cancelled (before it is read,
while it is computed, or while its answer is sent), no answer is taken for that of another job.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import signal
import struct
import subprocess
import sys
import threading
import time
import traceback
from dataclasses import dataclass
from types import FrameType
from typing import Any, BinaryIO

from hophoop._support.processes import start_python

ANSWER, ERROR, FAILED, STOPPED, BEGINNING = "answer", "error", "failed", "stopped", "beginning"
BEGINS = 4.0  # seconds that a process may take until its first report
REPORT = 0.25  # seconds between reports while code is compiled
AGAIN = 0.01  # seconds until a job that is importing a module is interrupted again


@dataclass(frozen=True)
class Job:
    """A request to compute, and the form of its answer.

    Attributes
    ----------
    request : hophoop.lab.calls.Request
        A checked request.
    limits : hophoop.lab.limits.Limits
    form : str
        Form of the answer: packed, json, or the name of a file.
    """

    request: Any
    limits: Any
    form: str


class Ended(RuntimeError):
    """The process has ended: it was stopped, or the system ended it."""


class Worker:
    """Another process that computes one job at a time."""

    def __init__(self) -> None:
        # a session of its own: Ctrl-C goes to the server, which ends the process and its children
        self._process = start_python(
            # an interrupt may come before the handler is installed
            "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN); from hophoop.lab.worker import main; main()",
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
        )
        self._began = time.monotonic() + BEGINS
        self._number = 0  # of the last job
        self._writing = threading.Lock()

    @property
    def beginning(self) -> bool:
        """True while it loads its modules, which does not count as computing."""
        return time.monotonic() - self._began < 4.0 * REPORT

    def exchange(self, job: Job) -> tuple[str, Any]:
        """Send a job and wait for its answer; one job at a time.

        Parameters
        ----------
        job : Job

        Returns
        -------
        said : (str, object)
            As from `outcome`, or `STOPPED` and None for a job that was interrupted before its end.

        Raises
        ------
        Ended
            If the process has ended.
        """
        self._number += 1
        number = self._number
        try:
            self._say(number, job)
            while True:
                said: tuple[int, str, Any] = _read(self._process.stdout)  # type: ignore[arg-type]
                if said[1] == BEGINNING:
                    self._began = time.monotonic()
                elif said[0] == number:
                    return said[1:]
        except (EOFError, OSError, ValueError):  # the pipe is broken or closed
            raise Ended from None

    def interrupt(self) -> bool:
        """Ask the process to stop its job, which still answers; return False if that is not possible."""
        if os.name != "posix":
            return False
        with contextlib.suppress(OSError, ValueError):  # it has ended
            self._say(self._number, None)
        return True

    def _say(self, number: int, job: Job | None) -> None:
        with self._writing:
            _write(self._process.stdin, (number, job))  # type: ignore[arg-type]

    def end(self) -> None:
        """End the process and all its children."""
        with contextlib.suppress(ProcessLookupError, PermissionError):
            if os.name == "posix":
                os.killpg(self._process.pid, signal.SIGKILL)
            else:
                self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()

    @property
    def running(self) -> bool:
        """True if the process runs."""
        return self._process.poll() is None


class _Stopped(KeyboardInterrupt):
    """The job that is being computed has been cancelled."""


class _Loop:
    """Loop that takes jobs one by one, and gives each exactly one answer."""

    def __init__(self, inward: BinaryIO, outward: BinaryIO) -> None:
        self.inward, self.outward = inward, outward
        self.jobs: queue.SimpleQueue[tuple[int, Job] | None] = queue.SimpleQueue()
        self.preparing = True
        self.computing = 0  # number of the current job
        self.unwanted = 0  # jobs up to this number are cancelled, unless they are answered already
        self.lock = threading.Lock()

    def say(self, number: int, said: tuple[str, Any]) -> None:
        with self.lock:
            _write(self.outward, (number, *said))

    def listen(self) -> None:
        """Receive jobs and cancellations, also while a job is computed; end the process at the end of the input."""
        try:
            while True:
                number, job = _read(self.inward)
                if job is not None:
                    self.jobs.put((number, job))
                    continue
                self.unwanted = number
                if self.computing == number:
                    signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
        except EOFError:
            pass
        finally:
            self.jobs.put(None)

    def report(self) -> None:
        """Report regularly that the process is still starting."""
        while self.preparing:
            with contextlib.suppress(OSError):
                self.say(0, (BEGINNING, None))
            time.sleep(REPORT)

    def interrupted(self, _: int, frame: FrameType | None) -> None:
        """Stop the current job; one that was just answered, or the next one, continues."""
        if 0 < self.computing <= self.unwanted:
            if importing(frame):  # a half-imported module would fail all later jobs
                signal.setitimer(signal.ITIMER_REAL, AGAIN)
                return
            self.computing = 0
            raise _Stopped

    def heed(self) -> None:
        """React to interrupts from now on, including those that were postponed."""
        signal.signal(signal.SIGINT, self.interrupted)
        if os.name == "posix":
            signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))

    def run(self) -> None:
        while (job := self.jobs.get()) is not None:
            self.say(job[0], self.answer(*job))

    def answer(self, number: int, job: Job) -> tuple[str, Any]:
        try:
            self.computing = number  # interruptible from here on; a job cancelled before is not started
            said = outcome(job) if number > self.unwanted else (STOPPED, None)
            self.computing = 0
        except _Stopped:
            return STOPPED, None
        return said


def importing(frame: FrameType | None) -> bool:
    """Return True if a module was being imported when a signal came."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def outcome(job: Job) -> tuple[str, Any]:
    """Compute a job.

    Parameters
    ----------
    job : Job

    Returns
    -------
    said : (str, object)
        `ANSWER` with bytes, `ERROR` with an exception for the client, or `FAILED` with a traceback.
    """
    from hophoop._support.extras import MissingExtra
    from hophoop.lab import calls, files
    from hophoop.scenario import InputError

    try:
        if job.form in files.KINDS:
            return ANSWER, files.KINDS[job.form].make(job.request.scenario, job.limits)
        answered = calls.answer(job.request, job.limits)
        return ANSWER, answered.packed() if job.form == "packed" else answered.json()
    except (InputError, MissingExtra) as error:
        return ERROR, error
    except Exception:
        return FAILED, traceback.format_exc()


def main() -> None:
    """Compute jobs until standard input ends."""
    inward = sys.stdin.buffer
    outward = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # prints must not mix with the answers
    loop = _Loop(inward, outward)
    loop.heed()
    for thread in (loop.listen, loop.report):
        threading.Thread(target=thread, daemon=True).start()
    usual = sys.unraisablehook
    # a stop within a callback is not reported
    sys.unraisablehook = lambda found: None if isinstance(found.exc_value, _Stopped) else usual(found)
    _prepare()
    loop.preparing = False
    loop.run()


def _prepare() -> None:
    """Load what most jobs need, before the first job waits for it."""
    from hophoop import maps  # noqa: F401
    from hophoop.lab import calls
    from hophoop.scenario import Scenario

    with contextlib.suppress(ValueError, ImportError):
        calls.film_of(calls.computed(Scenario()))
        import xarray  # noqa: F401  a map needs it, and a process that is importing cannot be stopped at once


def _write(stream: BinaryIO, value: Any) -> None:
    block = pickle.dumps(value, pickle.HIGHEST_PROTOCOL)
    stream.write(struct.pack("<Q", len(block)) + block)
    stream.flush()


def _read(stream: BinaryIO) -> Any:
    head = stream.read(8)
    if len(head) < 8:
        raise EOFError
    (length,) = struct.unpack("<Q", head)
    block = stream.read(length)
    if len(block) < length:
        raise EOFError
    return pickle.loads(block)
