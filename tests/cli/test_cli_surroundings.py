"""The command line where the world around it is poor: pipes that close, disks that are full, no home, no UTF-8, 40 columns."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest

START = [sys.executable, "-c", "from hophoop.cli import app; app()"]
linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="POSIX only")


def environment(**changed):
    whole = os.environ | {"HOPHOOP_KERNELS": "interpreted"} | changed
    return {name: value for name, value in whole.items() if value is not None}


def run(*words, **changed):
    return subprocess.run([*START, *words], capture_output=True, env=environment(**changed), check=False)


@linux
def test_a_reader_that_goes_gets_no_traceback():
    process = subprocess.Popen(
        [*START, "run", "--all", "--restitution", "0.9", "--duration", "60"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment(),
    )
    process.stdout.read(100)
    process.stdout.close()
    said = process.stderr.read()
    process.stderr.close()
    process.wait()
    assert said == b""


@linux
@pytest.mark.parametrize("words", [["run", "--json"], ["--help"], ["--version"]])
def test_an_output_that_is_full_is_one_sentence(words):
    with open("/dev/full", "wb") as full:
        done = subprocess.run([*START, *words], stdout=full, stderr=subprocess.PIPE, env=environment(), check=False)
    assert (done.returncode, done.stderr) == (2, b"Error: No space left on device.\n")


@linux
@pytest.mark.parametrize("home", [None, "/nowhere"])
def test_without_a_home(home, tmp_path):
    done = run("run", "--quiet", HOME=home, XDG_CACHE_HOME=None, TMPDIR=str(tmp_path))
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")


@linux
def test_a_terminal_that_knows_no_greek():
    done = run("run", LC_ALL="C", PYTHONUTF8="0", PYTHONCOERCECLOCALE="0", PYTHONIOENCODING=None)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"takeoff" in done.stdout
    assert done.stdout.isascii()


def in_terminal(columns, *words, **changed):
    """What a command prints in a terminal so wide."""
    import fcntl
    import pty
    import struct
    import termios

    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([*START, *words], stdin=slave, stdout=slave, stderr=slave, env=environment(**changed))
    os.close(slave)
    parts = []
    while True:
        try:
            part = os.read(master, 65536)
        except OSError:  # how Linux says that the other side has gone
            break
        if not part:
            break
        parts.append(part)
    os.close(master)
    assert process.wait() == 0
    return b"".join(parts).decode().replace("\r", "")


@linux
def test_forty_columns_without_colours():
    said = in_terminal(40, "run", TERM="xterm-256color", NO_COLOR="1", COLUMNS=None)
    assert "takeoff" in said
    assert "1.044713" in said
    # numbers stand whole or not at all
    assert not re.search(r"\d…", said)
    assert "Not shown for want of width: slip (m/s), x (m)," in " ".join(said.split())
    assert not re.search(r"\x1b\[[0-9;]*(3|4|9|10)[0-7]m", said)
    said = in_terminal(40, "theory", TERM="xterm-256color", NO_COLOR="1", COLUMNS=None)
    assert not re.search(r"\d…", said)


def test_without_docstrings_there_are_no_options():
    """Python -OO leaves them out, and options with them."""
    found = subprocess.run(
        [sys.executable, "-OO", "-m", "hophoop", "run", "--v0", "1"],
        capture_output=True,
        text=True,
        check=False,
        encoding="utf-8",
    )
    assert (found.returncode, found.stdout) == (2, "")
    assert found.stderr == "Error: Commands need their docstrings, which list the options: start Python without -OO.\n"
