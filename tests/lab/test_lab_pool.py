"""Processes that compute for the lab: work that ends when it is due, and waiting that is honest."""

import asyncio
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace

import pytest

pytest.importorskip("fastapi", reason="the extra 'lab' is not installed")
pebble = pytest.importorskip("pebble", reason="the extra 'lab' is not installed")

import hophoop as hh  # noqa: E402
from hophoop.lab.api import calls  # noqa: E402
from hophoop.lab.api.limits import USUAL, TooBusy, TooMuch  # noqa: E402
from hophoop.lab.server.pool import FILM, HEAVY, LIGHT, Pool, while_connected  # noqa: E402
from hophoop.lab.server.work import Job  # noqa: E402
from hophoop.scenario import InputError, Scenario, Start  # noqa: E402
from lab_tools import POSIX  # noqa: E402


def alone(coroutine):
    """Run in a thread of its own: the browser tests leave a running loop in this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, coroutine).result()


class Processes:
    """Stands for the processes: a job is a number of seconds, an event to wait for, or an error."""

    def __init__(self, count):
        self.count, self.active, self.running = count, True, 0

    def schedule(self, _, args, timeout):
        future, (job,) = Future(), args

        def compute():
            self.running += 1
            event = job if isinstance(job, threading.Event) else threading.Event()
            end = time.monotonic() + (job if isinstance(job, float) else 20.0)
            late = time.monotonic() + timeout
            while time.monotonic() < min(end, late) and not event.is_set() and not future.cancelled():
                time.sleep(0.002)
            self.running -= 1
            if future.cancelled():
                return
            if late <= time.monotonic():
                future.set_exception(TimeoutError())
            else:
                future.set_result(b"done")

        if isinstance(job, Exception):
            future.set_exception(job)
        else:
            threading.Thread(target=compute, daemon=True).start()
        return future

    def stop(self):
        self.active = False

    def join(self):
        pass


def pool(**limits):
    return Pool(replace(USUAL, **limits), Processes)


def test_only_computing_counts_and_not_waiting():
    """Five that take 0.2 s each, one after the other, are all answered though each may compute for 0.5 s only."""

    async def run():
        computing = pool(processes=1, patience=0.5)
        assert await asyncio.gather(*[computing.run(0.2, LIGHT) for _ in range(5)]) == [b"done"] * 5

    alone(run())


def test_who_would_wait_too_long_is_told_at_once_and_how_long():
    async def run():
        computing = pool(processes=1, queue=100.0)
        computing.lanes[HEAVY].seconds = 80.0
        leave = threading.Event()
        inside = [asyncio.create_task(computing.run(leave, HEAVY))]
        await asyncio.sleep(0.02)
        inside.append(asyncio.create_task(computing.run(leave, HEAVY)))  # waits 80 s
        await asyncio.sleep(0.02)
        begin = time.monotonic()
        with pytest.raises(TooBusy, match="try again in 160 seconds") as busy:
            await computing.run(leave, HEAVY)  # would wait 160 s
        assert time.monotonic() - begin < 10.0
        assert busy.value.seconds == 160
        leave.set()
        assert await asyncio.gather(*inside) == [b"done"] * 2
        assert await computing.run(0.0, HEAVY) == b"done"

    alone(run())


def test_who_has_waited_too_long_is_told_so():
    async def run():
        computing = pool(processes=1, queue=0.1)
        computing.lanes[HEAVY].seconds = 0.05
        leave = threading.Event()
        inside = asyncio.create_task(computing.run(leave, HEAVY))
        await asyncio.sleep(0.02)
        with pytest.raises(TooBusy):
            await computing.run(0.0, HEAVY)
        leave.set()
        assert await inside == b"done"
        assert await computing.run(0.0, HEAVY) == b"done"

    alone(run())


def test_no_more_wait_than_may():
    async def run():
        computing = pool(processes=1, waiting=2)
        leave = threading.Event()
        inside = [asyncio.create_task(computing.run(leave, LIGHT)) for _ in range(3)]
        await asyncio.sleep(0.02)
        with pytest.raises(TooBusy):
            await computing.run(leave, LIGHT)
        leave.set()
        assert await asyncio.gather(*inside) == [b"done"] * 3

    alone(run())


def test_it_learns_how_long_things_take():
    async def run():
        computing = pool(processes=1)
        before = computing.lanes[HEAVY].seconds
        for _ in range(20):
            await computing.run(0.01, HEAVY)
        assert computing.lanes[HEAVY].seconds < 0.3 * before

    alone(run())


def test_what_is_light_is_answered_while_what_is_heavy_computes():
    async def run():
        computing = pool(processes=2)
        leave = threading.Event()
        heavy = [asyncio.create_task(computing.run(leave, HEAVY)) for _ in range(4)]
        films = [asyncio.create_task(computing.run(leave, FILM)) for _ in range(4)]
        await asyncio.sleep(0.05)
        # of three processes one is left for it
        assert computing._processes.count - computing._processes.running == 1
        assert await asyncio.wait_for(computing.run(0.0, LIGHT), 2.0) == b"done"
        leave.set()
        await asyncio.gather(*heavy, *films)

    alone(run())


def test_who_goes_away_takes_the_work_along():
    async def run():
        computing = pool(processes=1)
        leaving = asyncio.Event()
        asked = asyncio.create_task(while_connected(computing.run(30.0, LIGHT), leaving.wait()))
        await asyncio.sleep(0.05)
        assert computing._processes.running == 1
        leaving.set()
        assert await asked is None
        await asyncio.sleep(0.2)
        assert computing._processes.running == 0
        # who waits only is simply left out
        leave = threading.Event()
        one = asyncio.create_task(computing.run(leave, LIGHT))
        await asyncio.sleep(0.02)
        two = asyncio.create_task(computing.run(leave, LIGHT))
        await asyncio.sleep(0.02)
        two.cancel()
        leave.set()
        assert await one == b"done"
        assert await computing.run(0.0, LIGHT) == b"done"

    alone(run())


def test_cancelled_films_block_no_film():
    async def run():
        computing = pool(processes=1)
        for _ in range(4):
            film = asyncio.create_task(computing.run(30.0, FILM))
            await asyncio.sleep(0.03)
            film.cancel()
        assert await asyncio.wait_for(computing.run(0.0, FILM), 5.0) == b"done"

    alone(run())


def test_a_pool_that_is_broken_is_replaced():
    async def run():
        computing = pool(processes=1)
        with pytest.raises(RuntimeError, match="has ended"):
            await computing.run(pebble.ProcessExpired("it ended"), LIGHT)
        first = computing._processes
        first.active = False
        assert await computing.run(0.0, LIGHT) == b"done"
        assert computing._processes is not first
        computing.close()
        assert not computing._processes.active

    alone(run())


# Real processes

HOSTILE = replace(USUAL, events=10_000_000, duration=1e9, turns=1e30, map_turns=1e30, map_seconds=1e30)
AXES = {
    "x": {"path": "start.speed", "from": 1.0, "to": 5.0, "cells": 250},
    "y": {"path": "plane.mu", "from": 0.2, "to": 1.0, "cells": 250},
}
FOREVER = Scenario(start=Start.rolling(2.8), duration=1e7, contact=hh.Rigid(max_events=10_000_000))
JOBS = {
    "a map": Job(calls.read("map", {**AXES, "what": "end_angle", "scenario": {"duration": 20.0}}, HOSTILE), HOSTILE, "packed"),
    "a motion within the kernel": Job(calls.read("motion", {"scenario": FOREVER.to_dict()}, HOSTILE), HOSTILE, "packed"),
    "a film": Job(calls.read("motion", {"query": "duration=20"}), USUAL, "motion.gif"),
}
SMALL = Job(calls.read("motion", {"query": "duration=1"}), USUAL, "packed")


@pytest.fixture
def computing():
    made = Pool(replace(HOSTILE, processes=1, patience=60.0, queue=60.0))
    yield made
    made.close()


def pids(computing):
    return set(computing._processes._pool_manager.worker_manager.workers)


async def begun(computing):
    """Wait until a process computes: a job that is given up while it waits for one ends none."""
    async with asyncio.timeout(120.0):
        while not any(task.started for task in list(computing._processes._pool_manager.task_manager.tasks.values())):
            await asyncio.sleep(0.005)


async def ended(numbers):
    """Wait until one of some processes has ended: in 0.03 to 0.15 s where nothing else is at work."""
    async with asyncio.timeout(120.0):
        while all(_lives(number) for number in numbers):
            await asyncio.sleep(0.005)


def _lives(number):
    try:
        os.kill(number, 0)
    except ProcessLookupError:
        return False
    return True


@POSIX
@pytest.mark.parametrize("name", JOBS)
def test_a_cancelled_job_ends_with_its_process_and_another_takes_its_place(computing, name):
    async def run():
        assert len(await computing.run(SMALL, LIGHT)) > 10_000
        before = pids(computing)
        task = asyncio.ensure_future(computing.run(JOBS[name], HEAVY))
        await begun(computing)
        await asyncio.sleep(1.0)
        task.cancel()
        await ended(before)
        assert await asyncio.gather(*[computing.run(SMALL, LIGHT) for _ in range(3)])
        assert pids(computing) - before

    alone(run())


@POSIX
@pytest.mark.parametrize("name", ["a map", "a motion within the kernel"])
def test_what_takes_too_long_is_stopped(computing, name, monkeypatch):
    async def run():
        await computing.run(SMALL, LIGHT)
        before = pids(computing)
        monkeypatch.setattr(computing, "limits", replace(computing.limits, patience=0.3))
        with pytest.raises(TooMuch, match=r"longer than 0\.3 s"):
            await computing.run(JOBS[name], HEAVY)
        monkeypatch.undo()
        await ended(before)
        assert len(await computing.run(SMALL, LIGHT)) > 10_000

    alone(run())


@POSIX
def test_processes_that_the_system_ends_are_replaced(computing):
    async def run():
        await computing.run(SMALL, LIGHT)
        for number in pids(computing):  # also those that compute nothing, which breaks a pool of pebble
            os.kill(number, signal.SIGKILL)
        assert len(await computing.run(SMALL, LIGHT)) > 10_000

    alone(run())


def test_refusals_and_defects_come_back(computing, caplog):
    async def run():
        with pytest.raises(InputError, match="at most 20 s for a film"):
            await computing.run(Job(calls.read("motion", {"query": "duration=21"}), USUAL, "motion.gif"), FILM)
        with pytest.raises(RuntimeError, match="The computation failed"):
            await computing.run(Job(None, USUAL, "json"), LIGHT)

    alone(run())
    assert "in outcome" in caplog.text
    assert "AttributeError" in caplog.text


@POSIX
def test_films_that_are_given_up_leave_no_files():
    computing = Pool(replace(USUAL, processes=1))

    async def run():
        await computing.run(SMALL, LIGHT)
        for wait in (0.5, 1.0):
            before = pids(computing)
            task = asyncio.ensure_future(computing.run(JOBS["a film"], FILM))
            await begun(computing)
            await asyncio.sleep(wait)
            task.cancel()
            await ended(before)

    alone(run())
    folder = computing._folder
    assert folder.is_dir()
    computing.close()
    assert not folder.exists()


SCRIPT = """
import asyncio
from hophoop.lab.api import calls
from hophoop.lab.api.limits import USUAL
from hophoop.lab.server.pool import LIGHT, Pool
from hophoop.lab.server.work import Job
print("once")
pool = Pool(USUAL)
job = Job(calls.read("motion", {"query": "duration=1"}), USUAL, "json")
print(len(asyncio.run(pool.run(job, LIGHT))) > 1000)
pool.close()
"""


def test_a_script_needs_no_guard(tmp_path):
    """Processes of multiprocessing import the script that starts them, which would start a server in each."""
    (tmp_path / "script.py").write_text(SCRIPT)
    words = [sys.executable, str(tmp_path / "script.py")]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120.0, check=False)
    assert done.stdout == "once\nTrue\n", done.stderr
    assert done.stderr == ""
