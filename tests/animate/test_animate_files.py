"""Files of films in 2D: formats, sizes, frames, and nothing half written."""

import subprocess
import sys

import av
import numpy as np
import pytest
from PIL import Image

from animate_tools import decoded, motion
from hophoop.animate import export, film
from hophoop.animate.export import format_of, write
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look

SIZE = (640, 360)


# Files


@pytest.mark.parametrize(("kind", "codec"), [("mp4", "h264"), ("webm", "vp9"), ("gif", "gif")])
def test_a_film_has_its_frames_duration_and_size(tmp_path, kind, codec):
    path = film(motion(), tmp_path / f"hop.{kind}", Timing(fps=20), Look(size=SIZE))
    assert path == tmp_path / f"hop.{kind}"
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]
    pictures, header = decoded(path)
    assert pictures.shape == (41, 360, 640, 3)
    assert header["fps"] == 20
    assert header["codec"] == codec
    assert header["seconds"] == pytest.approx(41 / 20, abs=0.01)


def test_mp4_plays_in_browsers(tmp_path):
    """High profile, 4:2:0, colours marked, index in front of the data: it starts before it is whole."""
    path = film(motion(), tmp_path / "hop.mp4", Timing(fps=20, end=0.3), Look(size=SIZE))
    with av.open(str(path)) as box:
        shown = box.streams.video[0].codec_context
    assert (shown.name, shown.profile, shown.pix_fmt) == ("h264", "High", "yuv420p")
    tv, bt709 = 1, 1
    assert shown.color_range == tv
    assert [shown.colorspace, shown.color_primaries, shown.color_trc] == [bt709] * 3
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


@pytest.mark.parametrize("name", ["film.mp4", "film.gif", "film.png"])
def test_the_folder_of_a_file_must_be_there_before_pictures_are_drawn(tmp_path, name):
    with pytest.raises(FileNotFoundError):
        write(Breaking(AssertionError()), tmp_path / "new" / name)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_for_pictures_is_made(tmp_path):
    film(motion(), tmp_path / "new" / "film", Timing(fps=10, end=0.1), Look(size=SIZE))
    assert len(list((tmp_path / "new" / "film").iterdir())) == 2


@pytest.mark.parametrize("name", ["film.mp4", "film.gif", "film.png", "film"])
def test_half_a_film_is_not_left(tmp_path, name):
    old = tmp_path / "film.mp4"
    old.write_bytes(b"before")
    with pytest.raises(KeyboardInterrupt):
        write(Breaking(KeyboardInterrupt()), tmp_path / name)
    left = [entry.name for entry in tmp_path.iterdir() if not (entry.is_dir() and not any(entry.iterdir()))]
    assert left == ["film.mp4"]
    assert old.read_bytes() == b"before"


def test_progress_is_told(tmp_path):
    told = []
    film(motion(), tmp_path / "a.mp4", Timing(fps=10), Look(size=(64, 64)), progress=lambda *pair: told.append(pair))
    assert told == [(k + 1, 21) for k in range(21)]


def test_pictures_stream_to_the_encoder(tmp_path):
    """Many pictures need no more memory than few: 250 of 1 MB each, in a process that may grow by 60 MB."""
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
write(Many(250), sys.argv[1] + '/b.mp4')
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    if sys.platform != "linux":
        pytest.skip("ru_maxrss has another unit elsewhere")
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True)
    assert int(done.stdout) < 60_000  # kB, where all pictures are 262 MB


class Plain(Breaking):
    """A few pictures, each of one colour."""

    def __init__(self, size):
        self.size, self.count = size, 6

    def draw(self, k):
        picture = np.zeros((self.size[1], self.size[0], 4), np.uint8)
        picture[:] = [
            (255, 255, 255, 255),
            (0, 0, 0, 255),
            (200, 30, 40, 255),
            (20, 160, 60, 0),
            (30, 50, 220, 255),
            (90, 90, 90, 9),
        ][k]
        return picture


def test_an_encoder_that_fails_says_why(tmp_path, monkeypatch):
    with pytest.raises(OSError, match=r"^The encoder failed \(mp4, 20000 × 20 pixels\): \S"):
        write(Plain((20000, 20)), tmp_path / "a.mp4")  # H.264 ends at 16384
    monkeypatch.setitem(export._ENCODERS, "mp4", "no_such_codec")
    with pytest.raises(OSError, match=r"^The encoder failed: this PyAV has no no_such_codec\.$"):
        write(Plain((64, 64)), tmp_path / "a.mp4")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ["mp4", "webm", "gif"])
def test_a_film_keeps_the_colours_of_its_pictures(tmp_path, kind):
    """Within the steps of limited range and of the encoder; a wrong matrix or range is off by 15 or more."""
    pictures = Plain((64, 64))
    shown, _ = decoded(write(pictures, tmp_path / f"a.{kind}"))
    drawn = np.array([pictures.draw(k)[..., :3] for k in range(pictures.count)])
    assert shown.shape == drawn.shape
    assert np.abs(shown.astype(int) - drawn).max() <= 5


def test_a_film_may_have_a_colon_in_its_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(Plain((64, 64)), "a:b.mp4")
    assert [path.name for path in tmp_path.iterdir()] == ["a:b.mp4"]


@pytest.mark.parametrize(("name", "kind"), [("a.MP4", "mp4"), ("a.webm", "webm"), ("folder", "png"), ("a.b/", "png")])
def test_formats(name, kind):
    assert format_of(name) == kind
