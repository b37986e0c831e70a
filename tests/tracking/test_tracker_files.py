"""A hoop marked in Tracker: its own files, and the text that it exports, say the same and give the hoop."""

import numpy as np
import pytest

import hophoop as hh
from hophoop.tracking import Reading, read_track
from tracking.tracker_files import text_export, trk, trz

RADIUS, RATE, SCALE = 0.3, 120.0, 400.0
TURN = 6.0  # of the axes against the picture, counterclockwise [degrees]
FIRST, START_MS = 7, 250.0
ORIGIN = np.array([150.0, 600.0])


@pytest.fixture(scope="module")
def motion():
    plane = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
    return hh.simulate(hh.Hoop.ideal(0.6, radius=RADIUS), plane, hh.Start.rolling(1.9, angle=0.1), duration=1.0)


@pytest.fixture(scope="module")
def marked(motion):
    """Frames, centres and markers as they are along the plane, with half a pixel of unsteady hand [m]."""
    rng = np.random.default_rng(4)
    n = np.arange(int(RATE * motion.duration))
    state = motion.at(n / RATE)
    centre = np.stack([state.x, state.height + RADIUS], axis=-1)
    marker = centre + 0.8 * RADIUS * np.stack([np.sin(state.angle), np.cos(state.angle)], axis=-1)
    return n, centre + rng.normal(0, 0.5 / SCALE, centre.shape), marker + rng.normal(0, 0.5 / SCALE, marker.shape)


def pixels(places):
    """Where Tracker's axes put places: rotated, scaled, moved; rows count downwards."""
    angle = np.radians(TURN)
    x, y = places[:, 0], places[:, 1]
    return ORIGIN + SCALE * np.stack([x * np.cos(angle) - y * np.sin(angle), -x * np.sin(angle) - y * np.cos(angle)], axis=-1)


HIDDEN = range(20, 24)


def project(marked, **options):
    n, centre, marker = marked
    hub = dict(zip((n + FIRST).tolist(), pixels(centre).tolist(), strict=True))
    load = {k: place for k, place in zip((n + FIRST).tolist(), pixels(marker).tolist(), strict=True) if k - FIRST not in HIDDEN}
    axes = {0: {"xorigin": ORIGIN[0], "yorigin": ORIGIN[1], "angle": TURN, "xscale": SCALE, "yscale": SCALE}}
    axes = {key: {name: float(value) for name, value in row.items()} for key, row in axes.items()}
    options = {"start_frame": FIRST, "start_ms": START_MS, "frames": 400} | options
    return trk({"hub": hub, "load": load}, axes, 1e3 / RATE, **options)


@pytest.mark.parametrize("ending", [".trk", ".trz"])
def test_a_project_says_where_all_is(tmp_path, marked, ending):
    file = tmp_path / f"hoop{ending}"
    if ending == ".trk":
        file.write_text(project(marked), encoding="utf-8")
    else:
        trz(file, "hoop", project(marked))
    track = read_track(file, Reading(radius=RADIUS))
    n, centre, marker = marked
    assert track.t == pytest.approx(1e-3 * START_MS + n / RATE, rel=1e-12)
    assert track.centre == pytest.approx(centre, abs=1e-12)
    seen = np.array([k not in HIDDEN for k in n])
    assert track.marker[seen] == pytest.approx(marker[seen], abs=1e-12)
    assert [k for k, word in enumerate(track.state) if word == "no marker"] == list(HIDDEN)


def test_axes_of_a_camera_that_moves_hold_from_their_frame_on(tmp_path, marked):
    n, centre, _ = marked
    shift = np.where(n >= 50, 30.0, 0.0)
    places = pixels(centre) + np.stack([shift, np.zeros(len(n))], axis=-1)
    axes = {k: {"xorigin": ORIGIN[0] + by, "yorigin": ORIGIN[1], "angle": TURN, "xscale": SCALE, "yscale": SCALE}
            for k, by in ((0, 0.0), (50, 30.0))}  # fmt: skip
    file = tmp_path / "moved.trk"
    axes = {key: {name: float(value) for name, value in row.items()} for key, row in axes.items()}
    file.write_text(trk({"hub": dict(zip(n.tolist(), places.tolist(), strict=True))}, axes, 1e3 / RATE), encoding="utf-8")
    assert read_track(file).centre == pytest.approx(centre, abs=1e-12)


@pytest.mark.parametrize(("delimiter", "comma"), [("\t", False), (";", True), (",", False), (" ", False)])
def test_the_export_says_the_same_as_the_project(tmp_path, marked, delimiter, comma):
    n, centre, marker = marked
    gaps = np.where(np.isin(n, list(HIDDEN)), np.nan, 1.0)
    file = tmp_path / "hoop.txt"
    masses = {"hub": centre.T, "load": marker.T * gaps}
    file.write_text(text_export(n / RATE, masses, ["x", "y"], delimiter, comma), encoding="utf-8")
    if delimiter == " ":
        with pytest.raises(ValueError, match=r"hoop\.txt"):
            read_track(file)
        return
    track = read_track(file)
    assert track.centre == pytest.approx(centre, rel=1e-6, abs=1e-9)
    assert track.state.count("no marker") == len(HIDDEN)


def test_frames_that_were_stepped_over_are_not_lost(tmp_path, marked):
    """With a step size of 2 Tracker still writes a row for every frame, in which every second has a time and nothing else."""
    n, centre, _ = marked
    gaps = np.where(n % 2 == 0, 1.0, np.nan)
    file = tmp_path / "hoop.txt"
    file.write_text(text_export(n / RATE, {"mass A": centre.T * gaps}, ["x", "y"]), encoding="utf-8")
    track = read_track(file)
    assert len(track.t) == len(n) // 2
    assert "lost" not in track.state
    assert track.t == pytest.approx(n[::2] / RATE, rel=1e-6)


def test_the_degrees_of_an_exported_angle_are_told_by_its_velocity(tmp_path, motion, marked):
    n, centre, _ = marked
    state = motion.at(n / RATE)
    degrees = np.degrees(state.angle)
    wrapped = (degrees + 180.0) % 360.0 - 180.0  # Tracker's θ jumps
    omega = np.array([np.nan, *np.gradient(state.angle, n / RATE)[1:-1], np.nan])
    file = tmp_path / "hoop.txt"
    columns = np.stack([*centre.T, wrapped, omega])
    file.write_text(text_export(n / RATE, {"mass A": columns}, ["x", "y", "θ", "ω"]), encoding="utf-8")
    assert read_track(file).angle == pytest.approx(state.angle, abs=2e-5)


@pytest.mark.compiled
def test_a_hoop_marked_by_hand_is_found(tmp_path, motion, marked):
    file = tmp_path / "hoop.trk"
    file.write_text(project(marked), encoding="utf-8")
    track = read_track(file, Reading(radius=RADIUS, sigma=0.5 / SCALE))
    fit = hh.fit(track)
    assert fit.good
    assert fit.values["gamma"] == pytest.approx(0.6, abs=4 * fit.error("gamma"))
    assert fit.values["mu_kinetic"] == pytest.approx(0.45, abs=4 * fit.error("mu_kinetic"))
    assert fit.values["origin_y"] == pytest.approx(0.0, abs=4 * fit.error("origin_y"))
