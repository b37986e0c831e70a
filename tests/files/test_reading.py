"""What reading a motion says of files that other versions, other programs and half a writer left."""

import json
from pathlib import Path

import pytest

import hophoop as hh
from hophoop import io
from hophoop._support import files
from hophoop.results import save as export


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(hh.Scenario(duration=0.1))


def test_only_the_first_line_of_an_error_is_told():
    assert io._first_line(ValueError("no such key: \nand much more")) == "no such key"
    assert io._first_line(ValueError()) == "ValueError"


# --- formats ---------------------------------------------------------------------------------------


@pytest.mark.filterwarnings("error")
def test_each_format_asks_for_its_own_library_and_warns_of_nothing(motion, tmp_path, monkeypatch):
    asked, whole = [], io.need
    for module in (io, export):
        monkeypatch.setattr(module, "need", lambda library, extra: asked.append(library) or whole(library, extra))
    for name, own in (("hop.nc", "netCDF4"), ("hop.zarr", "zarr")):
        asked.clear()
        io.save(motion, tmp_path / name, n=5)
        hh.load(tmp_path / name)
        assert {"netCDF4", "zarr"} & set(asked) == {own}


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize("error", [PermissionError(13, "Permission denied"), RuntimeError("NetCDF: HDF error")])
def test_the_system_says_why_netcdf_fails(error):
    """It calls a full disk 'Permission denied'."""
    with pytest.raises(OSError, match="No space left on device"), files.netcdf_errors(Path("/dev/full")):
        raise error


def test_an_error_of_netcdf_is_one_of_the_system(tmp_path):
    said = r"hop\.nc cannot be written: NetCDF: HDF error"
    with pytest.raises(OSError, match=said), files.netcdf_errors(tmp_path / "hop.nc"):
        raise RuntimeError("NetCDF: HDF error")


def test_json_is_text_for_people_with_numbers_only(motion, tmp_path):
    io.write_json(motion, tmp_path / "hop.json", more={"Größe": 1.0})
    text = (tmp_path / "hop.json").read_text(encoding="utf-8")
    assert text.startswith('{\n  "')
    assert '\n  "Größe": 1.0\n}\n' in text
    assert json.loads(text) == motion.to_dict() | {"Größe": 1.0}
    with pytest.raises(ValueError, match="not JSON compliant"):
        io.write_json(motion, tmp_path / "hop.json", more={"size": float("nan")})
