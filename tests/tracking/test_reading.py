"""Tracks from files of others: Tracker's export, and tables."""

import json

import numpy as np
import pytest

import hophoop as hh
from hophoop.scenario import InputError
from hophoop.tracking import Camera, Reading, View, read_track
from hophoop.tracking.table import COLUMNS, track_of

T = np.arange(6) / 240.0
X = 0.3 * np.arange(6) / 10 + 0.01
Y = np.array([0.3, 0.301, 0.302, 0.3, 0.3, 0.3])


def java(value):
    """A number as Tracker's exporter writes it."""
    mantissa, _, exponent = f"{value:.9E}".partition("E")
    return f"{mantissa}E{int(exponent)}"


def export(rows, names, columns, sep="\t", decimal=".", multi=False):
    """Tracker's text export: names over the columns, which end with a separator, as do all rows."""
    lines = ["#multi:"] if multi else []
    lines.append(sep + "".join(name + sep * len(columns) for name in names))
    lines.append("t" + sep + sep.join(sep.join(columns) for _ in names) + sep)
    for row in rows:
        lines.append(sep.join("" if value is None else java(value).replace(".", decimal) for value in row) + sep)
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize(("sep", "decimal"), [("\t", "."), ("\t", ","), (",", "."), (";", ","), (";", ".")])
def test_an_export_of_one_point(tmp_path, sep, decimal):
    # velocities lack both ends, as differences do
    v = [None, *np.gradient(X, T)[1:-1], None]
    file = tmp_path / "mass.txt"
    file.write_text(export(zip(T, X, Y, v, strict=True), ["mass A"], ["x", "y", "vx"], sep, decimal), encoding="utf-8-sig")
    track = read_track(file, Reading(radius=0.3))
    assert track.t == pytest.approx(T, rel=1e-9)
    assert track.centre == pytest.approx(np.stack([X, Y], axis=-1), rel=1e-9)
    assert np.isnan(track.marker).all()
    assert set(track.state) == {"no marker"}
    assert not track.placed
    assert track.radius == 0.3


def two_points(tmp_path, names):
    marker = X + 0.25, Y + np.array([0.1, np.nan, 0.1, 0.1, 0.1, 0.1])
    rows = [
        [t, x, y, None if np.isnan(b) else a, None if np.isnan(b) else b]
        for t, x, y, a, b in zip(T, X, Y, *marker, strict=True)
    ]
    file = tmp_path / "two.txt"
    file.write_text(export(rows, names, ["x", "y"], multi=True), encoding="utf-8")
    return file


def test_an_export_of_two_points_with_empty_cells(tmp_path):
    track = read_track(two_points(tmp_path, ["centre", "marker"]))
    assert track.centre[:, 0] == pytest.approx(X)
    assert track.marker[0] == pytest.approx([X[0] + 0.25, Y[0] + 0.1])
    assert track.state[1] == "no marker"
    assert np.isnan(track.marker[1]).all()
    assert track.angle[0] == pytest.approx(np.arctan2(0.25, 0.1))


def test_names_that_say_nothing_are_asked_for(tmp_path):
    file = two_points(tmp_path, ["A", "B"])
    with pytest.raises(ValueError, match="points 'A', 'B': name the one at the centre and the one at the marker by --centre"):
        read_track(file)
    track = read_track(file, Reading(centre="B", marker="A"))
    assert track.marker[:, 0] == pytest.approx(X)
    with pytest.raises(ValueError, match="no point 'C'; its points are 'A', 'B'"):
        read_track(file, Reading(centre="C"))


def test_an_angle_without_unit_is_asked_for(tmp_path):
    file = tmp_path / "angle.csv"
    file.write_text("t,angle\n" + "\n".join(f"{t},{350 + 4000 * t if t < 0.004 else 4000 * t - 10}" for t in T))
    with pytest.raises(ValueError, match="has no unit of angle"):
        read_track(file)
    # a jump of a whole turn is none
    steps = np.diff(read_track(file, Reading(angle_unit="deg")).angle)
    assert steps == pytest.approx(np.radians(4000 / 240), rel=1e-9)


def test_units_in_the_header(tmp_path):
    file = tmp_path / "plain.csv"
    file.write_text(
        "t [ms],x [cm],y [mm],angle [°]\n"
        + "\n".join(f"{1e3 * t},{x * 100},{y * 1000},{30 * t}" for t, x, y in zip(T, X, Y, strict=True))
    )
    track = read_track(file)
    assert track.t == pytest.approx(T)
    assert track.centre == pytest.approx(np.stack([X, Y], axis=-1))
    assert track.angle == pytest.approx(np.radians(30 * T))


@pytest.mark.parametrize("name", ["hoop.trk", "hoop.TRZ"])
def test_a_project_of_tracker_is_refused_with_the_way(tmp_path, name):
    (tmp_path / name).write_text("<object/>")
    with pytest.raises(InputError, match=rf"{name} is a project of Tracker: .* File, Export, Data\.$"):
        read_track(tmp_path / name)


# --- our own ---------------------------------------------------------------------------------------


def own():
    rng = np.random.default_rng(5)
    columns = {name: rng.normal(size=8) for name in COLUMNS if name != "t"}
    columns["x"][3] = columns["y"][3] = np.nan
    view = View(Camera(640, 360, 500.0, 0.01, -0.02), 200.0, -100.0, 3.0, 0.01, (-20.0, 90.0), 0.86, 1e-3, 1e-5, None)
    others = {"radius": 0.3, "slope": 0.02, "placed": True, "view": view, "source": "film.mp4", "notes": ("A note.",)}
    return track_of(np.arange(8) / 240.0, columns, **others)


def test_a_saved_track_is_the_same(tmp_path):
    track = own()
    track.save(tmp_path / "track.json")
    back = read_track(tmp_path / "track.json")
    for name in dict.fromkeys(attribute for attribute, _, _ in COLUMNS.values()):
        np.testing.assert_array_equal(getattr(back, name), getattr(track, name))
    for name in ("state", "radius", "slope", "placed", "view", "source", "notes"):
        assert getattr(back, name) == getattr(track, name)
    track.save(tmp_path / "track.csv")
    table = read_track(tmp_path / "track.csv")
    np.testing.assert_array_equal(table.centre, track.centre)
    np.testing.assert_array_equal(table.marker_error, track.marker_error)
    assert table.placed
    with pytest.raises(ValueError, match=r"must end in \.json or \.csv"):
        track.save(tmp_path / "track.xls")


# --- what goes wrong is one sentence ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "", "is empty"),
        ("a.csv", "1,2\n3,4\n", "has no row of column names"),
        ("a.csv", "t,x,y\n", "has no table"),
        ("a.csv", "t,x,y\na,b,c\n", "has no row of numbers"),
        ("a.csv", "x,y\n1,2\n3,4\n5,6\n", "has no column of times: its columns are x, y; --column t=HEAD names one"),
        ("a.csv", "t,x\n0,1\n1,1\n2,1\n", "has a column x, but none for y: its columns are t, x; --column y=HEAD"),
        ("a.csv", "t,speed\n0,1\n1,1\n2,1\n", "has neither x and y, nor marker_x and marker_y, nor angle"),
        ("a.csv", "t,x,y\n0,1,1\n1,1,1\n", "has 2 rows; at least 3 are needed"),
        ("a.csv", "t,x,y\n0,1,1\n2,1,1\n1,1,1\n", "must have times that increase, which they do not in row 3"),
        ("a.csv", "t,x,y\n0,1,1\n1,fast,1\n2,1,1\n", "has 'fast' in column x, row 2 below"),
        ("a.csv", "t,x,y\n0,1,inf\n1,1,1\n2,1,1\n", "has 'inf' in column y, row 1 below"),
        ("a.csv", "t,x,y\n0,nan,nan\n1,nan,nan\n2,,\n", "has the hoop in no row"),
        ("a.csv", "t [h],x,y\n0,1,1\n1,1,1\n2,1,1\n", "gives t [h] in an unknown unit; known units are s, ms and min"),
        ("a.md", "t,x,y\n0,1,1\n", "must end in .json, .csv"),
        ("a.json", "{", "is not valid JSON"),
        ("a.json", "[1]", "is not a track of hophoop"),
        ("a.json", json.dumps({"schema": "hophoop-track/1"}), "is incomplete: 'columns'"),
    ],
)
def test_bad_files(tmp_path, name, text, message):
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError) as caught:
        hh.read_track(file)
    assert message in str(caught.value)
    assert str(caught.value).endswith(".")


@pytest.mark.parametrize(
    ("name", "message"),
    [("a.csv", "is larger than 500 MB"), ("a.json", "is larger than 500 MB")],
)
def test_gigabytes_are_refused_unread(tmp_path, name, message):
    file = tmp_path / name
    with file.open("wb") as stream:
        stream.truncate(3_000_000_000)  # sparse: no byte of it is on the disk
    with pytest.raises(ValueError, match=message):
        read_track(file)


def test_files_that_are_no_text(tmp_path):
    file = tmp_path / "a.csv"
    file.write_bytes(b"\x89PNG\r\n\x1a\n\x00\x00")
    with pytest.raises(ValueError, match="is not text"):
        read_track(file)
    with pytest.raises(FileNotFoundError):
        read_track(tmp_path / "absent.csv")


@pytest.mark.parametrize("values", [{"angle_unit": "turn"}, {"radius": -1.0}, {"rate": 0.0}])
def test_bad_readings(values):
    with pytest.raises(ValueError, match=f"{next(iter(values))} = "):
        Reading(**values)
