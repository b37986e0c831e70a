"""Films in 2D: measured against the motion, and looked at by a program."""

import matplotlib
import numpy as np
import pytest

import hophoop as hh
from animate_tools import darkest_spot, keys_of, motion, near, places, window
from hophoop.animate import Player, film, picture, player
from hophoop.animate.film2d import Film2D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from hophoop.animate.panels import PANELS
from hophoop.vocabulary import colors


def opened(runs=None, fps=10, size=(640, 360), bare=False, timing=(), **look):
    """A film before it is encoded; bare: without traces and forces."""
    plain = {"traces": False, "forces": False} if bare else {}
    return Film2D(runs or [motion()], Timing(fps=fps, **dict(timing)), Look(size=size, **plain | look))


# Where things are


def test_the_load_is_where_the_following_camera_says_and_the_hoop_in_the_picture():
    shown = opened(fps=3, bare=True)
    world = places(motion(), shown.clock.times[0])
    for k in range(shown.count):
        np.testing.assert_allclose(darkest_spot(shown.draw(k), 6, below=60), shown.pixel_of(k, 0, world[k]), atol=1.5)
    narrow = opened(fps=10, size=(400, 400))
    for k, x in enumerate(motion().at(narrow.clock.times[0]).x):
        reach = narrow.actors[0].view.scale
        column, row = narrow.pixel_of(k, 0, [x, 1.0])
        assert reach <= column <= 400 - reach
        assert 0 < row < 400


@pytest.mark.parametrize(("slope", "speed"), [(0.35, 2.0), (-0.3, 3.0), (0.6, 0.5)])
def test_on_a_slope_the_plane_below_the_hoop_stays_in_the_picture(slope, speed):
    run = motion(speed, 0.6, slope=slope)
    shown = opened([run], size=(960, 540))
    left, bottom, width, height = shown.actors[0].view.rectangle
    for k, x in enumerate(run.at(shown.clock.times[0]).x):
        column, row = shown.pixel_of(k, 0, np.array([x * np.cos(slope), -x * np.sin(slope)]))
        assert left < column < left + width
        assert 540 - bottom - height < row < 540 - bottom - 5


# What is drawn


def test_arrows_are_to_one_scale():
    """The tip of the normal force's arrow rises over the contact as the force does; the largest has the full length."""
    run = motion(0.1, 1.0, 4.0)
    shown = opened([run], fps=1, size=(1280, 720), traces=False)
    lengths = []
    for k, sample in enumerate(map(run.at, shown.clock.times[0])):
        column, row = np.round(shown.pixel_of(k, 0, [sample.x, 0.0])).astype(int)
        strip = near(shown.draw(k)[110:row, column - 3 : column + 4], colors.NORMAL_FORCE, 25)
        # the load may lie over the arrow, but not over its tip, whose light edge has another colour
        lengths.append(row - 110 - np.flatnonzero(strip.any(axis=1))[0])
        assert 0 < sample.normal_force * shown.newton - lengths[-1] < 8
    assert max(lengths) > 80
    forces = run.at(np.linspace(0, 4, 400))
    most = np.maximum(forces.normal_force, np.abs(forces.friction_force)).max()
    assert most * shown.newton == pytest.approx(1.3 * shown.actors[0].view.scale, rel=0.03)


@pytest.mark.parametrize(
    ("speed", "look", "timing", "keys"),
    [
        (3.1, {}, {}, ["load", "centre of gravity", "airborne", "take-off", "landing"]),
        (3.1, {}, {"end": 0.9}, ["load", "centre of gravity"]),
        (3.1, {"traces": False}, {}, ["take-off", "landing"]),
    ],
)
def test_keys_are_those_of_what_is_seen(speed, look, timing, keys):
    assert keys_of(opened([motion(speed)], timing=timing, **look)) == keys


def test_the_ring_shows_the_speed_of_its_points():
    """The pixel in the middle of the ring, at some places, through the colour map back to a speed."""
    shown = opened([motion(2.0)], size=(1280, 720), bare=True)
    drawn, sample, top = shown.draw(7), motion(2.0).at(0.7), shown.subject.whole.speed
    palette = matplotlib.colormaps[colors.RING_SPEED_MAP](np.linspace(0, 1, 512))[:, :3] * 255
    for angle in np.radians([10, 100, 325]):
        spot = [sample.x + 0.975 * np.sin(angle), 1.0 + 0.975 * np.cos(angle)]
        share = np.argmin(np.abs(palette - window(drawn, shown.pixel_of(7, 0, spot))[0, 0]).sum(axis=1)) / 511
        # twice the speed of the centre times the cosine of half the angle, in rolling
        assert share * top == pytest.approx(2 * sample.vx * abs(np.cos(angle / 2)), abs=0.03 * top)


def test_panels_are_uncovered_as_time_goes_on():
    shown = opened(fps=1, size=(1280, 720), panels=tuple(PANELS))
    left, bottom, width, height = (round(part) for part in shown.panel_area)
    area = slice(720 - bottom - height, 720 - bottom), slice(left, left + width)
    amounts = [(shown.draw(k)[area][..., :3].min(axis=-1) < 110).sum() for k in range(shown.count)]
    assert amounts == sorted(amounts)
    assert amounts[-1] > 1.3 * amounts[0]
    soft = hh.simulate(motion().scenario.replace("contact", hh.Compliant()).replace("duration", 0.2))
    legend = opened([soft], panels="energy").panels.axes[0][1].get_legend()
    assert "damper" in [text.get_text() for text in legend.get_texts()]


@pytest.mark.parametrize(("load", "speed", "most", "letter"), [(0.75, 3.1, 3, "K"), (1.0, 1.0, 10_000, "M")])
def test_special_motions_are_shown(load, speed, most, letter):
    """One without an answer, and one that skims."""
    contact = hh.Rigid(max_events=most)
    run = hh.simulate(hh.Hoop.ideal(load), hh.Plane(), hh.Start.rolling(speed), duration=3.0, contact=contact)
    assert letter in run.sequence
    assert picture(run, run.duration, Look(size=(640, 360))).shape == (360, 640, 4)


# Pictures, settings and the player


def test_pictures_come_in_any_order_and_one_is_that_of_its_time():
    shown = opened(fps=1, panels=("velocity",), timing={"end": 1.0})
    forward = [shown.draw(k).copy() for k in range(shown.count)]
    assert all((shown.draw(k) == forward[k]).all() for k in reversed(range(shown.count)))
    assert (forward[-1] == picture(motion(), 1.0, Look(size=(640, 360), panels=("velocity",)))).all()
    with pytest.raises(ValueError, match=r"t = 3.0 must be from 0"):
        picture(motion(), 3.0)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"size": (10, 10)}, r"size = \(10, 10\) must be a width and a height from 64"),
        ({"size": (640,)}, r"size = \(640,\)"),
        ({"camera": "orbit"}, "camera = 'orbit' must be one of follow, hold"),
        ({"layout": "grid"}, "layout = 'grid'"),
    ],
)
def test_bad_looks_are_refused(tmp_path, options, words):
    with pytest.raises(ValueError, match=words):
        film(motion(), tmp_path / "a.mp4", look=Look(**options))
    assert not list(tmp_path.iterdir())


def test_the_player_plays_in_place_without_the_network():
    made = player(motion(), Timing(fps=20, end=0.1), Look(size=(128, 72)))
    assert isinstance(made, Player)
    assert made.data[4:8] == b"ftyp"
    assert made._repr_html_().startswith("<video controls")
    before, after = made.html('say "hop"').split('src="data:video/mp4;base64,')
    assert 'aria-label="say &quot;hop&quot;"' in before
    assert "http" not in before + after.split('"')[1]
