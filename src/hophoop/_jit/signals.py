"""Ctrl-C and SIGTERM while Numba loads or compiles: kept until it has ended.

LLVM asks Numba for cached code from within itself. What a handler raises there has no caller that it could reach: Python
prints it and goes on, and the person's Ctrl-C is lost.
"""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Any

Handler = Callable[[int, FrameType | None], Any]
KEPT = (signal.SIGINT, signal.SIGTERM)


@contextlib.contextmanager
def kept() -> Iterator[None]:
    """Within this, the first signal of a kind waits for the end, where its handler is called; a second one does not wait."""
    if threading.current_thread() is not threading.main_thread():  # handlers run in the main thread alone
        yield
        return
    handlers: dict[int, Handler] = {number: found for number in KEPT if callable(found := signal.getsignal(number))}
    waiting: list[int] = []

    def keep(number: int, frame: FrameType | None) -> None:
        if number in waiting:
            handlers[number](number, frame)
        waiting.append(number)

    try:
        for number in handlers:
            signal.signal(number, keep)
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
        for number in dict.fromkeys(waiting):
            handlers[number](number, None)
