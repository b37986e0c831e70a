"""`hophoop fit` and `hophoop plan`, as a person or a script calls them."""

import json
from functools import wraps

import numpy as np
import pytest
from rich.console import Console

import hophoop as hh
from cli_tools import done, save_track
from hophoop.cli.lab import rounded

FIT = "fit --radius 0.3"
KNOWN = f"{FIT} --fix restitution=0.2 --fix mu_excess=0"


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    return save_track(tmp_path_factory.mktemp("track") / "track.csv")


def test_a_table_for_people_and_a_page(table, tmp_path):
    said = done(f"{FIT} --quiet", table, "--out", tmp_path / "fit", "--save", tmp_path / "fit.json").stdout
    assert said.startswith("The motion explains the data.\n")  # before 16 rows of parameters
    assert said.index("The hoop never slips") < said.index("gamma  ") < said.index("Details")
    assert {path.name for path in (tmp_path / "fit").iterdir()} == {"index.html", "fit.json", "scenario.toml"}
    assert hh.load_fit(tmp_path / "fit.json").values["gamma"] == pytest.approx(0.6, abs=0.02)


def test_json_for_scripts(table):
    answer = json.loads(done(f"{KNOWN} --json --quiet --bound gamma=0.5:0.7 --squares", table).stdout)
    assert answer["values"]["restitution"] == 0.2
    assert answer["errors"]["gamma"] > 0
    assert "track" not in answer


def test_the_lab_opens_a_fit_with_values_to_their_error_and_a_slope_within_its_error_as_level(table, tmp_path, monkeypatch):
    from hophoop.lab import server

    opened = []
    monkeypatch.setattr(server, "serve", wraps(server.serve)(lambda **given: opened.append(given)))
    file = tmp_path / "fit.json"
    done(f"{FIT} --free slope --lab --quiet", table, "--save", file)
    done("lab --no-browser --port 0", file)
    found = hh.load_fit(file)
    shown = rounded(found)
    assert [given["query"] for given in opened] == 2 * [shown.scenario.to_query()]
    assert [given["backdrop"] for given in opened] == [None, None]  # no film
    assert 0 < abs(found.values["slope"]) <= found.error("slope")
    assert shown.scenario.plane.slope == 0.0
    gamma = shown.scenario.hoop.load_fraction
    assert len(repr(gamma)) <= 7
    assert abs(gamma - found.values["gamma"]) < 0.2 * found.error("gamma")
    # the data are a table, not a film
    refused = done("lab", file, "--film", file, status=2)
    assert "not to a track of a film" in " ".join(refused.output.split())
    assert len(opened) == 2


def test_no_good_fit_is_status_1(table):
    assert "Wrong: no motion fits" in done(f"{FIT} --sigma 1e-4 --fix gamma=0.2", table, status=1).stdout


def test_a_window_of_a_table_whose_columns_are_named(table, tmp_path):
    lines = table.read_text(encoding="utf-8").splitlines()
    head = lines[0].replace("t [s]", "clock [s]").replace(",x [m],", ",across [m],")
    held = [f"{t:.6f},0,0.3,0.2,0.001,0.001,0.001,found" for t in np.arange(-24, 0) / 120]
    file = tmp_path / "video.csv"
    file.write_text("\n".join([head, *held, *lines[1:]]), encoding="utf-8")
    answer = json.loads(done(f"{FIT} --quiet --json --column 't=clock [s]' --column 'x=across [m]' --from -1e-9", file).stdout)
    assert answer["values"]["gamma"] == pytest.approx(0.6, abs=0.02)


def test_a_plan():
    line = "plan --gamma 0.6 --radius 0.3 --v0 1.9 --mu-static 0.55 --mu-kinetic 0.45 --duration 1 --rate 60"
    assert "mu_excess" in done(line).stdout
    better, worse = (json.loads(done(f"{line} --json {more}").stdout) for more in ("", "--no-marker --fix restitution"))
    assert worse["errors"]["gamma"] > better["errors"]["gamma"]


@pytest.mark.long
def test_a_terminal_shows_that_the_fit_goes_on(table, monkeypatch):
    monkeypatch.setattr(Console, "is_terminal", property(lambda console: True))
    for more in ("", "--quiet", "--json"):
        found = done(f"{KNOWN} {more}", table)
        assert ("fitting" in found.stderr) == (not more)
        assert "fitting" not in found.stdout
