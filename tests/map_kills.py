"""Maps on the command line, stopped at random moments and taken up again."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from map_tools import contents

WORDS = (
    *("--axis", "plane.mu=0.05:1.95:100", "--axis", "start.speed=0.05:5:100"),
    *("--quantity", "sequence", "--quantity", "hop_height", "--quiet"),
)
# chunks that are small enough to be stopped between
START = """
import functools, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background leaves it ignored
from hophoop.cli import app
from hophoop.maps.grid import sweeping
sweeping.sweep = functools.wraps(sweeping.sweep)(functools.partial(sweeping.sweep, chunk_cells=250))
print("ready", flush=True)
app()
"""
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
# what may be said: one sentence, the first before there is anything to keep, or nothing where the process could not speak
SENTENCES = ("Stopped.\n", "Stopped; what is done is kept in {out}, and --resume goes on.\n")
SAID = {-signal.SIGKILL: ("",), -signal.SIGTERM: ("",), 143: SENTENCES, 130: SENTENCES}
STATUSES = {signal.SIGKILL: (-9,), signal.SIGTERM: (-15, 143), signal.SIGINT: (130,)}


def begin(out: Path) -> subprocess.Popen[str]:
    """`hophoop map --resume` in a process of its own."""
    environment = os.environ | {"HOPHOOP_KERNELS": "compiled"}
    return subprocess.Popen(
        [sys.executable, "-c", START, "map", *WORDS, "--out", str(out), *(("--resume",) if out.exists() else ())],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
    )


def finished(out: Path) -> None:
    """Let it run to its end."""
    process = begin(out)
    _, said = process.communicate(timeout=300)
    assert process.returncode == 0, said


def kill_at_random(whole: Path, out: Path, seed: int = 2026) -> None:
    """Stop a map by each signal at a random moment, each time until it was not yet complete; in the end it is the whole one."""
    draw = random.Random(seed)
    for sent in SIGNALS:
        status = 0
        for _ in range(20):
            process = begin(out)
            # a process that still imports its modules has nothing to lose
            assert process.stdout is not None
            process.stdout.readline()
            time.sleep(draw.uniform(0.0, 0.6))
            process.send_signal(sent)
            _, said = process.communicate(timeout=300)
            status = process.returncode
            if status:
                break
            assert contents(out) == contents(whole)
            shutil.rmtree(out)
        assert status in STATUSES[sent], (status, said)
        assert said in [one.format(out=out) for one in SAID[status]], (status, said)
    finished(out)
    assert contents(out) == contents(whole)
