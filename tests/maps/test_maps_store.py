"""Maps in files: equal to those in memory, and equal bytes after any stop."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps
from hophoop.maps.grid import chunks, store
from map_tools import contents

AXES = {"plane.mu": np.linspace(0.05, 1.95, 60), "start.speed": np.linspace(0.05, 5.0, 50)}
QUANTITIES = ["sequence", "hop_height", "status"]
CHUNK = 200


def make(out, **options):
    return maps.sweep(None, AXES, QUANTITIES, out=out, chunk_cells=CHUNK, **options)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    path = tmp_path_factory.mktemp("maps") / "whole.zarr"
    make(path)
    return path


def test_in_memory_and_in_files_are_identical(whole, tmp_path):
    memory = maps.sweep(None, AXES, QUANTITIES)
    assert maps.open_map(whole).load().identical(memory)
    file = tmp_path / "map.nc"
    written = maps.sweep(None, AXES, QUANTITIES, out=file, chunk_cells=CHUNK).load()
    for name in QUANTITIES:
        np.testing.assert_array_equal(written[name].values, memory[name].values)
        assert written[name].attrs["long_name"] == memory[name].attrs["long_name"]
    assert maps.words_of(written["sequence"]) == maps.words_of(memory["sequence"])
    assert [path.name for path in tmp_path.iterdir()] == ["map.nc"]


@pytest.mark.filterwarnings("error")
def test_what_a_file_browser_leaves_in_a_folder_is_not_spoken_of(whole, tmp_path):
    shutil.copytree(whole, tmp_path / "map.zarr")
    (tmp_path / "map.zarr" / "Thumbs.db").write_bytes(b"")
    assert maps.open_map(tmp_path / "map.zarr").load().identical(maps.open_map(whole).load())


def test_every_variable_and_coordinate_says_what_it_is(whole):
    dataset = maps.open_map(whole)
    assert list(dataset) == QUANTITIES
    for name in [*dataset.data_vars, *dataset.coords]:
        assert dataset[name].attrs["long_name"]
        assert dataset[name].attrs["units"]
    assert dataset["start.speed"].attrs["units"] == "m/s"
    assert dataset["hop_height"].attrs["units"] == "m"
    assert json.loads(dataset.attrs["scenario"]) == hh.Scenario().to_dict()
    assert dataset.attrs["source"] == f"hophoop {hh.__version__}"
    assert dataset.attrs["tolerance"] > 0
    table = maps.words_of(dataset["sequence"])
    assert table == sorted(table, key=lambda text: (len(text), text))
    assert set(np.unique(dataset["sequence"])) == set(range(len(table)))


def test_it_opens_without_us(whole):
    import xarray

    with xarray.open_zarr(str(whole), consolidated=False, chunks=None) as dataset:
        assert dataset["sequence"].dims == ("plane.mu", "start.speed")


def test_words_along_an_axis(tmp_path):
    axes = {"plane.impact_law": ["newton", "stronge"], "plane.restitution": [0.0, 0.5]}
    dataset = maps.sweep(None, axes, ["landing_loss"], out=tmp_path / "map.zarr")
    assert dataset["plane.impact_law"].values.tolist() == ["newton", "stronge"]
    memory = maps.sweep(None, axes, ["landing_loss"])
    np.testing.assert_array_equal(dataset["landing_loss"], memory["landing_loss"])


class Stopped(BaseException):
    pass


@pytest.mark.parametrize("interrupt", [KeyboardInterrupt, Stopped])
@pytest.mark.parametrize("after", [1, 7, 16])
def test_a_stopped_map_goes_on_to_the_same_bytes(whole, tmp_path, interrupt, after):
    path = tmp_path / "map.zarr"
    shares = []

    def stop(done, total):
        shares.append(done / total)
        if len(shares) == after + 1:  # the first call says what is there already
            raise interrupt

    with pytest.raises(interrupt):
        make(path, progress=stop)
    with pytest.raises(ValueError, match="not complete"):
        maps.open_map(path)
    with pytest.raises(ValueError, match="exists already"):
        make(path)
    again = []
    make(path, resume=True, threads=1, progress=lambda done, total: again.append(done))
    assert round(shares[-1] * 3000) <= again[0] < 3000  # chunks that were being computed are kept, too
    assert contents(path) == contents(whole)


KILLED = """
import numpy as np, sys
from hophoop import maps
axes = {{"plane.mu": np.linspace(0.05, 1.95, 60), "start.speed": np.linspace(0.05, 5.0, 50)}}
print("ready", flush=True)
maps.sweep(None, axes, {quantities!r}, out=sys.argv[1], chunk_cells={chunk}, resume=True)
"""


def pieces_done(path):
    """How many pieces of a map are kept: files of its last quantity, each of which is written at once."""
    return len(list(path.glob("status/c/*/*")))


@pytest.mark.skipif(sys.platform == "win32", reason="no signals to one process there")
@pytest.mark.parametrize("number", ["SIGKILL", "SIGINT"])
def test_a_stopped_process_leaves_a_map_that_goes_on_to_the_same_bytes(whole, tmp_path, number):
    path = tmp_path / "map.zarr"
    code = KILLED.format(quantities=QUANTITIES, chunk=CHUNK)
    process = subprocess.Popen([sys.executable, "-c", code, str(path)], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout.readline().strip() == b"ready"
    deadline = time.monotonic() + 120
    while process.poll() is None and time.monotonic() < deadline:
        if pieces_done(path) >= 3:
            process.send_signal(getattr(signal, number))
            break
        time.sleep(0.002)
    _, said = process.communicate(timeout=60)
    assert pieces_done(path) >= 3
    if number == "SIGKILL":
        assert (path / "unfinished" / "lock").exists()  # which is free again
        # leftovers of a writer that died in the middle
        (path / "hop_height" / "c" / "0").mkdir(parents=True, exist_ok=True)
        (path / "hop_height" / "c" / "0" / "0.1234.partial").write_bytes(b"half a chunk")
    elif process.returncode != 0:  # else it was faster than we
        assert b"KeyboardInterrupt" in said
    make(path, resume=True)
    assert contents(path) == contents(whole)


@pytest.mark.parametrize("step", ["table_of", "code_type", "encode", "_checksum_of", "rmtree"])
def test_a_stop_while_finishing_changes_nothing(whole, tmp_path, monkeypatch, step):
    path = tmp_path / "map.zarr"

    def stop(*arguments, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr(
        store, "shutil" if step == "rmtree" else step, SimpleNamespace(rmtree=stop) if step == "rmtree" else stop
    )
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


def test_a_complete_map_is_not_computed_again(whole, tmp_path, monkeypatch):
    path = tmp_path / "map.zarr"
    shutil.copytree(whole, path)
    monkeypatch.setattr(chunks, "compute_chunk", None)
    monkeypatch.setattr(store, "finish", None)
    assert make(path, resume=True).identical(maps.open_map(path))


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"base": hh.Scenario(duration=9.0)}, "scenario"),
        ({"axes": {"plane.mu": AXES["plane.mu"][:50], "start.speed": AXES["start.speed"]}}, "axes"),
        ({"quantities": ["sequence"]}, "quantities"),
        ({"span": "takeoff"}, "span"),
    ],
)
def test_another_map_is_not_taken_up(whole, tmp_path, change, word):
    path = tmp_path / "map.zarr"
    shutil.copytree(whole, path)
    arguments = {"base": None, "axes": AXES, "quantities": QUANTITIES} | change
    with pytest.raises(ValueError, match=f"another {word}"):
        maps.sweep(**arguments, out=path, resume=True)


def test_a_strange_folder_is_left_alone(tmp_path):
    path = tmp_path / "map.zarr"
    path.mkdir()
    (path / "letter.txt").write_text("mine")
    with pytest.raises(ValueError, match="is not a map"):
        make(path, resume=True)
    assert (path / "letter.txt").read_text() == "mine"
    with pytest.raises(ValueError, match="is not there"):
        maps.open_map(tmp_path / "nothing.zarr")


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
@pytest.mark.parametrize("ending", ["zarr", "nc"])
def test_a_link_to_nothing_gets_its_map(tmp_path, ending):
    (tmp_path / "data").mkdir()
    link = tmp_path / f"link.{ending}"
    link.symlink_to(f"data/map.{ending}")
    axes = {"plane.mu": [0.2, 0.4], "start.speed": [1.0, 2.0]}
    dataset = maps.sweep(None, axes, ["landing_loss"], out=link)
    assert dataset.sizes == {"plane.mu": 2, "start.speed": 2}
    dataset.close()
    assert os.readlink(link) == f"data/map.{ending}"
    assert os.listdir(tmp_path / "data") == [f"map.{ending}"]
