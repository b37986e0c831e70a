"""Parts of films in 2D: panels, views side by side, text, and the player."""

import numpy as np
import pytest

import hophoop as hh
from animate_tools import darkest_spot, motion, places
from hophoop.animate import Player, film, picture, player
from hophoop.animate.film2d import Film2D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from hophoop.animate.panels import CURVES
from hophoop.plots.curves import curve

SIZE = (640, 360)


def near(pixel, color, tolerance=40):
    wanted = np.array([int(color[i : i + 2], 16) for i in (1, 3, 5)])
    return np.abs(pixel.astype(int) - wanted).max(axis=-1) <= tolerance


# Parts


def test_panels_are_uncovered_as_time_goes_on():
    look = Look(size=(1280, 720), panels=("velocity", "energy", "forces", "utilization", "phase"))
    shown = Film2D([motion()], Timing(fps=10), look)
    left, bottom, width, height = (round(part) for part in shown._panel_area)
    top = 720 - bottom - height

    def ink(k):
        panel = shown.draw(k)[top : top + height, left : left + width, :3]
        return (panel.min(axis=-1) < 110).sum()

    amounts = [ink(k) for k in range(0, shown.count, 4)]
    assert amounts == sorted(amounts)
    assert amounts[-1] > 1.3 * amounts[0]


def test_side_by_side_and_overlay():
    runs = [motion(), motion(2.0)]
    beside = Film2D(runs, Timing(fps=10), Look(size=(1280, 720)))
    (a, b) = (actor.view.rectangle for actor in beside.actors)
    assert a[0] + a[2] <= b[0] or a[1] >= b[1] + b[3]
    over = Film2D(runs, Timing(fps=10), Look(size=(1280, 720), layout="overlay", camera="hold"))
    assert over.actors[0].view is over.actors[1].view
    for shown in (beside, over):
        drawn = shown.draw(6).copy()
        for i, run in enumerate(runs):
            column, row = np.round(shown.pixel_of(6, i, places(run, [0.6])[0])).astype(int)
            assert drawn[row, column, :3].max() < 160


def test_labels_must_be_as_many_as_motions(tmp_path):
    with pytest.raises(ValueError, match="labels has 1 texts; the film shows 2 motions"):
        film([motion(), motion(2.0)], tmp_path / "a.mp4", look=Look(labels=["one"]))


def test_a_hoop_of_parts_shows_its_parts():
    parts = [
        hh.Ring(0.4, 0.28, 0.3),
        hh.Disk(0.5, 0.05, at=-0.2),
        hh.Rod(0.1, 0.3, at=0.0),
        hh.PointMass(0.1, at=-0.25),
    ]
    hoop = hh.Hoop.from_parts(0.3, parts)
    run = hh.simulate(hoop, hh.Plane(), hh.Start.rolling(0.5), duration=0.2)
    shown = Film2D([run], Timing(fps=10), Look(size=SIZE, traces=False, forces=False))
    # the parts' line is turned round: G is on the negative side, and the point mass with it
    center = np.array([run.at(0.0).x, 0.3])
    drawn = shown.draw(0)
    column, row = np.round(shown.pixel_of(0, 0, center + np.array([0.0, 0.25]))).astype(int)
    assert drawn[row, column, :3].max() < 60
    column, row = np.round(shown.pixel_of(0, 0, center - np.array([0.0, 0.2]))).astype(int)
    assert drawn[row, column, :3].min() > 150


def test_a_motion_that_ends_without_an_answer_is_shown():
    run = hh.simulate(hh.Hoop(), hh.Plane(), hh.Start.rolling(3.1), duration=2.0, contact=hh.Rigid(max_events=3))
    assert run.status == "event_limit"
    assert picture(run, run.duration, Look(size=SIZE)).shape == (360, 640, 4)


def test_a_massless_hoop_that_skims():
    run = hh.simulate(hh.Hoop.ideal(1.0), hh.Plane(), hh.Start.rolling(1.0), duration=3.0)
    assert "M" in run.sequence
    shown = Film2D([run], Timing(fps=10), Look(size=SIZE))
    for k in range(shown.count):
        assert np.isfinite(shown.draw(k)).all()


def test_pictures_come_in_any_order():
    shown = Film2D([motion()], Timing(fps=10), Look(size=SIZE, panels=("velocity",)))
    forward = [shown.draw(k).copy() for k in range(shown.count)]
    for k in reversed(range(shown.count)):
        assert (shown.draw(k) == forward[k]).all()


def test_one_picture_is_that_of_its_time():
    run = motion()
    drawn = picture(run, 0.9, Look(size=SIZE, traces=False, forces=False, camera="hold"))
    shown = Film2D([run], Timing(fps=10), Look(size=SIZE, traces=False, forces=False, camera="hold"))
    moved = darkest_spot(drawn, 4, below=60) - darkest_spot(
        picture(run, 0.0, Look(size=SIZE, traces=False, forces=False, camera="hold")), 4, below=60
    )
    assert moved[0] > 0
    assert drawn.shape == shown.draw(9).shape
    with pytest.raises(ValueError, match=r"t = 3.0 must be from 0"):
        picture(run, 3.0)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"size": (10, 10)}, r"size = \(10, 10\) must be a width and a height from 64"),
        ({"size": (640,)}, r"size = \(640,\)"),
        ({"theme": "blue"}, "theme = 'blue' must be one of light, dark, print"),
        ({"camera": "orbit"}, "camera = 'orbit' must be one of follow, hold"),
        ({"layout": "grid"}, "layout = 'grid'"),
        ({"panels": ("speed",)}, "panels = 'speed' must be one of velocity"),
    ],
)
def test_bad_looks_are_refused(tmp_path, options, words):
    with pytest.raises(ValueError, match=words):
        film(motion(), tmp_path / "a.mp4", look=Look(**options))
    assert not list(tmp_path.iterdir())


def test_unknown_formats_are_refused(tmp_path):
    with pytest.raises(ValueError, match=r"a\.avi' must end in \.mp4"):
        film(motion(), tmp_path / "a.avi")
    with pytest.raises(ValueError, match=r"fps = 60 must be at most 50 in a gif"):
        film(motion(), tmp_path / "a.gif", Timing(fps=60))


# The player


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


def test_the_energy_panel_shows_what_impacts_take():
    """The landing's loss: friction and impacts together are what kinetic and potential energy have lost."""
    run = motion()
    drawn = {label: values for label, _, values in CURVES["energy"](run, curve(run))[1]}
    lost = drawn["sum"][0] - drawn["sum"]
    np.testing.assert_allclose(drawn["friction"] + drawn["impacts"], lost, atol=1e-9)
    assert drawn["impacts"][-1] == pytest.approx(run.ledger.impact_normal, rel=1e-12)
    assert drawn["impacts"][-1] > 1.0


@pytest.mark.parametrize("camera", ["follow", "hold"])
def test_views_side_by_side_share_their_scale(camera):
    shown = Film2D([motion(), motion(2.0), motion(0.5)], Timing(fps=5), Look(size=(1280, 720), camera=camera))
    scales = {actor.view.scale for actor in shown.actors}
    assert len(scales) == 1


@pytest.mark.parametrize("camera", ["follow", "hold"])
def test_planes_side_by_side_are_at_one_height(camera):
    """One hops high, one rolls."""
    shown = Film2D([motion(), motion(2.0)], Timing(fps=5), Look(size=(1280, 720), camera=camera))
    planes = [(actor.view.matrix(0) @ [0.0, 0.0, 1.0])[1] - actor.view.rectangle[1] for actor in shown.actors]
    assert planes[0] == pytest.approx(planes[1], abs=0.5)
