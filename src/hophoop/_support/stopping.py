"""Ctrl-C and SIGTERM: a command ends by one message and the status of the signal, and leaves nothing unfinished behind.

A signal raises KeyboardInterrupt wherever the command is, so that contexts clean up as after any error.
"""

from __future__ import annotations

import contextlib
import logging
import os
import shutil
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

STOPS = (signal.SIGINT, signal.SIGTERM)
ONE = 1.0  # s in which repeated signals count as one: a terminal and a starter may both send it


@contextlib.contextmanager
def temporary(path: Path) -> Iterator[Path]:
    """Context with a path for a file or a folder that is removed at the end."""
    try:
        yield path
    finally:
        remove(path)


@contextlib.contextmanager
def temporary_folder(prefix: str = "hophoop-", home: Path | None = None) -> Iterator[Path]:
    """Context with a folder, readable by this user only, that is removed at the end; by default in the temporary folder."""
    if home is None:
        from tempfile import gettempdir

        home = Path(gettempdir())
    with temporary(home / f"{prefix}{os.urandom(6).hex()}") as folder:
        folder.mkdir(0o700)
        yield folder


def remove(path: Path) -> None:
    """Remove a file or a folder if it exists."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


@contextlib.contextmanager
def ignored_by_children() -> Iterator[None]:
    """Context in which started processes and threads, and their children, ignore signals: this process ends them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # if started later, it would unblock the signals
    before = signal.pthread_sigmask(signal.SIG_BLOCK, STOPS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class Stopping:
    """What a command has heard of Ctrl-C and SIGTERM.

    Attributes
    ----------
    heard : int
        The signal received; 0 for none.
    words : callable
        Returns the message about the stop.
    """

    def __init__(self) -> None:
        self.heard = 0
        self.words: Callable[[], str] = lambda: "Stopped."
        self._raised = -ONE

    def hear(self, number: int, frame: object) -> None:
        """Raise KeyboardInterrupt; a handler of signals."""
        self.heard = self.heard or number
        if time.monotonic() - self._raised >= ONE:
            self._raised = time.monotonic()
            logging.disable()  # libraries complain about what is interrupted, also in other threads
            raise KeyboardInterrupt

    def say(self) -> None:
        """Print the message about the stop."""
        with contextlib.suppress(OSError, ValueError, AttributeError):  # nobody reads stderr
            print(self.words(), file=sys.stderr, flush=True)


_now: Stopping | None = None


@contextlib.contextmanager
def stop_on_signals(alone: bool) -> Iterator[Stopping]:
    """Context in which a command ends after Ctrl-C and SIGTERM with a message; within another one, that one.

    alone: True if the process only runs the command, and may be ended without waiting for threads that still compute.
    """
    global _now
    if _now is not None:
        yield _now
        return
    _now = stopping = Stopping()
    silent = logging.root.manager.disable
    handlers = {}
    if threading.current_thread() is threading.main_thread():
        # a shell makes background jobs ignore SIGINT
        handlers = {
            number: signal.signal(number, stopping.hear) for number in STOPS if signal.getsignal(number) != signal.SIG_IGN
        }
    try:
        yield stopping
    except BaseException:
        if not stopping.heard:
            raise
    finally:
        _now = None
        for number, handler in handlers.items():
            signal.signal(number, signal.SIG_IGN if alone else handler)  # a command that has ended has its own status
    if not stopping.heard:
        return
    stopping.say()
    if alone:
        with contextlib.suppress(OSError, ValueError, AttributeError):
            sys.stdout.flush()
        os._exit(128 + stopping.heard)
    logging.disable(silent)
    raise SystemExit(128 + stopping.heard)  # the exit status by the convention of shells


def say_when_stopped(words: Callable[[], str]) -> None:
    """Set the message about a stop, instead of 'Stopped.'."""
    if _now is not None:
        _now.words = words


def forget() -> None:
    """Continue as if no signal had come: it was meant for something else, such as a server, which has ended."""
    if _now is not None:
        _now.heard = 0
