"""What an output is written over: links are followed, the mode is kept, devices and pipes are never replaced."""

import errno
import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from hophoop._support import files as _files

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links, pipes and modes of POSIX systems")


def write(target, text="new"):
    with _files.replacing(target) as temporary:
        temporary.write_text(text, encoding="utf-8")


def kind(path):
    return stat.S_IFMT(path.lstat().st_mode)


def node(path, mode, major, minor):
    try:
        os.mknod(path, mode | 0o666, os.makedev(major, minor))
    except OSError:
        pytest.skip("only root makes devices")
    return path


def test_a_pipe_is_written_through(tmp_path):
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    read = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text(encoding="utf-8")), daemon=True)
    reader.start()
    write(pipe)
    reader.join(timeout=10)
    assert read == ["new"]
    assert kind(pipe) == stat.S_IFIFO
    assert os.listdir(tmp_path) == ["pipe.csv"]


def test_a_pipe_gets_nothing_of_what_failed_and_no_folder(tmp_path):
    pipe = tmp_path / "hop.zarr"
    os.mkfifo(pipe)
    with pytest.raises(UnicodeEncodeError), _files.replacing(pipe) as temporary:
        temporary.write_text("half κ", encoding="ascii")
    with pytest.raises(NotADirectoryError) as refusal, _files.replacing(pipe) as temporary:
        temporary.mkdir()
    assert refusal.value.filename == str(pipe)
    assert kind(pipe) == stat.S_IFIFO
    assert os.listdir(tmp_path) == ["hop.zarr"]


def test_a_device_is_written_through(tmp_path):
    null = node(tmp_path / "null.csv", stat.S_IFCHR, 1, 3)
    write(null)
    assert kind(null) == stat.S_IFCHR
    link = tmp_path / "link.csv"
    link.symlink_to(null)
    write(link)
    assert (kind(link), kind(null)) == (stat.S_IFLNK, stat.S_IFCHR)
    assert sorted(os.listdir(tmp_path)) == ["link.csv", "null.csv"]


def test_a_disk_is_refused(tmp_path):
    disk = node(tmp_path / "disk.csv", stat.S_IFBLK, 7, 200)
    with pytest.raises(PermissionError) as refusal:
        write(disk)
    assert refusal.value.filename == str(disk)
    assert kind(disk) == stat.S_IFBLK


def test_a_link_stays_and_its_file_is_replaced(tmp_path, monkeypatch):
    (tmp_path / "data").mkdir()
    real = tmp_path / "data" / "real.txt"
    real.write_text("old", encoding="utf-8")
    for link, to in (("direct.csv", "data/real.txt"), ("chain.csv", "direct.csv")):
        (tmp_path / link).symlink_to(to)
        with _files.replacing(tmp_path / link) as temporary:
            assert temporary.suffix == ".csv"  # libraries choose the format by the name that was given
            temporary.write_text(link, encoding="utf-8")
        assert os.readlink(tmp_path / link) == to
        assert real.read_text(encoding="utf-8") == link
    monkeypatch.chdir(tmp_path)
    write(Path("chain.csv"), "relative")
    assert real.read_text(encoding="utf-8") == "relative"
    assert os.listdir(tmp_path / "data") == ["real.txt"]


def test_a_link_to_nothing_gets_its_file(tmp_path):
    link = tmp_path / "link.csv"
    link.symlink_to("made.csv")
    write(link)
    assert os.readlink(link) == "made.csv"
    assert (tmp_path / "made.csv").read_text(encoding="utf-8") == "new"
    ring = tmp_path / "ring.csv"
    ring.symlink_to("ring.csv")
    with pytest.raises(OSError, match="ring") as refusal:
        write(ring)
    assert refusal.value.errno == errno.ELOOP
    assert ring.is_symlink()


def test_a_link_to_a_store_stays(tmp_path):
    store, link = tmp_path / "store.zarr", tmp_path / "link.zarr"
    store.mkdir()
    (store / "zarr.json").write_text("old", encoding="utf-8")
    link.symlink_to("store.zarr")
    with _files.replacing(link) as temporary:
        temporary.mkdir()
        (temporary / "zarr.json").write_text("new", encoding="utf-8")
    assert link.is_symlink()
    assert (store / "zarr.json").read_text(encoding="utf-8") == "new"
    assert sorted(os.listdir(tmp_path)) == ["link.zarr", "store.zarr"]


@pytest.mark.parametrize("mode", [0o604, 0o444])
def test_the_mode_stays(tmp_path, mode):
    target = tmp_path / "hop.csv"
    target.write_text("old", encoding="utf-8")
    target.chmod(mode)
    write(target)
    assert stat.S_IMODE(target.stat().st_mode) == mode
    assert target.read_text(encoding="utf-8") == "new"


def test_other_names_of_a_file_keep_what_was_there(tmp_path):
    # writing in place could stop half way, and would change copies that a backup made of links
    target, other = tmp_path / "hop.csv", tmp_path / "other.csv"
    target.write_text("old", encoding="utf-8")
    other.hardlink_to(target)
    write(target)
    assert (target.read_text(encoding="utf-8"), other.read_text(encoding="utf-8")) == ("new", "old")


@pytest.mark.skipif(not os.path.islink("/dev/stdout"), reason="open files have names on Linux")
@pytest.mark.parametrize("name", ["/dev/stdout", "/proc/self/fd/1"])
def test_standard_output_is_written_through(tmp_path, name):
    """A file opened again would be written from its start."""
    code = (
        "import pathlib, sys; from hophoop._support.files import replacing\n"
        "print('first', flush=True)\n"
        "with replacing(pathlib.Path(sys.argv[1])) as fresh: fresh.write_text('second\\n')\n"
        "print('third')"
    )
    link, out = tmp_path / "own.csv", tmp_path / "out.csv"
    link.symlink_to(name)  # no name of the system's is put at risk by a failing test
    with out.open("w") as stream:
        subprocess.run([sys.executable, "-c", code, str(link)], stdout=stream, check=True)
    assert out.read_text() == "first\nsecond\nthird\n"
    assert link.is_symlink()
