"""`hophoop map`, as a person or a script calls it."""

import re
from functools import wraps
from types import SimpleNamespace

import numpy as np
import psutil
import pytest
from typer.testing import CliRunner

import hophoop as hh
from hophoop import maps
from hophoop.cli import app
from hophoop.maps.grid import memory, sweeping

AXES = ["--axis", "plane.mu=0.2:1.8:9", "--axis", "start.speed=0.1,2,3.1,5"]


def call(*arguments, **options):
    return CliRunner().invoke(app, ["map", *map(str, arguments)], **options)


def test_a_map_into_a_file_and_a_picture(tmp_path):
    out, picture = tmp_path / "map.zarr", tmp_path / "map.png"
    quantities = ["--quantity", "sequence", "--quantity", "hop_height"]
    done = call(*AXES, *quantities, "--out", out, "--plot", picture, "--quiet")
    assert done.exit_code == 0, done.output
    assert "36 motions" in done.output
    expected = maps.sweep(
        None,
        {"plane.mu": np.linspace(0.2, 1.8, 9), "start.speed": [0.1, 2.0, 3.1, 5.0]},
        ["sequence", "hop_height"],
    )
    assert maps.open_map(out).load().identical(expected)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert call(*AXES, *quantities, "--out", out, "--resume", "--quiet").exit_code == 0


def test_a_scenario_as_the_base(tmp_path):
    file = tmp_path / "hop.toml"
    hh.Scenario(hoop=hh.Hoop.ideal(0.5)).save(file)
    done = call(file, *AXES, "--out", tmp_path / "map.nc", "--quiet", "--span", "takeoff")
    assert done.exit_code == 0, done.output
    dataset = maps.open_map(tmp_path / "map.nc")
    assert '"load_fraction": 0.5' in dataset.attrs["scenario"]
    assert dataset.attrs["span"] == "takeoff"


def test_what_becomes_of_motions(tmp_path):
    out, picture = tmp_path / "map.zarr", tmp_path / "map.svg"
    quantities = ["--quantity", "fate", "--quantity", "mean_speed"]
    done = call(*AXES, *quantities, "--span", "settled", "--out", out, "--plot", picture, "--quiet")
    assert done.exit_code == 0, done.output
    dataset = maps.open_map(out).load()
    words = maps.words_of(dataset["fate"])
    found = dataset["fate"].sel({"plane.mu": 1.0, "start.speed": [0.1, 3.1, 5.0]}).values
    assert [words[k] for k in found] == ["rolls_ahead", "slips_ever_less", "rocks"]
    assert "rolls ahead" in picture.read_text(encoding="utf-8")
    refused = call(*AXES, "--quantity", "fate", "--out", tmp_path / "b.zarr", "--quiet")
    assert refused.exit_code == 2
    assert "must be settled or settled:landing with quantity fate" in " ".join(refused.output.split())


def test_without_a_terminal_only_the_result_is_reported(tmp_path):
    done = call(*AXES, "--out", tmp_path / "map.zarr")
    assert done.output == f"36 motions in {tmp_path / 'map.zarr'}\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (AXES, "--out or --plot"),
        ([*AXES, "--resume", "--plot", "a.png"], "--out must name the map"),
        ([*AXES, "--axis", "plane.mu=1:2:3", "--out", "a.zarr"], "names plane.mu twice"),
        ([*AXES[:2], "--out", "a.zarr"], "at least two"),
        ([*AXES, "--out", "a.zarr", "--span", "ever"], "span = 'ever'"),
        ([*AXES, "--out", "a.zarr", "--quantity", "size"], "quantity = 'size'"),
        ([*AXES, "--axis", "hoop.mass=1,2", "--out", "a.zarr", "--plot", "a.png"], "two axes, not 3"),
        ([*AXES, "--out", "a.zarr", "--plot", "a.xyz"], "--plot = a.xyz must end in .png"),
        ([*AXES, "--plot", "gone/a.png"], "--plot = gone/a.png must be in an existing folder; gone does not exist"),
        (
            ["--axis", "plane.mu=0:1:300000", "--axis", "start.speed=1:2:300000", "--plot", "a.png"],
            "axes make 90,000,000,000 motions, which need",
        ),
        ([*AXES, "--out", "a.map"], "out = 'a.map' must end in .zarr or .nc"),
    ],
)
def test_bad_input_is_one_sentence(tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    done = call(*arguments)
    assert done.exit_code == 2
    assert message in " ".join(done.output.split())
    assert list(tmp_path.iterdir()) == []


def test_the_help_lists_the_quantities():
    text = call("--help").output
    for name, quantity in maps.QUANTITIES.items():
        assert re.search(rf"^  {name} +{re.escape(quantity.meaning)}", text, re.MULTILINE), name


def test_a_map_that_does_not_fit_into_memory_is_refused_before_it_starts(monkeypatch):
    values = {"plane.mu": np.linspace(0.1, 1.0, 20000), "start.speed": np.linspace(0.1, 3.0, 20000)}
    monkeypatch.setattr(memory, "free_memory", lambda: 1e9)
    with pytest.raises(ValueError, match=r"400,000,000 motions, which need 1\.8 GB of memory where 1\.0 GB are free"):
        maps.sweep(None, values)
    assert memory.check_memory([1000, 1000], ["f8"], "no") is None


def test_free_memory_is_what_the_system_can_give(monkeypatch):
    """Not all memory, and on every system: of 64 GB, 0.5 GB are available here."""
    monkeypatch.setattr(psutil, "virtual_memory", lambda: SimpleNamespace(total=64e9, available=5e8, free=1e8))
    with pytest.raises(ValueError, match=r"need 1\.0 GB of memory where 0\.5 GB are free: take fewer\."):
        memory.check_memory([100_000_000], ["f8"], "take fewer")


def test_free_memory_of_this_machine():
    """Less than all of it: this process is in memory."""
    assert 0.0 < memory.free_memory() < psutil.virtual_memory().total


def test_no_memory_is_one_sentence(monkeypatch):
    def fail(*args):
        raise MemoryError("Unable to allocate 745. GiB")

    monkeypatch.setattr("hophoop.maps.grid.axes.parse_axis", fail)
    done = call(*AXES, "--plot", "a.png")
    assert done.exit_code == 2
    assert "There is not enough memory: Unable to allocate 745. GiB." in done.output


def test_a_netcdf_map_that_cannot_be_written_in_the_end_is_not_begun(monkeypatch, tmp_path):
    """A Zarr store is written chunk by chunk, netCDF at the end and all at once."""
    monkeypatch.setattr(memory, "free_memory", lambda: 1e9)
    arguments = ("--axis", "plane.mu=0.5:1:20000", "--axis", "start.speed=1:2:20000", "--quantity", "time", "--quiet")
    refused = call(*arguments, "--out", tmp_path / "map.nc")
    assert refused.exit_code == 2
    assert "400,000,000 motions, which need 6.6 GB of memory where 1.0 GB are free" in refused.stderr
    assert refused.stderr.endswith("name a file that ends in .zarr.\n")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "place"), [("map.zarr", "map.zarr"), ("map.nc", "map.nc.part.zarr")])
def test_what_was_stopped_before_it_began_keeps_nothing(monkeypatch, tmp_path, name, place):
    @wraps(sweeping.sweep)
    def stopped(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(sweeping, "sweep", stopped)
    out = tmp_path / name
    arguments = ("--axis", "plane.mu=0.5:1:2", "--axis", "start.speed=1:2:2", "--out", out, "--quiet")
    assert call(*arguments).stderr == "Stopped.\n"
    (tmp_path / place).mkdir()
    assert call(*arguments).stderr == f"Stopped; what is done is kept in {tmp_path / place}, and --resume goes on.\n"
