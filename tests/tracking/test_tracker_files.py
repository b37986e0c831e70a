"""A hoop marked in Tracker: the text that it exports gives the hoop."""

import numpy as np
import pytest

import hophoop as hh
from hophoop.tracking import Reading, read_track
from tracking.tracker_files import text_export

RADIUS, RATE, SCALE = 0.3, 120.0, 400.0


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


HIDDEN = range(20, 24)


def text(marked, *style):
    n, centre, marker = marked
    gaps = np.where(np.isin(n, list(HIDDEN)), np.nan, 1.0)
    return text_export(n / RATE, {"hub": centre.T, "load": marker.T * gaps}, ["x", "y"], *style)


@pytest.mark.parametrize(("delimiter", "comma"), [("\t", False), (";", True), (",", False)])
def test_the_export_is_read_in_each_format(tmp_path, marked, delimiter, comma):
    _, centre, marker = marked
    file = tmp_path / "hoop.txt"
    file.write_text(text(marked, delimiter, comma), encoding="utf-8")
    track = read_track(file)
    assert track.centre == pytest.approx(centre, rel=1e-6, abs=1e-9)
    seen = [k for k in range(len(marker)) if k not in HIDDEN]
    assert track.marker[seen] == pytest.approx(marker[seen], rel=1e-6, abs=1e-9)
    assert [k for k, word in enumerate(track.state) if word == "no marker"] == list(HIDDEN)


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


@pytest.mark.compiled
def test_a_hoop_marked_by_hand_is_found(tmp_path, motion, marked):
    file = tmp_path / "hoop.txt"
    file.write_text(text(marked), encoding="utf-8")
    track = read_track(file, Reading(radius=RADIUS))
    fit = hh.fit(track, sigma=0.5 / SCALE)
    assert fit.good
    assert fit.values["gamma"] == pytest.approx(0.6, abs=4 * fit.error("gamma"))
    assert fit.values["mu_kinetic"] == pytest.approx(0.45, abs=4 * fit.error("mu_kinetic"))
    assert fit.values["origin_y"] == pytest.approx(0.0, abs=4 * fit.error("origin_y"))
