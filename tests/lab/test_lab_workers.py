"""Processes that compute for the lab: work that ends when it is due, and waiting that is honest."""

import asyncio
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest

pytest.importorskip("fastapi", reason="the extra 'lab' is not installed")
pytest.importorskip("httpx", reason="httpx is not installed")
uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

from hophoop.lab.worker import ANSWER, STOPPED, Ended, Job, Worker  # noqa: E402

import hophoop as hh  # noqa: E402
from hophoop.lab import workers  # noqa: E402
from hophoop.lab.api import calls  # noqa: E402
from hophoop.lab.api.limits import USUAL, TooBusy, TooMuch  # noqa: E402
from hophoop.lab.server.pool import FILM, GRACE, HEAVY, LIGHT, Workers, while_connected  # noqa: E402
from hophoop.scenario import Scenario, Start  # noqa: E402
from lab_tools import POSIX  # noqa: E402


def alone(coroutine):
    """Run in a thread of its own: the browser tests leave a running loop in this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, coroutine).result()


class Process:
    """Stands for a process: a job is a number of seconds, or an event to wait for."""

    made: list = []  # noqa: RUF012
    beginning = False

    def __init__(self, listens=True):
        self.listens, self.running = listens, True
        self.stopped = threading.Event()
        self.jobs = 0
        self.made.append(self)

    def exchange(self, job):
        self.jobs += 1
        self.stopped.clear()
        if job == "dies":
            self.running = False
            raise Ended
        event = threading.Event() if isinstance(job, float) else job
        end = time.monotonic() + (job if isinstance(job, float) else 20.0)
        while time.monotonic() < end and not event.is_set():
            if not self.running:
                raise Ended
            if self.stopped.is_set() and self.listens:
                return STOPPED, None
            time.sleep(0.002)
        return ANSWER, b"done"

    def interrupt(self):
        self.stopped.set()
        return True

    def end(self):
        self.running = False


@pytest.fixture
def made():
    Process.made = []
    return Process.made


def pool(start=Process, **limits):
    return Workers(replace(USUAL, **limits), start)


def test_only_computing_counts_and_not_waiting(made):
    """Five that take 0.2 s each, one after the other, are all answered though each may compute for 0.5 s only."""

    async def run():
        computing = pool(processes=1, patience=0.5)
        found = await asyncio.gather(*[computing.run(0.2, LIGHT) for _ in range(5)])
        assert found == [b"done"] * 5
        assert len(made) == 1

    alone(run())


def test_who_would_wait_too_long_is_told_at_once_and_how_long(made):
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


def test_it_learns_how_long_things_take(made):
    async def run():
        computing = pool(processes=1)
        before = computing.lanes[HEAVY].seconds
        for _ in range(20):
            await computing.run(0.01, HEAVY)
        assert computing.lanes[HEAVY].seconds < 0.3 * before

    alone(run())


def test_what_is_light_is_answered_while_what_is_heavy_computes(made):
    async def run():
        computing = pool(processes=2)
        leave = threading.Event()
        heavy = [asyncio.create_task(computing.run(leave, HEAVY)) for _ in range(4)]
        await asyncio.sleep(0.05)
        assert await asyncio.wait_for(computing.run(0.0, LIGHT), 2.0) == b"done"
        leave.set()
        await asyncio.gather(*heavy)

    alone(run())


@pytest.mark.parametrize("listens", [True, False])
def test_what_takes_too_long_is_stopped(made, listens):
    """A process that can stop is kept; one that cannot is ended. Either way nothing goes on computing."""

    async def run():
        computing = pool(lambda: Process(listens), processes=1, patience=0.05)
        with pytest.raises(TooMuch, match=r"longer than 0\.05 s"):
            await computing.run(30.0, LIGHT)
        (first,) = made
        await asyncio.sleep(GRACE + 0.3)
        assert first.running == listens
        assert computing.computing == 0
        assert await computing.run(0.0, LIGHT) == b"done"
        assert (first.jobs == 2) == listens

    alone(run())
    assert GRACE < 0.1


def test_time_in_which_a_process_begins_does_not_count(made, monkeypatch):
    monkeypatch.setattr(workers, "LOOK", 0.01)
    monkeypatch.setattr(Process, "beginning", True)

    async def run():
        computing = pool(processes=1, patience=0.05, queue=0.1)
        before = computing.lanes[LIGHT].seconds
        asked = [computing.run(0.3, LIGHT), computing.run(0.3, LIGHT)]  # the second one waits meanwhile
        assert await asyncio.gather(*asked) == [b"done"] * 2
        assert computing.lanes[LIGHT].seconds <= before  # nor is it learnt

    alone(run())


def test_who_goes_away_takes_the_work_along(made):
    async def run():
        computing = pool(processes=1)
        leaving = asyncio.Event()
        asked = asyncio.create_task(while_connected(computing.run(30.0, LIGHT), _wait(leaving)))
        await asyncio.sleep(0.05)
        assert computing.computing == 1
        leaving.set()
        assert await asked is None
        await asyncio.sleep(0.2)
        assert computing.computing == 0
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

    async def _wait(event):
        await event.wait()

    alone(run())


def test_cancelled_films_block_no_film(made):
    async def run():
        computing = pool(processes=1)
        for _ in range(4):
            film = asyncio.create_task(computing.run(30.0, FILM))
            await asyncio.sleep(0.03)
            film.cancel()
        assert await asyncio.wait_for(computing.run(0.0, FILM), 5.0) == b"done"

    alone(run())


def test_a_process_that_ends_is_replaced(made):
    async def run():
        computing = pool(processes=1)
        with pytest.raises(RuntimeError, match="has ended"):
            await computing.run("dies", LIGHT)
        assert len(made) == workers.TRIES
        assert await computing.run(0.0, LIGHT) == b"done"
        computing.close()
        assert not any(process.running for process in made)

    alone(run())


# Real processes

HOSTILE = replace(USUAL, events=10_000_000, duration=1e9, turns=1e30, map_turns=1e30, map_seconds=1e30)
AXES = {
    "x": {"path": "start.speed", "from": 1.0, "to": 5.0, "cells": 250},
    "y": {"path": "plane.mu", "from": 0.2, "to": 1.0, "cells": 250},
}


@POSIX
def test_a_map_stops_and_its_process_stays_and_a_long_motion_stops_too(monkeypatch):
    film = Job(calls.read("film", {"query": "start.speed=2"}), USUAL, "packed")
    hours = calls.read("map", {**AXES, "what": "end_angle", "scenario": {"duration": 20.0}}, HOSTILE)
    small = calls.read("map", {**AXES, "x": {**AXES["x"], "cells": 2}, "y": {**AXES["y"], "cells": 2}}, HOSTILE)
    scenario = Scenario(start=Start.rolling(2.8), duration=1e7, contact=hh.Rigid(max_events=10_000_000))
    long = calls.read("film", {"scenario": scenario.to_dict()}, HOSTILE)

    async def run():
        computing = Workers(replace(HOSTILE, processes=1, patience=60.0))
        try:
            for request in (film.request, small):  # all kernels are loaded then
                await computing.run(Job(request, HOSTILE, "packed"), LIGHT)
            (process,) = computing._all
            computing.limits = replace(HOSTILE, processes=1, patience=0.4)
            monkeypatch.setattr(workers, "GRACE", 5.0)  # others are at work on this machine
            with pytest.raises(TooMuch):
                await computing.run(Job(hours, HOSTILE, "packed"), HEAVY)
            assert await _until_free(computing) < 10.0
            assert process.running
            monkeypatch.setattr(workers, "GRACE", 0.08)
            computing.limits = replace(HOSTILE, processes=1, patience=0.1)
            with pytest.raises(TooMuch):
                await computing.run(Job(long, HOSTILE, "packed"), LIGHT)
            assert await _until_free(computing) < 10.0
            computing.limits = replace(HOSTILE, processes=1, patience=60.0)
            assert len(await computing.run(film, LIGHT)) > 10_000
        finally:
            computing.close()

    alone(run())


async def _until_free(computing):
    begin = time.monotonic()
    while computing.computing:
        await asyncio.sleep(0.002)
    return time.monotonic() - begin


def one_cell(speed):
    """A map of one cell, which is answered in no time, and differs from one speed to the next."""
    axes = {name: {**AXES[name], "from": at, "to": at, "cells": 1} for name, at in {"x": speed, "y": 0.7}.items()}
    return Job(calls.read("map", {**axes, "what": "end_angle", "scenario": {"duration": 0.2}}, USUAL), USUAL, "packed")


@pytest.fixture(scope="module")
def process():
    process = Worker()
    yield process
    process.end()


@POSIX
def test_interrupts_when_nothing_is_computed_stop_nothing(process):
    """Many at once stood in each other's way, so that the process never answered again."""
    job = one_cell(1.0)
    answer = process.exchange(job)
    assert answer[0] == ANSWER
    for _ in range(2000):
        process.interrupt()
    assert process.exchange(job) == answer


@POSIX
def test_whenever_it_is_interrupted_a_job_has_its_own_answer_or_none(process):
    """Before it is read, while it is computed, while it is answered: nobody is given the answer to another job."""
    jobs = [one_cell(speed) for speed in (1.0, 2.0, 3.0)]
    answers = [process.exchange(job) for job in jobs]
    assert len({content for _, content in answers}) == 3
    begin = time.perf_counter()
    process.exchange(jobs[0])
    usual = time.perf_counter() - begin
    outcomes = []
    with ThreadPoolExecutor(1) as beside:
        for index in range(150):
            exchange = beside.submit(process.exchange, jobs[index % 3])
            time.sleep(1.3 * usual * (index % 50) / 50)
            process.interrupt()
            outcomes.append(exchange.result())
    for index, said in enumerate(outcomes):
        assert said in (answers[index % 3], (STOPPED, None))
    assert {said for said, _ in outcomes} == {ANSWER, STOPPED}
    assert [process.exchange(job) for job in jobs] == answers


@POSIX
def test_a_job_that_is_given_up_before_it_comes_is_not_begun(process):
    process._say(process._number + 1, None)
    assert process.exchange(one_cell(1.0)) == (STOPPED, None)
    assert process.exchange(one_cell(1.0))[0] == ANSWER


IMPORTING = """
import sys, time
from hophoop.lab import worker
loop = worker._Loop(None, None)
loop.heed()
loop.computing = loop.unwanted = 1
sys.path.insert(0, sys.argv[1])
try:
    import interrupted_module
    time.sleep(60.0)
except worker._Stopped:
    print(hasattr(sys.modules.get("interrupted_module"), "END"), loop.computing)
"""


@POSIX
def test_an_interrupt_leaves_no_module_half_imported(tmp_path):
    """Maps failed in a process whose first one was given up while it imported pandas."""
    (tmp_path / "interrupted_module.py").write_text("import signal\nsignal.raise_signal(signal.SIGINT)\nEND = True\n")
    words = [sys.executable, "-c", IMPORTING, str(tmp_path)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=30.0, check=False)
    assert done.stdout == "True 0\n", done.stderr


def test_a_process_that_cannot_read_a_job_ends_and_one_that_has_ended_says_so():
    process = Worker()
    try:
        process._process.stdin.write(bytes([4, 0, 0, 0, 0, 0, 0, 0]) + b"what")
        for _ in range(2):
            with pytest.raises(Ended):
                process.exchange(one_cell(1.0))
        process._process.wait(10.0)
        assert not process.running
    finally:
        process.end()
    with pytest.raises(Ended):
        process.exchange(one_cell(1.0))
