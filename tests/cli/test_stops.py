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

# `hophoop run`, where `stop` is called at some moment
PROGRAM = """
import os, runpy, signal, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background leaves it ignored
number, sys.argv = int(sys.argv[1]), ["hophoop", "run"]
def stop():
    os.kill(os.getpid(), number)
    end = time.monotonic() + {long}
    while time.monotonic() < end:
        time.sleep(0.01)
{moment}
runpy.run_module("hophoop", run_name="__main__")
"""
WORK = """
import hophoop.cli._work
from hophoop._support.files import replacing
from pathlib import Path
def work(*_):
{body}
hophoop.cli._work.work_ahead = work
"""
MOMENTS = {
    # Python itself would show a traceback
    "the command is loaded": """
class Finder:
    def find_spec(self, name, *_):
        if name == "hophoop.cli":
            stop()
sys.meta_path.insert(0, Finder())
""",
    "its options are read": "import hophoop.cli; hophoop.cli.Commands.parse_args = lambda *_: stop()",
    "it computes": WORK.format(body="    stop()"),
    "a library makes another error of it": WORK.format(
        body="""
    try:
        stop()
    except BaseException:
        raise ValueError("Invalid affine transformation matrix") from None
"""
    ),
    "it writes a file, and a terminal and a starter send a signal": WORK.format(
        body="""
    with replacing(Path("half.csv").absolute()) as path:
        path.write_text("half")
        try:
            stop()
        finally:
            os.kill(os.getpid(), number)
"""
    ),
}


@SIGNALS
@pytest.mark.parametrize("moment", MOMENTS)
def test_a_stop_is_the_last_word(moment, number, status, tmp_path):
    began = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM.format(long=LONG, moment=MOMENTS[moment]), str(int(number))],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env=os.environ | {"HOPHOOP_KERNELS": "interpreted", "TMPDIR": str(tmp_path)},
        check=False,
        timeout=2 * LONG,
    )
    assert time.monotonic() - began < SOON
    assert (done.returncode, done.stdout, done.stderr) == (status, "", "Stopped.\n")
    assert list(tmp_path.iterdir()) == []


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
