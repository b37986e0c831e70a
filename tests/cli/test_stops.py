"""Ctrl-C and SIGTERM are the last word of a command: one sentence, the status of the signal, nothing left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="POSIX only")
SIGNALS = pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
LONG = 120.0  # seconds that a command takes that does not stop
SOON = 60.0  # seconds in which it has to, on a machine that is as busy as may be

# `hophoop run`, which comes to `work` where it would compute
START = """
import os, signal, subprocess, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background leaves it ignored
from pathlib import Path
import hophoop.cli._work
from hophoop._support.files import replacing
from hophoop.cli import app
number, folder = int(sys.argv.pop(1)), Path(sys.argv.pop(1))
def stop():
    os.kill(os.getpid(), number)
def wait():
    end = time.monotonic() + {long}
    while time.monotonic() < end:
        time.sleep(0.01)
def work(*_):
{body}
hophoop.cli._work.work_ahead = work
app()
"""
HEARS = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
RUN = "from hophoop.cli import app; app()"

# where the exception may come
WHERE = {
    "a library that makes another error of it": """
        try:
            stop()
            wait()
        except BaseException:
            raise ValueError("Invalid affine transformation matrix") from None
    """,
    "code that writes a file": """
        with replacing(folder / "half.csv") as path:
            path.write_text("half")
            stop()
            wait()
    """,
    "signals from a terminal and from a starter": """
        with replacing(folder / "half.csv") as path:
            path.write_text("half")
            try:
                stop()
            finally:
                stop()
    """,
}


def stopped(body, number, folder):
    """What `hophoop run` gives whose work is `body`."""
    lines = body.strip("\n").splitlines()
    margin = min(len(line) - len(line.lstrip()) for line in lines if line.strip())
    text = "\n".join("    " + line[margin:] for line in lines)
    began = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-c", START.format(long=LONG, body=text), str(int(number)), str(folder), "run"],
        capture_output=True,
        text=True,
        env=os.environ | {"HOPHOOP_KERNELS": "interpreted", "TMPDIR": str(folder)},
        check=False,
        timeout=2 * LONG,
    )
    assert time.monotonic() - began < SOON
    return done.returncode, done.stdout, done.stderr, sorted(path.name for path in folder.iterdir())


@SIGNALS
@pytest.mark.parametrize("where", WHERE)
def test_a_stop_is_the_last_word(where, number, status, tmp_path):
    assert stopped(WHERE[where], number, tmp_path) == (status, "", "Stopped.\n", [])


LOADED = """
import os, runpy, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
class Finder:
    def find_spec(self, name, *_):
        if name == "hophoop.cli":
            os.kill(os.getpid(), {number})
sys.meta_path.insert(0, Finder())
sys.argv = ["hophoop", "run"]
runpy.run_module("hophoop", run_name="__main__")
"""


@SIGNALS
def test_a_stop_while_the_command_is_loaded(number, status, tmp_path):
    """Python itself would show a traceback."""
    code = LOADED.format(number=int(number))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=SOON)
    assert (done.returncode, done.stdout, done.stderr) == (status, "", "Stopped.\n")


# long commands, and what a stopped one may leave: figures that are complete, chunks of a map
LONG_ONES = {
    "animate --v0 3.1 --duration 9 --out a.mp4 --quiet": [],
    "map --axis plane.mu=0.05:1.95:900 --axis start.speed=0.05:5:900 --out m.nc --quiet": ["m.nc.part.zarr"],
    "reproduce --out article --quiet": ["article"],
}


@pytest.mark.long
@pytest.mark.compiled
@SIGNALS
@pytest.mark.parametrize("words", LONG_ONES)
def test_a_stopped_command_leaves_nothing_half_written(words, number, status, tmp_path):
    (tmp_path / "tmp").mkdir()
    process = subprocess.Popen(
        [sys.executable, "-m", "hophoop", *words.split()],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env=os.environ | {"TMPDIR": str(tmp_path / "tmp")},
    )
    time.sleep(3.0)
    os.killpg(process.pid, number)
    said = process.communicate(timeout=SOON)[1]
    assert process.returncode == status
    assert said.startswith("Stopped")
    assert said.count("\n") == 1
    assert list((tmp_path / "tmp").iterdir()) == []
    assert {path.name for path in tmp_path.iterdir()} <= {"tmp", *LONG_ONES[words]}
    assert not list(tmp_path.glob("article/.*"))
