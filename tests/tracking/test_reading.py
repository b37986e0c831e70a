"""Tracks from tables as programs and people write them: each is read right, or refused in one sentence that says what to do."""

import json
import re

import numpy as np
import pytest

import hophoop as hh
from checkout import text_of
from hophoop.scenario import InputError
from hophoop.tracking import Camera, Reading, View, read_track
from hophoop.tracking.table import COLUMNS, track_of
from tracking.table_tools import assert_read, saved, table

T = np.arange(8) / 100.0
X = 0.95 + 1.7 * T
Y = np.full(8, 0.3)
ANGLE = 6.0 * T + 0.1
DEGREES = np.degrees(ANGLE)
LOAD_X, LOAD_Y = X + 0.27 * np.sin(ANGLE), Y + 0.27 * np.cos(ANGLE)
TWO_POINTS = (T, X, Y, LOAD_X, LOAD_Y)


# --- layouts, units, numbers -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("head", "separator", "form", "decimal"),
    [
        ('"Latest: Time (s)","Latest: X (m)","Latest: Y (m)","Latest: X 2 (m)","Latest: Y 2 (m)"', ",", "{:.6f}", "."),
        ("Data Set 1:Time(s),Data Set 1:X(m),Data Set 1:Y(m),Data Set 1:X 2(m),Data Set 1:Y 2(m)", ",", "{:.6f}", "."),
        ("Time (s) Run #1;x (m) Run #1;y (m) Run #1;load x (m) Run #1;load y (m) Run #1", ";", "{:.6f}", ","),
        ("# t x y marker_x marker_y", " ", "{:.18e}", "."),
        ("t / s; x / m; y / m; load x in m; load_y_m", ";", " {:.6f}", ","),
        ("t;x;y;load x;load y\n(sec);(Meters);(meter);(M);(m)", ";", "{:.6f}", ","),
        # Tracker: one point beside the other, a delimiter behind each cell
        ("#multi:\n\thub\t\tload\t\nt\tx\ty\tx\ty\t", "\t", "{:.6E}", "."),
        ("#multi:\n;hub;;load;\nt;x;y;x;y;", ";", "{:.6E}", ","),
        ("Our hoop with its load;;;;\nt;x;y;load_x;load_y", ";", "{:.6f}", ","),
    ],
)  # fmt: skip
def test_the_layouts_of_programs(tmp_path, head, separator, form, decimal):
    track = read_track(table(tmp_path, head, *TWO_POINTS, separator=separator, form=form, decimal=decimal), Reading(radius=0.3))
    assert_read(track, t=T, x=X, y=Y, marker_x=LOAD_X, marker_y=LOAD_Y)
    assert track.angle == pytest.approx(ANGLE, abs=1e-4)
    assert (track.placed, track.radius) == (False, 0.3)


@pytest.mark.parametrize(
    ("encoding", "head", "columns"),
    [
        ("utf-16", "t (ms),x (mm),y (mm),Winkel (Grad)", (1000 * T, 1000 * X, 1000 * Y, DEGREES)),
        ("utf-8", "time (Sec),x (CM),y (cm),theta (Deg)", (T, 100 * X, 100 * Y, DEGREES)),
        ("cp1252", "t,x,y,ángulo (rad)", (T, X, Y, ANGLE)),
    ],
)
def test_units_in_any_case_and_the_encodings_of_spreadsheets(tmp_path, encoding, head, columns):
    text = table(tmp_path, head, *columns).read_text(encoding="utf-8")
    track = read_track(saved(tmp_path, text, encoding))
    assert_read(track, t=T, x=X, angle=ANGLE)


@pytest.mark.parametrize(
    ("head", "rows", "said"),
    [
        ("t (ms)\tx (mm)\ty", ["0.50\t985\t300", "0.51\t1,002\t300", "0.52\t1,019\t300"], ("1,002 is read as 1002.",)),
        ("t (ms)\tx (mm)\ty", ["0\t985\t300", "10\t1,002\t300", "20\t1,019\t300"], ("1,002 is read as 1002.",)),
        ("t (ms)\tx (mm)\ty", ["0,50\t985\t300", "0,51\t1.002\t300", "0,52\t1.019\t300"], ("1.002 is read as 1002.",)),
        ("t (ms)\tx (mm)\ty", ["0.5\t985.0\t300", "0.6\t1,002.0\t300", "0.7\t1,019.0\t300"], ("1,002.0 is read as 1002.0.",)),
        ("t (ms)\tx (mm)\ty", ["0.50\t985\t300", "0.51\t1'002\t300", "0.52\t1 019\t300"], ()),
        # three decimals are no groups
        ("t\tx\ty", ["0,008\t0,985\t0,3", "0,016\t1,002\t0,3", "0,024\t1,019\t0,3"], ()),
        ("t\tx\ty", ["1.008\t0.985\t1.3", "1.016\t1.002\t1.3", "1.024\t1.019\t1.3"], ()),
        # signs and spaces of typesetters, and cells without a number
        ("t\tx (mm)\ty", ["0,00\t985\t\u2212300", "0,01\t1\u00a0002\t#N/A", "0,02\t 1019 \t300"], ()),
        ("t;x (mm);y", ["0:01:00,00;985;3", "0:01:00,01;1002;3", "0:01:00,02;1019;3"], ()),
        ("t,x (mm),y", ["1:00.00,985,3", "1:00.01,1002,3", "1:00.02,1019,3"], ()),
        ("t;x (mm);y", ["0,00;985;3", "0,01;1002;3;dark", "0,02;1019;3;;"],
         ("Columns of ours.csv that are not used: column 4.",)),
        ("t,x (cm),y,X Velocity (m/s),rejected x,sticker", ["1,98.5,0.3,1,5,1", "1.1,100.2,0.3,1,5,1", "1.2,101.9,0.3,1,5,1"],
         ("Columns of ours.csv that are not used: X Velocity (m/s), rejected x, sticker.",)),
        ("t,x (cm),y,remark", ['1,98.5,0.3,"dark, blurred"', '"1,1","100,2","0,3",', "1.2,101.9,0.3,"],
         ("Columns of ours.csv that are not used: remark.",)),
    ],
)  # fmt: skip
def test_numbers_as_people_write_them(tmp_path, head, rows, said):
    track = read_track(saved(tmp_path, "\n".join([head, *rows])))
    places = [0.985, np.nan if "#N/A" in rows[1] else 1.002, 1.019]
    assert track.centre[:, 0] == pytest.approx(places, nan_ok=True)
    assert track.notes == said
    assert (":" in rows[0]) == (track.t[0] == 60.0)


# --- columns and points ----------------------------------------------------------------------------


def test_a_table_marked_by_hand(tmp_path):
    """Pictures by number, a title with a comma, points over axes, y downwards in pixels, and remarks on some rows."""
    head = "Film 2231, 60 pictures a second\npicture\thub\t\tsticker\t\tremark\n\tx px\ty px\tx px\ty px"
    file = table(tmp_path, head, np.arange(312, 320), X, -Y, LOAD_X, -LOAD_Y, separator="\t")
    file.write_text(file.read_text() + "\tdark\n")
    with pytest.raises(InputError, match=r"numbers of frames instead of times; its columns are picture, hub x px, .* --rate"):
        read_track(file, Reading(radius=0.3))
    track = read_track(file, Reading(radius=0.3, rate=100.0, units={"x": "m", "y": "-m"}))
    assert_read(track, t=3.12 + T, x=X, y=Y, marker_x=LOAD_X, marker_y=LOAD_Y)


def test_the_second_point_may_be_the_centre(tmp_path):
    file = table(tmp_path, "t,x,y,x 2,y 2", T, LOAD_X, LOAD_Y, X, Y)
    track = read_track(file)
    assert_read(track, x=X)
    assert "x 2 is taken for the centre and x, which rises and falls more, for the marker" in track.notes[0]
    assert_read(read_track(file, Reading(marker="x 2")), marker_x=X)


def test_hidden_marks_and_frames_that_were_stepped_over(tmp_path):
    """With a step size of 2 Tracker still writes a row for every frame, in which every second has a time and nothing else."""
    rows = ["0\t0\t1\t0.5\t1", "1\t\t\t\t", "2\t1\t1\t\t", "3\t\t\t\t", "4\t2\t1\t2.5\t1"]
    track = read_track(saved(tmp_path, "\n".join(["\thub\t\tload\t", "t\tx\ty\tx\ty", *rows])))
    assert list(track.t) == [0, 2, 4]
    assert track.state == ("found", "no marker", "found")
    assert track.angle == pytest.approx([np.pi / 2, np.nan, np.pi / 2], nan_ok=True)


# --- angles, and the phone in the hoop -------------------------------------------------------------


@pytest.mark.parametrize("factor", [-1.0, np.pi / 180, 2.0])
def test_an_angle_that_contradicts_the_marker_is_noticed(tmp_path, factor):
    t = np.arange(100) / 100.0
    x, angle, head = 1.8 * t, 0.1 + 6.0 * t, "t,x,y,load_x,load_y,angle (deg)"
    columns = (t, x, np.full(100, 0.3), x + 0.27 * np.sin(angle), 0.3 + 0.27 * np.cos(angle))
    track = read_track(table(tmp_path, head, *columns, factor * np.degrees(angle)))
    assert track.angle == pytest.approx(angle, abs=1e-3)
    assert track.notes == ("angle (deg) contradicts the line from the centre to the marker: the marker is used.",)
    right = read_track(table(tmp_path, head, *columns, np.degrees(angle + 0.4)))  # a marker beside the load's line
    assert right.angle == pytest.approx(angle + 0.4, abs=1e-3)


@pytest.mark.parametrize(
    ("head", "separator", "decimal"),
    [
        ('"Time (s)","Gyroscope x (rad/s)","Gyroscope y (rad/s)","Gyroscope z (rad/s)","Absolute (rad/s)"', ",", "."),
        ('"Zeit (s)";"Gyroskop x (rad/s)";"Gyroskop y (rad/s)";"Gyroskop z (rad/s)";"Absolut (rad/s)"', ";", ","),
        ("time,wx (rad/s),wy (rad/s),wz (rad/s),all", ",", "."),
    ],
)
def test_a_phone_gives_its_angular_velocity(tmp_path, head, separator, decimal):
    omega = -6.0 - 10.0 * T
    columns = (T, 0.01 * omega, 0.1 + 0 * T, omega, np.abs(omega))
    file = table(tmp_path, head, *columns, separator=separator, form="{:.9E}", decimal=decimal)
    track = read_track(file)
    assert_read(track, omega=-omega)
    assert np.isnan([*track.angle, *track.centre[:, 0]]).all()
    assert set(track.state) == {"found"}
    names = [name.strip('"') for name in head.split(separator)]
    assert track.notes[0].startswith(f"The angular velocity is that of {names[3]}, the axis with the most rotation;")
    assert track.notes[1] == f"The sign of {names[3]} is reversed, for a hoop that rolls to the right."
    assert_read(read_track(file, Reading(columns={"omega": names[2]})), omega=[0.1] * 8)


def test_a_jump_of_a_whole_turn_is_none(tmp_path):
    file = table(tmp_path, "t,angle", T, 6000 * T % 360)
    assert np.diff(read_track(file, Reading(units={"angle": "deg"})).angle) == pytest.approx(np.radians(60.0), rel=1e-6)


def test_a_window_of_time(tmp_path):
    track = read_track(table(tmp_path, "t,x,y", T, X, Y), Reading(since=0.02, until=0.05))
    assert_read(track, t=[0.02, 0.03, 0.04, 0.05], x=X[2:6])
    assert track.state == ("no marker",) * 4


def test_the_table_of_the_docs_is_read(tmp_path):
    text = text_of("docs/film.md")
    rows = text.partition("```text\nt (s);")[2].partition("```")[0]
    track = read_track(saved(tmp_path, "t (s);" + rows))
    # a row without a mark is left out
    assert_read(track, t=[0.0, 0.008, 0.025], x=[0.001, 0.017, 0.05], y=[0.3] * 3, angle=np.radians([0.0, 3.0, 9.0]))


def test_a_saved_track_is_the_same(tmp_path):
    rng = np.random.default_rng(5)
    columns = {name: rng.normal(size=8) for name in COLUMNS if name != "t"}
    columns["x"][3] = columns["y"][3] = np.nan
    view = View(Camera(640, 360, 500.0, 0.01, -0.02), 200.0, -100.0, 3.0, 0.01, (-20.0, 90.0), 0.86, 1e-3, 1e-5, None)
    others = {"radius": 0.3, "slope": 0.02, "placed": True, "view": view, "source": "film.mp4", "notes": ("A note.",)}
    track = track_of(np.arange(8) / 240.0, columns, **others)
    track.save(tmp_path / "track.json")
    back = read_track(tmp_path / "track.json")
    np.testing.assert_equal(vars(back), vars(track))
    track.save(tmp_path / "track.csv")
    back = read_track(tmp_path / "track.csv")
    np.testing.assert_array_equal(back.centre, track.centre)
    np.testing.assert_array_equal(back.marker_error, track.marker_error)
    assert back.placed
    with pytest.raises(ValueError, match=r"must end in \.json or \.csv"):
        track.save(tmp_path / "track.xls")


# --- what goes wrong is one sentence ---------------------------------------------------------------


def rows(count, cells=3):
    """Some rows of numbers, in which only the first column grows."""
    return "".join(f"{k}{',1' * (cells - 1)}\n" for k in range(count))


TWICE = "which has two readings: save the table without signs"
RUNS = "t,x Run #1,y Run #1,x Run #2,y Run #2\n"


@pytest.mark.parametrize(
    ("name", "text", "message", "options"),
    [
        ("a.csv", "", "is empty", {}),
        ("a.csv", "1,2\n3,4\n", "has no row of column names", {}),
        ("a.csv", "0,1,3,1,5\n1,2,3,2,5\n2,3,3,3,5\n", "--column x=2 --column y=3 --column marker_x=4 --column marker_y=5", {}),
        ("a.csv", "t,x,y\n", "has no table", {}),
        ("a.csv", "t,x,y\na,b,c\n", "has no row of numbers", {}),
        ("a.csv", "x,y\n" + rows(3, 2), "has no column of times; its columns are x, y: give --rate 240", {}),
        ("a.csv", "frame,x,y\n" + rows(3), "numbers of frames instead of times; its columns are frame, x, y: give --rate", {}),
        ("a.csv", "t,x,y\n0.1,1,1\n0.2,1,1\n0.3,1,1", "has times, no numbers of frames: leave out --rate", {"rate": 100.0}),
        ("a.csv", "t,right,up\n" + rows(3), "its columns are t, right, up: give --column x=right --column y=up.", {}),
        ("a.csv", "t,x,y\n0,00,0,1,0,3\n0,01,0,2,0,3\n", "a row of 6 cells under 3 names: a comma can divide", {}),
        ("a.csv", "t,x\n" + rows(3, 2), "has a column x, but none for y; its columns are t, x.", {}),
        ("a.csv", "t,speed\n" + rows(3, 2), "has neither x and y, nor marker_x and marker_y, nor angle", {}),
        ("a.csv", "t,x,y\n" + rows(3), "has no column 'up'; its columns are t, x, y", {"columns": {"y": "up"}}),
        ("a.csv", RUNS + rows(3, 5), "has several runs, or sensors with times of their own: give --column 'x=x Run #1'", {}),
        (
            "a.txt",
            ",A,,B,\nt,x,y,x,y\n" + rows(3, 5),
            "points 'A', 'B', and which are the centre and the marker is open: give --centre A --marker B",
            {},
        ),
        ("a.txt", ",A,,B,\nt,x,y,x,y\n" + rows(3, 5), "no point 'C'; its points are 'A', 'B'", {"centre": "C"}),
        ("a.csv", "t,x,y,hub x,hub y\n" + rows(3, 5), "its points are one without a name, 'hub'", {"centre": "axle"}),
        ("a.csv", "t,angle\n" + rows(3, 2), "no unit of angle; known units are rad, deg and rev: give --unit angle=deg.", {}),
        ("a.csv", "t,omega\n" + rows(3, 2), "known units are rad/s, deg/s and rpm: give --unit omega=deg/s.", {}),
        (
            "a.csv",
            "t [h],x,y\n" + rows(3),
            "gives t [h] in an unknown unit; known units are s, ms, us, ns and min: give --unit t=s.",
            {},
        ),
        ("a.csv", "t,x,y\n" + rows(2), "has 2 rows; at least 3 are needed", {}),
        ("a.csv", "t,x,y\n" + rows(4), "has times from 0 to 3 s, of which 2 are in the window; at least 3", {"since": 1.5}),
        ("a.csv", "t,x,y\n0,1,1\n2,1,1\n1,1,1\n", "must have times that increase, which they do not in row 3", {}),
        ("a.csv", "t,x,y\n" + 2 * rows(4), "second starts with row 5 of the numbers, where the times start again", {}),
        ("a.csv", 2 * ("t,x,y\n" + rows(4)), "second starts with row 5 of the numbers, below the line 't,x,y'", {}),
        ("a.csv", "t,x,y\n0,1,1\n1,fast,1\n2,1,1\n", "has 'fast' in column x, row 2 below", {}),
        ("a.csv", "t,x,y\n0,1,inf\n1,1,1\n2,1,1\n", "has 'inf' in column y, row 1 below", {}),
        ("a.csv", "t,x,y\n0,nan,nan\n1,nan,nan\n2,,\n", "has neither x and y, nor marker_x", {}),
        # t = 1.000 or 1000
        ("a.csv", "t\tx\ty\n1,000\t1,002\t1,300\n1,010\t1,019\t1,300\n", TWICE, {}),
        ("a.csv", "t\tx\ty\n0\t985\t300\n10\t1.002\t300\n", TWICE, {}),
        ("a.csv", "t\tx\ty\n0.50\t985\t0,3\n0.51\t1.002\t0,3\n", TWICE, {}),
        ("a.csv", "frame\tx (cm)\ty (cm)\n7\t95,300\t30,000\n8\t97,000\t30,000\n9\t98,700\t30,000", TWICE, {"rate": 120.0}),
        (
            "a.csv",
            "t,x,y,t,x,y\n0,1,1,0,1,1\n1,1,1,2,1,1\n2,1,1,4,1,1\n",
            "has other times for some of the columns that are named",
            {"columns": {"x": "2", "y": "6"}},
        ),
        ("a.txt", "t x y\n0 1 1\n1 1\n2 1 1\n", "has a cell too few in row 2 of the numbers", {}),
        ("a.md", "t,x,y\n0,1,1\n", "must end in .json, .csv", {}),
        ("a.csv", "\x89PNG\r\n\x1a\n\x00\x00", "is not text", {}),
        ("a.xlsx", "PK", "save the sheet as CSV", {}),
        ("hoop.TRZ", "<object/>", "is a project of Tracker: open it there and save its points with File, Export, Data", {}),
        ("a.json", "{", "is not valid JSON", {}),
        ("a.json", "[1]", "is not a track of hophoop", {}),
        ("a.json", "{}", "columns, units and rate are for tables", {"rate": 100.0}),
        ("a.json", json.dumps({"schema": "hophoop-track/1"}), "is incomplete: 'columns'", {}),
    ],
)
def test_bad_files(tmp_path, name, text, message, options):
    with pytest.raises(InputError, match=re.escape(message)) as caught:
        hh.read_track(saved(tmp_path, text, name=name), Reading(**options))
    assert str(caught.value).endswith(".")


def test_gigabytes_are_refused_unread_and_what_is_absent(tmp_path):
    file = tmp_path / "a.csv"
    with file.open("wb") as stream:
        stream.truncate(3_000_000_000)  # sparse: no byte of it is on the disk
    with pytest.raises(ValueError, match="is larger than 500 MB"):
        read_track(file)
    with pytest.raises(FileNotFoundError):
        read_track(tmp_path / "absent.csv")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"radius": -1.0}, "radius = "),
        ({"radius": 1e-40}, r"radius = 1e-40 must be from 1e-30 to 1e\+30"),
        ({"units": {"speed": "m"}}, "units cannot name 'speed'; it can name frame, t, x, y"),
        ({"units": {"t": "furlong"}}, "units t = 'furlong' must be s, ms, us, ns and min, or a number other than 0"),
    ],
)
def test_bad_readings(values, message):
    with pytest.raises(ValueError, match=message):
        Reading(**values)
