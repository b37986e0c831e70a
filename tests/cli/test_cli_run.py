"""`hophoop run` and `hophoop theory`: what they print and write, and their exit status."""

import csv
import json
import math
import os
import re
import subprocess
import sys
import time

import pytest

import hophoop as hh
from cli_tools import HOP, hop, run


@pytest.fixture
def scenario(tmp_path):
    path = tmp_path / "hop.toml"
    path.write_text("duration = 2.0\n[start]\nspeed = 3.1\n", encoding="utf-8")
    return path


# JSON to the letter

EVENT_KEYS = ["t", "kind", "from", "to", "x", "height", "angle", "vx", "vy", "omega", "before", "impulse"]


def test_json_is_the_result_and_nothing_else():
    done = run("run", *HOP, "--json")
    assert done.exit_code == 0
    data = json.loads(done.stdout)
    assert data == hop().to_dict()
    assert list(data) == ["schema", "version", "scenario", "status", "sequence", "fingerprint", "events", "final", "energy"]
    assert data["schema"] == "hophoop/1"
    assert data["version"] == hh.__version__
    assert (data["status"], data["sequence"]) == ("completed", "RKRSHR")
    assert all(list(event)[: len(EVENT_KEYS)] == EVENT_KEYS for event in data["events"])
    impact = next(event for event in data["events"] if event["kind"] == "impact")
    assert list(impact["before"]) == ["vx", "vy", "omega"]
    assert list(impact["impulse"]) == ["normal", "tangential"]
    assert (impact["from"], impact["to"]) == ("H", "R")
    assert list(data["final"]) == ["t", "mode", "x", "height", "angle", "vx", "vy", "omega"]
    assert list(data["energy"]) == [
        "kinetic", "potential", "friction", "impact_normal", "impact_tangential", "rolling_resistance", "residual",
    ]  # fmt: skip


def test_numbers_keep_every_bit():
    events = json.loads(run("run", *HOP, "--json").stdout)["events"]
    assert [event["t"] for event in events] == [event.t for event in hop().events]
    assert [event["angle"] for event in events] == [event.angle for event in hop().events]


def test_the_same_json_into_a_file_leaves_the_table(tmp_path):
    path = tmp_path / "result.json"
    done = run("run", *HOP, "--out", path)
    assert done.exit_code == 0
    assert json.loads(path.read_text(encoding="utf-8")) == hop().to_dict()
    assert "takeoff" in done.stdout
    assert "RKRSHR" in done.stdout


def test_json_never_writes_over_the_scenario(scenario):
    before = scenario.read_text(encoding="utf-8")
    assert json.loads(run("run", "--json", scenario).stdout)["sequence"] == "RKRSHR"
    refused = run("run", scenario, "--out", scenario)
    assert refused.exit_code == 2
    assert "is the scenario itself" in refused.stderr
    assert scenario.read_text(encoding="utf-8") == before


def test_scenario_from_standard_input():
    done = run("run", "-", "--json", text='{"hoop": {"load_fraction": 0.5}, "duration": 1.0}')
    assert json.loads(done.stdout)["scenario"]["hoop"]["load_fraction"] == 0.5


# Options


def of(*arguments):
    return json.loads(run("run", *arguments, "--json").stdout)["scenario"]


def test_options_change_a_file(scenario):
    data = of(scenario, "--mu", "0.4", "--v0", "1", "--radius", "0.5")
    assert (data["plane"]["mu"], data["start"]["speed"], data["hoop"]["radius"]) == (0.4, 1.0, 0.5)
    assert data["duration"] == 2.0


def test_two_frictions_at_once():
    # each alone would contradict the other's default
    data = of("--mu-kinetic", "0.3", "--mu-static", "0.5", "--duration", "0.1")
    assert (data["plane"]["mu_static"], data["plane"]["mu_kinetic"]) == (0.5, 0.3)


@pytest.mark.parametrize("order", [1, -1])
def test_the_massless_hoop_by_its_numbers(order):
    pairs = [("--eccentricity", "1"), ("--inertia-ratio", "0")][::order]
    data = of(*(word for pair in pairs for word in pair), "--duration", "0.1")
    assert (data["hoop"]["eccentricity"], data["hoop"]["inertia_ratio"]) == (1.0, 0.0)


def test_free_start_and_degrees():
    data = of("--angle-deg", "90", "--omega", "-2", "--vx", "1", "--height", "0.1", "--slope-deg", "5")
    assert data["start"]["angle"] == math.pi / 2
    assert (data["start"]["omega"], data["start"]["vx"], data["start"]["height"]) == (-2.0, 1.0, 0.1)
    assert data["plane"]["slope"] == math.radians(5.0)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--gamma", "0.5", "--eccentricity", "0.2"), "--gamma cannot be given together with --eccentricity."),
        (("--v0", "1", "--vx", "2"), "--v0 cannot be given together with --vx."),
        (("--mu", "1", "--mu-static", "2"), "--mu cannot be given together with --mu-static."),
        (("--mu", "1", "--set", "plane.mu=0.5"), "--set plane.mu cannot be given together with --mu."),
        (("--v0", "1", "--set", "start.omega=2"), "--v0 cannot be given together with --set start.omega."),
        (("--vx", "2"), "--vx cannot be given without --omega: the start is a rolling one (start.speed = 3.1 m/s)"),
        (("--omega", "2"), "--omega cannot be given without --vx"),
        (("--height", "0.2"), "--height cannot be given without --vx and --omega"),
    ],
)
def test_contradictions_that_a_file_refuses_are_refused(words, said):
    done = run("run", *words, "--duration", "0.1")
    assert done.exit_code == 2
    assert said in " ".join(done.stderr.split())


def test_a_free_start_is_changed_one_number_at_a_time(tmp_path):
    path = tmp_path / "thrown.toml"
    path.write_text("[start]\nvx = 1.0\nheight = 0.1\n", encoding="utf-8")
    start = of(path, "--vx", "2", "--duration", "0.1")["start"]
    assert (start["vx"], start["height"], start["omega"]) == (2.0, 0.1, 0.0)


MAP = ("map", "--axis", "start.speed=1:2:2", "--axis")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("run", "--digits", "5"), "--digits = 5 must be"),
        (("run", "--sensitivity", "foo", "--wrt", "plane.mu"), "--sensitivity = 'foo' is no quantity"),
        (("run", "--radius", "-1"), "hoop.radius = -1.0 must be"),  # a scenario's parameters are told by their paths
        (("prove", "--until", "never"), "--until = 'never' must be"),
        ((*MAP, "plane.mu=1:2:0", "--out", "a.zarr"), "--axis plane.mu=1:2:0: count = 0 must be"),
        ((*MAP, "plane.mu=1:2:2", "--out", "a.csv"), "--out = 'a.csv' must end in"),
        (("map", "--axis", "plane.mu=1:2:2", "--out", "a.zarr"), "--axis = ['plane.mu'] must name"),
        (("lab", "--port", "99999999"), "--port = 99999999 must be"),
        (("track", "no.mp4", "--radius", "-1"), "--radius = -1.0 must be"),
        (("plan", "--rate", "0"), "--rate = 0.0 must be"),
    ],
)
def test_a_refusal_names_the_option(words, said):
    if words[0] == "lab":
        pytest.importorskip("uvicorn")
    done = run(*words)
    assert done.exit_code == 2
    assert done.stderr.lstrip("\n").startswith(f"Error: {said}")  # Rich 13.0 leaves the line of its bar


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        (["hophoop", "th"], "theory"),
        (["hophoop", "run", "--mu-s"], "--mu-static"),
        (["hophoop", "map", "--quantity", "hop_h"], "hop_height"),
    ],
)
def test_a_shell_completes_commands_options_and_values(typed, offered):
    code = "from hophoop.cli import app; app(prog_name='hophoop')"
    wanted = {"_HOPHOOP_COMPLETE": "complete_bash", "COMP_WORDS": " ".join(typed), "COMP_CWORD": str(len(typed) - 1)}
    done = subprocess.run([sys.executable, "-c", code], env=os.environ | wanted, capture_output=True, text=True, check=False)
    assert offered in done.stdout.split()


def test_any_parameter():
    data = of("--set", "contact.max_events=7", "--set", "plane.impact_law=newton", "--v0", "1")
    assert data["contact"] == {"model": "rigid", "max_events": 7}
    assert data["plane"]["impact_law"] == "newton"


# Files


def test_csv_and_picture_and_saved_motion(tmp_path):
    table, picture, store = tmp_path / "a.csv", tmp_path / "a.svg", tmp_path / "a.nc"
    done = run("run", *HOP, "--csv", table, "--samples", 11, "--plot", picture, "--save", store, "--quiet")
    assert done.exit_code == 0, done.stderr
    assert done.stdout == ""
    rows = list(csv.reader(table.open(encoding="utf-8")))
    assert len(rows) == 12
    assert "<svg" in picture.read_text(encoding="utf-8")
    assert hh.load(store).at(1.3) == hop().at(1.3)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv", "a.nc", "a.svg"]


def test_a_folder_is_not_replaced(tmp_path):
    kept = tmp_path / "results" / "precious"
    kept.parent.mkdir()
    kept.write_text("kept", encoding="utf-8")
    done = run("run", *HOP, "--csv", kept.parent)
    assert done.exit_code == 2
    assert kept.read_text(encoding="utf-8") == "kept"


# Exit status


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--mu", "-1"], "plane.mu = -1.0 must be at least 0"),
        (["--gamma", "1.5"], "hoop.load_fraction = 1.5 must be from 0 to 1"),
        (["--duration", "0"], "duration = 0.0 must be from 1e-09 to 1e+09 s"),
        (["--mu", "nan"], "plane.mu = nan"),
        (["--slope", "0.1", "--slope-deg", "3"], "--slope-deg cannot be given together with --slope"),
        (["--set", "plane.colour=1"], "colour"),
        (["--set", "plane.mu"], "--set = 'plane.mu' must be a path and a value"),
        (["nowhere.toml"], "nowhere.toml: No such file or directory"),
        (["--plot", "picture.xyz"], "--plot = picture.xyz must end in"),
        (["--save", "motion.txt"], "--save = motion.txt must end in"),
        (["--save", "gone/hop.nc"], "--save = gone/hop.nc must be in an existing folder; gone does not exist"),
        (["--out", "gone/hop.json"], "--out = gone/hop.json must be in an existing folder"),
        (["--csv", "gone/hop.csv"], "--csv = gone/hop.csv must be in an existing folder"),
        (["--plot", "gone/hop.png"], "--plot = gone/hop.png must be in an existing folder"),
        (["--samples", "1"], "--samples = 1 must be at least 2"),
        (["--csv", "a", "--out", "a"], "a is used for two outputs"),
        (["--mu", "much"], "--mu"),
        (["--colour", "red"], "--colour"),
    ],
)
def test_bad_input_is_one_sentence(arguments, sentence):
    done = run("run", *arguments)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert sentence in done.stderr
    assert done.stderr.startswith("Error: ")
    assert done.stderr.count("\n") == 1


def test_no_answer_is_written_and_told(tmp_path):
    path = tmp_path / "result.json"
    done = run("run", *HOP, "--set", "contact.max_events=3", "--out", path)
    assert done.exit_code == 1
    assert "event_limit" in done.stderr
    data = json.loads(path.read_text(encoding="utf-8"))
    assert data["status"] == "event_limit"
    assert len(data["events"]) >= 3


def test_no_command_and_unknown_command():
    assert run().exit_code == 2
    unknown = run("rum")
    assert unknown.exit_code == 2
    assert "rum" in unknown.stderr


# Theory


def test_theory_as_json():
    done = run("theory", "--json")
    assert done.exit_code == 0
    data = json.loads(done.stdout)
    assert data["schema"] == "hophoop-theory/1"
    values = data["theory"]
    assert values["first_slip_speed"] == hh.theory.first_slip_speed(hh.Hoop.ideal(0.75), hh.Plane())
    assert values["painleve_friction"] == pytest.approx(math.sqrt(1 - 0.75**2) / 0.75, rel=1e-14)
    assert values["immediate_hop_speed"] == pytest.approx(math.sqrt(9.81 / 0.75), rel=1e-14)
    assert values["hop_angle"] == pytest.approx(hop().find("takeoff")[0].angle, rel=1e-12)


def test_theory_says_what_a_hoop_does_not_have():
    data = json.loads(run("theory", "--json", "--gamma", "1", "--v0", "1").stdout)
    assert data["theory"]["first_slip_speed"] is None
    assert "massless" in data["notes"]["first_slip_speed"]
    assert data["theory"]["massless_loss_angle"] == pytest.approx(math.acos(1 / 9.81), rel=1e-14)
    assert data["theory"]["max_rolling_speed"] == "inf"


def test_theory_as_a_table():
    done = run("theory", "--v0", "2")
    assert done.exit_code == 0
    assert "2.04317391" in done.stdout
    assert "not within the first turn" in done.stdout


# As a program of its own


def program(*arguments, text=None):
    command = [sys.executable, "-m", "hophoop", *arguments]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=False, encoding="utf-8")


def test_program_exit_status_and_streams():
    done = program("run", "-", "--json", text="duration = 0.5\n")
    assert done.returncode == 0
    assert json.loads(done.stdout)["status"] == "completed"
    bad = program("run", "--gravity", "-9.81")
    assert (bad.returncode, bad.stdout) == (2, "")
    assert bad.stderr == "Error: plane.gravity = -9.81 must be 0 or from 1e-06 to 1e+06 m/s².\n"
    assert program("--version").stdout == f"{hh.__version__}\n"


def test_help_loads_no_numbers():
    code = (
        "import sys\nfrom hophoop.cli import app\n"
        "try:\n    app(['--help'])\nexcept SystemExit:\n    pass\n"
        "heavy = {'numpy', 'numba', 'pydantic', 'matplotlib', 'xarray'} & set(sys.modules)\n"
        "print(sorted(heavy), file=sys.stderr)"
    )
    begin = time.perf_counter()
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    seconds = time.perf_counter() - begin
    assert done.stderr.strip() == "[]"
    assert all(name in done.stdout for name in ("run", "theory", "reproduce"))
    assert seconds < 5.0  # half a second on a machine of its own; this only catches a heavy import


# Why


def test_explain():
    result = run("run", *HOP, "--explain")
    assert result.exit_code == 0, result.output
    assert "0.000000 to 0.266393 s: roll (R), θ from 0.000 to" in result.output
    assert "Slip ends: v_t = 0. It rolls: that needs F = " in result.output
    assert "Contact is lost: N = 0, and the rim is free to leave the plane. It flies" in result.output


def test_sensitivity():
    result = run("run", *HOP, "--sensitivity", "takeoff.angle,hop.height", "--wrt", "plane.mu,plane.restitution")
    assert result.exit_code == 0
    lines = result.output.splitlines()[-4:]
    assert lines[0] == "takeoff.angle  by plane.mu: +0.221788164 rad"
    none = "none, the parameter is at the edge of what is allowed; towards larger values +0 m"
    assert lines[3] == f"hop.height     by plane.restitution: {none}"


def test_sensitivity_is_in_the_json(tmp_path):
    """To standard output and to a file, beside what a run without it writes."""
    options = [*HOP, "--sensitivity", "takeoff.angle,hop.height", "--wrt", "plane.mu,plane.restitution"]
    printed = run("run", *options, "--json")
    assert printed.exit_code == 0, printed.output
    data = json.loads(printed.stdout)
    written = run("run", *options, "--out", tmp_path / "hop.json")
    assert written.exit_code == 0, written.output
    assert "takeoff.angle  by plane.mu: +0.221788164 rad" in written.stdout
    assert json.loads((tmp_path / "hop.json").read_text(encoding="utf-8")) == data
    found = data.pop("sensitivity")
    assert data == hop().to_dict()
    assert found == hop().sensitivity(["takeoff.angle", "hop.height"], ["plane.mu", "plane.restitution"]).to_dict()
    assert found["derivatives"][0] == {"of": "takeoff.angle", "wrt": "plane.mu", "derivative": pytest.approx(0.22178816435)}
    edge = found["derivatives"][1]
    assert (edge["derivative"], edge["smaller"], edge["larger"]) == (None, None, 0.0)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--sensitivity", "end.x"), "need each other"),
        (("--wrt", "plane.mu"), "need each other"),
        (("--sensitivity", "leap.x", "--wrt", "plane.mu"), "is no quantity"),
        (("--sensitivity", "end.x", "--wrt", "plane.mu", "--digits", "20"), "--sensitivity cannot be given together"),
    ],
)
def test_sensitivity_is_refused_in_a_sentence(options, sentence):
    result = run("run", *HOP, *options)
    assert result.exit_code == 2
    assert sentence in result.output


def test_explain_is_refused_where_it_has_no_rules():
    result = run("run", "--explain", "-", text='[contact]\nmodel = "compliant"\n')
    assert result.exit_code == 2, result.output
    assert "contact.model = 'compliant' must be 'rigid'" in result.output
    result = run("run", *HOP, "--digits", "20", "--explain")
    assert result.exit_code == 2, result.output
    assert "--explain cannot be given together with --digits" in result.output
    result = run("run", *HOP, "--check", "--errors")
    assert result.exit_code == 2
    assert "--errors cannot be given together with --check" in result.output


def test_the_work_of_a_compliant_motion_is_told_before_it_starts(tmp_path, monkeypatch):
    """From the steps of its first part; with few of them nothing is said, and standard output stays a result."""
    from hophoop.cli import _work

    path = tmp_path / "soft.toml"
    path.write_text('duration = 0.5\n[contact]\nmodel = "compliant"\n', encoding="utf-8")
    assert run("run", path, "--json").stderr == ""
    monkeypatch.setattr(_work, "MANY", 10)
    told = run("run", path, "--json")
    assert re.fullmatch(r"The first 5 % of the motion take \d+ steps: about [\d,]+ in all\.\n", told.stderr)
    assert json.loads(told.stdout)["status"] == "completed"
    assert run("run", path, "--quiet").stderr == ""
    monkeypatch.setattr("hophoop.kernel.compliant.run.MAX_STEPS", 30)
    assert "of which 30 are computed; a shorter duration" in run("run", path, "--json").stderr


def test_rolling_resistance_is_an_option_and_told():
    done = run("run", "--v0", 2.0, "--duration", 1.0, "--rolling-resistance", 0.02)
    assert done.exit_code == 0
    motion = hh.simulate(hh.Scenario(plane=hh.Plane(rolling_resistance=0.02), start=hh.Start.rolling(2.0), duration=1.0))
    assert f"rolling resistance {motion.ledger.rolling_resistance:.6g} J" in " ".join(done.stdout.split())
    refused = run("run", "--gamma", 1.0, "--rolling-resistance", 0.02)
    assert refused.exit_code == 2
    assert "must be 0 for the massless hoop" in " ".join(refused.stderr.split())


def test_until_ends_a_motion_earlier():
    found = json.loads(run("run", *HOP, "--until", "takeoff", "--json").stdout)
    assert found["ending"] == "takeoff"
    assert found["events"][-1]["t"] == pytest.approx(1.045, abs=1e-3)
    assert "ended by landings:1" in run("run", *HOP, "--until", "landings:1").stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--until", "supper"], "--until = 'supper' must be"),
        (["--until", "takeoff", "--digits", "20"], "--until cannot be given together with --digits"),
        (["--until", "takeoff", "--explain"], "--until cannot be given together with --explain"),
    ],
)
def test_until_that_is_not_allowed(arguments, message):
    found = run("run", *HOP, *arguments)
    assert found.exit_code == 2
    assert message in found.stderr
