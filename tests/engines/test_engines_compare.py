"""The comparison: three engines against the kept table, commands, entry points, failures, the command line."""

import csv
import json
import re
import shutil
import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from typer.testing import CliRunner

import hophoop as hh
from hophoop import engines
from hophoop.animate.words import StateLine, draw_state
from hophoop.cli import app
from hophoop.engines import comparing, figures, registry, tables
from hophoop.engines.external import job_text, run_command
from hophoop.engines.measures import exact_record
from hophoop.engines.recorded import RecordedMotion
from hophoop.engines.worker import Worker
from hophoop.results.poses import poses_of

ROOT = Path(__file__).parents[2]
KEPT = ROOT / "docs" / "tables" / "engines.json"
PAGE = ROOT / "docs" / "engines.md"
SCENARIOS = engines.bench_scenarios()
FAST = ("mujoco", "pymunk", "box2d")
HOP = SCENARIOS["hop"]


def call(*arguments):
    return CliRunner().invoke(app, ["compare", *arguments])


# Three engines, and the table that is kept

# What a number may be off beside the kept one: another version, another processor
RESOLUTION = {
    "takeoff_angle": 1.0, "takeoff_time": 5e-3, "hop_height": 5e-3, "landing_angle": 1.0, "landing_time": 5e-3,
    "energy_drift": 5e-3, "slip_loss": 0.05, "impact_loss": 0.1, "total_loss": 0.1, "penetration": 1e-3, "chatter": 10,
    "angle_error": 1.0, "place_error": 1e-2,
}  # fmt: skip
FACTOR = 2.0


@pytest.fixture(scope="module")
def kept():
    return json.loads(KEPT.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", FAST)
def test_scores_are_within_a_factor_of_the_kept_table(name, kept):
    one = engines.engine(name)
    pytest.importorskip({"box2d": "Box2D"}.get(name, name))
    if one.version.split(".")[0] != kept["engines"][name]["version"].split(".")[0]:
        pytest.skip(f"{one.title} {one.version} is another generation than the kept {kept['engines'][name]['version']}")
    result = engines.compare([one], [SCENARIOS["rolling"], SCENARIOS["slip"], HOP, SCENARIOS["drop"]], [0.001], ladder=False)
    rows = {(r["setting"], r["scenario"]): r for r in kept["rows"] if r["engine"] == name and r["dt"] == 0.001}
    compared = 0
    for row in result.rows:
        assert row.failure == ""
        before = rows[row.setting, row.scenario]["scores"]
        if row.setting != "default":
            continue  # the kept tuned rows are held by test_the_manuals_and_the_tuned below
        for column, resolution in RESOLUTION.items():
            mine, old = row.scores.to_dict()[column], before[column]
            if old in (None, "missing"):
                assert mine == old, (row.scenario, column)
                continue
            assert abs(mine) <= FACTOR * abs(old) + resolution, (row.scenario, column)
            assert abs(mine) >= abs(old) / FACTOR - resolution, (row.scenario, column)
            compared += 1
    assert compared > 30


def test_the_manuals_and_the_tuned():
    """An odd number of sweeps is all that pymunk lacks: see the page."""
    pytest.importorskip("pymunk")
    result = engines.compare([engines.engine("pymunk")], [HOP], [5e-5], ladder=False)
    default, tuned = (abs(row.scores.hop_height) for row in result.rows)
    assert tuned < 6e-3
    assert result.rows[0].measures.penetration > 10 * result.rows[1].measures.penetration
    assert default != tuned


def test_the_kept_table_is_whole(kept):
    assert kept["benchmark"] == "hophoop-bench/1"
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", kept["made"])
    assert set(kept["engines"]) == set(registry.PYTHON_ENGINES) | set(registry.NODE_ENGINES)
    assert {row["scenario"] for row in kept["rows"]} == set(SCENARIOS)
    for one in kept["engines"].values():
        assert one["model"]
        assert one["contact"]
        assert "default" in one["settings"]
    hop = next(r for r in kept["rows"] if (r["engine"], r["scenario"]) == ("hophoop", "hop"))
    assert hop["scores"]["sequence_right"]
    assert abs(hop["scores"]["takeoff_angle"]) < 1e-3


# What fails is a row


def test_an_engine_that_is_not_installed_is_a_row():
    missing = engines.Engine(name="absent", title="Absent", run=_absent)
    rows = _compared(missing)
    assert "no such engine" in rows[0].failure
    assert rows[0].scores is None


def _absent(task, dt):
    raise ImportError("no such engine")


def _compared(one, dt=0.01):
    """In this process: a worker knows engines by name only."""
    worker = SimpleNamespace(run=lambda task, dt, settings, limit: _here(one, task, dt, settings))
    row, _ = comparing._run(worker, comparing.Job(one, "default", HOP, dt), engines.truths()["hop"], 1.0)
    return [row]


def _here(one, task, dt, settings):
    try:
        return engines.Recording(engines.States(*one.run(task, dt, **settings)))
    except ImportError as error:
        raise RuntimeError(str(error)) from error


def test_nan_and_a_short_record_are_rows():
    def nan(task, dt):
        states = exact_record(HOP)
        return states._replace(x=states.x * np.nan)

    def short(task, dt):
        return engines.States(*(column[:100] for column in exact_record(HOP)))

    assert "x must be finite" in _compared(engines.Engine("a", "A", nan))[0].failure
    assert "the record ends at" in _compared(engines.Engine("b", "B", short))[0].failure


def test_a_crash_and_a_hang_are_sentences(monkeypatch, tmp_path):
    (tmp_path / "crashing.py").write_text("import os\ndef run(task, dt):\n    os._exit(3)\n")
    (tmp_path / "hanging.py").write_text("import time\ndef run(task, dt):\n    time.sleep(60)\n")
    info = tmp_path / "three-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: three\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text("[hophoop.engines]\ncrashing = crashing\nhanging = hanging\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:{Path(comparing.__file__).parents[2]}")
    found = engines.engines()
    assert {"crashing", "hanging"} <= set(found)
    task = engines.task_of(HOP)
    for name, limit, sentence in (("crashing", 60.0, "its process crashed"), ("hanging", 0.5, "more than 0.5 s")):
        worker = Worker(found[name])
        with pytest.raises(RuntimeError, match=sentence):
            worker.run(task, 0.01, {}, limit)
        worker.close()


def test_names_that_are_none():
    with pytest.raises(ValueError, match=r"engine = 'physx' is not one of hophoop, "):
        engines.engine("physx")
    with pytest.raises(ValueError, match="must be NAME=COMMAND"):
        engines.command_engine("no command")
    with pytest.raises(ValueError, match="has no run"):
        registry.engine_of("odd", SimpleNamespace())


# The page says how to add an engine: what stands there is run here


def included(name):
    """The code of an example that the page shows."""
    assert f"{{literalinclude}} ../examples/engines/{name}" in PAGE.read_text(encoding="utf-8")
    return (ROOT / "examples" / "engines" / name).read_text(encoding="utf-8")


def test_the_adapter_of_the_page_runs():
    code = included("penalty.py")
    assert len(code.splitlines()) <= 60
    space = {}
    exec(code, space)
    one = registry.engine_of("mine", SimpleNamespace(**space))
    assert len(one.settings) == 2
    for settings in one.settings.values():
        for dt in (1e-3, 1e-4):
            record = one.run(engines.task_of(HOP), dt, **settings)
            found, measures = engines.score(engines.Recording(engines.States(*record)), engines.truths()["hop"])
            # a penalty method of a dozen lines: it hops, a little off, with either settings
            assert "H" in measures.sequence
            assert abs(found.hop_height) < 0.02
            assert abs(found.total_loss) < 1.0
    assert measures.sequence == "RKRSHR"
    assert abs(found.hop_height) < 0.001


def test_the_command_of_the_page_runs(tmp_path):
    code = included("rolling.py")
    assert len(code.splitlines()) <= 60
    script = tmp_path / "mine.py"
    script.write_text(code, encoding="utf-8")
    result = call("--command", f"mine={sys.executable} {script}", "--scenario", "rolling", "--dt", "0.0001", "--json")
    assert result.exit_code == 0, result.output
    row = json.loads(result.stdout)["rows"][0]
    assert row["engine"] == "mine"
    assert row["scores"]["sequence_right"]
    assert row["scores"]["angle_error"] < 2.0


def test_the_figure_of_the_page_shows_the_hops_of_the_table(kept):
    """A panel for each engine, with its errors at 1 ms."""
    words = re.findall(r"<!-- (.+) -->", (ROOT / "docs" / "figures" / "engines-hops.svg").read_text(encoding="utf-8"))
    titles = [one["title"] for one in kept["engines"].values()]
    assert [word for word in words if word in titles] == titles
    for name, one in kept["engines"].items():
        errors = {
            row["setting"]: row["scores"]["hop_height"]
            for row in kept["rows"]
            if (row["engine"], row["scenario"], row["dt"]) == (name, "hop", 0.001)
        }
        shown = [errors["default"]] + [error for error in list(errors.values())[1:] if abs(error) < abs(errors["default"])]
        drawn = [f"{1e3 * error:+.1f} mm".replace("-", "−") if abs(error) >= 5e-5 else "exact" for error in shown]
        place = words.index(one["title"])
        assert drawn == words[place - len(drawn) : place]


def test_a_drawing_is_the_same_each_time_and_short():
    figure = pytest.importorskip("matplotlib.figure").Figure()
    figure.subplots().plot(np.linspace(0.0, 1.0, 50), np.sqrt(np.arange(50.0)), "o-")
    drawn = figures.drawing(figure)
    assert drawn == figures.drawing(figure)
    line = max(re.findall(r' d="([ML\d\s.z-]+)"', drawn), key=len)
    assert line.count("L") == 49
    assert not re.search(r"\.\d\d", line)
    assert re.search(r"C -?\d+\.\d{4}", drawn)  # a mark keeps its shape


def test_the_table_of_the_page_is_the_kept_one(kept):
    table = (ROOT / "docs" / "tables" / "engines.md").read_text(encoding="utf-8")
    assert f"made {kept['made']}" in table
    assert "{include} tables/engines.md" in PAGE.read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines() if line.startswith("|")]
    head, name, listed = rows[0], "", {}
    for row in rows[2:]:
        name = row[0] or name
        listed[name, row[1].replace("\u00a0", " ")] = row
    for row in kept["rows"]:
        if row["scenario"] != "hop" or row["dt"] != 0.001 or "scores" not in row:
            continue
        one, height = kept["engines"][row["engine"]], row["scores"]["hop_height"]
        titles = (one["title"], f"{one['title']} {one['version']}", f"Box2D {one['version']}")
        line = next(
            listed[title, f"{row['setting']}, 1 ms"] for title in titles if (title, f"{row['setting']}, 1 ms") in listed
        )
        written = line[head.index("hop (mm)")]
        if height == "missing":
            assert written == "none"
        else:
            assert float(written.replace("−", "-").replace(",", "")) == pytest.approx(1e3 * height, rel=0.06, abs=1e-3)


# Commands


def echo(tmp_path, body):
    script = tmp_path / "engine.py"
    script.write_text(body, encoding="utf-8")
    return [sys.executable, str(script)]


def test_what_a_command_reads(tmp_path):
    task = engines.task_of(SCENARIOS["slope"])
    job = json.loads(job_text(task, 0.0001, {"sweeps": 4}))
    assert job["every"] == 4
    assert job["settings"] == {"sweeps": 4}
    assert job["gravity_along"] == task.pull[0]
    assert job["gravity_center"]["turn"] == -task.angle


def test_a_command_that_fails_says_why(tmp_path):
    task = engines.task_of(HOP)
    with pytest.raises(RuntimeError, match="ended with status 1: ValueError: too stiff"):
        run_command(echo(tmp_path, "raise ValueError('too stiff')"), task, 0.01)
    with pytest.raises(RuntimeError, match="is not installed"):
        run_command(["no-such-program-anywhere"], task, 0.01)
    with pytest.raises(RuntimeError, match="more than"):
        run_command(echo(tmp_path, "import time; time.sleep(30)"), task, 0.01, limit=0.5)
    with pytest.raises(ValueError, match="must start with the header"):
        run_command(echo(tmp_path, "print('hello')"), task, 0.01)


@pytest.mark.skipif(find_spec("warp") is not None, reason="Newton is installed")
def test_an_engine_that_is_not_installed_says_what_to_install(tmp_path):
    result = call("newton", "--scenario", "rolling", "--dt", "0.001", "--out", str(tmp_path / "out"))
    assert 'pip install "hophoop[engines]"' in result.output
    assert 'pip install "hophoop"' not in result.output  # the table took [engines] for markup


def test_without_an_engine_nothing_is_computed(monkeypatch, tmp_path):
    """SciPy is no physics engine: it comes with other extras too."""
    there = ("python", "hophoop", "scipy")
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("HOPHOOP_NPM", raising=False)
    monkeypatch.setattr(registry, "_version", lambda package: "1.0" if package in there else "")
    monkeypatch.setattr(registry, "entry_points", lambda group: ())
    started = []
    monkeypatch.setattr(comparing, "compare", lambda *arguments: started.append(arguments))
    result = call()
    assert (result.exit_code, result.stdout, started) == (1, "", [])
    assert result.stderr == 'No engine is installed: pip install "hophoop[engines]".\n'
    there += ("pymunk",)
    assert [one.name for one in registry.physics_engines()] == ["pymunk"]


def test_engines_of_npm_are_looked_for_where_node_looks(monkeypatch, tmp_path):
    (tmp_path / "node_modules" / "planck").mkdir(parents=True)
    (tmp_path / "below").mkdir()
    monkeypatch.setenv("HOPHOOP_NPM", str(tmp_path / "below"))
    monkeypatch.setattr(shutil, "which", lambda program: "/bin/node")
    assert [name for name in registry.NODE_ENGINES if engines.engine(name).installed] == ["planck"]
    with pytest.raises(RuntimeError, match="matter-js is not in the folder of --npm: npm install --prefix FOLDER"):
        Worker(engines.engine("matter")).run(engines.task_of(HOP), 0.01, {}, 1.0)
    monkeypatch.setattr(shutil, "which", lambda program: None)
    assert not engines.engine("planck").installed


@pytest.mark.parametrize("name", registry.NODE_ENGINES)
def test_engines_of_npm(name, monkeypatch):
    folder = ROOT / "benchmarks" / "engines"
    if not (shutil.which("node") and (folder / "node_modules").is_dir()):
        pytest.skip("needs Node, and npm install --prefix benchmarks/engines")
    monkeypatch.setenv("HOPHOOP_NPM", str(folder))
    one = engines.engine(name)
    record = run_command(one.command, engines.task_of(SCENARIOS["drop"]), 0.001, {}, folder)
    assert record.notes["version"][0].isdigit()
    found, _ = engines.score(record, engines.truths()["drop"])
    assert found.landing_time == pytest.approx(0.0, abs=5e-3)


# The command line


def test_scoring_a_file(tmp_path):
    file = tmp_path / "hop.csv"
    file.write_text(engines.to_csv(engines.Recording(exact_record(HOP), notes={"scenario": "hop"})), encoding="utf-8")
    result = call("--score", str(file))
    assert result.exit_code == 0, result.output
    assert "hop: RKRSHR (right)" in result.stdout
    found = json.loads(call("--score", str(file), "--json").stdout)
    assert found["scores"]["sequence_right"] is True
    wrong = call("--score", str(file), "--scenario", "slip")
    assert wrong.exit_code == 2
    assert "the record starts with vx = 3.1, the motion 'slip' with 2.8" in wrong.output
    both = call("--score", str(file), "pymunk")
    assert both.exit_code == 2
    assert "--score cannot be given together with" in both.output


def test_a_row_doctored_by_hand_is_no_longer_right(tmp_path):
    lines = engines.to_csv(engines.Recording(exact_record(HOP))).splitlines()
    rows = list(csv.reader(lines[1:]))
    for row in rows:
        if 1.2 < float(row[0]) < 1.7:  # kept down by hand
            row[2], row[5] = "0.0", "0.0"
    file = tmp_path / "doctored.csv"
    file.write_text("\n".join([lines[0], *(",".join(row) for row in rows)]) + "\n", encoding="utf-8")
    result = call("--score", str(file), "--scenario", "hop")
    assert "should be RKRSHR" in result.stdout or "-" in result.stdout.replace("−", "-")
    assert json.loads(call("--score", str(file), "--scenario", "hop", "--json").stdout)["scores"]["place_error"] > 0.2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["physx"], "engine = 'physx' is not one of"),
        (["hophoop", "--scenario", "jump"], "scenario = 'jump' is not one of"),
        (["hophoop", "--dt", "0"], "--dt = 0.0 must be above 0"),
        (["hophoop", "--npm", "/no/such/folder"], "must be an existing folder"),
        (["--command", "mine"], "must be NAME=COMMAND"),
    ],
)
def test_bad_input(arguments, message):
    result = call(*arguments)
    assert result.exit_code == 2
    assert message in result.output


@pytest.mark.long
def test_a_report(tmp_path):
    pytest.importorskip("matplotlib")
    result = call("hophoop", "--scenario", "hop", "--out", str(tmp_path / "out"), "--no-film", "--quiet")
    assert result.exit_code == 0, result.output
    page = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    assert "by the authors of this benchmark" in page
    assert "hophoop (ours)" in page
    assert page.count("data:image/svg+xml") == 2
    document = json.loads((tmp_path / "out" / "scores.json").read_text(encoding="utf-8"))
    assert document["declaration"]
    assert document["rows"][0]["scores"]["sequence_right"] is True


def test_a_record_can_be_filmed():
    """The film's poses of a record are those of the exact motion that it samples."""
    record = RecordedMotion(HOP.scenario, engines.task_of(HOP), exact_record(HOP))
    times = np.array([0.1, 0.4, 0.9, 1.4, 1.9])
    mine, right = poses_of(record, times), poses_of(hh.simulate(HOP.scenario), times)
    assert mine.mode.tolist() == right.mode.tolist() == ["R", "K", "S", "H", "R"]
    np.testing.assert_allclose(mine.load, right.load, atol=1e-4)
    np.testing.assert_allclose(mine.normal_force[:3], right.normal_force[:3], rtol=0.02, atol=0.05)


def test_words_of_a_narrow_view_stay_in_it():
    drawn = []
    canvas = SimpleNamespace(
        unit=1.0,
        disc=lambda *_: None,
        text=lambda x, y, words, *_, **__: drawn.append(words),
        text_width=lambda words, size, *_: 0.6 * size * len(words),
    )
    line = StateLine("roll", t=0.5, angle=0.3, extra="v = 1.00 m/s")
    for room, count in ((1000.0, 4), (400.0, 2), (288.0, 1)):
        drawn.clear()
        draw_state(canvas, SimpleNamespace(ink="#000000"), (0.0, 0.0), line, room)
        assert len(drawn) == count


def test_settings_are_printed_in_full():
    for one in engines.engines().values():
        words = tables.settings_words(one)
        for values in one.settings.values():
            assert all(f"{key} = {value}" in words for key, value in values.items())
