"""The command line where the world around it is poor: pipes that close, disks that are full, no home, no UTF-8, 40 columns."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

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
@pytest.mark.parametrize("words", [["run"], ["run", "--json"], ["run", "--help"], ["--help"], ["--version"], []])
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


@linux
@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
@pytest.mark.parametrize("moment", ["hophoop.cli._work.work_ahead", "hophoop.cli.Commands.parse_args"])
def test_stopped_it_says_so(number, status, moment):
    """Ctrl-C and SIGTERM, while a command computes and while its options are read. Once both ended with 130 and no word."""
    module, _, name = moment.rpartition(".")
    code = (
        "import os\nfrom pydoc import locate\nimport hophoop.cli._work\nfrom hophoop.cli import app\n"
        f"setattr(locate({module!r}), {name!r}, lambda *_: os.kill(os.getpid(), {int(number)}))\napp()"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "run"], capture_output=True, text=True, env=environment(), check=False, timeout=60
    )
    assert (done.returncode, done.stdout, done.stderr) == (status, "", "Stopped.\n")


@pytest.mark.parametrize(
    ("command", "option"),
    [
        ("reproduce", "--out"),
        ("run", "--csv"),
        ("animate", "--out"),
        ("map", "--plot"),
        ("prove", "--out"),
        ("lab", "--export"),
    ],
)
def test_an_output_without_a_name_is_refused_at_once(command, option, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for words in ([option, ""], [f"{option}="]):
        done = run(command, *words)
        assert (done.returncode, done.stderr.decode()) == (2, f"Error: {option} = '' must name a file or a folder.\n")
        assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "words",
    [
        ("run", "--csv", "new/hop.csv"),
        ("run", "--plot", "new/hop.png"),
        ("animate", "--out", "new/hop.mp4"),
        ("animate", "--out", "new/hop.png"),
        ("animate", "--3d", "--out", "new/hop.html"),
    ],
)
def test_the_folder_of_a_file_is_not_made(words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = run(*words)
    sentence = f"Error: {words[-2]} = {Path(words[-1])} must be in an existing folder; new does not exist.\n"
    assert (done.returncode, done.stderr.decode()) == (2, sentence)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("words", [("run", "NAME"), ("NAME",), ("run", "--csv", "NAME")])
@pytest.mark.parametrize("letter", ["x", "\x1b"])
def test_a_name_of_5000_letters_is_shown_by_its_start(words, letter):
    done = run(*(word.replace("NAME", 5000 * letter) for word in words))
    assert done.returncode == 2
    said = done.stderr.decode()
    assert len(said) < 400
    assert "..." in said
    assert said.rstrip("\n").isprintable()
