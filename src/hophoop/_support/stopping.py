"""Ctrl-C and SIGTERM: a command ends soon, with one message and the right status, and leaves nothing unfinished behind.

A signal raises KeyboardInterrupt wherever the command is. The exception can be lost: in a callback that Python calls from C, in
a library that converts it, or in a compiled kernel. So a background thread waits, and ends the process if it still runs after
`PATIENCE`.
"""

from __future__ import annotations

import _thread
import atexit
import contextlib
import os
import select
import shutil
import signal
import sys
import threading
import time
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from types import FrameType
from typing import Any

PATIENCE = 1.0  # seconds from the signal until the process is ended
LOOKS = 0.02  # seconds between checks for a lost interrupt
TRIES = 20  # attempts to remove a folder into which another thread still writes
STOPS = (signal.SIGINT, signal.SIGTERM)

_undo: dict[object, Callable[[], object]] = {}


@contextlib.contextmanager
def when_stopped(undo: Callable[[], object]) -> Iterator[None]:
    """Call `undo`, perhaps twice, if the process is stopped within the block."""
    key = object()
    _undo[key] = undo
    try:
        yield
    finally:
        del _undo[key]


@contextlib.contextmanager
def undoing(undo: Callable[[], object]) -> Iterator[None]:
    """Call `undo` at the end of the block, or at the end of the process if it is stopped."""
    key = object()
    _undo[key] = undo
    try:
        yield
    finally:
        undo()
        del _undo[key]  # kept until `undo` has succeeded, so that an interrupted one is repeated


@contextlib.contextmanager
def temporary(path: Path) -> Iterator[Path]:
    """Context with a path for a file or a folder that is removed at the end."""
    with undoing(partial(remove, path)):
        yield path


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


def clean_up() -> None:
    """Undo everything in reverse order: a process ends before the folder that it writes to is removed."""
    for _ in range(TRIES):
        failed = False
        for undo in reversed(list(_undo.values())):
            try:
                undo()
            except OSError:
                failed = True
        if not failed:
            return
        time.sleep(LOOKS)


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
    """Context in which a command reacts to Ctrl-C and SIGTERM; it reports the stop last, and no errors caused by it.

    Parameters
    ----------
    alone : bool
        True if the process only runs the command, and may be ended.

    Attributes
    ----------
    heard : int
        The signal received; 0 for none.
    words : callable
        Returns the message about the stop.
    """

    def __init__(self, alone: bool) -> None:
        self.alone = alone
        self.heard = 0
        self.words: Callable[[], str] = lambda: "Stopped."
        self._running = True
        self._raised = False
        self._lost = False
        self._said = False
        self._pipe = 0
        self._watched = False
        self._handlers: dict[int, Any] = {}

    def __enter__(self) -> Stopping:
        global _now
        _now, self._hooks = self, (sys.unraisablehook, threading.excepthook)
        if threading.current_thread() is not threading.main_thread():
            return self
        sys.unraisablehook, threading.excepthook = self._unraisable, self._in_thread
        if self.alone:
            self._watch()
            atexit.register(self._ignore)
        for number in STOPS:
            # a shell makes background jobs ignore SIGINT
            if callable(signal.getsignal(number)) or signal.getsignal(number) is signal.SIG_DFL:
                self._handlers[number] = signal.signal(number, self._handle)
        return self

    def __exit__(self, *_: object) -> None:
        global _now
        self._running = False
        if self.heard and self.alone:
            clean_up()
            warnings.simplefilter("ignore")  # about unfinished resources
            self.say()
            with contextlib.suppress(OSError, ValueError, AttributeError):
                sys.stdout.flush()
            atexit._run_exitfuncs()
            os._exit(128 + self.heard)  # without waiting for threads that still compute
        if self.heard:
            self.say()
        if not self.alone:  # otherwise the thread waits until the process has ended
            for number, handler in self._handlers.items():
                signal.signal(number, handler)
            sys.unraisablehook, threading.excepthook = self._hooks
            _now = None
        if self.heard:
            raise SystemExit(128 + self.heard) from None  # the exit status by the convention of shells

    def say(self) -> None:
        """Print the message about the stop, once."""
        if self._said or sys.stderr is None:
            return
        self._said = True
        with contextlib.suppress(OSError, ValueError):  # nobody reads stderr
            print(self.words(), file=sys.stderr, flush=True)

    def forget(self) -> None:
        """Continue as if no signal had come: it was meant for something else, such as a server, which has ended."""
        self.heard, self._raised = 0, False

    def _handle(self, number: int, frame: FrameType | None) -> None:
        self.heard = self.heard or number
        if self._pipe:
            with contextlib.suppress(OSError):
                os.write(self._pipe, bytes([number]))
        if self._running and not (self._watched and self._raised):  # cleaning up after the first signal is not interrupted
            self._raised = True
            raise KeyboardInterrupt

    def _ignore(self) -> None:
        """Let a command that has ended exit with its own status: Python ignores signals from here on."""
        for number in self._handlers:
            signal.signal(number, signal.SIG_IGN)

    def _unraisable(self, found: Any) -> None:
        if self.heard and isinstance(found.exc_value, KeyboardInterrupt):
            self._raised, self._lost = False, True
        elif not self.heard:
            self._hooks[0](found)

    def _in_thread(self, found: Any) -> None:
        if not self.heard:  # errors in threads after a stop are not shown
            self._hooks[1](found)

    def _watch(self) -> None:
        with contextlib.suppress(OSError, ValueError, RuntimeError, AttributeError):  # not available on every system
            reading, self._pipe = os.pipe()
            os.set_blocking(self._pipe, False)
            # Python writes to the pipe at once, even if it cannot run a handler
            signal.set_wakeup_fd(self._pipe, warn_on_full_buffer=False)
            threading.Thread(target=self._wait, args=(reading,), name="stopping", daemon=True).start()
            self._watched = True

    def _wait(self, reading: int) -> None:
        while True:
            numbers = [number for number in os.read(reading, 64) if number in STOPS and _is_ours(number)]
            if not numbers:
                continue
            self.heard = self.heard or numbers[0]
            late = time.monotonic() + PATIENCE
            while self.heard and time.monotonic() < late:
                time.sleep(LOOKS)
                if self._lost:
                    self._lost = False
                    _thread.interrupt_main(signal.Signals(self.heard))
            if self.heard:
                self.end_now()

    def end_now(self) -> None:
        """Clean up, print the message and end the process."""
        self._running = False
        try:
            clean_up()
            if not self._said:
                # a progress bar may have hidden the cursor
                shown = "\r\x1b[K\x1b[?25h" if os.isatty(2) and os.environ.get("TERM", "dumb") != "dumb" else ""
                # skip the message if nobody reads stderr, since writing would block forever
                if select.select([], [2], [], 0.0)[1]:
                    os.write(2, f"{shown}{self.words()}\n".encode())
        finally:
            os._exit(128 + self.heard)


def _is_ours(number: int) -> bool:
    """Return True if a handler of this package gets a signal; a server that has replaced it ends by itself."""
    return str(getattr(signal.getsignal(number), "__module__", "")).startswith("hophoop.")


_now: Stopping | None = None


def stop_on_signals(alone: bool) -> contextlib.AbstractContextManager[Stopping]:
    """Return a `Stopping` context, or the current one."""
    return Stopping(alone) if _now is None else contextlib.nullcontext(_now)


def say_when_stopped(words: Callable[[], str]) -> None:
    """Set the message about a stop, instead of 'Stopped.'."""
    if _now is not None:
        _now.words = words


def end_now() -> None:
    """End the process after a stop, if it only runs the command."""
    if _now is not None and _now.alone and _now.heard:
        _now.end_now()


def forget() -> None:
    """Continue as if no signal had come."""
    if _now is not None:
        _now.forget()
