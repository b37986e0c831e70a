"""Maps that are stopped at any moment, made by two at once, damaged, or of another version."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr
import zarr

from damage import REFUSED, SAME, tally
from hophoop import maps
from hophoop.maps.grid import store
from hophoop.scenario import InputError
from map_kills import finished, kill_at_random
from map_tools import contents, stopped

AXES = {"plane.mu": np.linspace(0.05, 1.95, 12), "start.speed": np.linspace(0.05, 5.0, 10)}
QUANTITIES = ["sequence", "hop_height"]
linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs fork and POSIX signals")


def make(out, **options):
    return maps.sweep(None, AXES, QUANTITIES, out=out, chunk_cells=20, **options)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    path = tmp_path_factory.mktemp("maps") / "whole.zarr"
    make(path)
    return path


# --- stopped ---------------------------------------------------------------------------------------


@linux
@pytest.mark.long
@pytest.mark.compiled
def test_a_map_stopped_at_random_moments_is_the_same_in_the_end(tmp_path):
    finished(tmp_path / "whole.zarr")
    kill_at_random(tmp_path / "whole.zarr", tmp_path / "map.zarr")


# --- two at once -----------------------------------------------------------------------------------


def test_a_map_that_is_being_made_is_refused(tmp_path):
    path = tmp_path / "map.zarr"
    refusals = []

    def another(done, total):
        if len(refusals) < 2:
            with pytest.raises(ValueError, match=r"map\.zarr is being written by another process: wait for it") as caught:
                make(path, resume=True)
            refusals.append(caught)

    make(path, progress=another)
    assert len(refusals) == 2
    assert make(path, resume=True).identical(maps.open_map(path))


def test_two_that_begin_at_once_do_not_harm_each_other(whole, tmp_path, monkeypatch):
    path = tmp_path / "map.zarr"
    write = store._provenance

    def late(plan):  # another process makes the store while this one is about to
        if not path.exists():
            monkeypatch.undo()
            stopped(make, path, 39)
        return write(plan)

    monkeypatch.setattr(store, "_provenance", late)
    make(path)
    assert contents(path) == contents(whole)
    assert [file.name for file in tmp_path.iterdir()] == ["map.zarr"]


THREADS = """
import sys, threading
import numpy as np
from hophoop import maps
axes = {"plane.mu": np.linspace(0.05, 1.95, 80), "start.speed": np.linspace(0.05, 5.0, 80)}
came = []
def make(): came.append(maps.sweep(None, axes, ["sequence", "hop_height"], threads=2))
threads = [threading.Thread(target=make) for _ in "ab"]
for thread in threads: thread.start()
for thread in threads: thread.join()
assert len(came) == 2 and came[0].identical(came[1])
print("alike")
"""


@pytest.mark.slow
@pytest.mark.compiled
def test_two_threads_make_maps_at_once():
    environment = os.environ | {"HOPHOOP_KERNELS": "compiled"}
    done = subprocess.run([sys.executable, "-c", THREADS], capture_output=True, text=True, env=environment, check=False)
    assert (done.returncode, done.stdout) == (0, "alike\n"), done.stderr


# --- damaged ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("ending", ["zarr", "nc"])
def test_a_damaged_map_is_the_same_map_or_one_sentence(whole, tmp_path, ending):
    if ending == "nc":
        whole = tmp_path / "whole.nc"
        make(whole)
    values = maps.open_map(whole).load()
    came = tally(lambda file: maps.open_map(file).load(), values.identical, whole, tmp_path / f"damaged.{ending}", 30)
    assert set(came) <= {SAME, REFUSED}
    assert came[REFUSED] > 5


def test_a_part_that_is_missing_is_noticed(whole, tmp_path):
    shutil.copytree(whole, tmp_path / "map.zarr")
    next(file for file in (tmp_path / "map.zarr" / "hop_height" / "c").rglob("*") if file.is_file()).unlink()
    with pytest.raises(ValueError, match=r"map\.zarr is damaged: a part of it is missing\.$"):
        maps.open_map(tmp_path / "map.zarr")


def test_a_copy_that_xarray_wrote_is_read(whole, tmp_path):
    there = maps.open_map(whole)
    there.to_netcdf(tmp_path / "copy.nc")
    copy = maps.open_map(tmp_path / "copy.nc")
    for name in QUANTITIES:
        np.testing.assert_array_equal(copy[name], there[name])


# --- of others -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["map.zarr", "map.nc"])
def test_a_future_schema_is_refused_by_name(tmp_path, name):
    dataset = xr.Dataset(attrs={"schema": "hophoop-map/4", "plan": "in other words"})
    dataset.to_netcdf(tmp_path / name) if name.endswith(".nc") else dataset.to_zarr(tmp_path / name, consolidated=False)
    with pytest.raises(
        ValueError, match=r"has the schema 'hophoop-map/4', but this version of hophoop reads 'hophoop-map/1' only"
    ):
        maps.open_map(tmp_path / name)


def test_other_files_are_refused(tmp_path):
    xr.Dataset({"x": ("time", [1.0])}).to_netcdf(tmp_path / "other.nc")
    (tmp_path / "noise.nc").write_bytes(b"no file of ours" * 99)
    (tmp_path / "folder.zarr").mkdir()
    for name, said in (
        ("other.nc", "is not a map"),
        ("noise.nc", "cannot be read as a map"),
        ("folder.zarr", "cannot be read"),
    ):
        with pytest.raises(ValueError, match=f"{name} {said}"):
            maps.open_map(tmp_path / name)


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (("hophoop", "0.0.9"), r"holds a map of hophoop 0\.0\.9, which this version .* cannot resume\.$"),
        (("weather", "fine"), "holds a map with another weather"),
        *((damaged, "holds a damaged plan") for damaged in ("{", "[]", "\xff", 7)),
    ],
)
def test_another_plan_is_not_taken_up(tmp_path, changed, said):
    path = stopped(make, tmp_path / "map.zarr")
    attributes = zarr.open_group(path).attrs
    plan = json.loads(attributes["plan"])
    attributes["plan"] = json.dumps(plan | dict([changed])) if isinstance(changed, tuple) else changed
    with pytest.raises(InputError, match=rf"map\.zarr {said}"):
        make(path, resume=True)
