"""Bad input, as a person types it: one sentence on standard error, status 2, and no file."""

from functools import wraps

import pytest

import hophoop as hh
from cli_tools import run, save_track
from hophoop.gaits import search

MU, SPEED = "--axis plane.mu=0.2:1.8:9", "--axis start.speed=0.1,2,3.1,5"
MAP = f"map {MU} {SPEED}"
GAIT = "gait --slope-deg 3 --gamma 0.5 --near 8.68"
DIAGRAM = "diagram --axis plane.slope=0.01:0.02:3 --gamma 0.75 --gravity 1"
FIT = "fit track.csv --radius 0.3"
TRACK = "track no.mp4 --radius 0.3"
FILM = "animate --duration 0.2 --out a.mp4"
PROVE = "prove --v0 3.1"
FINGERPRINT = "0123456789abcdef"

# by command: what is typed behind it, and what is said; the scenario is hop.toml, the track is track.csv
REFUSED = {
    "": {
        "rum": "rum",
        "theory --colour red": "--colour",
        "lab --port 99999999": "--port = 99999999 must be",
        "lab --port many": "--port = 'many' must be a whole number, such as 3. See hophoop lab --help.",
        "lab hop.toml --film track.csv": "--film needs a fit",
        "lab --docs ../": "--docs needs --export",
        "lab --url https://hoop.example": "--url needs --export",
        "lab --export lab --url hoop.example": "--url = 'hoop.example/' must be an address of http or https",
        "lab --export lab --url 'https://hoop.example/\"><script>'": "--url = ",
        "plan --rate 0": "--rate = 0.0 must be a number above 0",
        "plan --sigma 5e-324": "--sigma = 5e-324 must be from 1e-30 to 1e+30",
        "plan --sigma-scale 5e-324": "--sigma-scale = 5e-324 must be from 1e-30 to 1e+30",
        "fit track.csv": "The radius of the hoop is missing",
        "track no.mp4": "Missing option '--radius'",
        "track no.mp4 --radius 0": "--radius = 0.0 must be a number above 0",
        "track a.mp4 --radius 30cm": "--radius = '30cm' must be a number, such as 3.1.",
        "track a.mp4 --radius 0.3 --overlay a.mp4": "is the film itself",
        "animate --v0 1": "Missing option '--out'",
        "animate --out a.avi": "--out = 'a.avi' must end in",
        "animate --3d --out new/hop.html": "--out = new/hop.html must be in an existing folder; new does not exist.",
    },
    "run": {
        "--gamma 0.5 --eccentricity 0.2": "--gamma cannot be given together with --eccentricity.",
        "--v0 1 --vx 2": "--v0 cannot be given together with --vx.",
        "--mu 1 --mu-static 2": "--mu cannot be given together with --mu-static.",
        "--mu 1 --set plane.mu=0.5": "--set plane.mu cannot be given together with --mu.",
        "--v0 1 --set start.omega=2": "--v0 cannot be given together with --set start.omega.",
        "--slope 0.1 --slope-deg 3": "--slope-deg cannot be given together with --slope",
        "--vx 2": "--vx cannot be given without --omega: the start is a rolling one (start.speed = 3.1 m/s)",
        "--omega 2": "--omega cannot be given without --vx",
        "--height 0.2": "--height cannot be given without --vx and --omega",
        "--radius -1": "--radius = -1.0 must be",
        "--gravity -9.81": "Error: --gravity = -9.81 must be 0 or from 1e-06 to 1e+06 m/s².",
        "--mu -1": "--mu = -1.0 must be from 0 to 1e+06, or inf.",
        "--mu nan": "--mu = nan",
        "--slope-deg 200": "plane.slope = 3.49",  # the value is not the option's
        "--set plane.mu=-1": "plane.mu = -1",
        "--mu much": "--mu = 'much' must be a number",
        "--v0 3,1": "--v0 = '3,1' must be a number, such as 3.1. See hophoop run --help.",
        "--gamma 1.5": "--gamma = 1.5 must be from 0 to 1",
        "--gamma 1 --rolling-resistance 0.02": "must be 0 for the massless hoop",
        "--duration 0": "--duration = 0.0 must be from 1e-09 to 1e+09 s",
        "--set plane.colour=1": "colour",
        "--set plane.mu": "--set = 'plane.mu' must be a path and a value",
        f"--set hoop.parts.{'9' * 5000}.mass=1": "hoop.parts.",
        "nowhere.toml": "nowhere.toml: No such file or directory",
        "--plot picture.xyz": "--plot = picture.xyz must end in",
        "--save motion.txt": "--save = motion.txt must end in",
        "--save gone/hop.nc": "--save = gone/hop.nc must be in an existing folder; gone does not exist",
        "--out gone/hop.json": "--out = gone/hop.json must be in an existing folder",
        "--csv gone/hop.csv": "--csv = gone/hop.csv must be in an existing folder",
        "--plot gone/hop.png": "--plot = gone/hop.png must be in an existing folder",
        "hop.toml --out hop.toml": "is the scenario itself",
        "--csv folder": "folder",
        "--csv a --out a": "a is used for two outputs",
        "--samples 1": "--samples = 1 must be at least 2",
        "--digits 5": "--digits = 5 must be",
        "--digits 30 --csv x.csv": "--csv cannot be given together with --digits.",
        "--sensitivity foo --wrt plane.mu": "--sensitivity = 'foo' is no quantity",
        "--sensitivity end.x": "need each other",
        "--wrt plane.mu": "need each other",
        "--sensitivity end.x --wrt plane.mu --digits 20": "--sensitivity cannot be given together with --digits",
        "--explain soft.toml": "contact.model = 'compliant' must be 'rigid'",
        "--digits 20 --explain": "--explain cannot be given together with --digits",
        "--check --errors": "--errors cannot be given together with --check",
        "--check --out a": "--out cannot be given together with --check",
        "--check --plot x.png": "--plot cannot be given together with --check.",
        "--errors --csv a.csv soft.toml": "--errors needs rigid contact",
        "--until supper": "--until = 'supper' must be",
        "--until takeoff --digits 20": "--until cannot be given together with --digits",
        "--until takeoff --explain": "--until cannot be given together with --explain",
        f"--digits 20 --check-fingerprint {FINGERPRINT}": "--check-fingerprint cannot be given together with --digits.",
        f"--check --check-fingerprint {FINGERPRINT}": "--check-fingerprint cannot be given together with --check.",
        **{
            f"--out a.json '--check-fingerprint={text}'": f"--check-fingerprint = {text!r} must be 16 hexadecimal digits."
            for text in ("", "12", FINGERPRINT[:-1] + "g", FINGERPRINT + "0", f" {FINGERPRINT}", f"{FINGERPRINT}\n")
        },
    },
    "map": {
        f"{MU} {SPEED}": "--out or --plot",
        "--out a.zarr": "--axis = [] must name at least one",
        f"{SPEED} --axis plane.mu=1:2:0 --out a.zarr": "--axis plane.mu=1:2:0: count = 0 must be",
        f"{SPEED} --axis plane.mu=1:inf:3:log --out a.zarr": "end of a logarithmic axis = inf must be",
        "--axis plane.mu=0:1:300000 --axis start.speed=1:2:300000 --plot a.png": "axes make 90,000,000,000 motions, which need",
    },
    MAP: {
        "--resume --plot a.png": "--out must name the map",
        "--axis plane.mu=1:2:3 --out a.zarr": "names plane.mu twice",
        "--out a.zarr --span ever": "--span = 'ever'",
        "--out a.zarr --quantity size": "quantity = 'size'",
        "--out a.zarr --quantity fate": "must be settled or settled:landing with quantity fate",
        "--axis hoop.mass=1,2 --out a.zarr --plot a.png": "two axes, not 3",
        "--out a.zarr --plot a.xyz": "--plot = a.xyz must end in .png",
        "--plot gone/a.png": "--plot = gone/a.png must be in an existing folder; gone does not exist",
        "--out a.map": "--out = 'a.map' must end in .zarr or .nc",
        "--out a.csv": "--out = 'a.csv' must end in",
    },
    GAIT: {
        "--period 70": "--period = 70 must be an integer from 1 to 64.",
        "--section top": "--section = 'top' must be one of bottom, landing.",
        "--slope-deg 0": "plane.slope = 0.0 must be other than 0",
        "--near 2": "No gait of period 1 was found",
        "--gamma 0": "hoop.load_fraction = 0.0 must be above 0",
    },
    DIAGRAM: {
        "": "--out or --plot must name a file",
        "--out d.txt": "--out = d.txt must end in .nc or .csv.",
        "--out d.csv --passages 3": "--passages = 3 must be an integer from 650",
        "--out d.csv --axis plane.impact_law=newton,stronge": "must have numbers",
        "--out d.csv --axis plane.tilt=1:2:3": "plane.tilt",
    },
    FIT: {
        "--fix restitution": "--fix = 'restitution' must be a name and a value",
        "--fix restitution=much": "--fix restitution = 'much' must be a number",
        "--bound gamma=1": "--bound gamma = '1' must be two numbers",
        "--free t0": "t0 is no parameter of a fit: the time of the start is redundant with its position",
        "--film film.mp4": "--film needs --out",
        "track.csv --film film.mp4 --out page": "--film is for one run",
        "--save fit.txt": "--save = fit.txt must end in .json",
        "--hoop absent.toml": "absent.toml",
        "--column x": "--column = 'x' must be a name and a value",
        "--column 'speed=x [m]'": "--column cannot name 'speed'; it can name frame, t, x, y",
        "--column x=across": "has no column 'across'; its columns are t [s], x [m], ",
        "--rate -1": "--rate = -1.0 must be a number above 0",
        "--from 2": "has times from 0 to 0.391667 s, of which 0 are in the window",
    },
    TRACK: {
        "--marker-color nonsense": "--marker-color = 'nonsense' must be auto, none, red",
        "--marker-color gray": "--marker-color = 'gray' is too near to gray",
        "--centre 1,2": "rim is missing",
        "--centre a,b": "--centre = 'a,b' must be 2 numbers",
        "--row-delay 1": "--row-delay = 1.0 must be from -0.001 to 0.001",
        "--level-deg 90": "--level-deg = ",
        "--save a.xls": "--save = a.xls must end in .json or .csv",
        "--overlay a.avi": "--overlay = a.avi must end in .mp4",
        "--save gone/a.csv": "in an existing folder; gone does not exist",
    },
    FILM: {
        "--size wide": "--size = wide must be a width and a height",
        "--size 321x181": "must be even numbers",
        "--slow-at hop": "--slow-at = 'hop' must be a finite time (s) or one of",
        "--vary plane.mu": "--vary = 'plane.mu' must be a path and values",
        "--3d --overlay": "cannot be given together with --3d",
        "--theme blue": "--theme = 'blue' must be one of light, dark, print",
        "--theme 'start = end'": "--theme = 'start = end' must be one of ",  # the option replaces the name alone
        "--to 9": "--to = 9.0 must be from the start at 0.0 s to",
        "--from inf": "--from = inf must be",
        "--panel speed": "--panel = 'speed' must be one of velocity",
        "--label a --label b": "--label has 2 texts; the film shows 1 motions",
        "--fps 0": "--fps = 0.0 must be a positive number",
        "--out new/hop.png": "--out = new/hop.png must be in an existing folder; new does not exist.",
    },
    PROVE: {
        "--digits 0": "--digits",
        "--until never": "--until = 'never' must be",
        "--thresholds fastest": "'fastest'",
        "--thresholds all --seconds 3": "--thresholds cannot be given together with --seconds",
    },
    "lab": {"fit.json": "fit.json is incomplete"},
}
# an output without a name, and a name of 5000 letters, which is shown by its start
OUTPUTS = ("reproduce --out", "run --csv", "animate --out", "map --plot", "prove --out", "lab --export")
REFUSED[""] |= {
    f"{line}{empty}": f"{line.split()[1]} = '' must name a file or a folder." for line in OUTPUTS for empty in (" ''", "=")
}
REFUSED[""] |= {f"{line} {5000 * letter}": "..." for line in ("", "run", "run --csv") for letter in ("x", "\x1b")}
# refused before the search for gaits, which takes seconds
FOLLOW = {
    "--plot b.png": "--plot needs --follow",
    "--follow plane.slope": "--follow = 'plane.slope' must be PATH=LOW:HIGH",
    "--follow plane.slope=a:b": "must be PATH=LOW:HIGH",
    "--follow plane.slope=0.1:0.2": "on both sides of plane.slope",
    "--follow plane.slope=nan:0.2": "must be finite",
    "--follow plane.slope=0.2:0.001": "on both sides of plane.slope",
    "--follow plane.slope=-0.1:0.2": "slopes of one sign",
    "--follow plane.tilt=0.001:0.2": "plane.tilt is not a known key; did you mean plane.slope?",
    "--follow plane.gravity=0.5:2": "a parameter other than hoop.radius, hoop.mass and plane.gravity",
    "--digits 3": "--digits = 3 must be an integer from 16 to 40",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a file of each kind."""
    path = tmp_path_factory.mktemp("files")
    save_track(path / "track.csv")
    hh.Scenario(duration=2.0).save(path / "hop.toml")
    hh.Scenario(duration=0.1, contact=hh.Compliant()).save(path / "soft.toml")
    (path / "folder").mkdir()
    texts = {
        "list": "[]",
        "long": f'{{"t": {"9" * 5000}}}',
        "deep": "[" * 100_000,
        "other": '{"schema": "hophoop-proof/2"}',
        "fit": '{"schema": "hophoop-fit/1", "values": {}, "free": [], "covariance": "much"}',
    }
    for name, text in texts.items():
        (path / f"{name}.json").write_text(text, encoding="utf-8")
    return path


def check(folder, monkeypatch, line, sentence):
    monkeypatch.chdir(folder)
    files = {path: path.stat().st_mtime_ns for path in folder.iterdir()}
    found = run(line)
    said = found.stderr.strip("\n")  # Rich 13.0 leaves the line of its bar
    assert (found.exit_code, found.stdout) == (2, "")
    assert said.startswith("Error: ")
    assert said.isprintable()
    assert len(said) < 400
    assert sentence in said
    assert {path: path.stat().st_mtime_ns for path in folder.iterdir()} == files


LINES = [(f"{command} {words}".strip(), said) for command, table in REFUSED.items() for words, said in table.items()]


@pytest.mark.parametrize(("line", "sentence"), LINES, ids=lambda text: ascii(text)[:60])
def test_bad_input_is_one_sentence(folder, monkeypatch, line, sentence):
    check(folder, monkeypatch, line, sentence)


@pytest.mark.parametrize(("words", "sentence"), FOLLOW.items())
def test_what_cannot_be_followed_is_refused_before_the_search(folder, monkeypatch, words, sentence):
    monkeypatch.setattr(search, "find", wraps(search.find)(lambda *_, **__: pytest.fail("it looks for gaits")))
    check(folder, monkeypatch, f"gait --slope-deg 1 --gamma 0.75 --gravity 1 --near 3.41 {words}", sentence)
