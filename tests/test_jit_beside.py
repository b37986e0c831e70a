"""A process that compiles beside, when the one that started it ends."""

import os
import subprocess
import sys

import pytest

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
