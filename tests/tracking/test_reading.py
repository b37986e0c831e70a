"""Tracks from files: Tracker's export, tables of spreadsheets, our own; and what a message says of them."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop.scenario import InputError
from hophoop.tracking import Camera, Reading, View, read_track
from hophoop.tracking.table import COLUMNS, track_of

ROWS = "".join(f"{0.01 * k:.2f};0,1{k};0,3;0,1{k};0,5\n" for k in range(5))
T = np.arange(24) / 240.0
X, Y = 0.03 * np.arange(24) + 0.01, 0.3 + 0.001 * (np.arange(24) % 3)
HIDDEN = range(10, 14)


def written(tmp_path, text, encoding="utf-8", name="ours.csv"):
    file = tmp_path / name
    file.write_bytes(text.encode(encoding))
    return file


# --- Tracker ---------------------------------------------------------------------------------------


def exported(tmp_path, names, delimiter="\t", comma=False, every=1):
    """Tracker's text of two points, of which the second is hidden in some frames; of every n-th frame if stepped over.

    One point beside the other, a delimiter behind each cell, numbers with Java's pattern 0.000000E0.
    """
    seen = np.where(np.arange(24) % every, np.nan, 1.0)
    marked = np.where(np.isin(np.arange(24), HIDDEN), np.nan, seen)
    columns = (T, X * seen, Y * seen, (X + 0.25) * marked, (Y + 0.1) * marked)
    rows = [["", names[0], "", names[1], ""], ["t", "x", "y", "x", "y"]]
    for row in zip(*columns, strict=True):
        cells = ("" if np.isnan(value) else re.sub(r"E\+?(-?)0", r"E\1", f"{value:.6E}") for value in row)
        rows.append([cell.replace(".", "," if comma else ".") for cell in cells])
    text = "\n".join(["#multi:", *(delimiter.join([*row, ""]) for row in rows)])
    return written(tmp_path, text, "utf-8-sig", "two.txt")


@pytest.mark.parametrize("style", [("\t", False), ("\t", True), (";", True), (";", False), (",", False)])
def test_an_export_is_read_in_each_format(tmp_path, style):
    track = read_track(exported(tmp_path, ["hub", "load"], *style), Reading(radius=0.3))
    assert track.t == pytest.approx(T, abs=1e-6)
    assert track.centre == pytest.approx(np.stack([X, Y], axis=-1), rel=1e-6)
    assert track.marker[0] == pytest.approx([X[0] + 0.25, Y[0] + 0.1], rel=1e-6)
    assert [k for k, word in enumerate(track.state) if word == "no marker"] == list(HIDDEN)
    assert np.isnan(track.marker[HIDDEN]).all()
    assert track.angle[0] == pytest.approx(np.arctan2(0.25, 0.1))
    assert (track.placed, track.radius) == (False, 0.3)


def test_frames_that_were_stepped_over_are_not_lost(tmp_path):
    """With a step size of 2 Tracker still writes a row for every frame, in which every second has a time and nothing else."""
    track = read_track(exported(tmp_path, ["hub", "load"], every=2))
    assert track.t == pytest.approx(T[::2], abs=1e-6)
    assert "lost" not in track.state


def test_names_that_say_nothing_are_asked_for(tmp_path):
    file = exported(tmp_path, ["A", "B"])
    with pytest.raises(ValueError, match="points 'A', 'B': name the one at the centre and the one at the marker by --centre"):
        read_track(file)
    assert read_track(file, Reading(centre="B", marker="A")).marker[:, 0] == pytest.approx(X, rel=1e-6)
    with pytest.raises(ValueError, match="no point 'C'; its points are 'A', 'B'"):
        read_track(file, Reading(centre="C"))


# --- spreadsheets ----------------------------------------------------------------------------------


def test_a_comma_between_quotes_divides_nothing(tmp_path):
    table = 't,x,y,remark\n0.00,0.1,0.3,"dark, blurred"\n"0,01","0,2","0,3",\n0.02,0.3,0.3,\n'
    track = read_track(written(tmp_path, table))
    assert track.t == pytest.approx([0.0, 0.01, 0.02])
    assert track.centre[:, 0] == pytest.approx([0.1, 0.2, 0.3])
    assert track.notes == ("Columns of ours.csv that are not used: remark.",)


def test_columns_that_are_not_used_are_named(tmp_path):
    track = read_track(written(tmp_path, "t;x;y;sticker_x;sticker_y\n" + ROWS))
    assert np.isnan(track.marker).all()
    assert track.notes == ("Columns of ours.csv that are not used: sticker_x, sticker_y.",)


def test_a_title_above_the_names_is_no_point(tmp_path):
    track = read_track(written(tmp_path, "Our hoop with its load;;;;\nt;x;y;load_x;load_y\n" + ROWS))
    assert track.centre[:, 0] == pytest.approx([0.10, 0.11, 0.12, 0.13, 0.14])
    assert track.marker[:, 1] == pytest.approx([0.5] * 5)


@pytest.mark.parametrize("encoding", ["cp1252", "utf-16", "utf-8-sig"])
def test_the_encodings_of_spreadsheets(tmp_path, encoding):
    table = "Größe;;;;\nt (s);x (m);y (m);angle (°);rotation (°)\n" + ROWS
    track = read_track(written(tmp_path, table, encoding))
    assert track.angle == pytest.approx(np.radians([0.10, 0.11, 0.12, 0.13, 0.14]))


def test_the_table_of_the_docs_is_read(tmp_path):
    text = (Path(__file__).parents[2] / "docs" / "film.md").read_text(encoding="utf-8")
    table = text.partition("```text\nt (s);")[2].partition("```")[0]
    track = read_track(written(tmp_path, "t (s);" + table), Reading(radius=0.3))
    assert track.t == pytest.approx([0.0, 0.008, 0.025])  # a row without a mark is left out
    assert track.centre == pytest.approx(np.array([[0.001, 0.3], [0.017, 0.3], [0.05, 0.3]]))
    assert track.angle == pytest.approx(np.radians([0.0, 3.0, 9.0]))


def test_a_missing_unit_of_angles_is_explained(tmp_path):
    file = written(tmp_path, "t,angle\n" + "\n".join(f"{t},{4000 * t % 360}" for t in T))
    with pytest.raises(ValueError, match=r"has no unit of angle: write it behind .* --angle-unit deg, or angle_unit="):
        read_track(file)
    # a jump of a whole turn is none
    steps = np.diff(read_track(file, Reading(angle_unit="deg")).angle)
    assert steps == pytest.approx(np.radians(4000 / 240), rel=1e-9)


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
        ("a.csv", "t;right;up;left\n0;0,1;0,3;0\n1;0,2;0,3;0\n", "its columns are t, right, up, left; --column x=HEAD"),
        ("a.csv", "t,x,y\n0,00,0,1,0,3\n0,01,0,2,0,3\n0,02,0,3,0,3\n", "a row of 6 cells under 3 names: a comma can divide"),
        ("a.xlsx", "PK", "save the sheet as CSV"),
        ("a.ods", "PK", "save the sheet as CSV"),
        ("hoop.TRZ", "<object/>", "is a project of Tracker: open it there and save its points with File, Export, Data"),
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
    with pytest.raises(InputError) as caught:
        hh.read_track(written(tmp_path, text, name=name))
    assert message in str(caught.value)
    assert str(caught.value).endswith(".")


def test_gigabytes_are_refused_unread(tmp_path):
    file = tmp_path / "a.csv"
    with file.open("wb") as stream:
        stream.truncate(3_000_000_000)  # sparse: no byte of it is on the disk
    with pytest.raises(ValueError, match="is larger than 500 MB"):
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
