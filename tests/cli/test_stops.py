"""Ctrl-C and SIGTERM are the last word of a command: one sentence, the status of the signal, nothing left behind."""

import os
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="POSIX only")
INTERRUPT, TERMINATE = (signal.SIGINT, 130), (signal.SIGTERM, 143)
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
import hophoop._support.progress
from hophoop._support.files import replacing
from pathlib import Path
def work(*_, **__):
{body}
hophoop._support.progress.bar = work
"""
FINDER = """
class Finder:
    def find_spec(self, name, *_):
        if name == "{module}":
            stop()
sys.meta_path.insert(0, Finder())
"""
# Python itself would show a traceback
MOMENTS = {
    "the command is loaded": FINDER.format(module="hophoop.cli"),
    "its options are read": "import hophoop.cli; hophoop.cli.Commands.parse_args = lambda *_: stop()",
    "a library makes another error of it, and complains": WORK.format(
        body="""
    import logging
    try:
        stop()
    except BaseException:
        logging.getLogger("library").error("Exception in callback")
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
    "nothing is loaded": FINDER.format(module="hophoop._support"),
}


@pytest.mark.parametrize(
    ("moment", "number", "status"),
    [(moment, *(INTERRUPT, TERMINATE)[k % 2]) for k, moment in enumerate(MOMENTS)],
)
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
