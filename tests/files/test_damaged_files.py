"""Files of motions that were cut, changed, half written or written by others: the same motion or one sentence."""

from __future__ import annotations

import contextlib
import json
import multiprocessing
import os
import re
import shutil
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
from damage import REFUSED, SAME, contents, sign, tally, unseal
from hophoop import io
from hophoop.cli import app

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


# --- what is done to a saved file, and what is said -------------------------------------------------


def attributes(signed=True, group="/", **changed):
    """Change attributes of a group, or take them away, with a checksum that fits or with the old one."""

    def damage(path):
        with netCDF4.Dataset(path, "a") as file:
            table = file if group == "/" else file[group]
            for name, value in changed.items():
                table.delncattr(name) if value is None else table.setncattr(name, value)
        if signed:
            sign(path)

    return damage


def zarr_attributes(path, group="/", **changed):
    attrs = zarr.open_group(path, mode="a")[group].attrs
    for name, value in changed.items():
        if value is None:
            del attrs[name]
        else:
            attrs[name] = value


def number(group):
    """Change the last digit of a number."""

    def damage(path):
        if path.suffix == ".nc":
            with netCDF4.Dataset(path, "a") as file:
                angle = (file if group == "/" else file[group])["angle"]
                angle[1] = np.nextafter(angle[1], 9.0)
        else:
            angle = zarr.open_group(path, mode="a")["angle" if group == "/" else f"{group}/angle"]
            angle[1] = np.nextafter(angle[1], 9.0)

    return damage


def rename(path):
    """Turn one bit of a member's name, in a folder or in a zip file."""
    if path.is_dir():
        (path / "events").rename(path / "evgnts")
        (path / "evgnts" / "zarr.json").unlink()
    else:
        path.write_bytes(path.read_bytes().replace(b"events/zarr.json", b"evgnts/zarr.json"))


def others(**attrs):
    """Put a dataset of another program in its place."""

    def damage(path):
        path.unlink()
        xr.Dataset({"x": ("time", [1.0])}, attrs=attrs).to_netcdf(path)

    return damage


def without_layout(path):
    zarr_attributes(path, "events", layout=None)
    sign(path)


def without_segments(path):
    del zarr.open_group(path, mode="a")["segments"]


CHECKSUM = "is damaged: its checksum is not that of its content."
FUTURE = "has the schema 'hophoop/7', but this version of hophoop reads 'hophoop/1' only."
FOREIGN = "is not a saved motion of hophoop."
OTHER = "0123456789abcdef"
DAMAGED = "is damaged: "
DAMAGE = {
    "nc": [
        (number("/"), CHECKSUM), (number("events"), CHECKSUM), (number("segments"), CHECKSUM),
        (attributes(False, "events", checksum=None), CHECKSUM),
        (attributes(False, scenario=None), CHECKSUM), (attributes(scenario=None), "is damaged: 'scenario'."),
        (attributes(status=None), "is damaged: 'status'."),
        (attributes(version=None), "is damaged: 'version'."),
        (attributes(scenario="{"), DAMAGED), (attributes(scenario=5), DAMAGED), (attributes(scenario="[" * 100_000), DAMAGED),
        (attributes(scenario='{"nonsense": 1}'), DAMAGED), (attributes(status="asleep"), DAMAGED),
        (attributes(status=5), DAMAGED),
        (attributes(version="0.0.1", scenario='{"nonsense": 1}'), "was written by hophoop 0.0.1: nonsense is not a known key"),
        (attributes(version="0.0.1", scenario="{"), DAMAGED),
        (attributes(fingerprint=OTHER), f"is damaged: its fingerprint '{OTHER}' is not that of its events, '"),
        (attributes(False, schema="hophoop/7", status="as nobody knows yet"), FUTURE),
        (lambda path: path.write_bytes(b"this is no file of ours" * 99), "cannot be read as netCDF: "),
        (others(), FOREIGN), (others(schema=5), FOREIGN), (others(schema="other/1"), FOREIGN),
        (others(schema="hophoop/1"), "is not whole: it has the samples of a motion, but not the tables"),
    ],
    "zarr": [
        (number("/"), CHECKSUM), (number("events"), CHECKSUM), (number("segments"), CHECKSUM),
        (rename, "cannot be read as Zarr: "),
        (without_layout, "is damaged: 'layout'."),
        (without_segments, "cannot be read as Zarr: "),
        (lambda path: (path / "zarr.json").write_text("{"), "cannot be read as Zarr: "),
        (lambda path: (path / "zarr.json").unlink(), "cannot be read as Zarr"),
        (lambda path: zarr_attributes(path, schema="hophoop/7", status="as nobody knows yet"), FUTURE),
    ],
    "zarr.zip": [
        (rename, "cannot be read as Zarr: "),
        (lambda path: path.write_bytes(b"this is no file of ours" * 99), "cannot be read as Zarr: "),
    ],
}  # fmt: skip


@pytest.fixture(scope="module")
def whole(motion, tmp_path_factory):
    """A file of each format, without the seal that others would not keep."""
    folder = tmp_path_factory.mktemp("whole")
    for name in FORMATS:
        io.save(motion, folder / name, n=5)
    unseal(folder / "hop.nc")
    return folder


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(("kind", "damage", "said"), [(kind, *row) for kind, rows in DAMAGE.items() for row in rows])
def test_a_file_that_was_changed_is_refused_in_one_sentence(whole, tmp_path, kind, damage, said):
    path = tmp_path / f"hop.{kind}"
    (shutil.copytree if kind == "zarr" else shutil.copy)(whole / path.name, path)
    assert same(hh.load(path), hh.load(whole / path.name))
    damage(path)
    with pytest.raises(ValueError, match=rf"^{re.escape(f'{path} {said}')}") as refusal:
        hh.load(path)
    text = str(refusal.value)
    assert text.isprintable()
    assert text.endswith((".", "?"))
    if damage in (rename, without_segments):
        assert re.search("events|segments", text)


@pytest.mark.long
@pytest.mark.parametrize("name", FORMATS)
def test_a_damaged_file_is_the_same_motion_or_one_sentence(motion, tmp_path, name):
    motion.save(tmp_path / name)
    came = tally(hh.load, lambda loaded: same(loaded, motion), tmp_path / name, tmp_path / f"damaged-{name}", 24)
    assert set(came) <= {SAME, REFUSED}
    assert came[REFUSED] > 4


@pytest.mark.filterwarnings("error")
def test_what_a_file_browser_leaves_in_a_folder_is_not_spoken_of(motion, tmp_path):
    path = tmp_path / "hop.zarr"
    motion.save(path)
    (path / ".DS_Store").write_bytes(b"\0\0\0\1Bud1")
    (path / "Thumbs.db").write_bytes(b"")
    assert same(hh.load(path), motion)


def test_a_file_that_hdf5_must_not_see_is_refused_before(motion, tmp_path, monkeypatch):
    # its library has been seen to crash on a bit that was turned
    motion.save(tmp_path / "hop.nc")
    content = bytearray((tmp_path / "hop.nc").read_bytes())
    content[len(content) // 2] ^= 4
    (tmp_path / "hop.nc").write_bytes(content)
    monkeypatch.setattr(xr, "open_dataset", None)
    with pytest.raises(ValueError, match=re.escape(f"hop.nc {CHECKSUM}")):
        hh.load(tmp_path / "hop.nc")


@pytest.mark.parametrize("name", FORMATS[:2])
def test_another_version_is_read_with_a_warning_at_who_loads(whole, tmp_path, name):
    path = tmp_path / name
    (shutil.copytree if path.suffix == ".zarr" else shutil.copy)(whole / name, path)
    if path.suffix == ".nc":
        attributes(version="0.0.1")(path)
    else:
        zarr_attributes(path, version="0.0.1")
        sign(path)
    with pytest.warns(UserWarning, match=r"was written by hophoop 0\.0\.1; samples may differ") as caught:
        loaded = hh.load(path)
    assert [Path(warning.filename).name for warning in caught] == [Path(__file__).name]
    assert loaded.version == "0.0.1"
    assert loaded.at(1.0) == hh.load(whole / name).at(1.0)


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
