"""Where the hoop is in a film, against the motion from which the film was rendered by code of its own."""

import dataclasses
import functools
import re
import struct
from fractions import Fraction

import av
import numpy as np
import pytest

import hophoop as hh
from film_maker import TICKS, Film, article_like, frames, make, planes, project
from hophoop.tracking import Camera, Hints, overlay
from hophoop.tracking.circle import Circle, fit_circle, robust_circle
from hophoop.tracking.doubts import doubt_marker
from hophoop.tracking.ground import ground_line
from hophoop.tracking.video import pictures, sample_pictures

RADIUS = 0.3


def errors(track, motion, film):
    """Distance of the centre from where it was [pixel], and error of the angle [rad], at the track's own times."""
    state = motion.at(np.clip(track.t + film.first, 0.0, motion.duration))
    away = track.pixel - project(film, state.x, state.height + RADIUS)
    turned = track.angle - state.angle
    # the angle counts from the plane's normal, and from the turn in which the film begins
    return np.hypot(away[:, 0], away[:, 1]), turned - 2 * np.pi * np.round(np.nanmedian(turned) / (2 * np.pi))


@functools.cache
def tracked(film, path, **hints):
    return hh.track(path, RADIUS, Hints(exposure=film.shutter, row_delay=film.row_delay, **hints))


def test_centre_and_angle_through_hidden_markers_and_a_restless_background(films, motion):
    path, film = films("hidden")
    track = tracked(film, path)
    centre, angle = errors(track, motion, film)
    assert np.nanmax(centre) < 0.2
    assert np.sqrt(np.nanmean(angle**2)) < 3e-3
    # what is not there is marked, and nothing else
    away = [word == "lost" for word in track.state]
    assert [k for k, lost in enumerate(away) if lost] == list(range(30, 34))
    assert {k for k, word in enumerate(track.state) if word == "no marker"} >= set(range(14, 20))
    assert track.state.count("found") >= 30
    assert np.isnan(track.centre[30:34]).all()
    assert np.isnan(track.angle[14:20]).all()


def test_times_are_those_of_the_file_and_the_middle_of_the_exposure(films):
    path, film = films("short")
    track = tracked(film, path)
    from film_maker import frame_times

    assert track.t == pytest.approx(frame_times(film) + 0.5 * film.shutter, abs=1e-12)
    slow = hh.track(path, RADIUS, Hints(rate=240.0))
    assert slow.t == pytest.approx(np.arange(film.frames) / 240.0, abs=1e-12)


@pytest.mark.long
def test_a_lens_out_of_axis_with_a_rolling_shutter(films, motion):
    path, film = films("tilted")
    track = tracked(film, path)
    centre, angle = errors(track, motion, film)
    assert np.nanmax(centre) < 0.2
    assert np.sqrt(np.nanmean(angle**2)) < 4e-3
    camera = track.view.camera
    assert np.degrees([camera.tilt_x, camera.tilt_y]) == pytest.approx([6.0, -8.0], abs=1.0)
    # in metres: without the tilt the hoop would grow by a tenth on its way
    state = motion.at(track.t + film.first)
    x = track.centre[:, 0] - state.x
    assert np.ptp(x) < 4e-3
    assert np.ptp(track.centre[:, 1] - state.height - RADIUS) < 2e-3
    flat = hh.track(path, RADIUS, Hints(exposure=film.shutter, row_delay=film.row_delay, tilt=(0.0, 0.0)))
    off = flat.centre[flat.found, 0] - state.x[flat.found]
    assert np.ptp(off) > 10 * np.ptp(x)


@pytest.mark.long
def test_a_rolling_shutter_is_put_right(films, motion):
    path, film = films("tilted")
    with_delay, without = tracked(film, path), hh.track(path, RADIUS, Hints(exposure=film.shutter))
    # the times differ by the row of the centre times the delay
    assert with_delay.t - without.t == pytest.approx(film.row_delay * with_delay.pixel[:, 1], rel=0.02)
    good, bad = (errors(track, motion, film) for track in (with_delay, without))
    assert np.nanmean(bad[0]) > 3 * np.nanmean(good[0])
    # the marker's row is exposed at another time than the centre's
    assert abs(np.nanmean(bad[1])) > 3 * abs(np.nanmean(good[1]))


@pytest.mark.long
def test_a_light_hoop_cut_by_the_edge_on_a_picture_that_is_not_level(films, motion):
    path, film = films("light")
    track = tracked(film, path)
    centre, angle = errors(track, motion, film)
    assert track.found.all()
    assert np.nanmax(centre) < 0.25
    # θ counts from the plane's normal, which the camera's roll does not change
    assert np.sqrt(np.nanmean(angle**2)) < 5e-3
    # a level line rises in a picture of a camera that is turned the other way
    assert np.degrees(track.slope) == pytest.approx(film.roll_deg, abs=0.2) or np.degrees(track.slope) == pytest.approx(
        -film.roll_deg, abs=0.2
    )
    leveled = tracked(film, path, level=-track.slope)
    assert leveled.slope == pytest.approx(0.0, abs=4e-3)


def test_errors_are_as_large_as_said(films, motion):
    path, film = films("hidden")
    track = tracked(film, path)
    state = motion.at(track.t + film.first)
    x = track.centre[:, 0] - state.x
    pull = (x - np.nanmean(x)) / track.centre_error[:, 0]
    assert 0.2 < np.nanstd(pull) < 2.0
    _, angle = errors(track, motion, film)
    assert 0.2 < np.nanstd(angle / track.angle_error) < 2.5


def test_the_scale_comes_from_the_radius(films):
    path, film = films("short")
    one, two = tracked(film, path), hh.track(path, 2 * RADIUS, Hints(exposure=film.shutter))
    assert one.view.scale == pytest.approx(film.scale, rel=2e-3)
    assert two.centre == pytest.approx(2 * one.centre, nan_ok=True)


@pytest.mark.long
def test_hints_are_followed(films, motion):
    path, film = films("short")
    track = tracked(film, path, marker_color="red", ring="dark")
    assert np.nanmax(errors(track, motion, film)[0]) < 0.2
    u, v = track.pixel[5]
    pointed = tracked(film, path, centre=(u + 2, v - 2), rim=40.0, at=track.t[5])
    assert np.nanmax(errors(pointed, motion, film)[0]) < 0.2
    bare = tracked(film, path, marker_color="none")
    assert set(bare.state) == {"no marker", "lost"}
    below = tracked(film, path, ground=(0.0, 170.0, 319.0, 170.0), slope=0.1)
    assert below.slope == 0.1
    assert np.nanmedian(below.centre[:, 1]) == pytest.approx(RADIUS, abs=2e-3)
    with pytest.raises(ValueError, match="show no rim in the frame"):
        tracked(film, path, centre=(280.0, 40.0), rim=25.0)
    with pytest.raises(ValueError, match="no patch of that colour"):
        tracked(film, path, marker_color="cyan")


def test_what_was_found_is_drawn_where_it_is(films, tmp_path):
    path, film = films("short")
    track = tracked(film, path)
    seen = []
    overlay(path, track, tmp_path / "over.mp4", tmp_path / "page.html", lambda done, total: seen.append((done, total)))
    assert seen[-1] == (18, 18)
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert page.count("data:image/jpeg") >= 9
    overlay(path, dataclasses.replace(track, source="<script>.mp4"), page=tmp_path / "named.html")
    named = (tmp_path / "named.html").read_text(encoding="utf-8")
    assert named.count("Track of &lt;script&gt;.mp4") == 2
    assert "<script" not in named
    drawn = list(pictures(tmp_path / "over.mp4"))
    assert len(drawn) == 18
    place = track.view.to_picture(np.array([[track.centre[0, 0], track.centre[0, 1] + RADIUS]]), RADIUS)[0]
    row, column = round(place[1]), round(place[0])
    # the rim is yellow: much red, little blue
    assert drawn[0].blue[row // 2, column // 2] < 100
    assert next(iter(pictures(path))).blue[row // 2, column // 2] > 108
    # a frame without hoop has a red edge
    assert drawn[13].red[0, 100] > 180


def test_memory_does_not_grow_with_length(films):
    path, _ = films("short")
    few = sample_pictures(path, None, fewest=2, most=3)
    assert 3 <= len(few) <= 6
    steps = np.diff([one.t for one, _ in few])
    assert all(after is not None and after.t > one.t for one, after in few[:-1])
    assert steps.max() < 1.8 * steps.min()


# --- what goes wrong is one sentence ---------------------------------------------------------------


def nothing(tmp_path, busy=True, frames=12):
    film = Film(size=(320, 192), frames=frames, busy=busy, without=((0, frames),), samples=1)
    return make(tmp_path / "empty.mp4", article_like(duration=0.2), film)


def test_a_film_without_a_marker_is_doubted(tmp_path):
    """A film of `hophoop animate` has a black load and coloured arrows, but no marker."""
    look = hh.animate.Look(size=(1280, 720), camera="hold")
    hh.animate.film(hh.simulate(hh.Scenario(duration=2.0)), tmp_path / "hold.mp4", hh.animate.Timing(fps=30), look)
    assert hh.track(tmp_path / "hold.mp4", radius=1.0).notes[0].startswith("Doubtful: the ")


@pytest.mark.parametrize(
    ("turned", "visible", "doubt"),
    [(1.0, 1.0, None), (0.3, 1.0, None), (0.05, 1.0, "by 4.0 radii .* turns by 0.20 rad"), (1.0, 0.4, "only 16 of 40 frames")],
)
def test_a_marker_is_doubted_for_a_reason(turned, visible, doubt):
    x = np.linspace(0.0, 4.0, 40)
    said = doubt_marker(x, np.where(np.arange(40) < visible * 40, turned * x, np.nan))
    assert len(said) == (doubt is not None)
    assert doubt is None or re.search(doubt, said[0])


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"busy": False}, r"empty\.mp4 shows no hoop that could be followed"),
        ({"busy": True}, "shows a circle that does not move"),
        ({"frames": 2}, "has 2 frames; tracking needs at least 3"),
    ],
)
def test_a_film_without_a_hoop_is_refused(tmp_path, how, message):
    with pytest.raises(ValueError, match=message):
        hh.track(nothing(tmp_path, **how), RADIUS)


def test_files_that_are_no_films(tmp_path):
    text = tmp_path / "film.mp4"
    text.write_text("no film at all")
    with pytest.raises(ValueError, match=r"film\.mp4 cannot be read as a video: Invalid data"):
        hh.track(text, RADIUS)
    with pytest.raises(FileNotFoundError):
        hh.track(tmp_path / "absent.mp4", RADIUS)
    vast = tmp_path / "vast.mp4"
    with vast.open("wb") as stream:
        stream.truncate(5_000_000_000)  # sparse: no byte of it is on the disk
    with pytest.raises(ValueError, match=r"vast\.mp4 cannot be read as a video"):
        hh.track(vast, RADIUS)
    whole = nothing(tmp_path).read_bytes()
    cut = tmp_path / "cut.mp4"
    cut.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(ValueError, match=r"cut\.mp4"):
        hh.track(cut, RADIUS)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"radius": 0.0}, "radius = 0.0 must be a number above 0"),
        ({"radius": float("nan")}, "radius = nan must be"),
        ({"marker_color": "gray"}, "marker_color = 'gray' must be auto, none, red"),
        ({"marker_color": "#888888"}, "too near to gray"),
        ({"ring": "blue"}, "ring = 'blue' must be auto, dark or light"),
        ({"centre": (1.0, 2.0)}, "rim is missing"),
        ({"ground": (1.0, 2.0)}, "ground = .* must be 4 numbers"),
        ({"rate": -1.0}, "rate = -1.0 must be a number above 0"),
        ({"exposure": 2.0}, "exposure = 2.0 must be from 0 to 1 s"),
        ({"row_delay": 1.0}, "row_delay = 1.0"),
        ({"tilt": (1.0, 0.0)}, "tilt"),
        ({"slope": 2.0}, "slope = 2.0 must be between"),
    ],
)
def test_bad_values(films, values, message):
    path, _ = films("short")
    radius = values.pop("radius", RADIUS)
    with pytest.raises(ValueError, match=message):
        hh.track(path, radius, Hints(**values))


# --- the pieces ------------------------------------------------------------------------------------


def test_a_camera_there_and_back_and_a_tilt_by_hand():
    camera = Camera(640, 360, 500.0, 0.1, -0.2)
    points = np.random.default_rng(1).uniform(-200, 200, (40, 2))
    assert camera.to_plane(camera.to_picture(points)) == pytest.approx(points, abs=1e-9)
    # turned about the vertical axis alone: columns shrink by the cosine and by what lies further away
    turned = Camera(640, 360, 500.0, 0.0, 0.3)
    column, row = turned.to_picture(np.array([100.0, 0.0]))
    assert row == pytest.approx(179.5)
    assert column - 319.5 == pytest.approx(500 * 100 * np.cos(0.3) / (500 - 100 * np.sin(0.3)))
    straight = Camera(640, 360, 500.0)
    assert straight.to_picture(np.array([3.0, 4.0])) == pytest.approx([322.5, 175.5])


def test_a_circle_by_least_squares_is_the_one_that_was_drawn():
    rng = np.random.default_rng(2)
    around = rng.uniform(0, 2 * np.pi, 200)
    points = [30.0, -12.0] + (50.0 + rng.normal(0, 0.1, 200))[:, None] * np.stack([np.cos(around), np.sin(around)], axis=-1)
    x, y, radius, off = fit_circle(points)
    assert (x, y, radius) == pytest.approx((30.0, -12.0, 50.0), abs=0.03)
    # the normal equations, of the squares of the distances
    squares = (radius + off) ** 2 - radius**2
    assert np.abs(points.T @ squares).max() < 1e-6
    assert abs(squares.sum()) < 1e-6


def test_a_robust_circle_does_not_mind_strangers():
    rng = np.random.default_rng(3)
    around = rng.uniform(0, 2 * np.pi, 300)
    size = 60.0 + rng.normal(0, 0.15, 300)
    size[:100] += rng.uniform(0.5, 4, 100)
    points = size[:, None] * np.stack([np.cos(around), np.sin(around)], axis=-1)
    fit = robust_circle(points, Circle(1.0, -1.0, 60.0), 6.0, None)
    assert fit.circle == pytest.approx((0.0, 0.0, 60.0), abs=0.05)
    assert not fit.inside[size > 62.0].any()
    assert np.sqrt(fit.covariance[0, 0]) == pytest.approx(0.15 * np.sqrt(2 / 200), rel=0.5)


def test_the_ground_is_under_the_lowest_places():
    rng = np.random.default_rng(4)
    x = np.linspace(0, 500, 200)
    y = 40 + 0.03 * x + rng.normal(0, 0.05, 200)
    y[60:150] += 30 * np.sin(np.linspace(0, np.pi, 90))  # a hop
    line = ground_line(np.stack([x, y], axis=-1), np.full(200, 0.05), 100.0)
    assert np.tan(line.angle) == pytest.approx(0.03, abs=1e-4)
    assert line.y - np.tan(line.angle) * line.x == pytest.approx(40.0, abs=0.05)
    still = ground_line(np.stack([rng.normal(0, 1, 50), np.full(50, 7.0)], axis=-1), np.full(50, 0.05), 100.0)
    assert (still.angle, still.directed) == (0.0, False)


# --- the whole claim, at the size of a phone's film ------------------------------------------------

BIG = Film(size=(1280, 720), scale=330.0, origin=(120.0, 600.0), focal=1150.0, frames=60, marker_size=0.04, busy=True)


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        {"rate": 240.0},
        {"rate": 120.0, "shutter": 1 / 1000},
        {"rate": 60.0, "shutter": 1 / 1000},
        {"rate": 30.0, "shutter": 1 / 500, "frames": 30},
        {"first": 0.35, "uneven": 0.3},
        {"tilt_deg": (7.0, -7.1), "first": 0.2, "frames": 120, "busy": False},
        {"row_delay": 1e-5, "first": 0.3},
        {"origin": (10.0, 640.0)},
        {"hidden": ((10, 25),), "without": ((40, 50),)},
        {"crf": 26},
    ],
    ids=str,
)
def test_films_as_a_phone_takes_them(tmp_path, motion, change):
    film = dataclasses.replace(BIG, **change)
    path = make(tmp_path / "film.mp4", motion, film)
    track = tracked(film, path)
    centre, angle = errors(track, motion, film)
    centre, angle = (np.where(track.t + film.first < motion.duration, one, np.nan) for one in (centre, angle))
    assert np.nanmax(centre) < 0.2
    # coarse coding smears the marker; frames without it have no angle
    coarse = film.crf > 20
    assert np.sqrt(np.nanmean(angle**2)) < (2e-3 if coarse else 1.5e-3)
    known = angle[np.isfinite(angle)]
    assert (np.abs(known) < 3e-3).mean() > (0.9 if coarse else 0.97)


# --- what a player does, and films whose times are wrong -------------------------------------------


SHORT = Film(size=(320, 192), scale=130.0, origin=(60.0, 170.0), frames=36, rate=60.0, shutter=1 / 1000, marker_size=0.045)


def encode(path, pictures, times, aspect=None):
    """A film of planes at given times in ticks, with the pixel's aspect ratio."""
    with av.open(str(path), "w") as box:
        stream = box.add_stream("libx264", rate=60)
        stream.height, stream.width = pictures[0].shape[0] * 2 // 3, pictures[0].shape[1]
        stream.pix_fmt, stream.options = "yuv420p", {"crf": "18", "preset": "veryfast"}
        stream.time_base = stream.codec_context.time_base = Fraction(1, TICKS)
        if aspect is not None:
            stream.codec_context.sample_aspect_ratio = aspect
        for picture, tick in zip(pictures, times, strict=True):
            frame = av.VideoFrame.from_ndarray(picture, format="yuv420p")
            frame.pts, frame.time_base = int(tick), Fraction(1, TICKS)
            box.mux(stream.encode(frame))
        box.mux(stream.encode())
    return path


@pytest.fixture(scope="module")
def shorts(motion):
    return [planes(picture) for picture in frames(motion, SHORT)]


STEP = TICKS // 60


def test_a_film_is_mirrored_and_turned_as_players_show_it(tmp_path, shorts):
    one = 65536
    times = np.arange(len(shorts)) * STEP
    right = encode(tmp_path / "plain.mp4", shorts, times)
    plain = next(pictures(right))
    cases = {
        "mirror": ((-one, 0, 0, 0, one, 0, 320 * one, 0, 1 << 30), plain.luma[:, ::-1]),
        "turn": ((0, one, 0, -one, 0, 0, 192 * one, 0, 1 << 30), np.rot90(plain.luma, -1)),
        "back": ((-one, 0, 0, 0, -one, 0, 320 * one, 192 * one, 1 << 30), plain.luma[::-1, ::-1]),
    }
    for name, (matrix, wanted) in cases.items():
        data = bytearray(right.read_bytes())
        at = data.index(b"tkhd") + 4 + 40  # nine numbers of the track's header, 48 bytes behind its first ones
        data[at : at + 36] = struct.pack(">9i", *matrix)
        (tmp_path / f"{name}.mp4").write_bytes(data)
        np.testing.assert_array_equal(next(pictures(tmp_path / f"{name}.mp4")).luma, wanted)
    right, mirrored = (hh.track(tmp_path / f"{name}.mp4", RADIUS) for name in ("plain", "mirror"))
    assert mirrored.centre[:, 0] == pytest.approx(-right.centre[:, 0], abs=2e-3)
    assert mirrored.angle == pytest.approx(-right.angle, abs=2e-2)


def test_pixels_that_are_not_square(tmp_path, shorts):
    film = encode(tmp_path / "wide.mp4", shorts, np.arange(len(shorts)) * STEP, aspect=Fraction(4, 3))
    assert next(pictures(film)).size == (426, 192)


def test_a_film_at_two_speeds_is_doubted(tmp_path, shorts):
    steps = np.where((np.arange(len(shorts) - 1) > 11) & (np.arange(len(shorts) - 1) < 24), 4 * STEP, STEP)
    film = encode(tmp_path / "ramp.mp4", shorts, np.concatenate([[0], np.cumsum(steps)]))
    track = hh.track(film, RADIUS)
    assert track.notes[0].startswith("Doubtful: the film plays at two speeds, 60 and 15 frames per second")
    assert "--rate 60" in track.notes[0]
    cured = hh.track(film, RADIUS, Hints(rate=60.0))
    assert not any(note.startswith("Doubtful") for note in cured.notes)


def test_repeated_pictures_are_doubted_and_left_out_with_the_rate(tmp_path, shorts):
    order = [k for k in range(len(shorts)) for _ in range(2 if k % 4 == 3 else 1)][:-1]
    film = encode(tmp_path / "repeats.mp4", [shorts[k] for k in order], np.arange(len(order)) * STEP)
    track = hh.track(film, RADIUS)
    assert any(re.search("Doubtful: 8 of 44 pictures repeat the one before.* about --rate 49", note) for note in track.notes)
    cured = hh.track(film, RADIUS, Hints(rate=60.0))
    there = np.isfinite(cured.centre[:, 0])
    assert cured.t[there] == pytest.approx(np.unique(order)[: there.sum()] / 60.0, abs=1e-9)


def test_pictures_that_were_cut_out_are_doubted(tmp_path, shorts):
    kept = [picture for k, picture in enumerate(shorts) if k != 14]
    track = hh.track(encode(tmp_path / "cut.mp4", kept, np.arange(len(kept)) * STEP), RADIUS)
    assert any("Doubtful: the hoop leaps ahead at 0.217 s" in note and "--from or --to" in note for note in track.notes)
    times = np.delete(np.arange(len(shorts)), 14) * STEP
    gap = hh.track(encode(tmp_path / "gap.mp4", kept, times), RADIUS)
    assert any("1 pictures are missing in the film" in note for note in gap.notes)
    assert not any(note.startswith("Doubtful") for note in gap.notes)


def test_a_window_of_a_film(tmp_path, shorts):
    film = encode(tmp_path / "plain.mp4", shorts, np.arange(len(shorts)) * STEP)
    whole, part = hh.track(film, RADIUS), hh.track(film, RADIUS, Hints(since=0.1, until=0.3))
    assert part.t == pytest.approx(whole.t[6:19])
    assert part.view.first == 6
    assert part.angle == pytest.approx(whole.angle[6:19], abs=5e-3)
    assert whole.between(0.1, 0.3).view.first == 6
    with pytest.raises(ValueError, match=r"has 0 frames from 5 s on up to 6 s; tracking needs at least 3"):
        sample_pictures(film, None, 5.0, 6.0)


@pytest.mark.parametrize("seed", [1, 2])
def test_rings_of_light_are_no_hoop(tmp_path, seed):
    rng = np.random.default_rng(seed)
    v, u = np.mgrid[0:240, 0:320]
    waves = [(rng.uniform(-100, 420), rng.uniform(-100, 340), rng.uniform(40, 90), rng.uniform(0, 6)) for _ in range(5)]
    water = []
    for k in range(40):
        light = sum(np.cos(2 * np.pi * np.hypot(u - x, v - y) / wide + phase - 0.7 * k) for x, y, wide, phase in waves)
        grey = 110 + 25 * light + rng.normal(0, 3, light.shape)
        water.append(planes(np.repeat(grey[..., None], 3, axis=-1).clip(0, 255)))
    film = encode(tmp_path / "water.mp4", water, np.arange(40) * STEP)
    try:
        track = hh.track(film, RADIUS)
    except ValueError:
        return  # not found
    assert track.notes[0].startswith("Doubtful: perhaps this is no hoop: ")
