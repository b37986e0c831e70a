"""Films in 3D, rendered without a display: decoded, and measured against the motion."""

from contextlib import closing

import numpy as np
import pytest

from animate_tools import darkest_spot, decoded, keys_of, motion, near, places
from hophoop.animate import film3d, film_3d, player
from hophoop.animate.film3d import SUN, Film3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import CAMERAS_3D, Look3D
from hophoop.vocabulary import colors

SIZE = (400, 224)


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    """Smooth edges take most of the time of software rendering."""
    monkeypatch.setattr(film3d, "SMOOTH", 0)


def film(options=None, fps=5, runs=None, **timing):
    look = {"size": SIZE, "traces": False, "forces": False, "shadows": False} | (options or {})
    return closing(Film3D(runs or [motion()], Timing(fps=fps, **timing), Look3D(**look)))


def test_a_film_has_its_frames_and_size_without_a_display(tmp_path, monkeypatch, capfd):
    monkeypatch.delenv("DISPLAY", raising=False)
    told = []
    timing, look = Timing(fps=5, end=0.8), Look3D(size=SIZE)
    path = film_3d(motion(), tmp_path / "hop.mp4", timing, look, progress=lambda *pair: told.append(pair))
    pictures, header = decoded(path)
    assert pictures.shape == (5, 224, 400, 3)
    assert header["fps"] == 5
    assert told[-1] == (5, 5)
    assert [entry.name for entry in tmp_path.iterdir()] == ["hop.mp4"]
    assert pictures.std() > 10  # something is to be seen
    said = "".join(capfd.readouterr())
    assert "WARN" not in said
    assert "X server" not in said


@pytest.mark.parametrize("camera", CAMERAS_3D)
def test_the_load_is_where_the_motion_says(camera):
    run = motion()
    with film({"camera": camera}, fps=3) as shown:
        world = places(run, shown.clock.times[0])
        for k in range(shown.count):
            wanted = shown.pixel_of(k, 0, world[k])
            found = darkest_spot(shown.draw(k)[:200], 5, below=62 if camera == "hold" else 32)  # above the keys
            assert np.hypot(*(found - wanted)) < 4.0


def test_the_ring_is_coloured_by_speed():
    """Light makes colours brighter or darker; their direction in RGB stays, but for a little gloss."""
    import matplotlib

    run = motion(2.0, duration=1.0)
    shades = matplotlib.colormaps[colors.RING_SPEED_MAP]
    with film({"camera": "side", "size": (800, 448)}, fps=10, runs=[run]) as shown:
        for k in (3, 6, 9):
            drawn = shown.draw(k).astype(float)
            sample = run.at(shown.clock.times[0][k])
            for height in (1.95, 0.05):
                column, row = np.round(shown.pixel_of(k, 0, [sample.x, height])).astype(int)
                pixel = np.median(drawn[row - 1 : row + 2, column, :3], axis=0)
                speed = 2.0 * sample.vx if height > 1.0 else 0.0
                shade = np.array(shades(speed / shown.subject.whole.speed)[:3])
                assert pixel @ shade / np.linalg.norm(pixel) / np.linalg.norm(shade) > 0.985


def test_the_trace_turns_red_in_flight():
    run = motion()
    takeoff = run.find("takeoff")[0].t
    with film({"traces": True, "camera": "hold"}, fps=10) as shown:
        before = shown.draw(int(takeoff * 10)).copy()
        after = shown.draw(shown.count - 1).copy()
    red = [near(drawn[40:200], colors.GRAVITY_CENTER_AIRBORNE, 45).sum() for drawn in (before, after)]
    assert red[0] == 0
    assert red[1] > 20


def test_shadows_darken_the_plane():
    lit, shaded = [], []
    for shadows, kept in ((False, lit), (True, shaded)):
        with film({"shadows": shadows, "camera": "chase"}) as shown:
            kept.append(shown.draw(2).astype(int))
    darker = (lit[0] - shaded[0])[..., :3].min(axis=-1) > 30
    assert 100 < darker.sum() < 0.1 * darker.size


def test_arrows_show_where_there_are_forces():
    run = motion()
    times = np.arange(61) / 30
    strongest = int(np.argmax(run.at(times).normal_force))
    flying = int((run.find("takeoff")[0].t + 0.2) * 30)
    drawn, drawn_from = {}, 90
    for forces in (False, True):
        with film({"forces": forces, "camera": "side"}, fps=30) as shown:
            # the key of the arrows is in the head
            assert shown.head.head < drawn_from
            drawn[forces] = [shown.draw(k)[drawn_from:200].astype(int) for k in (strongest, flying)]
    changed = [(np.abs(a - b).max(axis=-1) > 40).sum() for a, b in zip(*drawn.values(), strict=True)]
    assert changed[0] > 150
    assert changed[1] == 0


def test_arrows_keep_one_scale_within_a_film():
    run = motion()
    with film({"forces": True, "camera": "side"}, fps=20) as shown:
        sample = run.at(shown.clock.times[0])
        force = np.maximum(sample.normal_force, np.abs(sample.friction_force))
        assert shown.newton * force.max() == pytest.approx(1.3, rel=0.03)


def test_marks_letters_and_keys():
    run = motion()
    down = run.find("impact")[0]
    with film({"camera": "hold", "traces": True}, fps=20) as shown:
        assert [one.kind for one in shown.subject.marks[0]] == ["takeoff", "impact"]
        assert "airborne" in keys_of(shown)
        shown.draw(0)  # the camera is set where a picture is drawn
        spot = shown.on_screen(shown.subject.marks[0][1].place, shown.actors[0].lane - 0.35)
        k = int(down.t * 20)
        row, column = round(SIZE[1] - spot[1]), round(spot[0])
        window = (slice(row - 2, row + 25), slice(column - 12, column + 13))
        before, after = shown.draw(k)[window].astype(int), shown.draw(shown.count - 1)[window].astype(int)
        assert (np.abs(after - before).max(axis=-1) > 60).sum() > 15
    with film({"traces": True}, runs=[motion(2.0), motion(1.0)]) as two:
        assert two.head.tagged
        assert "airborne" not in keys_of(two)


def test_several_motions_run_in_lanes():
    runs = [motion(), motion(2.0)]
    with film(runs=runs, options={"camera": "hold"}) as shown:
        assert shown.actors[0].lane < 0 < shown.actors[1].lane
        drawn = shown.draw(3)
        for i, run in enumerate(runs):
            column, row = np.round(shown.pixel_of(3, i, places(run, [0.6])[0])).astype(int)
            assert drawn[row, column, :3].max() < 90
    slopes = [motion(), motion(2.0, slope=0.1)]
    with pytest.raises(ValueError, match="must be the same in all motions"):
        film(runs=slopes)


def test_the_hoop_stays_in_the_picture_on_a_slope():
    run = motion(0.5, 1.0, 2.0, 0.25)
    for camera in CAMERAS_3D:
        with film({"camera": camera}, runs=[run]) as shown:
            for k in range(shown.count):
                column, row = shown.pixel_of(k, 0, places(run, [shown.clock.times[0][k]])[0])
                assert 0 < column < SIZE[0]
                assert 0 < row < SIZE[1]


@pytest.mark.parametrize("slope", [0.0, 0.3])
def test_shadows_lie_on_the_plane_along_the_light(slope):
    with film(runs=[motion(slope=slope)]) as shown:
        matrix = shown.flat
    normal = np.array([np.sin(slope), 0.0, np.cos(slope)])
    for point in ([0.3, 0.1, 1.2], [-2.0, 0.5, 2.0]):
        shadow = matrix[:3, :3] @ point
        assert shadow @ normal == pytest.approx(0.0, abs=1e-12)
        assert np.linalg.norm(np.cross(shadow - point, SUN)) == pytest.approx(0.0, abs=1e-12)


def test_bad_looks_are_refused(tmp_path):
    with pytest.raises(ValueError, match="camera = 'follow' must be one of chase, side, orbit, hold"):
        film_3d(motion(), tmp_path / "a.mp4", look=Look3D(camera="follow"))


def test_the_player_in_3d():
    assert player(motion(), Timing(fps=5, end=0.2), Look3D(size=(128, 72))).data[4:8] == b"ftyp"
