"""Where the hoop is in a film, against the motion from which the film was rendered by code of its own."""

import dataclasses
import re
import struct
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

import hophoop as hh
from film_maker import SMALL, TICKS, Film, article_like, encode, frame_times, frames, make, planes, project
from hophoop.tracking import Camera, Hints, overlay
from hophoop.tracking.circle import Circle, robust_circle
from hophoop.tracking.doubts import doubt_hoop, doubt_marker, doubt_times
from hophoop.tracking.ground import ground_line
from hophoop.tracking.video import even_step, pictures, sample_pictures

RADIUS = 0.3
MOTION = article_like()
# each film with the greatest standard deviation of its angle [rad]
FILMS = {
    # a restless background, uneven times, a marker that is hidden for a while, a hoop that is away for a while
    "hidden": (Film(frames=40, uneven=0.3, busy=True, hidden=((14, 20),), without=((30, 34),)), 3e-3),
    # a lens out of axis, whose rows are exposed one after the other
    "tilted": (Film(frames=40, first=0.15, tilt_deg=(6.0, -8.0), row_delay=1.5e-5, rate=120.0, shutter=1 / 500), 4e-3),
    # light on dark; the rim is cut by the edge of the picture at first; the picture is not level
    "light": (Film(frames=36, light=True, origin=(25.0, 225.0), roll_deg=2.0, marker_size=0.04), 5e-3),
    # so far out of axis that the rim is an ellipse, whose width in the picture changes by a fifth
    "steep": (Film(frames=36, rate=120.0, first=0.15, tilt_deg=(4.0, 20.0), focal=600.0), 4e-3),
    # lost frames at the start, in the middle and at the end of uneven times, with a rolling shutter
    "lost": (
        Film(frames=30, rate=300.0, row_delay=1.2e-5, uneven=0.5, without=((0, 2), (12, 13), (18, 21), (29, 30))), 5e-3,
    ),
    # the hoop moves by three pixels while a picture is exposed
    "blurred": (Film(frames=40, rate=120.0, first=0.1, shutter=1 / 125), 3e-3),
    # the lower edge of the picture cuts the rim, whose inner edge shows more of itself
    "cut": (Film(frames=40, rate=120.0, origin=(90.0, 275.0)), 3e-3),
    # as a phone takes them
    "phone": (
        Film(size=(1280, 720), scale=330.0, origin=(120.0, 600.0), focal=1150.0, frames=60, marker_size=0.04, busy=True,
             row_delay=1e-5, uneven=0.3, hidden=((10, 25),), without=((40, 50),)),
        1.5e-3,
    ),
}  # fmt: skip
MARKS = {"phone": pytest.mark.slow} | dict.fromkeys(("tilted", "light", "steep", "lost", "blurred"), pytest.mark.long)


@pytest.fixture(scope="session")
def films(tmp_path_factory):
    """The file of a film by its name, each made once."""
    folder = tmp_path_factory.mktemp("films")

    @cache
    def film(name):
        return make(folder / f"{name}.mp4", MOTION, FILMS[name][0])

    return film


@pytest.fixture(scope="session")
def tracked(films):
    """The track of a film by its name and by hints."""

    @cache
    def track(name, **hints):
        film, _ = FILMS[name]
        return hh.track(films(name), RADIUS, Hints(**{"exposure": film.shutter, "row_delay": film.row_delay} | hints))

    return track


def errors(track, name):
    """Distance of the centre from where it was [pixel], and error of the angle [rad], at the track's own times."""
    film, _ = FILMS[name]
    t = track.t + film.first
    state = MOTION.at(np.minimum(t, MOTION.duration))
    away = np.hypot(*(track.pixel - project(film, state.x, state.height + RADIUS)).T)
    turned = track.angle - state.angle
    # the angle counts from the turn in which the film begins
    turned -= 2 * np.pi * np.round(np.nanmedian(turned) / (2 * np.pi))
    return np.where(t < MOTION.duration, [away, turned], np.nan)


@pytest.mark.parametrize("name", [pytest.param(name, marks=MARKS.get(name, ())) for name in FILMS])
def test_centre_and_angle(tracked, name):
    film, most = FILMS[name]
    track = tracked(name)
    centre, angle = errors(track, name)
    assert np.nanmax(centre) < 0.2
    assert np.sqrt(np.nanmean(angle**2)) < most
    assert track.view.scale == pytest.approx(film.scale, rel=5e-3)
    # what is not there is marked, and nothing else
    away, bare = ({k for a, b in spans for k in range(a, b)} for spans in (film.without, film.hidden))
    assert {k for k, word in enumerate(track.state) if word == "lost"} == away
    assert {k for k, word in enumerate(track.state) if word == "no marker"} >= bare
    assert track.state.count("found") >= 0.97 * (film.frames - len(away | bare)) - 1
    assert np.isnan(track.centre[[*away]]).all()
    assert np.isnan(track.angle[[*away, *bare]]).all()


def test_errors_are_as_large_as_said_and_times_and_scale_those_of_the_film(tracked):
    """Times are those of the file at the middle of the exposure; the scale comes from the radius."""
    film, _ = FILMS["hidden"]
    track = tracked("hidden")
    x = track.centre[:, 0] - MOTION.at(track.t).x
    assert 0.2 < np.nanstd(x / track.centre_error[:, 0]) < 2.0
    assert 0.2 < np.nanstd(errors(track, "hidden")[1] / track.angle_error) < 2.5
    assert track.t == pytest.approx(frame_times(film) + 0.5 * film.shutter, abs=1e-12)
    assert track.view.scale == pytest.approx(film.scale, rel=2e-3)


def test_a_lost_frame_has_the_time_of_a_row_between_those_of_its_neighbours(tracked):
    film, _ = FILMS["lost"]
    track = tracked("lost")
    delay = track.t - frame_times(film) - 0.5 * film.shutter
    lost = np.isnan(track.pixel[:, 1])
    assert delay[~lost] == pytest.approx(film.row_delay * track.pixel[~lost, 1], abs=1e-12)
    assert delay[lost] == pytest.approx(np.interp(frame_times(film)[lost], frame_times(film)[~lost], delay[~lost]), abs=1e-12)


@pytest.mark.long
def test_a_lens_out_of_axis_with_a_rolling_shutter(tracked):
    track, early = tracked("tilted"), tracked("tilted", row_delay=0.0)
    camera = track.view.camera
    assert np.degrees([camera.tilt_x, camera.tilt_y]) == pytest.approx([6.0, -8.0], abs=1.0)
    # without the delay, the times differ by the row of the centre, and the marker's row is exposed at another time
    assert track.t - early.t == pytest.approx(1.5e-5 * track.pixel[:, 1], rel=0.02)
    good, bad = (np.abs(np.nanmean(errors(one, "tilted"), axis=1)) for one in (track, early))
    assert (bad > 3 * good).all()


def test_blur_is_no_tilt(tracked):
    """It widens the rim along the motion, so that its picture is an oval as that of a tilted hoop."""
    track = tracked("blurred")
    assert (track.view.camera.tilt_x, track.view.camera.tilt_y) == (0.0, 0.0)
    state = MOTION.at(track.t + FILMS["blurred"][0].first)
    assert np.ptp(track.centre[:, 1] - state.height) < 2e-3


@pytest.mark.long
def test_a_camera_that_is_not_level(tracked):
    """A level line rises in its picture, and the slope counts from the picture's rows."""
    slope = tracked("light").slope
    assert abs(np.degrees(slope)) == pytest.approx(2.0, abs=0.2)
    assert tracked("light", level=-slope).slope == pytest.approx(0.0, abs=4e-3)


@pytest.mark.long
def test_hints_are_followed(tracked):
    u, v = tracked("hidden").pixel[5]
    for hints in ({"marker_color": "red", "ring": "dark"}, {"centre": (u + 2, v - 2), "rim": 61.0, "at": 5 / 240}):
        assert np.nanmax(errors(tracked("hidden", **hints), "hidden")[0]) < 0.2
    assert set(tracked("hidden", marker_color="none").state) == {"no marker", "lost"}
    below = tracked("hidden", ground=(0.0, 240.0, 479.0, 240.0), slope=0.1)
    assert below.slope == 0.1
    assert np.nanmin(below.centre[:, 1]) == pytest.approx(RADIUS, abs=3e-3)
    for hints, message in (
        ({"centre": (420.0, 60.0), "rim": 25.0}, "show no rim in the frame"),
        ({"marker_color": "cyan"}, "no patch of that colour"),
    ):
        with pytest.raises(ValueError, match=message):
            tracked("hidden", **hints)


def test_what_was_found_is_drawn_where_it_is(films, tracked, tmp_path):
    path, track, seen = films("hidden"), tracked("hidden"), []
    overlay(path, track, tmp_path / "over.mp4", lambda *pair: seen.append(pair))
    assert seen[-1] == (40, 40)
    drawn = list(pictures(tmp_path / "over.mp4"))
    assert len(drawn) == 40
    column, row = np.round(track.view.to_picture(track.centre[0] + [0.0, RADIUS], RADIUS)).astype(int) // 2
    # the rim is yellow: much red, little blue
    assert drawn[0].blue[row, column] < 100 < 108 < next(pictures(path)).blue[row, column]
    # a frame without hoop has a red edge
    assert drawn[31].red[0, 100] > 180
    # over time: what is there, where it is there
    figure = hh.plots.track(track)
    assert [ax.get_title("left") for ax in figure.axes] == ["x (m)", "Height of the rim above the plane (mm)", "Angle (°)"]
    heights = 1e3 * (track.centre[:, 1] - RADIUS)
    for ax, drawn_over_time in zip(figure.axes[1:], (heights, np.degrees(track.angle)), strict=True):
        np.testing.assert_array_equal(ax.lines[0].get_ydata(), drawn_over_time)
    with pytest.raises(ValueError, match=r"over.webm must end in \.mp4"):
        overlay(path, track, tmp_path / "over.webm")


def test_memory_does_not_grow_with_length(films):
    few = sample_pictures(films("hidden"), None, least=3)
    assert [one.row for one in few] == [0, 13, 26, 39]
    assert [one.row for one in sample_pictures(films("hidden"), None, 0.05, 0.1, least=30)] == [
        k for k, t in enumerate(frame_times(FILMS["hidden"][0])) if 0.05 <= t <= 0.1
    ]


# --- doubts, and what goes wrong is one sentence ---------------------------------------------------


def assert_doubt(found, said):
    """One doubt that says this, or none where there is nothing to say."""
    assert len(found) == bool(said)
    assert re.search(said, "".join(found))


@pytest.mark.parametrize(
    ("turned", "visible", "doubt"),
    [(1.0, 1.0, ""), (0.3, 1.0, ""), (0.05, 1.0, "by 4.0 radii .* turns by 0.20 rad"), (1.0, 0.4, "only 16 of 40 frames")],
)
def test_a_marker_is_doubted_for_a_reason(turned, visible, doubt):
    x = np.linspace(0.0, 4.0, 40)
    assert_doubt(doubt_marker(x, np.where(np.arange(40) < visible * 40, turned * x, np.nan)), doubt)


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"busy": False}, r"empty\.mp4 shows no hoop that could be followed"),
        ({"busy": True}, "shows a circle that does not move"),
        ({"frames": 2}, "has 2 frames; tracking needs at least 3"),
    ],
)
def test_a_film_without_a_hoop_is_refused(tmp_path, how, message):
    film = Film(**{"size": (320, 192), "frames": 6, "without": ((0, 12),)} | how)
    with pytest.raises(ValueError, match=message):
        hh.track(make(tmp_path / "empty.mp4", MOTION, film), RADIUS)


def test_files_that_are_no_films(tmp_path, plain):
    whole = plain.read_bytes()
    for name, data in {"text": b"no film at all", "cut": whole[: len(whole) // 2], "vast": b""}.items():
        (tmp_path / name).write_bytes(data)
        if not data:
            with (tmp_path / name).open("wb") as stream:
                stream.truncate(5_000_000_000)  # sparse: no byte of it is on the disk
        with pytest.raises(ValueError, match=f"{name} cannot be read as a video: Invalid data"):
            hh.track(tmp_path / name, RADIUS)
    with pytest.raises(FileNotFoundError):
        hh.track(tmp_path / "absent.mp4", RADIUS)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"radius": float("nan")}, "radius = nan must be"),
        ({"ring": "blue"}, "ring = 'blue' must be auto, dark or light"),
        ({"ground": (1.0, 2.0)}, "ground = .* must be 4 numbers"),
        ({"rate": -1.0}, "rate = -1.0 must be a number above 0"),
        ({"exposure": 2.0}, "exposure = 2.0 must be from 0 to 1 s"),
        ({"tilt": (1.0, 0.0)}, "tilt"),
        ({"slope": 2.0}, "slope = 2.0 must be between"),
    ],
)
def test_bad_values(values, message):
    radius = values.pop("radius", RADIUS)
    with pytest.raises(ValueError, match=message):
        hh.track("absent.mp4", radius, Hints(**values))


# --- the pieces ------------------------------------------------------------------------------------


@pytest.mark.parametrize("tilt", [(0.0, 0.0), (0.1, -0.2), (0.3, 0.0)])
def test_a_camera_there_and_back_and_against_that_of_the_films(tilt):
    camera, film = Camera(640, 360, 500.0, *tilt), Film(size=(640, 360), focal=500.0, tilt_deg=np.degrees(tilt), scale=1.0)
    points = np.random.default_rng(1).uniform(-100, 100, (40, 2))
    seen = camera.to_picture(points)
    middle = [319.5 - film.origin[0], film.origin[1] - 179.5]
    assert seen == pytest.approx(project(film, *(points + middle).T), abs=1e-9)
    assert camera.to_plane(seen) == pytest.approx(points, abs=1e-9)


def test_a_robust_circle_does_not_mind_strangers():
    rng = np.random.default_rng(3)
    around, size = rng.uniform(0, 2 * np.pi, 300), 60.0 + rng.normal(0, 0.15, 300)
    size[:100] += rng.uniform(0.5, 4, 100)
    fit = robust_circle(size * np.exp(1j * around), Circle(1.0 - 1.0j, 60.0), 6.0)
    assert fit.circle == pytest.approx((0.0, 60.0), abs=0.05)
    inner = robust_circle(size * np.exp(1j * around), Circle(0j, 54.0), 9.0)
    assert inner.circle == pytest.approx((0.0, 60.0), abs=0.05)
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


# --- what a player does, and films whose times are wrong -------------------------------------------

SHORT = dataclasses.replace(SMALL, frames=24, rate=60.0, shutter=1 / 1000)
STEP = TICKS // 60


@pytest.fixture(scope="module")
def shorts():
    return [planes(picture) for picture in frames(MOTION, SHORT)]


@pytest.fixture(scope="module")
def plain(shorts, tmp_path_factory):
    return encode(tmp_path_factory.mktemp("plain") / "plain.mp4", SHORT.size, shorts, np.arange(24) * STEP)


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


def test_pixels_that_are_not_square_and_a_given_rate(tmp_path, shorts):
    film = encode(tmp_path / "wide.mp4", SHORT.size, shorts[:3], np.arange(3) * STEP, aspect=Fraction(4, 3))
    found = [(one.size, one.t) for one in pictures(film, rate=240.0)]
    assert found == [((426, 192), k / 240.0) for k in range(3)]


@pytest.mark.parametrize(
    ("often", "said"),
    [
        ([2], "^23 pictures that repeat the one before are left out"),
        ([3, 2], "Doubtful: 35 of 59 pictures repeat the one before.* about --rate 24"),
    ],
)
def test_repeated_pictures_are_doubted_and_left_out(tmp_path, shorts, often, said):
    order = np.repeat(np.arange(24), np.resize(often, 24))[:-1]
    film = encode(tmp_path / "film.mp4", SHORT.size, [shorts[k] for k in order], np.arange(len(order)) * STEP)
    assert re.search(said, hh.track(film, RADIUS).notes[0])
    cured = hh.track(film, RADIUS, Hints(rate=60.0))
    assert not re.search("Doubtful|lost", "\n".join(cured.notes))
    assert cured.t[cured.found] == pytest.approx(np.arange(24) / 60.0, abs=1e-9)


@pytest.mark.parametrize(
    ("t", "steps", "said"),
    [
        (np.arange(30) / 60, 1.0, ""),
        (np.append(np.arange(15) / 60, 0.25 + np.arange(15) / 15), 1.0, "the film plays at two speeds, 60 and 15 .* 0.250 s"),
        (np.arange(30) / 60, 2.0, "between 0.233 s and 0.250 s the hoop goes 10.0 pixels, 2.0 times as fast .* --from or --to"),
        (
            np.append(np.arange(15) / 60, np.arange(16, 31) / 60),
            2.0,
            "1 pictures are missing in the film, the first after 0.23",
        ),
    ],
    ids=["good", "two speeds", "cut", "gap"],
)
def test_times_that_are_wrong_are_doubted(t, steps, said):
    """Where the hoop goes 5 pixels between two pictures, once as many times more."""
    ways = np.full(29, 5.0)
    ways[14] *= steps
    assert_doubt(doubt_times(t, ways, np.zeros(30, dtype=bool)), said)


def test_times_in_whole_milliseconds_are_those_of_the_even_grid(tmp_path, shorts):
    """As in Matroska and films of screen recorders; a picture is missing in it."""
    kept = np.delete(np.arange(24), 9)
    film = encode(tmp_path / "film.mkv", SHORT.size, [shorts[k] for k in kept], kept * STEP)
    assert hh.track(film, RADIUS).t == pytest.approx(kept / 60, abs=2e-7)


@pytest.mark.parametrize(
    ("ticks", "usual", "step"),
    [
        (np.round(np.arange(300) * 1000 / 240), 1000 / 240, 1000 / 240),
        # the rate in the header is only the mean
        (np.round(np.delete(np.arange(300), [3, 50, 51]) * 1000 / 59.94), 17.1, 1000 / 59.94),
        (np.floor(np.arange(100) * 600 / 29.97), 0.0, 600 / 29.97),
        (np.arange(50) * 375.0, 375.0, 375.0),
        # times that are uneven for another reason
        (np.round(np.arange(300) * 1000 / 240 + 0.7 * (np.arange(300) % 2)), 1000 / 240, 0.0),
        (np.cumsum(np.arange(20) + 90.0), 100.0, 0.0),
    ],
)
def test_an_even_grid_is_what_all_times_round_to(ticks, usual, step):
    assert even_step(ticks, usual) == pytest.approx(step, abs=1.0 / len(ticks))  # rounding leaves as much open


def test_pictures_of_different_sizes_are_refused(tmp_path, shorts):
    narrow = [planes(picture[:, :160]) for picture in frames(MOTION, dataclasses.replace(SHORT, frames=12))]
    parts = [
        encode(tmp_path / f"{k}.h264", size, pictures, np.arange(12) * STEP)
        for k, (size, pictures) in enumerate((((320, 192), shorts[:12]), ((160, 192), narrow)))
    ]
    (tmp_path / "film.h264").write_bytes(b"".join(part.read_bytes() for part in parts))
    with pytest.raises(ValueError, match=r"film\.h264 has pictures of different sizes"):
        hh.track(tmp_path / "film.h264", RADIUS, Hints(rate=60.0))


def test_a_film_of_minutes_asks_for_a_window_at_once(tmp_path, shorts):
    film = encode(tmp_path / "film.mp4", SHORT.size, shorts[:4], np.arange(4) * 200 * TICKS)
    with pytest.raises(ValueError, match=r"film.mp4 lasts 600 s, .* --from 12.5 --to 15"):
        hh.track(film, RADIUS)
    with pytest.raises(ValueError, match="has 1 frame from 150 s on up to 250 s"):
        hh.track(film, RADIUS, Hints(since=150.0, until=250.0))


def test_what_a_track_assumes_of_camera_and_scale(plain):
    """Nobody levels a camera better than to 2 degrees without saying so, and an edge is where it is to half a pixel."""
    found, level, slope = (hh.track(plain, RADIUS, Hints(**one)) for one in ({}, {"level": 0.0}, {"slope": 0.1}))
    assert np.degrees(found.slope_error) == pytest.approx(2.0, abs=0.01)
    assert "It falls by 0.0" in found.notes[1]
    assert "level to 2°" in found.notes[1]
    assert level.slope == found.slope
    assert 0.05 < np.degrees(level.slope_error) < 0.3
    assert (slope.slope, np.isnan(slope.slope_error)) == (0.1, True)
    assert "level" not in " ".join(slope.notes + level.notes)
    assert found.view.scale_error == pytest.approx(0.5 / 39.0, rel=0.02)
    assert "radius of only 39 pixels in the picture, so the scale is uncertain by 1 %" in found.notes[-1]


@pytest.mark.long
def test_a_window_of_a_film(plain):
    whole, part = hh.track(plain, RADIUS), hh.track(plain, RADIUS, Hints(since=0.1, until=0.3))
    assert part.t == pytest.approx(whole.t[6:19])
    assert part.view.first == whole.between(0.1, 0.3).view.first == 6
    assert part.angle == pytest.approx(whole.angle[6:19], abs=5e-3)
    fast = hh.track(plain, RADIUS, Hints(rate=6000.0, until=0.004))
    assert fast.notes[0].startswith("Doubtful: perhaps this is no hoop: it moves at 4")
    with pytest.raises(ValueError, match=r"has 0 frames from 5 s on up to 6 s; tracking needs at least 3"):
        sample_pictures(plain, None, 5.0, 6.0)


def test_a_film_on_its_side_is_doubted(tmp_path):
    """As a phone writes it that was held upright, if no program has turned it."""
    film = dataclasses.replace(SHORT, size=(192, 320), origin=(-4.0, 234.0), roll_deg=90.0, rate=30.0)
    notes = "\n".join(hh.track(make(tmp_path / "sideways.mp4", MOTION, film), RADIUS).notes)
    assert "Doubtful: the hoop moves up or down the picture. Is the film sideways?" in notes
    assert "stays in one place" not in notes


@pytest.mark.parametrize(
    ("jumps", "seen", "step", "said"),
    [
        (0.0, 0.9, 0.02, ""),
        (0.3, 0.9, 0.02, "no hoop: the circle jumps back and forth"),
        (0.0, 0.4, 0.02, "no hoop: only 40 % of a rim are seen"),
        (0.0, 0.9, 1e-4, "no hoop: it moves at 50 m/s"),
    ],
)
def test_a_circle_that_is_no_hoop_is_doubted(jumps, seen, step, said):
    """Such as rings of light on water: a circle of 60 pixels that moves by one a frame, and jumps by a share of its radius."""
    x = np.arange(20.0) + 60.0 * jumps * (-1.0) ** np.arange(20)
    assert_doubt(doubt_hoop(x / 60.0 + 0j, np.full(20, seen), step, RADIUS, 0.0), said)
