"""A sweep over a real Dask scheduler and worker processes on loopback, one of which dies on the way."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from damage import contents
from hophoop import maps
from hophoop.maps.grid.chunks import compute_chunk
from hophoop.maps.grid.evaluate import make_plan

distributed = pytest.importorskip("distributed")

AXES = {"plane.mu": np.linspace(0.05, 1.95, 50), "start.speed": np.linspace(0.05, 5.0, 50)}
QUANTITIES = ["sequence", "hop_height"]


def make(path, **options):
    return maps.sweep(None, AXES, QUANTITIES, out=path, chunk_cells=50, **options)


def start(*arguments):
    environment = os.environ | {"DASK_DISTRIBUTED__DASHBOARD__LINK": ""}
    return subprocess.Popen(
        [sys.executable, "-m", "distributed.cli." + arguments[0], *arguments[1:]],
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        text=True,
        env=environment,
    )


def said(process, pattern):
    """What a process says on standard error that matches; the rest is read and dropped."""
    for line in process.stderr:
        found = re.search(pattern, line)
        if found:
            threading.Thread(target=process.stderr.read, daemon=True).start()
            return found.group(1)
    raise AssertionError("the process ended")


@contextlib.contextmanager
def cluster(tmp_path):
    processes = [start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")]
    try:
        address = said(processes[0], r"Scheduler at:\s+(tcp://\S+)")
        for number in (1, 2):
            folder = tmp_path / f"worker{number}"
            worker = start(
                "dask_worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
                "--host", "127.0.0.1", "--local-directory", str(folder),
            )  # fmt: skip
            processes.append(worker)
        for worker in processes[1:]:
            said(worker, r"Registered to:\s+(tcp://\S+)")
        yield address, processes[1:], processes[0]
    finally:
        for process in processes:
            if process.poll() is None:
                process.kill()
            process.wait()
            process.stderr.close()


@pytest.mark.parametrize(
    "lost", [pytest.param("worker", marks=pytest.mark.long), pytest.param("scheduler", marks=pytest.mark.slow)]
)
def test_a_cluster_that_loses_a_process_makes_the_same_bytes(tmp_path, lost):
    """Without a worker at once, without its scheduler when the map is resumed elsewhere."""
    local, path, deaths = tmp_path / "local.zarr", tmp_path / "cluster.zarr", []
    make(local)
    with cluster(tmp_path) as (address, workers, scheduler):

        def watch(done, total):
            if done > 0.2 * total and not deaths:
                (workers[0] if lost == "worker" else scheduler).kill()
                deaths.append(done)

        gone = r"The scheduler at tcp://127\.0\.0\.1:\d+ is gone; finished chunks are kept, and resume continues\."
        with pytest.raises(OSError, match=gone) if lost == "scheduler" else contextlib.nullcontext():
            make(path, scheduler=address, progress=watch)
    assert len(deaths) == 1
    make(path, resume=True)
    assert contents(path) == contents(local)


@pytest.mark.long
def test_a_client_takes_up_a_stopped_map(tmp_path):
    """Any `distributed.Client` will do, here one with threads of this process."""

    def stop(done, total):
        if done > total / 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make(tmp_path / "cluster.zarr", progress=stop)
    with distributed.Client(processes=False, n_workers=1, dashboard_address=None) as client:
        make(tmp_path / "cluster.zarr", resume=True, scheduler=client)
        assert client.status == "running"
    make(tmp_path / "local.zarr")
    assert contents(tmp_path / "cluster.zarr") == contents(tmp_path / "local.zarr")


def test_a_scheduler_that_is_not_there(tmp_path, monkeypatch):
    monkeypatch.setattr("hophoop.maps.grid.chunks.PATIENCE", 1.0)
    began = time.monotonic()
    with pytest.raises(OSError, match=r"127.0.0.1:9"):
        make(tmp_path / "map.zarr", scheduler="tcp://127.0.0.1:9")
    assert time.monotonic() - began < 20


def test_a_worker_with_other_kernels_is_refused():
    """Its results would be those of another version."""
    plan = make_plan(None, AXES, QUANTITIES, "duration")
    with pytest.raises(OSError, match=r"A worker on .* has kernels of other sources \([0-9a-f]{8}, here 00000000\)"):
        compute_chunk(plan, {}, (0, 0), sources=32 * "0")


STOPPED = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background leaves it ignored
from hophoop.cli import app
app()
"""


@pytest.mark.long
@pytest.mark.skipif(sys.platform == "win32", reason="POSIX only")
def test_a_stop_ends_a_map_over_a_cluster_by_one_sentence(tmp_path):
    words = "map --axis plane.mu=0.05:1.95:2000 --axis start.speed=0.05:5:2000 --quiet --scheduler"
    with cluster(tmp_path) as (address, _, _):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            out = tmp_path / f"{status}.zarr"
            command = [sys.executable, "-c", STOPPED, *words.split(), address, "--out", str(out)]
            process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
            while not list(out.glob("unfinished/sequence/c/*/*/*")):
                assert process.poll() is None
                time.sleep(0.05)
            process.send_signal(number)
            told = process.communicate(timeout=60)[1]
            assert (process.returncode, told) == (status, f"Stopped; what is done is kept in {out}, and --resume goes on.\n")
