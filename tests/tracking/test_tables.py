"""Tables of many programs: each sample is read right or asked about, an answer works when it is pasted, and random layouts of a
known record give this record or a refusal."""

import random
import re
import shlex
from datetime import datetime, timedelta
from functools import wraps

import numpy as np
import pytest

import hophoop as hh
from checkout import DATA
from cli_tools import run
from hophoop.scenario import InputError
from hophoop.tracking import Reading, read_track
from hophoop.tracking.dialects import COMMA_LANGUAGES, ENGLISH, OTHERS
from tracking.table_tools import assert_read, saved, table

SAMPLES = DATA / "tables"
OPTION = re.compile(r"--(?:column|unit|rate|centre|marker) (?:'[^']*'|[^\s',]*[^\s',.:])")


@pytest.fixture
def ask(monkeypatch):
    """Run `hophoop fit` up to the fit: the track, and the question that was asked instead, an empty text if none was."""

    read = []

    @wraps(hh.fit)
    def fit(tracks, **_):
        read.extend(tracks)
        raise InputError("The table is read.")

    monkeypatch.setattr("hophoop.fitting.fit", fit)

    def asked(file, words=()):
        found = run("fit --quiet --radius 0.3", file, *words)
        assert found.exit_code == 2, found.output
        return (read.pop(), "") if read else (None, " ".join(found.output.split()))

    return asked


def answered(ask, file):
    """Paste the first option of each question until there is a track: this one, and the options."""
    words = []
    for _ in range(4):
        track, question = ask(file, words)
        if track is not None:
            return track, words
        options = OPTION.findall(question.partition(": give ")[2].partition(" or --")[0])
        assert options, question
        words += [word for option in options for word in shlex.split(option)]
    raise AssertionError(f"{file.name} is asked about for ever: {words}")


# --- the samples -----------------------------------------------------------------------------------

READ = (
    "capstone.csv", "clock_hms.csv", "datetime_de.csv", "fps120.csv", "iso.csv", "kinovea.csv", "kinovea_stacked.txt",
    "loggerpro.csv", "thousands.txt", "tracker_theta_r.txt", "vernier.csv", "zeit.csv",
)  # fmt: skip
RATE = ("frames_only.csv", "sleap.csv")
PHONES = ("phone_merged.csv", "phyphox_gyro.csv")


def assert_the_record(track, step=1 / 120):
    """The second row of the computed motion, with noise of 1 mm."""
    assert track.t[1] == pytest.approx(step, rel=0.05)
    assert track.centre[1] == pytest.approx([0.0155, 0.3], abs=4e-3)
    assert track.marker[1] == pytest.approx([0.0575, 0.5675], abs=4e-3)


@pytest.mark.parametrize("name", READ)
def test_samples_are_read(name):
    track = read_track(SAMPLES / name)
    assert_the_record(track)
    assert (name == "tracker_theta_r.txt") == ("hub θr is the direction as seen from the axes" in " ".join(track.notes))


@pytest.mark.parametrize("name", RATE)
def test_numbers_of_frames_are_asked_about(name, ask):
    assert_the_record(read_track(SAMPLES / name, Reading(rate=120.0)))
    track, words = answered(ask, SAMPLES / name)
    assert words == ["--rate", "240"]
    assert_the_record(track, step=1 / 240)


@pytest.mark.parametrize("name", PHONES)
def test_the_gyroscope_of_a_phone_has_its_own_times(name):
    track = read_track(SAMPLES / name)
    assert track.t[0] == 0.0
    assert track.omega[0] == pytest.approx(6.34, abs=0.03)
    assert np.isnan(track.centre).all()


@pytest.mark.parametrize(
    ("name", "question", "answer"),
    [
        ("boot_ns.txt", "has no row of column names", "--column t=1 --unit t=ns --column omega=4 --unit omega=rad/s"),
        ("sensorlogger.csv", "has three axes without units, z, y, x", "--column omega=z --unit omega=rad/s"),
        ("lying_ms.csv", "with a step of 8.33e-06 s, which no camera or sensor has: give --unit t=s.", "--unit t=s"),
        ("two_runs_side.csv", "has several runs, or sensors with times of their own", "--column 't=Time (s) Run #1'"),
        ("deeplabcut.csv", "numbers of frames instead of times", "--rate 240 --unit x=0.0024 --unit y=-0.0024"),
    ],
)  # fmt: skip
def test_an_answer_works_when_it_is_pasted(name, question, answer, ask):
    assert question in ask(SAMPLES / name)[1]
    track, words = answered(ask, SAMPLES / name)
    assert words == shlex.split(answer)
    if "omega" in answer:
        assert np.diff(track.t) == pytest.approx(0.005)
        assert track.omega[0] == pytest.approx(6.3565, abs=1e-3)
    elif name == "deeplabcut.csv":
        assert np.nanmedian(np.hypot(*(track.marker - track.centre).T)) == pytest.approx(0.27, rel=0.1)
        assert track.angle[-1] - track.angle[0] > 1.5
    else:
        assert_the_record(track)


def test_the_second_run_and_its_marker(ask):
    track, question = ask(SAMPLES / "two_runs_side.csv", ["--column", "t=Time (s) Run #2"])
    assert not question
    assert track.centre[1] == pytest.approx([0.01201, 0.29909])
    assert track.marker[1] == pytest.approx([0.05138, 0.56709])
    assert read_track(SAMPLES / "two_runs_side.csv", Reading(columns={"t": "6"})).centre[1] == pytest.approx([0.01201, 0.29909])


# --- one kind of fault each ------------------------------------------------------------------------

T = np.arange(40) / 120.0
ANGLE = 0.1 + 6.3 * T + 3.0 * T**2
X, Y = 0.95 + 0.3 * ANGLE, np.full(40, 0.3)
LOAD_X, LOAD_Y = X + 0.18 * np.sin(ANGLE), Y + 0.18 * np.cos(ANGLE)
PLACES = (X, Y, LOAD_X, LOAD_Y)
FRAMES = np.arange(40)
HALF_A_DAY = "%I:%M:%S.%f %p"


def clock(seconds, form="%H:%M:%S.%f"):
    return (datetime(2026, 11, 20) + timedelta(seconds=seconds)).strftime(form)


@pytest.mark.parametrize(
    "times",
    [
        [clock(86399.9 + t) for t in T],  # past midnight
        [f"11/20/2026 {clock(43199.9 + t, HALF_A_DAY)}" for t in T],  # past noon
        [f"20/11/2026 {clock(46799.9 + t, HALF_A_DAY)}" for t in T],
        [f"2026-11-20 {clock(36900.0 + t)}+0100" for t in T],
        [f"20-Nov-2026 {clock(36900.0 + t)}" for t in T],
        [f"{60.0 * 15 + t:.6f}" for t in T],
        [clock(65.0 + t)[3:] for t in T],  # minutes and seconds of a film
    ],
)
def test_dates_and_clocks_are_seconds(tmp_path, times):
    track = read_track(table(tmp_path, "time,x,y,marker x,marker y", times, *PLACES))
    assert track.t - track.t[0] == pytest.approx(T, abs=2e-6)
    assert track.t[0] == pytest.approx(
        0.0 if times[0].count(":") == 2 else float(times[0].split(":")[-1]) + 60.0 * (":" in times[0])
    )


def test_clocks_that_count_frames_need_the_rate(tmp_path, ask):
    times = [f"00:00:{(50 + k) // 60:02d}:{(50 + k) % 60:02d}" for k in range(40)]
    file = table(tmp_path, "Time (hh:mm:ss:ff);x;y", times, X, Y, separator=";")
    track, words = answered(ask, file)
    assert words == ["--rate", "60"]
    assert_read(track, t=np.arange(40) / 60.0)
    assert ask(file, ["--rate", "25"])[1]


@pytest.mark.parametrize("head", ["t", "t (s)"])
@pytest.mark.parametrize(("factor", "unit"), [(1e3, "ms"), (1e6, "us"), (1e9, "ns"), (1 / 86400, "d")])
def test_a_step_that_nothing_has_is_asked_about(tmp_path, ask, factor, unit, head):
    times = [f"{46000.0 + factor * t:.15g}" for t in T] if unit == "d" else [f"{factor * t:.6f}" for t in T]
    track, words = answered(ask, table(tmp_path, f"{head},x,y,marker x,marker y", times, *PLACES))
    assert words == ["--unit", f"t={unit}"]
    assert track.t - track.t[0] == pytest.approx(T, rel=1e-3)


@pytest.mark.parametrize(
    ("t", "rate"),
    [
        (np.floor(100.0 * T) / 100.0, 120.0),  # rounded
        (T // 0.05 * 0.05 + (T % 0.05) / 100.0, 120.0),  # in bursts
        (np.floor(37.0 * T) / 37.0, 120.0),
    ],
)
def test_repeated_times_and_bursts_are_counted_by_a_rate(tmp_path, ask, t, rate):
    track, words = answered(ask, table(tmp_path, "t (s),x,y,marker x,marker y", t, *PLACES))
    assert words[0] == "--rate"
    assert float(words[1]) == pytest.approx(rate, rel=0.03)
    assert_read(track, t=np.arange(40) / float(words[1]))
    assert "The rows are counted" in track.notes[0]


@pytest.mark.parametrize(("rows", "rate"), [(FRAMES // 2, 60.0), (FRAMES - (FRAMES % 5 == 4), None)])
def test_copies_of_rows_are_left_out(tmp_path, rows, rate):
    fresh = np.unique(rows, return_index=True)[1]
    track = read_track(table(tmp_path, "t,x,y", T, X[rows], Y), Reading(rate=rate))
    assert "rows that repeat the one before are left out." in track.notes[0]
    assert_read(track, t=T[fresh], x=X[rows[fresh]])


def test_rows_that_are_equal_by_rounding_are_no_copies(tmp_path):
    assert_read(read_track(table(tmp_path, "t,x,y", T, np.round(0.5 * T, 2), Y)), t=T)


def test_a_gap_in_the_times_is_no_burst(tmp_path):
    t = np.where(T < 0.05, T, T + 0.1)[:20]
    assert_read(read_track(table(tmp_path, "t,x,y", t, X[:20], Y[:20])), t=t)


def test_numbers_of_frames_as_times_are_asked_about(tmp_path, ask):
    track, words = answered(ask, table(tmp_path, "t,x,y", map(str, range(40)), X, Y))
    assert words == ["--rate", "240"]
    assert_read(track, t=np.arange(40) / 240.0)


SPOTS = """LABEL,ID,TRACK_ID,QUALITY,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME
Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame
Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame
,,,(quality),(cm),(cm),(cm),(sec),"""


def test_objects_below_each_other_are_points(tmp_path, ask):
    rows = [
        f"ID{100 * k + n},{100 * k + n},{n},5.1,{100 * x[k]:.4f},{100 * y[k]:.4f},0.0,{T[k]:.6f},{k}"
        for k in range(40) for n, (x, y) in enumerate(((X, Y), (LOAD_X, LOAD_Y)))
    ]  # fmt: skip
    track, words = answered(ask, saved(tmp_path, "\n".join([SPOTS, *rows])))
    assert words == []
    assert "is taken for the centre" in track.notes[0]
    assert_read(track, t=T, x=X, marker_y=LOAD_Y)


def test_the_same_heads_twice_are_named_by_their_numbers(tmp_path, ask):
    file = table(tmp_path, "t,x,y,x,y", T, *PLACES)
    track, words = answered(ask, file)
    assert words == ["--column", "x=2", "--column", "y=3"]
    assert_read(track, x=X)
    numbers = {"x": "2", "y": "3", "marker_x": "4", "marker_y": "5"}
    assert_read(read_track(file, Reading(columns=numbers)), marker_x=LOAD_X)


def test_a_marker_alone_is_no_centre(tmp_path):
    track = read_track(table(tmp_path, "Zeit;Gewicht/0/X;Gewicht/0/Y", T, LOAD_X, LOAD_Y, separator=";"))
    assert np.isnan(track.centre).all()
    assert track.marker[:, 0] == pytest.approx(LOAD_X, abs=1e-6)


def test_axes_of_an_accelerometer_are_no_places(tmp_path, ask):
    rng = np.random.default_rng(1)
    noise = [9.8 * (k == 1) + rng.normal(scale=0.01, size=40) for k in range(3)]
    heads = "t,accelerometer x,accelerometer y,accelerometer z,gyroscope z (rad/s)"
    track = read_track(table(tmp_path, heads, T, *noise, 6.3 + 6.0 * T))
    assert np.isnan(track.centre).all()
    assert_read(track, omega=6.3 + 6.0 * T)
    _, question = ask(table(tmp_path, "t,x,y", T, *noise[:2]))
    assert "neither moves nor is at the height of the radius" in question
    assert ask(table(tmp_path, "t,x,y", T, X, Y))[1] == ""


@pytest.mark.parametrize(
    "head",
    [
        "t/s;x/cm;y/cm;φ (rad)",
        "Zeit t in s;Ort x in cm;Höhe y in cm;Winkel in rad",
        "Zeit/s;Ort x/cm;Ort y/cm;Winkel φ (rad)",
        "t;x (cm);y (cm);phi [rad]",
        "t;x (cm);y (cm);ángulo (rad)",
        "t;x (cm);y (cm);ϕ / rad",
        "Zeit;Nabe;;Winkel\ns;x in cm;y in cm;rad",
    ],
)
def test_heads_of_school_books(tmp_path, head):
    track = read_track(table(tmp_path, head, T, 100.0 * X, 100.0 * Y, ANGLE, separator=";"))
    assert_read(track, t=T, x=X, angle=ANGLE)


def test_errors_have_the_units_of_their_own_heads(tmp_path):
    head = "t (s),x (cm),y (cm),angle (turns),sigma_x (mm),sigma_y (mm),sigma_angle (deg)"
    given = np.ones((3, len(T))) * [[2.0], [3.0], [1.0]]
    track = read_track(table(tmp_path, head, T, 100.0 * X, 100.0 * Y, ANGLE / (2.0 * np.pi), *given))
    still = np.ones(len(T))
    assert_read(track, x=X, angle=ANGLE, sigma_x=0.002 * still, sigma_y=0.003 * still, sigma_angle=np.radians(1.0) * still)


def test_tracks_of_imagej_below_each_other_are_points(tmp_path):
    places = [(1, k + 1, *at) for k, at in enumerate(zip(X, Y, strict=True))]
    places += [(2, k + 1, *at) for k, at in enumerate(zip(LOAD_X, LOAD_Y, strict=True)) if k != 5]
    track = read_track(table(tmp_path, "Track n°,Slice n°,X,Y", *zip(*places, strict=True)), Reading(rate=120.0))
    assert_read(track, x=X)
    assert track.marker[:, 0] == pytest.approx(np.where(T[5] == T, np.nan, LOAD_X), abs=1e-6, nan_ok=True)


@pytest.mark.parametrize(
    "head",
    [
        "ms,gx,gy,gz",
        "sampleTimestamp_sinceReboot(ms),gyrX(deg/s),gyrY(deg/s),gyrZ(deg/s)",
        "temps (ms),Gyroscope (x),Gyroscope (y),Gyroscope (z)",
        "t (ms),Winkelgeschw. x (deg/s),Winkelgeschw. y (deg/s),Winkelgeschw. z (deg/s)",
        "t (ms),rotation rate x cal.,rotation rate y cal.,rotation rate z cal.",
    ],
)
def test_sensors_without_usual_names_are_asked_about_at_most_for_units(tmp_path, ask, head):
    rates = [0.1 + 0.0 * T, 360.0 + 340.0 * T, 0.1 * T]
    track, words = answered(ask, table(tmp_path, head, 1000.0 * T + 5e4, *rates))
    assert words[::2] == ["--unit"] * (len(words) // 2)
    assert track.t - track.t[0] == pytest.approx(T - T[0], abs=1e-6)
    assert_read(track, omega=np.radians(rates[1]))


@pytest.mark.parametrize("zero", ["０", "٠", "۰"])
def test_digits_of_other_scripts(tmp_path, zero):
    file = table(tmp_path, "t;x in cm;y in cm", T, 100.0 * X, 100.0 * Y, separator=";")
    head, _, body = file.read_text(encoding="utf-8").partition("\n")
    digits = {ord(str(k)): chr(ord(zero) + k) for k in range(10)}
    file.write_text(f"{head}\n{body.translate(digits)}", encoding="utf-8")
    assert_read(read_track(file), x=X)


@pytest.mark.parametrize("unit", ["", " (cm)", " (px)"])
def test_lengths_that_no_hoop_has_are_asked_about(tmp_path, ask, unit):
    size = {"": 100.0, " (cm)": 1e4, " (px)": 400.0}[unit]
    head = f"t,x{unit},y{unit},marker x{unit},marker y{unit},ruler_px"
    file = table(tmp_path, head, T, *(size * one for one in PLACES), Y)
    track, words = answered(ask, file)
    assert ("that in the table (ruler_px, about 0.3, if it is one)" in ask(file)[1]) == bool(unit)
    assert words[::2] == ["--unit", "--unit"]
    assert np.nanmedian(np.hypot(*(track.marker - track.centre).T)) == pytest.approx(0.18, rel=0.05)


@pytest.mark.parametrize(
    "head",
    [
        "# t x y marker_x marker_y",
        "#t\tx\ty\tmarker x\tmarker y",
        "#made by hand\n#t x y marker_x marker_y\n# the hoop of group 3 in the yard",
    ],
)
def test_comments_are_heads_where_they_are_the_only_ones(tmp_path, head):
    for lines in (head, "# a b c d e\nt x y marker_x marker_y"):
        assert_read(read_track(table(tmp_path, lines, T, *PLACES, separator=" ")), marker_x=LOAD_X)


def test_three_digits_after_a_comma_are_decimals_where_the_language_has_decimal_commas(tmp_path):
    cells = [[f"{100.0 * value:.3f}".replace(".", ",") for value in column] for column in (X, Y)]
    file = table(tmp_path, "frame\tMitte x (cm)\tMitte y (cm)", map(str, range(7, 47)), *cells, separator="\t")
    assert_read(read_track(file, Reading(rate=120.0)), x=X)


def test_each_word_has_one_meaning_in_one_language():
    languages = [ENGLISH, *COMMA_LANGUAGES.values(), *OTHERS.values()]
    words = [word for language in languages for those in language.values() for word in those.split("|")]
    assert len(words) == len(set(words))


# --- random layouts of a known record --------------------------------------------------------------

HEADS = (
    "t|x|y|marker_x|marker_y", "Time|hub x|hub y|tape x|tape y", "Zeit|Mittelpunkt_x|Mittelpunkt_y|Aufkleber_x|Aufkleber_y",
    "Temps|X moyeu|Y moyeu|X charge|Y charge", "Tiempo|centro x|centro y|carga x|carga y", "t|x1|y1|x2|y2", "t|x|y|x 2|y 2",
    "Time|hub/0/X|hub/0/Y|load/0/X|load/0/Y", "time|hub.x|hub.y|load.x|load.y",
    "Set 1: Time|Set 1: X|Set 1: Y|Set 1: X 2|Set 1: Y 2",
)  # fmt: skip
LENGTHS, TIMES = {"m": 1.0, "cm": 100.0, "mm": 1000.0}, {"s": 1.0, "ms": 1000.0}
FORMS = ("{} ({})", "{} [{}]", "{} / {}", "{}/{}", "{} in {}", "row")
TITLES = ("", "", "Our hoop\n", "Our hoop\nmade in class 9b\n")
SEPARATORS = (("\t", "."), ("\t", ","), (";", "."), (";", ","), (",", "."), (" ", "."), ("   ", ","))


def layout(seed):
    """The bytes of a table of the record, and options of its reading."""
    one_of = random.Random(seed).choice
    separator, decimal = one_of(SEPARATORS)
    blank = not separator.strip(" ")
    names, length, time, form = one_of(HEADS).split("|"), one_of([*LENGTHS]), one_of([*TIMES]), one_of(FORMS)
    form, frames = "{} [{}]" if blank else form, one_of(6 * [False] + [True])
    values = [TIMES[time] * T, *(LENGTHS[length] * one for one in PLACES)]
    texts = [[f"{value:.{6 if length == 'm' or not k else 3}f}" for value in one] for k, one in enumerate(values)]
    units, rate = [time, *4 * [length]], {}
    if frames:
        names[0], texts[0], units[0], rate = "frame", list(map(str, range(7, 47))), "", {"rate": 120.0}
    if not blank and one_of((False, True)):
        texts[3][17] = texts[4][17] = ""
    for name, cell in (("score" if blank else "remark", "0.98"), ("label", "run_1")):
        if one_of((False, True)):
            names, texts, units = [*names, name], [*texts, 40 * [cell]], [*units, ""]
    columns = []
    for name, unit, cells in zip(names, units, texts, strict=True):
        head = [name, f"({unit})" if unit else ""] if form == "row" else [form.format(name, unit) if unit else name]
        head[0] = head[0].replace(" ", "_", name.count(" ") * blank)
        columns.append([*head, *(cell.replace(".", decimal) for cell in cells)])
    random.Random(seed).shuffle(columns)
    quote, end = ('"', separator) if not blank and one_of((False, True)) else ("", "")
    lines = [separator.join(f"{quote}{cell}{quote}" for cell in row) + end for row in zip(*columns, strict=True)]
    above = one_of(("", "", "# exported by hand\n", "# a b c d e\n")) + one_of(TITLES)
    text = above + one_of(("\n", "\r\n")).join([*lines, *one_of(([], ["End of the data"]))])
    return text.encode(one_of(("utf-8", "utf-8-sig", "utf-16", "cp1252"))), rate


def test_random_layouts_are_read_right_or_refused(tmp_path):
    """Another record is never read; of these layouts at least 98 % are read."""
    file, refused = tmp_path / "random.csv", []
    for seed in range(150):
        data, rate = layout(seed)
        file.write_bytes(data)
        try:
            track = read_track(file, Reading(radius=0.3, **rate))
        except InputError as error:
            refused.append(str(error))
            continue
        assert track.t - track.t[0] == pytest.approx(T, abs=1e-5)
        assert_read(track, x=X, y=Y)
        there = np.isfinite(track.marker[:, 0])
        assert there.sum() >= 39
        assert track.marker[there] == pytest.approx(np.stack([LOAD_X, LOAD_Y], axis=-1)[there], abs=1e-5)
    assert len(refused) <= 3, refused
