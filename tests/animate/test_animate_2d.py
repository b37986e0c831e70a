"""Films in 2D: measured against the motion, and looked at by a program."""

import itertools

import numpy as np
import pytest

import hophoop as hh
from animate_tools import darkest_spot, decoded, motion, places
from hophoop.animate import film, picture
from hophoop.animate.film2d import Film2D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from hophoop.animate.themes import THEMES
from hophoop.vocabulary import colors

SIZE = (640, 360)


def near(pixel, color, tolerance=40):
    wanted = np.array([int(color[i : i + 2], 16) for i in (1, 3, 5)])
    return np.abs(pixel.astype(int) - wanted).max(axis=-1) <= tolerance


# Where things are


@pytest.mark.parametrize("kind", ["mp4", "gif"])
def test_the_load_is_where_the_motion_says(tmp_path, kind):
    """With a camera at rest, pixels are metres times one scale: fitted, not taken from the film's views."""
    run, fps = motion(), 10
    look = Look(size=(960, 540), camera="hold", traces=False, forces=False)
    path = film(run, tmp_path / f"hop.{kind}", Timing(fps=fps), look)
    pictures, _ = decoded(path)
    found = np.array([darkest_spot(shown, 6, below=80) for shown in pictures])
    world = places(run, np.arange(len(pictures)) / fps)
    # column = a + s X, row = b − s Y
    n = len(world)
    left = np.zeros((2 * n, 3))
    left[:n, 0] = left[n:, 1] = 1.0
    left[:n, 2], left[n:, 2] = world[:, 0], -world[:, 1]
    right = np.concatenate([found[:, 0], found[:, 1]])
    fit, *_ = np.linalg.lstsq(left, right, rcond=None)
    assert fit[2] > 50.0  # pixels a metre
    assert np.abs(left @ fit - right).max() < 1.5


def test_the_load_is_where_the_following_camera_says():
    run = motion()
    shown = Film2D([run], Timing(fps=10), Look(size=SIZE, traces=False, forces=False))
    world = places(run, shown.clock.times[0])
    for k in range(shown.count):
        wanted = shown.pixel_of(k, 0, world[k])
        np.testing.assert_allclose(darkest_spot(shown.draw(k), 6, below=60), wanted, atol=1.5)


@pytest.mark.parametrize(("slope", "speed"), [(0.35, 2.0), (-0.3, 3.0), (0.6, 0.5)])
def test_on_a_slope_the_plane_below_the_hoop_stays_in_the_picture(slope, speed):
    run = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(slope=slope, mu=0.6), hh.Start.rolling(speed), duration=2.0)
    shown = Film2D([run], Timing(fps=10), Look(size=(960, 540)))
    left, bottom, width, height = shown.actors[0].view.rectangle
    for k in range(shown.count):
        x = run.at(shown.clock.times[0][k]).x
        column, row = shown.pixel_of(k, 0, np.array([x * np.cos(slope), -x * np.sin(slope)]))
        assert left < column < left + width
        assert 540 - bottom - height < row < 540 - bottom - 5


def test_a_slope_is_drawn_as_a_slope():
    slope = 0.25
    run = motion(0.5, 1.0, 1.0, slope)
    shown = Film2D([run], Timing(fps=1), Look(size=SIZE, camera="hold", traces=False, forces=False))
    drawn = shown.draw(0)
    ground = near(drawn[100:, :, :3], THEMES["light"].ground, 3)
    # the height of the ground's upper edge at two columns
    a, b = 40, 540
    rise = np.argmax(ground[:, b]) - np.argmax(ground[:, a])
    assert rise / (b - a) == pytest.approx(np.tan(slope), abs=0.01)


def test_the_following_camera_keeps_the_hoop_in_the_picture():
    run = motion(3.1, 1.0, 2.0)
    shown = Film2D([run], Timing(fps=30), Look(size=(400, 400)))
    for k in range(0, shown.count, 3):
        center = [run.at(shown.clock.times[0][k]).x, 1.0]
        column, row = shown.pixel_of(k, 0, center)
        reach = shown.actors[0].view.scale
        assert reach <= column <= 400 - reach
        assert 0 < row < 400


def test_arrows_are_to_scale():
    """The tip of the arrow of the normal force rises over the contact as the force does, at the scale of its picture."""
    run = motion(0.1, 1.0, 4.0)
    shown = Film2D([run], Timing(fps=2), Look(size=(1280, 720), traces=False))
    lengths, wanted = [], []
    for k in range(shown.count):
        sample = run.at(shown.clock.times[0][k])
        column, row = np.round(shown.pixel_of(k, 0, [sample.x, 0.0])).astype(int)
        strip = shown.draw(k)[110:row, column - 3 : column + 4, :3]
        # the load may lie over the arrow, but not over its tip
        lengths.append(row - 110 - np.flatnonzero(near(strip, colors.NORMAL_FORCE, 25).any(axis=1))[0])
        wanted.append(sample.normal_force * shown.newton)
    cut = np.array(wanted) - lengths
    assert (cut > 0).all()  # the tip and the arrow's light edge have another colour
    assert (cut < 8).all()
    assert max(lengths) > 80


def test_arrows_keep_one_scale_within_a_film():
    """The largest force has the full length, and the key does not change."""
    run = motion(0.1, 1.0, 6.0)
    shown = Film2D([run], Timing(fps=30), Look(size=(960, 540)))
    forces = run.at(shown.clock.times[0])
    greatest = np.maximum(forces.normal_force, np.abs(forces.friction_force))
    assert greatest.max() * shown.newton == pytest.approx(1.3 * shown.actors[0].view.scale, rel=0.03)
    start, bottom = shown.draw(0).copy(), shown.draw(int(np.argmax(greatest))).copy()
    x, y, width, height = (round(part) for part in shown.layout.forces)
    assert (start == bottom)[540 - y - height : 540 - y, x : x + width].all()


SIZES = [(64, 64), (128, 72), (160, 480), (360, 640), (400, 300), (640, 360), (960, 540), (1920, 400)]


def rectangles(layout):
    return [each for each in (layout.words, layout.bar, layout.forces, layout.pace, *layout.lines) if each and each[2] > 0]


@pytest.mark.parametrize("size", SIZES, ids=[f"{w}x{h}" for w, h in SIZES])
@pytest.mark.parametrize("several", [(), ("side", 2.0), ("overlay", 2.0, 0.5)], ids=["one", "side", "overlay"])
def test_words_and_keys_never_meet(size, several):
    """Nothing of what is laid out lies on anything else or leaves the picture; words keep to their places."""
    layout = several[0] if several else "side"
    runs = [motion(), *(motion(speed) for speed in several[1:])]
    shown = Film2D(runs, Timing(fps=4, slow_at=("takeoff",)), Look(size=size, layout=layout))
    found = rectangles(shown.layout)
    for x, y, wide, high in found:
        assert x >= -0.5
        assert y >= -0.5
        assert x + wide <= size[0] + 0.5
        assert y + high <= size[1] + 0.5
    for a, b in itertools.combinations(found, 2):
        across = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
        up = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
        assert across <= 0.5 or up <= 0.5, (a, b)
    for actor in shown.actors:
        _, bottom, _, high = actor.view.rectangle
        assert high > 0.2 * size[1] / len(runs)
        assert bottom + high <= size[1] - shown.layout.head + 1.0
        assert bottom >= shown.layout.foot - 1.0
    # what is drawn in the head lies within its rectangles
    drawn = shown.draw(shown.count - 1).astype(int)
    back = np.array([int(THEMES["light"].background[j : j + 2], 16) for j in (1, 3, 5)])
    ink = np.abs(drawn[..., :3] - back).max(axis=-1) > 60
    head = np.zeros_like(ink)
    head[: int(shown.layout.head)] = True
    for x, y, wide, high in found:
        head[max(0, int(size[1] - y - high) - 2) : int(size[1] - y) + 3, max(0, int(x) - 3) : int(x + wide) + 4] = False
    assert not (ink & head).any()


def keys_of(shown):
    return [words for _, words, _ in shown.keys]


def test_nothing_is_said_to_be_airborne_where_nothing_flies():
    assert "airborne" in keys_of(Film2D([motion()], Timing(fps=4), Look(size=SIZE)))
    assert "airborne" not in keys_of(Film2D([motion(2.0)], Timing(fps=4), Look(size=SIZE)))
    assert "airborne" not in keys_of(Film2D([motion()], Timing(fps=4, end=0.9), Look(size=SIZE)))
    assert keys_of(Film2D([motion()], Timing(fps=4), Look(size=SIZE, traces=False))) == ["take-off", "landing"]


def test_take_offs_and_impacts_are_marked_where_they_happen():
    run = motion()
    look = Look(size=(1280, 720), traces=False, forces=False, camera="hold")
    shown = Film2D([run], Timing(fps=30), look)
    off, down = run.find("takeoff")[0], run.find("impact")[0]
    for event in (off, down):
        k = int(np.ceil(event.t * 30))
        column, row = np.round(shown.pixel_of(k, 0, [event.x, 0.0])).astype(int)
        before = shown.draw(k - 1).astype(int)
        after = shown.draw(shown.count - 1).astype(int)
        # under the plane, where nothing else moves
        spot = (slice(row + 6, row + 60), slice(column - 12, column + 13))
        assert np.abs(after[spot] - before[spot]).max(axis=-1).sum() > 2000
    assert [one.kind for one in shown.actors[0].found] == ["takeoff", "impact"]
    bare = Film2D([motion(2.0)], Timing(fps=4), Look(size=SIZE))
    assert bare.actors[0].found == []


def test_a_jam_is_marked():
    run = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.2), hh.Start(angle=5.45, vx=-3.0, omega=4.1), duration=1.0)
    kinds = {event.kind for event in run.events} & {"jam", "painleve_inconsistent", "painleve_indeterminate"}
    shown = Film2D([run], Timing(fps=20), Look(size=SIZE))
    assert {one.kind for one in shown.actors[0].found} >= kinds


def test_hoops_in_one_view_have_letters():
    runs = [motion(), motion(2.0)]
    over = Film2D(runs, Timing(fps=10), Look(size=(1280, 720), layout="overlay", camera="hold"))
    assert [actor.tag for actor in over.actors] == ["A", "B"]
    beside = Film2D(runs, Timing(fps=10), Look(size=(1280, 720), camera="hold"))
    assert [actor.tag for actor in beside.actors] == ["", ""]
    drawn = over.draw(6).astype(int)
    for i, run in enumerate(runs):
        column, row = np.round(over.pixel_of(6, i, [run.at(0.6).x, 1.0])).astype(int)
        around = drawn[row - 5 : row + 6, column - 5 : column + 6, :3]
        assert around.min() < 80  # the letter
        assert around.max() > 230  # on its disc


def test_the_trace_is_green_and_red_while_airborne():
    run = motion()
    shown = Film2D([run], Timing(fps=20), Look(size=(1280, 720), camera="hold", forces=False))
    last = shown.draw(shown.count - 1)[90:640, :, :3]
    green = near(last, colors.GRAVITY_CENTER, 50).sum()
    red = near(last, colors.GRAVITY_CENTER_AIRBORNE, 50).sum()
    assert green > 300
    assert red > 300
    k = int(run.find("takeoff")[0].t * 20)
    before = shown.draw(k)[90:640, :, :3]
    assert near(before, colors.GRAVITY_CENTER_AIRBORNE, 50).sum() == 0


def test_the_ring_shows_the_speed_of_its_points():
    """The pixel in the middle of the ring, at eight places, through the colour map back to a speed."""
    import matplotlib

    run = motion(2.0)
    shown = Film2D([run], Timing(fps=10), Look(size=(1280, 720), traces=False, forces=False))
    k = 7
    drawn = shown.draw(k)
    sample = run.at(shown.clock.times[0][k])
    palette = matplotlib.colormaps[colors.RING_SPEED_MAP](np.linspace(0, 1, 512))[:, :3] * 255
    for angle in np.radians([10, 55, 100, 145, 220, 280, 325]):
        if abs(np.angle(np.exp(1j * (angle - sample.angle)))) < 0.3:
            continue  # the load covers it
        spot = [sample.x + 0.975 * np.sin(angle), 1.0 + 0.975 * np.cos(angle)]
        column, row = np.round(shown.pixel_of(k, 0, spot)).astype(int)
        pixel = drawn[row, column, :3]
        share = np.argmin(np.abs(palette - pixel).sum(axis=1)) / 511
        # twice the speed of the centre times the cosine of half the angle, in rolling
        speed = 2 * sample.vx * abs(np.cos(angle / 2))
        assert share * shown.top_speed == pytest.approx(speed, abs=0.03 * shown.top_speed)


@pytest.mark.parametrize("theme", list(THEMES))
def test_themes_have_their_background(theme):
    shown = picture(motion(), 0.5, Look(size=(320, 180), theme=theme))
    assert near(shown[175, 5, :3], THEMES[theme].background, 1)
