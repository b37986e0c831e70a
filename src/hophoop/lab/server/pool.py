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
from concurrent.futures import BrokenExecutor, Future
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
STARTS = 5.0  # seconds that processes may take to start
CHECK = 0.5  # seconds between checks whether the pool is still there
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
        self._starting = threading.Lock()
        self._files = contextlib.ExitStack()
        self._closed = False

    def prepare(self) -> None:
        """Start the processes, so that the first request need not wait for them."""
        self._begun()

    def close(self) -> None:
        """End all processes, whatever they compute."""
        self._closed = True
        waited = self._starting.acquire(timeout=STARTS)  # processes that begin without a server complain
        if self._processes is not None:
            self._processes.stop()
            self._processes.join()
        self._files.close()
        if waited:
            self._starting.release()

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
            processes = self._processes if self._ready() else await asyncio.wrap_future(self._begun())
            try:
                future = asyncio.wrap_future(processes.schedule(outcome, [job], timeout=patience))
                await _settled(future, processes)
                content: bytes = future.result()
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

    def _ready(self) -> bool:
        return self._processes is not None and self._processes.active

    def _begun(self) -> Future[Any]:
        """Start processes if there are none, or if their pool is broken; that takes a moment, in which others are answered."""
        future: Future[Any] = Future()
        future.set_running_or_notify_cancel()  # a client that leaves does not cancel it

        def begin() -> None:
            try:
                with self._starting:
                    if not self._ready() and not self._closed:
                        if self._processes is not None:
                            self._processes.stop()
                            self._processes.join()
                        made = self._make(self._count)
                        made.active  # noqa: B018  starts them
                        self._processes = made
                if self._closed:
                    raise asyncio.CancelledError
                future.set_result(self._processes)
            except BaseException as error:
                future.set_exception(error)

        threading.Thread(target=begin, name="hophoop-lab", daemon=True).start()  # the server does not wait for it at its end
        return future

    def _started(self, count: int) -> Any:
        pebble.CONSTS.sleep_unit, pebble.CONSTS.term_timeout = LOOK, GRACE
        self._folder = self._files.enter_context(temporary_folder("hophoop-lab-"))
        return pebble.ProcessPool(count, initializer=prepare, initargs=[str(self._folder)], context=_Context())


async def _settled(future: asyncio.Future[bytes], processes: Any) -> None:
    """Wait for a job; a pool that breaks may leave it unanswered."""
    try:
        while not (await asyncio.wait({future}, timeout=CHECK))[0]:
            if not processes.active:
                raise BrokenExecutor("the pool is broken")
    except BaseException:
        future.cancel()
        raise


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
