"""Files of films in 2D: formats, sizes, frames, and nothing half written."""

import sys

import av
import numpy as np
import pytest
from PIL import Image

from animate_tools import decoded, motion
from hophoop.animate import export, film
from hophoop.animate.export import format_of, write
from hophoop.animate.film2d import Film2D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from kernel_tools import started

LOOK = Look(size=(320, 180))


@pytest.mark.parametrize(("kind", "codec"), [("mp4", "h264"), ("webm", "vp9"), ("gif", "gif")])
def test_a_film_has_its_frames_duration_and_size(tmp_path, kind, codec):
    timing, told = Timing(fps=20, end=0.5), []
    path = film(motion(), tmp_path / f"hop.{kind}", timing, LOOK, lambda *pair: told.append(pair))
    assert path == tmp_path / f"hop.{kind}"
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]
    assert told == [(k + 1, 11) for k in range(11)]
    pictures, header = decoded(path)
    assert pictures.shape == (11, 180, 320, 3)
    assert header == {"codec": codec, "fps": 20, "seconds": pytest.approx(11 / 20, abs=0.01)}
    drawn = Film2D([motion()], timing, LOOK).draw(10)[..., :3]
    assert np.abs(pictures[10].astype(int) - drawn).mean() < 4


def test_mp4_plays_in_browsers(tmp_path):
    """High profile, 4:2:0, colours marked, index in front of the data: it starts before it is whole."""
    path = write(Plain((64, 64)), tmp_path / "hop.mp4")
    with av.open(str(path)) as box:
        shown = box.streams.video[0].codec_context
    assert (shown.name, shown.profile, shown.pix_fmt) == ("h264", "High", "yuv420p")
    tv, bt709 = 1, 1
    assert shown.color_range == tv
    assert [shown.colorspace, shown.color_primaries, shown.color_trc] == [bt709] * 3
    data = path.read_bytes()
    assert data.index(b"moov") < data.index(b"mdat")
    assert write(Plain((64, 64)), tmp_path / "again.mp4").read_bytes() == data


def test_png_pictures(tmp_path):
    folder = tmp_path / "new" / "film"
    assert write(Plain((64, 32)), folder) == folder
    assert sorted(file.name for file in folder.iterdir()) == [f"0000{k}.png" for k in range(6)]
    with Image.open(folder / "00002.png") as shown:
        assert (shown.size, shown.mode, shown.getpixel((5, 5))) == ((64, 32), "RGB", (200, 30, 40))
    with pytest.raises(FileExistsError, match="not an empty folder"):
        write(Plain((64, 32)), folder)


def test_png_pictures_by_name_replace_those_of_a_longer_film(tmp_path):
    for name in ("hop-other.png", "hop-00005.png", "hop-00006.png"):
        (tmp_path / name).write_bytes(b"mine")
    write(Plain((64, 64)), tmp_path / "hop.png")
    assert sorted(file.name for file in tmp_path.iterdir()) == [*(f"hop-0000{k}.png" for k in range(6)), "hop-other.png"]
    assert (tmp_path / "hop-00005.png").read_bytes() != b"mine"


def test_odd_sizes_where_the_format_allows(tmp_path):
    assert decoded(film(motion(), tmp_path / "a.gif", Timing(end=0.1), Look(size=(321, 181))))[0].shape == (3, 181, 321, 3)
    with pytest.raises(ValueError, match=r"size = \(321, 181\) must be even"):
        film(motion(), tmp_path / "a.mp4", look=Look(size=(321, 181)))


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


@pytest.mark.parametrize("name", ["film.mp4", "film.gif", "film.png", "film"])
def test_half_a_film_is_not_left(tmp_path, name):
    old = tmp_path / "film.mp4"
    old.write_bytes(b"before")
    with pytest.raises(KeyboardInterrupt):
        write(Breaking(KeyboardInterrupt()), tmp_path / name)
    assert [entry for entry in tmp_path.rglob("*") if entry.is_file()] == [old]
    assert old.read_bytes() == b"before"


@pytest.mark.long
def test_pictures_stream_to_the_encoder(tmp_path):
    """Many pictures need no more memory than few: 120 of 1 MB each, in a process that may grow by 60 MB."""
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
write(Many(120), sys.argv[1] + '/b.mp4')
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    if sys.platform != "linux":
        pytest.skip("ru_maxrss has another unit elsewhere")
    assert int(started("-c", code, str(tmp_path)).stdout) < 60_000  # kB, where all pictures are 126 MB


COLOURS = [(255, 255, 255, 255), (0, 0, 0, 255), (200, 30, 40, 255), (20, 160, 60, 0), (30, 50, 220, 255), (90, 90, 90, 9)]


class Plain(Breaking):
    """A few pictures, each of one colour."""

    def __init__(self, size):
        self.size, self.count = size, 6

    def draw(self, k):
        return np.tile(np.array(COLOURS[k], np.uint8), (self.size[1], self.size[0], 1))


def test_an_encoder_that_fails_says_why(tmp_path, monkeypatch):
    with pytest.raises(OSError, match=r"^The encoder failed \(mp4, 20000 × 20 pixels\): \S"):
        write(Plain((20000, 20)), tmp_path / "a.mp4")  # H.264 ends at 16384
    monkeypatch.setitem(export._ENCODERS, "mp4", "no_such_codec")
    with pytest.raises(OSError, match=r"^The encoder failed: this PyAV has no no_such_codec\.$"):
        write(Plain((64, 64)), tmp_path / "a.mp4")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ["mp4", "webm", "gif"])
def test_a_film_keeps_the_colours_of_its_pictures(tmp_path, monkeypatch, kind):
    """Within the steps of limited range and of the encoder; a wrong matrix or range is off by 15 or more."""
    monkeypatch.chdir(tmp_path)
    write(Plain((64, 64)), f"a:b.{kind}")  # a name that is no address
    shown, _ = decoded(tmp_path / f"a:b.{kind}")
    assert [path.name for path in tmp_path.iterdir()] == [f"a:b.{kind}"]
    assert shown.shape == (6, 64, 64, 3)
    assert np.abs(shown - np.array(COLOURS)[:, None, None, :3]).max() <= 5


@pytest.mark.parametrize(("name", "kind"), [("a.MP4", "mp4"), ("a.webm", "webm"), ("folder", "png"), ("a.b/", "png")])
def test_formats(name, kind):
    assert format_of(name) == kind
