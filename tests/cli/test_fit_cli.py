"""`hophoop fit` and `hophoop plan`, as a person or a script calls them."""

import json
from functools import wraps

import numpy as np
import pytest
from typer.testing import CliRunner

import hophoop as hh
from hophoop.cli import app
from hophoop.cli.lab import rounded
from hophoop.tracking.table import track_of

pytestmark = pytest.mark.compiled


def call(*arguments):
    return CliRunner().invoke(app, [str(part) for part in arguments])


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    motion = hh.simulate(hh.Hoop.ideal(0.6, radius=0.3), hh.Plane(mu=0.8), hh.Start.rolling(1.5, angle=0.2), duration=0.4)
    t, rng = np.arange(48) / 120, np.random.default_rng(1)
    state = motion.at(t)
    columns = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    columns = {name: values + rng.normal(0, 1e-3, 48) for name, values in columns.items()}
    columns |= {f"sigma_{name}": np.full(48, 1e-3) for name in columns}
    track = track_of(t, columns, radius=0.3, placed=True)
    path = tmp_path_factory.mktemp("track") / "track.csv"
    track.save(path)
    return path


def test_a_table_for_people_and_a_page(table, tmp_path):
    done = call("fit", table, "--radius", 0.3, "--out", tmp_path / "fit", "--save", tmp_path / "fit.json", "--quiet")
    assert done.exit_code == 0, done.output
    assert "gamma" in done.stdout
    assert "The hoop never slips" in done.stdout
    assert {path.name for path in (tmp_path / "fit").iterdir()} == {"index.html", "fit.json", "scenario.toml"}
    assert hh.load_fit(tmp_path / "fit.json").values["gamma"] == pytest.approx(0.6, abs=0.02)


def test_json_for_scripts(table):
    done = call("fit", table, "--radius", 0.3, "--json", "--fix", "restitution=0.2", "--bound", "gamma=0.5:0.7", "--squares")
    assert done.exit_code == 0, done.output
    answer = json.loads(done.stdout)
    assert answer["values"]["restitution"] == 0.2
    assert answer["errors"]["gamma"] > 0
    assert "track" not in answer


def test_a_chain_on_request(table):
    done = call(
        "fit", table, "--radius", 0.3, "--fix", "restitution=0.2", "--fix", "mu_excess=0", "--sample", 20, "--quiet", "--json"
    )
    assert done.exit_code == 0, done.output
    posterior = json.loads(done.stdout)["posterior"]
    assert posterior["steps"] == 20
    assert sum(posterior["shares"].values()) == pytest.approx(1.0)


def test_a_chain_that_is_stopped_says_no_more_than_that(table, monkeypatch):
    """emcee printed the traceback of each exception."""
    from hophoop.fitting import sampling

    calls, loss = iter(range(200)), sampling.loss

    def stops(residuals, robust):
        if next(calls, None) is None:
            raise KeyboardInterrupt
        return loss(residuals, robust)

    monkeypatch.setattr(sampling, "loss", stops)
    done = call("fit", table, "--radius", 0.3, "--fix", "restitution=0.2", "--fix", "mu_excess=0", "--sample", 50, "--quiet")
    assert (done.exit_code, done.output) == (130, "Stopped.\n")


def test_the_lab_opens_a_fit(table, tmp_path, monkeypatch):
    pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")
    from hophoop.lab.server import app as server

    opened = []
    monkeypatch.setattr(server, "serve", wraps(server.serve)(lambda **given: opened.append(given)))
    file = tmp_path / "fit.json"
    done = call("fit", table, "--radius", 0.3, "--save", file, "--lab", "--quiet")
    assert done.exit_code == 0, done.output
    assert call("lab", file, "--no-browser", "--port", 0).exit_code == 0
    wanted = rounded(hh.load_fit(file)).scenario.to_query()
    assert [given["query"] for given in opened] == [wanted, wanted]
    assert [given["backdrop"] for given in opened] == [None, None]  # no film
    # the data are a table, not a film
    done = call("lab", file, "--film", file)
    assert done.exit_code == 2
    assert "not to a track of a film" in " ".join(done.output.split())
    hh.Scenario().save(tmp_path / "hop.toml")
    done = call("lab", tmp_path / "hop.toml", "--film", file)
    assert done.exit_code == 2
    assert "--film needs a fit" in done.output
    assert len(opened) == 2


def test_the_lab_shows_values_to_their_error_and_a_slope_within_its_error_as_level(table, tmp_path):
    file = tmp_path / "fit.json"
    assert call("fit", table, "--radius", 0.3, "--free", "slope", "--save", file, "--quiet").exit_code == 0
    found = hh.load_fit(file)
    assert 0 < abs(found.values["slope"]) <= found.error("slope")
    shown = rounded(found)
    assert shown.values["slope"] == 0.0
    gamma = shown.values["gamma"]
    assert len(repr(gamma)) <= 7
    assert abs(gamma - found.values["gamma"]) < 0.2 * found.error("gamma")
    assert shown.scenario.hoop.load_fraction == gamma
    assert shown.scenario.plane.slope == 0.0


def test_no_good_fit_is_status_1(table):
    done = call("fit", table, "--radius", 0.3, "--sigma", 1e-4, "--fix", "gamma=0.2")
    assert done.exit_code == 1
    assert "Wrong: no motion fits" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--fix", "restitution"], "--fix = 'restitution' must be a name and a value"),
        (["--fix", "restitution=much"], "--fix restitution = 'much' must be a number"),
        (["--bound", "gamma=1"], "--bound gamma = '1' must be two numbers"),
        (["--free", "t0"], "t0 is no parameter of a fit: the time of the start is redundant with its position"),
        (["--sample", "3"], "steps = 3 must be from 10"),
        (["--film", "film.mp4"], "--film needs --out"),
        (["--save", "fit.txt"], "--save = fit.txt must end in .json"),
        (["--hoop", "absent.toml"], "absent.toml"),
        (["--angle-unit", "turn"], "--angle-unit = 'turn'"),
        (["--column", "x"], "--column = 'x' must be a name and a value"),
        (["--column", "speed=x [m]"], "--column cannot name 'speed'; it can name frame, t, x, y"),
        (["--column", "x=across"], "has no column 'across': its columns are t [s], x [m], "),
        (["--rate", "-1"], "--rate = -1.0 must be a number above 0"),
        (["--from", "2"], "has times from 0 to 0.391667 s, of which 0 are in the window"),
    ],
)
def test_bad_input_is_one_sentence(table, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    done = call("fit", table, "--radius", 0.3, *arguments)
    assert done.exit_code == 2
    assert message in " ".join(done.output.split())


def test_a_file_without_radius_is_asked_for_it(table):
    done = call("fit", table)
    assert done.exit_code == 2
    assert "The radius of the hoop is missing" in done.output


def test_a_window_of_a_table_whose_columns_are_named(table, tmp_path):
    lines = table.read_text(encoding="utf-8").splitlines()
    head = lines[0].replace("t [s]", "clock [s]").replace(",x [m],", ",across [m],")
    held = [f"{t:.6f},0,0.3,0.2,0.001,0.001,0.001,found" for t in np.arange(-24, 0) / 120]
    file = tmp_path / "video.csv"
    file.write_text("\n".join([head, *held, *lines[1:]]), encoding="utf-8")
    options = ["--radius", 0.3, "--quiet", "--json", "--column", "t=clock [s]", "--column", "x=across [m]", "--from", -1e-9]
    done = call("fit", file, *options)
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["values"]["gamma"] == pytest.approx(0.6, abs=0.02)


def test_a_plan(tmp_path):
    options = ["plan", "--gamma", 0.6, "--radius", 0.3, "--v0", 1.9, "--mu-static", 0.55, "--mu-kinetic", 0.45, "--duration", 1]
    done = call(*options)
    assert done.exit_code == 0, done.output
    assert "mu_excess" in done.stdout
    answers = [call(*options, "--json"), call(*options, "--json", "--no-marker", "--fix", "restitution")]
    assert [done.exit_code for done in answers] == [0, 0], [done.output for done in answers]
    better, worse = (json.loads(done.stdout) for done in answers)
    assert worse["errors"]["gamma"] > better["errors"]["gamma"]
    done = call(*options, "--rate", -1)
    assert done.exit_code == 2
    assert "--rate = -1.0 must be a number above 0" in done.output


@pytest.mark.parametrize(("arguments", "shown"), [((), True), (("--quiet",), False), (("--json",), False)])
def test_a_terminal_shows_that_the_fit_goes_on(table, monkeypatch, arguments, shown):
    from rich.console import Console

    monkeypatch.setattr(Console, "is_terminal", property(lambda console: True))
    done = call("fit", table, "--radius", 0.3, "--fix", "restitution=0.2", *arguments)
    assert done.exit_code == 0, done.output
    assert ("fitting" in done.stderr) == shown
    assert "fitting" not in done.stdout
