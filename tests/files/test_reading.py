"""What reading a motion says of files that other versions, other programs and half a writer left."""

from __future__ import annotations

import json
import re
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr
import zarr

import hophoop as hh
from damage import sign, unseal
from hophoop import io
from hophoop._support import files
from hophoop.results import save as export


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(hh.Scenario(duration=0.1))


@pytest.fixture
def saved(motion, tmp_path):
    path = tmp_path / "hop.nc"
    io.save(motion, path, n=5)
    unseal(path)
    return path


def change(path, **attributes):
    """Write a file with other attributes, as if hophoop had."""
    with netCDF4.Dataset(path, "a") as file:
        file.setncatts(attributes)
    sign(path)


def refusal(path):
    with pytest.raises(ValueError, match=rf"^{re.escape(str(path))} ") as caught:
        hh.load(path)
    return str(caught.value).removeprefix(f"{path} ")


# --- damaged, of another version, not whole ---------------------------------------------------------


@pytest.mark.parametrize(
    "attributes",
    [
        {"scenario": "{"},  # ValueError
        {"scenario": 5},  # TypeError
        {"scenario": "[" * 100_000},  # RecursionError
        {"scenario": '{"nonsense": 1}'},
        {"status": "asleep"},  # KeyError
        {"status": 5},  # AttributeError
    ],
)
def test_an_attribute_that_means_nothing_is_damage(saved, attributes):
    change(saved, **attributes)
    assert refusal(saved).startswith("is damaged: ")


def test_what_another_version_can_say_is_told_with_its_name(saved):
    change(saved, version="0.0.1", scenario='{"nonsense": 1}')
    assert refusal(saved).startswith("was written by hophoop 0.0.1: ")
    change(saved, scenario="{")
    assert refusal(saved).startswith("is damaged: ")


def test_a_zarr_store_without_a_table_cannot_be_read(motion, tmp_path):
    path = tmp_path / "hop.zarr"
    io.save(motion, path, n=5)
    del zarr.open_group(path, mode="a")["segments"]
    assert re.match(r"cannot be read as Zarr: .*segments", refusal(path))


def test_a_table_without_its_layout_is_damage(motion, tmp_path):
    path = tmp_path / "hop.zarr"
    io.save(motion, path, n=5)
    del zarr.open_group(path, mode="a")["events"].attrs["layout"]
    sign(path)
    assert refusal(path) == "is damaged: 'layout'."


def test_only_the_first_line_of_an_error_is_told():
    assert io._first_line(ValueError("no such key: \nand much more")) == "no such key"
    assert io._first_line(ValueError()) == "ValueError"


def test_a_warning_about_the_version_points_at_who_loads(saved):
    change(saved, version="0.0.1")
    with pytest.warns(UserWarning, match="was written by hophoop 0") as caught:
        hh.load(saved)
    assert [Path(warning.filename).name for warning in caught] == [Path(__file__).name]


def test_a_column_of_vectors_comes_back():
    table = np.zeros(2, dtype=[("t", "f8"), ("force", "f8", (3,))])
    table["force"] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]
    packed = export._packed(xr, table, "event")
    assert packed["force"].dims == ("event", "force_1")
    assert io._unpacked(packed).tobytes() == table.tobytes()


def test_a_store_whose_metadata_is_no_text_of_zarr_is_refused(tmp_path):
    path = tmp_path / "hop.zarr"
    path.mkdir()
    (path / "zarr.json").write_text("{", encoding="utf-8")
    assert refusal(path).startswith("cannot be read as Zarr: ")


# --- formats ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "other"), [("hop.nc", "zarr"), ("hop.zarr", "netCDF4")])
@pytest.mark.filterwarnings("error")
def test_each_format_asks_for_its_own_library_and_warns_of_nothing(motion, tmp_path, monkeypatch, name, other):
    asked, whole = [], io.need

    def need(library, extra):
        asked.append(library)
        return whole(library, extra)

    for module in (io, export):
        monkeypatch.setattr(module, "need", need)
    io.save(motion, tmp_path / name, n=5)
    hh.load(tmp_path / name)
    assert other not in asked
    assert {"netCDF4", "zarr"} - {other} <= set(asked)


@pytest.mark.parametrize(("name", "words"), [("hop.nc", "netCDF"), ("hop.zarr.zip", "Zarr")])
def test_noise_is_named_by_its_format(tmp_path, name, words):
    (tmp_path / name).write_bytes(b"this is no file of ours" * 99)
    assert refusal(tmp_path / name).startswith(f"cannot be read as {words}: ")


def test_a_file_of_others_is_refused_without_a_word_on_formats(tmp_path):
    for attributes in ({}, {"schema": 5}, {"schema": "other/1"}):
        path = tmp_path / "other.nc"
        xr.Dataset({"x": ("time", [1.0])}, attrs=attributes).to_netcdf(path)
        assert refusal(path) == "is not a saved motion of hophoop."
    (tmp_path / "empty.zarr").mkdir()
    assert refusal(tmp_path / "empty.zarr").startswith("cannot be read as Zarr")


@pytest.mark.parametrize("name", ["hop.zarr", "hop.zarr.zip"])
def test_what_fails_at_once_says_why(motion, tmp_path, name, monkeypatch):
    def full(self, *arguments, **options):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(xr.Dataset, "to_zarr", full)
    with pytest.raises(OSError, match="No space left on device"):
        io.save(motion, tmp_path / name, n=5)
    assert not list(tmp_path.iterdir())


def test_a_full_disk_is_an_error_of_the_system_in_netcdf_too(motion, tmp_path, monkeypatch):
    def full(self, *arguments, **options):
        raise RuntimeError("NetCDF: HDF error")

    monkeypatch.setattr(xr.Dataset, "to_netcdf", full)
    with pytest.raises(OSError, match=r"hop\.nc cannot be written: NetCDF: HDF error"):
        io.save(motion, tmp_path / "hop.nc", n=5)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize("error", [PermissionError(13, "Permission denied"), RuntimeError("NetCDF: HDF error")])
def test_the_system_says_why_netcdf_fails(error):
    """It calls a full disk 'Permission denied'."""
    with pytest.raises(OSError, match="No space left on device"), files.netcdf_errors(Path("/dev/full")):
        raise error


def test_an_error_names_the_file_that_was_given(tmp_path, monkeypatch):
    """In a folder that is read-only, removing the temporary file fails as well."""

    def refuse(path, **_):
        raise OSError(30, "Read-only file system", str(path))

    monkeypatch.setattr(Path, "unlink", refuse)
    with pytest.raises(OSError, match="Read-only") as refused, files.replacing(tmp_path / "hop.csv") as fresh:
        fresh.write_text("text")
    assert refused.value.filename == str(tmp_path / "hop.csv")


def test_json_is_text_for_people_with_numbers_only(motion, tmp_path):
    io.write_json(motion, tmp_path / "hop.json", more={"Größe": 1.0})
    text = (tmp_path / "hop.json").read_text(encoding="utf-8")
    assert text.startswith('{\n  "')
    assert '\n  "Größe": 1.0\n}\n' in text
    assert json.loads(text) == motion.to_dict() | {"Größe": 1.0}
    with pytest.raises(ValueError, match="not JSON compliant"):
        io.write_json(motion, tmp_path / "hop.json", more={"size": float("nan")})
