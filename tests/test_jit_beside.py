"""A process that compiles beside: its end, and what a person is told meanwhile."""

import io
import os
import subprocess
import sys

import pytest

from hophoop._jit import beside
from hophoop.maps import distributed, evaluate

A_PROCESS_BESIDE = """
import os, subprocess, sys, warnings
from pathlib import Path
from hophoop._jit import beside

reading, _ = os.pipe()  # it runs until this process and its forks have ended
until = "import sys; sys.stdin.read()"
process = subprocess.Popen([sys.executable, "-c", until], stdin=reading)
beside._jobs["any kernel"] = beside.Job(process, [], Path())
del process
warnings.simplefilter("error")
"""
IN_A_FORK = """
child = os.fork()
if child == 0:
    os._exit(len(beside._jobs))
assert os.waitpid(child, 0)[1] == 0
assert beside._jobs["any kernel"]._process.poll() is None  # in the parent it goes on
"""


@pytest.mark.parametrize(
    "then",
    [
        "",
        pytest.param(IN_A_FORK, marks=pytest.mark.skipif(not hasattr(os, "fork"), reason="this system cannot fork")),
    ],
    ids=["end", "fork"],
)
def test_nothing_is_said_of_a_process_beside_that_still_runs(then):
    done = subprocess.run([sys.executable, "-c", A_PROCESS_BESIDE + then], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


class Terminal(io.StringIO):
    def isatty(self):
        return True


def told(times=2, kind=io.StringIO):
    """What several waits for kernels write to a stream."""
    stream = kind()
    for _ in range(times):
        with beside.Waiting(stream) as waiting:
            waiting.report(0, 70)
            waiting.report(35, 70)
    return stream.getvalue()


def test_a_process_says_once_that_it_compiles(monkeypatch):
    monkeypatch.setattr(beside.Waiting, "told", False)
    assert told().count("this happens once") == 1
    assert told() == ""


def test_a_worker_does_not_say_that_it_compiles(monkeypatch):
    monkeypatch.setattr(beside.Waiting, "told", False)
    monkeypatch.setattr(beside, "parent_process", lambda: "another process")
    assert told() == ""


def test_a_terminal_shows_how_far_it_is_and_is_clean_afterwards():
    said = "hophoop compiles its kernel, this once:"
    assert told(1, Terminal).split("\r\x1b[K") == ["", f"{said} 0 of 70 functions", f"{said} 35 of 70 functions", ""]


def test_workers_start_when_the_kernel_of_maps_is_compiled(monkeypatch, capsys):
    """One process says so and waits, and not each worker."""
    done = []

    class Job:
        def wait(self, report):
            report(0, 70)
            done.append("compiled")

    def cluster(**_):
        done.append("cluster")
        raise OSError

    monkeypatch.setattr(beside.Waiting, "told", False)
    monkeypatch.setattr(evaluate, "precompile", lambda wanted: Job())
    monkeypatch.setattr(pytest.importorskip("distributed"), "LocalCluster", cluster)
    with pytest.raises(OSError), distributed._client(None, 2):
        pass
    assert done == ["compiled", "cluster"]
    assert capsys.readouterr().err.count("this happens once") == 1
