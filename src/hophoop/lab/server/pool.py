"""Scheduling of requests: which process computes which request, time limits, and refusals when the lab is busy."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import math
import multiprocessing
import sys
import threading
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import BrokenExecutor, ThreadPoolExecutor
from types import ModuleType
from typing import Any

import pebble

from hophoop._support.extras import MissingExtra
from hophoop._support.stopping import temporary_folder
from hophoop.lab.api.limits import Limits, TooBusy, TooMuch
from hophoop.lab.server.work import Job, outcome, prepare
from hophoop.scenario import InputError

logger = logging.getLogger("hophoop.lab")

LIGHT, HEAVY, FILM = "light", "heavy", "film"
USUAL_SECONDS = {LIGHT: 0.05, HEAVY: 1.0, FILM: 15.0}  # initial estimates, until requests have been measured
LOOK = 0.02  # seconds between the pool's checks for cancelled and late jobs
GRACE = 0.1  # seconds in which a stopped process may remove its files

_starting = threading.Lock()


@contextlib.contextmanager
def _without_main() -> Iterator[None]:
    """Context in which a new process does not import the main program: a script needs no `if __name__ == "__main__"`."""
    with _starting:
        main, sys.modules["__main__"] = sys.modules["__main__"], ModuleType("__main__")
        try:
            yield
        finally:
            sys.modules["__main__"] = main


# A new process is a copy of one that has imported everything, which takes milliseconds, except on Windows.
_METHOD: Any = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
_usual: Any = multiprocessing.get_context(_METHOD)
if _METHOD == "forkserver":
    _usual.set_forkserver_preload([__name__])


class _Process(_usual.Process):  # type: ignore[misc]
    def start(self) -> None:
        with _without_main():
            super().start()


class _Context(type(_usual)):  # type: ignore[misc]
    Process = _Process


class Lane:
    """Lane for requests of one kind: how many compute at a time, how many wait, and the mean time of a request."""

    def __init__(self, kind: str, places: int) -> None:
        self.places = places
        self.seconds = USUAL_SECONDS[kind]
        self.inside = 0
        self._free = asyncio.Semaphore(places)

    def wait(self) -> float:
        """Return the waiting time of a request that arrives now [s]."""
        ahead = self.inside - self.places + 1
        return max(math.ceil(ahead / self.places), 0) * self.seconds

    def measured(self, seconds: float) -> None:
        """Update the mean time with a computed request."""
        self.seconds += 0.2 * (seconds - self.seconds)

    @contextlib.asynccontextmanager
    async def place(self, queue: float, waiting: int) -> Any:
        """Wait for a place, in order of arrival.

        Parameters
        ----------
        queue : float
            Maximum waiting time [s].
        waiting : int
            Maximum number of waiting requests [1].

        Raises
        ------
        TooBusy
            If the request has to wait longer; at once if that is foreseen.
        """
        if self.wait() > queue or self.inside - self.places >= waiting:
            raise TooBusy.after(self.wait())
        self.inside += 1
        try:
            try:
                async with asyncio.timeout(queue):
                    await self._free.acquire()
            except TimeoutError:
                raise TooBusy.after(self.wait()) from None
            try:
                yield
            finally:
                self._free.release()
        finally:
            self.inside -= 1


class Pool:
    """The processes that compute, and the lanes in front of them.

    Parameters
    ----------
    limits : Limits
    make : callable, optional
        Makes the pool of processes for a number of them.
    """

    def __init__(self, limits: Limits, make: Callable[[int], Any] | None = None) -> None:
        self.limits = limits
        self._make = self._started if make is None else make
        count = max(limits.processes, 1)
        # one process is reserved for light requests
        self.lanes = {LIGHT: Lane(LIGHT, count), HEAVY: Lane(HEAVY, max(count - 1, 1)), FILM: Lane(FILM, 1)}
        self._count = count + 1  # one more for a film
        self._processes: Any = None
        self._thread = ThreadPoolExecutor(1, "hophoop-lab")  # starting processes takes a moment, in which others are answered
        self._files = contextlib.ExitStack()
        self._closed = False

    def prepare(self) -> None:
        """Start the processes, so that the first request need not wait for them."""
        self._thread.submit(self._running)

    def close(self) -> None:
        """End all processes, whatever they compute."""
        self._closed = True
        if self._processes is not None:
            self._processes.stop()
            self._processes.join()
        self._thread.shutdown(wait=False, cancel_futures=True)
        self._files.close()

    async def run(self, job: Job, kind: str) -> bytes:
        """Compute a job in a process; stop it if the client disconnects or the time is up.

        Parameters
        ----------
        job : Job
        kind : str
            `LIGHT`, `HEAVY` or `FILM`.

        Returns
        -------
        content : bytes

        Raises
        ------
        TooBusy
            If the request would have to wait too long.
        TooMuch
            If the computation takes too long.
        InputError, MissingExtra
            As raised by the computation.
        RuntimeError
            If the computation fails because of a defect.
        """
        film = kind == FILM
        lane, patience = self.lanes[kind], self.limits.film_patience if film else self.limits.patience
        async with lane.place(self.limits.film_queue if film else self.limits.queue, self.limits.waiting):
            begin = asyncio.get_running_loop().time()
            try:
                content = await self._computed(job, patience)
            except TimeoutError:
                lane.measured(patience)
                raise TooMuch(f"This takes longer than {patience:g} s; ask for a shorter motion or fewer cells.") from None
            lane.measured(asyncio.get_running_loop().time() - begin)
            return content

    async def _computed(self, job: Job, patience: float) -> bytes:
        for last in (False, True):
            processes = await asyncio.wrap_future(self._thread.submit(self._running))
            try:
                content: bytes = await asyncio.wrap_future(processes.schedule(outcome, [job], timeout=patience))
            except (InputError, MissingExtra, TimeoutError, asyncio.CancelledError):
                raise
            except (pebble.ProcessExpired, BrokenExecutor) as error:  # the system has ended the process
                if last:
                    logger.error("The process that computed a request has ended: %s", error)
                    raise RuntimeError("The process that computed this has ended.") from None
            except Exception as error:
                logger.error("A request failed in the process that computed it.", exc_info=error)
                raise RuntimeError("The computation failed.") from None
            else:
                return content
        raise AssertionError

    def _running(self) -> Any:
        """Return the pool of processes, a new one if there is none or if it is broken."""
        if self._closed:
            raise asyncio.CancelledError
        if self._processes is None or not self._processes.active:
            if self._processes is not None:
                self._processes.stop()
                self._processes.join()
            self._processes = self._make(self._count)
            self._processes.active  # noqa: B018  starts them
        return self._processes

    def _started(self, count: int) -> Any:
        pebble.CONSTS.sleep_unit, pebble.CONSTS.term_timeout = LOOK, GRACE
        folder = self._files.enter_context(temporary_folder("hophoop-lab-"))
        return pebble.ProcessPool(count, initializer=prepare, initargs=[str(folder)], context=_Context())


async def while_connected(work: Coroutine[Any, Any, bytes], gone: Coroutine[Any, Any, None]) -> bytes | None:
    """Run `work` until it is done or the client disconnects.

    Parameters
    ----------
    work : coroutine
        Cancelled when the client disconnects.
    gone : coroutine
        Ends when the client disconnects.

    Returns
    -------
    content : bytes or None
        None if the client has disconnected.
    """
    tasks = working, _ = asyncio.ensure_future(work), asyncio.ensure_future(gone)
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        return working.result() if working.done() else None
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
