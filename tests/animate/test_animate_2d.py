"""Films in 2D: decoded, measured against the motion, and looked at by a program."""

import itertools
import subprocess
import sys

import imageio_ffmpeg
import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

import hophoop as hh
from animate_tools import darkest_spot, decoded, motion, places
from hophoop.animate import Player, film, picture, player
from hophoop.animate.canvas import Canvas
from hophoop.animate.export import format_of, write
from hophoop.animate.frames import Timing, clock
from hophoop.animate.look import Look
from hophoop.animate.mpl import Film2D
from hophoop.animate.panels import DRAWN
from hophoop.animate.scaling import force_levels
from hophoop.animate.themes import THEMES
from hophoop.plots.curves import curve
from hophoop.vocabulary import colors

SIZE = (640, 360)


def near(pixel, color, tolerance=40):
    wanted = np.array([int(color[i : i + 2], 16) for i in (1, 3, 5)])
    return np.abs(pixel.astype(int) - wanted).max(axis=-1) <= tolerance


# Files


@pytest.mark.parametrize(("kind", "codec"), [("mp4", "h264"), ("webm", "vp9"), ("gif", "gif")])
def test_a_film_has_its_frames_duration_and_size(tmp_path, kind, codec):
    path = film(motion(), tmp_path / f"hop.{kind}", Timing(fps=20), Look(size=SIZE))
    assert path == tmp_path / f"hop.{kind}"
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]
    pictures, header = decoded(path)
    assert pictures.shape == (41, 360, 640, 3)
    assert header["fps"] == 20
    assert header["codec"].startswith(codec)
    count, seconds = imageio_ffmpeg.count_frames_and_secs(str(path))
    assert count == 41
    assert seconds == pytest.approx(41 / 20, abs=0.06)


def test_mp4_plays_in_browsers(tmp_path):
    """High profile, 4:2:0, colours marked, index in front of the data: it starts before it is whole."""
    path = film(motion(), tmp_path / "hop.mp4", Timing(fps=20, end=0.3), Look(size=SIZE))
    said = subprocess.run(
        [imageio_ffmpeg.get_ffmpeg_exe(), "-i", str(path)], capture_output=True, text=True, check=False
    ).stderr
    assert "h264 (High)" in said
    assert "yuv420p(tv, bt709" in said
    data = path.read_bytes()
    assert data.index(b"moov") < data.index(b"mdat")


def test_png_pictures(tmp_path):
    assert film(motion(), tmp_path / "film", Timing(fps=10, end=0.3), Look(size=SIZE)) == tmp_path / "film"
    names = sorted(file.name for file in (tmp_path / "film").iterdir())
    assert names == ["00000.png", "00001.png", "00002.png", "00003.png"]
    with Image.open(tmp_path / "film" / "00003.png") as shown:
        assert shown.size == SIZE
        assert shown.mode == "RGB"
    with pytest.raises(FileExistsError, match="not an empty folder"):
        film(motion(), tmp_path / "film", Timing(fps=10, end=0.3), Look(size=SIZE))


def test_png_pictures_by_name_replace_those_of_a_longer_film(tmp_path):
    (tmp_path / "hop-other.png").write_bytes(b"mine")
    film(motion(), tmp_path / "hop.png", Timing(fps=10, end=0.4), Look(size=SIZE))
    film(motion(), tmp_path / "hop.png", Timing(fps=10, end=0.1), Look(size=SIZE))
    assert sorted(file.name for file in tmp_path.iterdir()) == [
        "hop-00000.png",
        "hop-00001.png",
        "hop-other.png",
    ]


def test_odd_sizes_where_the_format_allows(tmp_path):
    film(motion(), tmp_path / "a.gif", Timing(end=0.1), Look(size=(321, 181)))
    assert decoded(tmp_path / "a.gif")[0].shape[1:] == (181, 321, 3)
    with pytest.raises(ValueError, match=r"size = \(321, 181\) must be even"):
        film(motion(), tmp_path / "a.mp4", look=Look(size=(321, 181)))


def test_the_same_film_twice_is_the_same_file(tmp_path):
    one, two = (film(motion(), tmp_path / f"{i}.mp4", Timing(fps=20, end=0.4), Look(size=SIZE)).read_bytes() for i in range(2))
    assert one == two


class Breaking:
    """Pictures that stop in the middle."""

    count, size, fps = 40, (64, 64), 10.0

    def __init__(self, error):
        self.error = error

    def draw(self, k):
        if k == 20:
            raise self.error
        return np.full((64, 64, 4), k, np.uint8)


@pytest.mark.parametrize("name", ["film.mp4", "film.gif", "film.png", "film"])
def test_half_a_film_is_not_left(tmp_path, name):
    old = tmp_path / "film.mp4"
    old.write_bytes(b"before")
    with pytest.raises(KeyboardInterrupt):
        write(Breaking(KeyboardInterrupt()), tmp_path / name)
    left = [entry.name for entry in tmp_path.iterdir() if not (entry.is_dir() and not any(entry.iterdir()))]
    assert left == ["film.mp4"]
    assert old.read_bytes() == b"before"


class Counting(Breaking):
    """Remembers how far drawing ran ahead of the encoder."""

    def __init__(self):
        self.count = 2000

    def draw(self, k):
        return np.full((64, 64, 4), k % 256, np.uint8)


def test_progress_is_told(tmp_path):
    told = []
    film(motion(), tmp_path / "a.mp4", Timing(fps=10), Look(size=(64, 64)), progress=lambda *pair: told.append(pair))
    assert told == [(k + 1, 21) for k in range(21)]


def test_pictures_stream_to_the_encoder(tmp_path):
    """Many pictures need no more memory than few: 2000 of 1 MB each, in a process that may grow by 100 MB."""
    code = """
import resource, sys
import numpy as np
from hophoop.animate.export import write
class Many:
    size, fps = (512, 512), 30.0
    def __init__(self, count): self.count = count
    def draw(self, k): return np.full((512, 512, 4), k % 256, np.uint8)
write(Many(10), sys.argv[1] + '/a.mp4')
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
write(Many(600), sys.argv[1] + '/b.mp4')
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    if sys.platform != "linux":
        pytest.skip("ru_maxrss has another unit elsewhere")
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True)
    assert int(done.stdout) < 60_000  # kB, where all pictures are 630 MB


def test_an_encoder_that_fails_says_why(tmp_path, monkeypatch):
    from hophoop.animate import export

    monkeypatch.setitem(export._OPTIONS, "mp4", ["-c:v", "no_such_codec"])
    with pytest.raises(OSError, match=r"The encoder failed .*no_such_codec"):
        film(motion(), tmp_path / "a.mp4", Timing(fps=20), Look(size=SIZE))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "kind"), [("a.MP4", "mp4"), ("a.webm", "webm"), ("folder", "png"), ("a.b/", "png")])
def test_formats(name, kind):
    assert format_of(name) == kind


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
        wanted.append(sample.normal_force * shown.newton(k))
    cut = np.array(wanted) - lengths
    assert (cut > 0).all()  # the tip and the arrow's light edge have another colour
    assert (cut < 8).all()
    assert max(lengths) > 80


def test_the_scale_of_arrows_follows_the_forces():
    """Small forces show as well, no arrow is longer than the longest, and the key says the scale of the picture."""
    run = motion(0.1, 1.0, 6.0)
    shown = Film2D([run], Timing(fps=30), Look(size=(960, 540)))
    forces = run.at(shown.clock.times[0])
    greatest = np.maximum(forces.normal_force, np.abs(forces.friction_force))
    full = 1.3 * shown.actors[0].view.scale
    lengths = np.array([shown.newton(k) for k in range(shown.count)]) * greatest
    assert lengths.max() <= full * (1.0 + 1e-12)
    assert lengths.min() > 0.1 * full  # at one scale for all it would be 0.09 and less
    steps = np.diff(np.log([shown.newton(k) for k in range(shown.count)]))
    assert np.abs(steps).max() < 0.2  # it does not jump
    start, bottom = shown.draw(0).copy(), shown.draw(int(np.argmax(greatest))).copy()
    x, y, width, height = (round(part) for part in shown.layout.forces)
    key = [drawn[540 - y - height : 540 - y, x : x + width].astype(int) for drawn in (start, bottom)]
    assert np.abs(key[0] - key[1]).max() > 100


def test_in_flight_the_scale_goes_over_to_what_follows():
    levels = force_levels([motion()], clock([motion()], Timing(fps=20)), 20.0, 100.0)
    assert np.isfinite(levels).all()
    assert (levels > 0.0).all()
    still = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(gravity=0.0), hh.Start(height=1.0, vx=1.0), duration=1.0)
    assert set(force_levels([still], clock([still], Timing(fps=5)), 5.0, 7.0)) == {7.0}


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
    return [words for _, words in shown._keys]


def test_nothing_is_said_to_be_airborne_where_nothing_flies():
    assert "airborne" in keys_of(Film2D([motion()], Timing(fps=4), Look(size=SIZE)))
    assert "airborne" not in keys_of(Film2D([motion(2.0)], Timing(fps=4), Look(size=SIZE)))
    assert "airborne" not in keys_of(Film2D([motion()], Timing(fps=4, end=0.9), Look(size=SIZE)))
    assert keys_of(Film2D([motion()], Timing(fps=4), Look(size=SIZE, traces=False))) == []


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
    with pytest.raises(ValueError, match="labels holds 1 texts; the film shows 2 motions"):
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


# Text and lines


def test_text_stands_where_it_should():
    canvas = Canvas((200, 100), "#FFFFFF")
    canvas.text(100, 50, "H", "#000000", 40, anchor="center", vertical="center")
    rows, columns = np.nonzero(canvas.pixels[..., 0] < 128)
    assert columns.mean() == pytest.approx(100, abs=2)
    assert rows.mean() == pytest.approx(50, abs=2)
    canvas.text(150, 50, "11", "#000000", 20, anchor="right")
    assert (canvas.pixels[:, 150:, 0] > 128).all()


def test_text_that_leaves_the_picture_is_cut():
    canvas = Canvas((100, 64), "#FFFFFF")
    for x, y in ((-30, 10), (95, 60), (50, -5), (300, 300)):
        canvas.text(x, y, "long words 12", "#000000", 20)
    canvas.clip((20, 0, 20, 64))
    before = canvas.pixels.copy()
    canvas.text(0, 30, "MMMMMMMM", "#FF0000", 20)
    changed = np.flatnonzero((canvas.pixels != before).any(axis=(0, 2)))
    assert changed.min() >= 20
    assert changed.max() < 40


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
    figure = Figure()
    axes, run = figure.subplots(), motion()
    DRAWN["energy"](axes, run, curve(run))
    drawn = {line.get_label(): line.get_ydata() for line in axes.get_lines()}
    lost = drawn["sum"][0] - drawn["sum"]
    np.testing.assert_allclose(drawn["friction"] + drawn["impacts, normal"], lost, atol=1e-9)
    assert drawn["impacts, normal"][-1] == pytest.approx(run.ledger.impact_normal, rel=1e-12)
    assert drawn["impacts, normal"][-1] > 1.0


@pytest.mark.parametrize("camera", ["follow", "hold"])
def test_views_side_by_side_share_their_scale(camera):
    shown = Film2D([motion(), motion(2.0), motion(0.5)], Timing(fps=5), Look(size=(1280, 720), camera=camera))
    scales = {actor.view.scale for actor in shown.actors}
    assert len(scales) == 1
