"""What files are written and read with: a checksum behind the bytes, a place that is taken when all is there."""

import errno
import hashlib
import os
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from hophoop._support import checksum as _checksum
from hophoop._support import files as _files

# --- the seal --------------------------------------------------------------------------------------


@pytest.mark.parametrize("length", [0, 1, 80, 81, 2**20, 3 * 2**19])
def test_a_seal_holds_for_any_length_and_breaks_with_any_byte(tmp_path, length):
    file = tmp_path / "bytes"
    content = bytes(k * k % 251 for k in range(length))
    file.write_bytes(content)
    assert not _checksum.is_broken(file)  # it has no seal
    _checksum.seal(file)
    sealed = file.read_bytes()
    assert sealed == content + b"\nhophoop sha256 " + hashlib.sha256(content).hexdigest().encode() + b"\n"
    assert not _checksum.is_broken(file)
    for place in {0, length // 2, length - 1, length + 20, length + 79} - {-1, length}:
        changed = bytearray(sealed)
        changed[place] ^= 1
        file.write_bytes(changed)
        assert _checksum.is_broken(file)


def test_the_checksum_is_the_same_in_every_version():
    # files of today must be read by every later version
    data = xr.Dataset({"x": ("time", np.array([1.0, -2.5]), {"units": "µm"})}, attrs={"b": 1, "a": [2.0]})
    lines = ('["/", [["a", [2.0]], ["b", [1]]]]\n', '["x", ["time"], [2], "<f8", [["units", ["µm"]]]]\n')
    told = hashlib.sha256("".join(lines).encode())
    assert _checksum.checksum({"/": data}, without=["x"]) == told.hexdigest()
    told.update(np.array([1.0, -2.5], dtype="<f8").tobytes())
    assert _checksum.checksum({"/": data}) == told.hexdigest()


# --- taking the place ------------------------------------------------------------------------------


def folder(path, text, mark="zarr.json"):
    path.mkdir()
    (path / mark).write_text(text, encoding="utf-8")
    return path


def put(target, text):
    with _files.replacing(target) as temporary:
        folder(temporary, text)


def test_a_folder_takes_the_place_of_another_store_only(tmp_path):
    target = folder(tmp_path / "hop.zarr", "old")
    put(target, "new")
    assert (target / "zarr.json").read_text(encoding="utf-8") == "new"
    assert os.listdir(tmp_path) == ["hop.zarr"]
    older = folder(tmp_path / "older.zarr", "old", ".zgroup")
    put(older, "new")
    assert (older / "zarr.json").read_text(encoding="utf-8") == "new"
    theirs = folder(tmp_path / "theirs.zarr", "their thesis", "thesis.tex")
    with pytest.raises(IsADirectoryError) as refusal:
        put(theirs, "new")
    assert refusal.value.filename == str(theirs)
    assert (theirs / "thesis.tex").read_text(encoding="utf-8") == "their thesis"


def test_what_fails_leaves_nothing_and_names_the_target(tmp_path):
    target = tmp_path / "hop.csv"
    target.write_text("old", encoding="utf-8")
    with pytest.raises(UnicodeEncodeError), _files.replacing(target) as temporary:
        temporary.write_text("half κ", encoding="ascii")
    assert target.read_text(encoding="utf-8") == "old"
    assert os.listdir(tmp_path) == ["hop.csv"]


def test_an_error_names_the_target_unless_it_is_of_another_file(tmp_path):
    target = tmp_path / "hop.csv"

    def fail(error):
        with pytest.raises(type(error)) as refusal, _files.replacing(target):
            raise error
        return refusal.value.filename

    assert fail(PermissionError(errno.EACCES, "no", "/etc/another")) == "/etc/another"
    assert fail(PermissionError(errno.EACCES, "no")) == str(target)


def test_a_folder_that_cannot_be_put_leaves_what_was_there(tmp_path, monkeypatch):
    target, rename = folder(tmp_path / "hop.zarr", "old"), Path.rename

    def refused(self, to):
        if to == target and not self.name.endswith(".old"):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        return rename(self, to)

    monkeypatch.setattr(Path, "rename", refused)
    with pytest.raises(PermissionError):
        put(target, "new")
    assert os.listdir(tmp_path) == ["hop.zarr"]
    assert (target / "zarr.json").read_text(encoding="utf-8") == "old"
