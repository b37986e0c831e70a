"""Pieces of a store: its codes, plan, lock, checksum and what is said of one that cannot be read."""

from __future__ import annotations

import types

import numpy as np
import pytest
import xarray as xr
import zarr

from hophoop import maps
from hophoop._support.checksum import checksum
from hophoop.maps.grid import store
from map_tools import stopped

AXES = {"plane.mu": [0.1, 0.7, 1.3], "start.speed": [0.5, 2.5, 3.2, 4.0]}
QUANTITIES = ["sequence", "status"]


def make(path, **options):
    return maps.sweep(None, AXES, QUANTITIES, out=path, chunk_cells=4, threads=1, **options)


def test_short_codes_hold_all_they_may():
    assert np.iinfo(np.int16).max == store.MOST_SHORT_CODES


@pytest.mark.parametrize(("room", "kind"), [(0, np.int16), (-1, np.int32)])
def test_more_sequences_than_short_codes_get_long_ones(tmp_path, monkeypatch, room, kind):
    memory = maps.sweep(None, AXES, QUANTITIES)
    monkeypatch.setattr(store, "MOST_SHORT_CODES", len(maps.words_of(memory["sequence"])) + room)
    made = make(tmp_path / "map.zarr")
    assert made["sequence"].dtype == kind
    np.testing.assert_array_equal(made["sequence"].values, memory["sequence"].values)


def test_coordinates_are_zero_where_nothing_is_written(tmp_path):
    make(tmp_path / "map.zarr")
    group = zarr.open_group(tmp_path / "map.zarr", mode="r")
    assert [group[name].fill_value for name in AXES] == [0.0, 0.0]


def test_a_map_that_was_finished_while_its_lock_was_taken_is_complete(tmp_path, monkeypatch):
    path = stopped(make, tmp_path / "map.zarr")
    lock = store._locked

    def late(place):  # another process completes the map first
        monkeypatch.undo()
        make(path, resume=True)
        return lock(place)

    monkeypatch.setattr(store, "_locked", late)
    counts = []
    made = make(path, resume=True, progress=lambda done, total: counts.append(done))
    assert counts == [12]
    assert made.identical(maps.open_map(path))
    assert not (path / "unfinished").exists()


def test_a_chunk_that_lacks_a_quantity_is_computed_again(tmp_path):
    path = stopped(make, tmp_path / "map.zarr")
    counts = []
    written = sorted(file for file in (path / "status" / "c").rglob("*") if file.is_file())
    written[0].unlink()
    make(path, resume=True, progress=lambda done, total: counts.append(done))
    assert counts[0] == sum(2 * min(2, 3 - 2 * int(file.parent.name)) for file in written[1:])  # chunks of 2 × 2 cells
    assert not (path / "unfinished").exists()


def test_the_checksum_of_a_map_is_of_what_stands_in_it(tmp_path):
    make(tmp_path / "map.zarr")
    with xr.open_zarr(tmp_path / "map.zarr", consolidated=False, chunks=None, decode_cf=False) as dataset:
        told = checksum({"/": dataset}, without=QUANTITIES)
        assert dataset.attrs["checksum"] == told


@pytest.mark.parametrize(
    ("error", "said"), [(RuntimeError("no chunk: \nof many"), "no chunk"), (RuntimeError(), "RuntimeError")]
)
def test_what_a_library_says_of_a_map_ends_in_one_sentence(tmp_path, monkeypatch, error, said):
    def fail(place):
        raise error

    monkeypatch.setattr(store, "_check_whole", fail)
    with pytest.raises(ValueError, match="cannot be read") as caught:
        maps.open_map(tmp_path)
    assert str(caught.value) == f"{tmp_path} cannot be read as a map of hophoop: {said}."


@pytest.mark.parametrize("error", [OSError, ValueError, KeyError])
def test_a_folder_that_zarr_cannot_open_has_no_plan(tmp_path, monkeypatch, error):
    path = tmp_path / "map.zarr"
    path.mkdir()

    def open_group(path, mode):
        raise error

    monkeypatch.setattr(store, "need", lambda name, extra: types.SimpleNamespace(open_group=open_group))
    with pytest.raises(ValueError, match="is not a map of hophoop"):
        make(path, resume=True)


def test_a_folder_that_cannot_be_made_is_an_error_of_the_system(tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(OSError, match="file"):
        make(tmp_path / "file" / "nowhere" / "map.zarr")


def test_an_axis_of_numbers_without_words_keeps_its_numbers():
    plan = '{"quantities": ["status"]}'
    dataset = xr.Dataset({"status": ("n", [1, 2])}, coords={"n": ("n", [7, 9], {"long_name": "n"})}, attrs={"plan": plan})
    assert store.with_words(dataset)["n"].values.tolist() == [7, 9]


@pytest.mark.parametrize(("name", "value"), [("units", "days since nowhere"), ("missing_value", 9.5), (None, 0.8)])
def test_a_changed_axis_is_noticed_before_it_is_decoded(tmp_path, name, value):
    """Decoding would stumble over one attribute, and take the other away."""
    make(tmp_path / "map.zarr")
    axis = zarr.open_group(tmp_path / "map.zarr", mode="a")["plane.mu"]
    if name is None:
        axis[1] = value
    else:
        axis.attrs[name] = value
    with pytest.raises(ValueError, match=r"map\.zarr is damaged: its checksum is not that of its content\.$"):
        maps.open_map(tmp_path / "map.zarr")
