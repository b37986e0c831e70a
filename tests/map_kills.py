"""Maps on the command line, stopped at random moments and taken up again."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
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


def kill_at_random(whole: Path, out: Path, kills: int, seed: int = 2026) -> Counter[str]:
    """Stop a map again and again at random moments, compare it with the whole one each time that it is complete."""
    draw = random.Random(seed)
    came: Counter[str] = Counter()
    before = contents(whole)
    while came["stopped"] < kills:
        with_signal = SIGNALS[came["stopped"] % len(SIGNALS)]
        process = begin(out)
        # a process that still imports its modules has nothing to lose
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(draw.uniform(0.0, 0.6))
        process.send_signal(with_signal)
        _, said = process.communicate(timeout=300)
        if out.exists() and not (out / "unfinished").exists():
            came["complete before it was stopped"] += 1
            assert came["complete before it was stopped"] < 20 + 5 * kills, "signals do not stop a map"
        else:
            assert process.returncode in STATUSES[with_signal], (process.returncode, said)
            assert said in [one.format(out=out) for one in SAID[process.returncode]], (process.returncode, said)
            came["stopped"] += 1
            came[with_signal.name] += 1
        if out.exists() and not (out / "unfinished").exists():
            assert contents(out) == before
            came["whole maps compared"] += 1
            for file in sorted(out.rglob("*"), reverse=True):
                file.rmdir() if file.is_dir() else file.unlink()
            out.rmdir()
    if not out.exists() or (out / "unfinished").exists():
        finished(out)
    assert contents(out) == before
    came["whole maps compared"] += 1
    return came
