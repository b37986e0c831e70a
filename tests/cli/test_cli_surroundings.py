"""The command line where the world around it is poor: pipes that close, disks that are full, no home, no UTF-8, 40 columns."""

import os
import re
import subprocess
import sys

import pytest
from rich.console import Console

from cli_tools import done
from hophoop.cli._options import entries_of
from kernel_tools import started

PROGRAM = ("-c", "from hophoop.cli import app; app()")
START = [sys.executable, *PROGRAM]
ENVIRONMENT = os.environ | {"HOPHOOP_KERNELS": "interpreted"}
linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="POSIX only")


@linux
def test_a_reader_that_goes_gets_no_traceback():
    words = [*START, "run", "--all", "--restitution", "0.9", "--duration", "60"]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=ENVIRONMENT)
    process.stdout.read(100)
    process.stdout.close()
    assert process.communicate()[1] == b""


@linux
@pytest.mark.parametrize("words", [["run", "--json"], ["--version"]])
def test_an_output_that_is_full_is_one_sentence(words):
    with open("/dev/full", "wb") as full:
        done = subprocess.run([*START, *words], stdout=full, stderr=subprocess.PIPE, env=ENVIRONMENT, check=False)
    assert (done.returncode, done.stderr) == (2, b"Error: No space left on device.\n")


@linux
def test_without_a_home_in_a_terminal_that_knows_no_greek(tmp_path):
    poor = {"HOME": "/nowhere", "XDG_CACHE_HOME": "", "TMPDIR": str(tmp_path), "HOPHOOP_KERNELS": "interpreted"}
    found = started(*PROGRAM, "run", LC_ALL="C", PYTHONUTF8="0", PYTHONCOERCECLOCALE="0", PYTHONIOENCODING="", **poor)
    assert (found.returncode, found.stderr) == (0, "")
    assert "takeoff" in found.stdout
    assert found.stdout.isascii()


def test_forty_columns_without_colours(monkeypatch):
    for name, value in {"TERM": "xterm-256color", "NO_COLOR": "1", "COLUMNS": "40"}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(Console, "is_terminal", property(lambda console: True))
    said = done("run").stdout
    assert "1.044713" in said
    assert "Not shown for want of width: slip (m/s), x (m)," in " ".join(said.split())
    assert not re.search(r"\x1b\[[0-9;]*(3|4|9|10)[0-7]m", said)


def test_without_docstrings_there_are_no_options():
    """Python -OO leaves them out, and options with them."""
    with pytest.raises(ValueError, match=r"which list the options: start Python without -OO\.$"):
        entries_of(None)
