"""Scheduling of requests: which process computes which request, time limits, and refusals when the lab is busy."""

from __future__ import annotations

import asyncio
import logging
import math
import time
from collections import deque
from collections.abc import Callable, Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from hophoop.lab.limits import Limits, TooBusy, TooMuch
from hophoop.lab.worker import ERROR, FAILED, Ended, Job, Worker

logger = logging.getLogger("hophoop.lab")

LIGHT, HEAVY, FILM = "light", "heavy", "film"
LOOK = 0.5  # seconds between checks whether code is being compiled
GRACE = 0.08  # seconds in which a process must react to a cancellation
USUAL_SECONDS = {LIGHT: 0.05, HEAVY: 1.0, FILM: 15.0}  # initial estimates, until requests have been measured
TRIES = 2  # a process that the system has ended is replaced once


class Lane:
    """Lane for requests of one kind: how many compute at a time, the queue, and the mean time of a request."""

    def __init__(self, kind: str, places: int) -> None:
        self.places = places
        self.taken = 0
        self.seconds = USUAL_SECONDS[kind]
        self.queue: deque[asyncio.Future[None]] = deque()

    def wait(self) -> float:
        """Return the waiting time of a request that arrives now [s]."""
        ahead = self.taken + len(self.queue) - self.places + 1
        return max(math.ceil(ahead / self.places), 0) * self.seconds

    def measured(self, seconds: float) -> None:
        """Update the mean time with a computed request."""
        self.seconds += 0.2 * (seconds - self.seconds)

    async def enter(self, most: float, beginning: Callable[[], bool] = lambda: False) -> None:
        """Wait for a slot, in order of arrival; time in which a process starts does not count.

        Raises
        ------
        TimeoutError
            If there is no slot within `most` seconds.
        """
        if self.taken < self.places:
            self.taken += 1
            return
        place: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self.queue.append(place)
        try:
            while most > 0.0 and not place.done():
                look = min(most, LOOK)
                await asyncio.wait({place}, timeout=look)
                if not beginning():
                    most -= look
            if not place.done():
                raise TimeoutError
        except BaseException:
            if place.done() and not place.cancelled():
                self.leave()  # the slot was granted at this very moment
            elif place in self.queue:
                self.queue.remove(place)
            raise

    def leave(self) -> None:
        """Pass the slot on."""
        while self.queue:
            following = self.queue.popleft()
            if not following.done():
                following.set_result(None)
                return
        self.taken -= 1


class Workers:
    """The processes that compute, and the lanes in front of them.

    Parameters
    ----------
    limits : Limits
    start : callable, optional
        Function that starts a process.
    """

    def __init__(self, limits: Limits, start: Callable[[], Any] = Worker) -> None:
        self.limits = limits
        self._start = start
        count = max(limits.processes, 1)
        # one process is reserved for light requests
        self.lanes = {LIGHT: Lane(LIGHT, count), HEAVY: Lane(HEAVY, max(count - 1, 1)), FILM: Lane(FILM, 1)}
        self._free: deque[Any] = deque()
        self._places = Lane(LIGHT, count + 1)  # one more for a film
        self._all: set[Any] = set()
        self._stopping: set[asyncio.Task[None]] = set()
        # threads only wait for the processes
        self._threads = ThreadPoolExecutor(2 * count + 8, "hophoop-lab")

    def prepare(self) -> None:
        """Start the processes, so that the first request need not wait for one."""
        while len(self._all) < max(self.limits.processes, 1):
            self._free.append(self._new())

    def close(self) -> None:
        """End all processes, whatever they compute."""
        for worker in self._all:
            worker.end()
        self._all.clear()
        self._free.clear()
        self._threads.shutdown(wait=False, cancel_futures=True)

    @property
    def computing(self) -> int:
        """Number of requests that are being computed or stopped."""
        return self._places.taken

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
        lane = self.lanes[kind]
        queue = self.limits.queue if kind != FILM else self.limits.film_queue
        if lane.wait() > queue or len(lane.queue) >= self.limits.waiting:
            raise TooBusy.after(lane.wait())
        try:
            await lane.enter(queue, self._beginning)
        except TimeoutError:
            raise TooBusy.after(lane.wait()) from None
        try:
            patience = self.limits.film_patience if kind == FILM else self.limits.patience
            said, content, seconds = await self._computed(job, patience)
            lane.measured(seconds)
        except TooMuch:
            lane.measured(patience)
            raise
        finally:
            lane.leave()
        if said == ERROR:
            raise content
        if said == FAILED:
            logger.error("A request failed in the process that computed it:\n%s", content)
            raise RuntimeError("The computation failed.")
        return bytes(content)

    def _beginning(self) -> bool:
        return any(worker.beginning for worker in self._all)

    async def _computed(self, job: Job, patience: float) -> tuple[str, Any, float]:
        """Return a process's answer, and the computing time without its process's start [s]."""
        for last in (False, True):
            try:
                await self._places.enter(self.limits.queue, self._beginning)
            except TimeoutError:  # films and jobs that are being stopped occupy the slots
                raise TooBusy.after(self.lanes[HEAVY].seconds) from None
            worker = self._take()
            exchange = self._beside(worker.exchange, job)
            left, begin, began = patience, time.monotonic(), False
            try:
                while not exchange.done() and left > 0.0:
                    look = min(left, LOOK)
                    await asyncio.wait({exchange}, timeout=look)
                    if worker.beginning:
                        began = True
                    else:
                        left -= look
                if not exchange.done():
                    self._stop(worker, exchange)
                    raise TooMuch(f"This takes longer than {patience:g} s; ask for a shorter motion or fewer cells.")
                said: tuple[str, Any] = exchange.result()
            except asyncio.CancelledError:
                self._stop(worker, exchange)
                raise
            except Ended:
                self._dismiss(worker)
                self._places.leave()
                if last:
                    raise RuntimeError("The process that computed this has ended.") from None
                continue
            self._give_back(worker)
            took = time.monotonic() - begin
            return *said, min(took, patience - left) if began else took
        raise AssertionError

    def _beside(self, call: Callable[..., Any], *arguments: Any) -> asyncio.Future[Any]:
        return asyncio.get_running_loop().run_in_executor(self._threads, call, *arguments)

    def _new(self) -> Any:
        worker = self._start()
        self._all.add(worker)
        return worker

    def _take(self) -> Any:
        while self._free:
            worker = self._free.popleft()
            if worker.running:
                return worker
            self._dismiss(worker)
        return self._new()

    def _give_back(self, worker: Any) -> None:
        self._free.append(worker)
        self._places.leave()

    def _dismiss(self, worker: Any) -> None:
        self._all.discard(worker)
        worker.end()

    def _stop(self, worker: Any, exchange: asyncio.Future[Any]) -> None:
        task = asyncio.ensure_future(self._stopped(worker, exchange))
        self._stopping.add(task)
        task.add_done_callback(self._stopping.discard)

    async def _stopped(self, worker: Any, exchange: asyncio.Future[Any]) -> None:
        """Stop a cancelled job: ask its process, and end the process if it does not react."""
        try:
            if not worker.interrupt():
                raise Ended
            while worker.beginning and not exchange.done():  # it cannot react yet
                await asyncio.wait({exchange}, timeout=GRACE)
            async with asyncio.timeout(GRACE):
                await asyncio.shield(exchange)
        except (TimeoutError, Ended):
            self._dismiss(worker)
            exchange.add_done_callback(_forget)
            self._places.leave()
            if len(self._all) < max(self.limits.processes, 1):
                self._free.append(self._new())
        else:
            self._give_back(worker)


def _forget(future: asyncio.Future[Any]) -> None:
    if not future.cancelled():
        future.exception()


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
