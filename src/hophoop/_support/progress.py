"""Progress of long computations: a bar on a terminal, and reports while a kernel runs."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Protocol, TypeVar

import numpy as np

if TYPE_CHECKING:
    from rich.progress import ProgressColumn

Result = TypeVar("Result")
LOOKS = 0.1  # s between two reports
SOON = 1.0  # s until the bar of a share appears: most motions take less


class Report(Protocol):
    """Shows the part that is done."""

    def __call__(self, done: float, total: float | None = 1.0, title: str | None = None) -> None:
        """Show the part done of the whole, and change the title if one is given."""


@contextmanager
def waiting(title: str, *, quiet: bool = False) -> Iterator[None]:
    """Show on a terminal's standard error that a computation of unknown length goes on.

    title: text next to the moving sign; quiet: show none.
    """
    from rich.console import Console

    console = Console(stderr=True)
    if quiet or not console.is_terminal:
        yield
        return
    with console.status(title):
        yield


@contextmanager
def bar(title: str, *, quiet: bool = False, share: bool = False, rate: bool = False) -> Iterator[Report | None]:
    """Show a progress bar on standard error.

    Parameters
    ----------
    title : str
        Text in front of the bar.
    quiet : bool, default False
        Show none.
    share : bool, default False
        For one computation, which reports a share: the bar has no counts, and appears after a second.
    rate : bool, default False
        Show also how many are done per second.

    Yields
    ------
    report : callable or None
        Takes the part done and the whole; to be given to functions as `progress`. None without a terminal or notebook.
    """
    from rich.console import Console

    console = Console(stderr=True)
    if quiet or not (console.is_terminal or console.is_jupyter):  # a file would get an empty line
        yield None
        return
    from rich.progress import MofNCompleteColumn, Progress

    counts: list[ProgressColumn] = [] if share else [MofNCompleteColumn()]
    if rate:
        counts.append(_rate_column())
    shown = Progress(*Progress.get_default_columns(), *counts, console=console, transient=True)
    task = shown.add_task(title, total=None)
    start = time.monotonic() + (SOON if share else 0.0)

    def report(done: float, total: float | None = 1.0, title: str | None = None) -> None:
        if time.monotonic() >= start:
            shown.start()
        shown.update(task, completed=done, total=total, description=title)

    try:
        yield report
    finally:
        if shown.live.is_started:
            shown.stop()


def _rate_column() -> ProgressColumn:
    from rich.progress import ProgressColumn, Task
    from rich.text import Text

    class Rate(ProgressColumn):
        """How many are done per second."""

        def render(self, task: Task) -> Text:
            speed = task.finished_speed or task.speed
            return Text("" if speed is None else f"{speed:,.0f} per second")

    return Rate()


def compute_reporting(compute: Callable[[np.ndarray], Result], progress: Callable[[float], object]) -> Result:
    """Compute in a second thread and report its progress from this one.

    compute: writes the share that is computed into the array, shape (1,), that it is called with [1]; progress: called with
    this share about ten times a second; result: the result of `compute`.
    """
    share = np.zeros(1)
    results: list[Result] = []
    errors: list[BaseException] = []

    def work() -> None:
        try:
            results.append(compute(share))
        except BaseException as error:
            errors.append(error)

    # compiled code releases the interpreter, so that this thread hears Ctrl-C; a daemon does not keep the process alive
    thread = threading.Thread(target=work, daemon=True)
    thread.start()
    while thread.is_alive():
        thread.join(LOOKS)
        progress(float(share[0]))
    if errors:
        raise errors[0]
    return results[0]
