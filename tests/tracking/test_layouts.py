"""One motion in the layouts that programs write: each is read right, or refused in one sentence that says what to do."""

import numpy as np
import pytest

from hophoop.scenario import InputError
from hophoop.tracking import Reading, read_track

T = np.arange(8) / 100.0
X = 0.95 + 1.7 * T
Y = np.full(8, 0.3)
ANGLE = 6.0 * T + 0.1
LOAD_X, LOAD_Y = X + 0.27 * np.sin(ANGLE), Y + 0.27 * np.cos(ANGLE)
TWO_POINTS = (T, X, Y, LOAD_X, LOAD_Y)


def written(tmp_path, head, columns, separator=",", form="{:.5f}", decimal="."):
    """A file of a head, which may have several lines, and of rows of numbers in one form or one per column."""
    forms = [form] * len(columns) if isinstance(form, str) else form
    rows = (
        separator.join(one.format(value).replace(".", decimal) for one, value in zip(forms, row, strict=True))
        for row in zip(*columns, strict=True)
    )
    file = tmp_path / "ours.csv"
    file.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("head", "separator", "form", "decimal"),
    [
        ('"Latest: Time (s)","Latest: X (m)","Latest: Y (m)","Latest: X 2 (m)","Latest: Y 2 (m)"', ",", "{:.5f}", "."),
        ("Data Set 1:Time(s),Data Set 1:X(m),Data Set 1:Y(m),Data Set 1:X 2(m),Data Set 1:Y 2(m)", ",", "{:.5f}", "."),
        ("Time (s) Run #1;x (m) Run #1;y (m) Run #1;load x (m) Run #1;load y (m) Run #1", ";", "{:.5f}", ","),
        ('"Time";"hub/0/X";"hub/0/Y";"load/0/X";"load/0/Y"', ";", '"{:.5f}"', ","),
        ("Zeit (s);Mitte_x (m);Mitte_y (m);Gewicht_x (m);Gewicht_y (m)", ";", "{:.5f}", ","),
        ("Temps (s);X moyeu (m);Y moyeu (m);X charge (m);Y charge (m)", ";", "{:.5f}", ","),
        ("Tiempo (s)\tcentro x (m)\tcentro y (m)\tcarga x (m)\tcarga y (m)", "\t", "{:.5f}", ","),
        ("t (s);x (m);y (m);mark_x (m);mark_y (m)", ";", "{:.5f}", ","),
        ("t;centre x;centre y;load x;load y", ";", "{:.5f}", ","),
        ("t x y marker_x marker_y", "   ", "{:.5f}", "."),
        ("# t x y marker_x marker_y", " ", "{:.18e}", "."),
        ("t,x1,y1,x2,y2", ",", "{:.5f}", "."),
        ("t (S),x (M),y (M),x 2 (m),y 2 (m)", ",", "{:.5f}", "."),
        ("t / s; x / m; y / m; load x in m; load_y_m", ";", " {:.5f}", ","),
        ("t;x;y;load x;load y\ns;m;m;m;m", ";", "{:.5f}", ","),
        ("t;x;y;load x;load y\n(sec);(Meters);(meter);(M);(m)", ";", "{:.5f}", ","),
        ("\thub\t\tload\t\nt\tx\ty\tx\ty\t", "\t", "{:.5f}", "."),
    ],
)  # fmt: skip
def test_the_layouts_of_programs(tmp_path, head, separator, form, decimal):
    track = read_track(written(tmp_path, head, TWO_POINTS, separator, form, decimal))
    assert track.t == pytest.approx(T)
    assert track.centre == pytest.approx(np.stack([X, Y], axis=-1), abs=1e-5)
    assert track.marker == pytest.approx(np.stack([LOAD_X, LOAD_Y], axis=-1), abs=1e-5)
    assert track.angle == pytest.approx(ANGLE, abs=1e-4)


@pytest.mark.parametrize(
    ("head", "angle"),
    [
        ("t,x,y,angle\ns,m,m,deg", np.degrees(ANGLE)),
        ("t (ms),x (mm),y (mm),Winkel (Grad)", np.degrees(ANGLE)),
        ("time (Sec),x (CM),y (cm),theta (Deg)", np.degrees(ANGLE)),
        ("t,x,y,θ (°)", np.degrees(ANGLE)),
        ("t,x,y,ángulo (rad)", ANGLE),
    ],
)
def test_units_in_any_case_and_in_a_row_of_their_own(tmp_path, head, angle):
    metre = 1000.0 if "(mm)" in head else 100.0 if "(cm)" in head else 1.0
    second = 1000.0 if "(ms)" in head else 1.0
    track = read_track(written(tmp_path, head, (T * second, X * metre, Y * metre, angle)))
    assert track.t == pytest.approx(T)
    assert track.centre[:, 0] == pytest.approx(X, abs=1e-5)
    assert track.angle == pytest.approx(ANGLE, abs=1e-5)


def test_the_second_point_may_be_the_centre(tmp_path):
    file = written(tmp_path, "t,x,y,x 2,y 2", (T, LOAD_X, LOAD_Y, X, Y))
    track = read_track(file)
    assert track.centre[:, 0] == pytest.approx(X, abs=1e-5)
    assert "x 2 is taken for the centre and x, which rises and falls more, for the marker" in track.notes[0]
    asked = read_track(file, Reading(marker="x 2"))
    assert asked.marker[:, 0] == pytest.approx(X, abs=1e-5)


def test_numbers_of_frames_need_the_rate(tmp_path):
    file = written(tmp_path, "frame,x,y", (np.arange(8), X, Y), form=("{:.0f}", "{:.5f}", "{:.5f}"))
    assert read_track(file, Reading(rate=100.0)).t == pytest.approx(T)
    with pytest.raises(InputError, match=r"has numbers of frames instead of times: its columns are frame, x, y; .*--rate 240"):
        read_track(file)
    without = written(tmp_path, "x,y", (X, Y))
    assert read_track(without, Reading(rate=100.0)).t == pytest.approx(T)
    with pytest.raises(InputError, match="has times, no numbers of frames: leave out --rate"):
        read_track(written(tmp_path, "t,x,y", (T, X, Y)), Reading(rate=100.0))


def test_times_of_a_clock(tmp_path):
    file = written(tmp_path, "time;x;y", (T, X, Y), ";", ("0:01:0{:.2f}", "{:.5f}", "{:.5f}"), ",")
    assert read_track(file).t == pytest.approx(60.0 + T)
    file = written(tmp_path, "time,x,y", (T, X, Y), form=("1:0{:.2f}", "{:.5f}", "{:.5f}"))
    assert read_track(file).t == pytest.approx(60.0 + T)


def test_signs_and_spaces_of_typesetters(tmp_path):
    text = "t\tx (mm)\ty (mm)\n0,00\t\u22121\u00a0002\t300\n0,01\t\u2212985\t#N/A\n0,02\t \u2212970 \t300\n0,03\t-955\t300\n"
    file = tmp_path / "ours.txt"
    file.write_text(text, encoding="utf-8")
    track = read_track(file)
    assert track.centre[:, 0] == pytest.approx([-1.002, np.nan, -0.970, -0.955], nan_ok=True)


# --- digits in groups ------------------------------------------------------------------------------


TWICE = r"has the number 1[.,]00\d, which has two readings: save the table without signs"


@pytest.mark.parametrize(
    ("head", "rows", "said"),
    [
        ("t (ms)\tx (mm)\ty", ["0.50\t985\t300", "0.51\t1,002\t300", "0.52\t1,019\t300"], "1,002 is read as 1002."),
        ("t (ms)\tx (mm)\ty", ["0\t985\t300", "10\t1,002\t300", "20\t1,019\t300"], "1,002 is read as 1002."),
        ("t (ms)\tx (mm)\ty", ["0,50\t985\t300", "0,51\t1.002\t300", "0,52\t1.019\t300"], "1.002 is read as 1002."),
        ("t (ms)\tx (mm)\ty", ["0.5\t985.0\t300", "0.6\t1,002.0\t300", "0.7\t1,019.0\t300"], "1,002.0 is read as 1002.0."),
        ("t (ms)\tx (mm)\ty", ["0.50\t985\t300", "0.51\t1'002\t300", "0.52\t1 019\t300"], None),
        # three decimals are no groups
        ("t\tx\ty", ["0,008\t0,985\t0,3", "0,016\t1,002\t0,3", "0,024\t1,019\t0,3"], None),
        ("t\tx\ty", ["1.008\t0.985\t1.3", "1.016\t1.002\t1.3", "1.024\t1.019\t1.3"], None),
        # t = 1.000 or 1000
        ("t\tx (mm)\ty", ["1,000\t1,002\t1,300", "1,010\t1,019\t1,300", "1,020\t1,036\t1,300"], TWICE),
        ("t\tx (mm)\ty", ["0\t985\t300", "10\t1.002\t300", "20\t1.019\t300"], TWICE),
        ("t\tx (mm)\ty", ["0.50\t985\t0,3", "0.51\t1.002\t0,3", "0.52\t1.019\t0,3"], TWICE),
    ],
)
def test_digits_in_groups_are_recognized_or_refused(tmp_path, head, rows, said):
    file = tmp_path / "ours.txt"
    file.write_text("\n".join([head, *rows]), encoding="utf-8")
    if said == TWICE:
        with pytest.raises(InputError, match=said):
            read_track(file)
        return
    track = read_track(file)
    assert track.centre[:, 0] == pytest.approx([0.985, 1.002, 1.019])
    assert track.notes == (() if said is None else (said,))


# --- columns by name -------------------------------------------------------------------------------


def test_any_column_by_name(tmp_path):
    head = "Video: clock (s),Video: across (cm),Video: up (cm),Video: turned (deg)"
    file = written(tmp_path, head, (T, 100 * X, 100 * Y, np.degrees(ANGLE)))
    labels = dict(zip(("t", "x", "y", "angle"), head.split(","), strict=True))
    track = read_track(file, Reading(columns=labels))
    assert track.t == pytest.approx(T)
    assert track.centre == pytest.approx(np.stack([X, Y], axis=-1), abs=1e-6)
    assert track.angle == pytest.approx(ANGLE, abs=1e-6)
    with pytest.raises(InputError, match=r"has no column 'up': its columns are Video: clock \(s\), Video: across \(cm\), "):
        read_track(file, Reading(columns={"y": "up"}))
    with pytest.raises(InputError, match="columns cannot name 'speed'; it can name frame, t, x, y"):
        Reading(columns={"speed": "up"})


def test_two_runs_in_one_table_are_asked_for(tmp_path):
    head = "Time (s),x (m) Run #1,y (m) Run #1,x (m) Run #2,y (m) Run #2"
    file = written(tmp_path, head, (T, X, Y, 2 * X, Y))
    with pytest.raises(InputError, match=r"has the columns x \(m\) Run #1 and x \(m\) Run #2 for x: name one by --column 'x=x"):
        read_track(file)
    track = read_track(file, Reading(columns={"x": "x (m) Run #2", "y": "y (m) Run #2"}))
    assert track.centre[:, 0] == pytest.approx(2 * X, abs=1e-5)


def test_velocities_are_no_positions(tmp_path):
    head = "t (s),X (m),Y (m),X Velocity (m/s),Y Velocity (m/s),Beschleunigung x (m/s²)"
    track = read_track(written(tmp_path, head, (T, X, Y, X, Y, X)))
    assert track.centre[:, 0] == pytest.approx(X, abs=1e-5)
    assert np.isnan(track.marker).all()


# --- angles ----------------------------------------------------------------------------------------


def test_a_direction_seen_from_the_axes_is_no_rotation(tmp_path):
    head = "\thub\t\t\tload\t\t\nt\tx\ty\tθr\tx\ty\tθr"
    columns = (T, X, Y, np.degrees(np.arctan2(Y, X)), LOAD_X, LOAD_Y, np.degrees(np.arctan2(LOAD_Y, LOAD_X)))
    track = read_track(written(tmp_path, head, columns, "\t"))
    assert track.angle == pytest.approx(ANGLE, abs=1e-4)
    assert track.notes == ("hub θr is the direction as seen from the axes, not the rotation of the hoop: it is not used.",)


@pytest.mark.parametrize("factor", [-180 / np.pi, 1.0, 360 / np.pi])
def test_an_angle_that_contradicts_the_marker_is_noticed(tmp_path, factor):
    t, angle = np.arange(100) / 100.0, 0.1 + 6.0 * np.arange(100) / 100.0
    x, y = 1.8 * t, np.full(100, 0.3)
    head = "t,x,y,load_x,load_y,angle (deg)"
    columns = (t, x, y, x + 0.27 * np.sin(angle), y + 0.27 * np.cos(angle), factor * angle)
    track = read_track(written(tmp_path, head, columns))
    assert track.angle == pytest.approx(angle, abs=1e-3)
    assert track.notes == ("angle (deg) contradicts the line from the centre to the marker: the marker is used.",)
    right = read_track(written(tmp_path, head, (*columns[:-1], np.degrees(angle + 0.4))))  # a marker beside the load's line
    assert right.angle == pytest.approx(angle + 0.4, abs=1e-3)


# --- the phone in the hoop -------------------------------------------------------------------------


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
    file = written(tmp_path, head, (T, 0.01 * omega, 0.1 + 0 * T, omega, np.abs(omega)), separator, "{:.9E}", decimal)
    track = read_track(file)
    assert track.omega == pytest.approx(-omega)
    assert np.isnan(track.angle).all()
    assert np.isnan(track.centre).all()
    assert set(track.state) == {"found"}
    axis = head.split(separator)[3].strip('"')
    assert track.notes[0].startswith(f"The angular velocity is that of {axis}, the axis with the most rotation;")
    assert track.notes[1] == f"The sign of {axis} is reversed, for a hoop that rolls to the right."
    named = read_track(file, Reading(columns={"omega": head.split(separator)[2].strip('"')}))
    assert named.omega == pytest.approx([0.1] * 8)


def test_a_unit_of_the_angular_velocity_is_asked_for(tmp_path):
    file = written(tmp_path, "t,omega", (T, np.degrees(6.0 + T)))
    with pytest.raises(InputError, match=r"has no unit of omega: .*--angle-unit deg"):
        read_track(file)
    assert read_track(file, Reading(angle_unit="deg")).omega == pytest.approx(6.0 + T)


# --- a window of time ------------------------------------------------------------------------------


def test_a_window_of_time(tmp_path):
    file = written(tmp_path, "t,x,y", (T, X, Y))
    track = read_track(file, Reading(since=0.02, until=0.05))
    assert track.t == pytest.approx([0.02, 0.03, 0.04, 0.05])
    assert track.centre[:, 0] == pytest.approx(X[2:6], abs=1e-5)
    assert track.state == ("no marker",) * 4
    with pytest.raises(InputError, match=r"ours\.csv has times from 0 to 0\.07 s, of which 2 are in the window; at least 3"):
        read_track(file, Reading(since=0.06))


def test_a_point_without_a_name_is_said_to_have_none(tmp_path):
    file = written(tmp_path, "t,x,y,hub x,hub y,rim x,rim y", (T, X, Y, X, Y, X, Y))
    with pytest.raises(InputError, match="its points are one without a name, 'hub', 'rim'"):
        read_track(file, Reading(centre="axle"))
