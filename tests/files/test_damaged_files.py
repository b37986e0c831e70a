"""Files of motions that were cut, changed, half written or written by others: the same motion or one sentence."""

from __future__ import annotations

import contextlib
import json
import multiprocessing
import os
import signal
import sys
import threading
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr
import zarr

import hophoop as hh
from damage import REFUSED, SAME, sign, tally, unseal
from hophoop import io
from hophoop.cli import app
from map_tools import contents

FORMATS = ["hop.nc", "hop.zarr", "hop.zarr.zip"]


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(hh.Hoop(), hh.Plane(restitution=0.4), hh.Start.rolling(3.1), duration=2.0)


@pytest.fixture(scope="module")
def shorter(motion):
    return hh.simulate(motion.scenario.replace("duration", 0.5))


def same(one, other):
    equal = one.scenario == other.scenario and (one.status, one.version) == (other.status, other.version)
    return equal and all(one.tables[name].tobytes() == other.tables[name].tobytes() for name in ("events", "segments"))


@pytest.mark.long
@pytest.mark.parametrize("name", FORMATS)
def test_a_damaged_file_is_the_same_motion_or_one_sentence(motion, tmp_path, name):
    motion.save(tmp_path / name)
    came = tally(hh.load, lambda loaded: same(loaded, motion), tmp_path / name, tmp_path / f"damaged-{name}", 24)
    assert set(came) <= {SAME, REFUSED}
    assert came[REFUSED] > 4


def test_an_attribute_that_is_missing_is_noticed(motion, tmp_path):
    path = tmp_path / "hop.nc"
    for group, attribute in (("events", "checksum"), ("/", "scenario"), ("/", "status"), ("/", "version")):
        motion.save(path)
        unseal(path)
        with netCDF4.Dataset(path, "a") as file:
            (file if group == "/" else file[group]).delncattr(attribute)
        with pytest.raises(ValueError, match="is damaged: its checksum"):
            hh.load(path)
        if attribute != "checksum":
            sign(path)
            with pytest.raises(ValueError, match=rf"is damaged: '{attribute}'\.$"):
                hh.load(path)


@pytest.mark.parametrize("name", ["hop.nc", "hop.zarr"])
@pytest.mark.parametrize("group", ["/", "events", "segments"])
def test_a_number_that_was_changed_is_noticed(motion, tmp_path, name, group):
    path = tmp_path / name
    motion.save(path)
    if name.endswith(".nc"):
        unseal(path)
        with netCDF4.Dataset(path, "a") as file:
            table = file if group == "/" else file[group]
            table["angle"][1] = np.nextafter(table["angle"][1], 9.0)
    else:
        angle = zarr.open_group(path, mode="a")["angle" if group == "/" else f"{group}/angle"]
        angle[1] = np.nextafter(angle[1], 9.0)
    with pytest.raises(ValueError, match=f"{name} is damaged: its checksum is not that of its content\\.$"):
        hh.load(path)


def with_a_name_changed(path, old, new):
    """One bit of a member's name turned, in a folder or in a zip file."""
    if path.is_dir():
        (path / old).rename(path / new)
        (path / new / "zarr.json").unlink()
    else:
        path.write_bytes(path.read_bytes().replace(f"{old}/zarr.json".encode(), f"{new}/zarr.json".encode()))


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", FORMATS[1:])
def test_a_name_that_is_damaged_is_said_in_one_sentence_without_a_warning(motion, tmp_path, name):
    path = tmp_path / name
    motion.save(path)
    with_a_name_changed(path, "events", "evgnts")
    with pytest.raises(ValueError, match=r" cannot be read as Zarr: .*\bevents'?\.$"):
        hh.load(path)


@pytest.mark.filterwarnings("error")
def test_what_a_file_browser_leaves_in_a_folder_is_not_spoken_of(motion, tmp_path):
    path = tmp_path / "hop.zarr"
    motion.save(path)
    (path / ".DS_Store").write_bytes(b"\0\0\0\1Bud1")
    (path / "Thumbs.db").write_bytes(b"")
    assert same(hh.load(path), motion)


@pytest.mark.parametrize("name", FORMATS[:2])
def test_a_future_schema_is_refused_by_name_whatever_is_inside(tmp_path, name):
    dataset = xr.Dataset(attrs={"schema": "hophoop/7", "motion": "in a way that nobody knows yet"})
    dataset.to_netcdf(tmp_path / name) if name.endswith(".nc") else dataset.to_zarr(tmp_path / name, consolidated=False)
    with pytest.raises(ValueError, match=r"has the schema 'hophoop/7', but this version of hophoop reads 'hophoop/1' only\.$"):
        hh.load(tmp_path / name)


def test_a_file_that_hdf5_must_not_see_is_refused_before(motion, tmp_path, monkeypatch):
    # its library has been seen to crash on a bit that was turned
    motion.save(tmp_path / "hop.nc")
    content = bytearray((tmp_path / "hop.nc").read_bytes())
    content[len(content) // 2] ^= 4
    (tmp_path / "hop.nc").write_bytes(content)
    monkeypatch.setattr(xr, "open_dataset", None)
    with pytest.raises(ValueError, match=r"hop\.nc is damaged: its checksum is not that of its content\.$"):
        hh.load(tmp_path / "hop.nc")


def test_a_file_that_was_changed_by_others_keeps_no_seal(motion, tmp_path):
    motion.save(tmp_path / "hop.nc")
    unseal(tmp_path / "hop.nc")
    assert same(hh.load(tmp_path / "hop.nc"), motion)


# --- a disk that is full ---------------------------------------------------------------------------


def run_limited(limit, said, *words):
    """`hophoop run` where no file can grow beyond a limit, as on a disk that is full; in a process of its own."""
    import resource

    child = os.fork()
    if child == 0:
        status = 99
        try:
            os.dup2(os.open(said, os.O_WRONLY | os.O_CREAT), 2)
            sys.stderr = open(2, "w", closefd=False)  # noqa: SIM115
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            app(["run", "--duration", "0.5", "--quiet", *map(str, words)])
        except SystemExit as end:
            status = end.code
        finally:
            sys.stderr.flush()
            os._exit(status)
    _, status = os.waitpid(child, 0)
    return os.waitstatus_to_exitcode(status), said.read_text()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs fork and a limit on the size of files")
@pytest.mark.parametrize(
    ("option", "name", "limit"),
    [
        ("--save", "hop.nc", 20000),
        ("--save", "hop.zarr", 300),
        ("--save", "hop.zarr.zip", 30000),
        ("--csv", "hop.csv", 5000),
        ("--out", "hop.json", 1000),
        ("--plot", "hop.png", 5000),
    ],
)
def test_a_full_disk_leaves_the_old_file(motion, tmp_path, option, name, limit):
    folder = tmp_path / "disk"
    folder.mkdir()
    target = folder / name
    if option == "--save":
        motion.save(target)
    else:
        target.write_text("what was there before")
    before = contents(folder)
    status, said = run_limited(limit, tmp_path / "said", option, target)
    assert status == 2, said
    assert said.startswith(f"Error: {target}")  # by the name that was given
    assert said.count("\n") == 1
    assert contents(folder) == before


# --- writers and readers at once -------------------------------------------------------------------


def write(motion, path, times):
    for _ in range(times):
        io.save(motion, path, n=5)


@pytest.mark.long
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs fork; on Windows an open file cannot be replaced")
@pytest.mark.parametrize("name", FORMATS)
def test_readers_next_to_two_writers_see_whole_motions_only(motion, shorter, tmp_path, name):
    path = tmp_path / name
    write(motion, path, 1)
    context = multiprocessing.get_context("fork")
    writers = [context.Process(target=write, args=(one, path, 4)) for one in (motion, shorter)]
    for writer in writers:
        writer.start()
    seen = []
    while any(writer.is_alive() for writer in writers):
        # a store that is replaced while it is read may be refused
        with contextlib.suppress(ValueError, FileNotFoundError):
            seen.append(hh.load(path))
    for writer in writers:
        writer.join()
    assert [writer.exitcode for writer in writers] == [0, 0]
    seen.append(hh.load(path))
    assert all(same(one, motion) or same(one, shorter) for one in seen)
    assert os.listdir(tmp_path) == [name]


def test_threads_that_write_one_text_leave_one_of_them(motion, shorter, tmp_path):
    path = tmp_path / "hop.json"
    io.write_json(motion, path)
    threads = [threading.Thread(target=io.write_json, args=(one, path)) for one in (motion, shorter) * 4]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        assert json.loads(path.read_text(encoding="utf-8"))["final"]["t"] in (2.0, 0.5)
    for thread in threads:
        thread.join()
    assert [Path(file).name for file in os.listdir(tmp_path)] == ["hop.json"]
