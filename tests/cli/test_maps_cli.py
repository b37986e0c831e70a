"""`hophoop map`, as a person or a script calls it."""

import re
from functools import wraps
from types import SimpleNamespace

import numpy as np
import psutil
import pytest

import hophoop as hh
from cli_tools import done, run
from hophoop import maps
from hophoop.maps.grid import sweeping

MAP = "map --axis plane.mu=0.2:1.8:9 --axis start.speed=0.1,2,3.1,5"
LARGE = "map --axis plane.mu=0.5:1:20000 --axis start.speed=1:2:20000 --quantity time --quiet"


def test_a_map_into_a_file_and_a_picture(tmp_path):
    out, picture, line = tmp_path / "map.zarr", tmp_path / "map.png", f"{MAP} --quantity sequence --quantity hop_height"
    assert done(line, "--out", out, "--plot", picture).output == f"36 motions in {out}\n"  # without a terminal no more
    axes = {"plane.mu": np.linspace(0.2, 1.8, 9), "start.speed": [0.1, 2.0, 3.1, 5.0]}
    assert maps.open_map(out).load().identical(maps.sweep(None, axes, ["sequence", "hop_height"]))
    assert picture.read_bytes().startswith(b"\x89PNG")
    done(f"{line} --resume --quiet", "--out", out)


def test_what_becomes_of_motions_of_a_scenario(tmp_path):
    file, out, picture = tmp_path / "hop.toml", tmp_path / "map.nc", tmp_path / "map.svg"
    hh.Scenario(hoop=hh.Hoop(mass=2.0)).save(file)
    done(f"{MAP} --quantity fate --quantity mean_speed --span settled --quiet", file, "--out", out, "--plot", picture)
    dataset = maps.open_map(out).load()
    assert '"mass": 2.0' in dataset.attrs["scenario"]
    assert dataset.attrs["span"] == "settled"
    words = maps.words_of(dataset["fate"])
    found = dataset["fate"].sel({"plane.mu": 1.0, "start.speed": [0.1, 3.1, 5.0]}).values
    assert [words[k] for k in found] == ["rolls_ahead", "slips_ever_less", "rocks"]
    assert "rolls ahead" in picture.read_text(encoding="utf-8")


def test_the_help_lists_the_quantities():
    text = done("map --help").output
    for name, quantity in maps.QUANTITIES.items():
        assert re.search(rf"^  {name} +{re.escape(quantity.meaning)}", text, re.MULTILINE), name


def test_a_netcdf_map_that_cannot_be_written_in_the_end_is_not_begun(monkeypatch, tmp_path):
    """A Zarr store is written chunk by chunk, netCDF at the end and all at once."""
    monkeypatch.setattr(psutil, "virtual_memory", lambda: SimpleNamespace(total=64e9, available=1e9, free=1e8))
    refused = done(LARGE, "--out", tmp_path / "map.nc", status=2)
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
    assert run(MAP, "--out", out).stderr == "Stopped.\n"
    (tmp_path / place).mkdir()
    assert run(MAP, "--out", out).stderr == f"Stopped; what is done is kept in {tmp_path / place}, and --resume goes on.\n"
