"""Encode pictures as films: mp4, webm, gif and PNG, by PyAV, as they are drawn."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from hophoop._support.extras import need
from hophoop._support.files import replacing, require_folder_of
from hophoop._support.stopping import temporary_folder
from hophoop.animate.sheet import Bytes
from hophoop.scenario import InputError

Progress = Callable[[int, int], None]
FORMATS = (".mp4", ".webm", ".gif", ".png")
PALETTE_PICTURES = 32
MAX_GIF_FPS = 50.0


class Pictures(Protocol):
    """A film before it is encoded: its pictures can be drawn in any order."""

    @property
    def count(self) -> int:
        """Number of pictures."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""

    @property
    def fps(self) -> float:
        """Pictures per second [1/s]."""

    def draw(self, k: int) -> Bytes:
        """The k-th picture, height × width × RGBA."""


def format_of(path: str | Path) -> str:
    """Return the format of a file's name.

    path: ends in .mp4, .webm, .gif or .png; without an ending, or with a slash, a folder for PNG pictures; format: 'mp4',
    'webm', 'gif' or 'png'.
    """
    suffix = Path(path).suffix.lower()
    if suffix == "" or str(path).endswith(("/", os.sep)):
        return "png"
    if suffix not in FORMATS:
        raise InputError.of_field("out", str(path), f"{', '.join(FORMATS)}, or be a folder for pictures", rule="must end in")
    return suffix[1:]


def write(pictures: Pictures, path: str | Path, progress: Progress | None = None) -> Path:
    """Draw and encode a film.

    The pictures go to the encoder as they are drawn. An existing file is replaced when the new one is complete.

    path: by its ending mp4 (H.264), webm (VP9), gif, or numbered PNG pictures: `film.png` gives film-00000.png and so on, a
    folder 00000.png and so on. The folder of a file must exist; a folder for pictures is created; progress: called with the
    number of pictures done and of all; result: the film, or the folder of PNG pictures.
    """
    kind = format_of(path)
    target = Path(path)
    if kind == "png":
        return _write_png(pictures, target, progress)
    if kind in ("mp4", "webm") and any(side % 2 for side in pictures.size):
        raise InputError.of_field("size", pictures.size, f"even numbers in a film of kind {kind}")
    if kind == "gif" and pictures.fps > MAX_GIF_FPS:
        raise InputError.of_field("fps", pictures.fps, f"at most {MAX_GIF_FPS:g} in a gif: browsers slow down faster ones")
    av = need("av", "films")
    with replacing(target) as part, _failures(av, kind, pictures.size):
        frames = _frames(av, pictures, range(pictures.count), progress)
        coloured = _in_palette(av, pictures, frames) if kind == "gif" else _in_bt709(frames)
        _encode(av, coloured, kind, pictures, part)
    return target


# Colours of HDTV, declared in the file.
_TO_BT709 = {"dst_colorspace": "ITU709", "src_color_range": "JPEG", "dst_color_range": "MPEG", "interpolation": "BICUBIC"}
_BT709 = {"colorspace": "bt709", "color_primaries": "bt709", "color_trc": "bt709", "color_range": "tv"}
_ENCODERS = {"mp4": "libx264", "webm": "libvpx-vp9", "gif": "gif"}
# H.264 in a profile that every browser plays, with the index at the start.
_OPTIONS = {
    "mp4": {"preset": "veryfast", "crf": "19", "profile": "high", **_BT709},
    "webm": {"b": "0", "crf": "30", "deadline": "realtime", "cpu-used": "6", "row-mt": "1", **_BT709},
    "gif": {},
}
_FILE_OPTIONS = {"mp4": {"movflags": "+faststart"}, "webm": {}, "gif": {"loop": "0"}}
_PALETTE = "max_colors=255:reserve_transparent=0:stats_mode=full"
# Without dithering, flat areas stay flat, and only the changed rectangle is stored.
_PAINTING = "dither=none:diff_mode=rectangle"


def _encode(av: Any, frames: Iterable[Any], kind: str, pictures: Pictures, path: Path) -> None:
    options = {**_FILE_OPTIONS[kind], "fflags": "+bitexact"}
    # 'file:' keeps FFmpeg from reading a colon in the name as a protocol
    with av.open(f"file:{path}", "w", format=kind, container_options=options) as box:
        stream = box.add_stream(_ENCODERS[kind], rate=_rate(pictures))
        stream.options = {**_OPTIONS[kind], "flags": "+bitexact"}
        stream.width, stream.height = pictures.size
        stream.pix_fmt = "pal8" if kind == "gif" else "yuv420p"
        stream.thread_type = "AUTO"  # slices alone make larger files
        for frame in frames:
            box.mux(stream.encode(frame))
        box.mux(stream.encode())


def _frames(av: Any, pictures: Pictures, numbers: Iterable[int], progress: Progress | None = None) -> Iterator[Any]:
    for k in numbers:
        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(pictures.draw(k)), format="rgba")
        frame.pts, frame.time_base = k, 1 / _rate(pictures)
        yield frame
        if progress is not None:
            progress(k + 1, pictures.count)


def _rate(pictures: Pictures) -> Fraction:
    return Fraction(pictures.fps).limit_denominator(1_000_000)


def _in_bt709(frames: Iterable[Any]) -> Iterator[Any]:
    for frame in frames:
        yield frame.reformat(format="yuv420p", **_TO_BT709)


def _in_palette(av: Any, pictures: Pictures, frames: Iterable[Any]) -> Iterator[Any]:
    """Yield frames in one palette, which FFmpeg makes of a sample of the pictures: of all it would need the film twice."""
    graph = av.filter.Graph()
    width, height = pictures.size
    drawn, sample = (
        graph.add_buffer(width=width, height=height, format="rgb24", time_base=1 / _rate(pictures)) for _ in range(2)
    )
    gathering, painting, sink = graph.add("palettegen", _PALETTE), graph.add("paletteuse", _PAINTING), graph.add("buffersink")
    sample.link_to(gathering)
    drawn.link_to(painting, 0, 0)
    gathering.link_to(painting, 0, 1)
    painting.link_to(sink)
    graph.configure()
    numbers = np.unique(np.linspace(0, pictures.count - 1, min(PALETTE_PICTURES, pictures.count)).astype(int))
    for source, shown in ((sample, _frames(av, pictures, map(int, numbers))), (drawn, frames)):
        for frame in shown:
            source.push(frame.reformat(format="rgb24"))
            yield from _ready(sink)
        source.push(None)
        yield from _ready(sink)


def _ready(sink: Any) -> Iterator[Any]:
    with contextlib.suppress(BlockingIOError, EOFError):
        while True:
            yield sink.pull()


@contextmanager
def _failures(av: Any, kind: str, size: tuple[int, int]) -> Iterator[None]:
    try:
        yield
    except av.codec.codec.UnknownCodecError as error:
        raise OSError(f"The encoder failed: this PyAV has no {error}.") from None
    except av.error.FFmpegError as error:
        raise OSError(f"The encoder failed ({kind}, {size[0]} × {size[1]} pixels): {error.strerror}.") from None


def _write_png(pictures: Pictures, target: Path, progress: Progress | None) -> Path:
    if target.suffix:
        folder, stem = target.parent, f"{target.stem}-"
        require_folder_of(target, target)
    else:
        folder, stem = target, ""
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise FileExistsError(f"{folder} exists already and is not an empty folder.")
    home = folder if target.suffix else folder.parent
    home.mkdir(parents=True, exist_ok=True)
    with temporary_folder(".film-", home) as part:
        for k in range(pictures.count):
            save_png(pictures.draw(k), part / f"{stem}{k:05d}.png")
            if progress is not None:
                progress(k + 1, pictures.count)
        folder.mkdir(exist_ok=True)
        if target.suffix:
            # remove the rest of an older, longer film
            for old in folder.iterdir():
                if re.fullmatch(re.escape(stem) + r"\d{5,}\.png", old.name):
                    old.unlink()
        for file in sorted(part.iterdir()):
            shutil.move(file, folder / file.name)
    return folder


def save_png(picture: Bytes, path: Path) -> None:
    """Write one picture.

    picture: shape (height, width, 3 or 4), values from 0 to 255 [1].
    """
    image = need("PIL.Image", "films")
    image.fromarray(np.ascontiguousarray(picture[..., :3])).save(path, compress_level=4)
