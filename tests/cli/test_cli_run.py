"""`hophoop run` and `hophoop theory`: what they print and write, and their exit status."""

import dataclasses
import json
import math
import re

import pytest

import hophoop as hh
from cli_tools import HOP, done, hop, run
from hophoop.cli import app, command_of
from hophoop.tracking import Hints
from kernel_tools import python, started


def of(line, *more):
    """The JSON that a command prints."""
    return json.loads(done(f"{line} --json", *more).stdout)


@pytest.fixture
def scenario(tmp_path):
    path = tmp_path / "hop.toml"
    path.write_text("duration = 2.0\n[start]\nspeed = 3.1\n", encoding="utf-8")
    return path


# JSON to the letter

EVENT_KEYS = ["t", "kind", "from", "to", "x", "height", "angle", "vx", "vy", "omega", "before", "impulse"]


def test_json_is_the_result_and_nothing_else(tmp_path):
    data = of(HOP)
    assert data == hop().to_dict()  # every bit of every number
    assert list(data) == ["schema", "version", "scenario", "status", "sequence", "fingerprint", "events", "final", "energy"]
    assert [data[name] for name in ("schema", "version", "status", "sequence")] == [
        "hophoop/1", hh.__version__, "completed", "RKRSHR",
    ]  # fmt: skip
    assert all(list(event)[: len(EVENT_KEYS)] == EVENT_KEYS for event in data["events"])
    impact = next(event for event in data["events"] if event["kind"] == "impact")
    assert [list(impact["before"]), list(impact["impulse"])] == [["vx", "vy", "omega"], ["normal", "tangential"]]
    assert list(data["final"]) == ["t", "mode", "x", "height", "angle", "vx", "vy", "omega"]
    assert list(data["energy"]) == [
        "kinetic", "potential", "friction", "impact_normal", "impact_tangential", "rolling_resistance", "residual",
    ]  # fmt: skip
    path = tmp_path / "result.json"
    table = done(HOP, "--out", path).stdout
    assert json.loads(path.read_text(encoding="utf-8")) == data
    assert "(R roll, S spin, K skid, H flight, M skim)" in " ".join(table.split())  # the letters are explained
    assert table.splitlines()[-1].split() == ["fingerprint", hop().fingerprint]


# Options


@pytest.mark.parametrize(
    ("words", "changed"),
    [
        ("--mu 0.4 --v0 1 --radius 0.5", {"plane.mu": 0.4, "start.speed": 1.0, "hoop.radius": 0.5}),
        # each alone would contradict the other's default
        ("--mu-kinetic 0.3 --mu-static 0.5", {"plane.mu_static": 0.5, "plane.mu_kinetic": 0.3}),
        ("--inertia-ratio 0 --eccentricity 1", {"hoop.eccentricity": 1.0, "hoop.inertia_ratio": 0.0}),
        (
            "--angle-deg 90 --omega -2 --vx 1 --height 0.1 --slope-deg 5",
            {"start.angle": math.pi / 2, "start.omega": -2.0, "start.vx": 1.0, "plane.slope": math.radians(5)},
        ),
        (
            "--set contact.max_events=7 --set plane.impact_law=newton --v0 1",
            {"contact.model": "rigid", "contact.max_events": 7, "plane.impact_law": "newton"},
        ),
    ],
)  # fmt: skip
def test_options_change_a_file(scenario, words, changed):
    data = of(f"run {words}", scenario)["scenario"]
    assert {path: data[path.partition(".")[0]][path.partition(".")[2]] for path in changed} == changed
    assert data["duration"] == 2.0


def test_a_free_start_is_changed_one_number_at_a_time():
    text = '{"start": {"vx": 1.0, "height": 0.1}, "duration": 0.1}'
    start = json.loads(run("run - --vx 2 --json", text=text).stdout)["scenario"]["start"]
    assert [start[name] for name in ("vx", "height", "omega")] == [2.0, 0.1, 0.0]


def test_an_option_is_declared_where_its_value_is_used():
    """Type, default and text are those of the dataclass; the command names the option and its place in the help."""
    options = {option.name: option for option in command_of("track").params}
    for field in dataclasses.fields(Hints):
        assert options[field.name].default == field.default, field.name
    assert options["level"].opts == ["--level-deg"]
    assert options["ring"].help == "The rim against its background: auto, dark or light."


def test_a_name_of_python_leads_to_the_option():
    for line, right in (
        ("run --speed 1", "(Possible options: --v0)"),
        ("run --load_fraction 1", "(Possible options: --gamma)"),
        ("run --slop 1", "--slope"),
        ("track --speed 1", "(Possible options: --save, --slope-deg)"),  # it has no --v0
    ):
        assert right in " ".join(done(line, status=2).output.split())


def test_a_shell_completes_commands_options_and_values(monkeypatch, capsys):
    monkeypatch.setenv("_HOPHOOP_COMPLETE", "complete_bash")
    for typed, offered in (("th", "theory"), ("run --mu-s", "--mu-static"), ("map --quantity hop_h", "hop_height")):
        monkeypatch.setenv("COMP_WORDS", f"hophoop {typed}")
        monkeypatch.setenv("COMP_CWORD", str(len(typed.split())))
        with pytest.raises(SystemExit):
            app([], prog_name="hophoop")
        assert offered in capsys.readouterr().out.split()


# Files and exit status


def test_csv_and_picture_and_saved_motion(tmp_path):
    table, picture, store = tmp_path / "a.csv", tmp_path / "a.svg", tmp_path / "a.nc"
    assert done(f"{HOP} --samples 11 --quiet", "--csv", table, "--plot", picture, "--save", store).stdout == ""
    assert len(table.read_text(encoding="utf-8").splitlines()) == 12
    assert "<svg" in picture.read_text(encoding="utf-8")
    assert hh.load(store).at(1.3) == hop().at(1.3)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv", "a.nc", "a.svg"]


def test_equal_bits_are_confirmed_and_other_ones_end_with_status_1(tmp_path):
    said = f"This machine gets the same bits: the fingerprint is {hop().fingerprint}.\n"
    assert done(HOP, "--check-fingerprint", hop().fingerprint).stdout.endswith(f"\n{said}")
    found = done(f"{HOP} --json", "--check-fingerprint", hop().fingerprint.upper())
    assert json.loads(found.stdout) == hop().to_dict()
    assert found.stderr == said
    result, other = tmp_path / "hop.json", "0123456789abcdef"
    found = run(f"{HOP} --quiet --check-fingerprint {other}", "--out", result)
    assert (found.exit_code, found.stdout) == (1, "")
    assert found.stderr == (
        f"hophoop {hh.__version__} gets other bits on this machine: the fingerprint is {hop().fingerprint}, not {other}. "
        "Only the same version of hophoop and the same scenario give the same bits.\n"
    )
    assert json.loads(result.read_text(encoding="utf-8")) == hop().to_dict()


def test_no_answer_is_written_and_told_and_has_a_fingerprint(tmp_path):
    scenario = hh.Scenario().with_values({"contact.max_events": 3, "start.speed": 3.1, "duration": 2.0})
    path, words = tmp_path / "result.json", f"{HOP} --set contact.max_events=3 --check-fingerprint"
    found = done(words, hh.simulate(scenario).fingerprint, "--out", path, status=1)
    assert "This machine gets the same bits" in found.stdout
    assert re.match(r"The motion ends at t = .*event_limit", found.stderr)
    assert json.loads(path.read_text(encoding="utf-8"))["status"] == "event_limit"


# Theory


def test_theory_as_json_and_as_a_table():
    data = of("theory")
    assert data["schema"] == "hophoop-theory/1"
    assert data["theory"]["first_slip_speed"] == hh.theory.first_slip_speed(hh.Hoop(), hh.Plane())
    assert data["theory"]["hop_angle"] == pytest.approx(hop().find("takeoff")[0].angle, rel=1e-12)
    table = done("theory --v0 2").stdout
    assert "2.04317391" in table
    assert "not within the first turn" in table
    massless = of("theory --gamma 1 --v0 1")
    assert massless["theory"]["first_slip_speed"] is None
    assert "massless" in massless["notes"]["first_slip_speed"]
    assert massless["theory"]["max_rolling_speed"] == "inf"


# As a program of its own


def test_program_exit_status_and_streams():
    assert json.loads(started("-m", "hophoop", "run", "--duration", "0.5", "--json").stdout)["status"] == "completed"
    assert run("--version").stdout == f"{hh.__version__}\n"
    done("", status=2)


def test_help_loads_no_numbers():
    code = (
        "import sys\nfrom hophoop.cli import app\n"
        "try:\n    app(['--help'])\nexcept SystemExit:\n    pass\n"
        "heavy = {'numpy', 'numba', 'pydantic', 'matplotlib', 'xarray'} & set(sys.modules)\n"
        "print(sorted(heavy), file=sys.stderr)"
    )
    found = python(code)
    assert found.stderr.strip() == "[]"
    assert all(name in found.stdout for name in ("run", "theory", "reproduce"))


# Why


def test_explain():
    said = done(f"{HOP} --explain").output
    assert "0.000000 to 0.266393 s: roll (R), θ from 0.000 to" in said
    assert "Slip ends: v_t = 0. It rolls: that needs F = " in said
    assert "Contact is lost: N = 0, and the rim is free to leave the plane. It flies" in said


def test_sensitivity_is_told_and_in_the_json(tmp_path):
    """To standard output and to a file, beside what a run without it writes."""
    of, wrt = ["takeoff.angle", "hop.height"], ["plane.mu", "plane.restitution"]
    line = f"{HOP} --sensitivity {','.join(of)} --wrt {','.join(wrt)}"
    lines = done(line, "--out", tmp_path / "hop.json").stdout.splitlines()[-4:]
    assert lines[0] == "takeoff.angle  by plane.mu: +0.221788164 rad"
    none = "none, the parameter is at the edge of what is allowed; towards larger values +0 m"
    assert lines[3] == f"hop.height     by plane.restitution: {none}"
    data = json.loads((tmp_path / "hop.json").read_text(encoding="utf-8"))
    assert data == hop().to_dict() | {"sensitivity": hop().sensitivity(of, wrt).to_dict()}


def test_until_ends_a_motion_earlier():
    found = of(f"{HOP} --until takeoff")
    assert found["ending"] == "takeoff"
    assert found["events"][-1]["t"] == pytest.approx(1.045, abs=1e-3)
    assert "ended by landings:1" in run(f"{HOP} --until landings:1").stdout
