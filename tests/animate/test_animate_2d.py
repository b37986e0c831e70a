"""Films in 2D: measured against the motion, and looked at by a program."""

import matplotlib
import numpy as np
import pytest

import hophoop as hh
from animate_tools import darkest_spot, decoded, keys_of, motion, near, places, window
from hophoop.animate import Player, film, picture, player
from hophoop.animate.film2d import Film2D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from hophoop.animate.panels import PANELS
from hophoop.plots.curves import curve, values_of
from hophoop.vocabulary import colors

PAIR = (motion(), motion(2.0))


def opened(runs=None, fps=10, size=(640, 360), bare=False, timing=(), **look):
    """A film before it is encoded; bare: without traces and forces."""
    plain = {"traces": False, "forces": False} if bare else {}
    return Film2D(runs or [motion()], Timing(fps=fps, **dict(timing)), Look(size=size, **plain | look))


# Where things are


@pytest.mark.parametrize("kind", ["mp4", "gif"])
def test_the_load_is_where_the_motion_says(tmp_path, kind):
    """With a camera at rest, pixels are metres times one scale: fitted, not taken from the film's views."""
    run, fps = motion(), 10
    look = Look(size=(960, 540), camera="hold", traces=False, forces=False)
    pictures, _ = decoded(film(run, tmp_path / f"hop.{kind}", Timing(fps=fps), look))
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


def test_the_load_is_where_the_following_camera_says_and_the_hoop_in_the_picture():
    shown = opened(bare=True)
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
    run = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(slope=slope, mu=0.6), hh.Start.rolling(speed), duration=2.0)
    shown = opened([run], size=(960, 540))
    left, bottom, width, height = shown.actors[0].view.rectangle
    for k, x in enumerate(run.at(shown.clock.times[0]).x):
        column, row = shown.pixel_of(k, 0, np.array([x * np.cos(slope), -x * np.sin(slope)]))
        assert left < column < left + width
        assert 540 - bottom - height < row < 540 - bottom - 5


@pytest.mark.parametrize("camera", ["follow", "hold"])
def test_views_share_scale_and_height_of_the_plane(camera):
    """One hops high, one rolls."""
    shown = opened([*PAIR, motion(0.5)], size=(1280, 720), camera=camera)
    views = [actor.view for actor in shown.actors]
    assert len({view.scale for view in views}) == 1
    floors = [720 - shown.pixel_of(0, i, [0.0, 0.0])[1] - view.rectangle[1] for i, view in enumerate(views)]
    np.testing.assert_allclose(floors, floors[0], atol=0.5)
    for one, other in ((0, 1), (0, 2), (1, 2)):
        (left, bottom, wide, _), (x, y, _, tall) = views[one].rectangle, views[other].rectangle
        assert left + wide <= x or bottom >= y + tall


# What is drawn


def test_arrows_are_to_one_scale():
    """The tip of the normal force's arrow rises over the contact as the force does; the largest has the full length."""
    run = motion(0.1, 1.0, 4.0)
    shown = opened([run], fps=2, size=(1280, 720), traces=False)
    cut, lengths = [], []
    for k, sample in enumerate(map(run.at, shown.clock.times[0])):
        column, row = np.round(shown.pixel_of(k, 0, [sample.x, 0.0])).astype(int)
        strip = near(shown.draw(k)[110:row, column - 3 : column + 4], colors.NORMAL_FORCE, 25)
        # the load may lie over the arrow, but not over its tip
        lengths.append(row - 110 - np.flatnonzero(strip.any(axis=1))[0])
        cut.append(sample.normal_force * shown.newton - lengths[-1])
    assert 0 < min(cut) <= max(cut) < 8  # the tip and the arrow's light edge have another colour
    assert max(lengths) > 80
    forces = run.at(np.linspace(0, 4, 400))
    most = np.maximum(forces.normal_force, np.abs(forces.friction_force)).max()
    assert most * shown.newton == pytest.approx(1.3 * shown.actors[0].view.scale, rel=0.03)


@pytest.mark.parametrize(
    ("speed", "look", "timing", "keys"),
    [
        (3.1, {}, {}, ["load", "centre of gravity", "airborne", "take-off", "landing"]),
        (2.0, {}, {}, ["load", "centre of gravity"]),
        (3.1, {}, {"end": 0.9}, ["load", "centre of gravity"]),
        (3.1, {"traces": False}, {}, ["take-off", "landing"]),
    ],
)
def test_keys_are_those_of_what_is_seen(speed, look, timing, keys):
    assert keys_of(opened([motion(speed)], timing=timing, **look)) == keys


def test_take_offs_and_impacts_are_marked_where_they_happen():
    run = motion()
    shown = opened(fps=30, size=(1280, 720), bare=True, camera="hold")
    last = shown.draw(shown.count - 1).copy()
    for event in (run.find("takeoff")[0], run.find("impact")[0]):
        k = int(np.ceil(event.t * 30))
        spot = shown.pixel_of(k, 0, [event.x, 0.0])
        # under the plane, where nothing else moves
        changed = window(last, spot, (6, 60), 12) - window(shown.draw(k - 1), spot, (6, 60), 12)
        assert np.abs(changed).max(axis=-1).sum() > 2000
    stuck = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.2), hh.Start(angle=5.45, vx=-3.0, omega=4.1), duration=1.0)
    kinds = {event.kind for event in stuck.events} & {"jam", "painleve_inconsistent", "painleve_indeterminate"}
    assert {one.kind for one in opened([stuck]).subject.marks[0]} >= kinds


@pytest.mark.parametrize("layout", ["side", "overlay"])
def test_hoops_are_at_their_places_and_have_letters_in_one_view(layout):
    shown = opened(PAIR, size=(1280, 720), layout=layout, camera="hold")
    assert (shown.actors[0].view is shown.actors[1].view) == (layout == "overlay")
    drawn = shown.draw(6).copy()
    for i, run in enumerate(PAIR):
        assert window(drawn, shown.pixel_of(6, i, places(run, [0.6])[0])).max() < 160  # the load
        letter = window(drawn, shown.pixel_of(6, i, [run.at(0.6).x, 1.0]), (-5, 6), 5)
        if layout == "overlay":
            assert letter.min() < 80
            assert letter.max() > 230  # on its disc


def test_the_trace_is_green_and_red_while_airborne():
    shown = opened(fps=20, size=(1280, 720), camera="hold", forces=False)
    amounts = {}
    for k in (int(motion().find("takeoff")[0].t * 20), shown.count - 1):
        drawn = shown.draw(k)[90:640]
        inks = (colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE)
        amounts[k] = [near(drawn, ink, 50).sum() for ink in inks]
    (_, red), after = amounts.values()
    assert red == 0
    assert min(after) > 300


def test_the_ring_shows_the_speed_of_its_points():
    """The pixel in the middle of the ring, at eight places, through the colour map back to a speed."""
    run, k = motion(2.0), 7
    shown = opened([run], size=(1280, 720), bare=True)
    drawn, sample = shown.draw(k), run.at(shown.clock.times[0][k])
    palette = matplotlib.colormaps[colors.RING_SPEED_MAP](np.linspace(0, 1, 512))[:, :3] * 255
    for angle in np.radians([10, 55, 100, 145, 220, 280, 325]):
        if abs(np.angle(np.exp(1j * (angle - sample.angle)))) < 0.3:
            continue  # the load covers it
        spot = [sample.x + 0.975 * np.sin(angle), 1.0 + 0.975 * np.cos(angle)]
        share = np.argmin(np.abs(palette - window(drawn, shown.pixel_of(k, 0, spot))[0, 0]).sum(axis=1)) / 511
        # twice the speed of the centre times the cosine of half the angle, in rolling
        top = shown.subject.whole.speed
        assert share * top == pytest.approx(2 * sample.vx * abs(np.cos(angle / 2)), abs=0.03 * top)


def test_panels_are_uncovered_as_time_goes_on():
    shown = opened(size=(1280, 720), panels=tuple(PANELS))
    left, bottom, width, height = (round(part) for part in shown.panel_area)
    area = slice(720 - bottom - height, 720 - bottom), slice(left, left + width)
    amounts = [(shown.draw(k)[area][..., :3].min(axis=-1) < 110).sum() for k in range(0, shown.count, 4)]
    assert amounts == sorted(amounts)
    assert amounts[-1] > 1.3 * amounts[0]


def test_the_energy_panel_shows_what_impacts_take():
    """The landing's loss: friction and impacts together are what kinetic and potential energy have lost."""
    run = motion()
    drawn = {label: values_of(name, curve(run), run.scenario) for label, _, name in PANELS["energy"][1]}
    np.testing.assert_allclose(drawn["friction"] + drawn["impacts"], drawn["sum"][0] - drawn["sum"], atol=1e-9)
    assert drawn["impacts"][-1] == pytest.approx(run.ledger.impact_normal, rel=1e-12)
    assert drawn["impacts"][-1] > 1.0
    soft = hh.simulate(motion().scenario.replace("contact", hh.Compliant()).replace("duration", 0.2))
    legend = opened([soft], panels="energy").panels.axes[0][1].get_legend()
    assert "damper" in [text.get_text() for text in legend.get_texts()]


def test_a_hoop_of_parts_shows_its_parts():
    parts = [hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.05, at=-0.2), hh.Rod(0.1, 0.3, at=0.0), hh.PointMass(0.1, at=-0.25)]
    run = hh.simulate(hh.Hoop.from_parts(0.3, parts), hh.Plane(), hh.Start.rolling(0.5), duration=0.2)
    shown = opened([run], bare=True)
    # the parts' line is turned round: G is on the negative side, and the point mass with it
    drawn, center = shown.draw(0), np.array([run.at(0.0).x, 0.3])
    assert window(drawn, shown.pixel_of(0, 0, center + np.array([0.0, 0.25]))).max() < 60
    assert window(drawn, shown.pixel_of(0, 0, center - np.array([0.0, 0.2]))).min() > 150


@pytest.mark.parametrize(
    ("load", "speed", "most", "letter"), [(0.75, 3.1, 3, "K"), (1.0, 1.0, 10_000, "M")], ids=["without an answer", "skimming"]
)
def test_special_motions_are_shown(load, speed, most, letter):
    contact = hh.Rigid(max_events=most)
    run = hh.simulate(hh.Hoop.ideal(load), hh.Plane(), hh.Start.rolling(speed), duration=3.0, contact=contact)
    assert letter in run.sequence
    shown = opened([run])
    assert all(np.isfinite(shown.draw(k)).all() for k in range(shown.count))
    assert picture(run, run.duration, Look(size=(640, 360))).shape == (360, 640, 4)


# Pictures, settings and the player


def test_pictures_come_in_any_order_and_one_is_that_of_its_time():
    shown = opened(panels=("velocity",))
    forward = [shown.draw(k).copy() for k in range(shown.count)]
    assert all((shown.draw(k) == forward[k]).all() for k in reversed(range(shown.count)))
    look = Look(size=(640, 360), traces=False, forces=False, camera="hold")
    early, late = (darkest_spot(picture(motion(), t, look), 4, below=60) for t in (0.0, 0.9))
    assert late[0] > early[0]
    with pytest.raises(ValueError, match=r"t = 3.0 must be from 0"):
        picture(motion(), 3.0)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"size": (10, 10)}, r"size = \(10, 10\) must be a width and a height from 64"),
        ({"size": (640,)}, r"size = \(640,\)"),
        ({"theme": "blue"}, "theme = 'blue' must be one of light, dark, print"),
        ({"camera": "orbit"}, "camera = 'orbit' must be one of follow, hold"),
        ({"layout": "grid"}, "layout = 'grid'"),
        ({"panels": ("speed",)}, "panels = 'speed' must be one of velocity"),
        ({"labels": ["one", "two"]}, "labels has 2 texts; the film shows 1 motions"),
    ],
)
def test_bad_looks_are_refused(tmp_path, options, words):
    with pytest.raises(ValueError, match=words):
        film(motion(), tmp_path / "a.mp4", look=Look(**options))
    assert not list(tmp_path.iterdir())


def test_the_player_plays_in_place_without_the_network():
    made = player(motion(), Timing(fps=20, end=0.2), Look(size=(320, 180)))
    assert isinstance(made, Player)
    text = made._repr_html_()
    assert text.startswith("<video controls")
    assert 'src="data:video/mp4;base64,' in text
    assert "http" not in text.split("base64,")[0]
    assert made.data[4:8] == b"ftyp"
    assert '"' not in made.html('say "hop"').split('aria-label="')[1].split('"')[0]


def test_a_word_or_a_list_is_as_good_as_a_tuple():
    assert Look(panels="velocity", labels=["one"]) == Look(panels=("velocity",), labels=("one",))
    assert Timing(slow_at="takeoff").marks == Timing(slow_at=["takeoff"]).marks == ("takeoff",)
    assert Timing(slow_at=0.5).marks == (0.5,)
