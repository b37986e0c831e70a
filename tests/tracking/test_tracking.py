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
from film_maker import TICKS, Film, article_like, frame_times, frames, make, planes, project
from hophoop.tracking import Camera, Hints, overlay
from hophoop.tracking.circle import Circle, fit_circle, robust_circle
from hophoop.tracking.doubts import DOUBT, doubt_marker
from hophoop.tracking.ground import ground_line
from hophoop.tracking.video import pictures, sample_pictures
from tracking.conftest import PHONES

RADIUS = 0.3


def errors(track, motion, film):
    """Distance of the centre from where it was [pixel], and error of the angle [rad], at the track's own times."""
    moving = track.t + film.first < motion.duration
    state = motion.at(np.where(moving, track.t + film.first, 0.0))
    away = np.hypot(*(track.pixel - project(film, state.x, state.height + RADIUS)).T)
    turned = track.angle - state.angle
    # the angle counts from the turn in which the film begins
    turned = turned - 2 * np.pi * np.round(np.nanmedian(turned) / (2 * np.pi))
    return np.where(moving, away, np.nan), np.where(moving, turned, np.nan)


@functools.cache
def tracked(film, path, **hints):
    known = {"exposure": film.shutter, "row_delay": film.row_delay} | hints
    return hh.track(path, RADIUS, Hints(**known))


# standard deviation of the angle [rad]; coarse coding smears the marker
LIMITS = {"hidden": 3e-3, "tilted": 4e-3, "light": 5e-3} | {name: 2e-3 if "crf" in name else 1.5e-3 for name in PHONES}
MARKS = {"tilted": pytest.mark.long, "light": pytest.mark.long} | dict.fromkeys(PHONES, pytest.mark.slow)


@pytest.mark.parametrize("name", [pytest.param(name, marks=MARKS.get(name, ())) for name in LIMITS])
def test_centre_and_angle(films, motion, name):
    path, film = films(name)
    track = tracked(film, path)
    centre, angle = errors(track, motion, film)
    assert np.nanmax(centre) < 0.2
    assert np.sqrt(np.nanmean(angle**2)) < LIMITS[name]
    # what is not there is marked, and nothing else
    away, bare = ({k for a, b in spans for k in range(a, b)} for spans in (film.without, film.hidden))
    assert {k for k, word in enumerate(track.state) if word == "lost"} == away
    assert {k for k, word in enumerate(track.state) if word == "no marker"} >= bare
    assert track.state.count("found") >= (0.9 if "crf" in name else 0.97) * (film.frames - len(away | bare)) - 1
    assert np.isnan(track.centre[[*away]]).all()
    assert np.isnan(track.angle[[*away, *bare]]).all()


def test_errors_are_as_large_as_said(films, motion):
    path, film = films("hidden")
    track = tracked(film, path)
    x = track.centre[:, 0] - motion.at(track.t + film.first).x
    assert 0.2 < np.nanstd(x / track.centre_error[:, 0]) < 2.0
    assert 0.2 < np.nanstd(errors(track, motion, film)[1] / track.angle_error) < 2.5


def test_times_and_scale(films):
    """Times are those of the file at the middle of the exposure; the scale comes from the radius."""
    path, film = films("short")
    track = tracked(film, path)
    assert track.t == pytest.approx(frame_times(film) + 0.5 * film.shutter, abs=1e-12)
    assert hh.track(path, RADIUS, Hints(rate=240.0)).t == pytest.approx(np.arange(film.frames) / 240.0, abs=1e-12)
    assert track.view.scale == pytest.approx(film.scale, rel=2e-3)
    assert hh.track(path, 2 * RADIUS, Hints(exposure=film.shutter)).centre == pytest.approx(2 * track.centre, nan_ok=True)


@pytest.mark.long
def test_a_lens_out_of_axis_with_a_rolling_shutter(films, motion):
    path, film = films("tilted")
    track, flat, early = (tracked(film, path, **hints) for hints in ({}, {"tilt": (0.0, 0.0)}, {"row_delay": 0.0}))
    camera = track.view.camera
    assert np.degrees([camera.tilt_x, camera.tilt_y]) == pytest.approx([6.0, -8.0], abs=1.0)
    # in metres: without the tilt the hoop would grow by a tenth on its way
    state = motion.at(track.t + film.first)
    assert np.ptp(track.centre[:, 0] - state.x) < 4e-3
    assert np.ptp(track.centre[:, 1] - state.height - RADIUS) < 2e-3
    assert np.nanmax(flat.centre[:, 0] - state.x) - np.nanmin(flat.centre[:, 0] - state.x) > 4e-2
    # without the delay, the times differ by the row of the centre, and the marker's row is exposed at another time
    assert track.t - early.t == pytest.approx(film.row_delay * track.pixel[:, 1], rel=0.02)
    good, bad = (errors(one, motion, film) for one in (track, early))
    assert np.nanmean(bad[0]) > 3 * np.nanmean(good[0])
    assert abs(np.nanmean(bad[1])) > 3 * abs(np.nanmean(good[1]))


@pytest.mark.long
def test_a_camera_that_is_not_level(films):
    """A level line rises in its picture, and the slope counts from the picture's rows."""
    path, film = films("light")
    slope = tracked(film, path).slope
    assert abs(np.degrees(slope)) == pytest.approx(film.roll_deg, abs=0.2)
    assert tracked(film, path, level=-slope).slope == pytest.approx(0.0, abs=4e-3)


@pytest.mark.long
def test_hints_are_followed(films, motion):
    path, film = films("short")
    u, v = tracked(film, path).pixel[5]
    for hints in ({"marker_color": "red", "ring": "dark"}, {"centre": (u + 2, v - 2), "rim": 40.0, "at": 5 / film.rate}):
        assert np.nanmax(errors(tracked(film, path, **hints), motion, film)[0]) < 0.2
    assert set(tracked(film, path, marker_color="none").state) == {"no marker", "lost"}
    below = tracked(film, path, ground=(0.0, 170.0, 319.0, 170.0), slope=0.1)
    assert below.slope == 0.1
    assert np.nanmedian(below.centre[:, 1]) == pytest.approx(RADIUS, abs=2e-3)
    for hints, message in (
        ({"centre": (280.0, 40.0), "rim": 25.0}, "show no rim in the frame"),
        ({"marker_color": "cyan"}, "no patch of that colour"),
    ):
        with pytest.raises(ValueError, match=message):
            tracked(film, path, **hints)


def test_what_was_found_is_drawn_where_it_is(films, tmp_path):
    path, film = films("short")
    track = dataclasses.replace(tracked(film, path), source="<script>.mp4")
    seen = []
    overlay(path, track, tmp_path / "over.mp4", tmp_path / "page.html", lambda done, total: seen.append((done, total)))
    assert seen[-1] == (18, 18)
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert page.count("data:image/jpeg") >= 9
    assert page.count("Track of &lt;script&gt;.mp4") == 2
    assert "<script" not in page
    drawn = list(pictures(tmp_path / "over.mp4"))
    assert len(drawn) == 18
    column, row = np.round(track.view.to_picture(track.centre[0] + [0.0, RADIUS], RADIUS)).astype(int) // 2
    # the rim is yellow: much red, little blue
    assert drawn[0].blue[row, column] < 100 < 108 < next(pictures(path)).blue[row, column]
    # a frame without hoop has a red edge
    assert drawn[13].red[0, 100] > 180


def test_memory_does_not_grow_with_length(films):
    few = sample_pictures(films("short")[0], None, fewest=2, most=3)
    assert 3 <= len(few) <= 6
    steps = np.diff([one.t for one, _ in few])
    assert all(after is not None and after.t > one.t for one, after in few[:-1])
    assert steps.max() < 1.8 * steps.min()


# --- doubts, and what goes wrong is one sentence ---------------------------------------------------


def test_a_film_without_a_marker_is_doubted(tmp_path):
    """A film of `hophoop animate` has a black load and coloured arrows, but no marker."""
    look = hh.animate.Look(size=(640, 360), camera="hold")
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
    film = Film(**{"size": (320, 192), "frames": 12, "without": ((0, 12),), "samples": 1} | how)
    with pytest.raises(ValueError, match=message):
        hh.track(make(tmp_path / "empty.mp4", article_like(duration=0.2), film), RADIUS)


def test_files_that_are_no_films(tmp_path, films):
    whole = films("short")[0].read_bytes()
    files = {"text": b"no film at all", "cut": whole[: len(whole) // 2], "vast": b""}
    for name, data in files.items():
        (tmp_path / name).write_bytes(data)
    with (tmp_path / "vast").open("wb") as stream:
        stream.truncate(5_000_000_000)  # sparse: no byte of it is on the disk
    for name in files:
        with pytest.raises(ValueError, match=f"{name} cannot be read as a video: Invalid data"):
            hh.track(tmp_path / name, RADIUS)
    with pytest.raises(FileNotFoundError):
        hh.track(tmp_path / "absent.mp4", RADIUS)


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
def test_bad_values(values, message):
    radius = values.pop("radius", RADIUS)
    with pytest.raises(ValueError, match=message):
        hh.track("absent.mp4", radius, Hints(**values))


# --- the pieces ------------------------------------------------------------------------------------


def test_a_camera_there_and_back_and_a_tilt_by_hand():
    camera = Camera(640, 360, 500.0, 0.1, -0.2)
    points = np.random.default_rng(1).uniform(-200, 200, (40, 2))
    assert camera.to_plane(camera.to_picture(points)) == pytest.approx(points, abs=1e-9)
    assert Camera(640, 360, 500.0).to_picture(np.array([3.0, 4.0])) == pytest.approx([322.5, 175.5])
    # turned about one axis alone: shrunk by the cosine and by what lies further away
    far, near = (500 * 100 * np.cos(0.3) / (500 + away * 100 * np.sin(0.3)) for away in (1, -1))
    assert Camera(640, 360, 500.0, 0.0, 0.3).to_picture(np.array([100.0, 0.0])) == pytest.approx([319.5 + near, 179.5])
    assert Camera(640, 360, 500.0, 0.3, 0.0).to_picture(np.array([0.0, 100.0])) == pytest.approx([319.5, 179.5 - far])


def test_a_circle_by_least_squares_and_a_robust_one_that_does_not_mind_strangers():
    rng = np.random.default_rng(3)
    around, size = rng.uniform(0, 2 * np.pi, 300), 60.0 + rng.normal(0, 0.15, 300)
    direction = np.stack([np.cos(around), np.sin(around)], axis=-1)
    points = [30.0, -12.0] + size[:, None] * direction
    x, y, radius, off = fit_circle(points)
    assert (x, y, radius) == pytest.approx((30.0, -12.0, 60.0), abs=0.05)
    # the normal equations, of the squares of the distances
    squares = (radius + off) ** 2 - radius**2
    assert np.abs(points.T @ squares).max() < 1e-5
    points[:100] += rng.uniform(0.5, 4, 100)[:, None] * direction[:100]
    fit = robust_circle(points, Circle(31.0, -13.0, 60.0), 6.0, None)
    assert fit.circle == pytest.approx((30.0, -12.0, 60.0), abs=0.05)
    assert not fit.inside[np.hypot(*(points - [30.0, -12.0]).T) > 62.0].any()
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


# --- what a player does, and films whose times are wrong -------------------------------------------

SHORT = Film(size=(320, 192), scale=130.0, origin=(60.0, 170.0), frames=36, rate=60.0, shutter=1 / 1000, marker_size=0.045)
STEP = TICKS // 60


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


@pytest.fixture(scope="module")
def plain(shorts, tmp_path_factory):
    return encode(tmp_path_factory.mktemp("plain") / "plain.mp4", shorts, np.arange(len(shorts)) * STEP)


@pytest.mark.parametrize(
    ("matrix", "shown", "chroma"),
    [
        ((-1, 0, 0, 1, 320, 0), lambda plane: plane[:, ::-1], (1.0, 0.5)),
        ((0, 1, -1, 0, 192, 0), lambda plane: np.rot90(plane, -1), (0.5, 0.0)),
        ((-1, 0, 0, -1, 320, 192), lambda plane: plane[::-1, ::-1], (1.0, 0.5)),
    ],
    ids=["mirror", "turn", "back"],
)
def test_a_film_is_mirrored_and_turned_as_players_show_it(tmp_path, plain, matrix, shown, chroma):
    a, b, c, d, x, y = (65536 * number for number in matrix)
    data = bytearray(plain.read_bytes())
    at = data.index(b"tkhd") + 4 + 40  # nine numbers of the track's header, 48 bytes behind its first ones
    data[at : at + 36] = struct.pack(">9i", a, b, 0, c, d, 0, x, y, 1 << 30)
    (tmp_path / "film.mp4").write_bytes(data)
    as_is, found = next(pictures(plain)), next(pictures(tmp_path / "film.mp4"))
    for name in ("luma", "blue", "red"):
        np.testing.assert_array_equal(getattr(found, name), shown(getattr(as_is, name)))
    assert (as_is.chroma, found.chroma) == ((0.0, 0.5), chroma)


def test_pixels_that_are_not_square(tmp_path, shorts):
    film = encode(tmp_path / "wide.mp4", shorts[:3], np.arange(3) * STEP, aspect=Fraction(4, 3))
    assert next(pictures(film)).size == (426, 192)


ALL = np.arange(SHORT.frames)
CUT = np.delete(ALL, 14)
REPEATED = np.repeat(ALL, np.where(ALL % 4 == 3, 2, 1))[:-1]


@pytest.mark.parametrize(
    ("order", "steps", "said"),
    [
        (ALL, np.cumsum((ALL > 0) + 3 * ((ALL > 12) & (ALL < 25))), "the film plays at two speeds, 60 and 15 .* --rate 60"),
        (REPEATED, np.arange(len(REPEATED)), "8 of 44 pictures repeat the one before.* about --rate 49"),
        (CUT, np.arange(len(CUT)), "the hoop leaps ahead at 0.217 s.* --from or --to"),
        (CUT, CUT, None),
    ],
    ids=["two speeds", "repeated", "cut", "gap"],
)
def test_times_that_are_wrong_are_doubted(tmp_path, shorts, order, steps, said):
    film = encode(tmp_path / "film.mp4", [shorts[k] for k in order], steps * STEP)
    text = "\n".join(hh.track(film, RADIUS).notes)
    assert re.search(f"{DOUBT}{said}" if said else "1 pictures are missing in the film", text)
    assert (DOUBT in text) == (said is not None)
    if said and "--rate" in said:
        cured = hh.track(film, RADIUS, Hints(rate=60.0))
        assert DOUBT not in "\n".join(cured.notes)
        assert cured.t[cured.found] == pytest.approx(np.unique(order)[: cured.found.sum()] / 60.0, abs=1e-9)


def test_a_window_of_a_film(plain):
    whole, part = hh.track(plain, RADIUS), hh.track(plain, RADIUS, Hints(since=0.1, until=0.3))
    assert part.t == pytest.approx(whole.t[6:19])
    assert part.view.first == whole.between(0.1, 0.3).view.first == 6
    assert part.angle == pytest.approx(whole.angle[6:19], abs=5e-3)
    with pytest.raises(ValueError, match=r"has 0 frames from 5 s on up to 6 s; tracking needs at least 3"):
        sample_pictures(plain, None, 5.0, 6.0)


@pytest.mark.parametrize("seed", [1, 2])
def test_rings_of_light_are_no_hoop(tmp_path, seed):
    rng = np.random.default_rng(seed)
    v, u = np.mgrid[0:240, 0:320]
    waves = [(rng.uniform(-100, 420), rng.uniform(-100, 340), rng.uniform(40, 90), rng.uniform(0, 6)) for _ in range(5)]
    water = []
    for k in range(24):
        light = sum(np.cos(2 * np.pi * np.hypot(u - x, v - y) / wide + phase - 0.7 * k) for x, y, wide, phase in waves)
        grey = 110 + 25 * light + rng.normal(0, 3, light.shape)
        water.append(planes(np.repeat(grey[..., None], 3, axis=-1).clip(0, 255)))
    film = encode(tmp_path / "water.mp4", water, np.arange(24) * STEP)
    try:
        track = hh.track(film, RADIUS)
    except ValueError:
        return  # not found
    assert track.notes[0].startswith("Doubtful: perhaps this is no hoop: ")
