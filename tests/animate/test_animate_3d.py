"""Films in 3D, rendered without a display: decoded, and measured against the motion."""

import math
import re
from contextlib import closing
from dataclasses import replace

import matplotlib
import numpy as np
import pytest

from animate_tools import darkest_spot, decoded, keys_of, motion, near, places, window
from hophoop.animate import film_3d, player
from hophoop.animate.film3d import SUN, Film3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look3D
from hophoop.vocabulary import colors

RUN = motion(slope=0.1)
ALL = Look3D(size=(800, 448), camera="hold")


@pytest.fixture(scope="module")
def scene():
    """A film of a hop on a slope, with all that is drawn."""
    with closing(Film3D([RUN], Timing(fps=10), ALL)) as shown:
        yield shown


def world(x, above):
    """A point of the plane of motion from its place along the plane and above it, with the slope of the run."""
    turned = (x + 1j * above) * np.exp(-0.1j)
    return np.array([turned.real, turned.imag])


def in_space(point, lane=0.0):
    return np.array([point[0], lane, point[1]])


def projected(film, k, point):
    """A point of the world in the k-th picture, column and row; computed from where the camera stands."""
    eye, focus = (path[min(k, len(path) - 1)] for path in film.path)
    ahead = (focus - eye) / np.linalg.norm(focus - eye)
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    way = np.asarray(point) - eye
    scale = 0.5 * film.size[1] / math.tan(math.radians(15.0)) / (way @ ahead)
    return np.array([0.5 * film.size[0] + scale * (way @ right), 0.5 * film.size[1] - scale * (way @ np.cross(right, ahead))])


def test_a_film_has_its_frames_and_size_without_a_display(tmp_path, monkeypatch, capfd):
    monkeypatch.delenv("DISPLAY", raising=False)
    told = []
    timing, look = Timing(fps=5, end=0.8), Look3D(size=(400, 224))
    pictures, header = decoded(film_3d(motion(), tmp_path / "hop.mp4", timing, look, lambda *pair: told.append(pair)))
    assert pictures.shape == (5, 224, 400, 3)
    assert header["fps"] == 5
    assert told[-1] == (5, 5)
    assert pictures.std() > 10  # something is to be seen
    said = "".join(capfd.readouterr())
    assert "WARN" not in said
    assert "X server" not in said


@pytest.mark.parametrize(("camera", "slope"), [("chase", 0.2), ("side", 0.2), ("orbit", 0.0), ("hold", 0.2), ("chase", 0.0)])
def test_the_load_and_the_distances_are_where_each_camera_sees_them(camera, slope, written):
    run, look = motion(slope=slope), Look3D(size=(640, 360), camera=camera, traces=False, forces=False, shadows=False)
    with closing(Film3D([run], Timing(fps=2), look)) as film:
        load = places(run, film.clock.times[0])
        for k in (0, 3):
            written.clear()
            found = darkest_spot(film.draw(k)[:320], 6, below=60)  # between head and keys
            assert np.hypot(*(found - projected(film, k, in_space(load[k])))) < 5.0
            np.testing.assert_allclose(film.pixel_of(k, 0, load[k]), projected(film, k, in_space(load[k])), atol=1.0)
            numbers = {words: box for words, _, box in written if re.fullmatch(r"-?\d+ m", words)}
            assert len(numbers) >= 1 + (k == 0)
            for words, (left, _, right, top) in numbers.items():
                along = float(words.removesuffix(" m"))
                # below the near edge of the track, which is 2.2 radii wide
                column, row = projected(film, k, (along * math.cos(slope), -1.1, -along * math.sin(slope)))
                assert 0.5 * (left + right) == pytest.approx(column, abs=1.0)
                assert 2.0 < 360 - row - top < 10.0


def test_the_ring_is_coloured_by_speed(scene):
    """Light makes colours brighter or darker; their direction in RGB stays, but for a little gloss."""
    shades = matplotlib.colormaps[colors.RING_SPEED_MAP]
    for k, angles in ((1, (120, 180, 240, 300)), (10, (60, 120, 180))):  # without the load
        drawn, sample = scene.draw(k), RUN.at(scene.clock.times[0][k])
        for angle in np.radians(angles):
            spot = world(sample.x + 0.95 * np.sin(angle), 1.0 + sample.height + 0.95 * np.cos(angle))
            pixel = np.median(window(drawn, projected(scene, k, in_space(spot)), (-1, 2), 1), axis=(0, 1))
            speed = np.hypot(sample.vx + sample.omega * np.cos(angle), sample.vy - sample.omega * np.sin(angle))
            shade = np.array(shades(speed / scene.subject.whole.speed)[:3])
            assert pixel @ shade / np.linalg.norm(pixel) / np.linalg.norm(shade) > 0.985


def test_traces_and_marks_come_with_their_events(scene):
    off, down = RUN.find("takeoff")[0], RUN.find("impact")[0]
    spot = projected(scene, 0, in_space(world(down.x, 0.0), -0.35))
    reds, windows = [], []
    for k in (int(off.t * 10), int(down.t * 10), scene.count - 1):
        drawn = scene.draw(k)
        reds.append(near(drawn[100:400], colors.GRAVITY_CENTER_AIRBORNE, 45).sum())
        windows.append(window(drawn, spot, (2, 40), 12))
    assert reds[0] == 0
    assert reds[-1] > 40
    assert (np.abs(windows[2] - windows[1]).max(axis=-1) > 60).sum() > 15
    assert "airborne" in keys_of(scene)


def test_shadows_lie_on_the_plane_along_the_light(scene):
    k, normal = 3, in_space(world(0.0, 1.0))
    drawn, sample = scene.draw(k), RUN.at(scene.clock.times[0][k])
    dark = colors.mix(scene.ground, "#000000", 0.38)
    for point, shaded in ((places(RUN, [sample.t])[0], True), (world(sample.x, 1.0 + sample.height), False)):
        high = in_space(point)
        shadow = high - SUN * (high @ normal) / (SUN @ normal)
        assert near(window(drawn, projected(scene, k, shadow)), dark).all() == shaded


def test_arrows_show_where_there_are_forces(scene):
    assert scene.newton * RUN.at(RUN.times(4000)).normal_force.max() == pytest.approx(1.3, rel=0.03)
    changed = []
    for k in (6, 12):  # in slip and in flight
        drawn = scene.draw(k)[100:].astype(int)
        scene.look = replace(ALL, forces=False)
        changed.append((np.abs(scene.draw(k)[100:] - drawn).max(axis=-1) > 40).sum())
        scene.look = ALL
    assert changed[0] > 150
    assert changed[1] == 0


def test_several_motions_run_in_lanes():
    runs = [motion(2.0), motion(1.0)]
    with closing(Film3D(runs, Timing(fps=2), replace(ALL, forces=False))) as shown:
        assert shown.actors[0].lane < 0 < shown.actors[1].lane
        drawn = shown.draw(2)
        for actor, run in zip(shown.actors, runs, strict=True):
            spot = projected(shown, 2, in_space(places(run, [1.0])[0], actor.lane))
            assert window(drawn, spot).max() < 90  # the load
        assert shown.head.tagged
        assert "airborne" not in keys_of(shown)
    with pytest.raises(ValueError, match="must be the same in all motions"):
        Film3D([motion(), motion(2.0, slope=0.1)], Timing(), ALL)


def test_bad_looks_are_refused(tmp_path):
    with pytest.raises(ValueError, match="camera = 'follow' must be one of chase, side, orbit, hold"):
        film_3d(motion(), tmp_path / "a.mp4", look=Look3D(camera="follow"))


def test_the_player_in_3d():
    assert player(motion(), Timing(fps=5, end=0.2), Look3D(size=(128, 72))).data[4:8] == b"ftyp"
