"""Files of motions that were cut, changed, half written or written by others: the same motion or one sentence."""

import contextlib
import multiprocessing
import os
import re
import shutil
import sys
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr
import zarr

import hophoop as hh
from damage import REFUSED, SAME, contents, same, sign, tally, unseal
from hophoop import io
from kernel_tools import started

FORMATS = ["hop.nc", "hop.zarr", "hop.zarr.zip"]


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(hh.Scenario.from_query("duration=2&plane.restitution=0.4"))


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


def zarr_attributes(path, **changed):
    zarr.open_group(path, mode="a", use_consolidated=False).attrs.update(changed)


def number(table):
    """Change the last digit of a number."""

    def damage(path):
        angle = zarr.open_group(path, mode="a", use_consolidated=False)[f"{table}/angle"]
        angle[1] = np.nextafter(angle[1], 9.0)

    return damage


def rename(path):
    """Turn one bit of a member's name in a zip file."""
    path.write_bytes(path.read_bytes().replace(b"events/zarr.json", b"evgnts/zarr.json"))


def others(**attrs):
    """Put a dataset of another program in its place."""

    def damage(path):
        path.unlink()
        xr.Dataset({"x": ("time", [1.0])}, attrs=attrs).to_netcdf(path)

    return damage


def without_layout(path):
    del zarr.open_group(path, mode="a", use_consolidated=False)["events"].attrs["layout"]
    sign(path)


def without_segments(path):
    del zarr.open_group(path, mode="a", use_consolidated=False)["segments"]


CHECKSUM = "is damaged: its checksum is not that of its content."
FUTURE = "has the schema 'hophoop/7', but this version of hophoop reads 'hophoop/1' only."
FOREIGN = "is not a saved motion of hophoop."
OTHER = "0123456789abcdef"
DAMAGED = "is damaged: "
DAMAGE = {
    "nc": [
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
        (without_layout, "is damaged: 'layout'."),
        (without_segments, "cannot be read as Zarr: "),
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


def test_another_version_is_read_with_a_warning_at_who_loads(whole, tmp_path):
    path = Path(shutil.copy(whole / "hop.nc", tmp_path))
    attributes(version="0.0.1")(path)
    with pytest.warns(UserWarning, match=r"was written by hophoop 0\.0\.1; samples may differ") as caught:
        loaded = hh.load(path)
    assert [Path(warning.filename).name for warning in caught] == [Path(__file__).name]
    assert loaded.version == "0.0.1"


# --- a disk that is full ---------------------------------------------------------------------------


def run_limited(limit, *words):
    """`hophoop run` where no file can grow beyond a limit, as on a disk that is full; in a process of its own."""
    code = (
        "import resource, signal, sys; from hophoop.cli import app\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "sys.dont_write_bytecode = True\n"  # Python would cut it off, and keep it
        f"resource.setrlimit(resource.RLIMIT_FSIZE, ({limit}, {limit}))\n"
        "app(['run', '--duration', '0.5', '--quiet', *sys.argv[1:]])"
    )
    return started("-c", code, *map(str, words))


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs a limit on the size of files")
@pytest.mark.parametrize(
    ("option", "name", "limit"),
    [
        pytest.param("--save", "hop.nc", 20000, marks=pytest.mark.long),
        pytest.param("--save", "hop.zarr.zip", 30000, marks=pytest.mark.long),
        ("--out", "hop.json", 1000),
        pytest.param("--plot", "hop.png", 5000, marks=pytest.mark.long),
    ],
)
def test_a_full_disk_leaves_the_old_file(motion, tmp_path, option, name, limit):
    target = tmp_path / name
    if option == "--save":
        motion.save(target)
    else:
        target.write_text("what was there before")
    before = contents(tmp_path)
    found = run_limited(limit, option, target)
    assert found.returncode == 2
    assert found.stderr.startswith(f"Error: {target}")  # by the name that was given
    assert found.stderr.count("\n") == 1
    assert contents(tmp_path) == before


# --- writers and readers at once -------------------------------------------------------------------


@pytest.mark.long
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs fork; on Windows an open file cannot be replaced")
@pytest.mark.parametrize("name", FORMATS)
def test_readers_next_to_two_writers_see_whole_motions_only(motion, tmp_path, name):
    path = tmp_path / name
    both = motion, hh.simulate(motion.scenario.replace("duration", 0.5))

    def write(one, times=4):
        for _ in range(times):
            io.save(one, path, n=5)

    write(motion, 1)
    writers = [multiprocessing.get_context("fork").Process(target=write, args=(one,)) for one in both]
    for writer in writers:
        writer.start()
    seen = []
    while any(writer.is_alive() for writer in writers):
        # a store that is replaced while it is read may be refused
        with contextlib.suppress(ValueError, FileNotFoundError):
            seen.append(hh.load(path))
    assert [writer.exitcode for writer in writers] == [0, 0]
    assert all(same(one, both[0]) or same(one, both[1]) for one in [*seen, hh.load(path)])
    assert os.listdir(tmp_path) == [name]
