"""Maps in files: as in memory, the same bytes after any stop, and one sentence where they are damaged or of others."""

import json
import os
import shutil
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
import zarr

import hophoop as hh
from damage import REFUSED, SAME, contents, tally
from hophoop import maps
from hophoop.maps.grid import chunks, quantities, store

AXES = {"plane.mu": np.linspace(0.05, 1.95, 24), "start.speed": np.linspace(0.05, 5.0, 20)}
QUANTITIES = ["sequence", "hop_height", "status"]
CHANGED = "is damaged: its checksum is not that of its content."


def make(out, **options):
    return maps.sweep(None, AXES, QUANTITIES, out=out, chunk_cells=60, **options)


def stopped(path, calls=2):
    """The path of a map that is stopped at the given call of its progress; the first one says what is there already."""
    shares = []

    def stop(done, total):
        shares.append(done / total)
        if len(shares) == calls:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make(path, threads=2, progress=stop)  # of 8 chunks, the others are not all under way
    return path


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    path = tmp_path_factory.mktemp("maps") / "whole.zarr"
    make(path)
    return path


@pytest.fixture
def copy(whole, tmp_path):
    return shutil.copytree(whole, tmp_path / "map.zarr")


# What is in them


def test_in_memory_and_in_files_are_identical(whole, tmp_path):
    memory = maps.sweep(None, AXES, QUANTITIES)
    assert maps.open_map(whole).load().identical(memory)
    file = tmp_path / "map.nc"
    written = make(file).load()
    assert [path.name for path in tmp_path.iterdir()] == ["map.nc"]
    maps.open_map(whole).to_netcdf(tmp_path / "copy.nc")  # as xarray writes it
    for one in (written, maps.open_map(tmp_path / "copy.nc")):
        xr.testing.assert_equal(one, memory)
        assert maps.words_of(one["sequence"]) == maps.words_of(memory["sequence"])


@pytest.mark.filterwarnings("error")
def test_plain_xarray_opens_a_store_whatever_a_file_browser_leaves_in_it(whole, copy):
    (copy / "Thumbs.db").write_bytes(b"")
    assert maps.open_map(copy).load().identical(maps.open_map(whole).load())
    with xr.open_zarr(copy) as dataset:
        assert set(QUANTITIES) <= set(dataset)


@pytest.mark.parametrize(
    ("axes", "quantities", "options"),
    [
        ({"start.speed": AXES["start.speed"]}, QUANTITIES, {}),
        ({"plane.impact_law": ["newton", "stronge"], "plane.restitution": [0.0, 0.5]}, ["landing_loss"], {}),
        ({"plane.mu": [0.1, 0.7], "start.speed": [0.1, 2.0, 4.0]}, ["fate", "revolutions"], {"span": "settled"}),
    ],
)
def test_any_map_is_the_same_in_memory_and_in_files(tmp_path, axes, quantities, options):
    """Along one axis, with words along an axis, and of what becomes of motions in the end."""
    memory = maps.sweep(None, axes, quantities, threads=1, **options)
    assert memory.sizes == {path: len(values) for path, values in axes.items()}
    xr.testing.assert_equal(maps.sweep(None, axes, quantities, out=tmp_path / "map.zarr", chunk_cells=2, **options), memory)


def test_every_variable_and_coordinate_says_what_it_is(whole):
    dataset = maps.open_map(whole)
    assert list(dataset) == QUANTITIES
    assert all(array.attrs["long_name"] and array.attrs["units"] for array in dataset.variables.values())
    assert (dataset["start.speed"].attrs["units"], dataset["hop_height"].attrs["units"]) == ("m/s", "m")
    assert json.loads(dataset.attrs["scenario"]) == hh.Scenario().to_dict()
    assert dataset.attrs["source"] == f"hophoop {hh.__version__}"
    table = maps.words_of(dataset["sequence"])[:-1]
    assert table == sorted(table, key=lambda text: (len(text), text))
    assert set(np.unique(dataset["sequence"])) == set(range(len(table)))


@pytest.mark.parametrize(("room", "kind"), [(-1, np.int16), (-2, np.int32)])
def test_more_sequences_than_short_codes_get_long_ones(whole, tmp_path, monkeypatch, room, kind):
    assert np.iinfo(np.int16).max == quantities.MOST_SHORT_CODES
    monkeypatch.setattr(quantities, "MOST_SHORT_CODES", len(maps.words_of(maps.open_map(whole)["sequence"])) + room)
    made = make(tmp_path / "map.zarr")
    assert made["sequence"].dtype == kind
    xr.testing.assert_equal(made, maps.open_map(whole))


# Stopped, and made by two at once


@pytest.mark.parametrize("calls", [2, 5])
def test_a_stopped_map_goes_on_to_the_same_bytes(whole, tmp_path, calls):
    path = stopped(tmp_path / "map.zarr", calls)
    with pytest.raises(ValueError, match="not complete"):
        maps.open_map(path)
    with pytest.raises(ValueError, match="exists already"):
        make(path)
    again = []
    make(path, resume=True, threads=1, progress=lambda done, total: again.append(done))
    assert 0 < again[0] < 480  # what is there is not computed again
    assert contents(path) == contents(whole)


KILLED = """
import os, signal, sys
import numpy as np
from hophoop import maps
axes = {"plane.mu": np.linspace(0.05, 1.95, 24), "start.speed": np.linspace(0.05, 5.0, 20)}
def die(done, total):
    if done > 100:
        os.kill(os.getpid(), signal.SIGKILL)
maps.sweep(None, axes, ["sequence", "hop_height", "status"], out=sys.argv[1], chunk_cells=60, progress=die)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no such signal there")
def test_a_killed_process_leaves_a_map_that_goes_on_to_the_same_bytes(whole, tmp_path):
    path = tmp_path / "map.zarr"
    assert subprocess.run([sys.executable, "-c", KILLED, path], check=False).returncode == -signal.SIGKILL
    assert (path / "unfinished" / "lock").exists()  # which is free again
    # leftovers of a writer that died in the middle: half a chunk, and a chunk of one quantity alone
    (path / "hop_height" / "c" / "0").mkdir(parents=True, exist_ok=True)
    (path / "hop_height" / "c" / "0" / "0.1234.partial").write_bytes(b"half a chunk")
    next(file for file in (path / "status" / "c").rglob("*") if file.is_file()).unlink()
    make(path, resume=True)
    assert contents(path) == contents(whole)


@pytest.mark.parametrize("step", ["codes_of", "encode", "_checksum_of", "rmtree"])
def test_a_stop_while_finishing_changes_nothing(whole, tmp_path, monkeypatch, step):
    path = tmp_path / "map.zarr"

    def stop(*arguments, **options):
        raise KeyboardInterrupt

    name, value = ("shutil", SimpleNamespace(rmtree=stop)) if step == "rmtree" else (step, stop)
    monkeypatch.setattr(store, name, value)
    with pytest.raises(KeyboardInterrupt):
        make(path)
    monkeypatch.undo()
    if step == "rmtree":  # complete, except for the folder
        assert maps.open_map(path).identical(maps.open_map(whole))
    else:
        with pytest.raises(ValueError, match="not complete"):
            maps.open_map(path)
    make(path, resume=True)
    assert contents(path) == contents(whole)


def test_a_complete_map_is_not_computed_again(whole, copy, monkeypatch):
    monkeypatch.setattr(chunks, "compute_chunk", None)
    monkeypatch.setattr(store, "finish", None)
    assert make(copy, resume=True).identical(maps.open_map(whole))


def test_a_map_that_is_being_made_is_refused(tmp_path):
    path = tmp_path / "map.zarr"
    refusals = []

    def another(done, total):
        with pytest.raises(ValueError, match=r"map\.zarr is being written by another process: wait for it") as caught:
            make(path, resume=True)
        refusals.append(caught)

    make(path, progress=another)
    assert len(refusals) > 1


@pytest.mark.parametrize("moment", ["_provenance", "_locked"])
def test_another_process_comes_first(whole, tmp_path, monkeypatch, moment):
    """It begins the map just as this one is about to create it, or completes it as this one is about to lock it."""
    path, usual = tmp_path / "map.zarr", getattr(store, moment)
    if moment == "_locked":
        stopped(path)

    def late(argument):
        monkeypatch.undo()
        make(path, resume=True) if moment == "_locked" else stopped(path)
        return usual(argument)

    monkeypatch.setattr(store, moment, late)
    make(path, resume=moment == "_locked")
    assert contents(path) == contents(whole)
    assert [file.name for file in tmp_path.iterdir()] == ["map.zarr"]


def test_two_threads_make_maps_at_once():
    with ThreadPoolExecutor(2) as pool:
        one, other = pool.map(lambda _: maps.sweep(None, AXES, QUANTITIES, threads=2), range(2))
    assert one.identical(other)


# Damaged, and of others


@pytest.mark.parametrize("ending", ["zarr", "nc"])
def test_a_damaged_map_is_the_same_map_or_one_sentence(whole, tmp_path, ending):
    if ending == "nc":
        whole = tmp_path / "whole.nc"
        make(whole)
    values = maps.open_map(whole).load()
    came = tally(lambda file: maps.open_map(file).load(), values.identical, whole, tmp_path / f"damaged.{ending}", 12)
    assert set(came) <= {SAME, REFUSED}
    assert came[REFUSED] > 2


@pytest.mark.parametrize(("name", "value"), [("units", "days since nowhere"), ("missing_value", 9.5), (None, 0.8)])
def test_a_changed_axis_is_noticed_before_it_is_decoded(copy, name, value):
    """Decoding would stumble over one attribute, and take the other away."""
    axis = zarr.open_group(copy, mode="a", use_consolidated=False)["plane.mu"]
    if name is None:
        axis[1] = value
    else:
        axis.attrs[name] = value
    with pytest.raises(ValueError, match=rf"map\.zarr {CHANGED}$"):
        maps.open_map(copy)


@pytest.mark.parametrize("name", ["hop_height", "sequence"])
def test_a_damaged_chunk_is_noticed_with_the_name_of_the_file(copy, name):
    """Zarr says of it only that checksums do not match, and only where it is read."""
    for file in (copy / name / "c").rglob("*"):
        if file.is_file():
            data = bytearray(file.read_bytes())
            data[len(data) // 2] ^= 1
            file.write_bytes(data)
            break
    with pytest.raises(ValueError, match=rf"map\.zarr is damaged: a part of {name} is not as it was written\.$"):
        maps.open_map(copy)


def test_a_part_that_is_missing_is_noticed(copy):
    next(file for file in (copy / "hop_height" / "c").rglob("*") if file.is_file()).unlink()
    with pytest.raises(ValueError, match=r"map\.zarr is damaged: a part of it is missing\.$"):
        maps.open_map(copy)


def test_other_files_are_refused(tmp_path):
    future = xr.Dataset(attrs={"schema": "hophoop-map/4", "plan": "in other words"})
    future.to_netcdf(tmp_path / "future.nc")
    future.to_zarr(tmp_path / "future.zarr", consolidated=False)
    xr.Dataset({"x": ("time", [1.0])}).to_netcdf(tmp_path / "other.nc")
    (tmp_path / "noise.nc").write_bytes(b"no file of ours" * 99)
    (tmp_path / "folder.zarr").mkdir()
    for name, said in (
        *(
            (f"future.{ending}", "has the schema 'hophoop-map/4', but .* reads 'hophoop-map/1' only")
            for ending in ("nc", "zarr")
        ),
        ("other.nc", "is not a map of hophoop"),
        ("noise.nc", r"cannot be read as a map of hophoop: [^\n]*[^.: ]"),
        ("folder.zarr", "cannot be read as a map of hophoop: .*"),
        ("nothing.zarr", "is not there"),
    ):
        with pytest.raises(ValueError, match=rf"{name} {said}\.$"):
            maps.open_map(tmp_path / name)


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"hophoop": "0.0.9"}, r"a map of hophoop 0\.0\.9, which this version .* cannot resume\.$"),
        ({"weather": "fine"}, "a map with another weather"),
        ({"scenario": {}}, "a map with another scenario"),
        ({"axes": {}}, "a map with another axes"),
        *((damaged, "a damaged plan") for damaged in ("{", "[]", "\xff", 7)),
    ],
)
def test_another_plan_is_not_taken_up(copy, changed, said):
    attributes = zarr.open_group(copy).attrs
    attributes["plan"] = json.dumps(json.loads(attributes["plan"]) | changed) if isinstance(changed, dict) else changed
    with pytest.raises(ValueError, match=rf"map\.zarr holds {said}"):
        make(copy, resume=True)


def test_a_strange_folder_is_left_alone(tmp_path):
    path = tmp_path / "map.zarr"
    path.mkdir()
    (path / "letter.txt").write_text("mine")
    with pytest.raises(ValueError, match="is not a map"):
        make(path, resume=True)
    assert (path / "letter.txt").read_text() == "mine"
    with pytest.raises(OSError, match=r"letter\.txt"):  # a folder that cannot be made
        make(path / "letter.txt" / "map.zarr")


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
@pytest.mark.parametrize("ending", ["zarr", "nc"])
def test_a_link_to_nothing_gets_its_map(tmp_path, ending):
    (tmp_path / "data").mkdir()
    link = tmp_path / f"link.{ending}"
    link.symlink_to(f"data/map.{ending}")
    make(link).close()
    assert os.readlink(link) == f"data/map.{ending}"
    assert os.listdir(tmp_path / "data") == [f"map.{ending}"]
