"""Read pictures of a video with their times, and write a film picture by picture."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop.scenario import InputError
from hophoop.tracking.scatter import Floats

Bytes = NDArray[np.uint8]

# The first chroma sample is at the first luma sample in H.264 and its successors, half a luma pixel to the right of it in
# JPEG.
CENTRED_CHROMA = ("mjpeg",)
TICKS = 90_000  # of a written film, per second
ROUNDED = 1.05  # range of the differences from a grid of ticks that are rounded from it, with the error of its step [ticks]
STILLS = 16  # pictures of a sample, or up to twice as many: of 3840 × 2160 they take up to 400 MB
SMALLEST, LARGEST = 32, 16384  # side of a picture [pixel]


@dataclass(frozen=True)
class Picture:
    """A frame as a player shows it: time, luma, and the two chroma planes at half the size."""

    row: int  # its number in the film, from 0
    t: float  # from the first frame of the film [s]
    luma: Bytes
    blue: Bytes
    red: Bytes
    chroma: tuple[float, float]  # of the first chroma sample: column and row [pixel]

    @property
    def size(self) -> tuple[int, int]:
        """Width and height [pixel]."""
        return self.luma.shape[1], self.luma.shape[0]


def pictures(
    path: str | Path, rate: float | None = None, since: float | None = None, until: float | None = None
) -> Iterator[Picture]:
    """Yield the frames of a video in the order of display, one in memory at a time.

    rate: frames per second as taken, if the file's own times are wrong, such as in slow motion [Hz]; since, until: times of
    the first and the last frame to yield, from the first frame of the film [s].
    """
    file, row, last, size = Path(path), 0, -1.0, None
    stamps, times = _timetable(file, rate)
    with _opened(file) as (box, stream):
        stream.thread_type = "AUTO"
        for frame in box.decode(stream):
            t = float(np.interp(row if frame.pts is None else frame.pts, stamps, times))
            if not t > last:
                continue  # a repeated frame
            if until is not None and t > until:
                break
            if t >= (since or 0.0):
                picture = _picture(frame, stream, row, t, file)
                size = size or picture.size
                if picture.size != size:
                    raise InputError(f"{file} has pictures of different sizes.")
                yield picture
            row, last = row + 1, t


def picture_times(
    path: str | Path, rate: float | None = None, since: float | None = None, until: float | None = None
) -> Floats:
    """Return the times of the pictures of a video by its packets, without decoding them.

    rate, since, until: as in `pictures`; times: shape (n,) [s].
    """
    _, t = _timetable(Path(path), rate)
    return t[(t >= (since or 0.0)) & (t <= (np.inf if until is None else until))]


def _timetable(file: Path, rate: float | None) -> tuple[Floats, Floats]:
    """Return the stamps of a video's pictures by its packets [ticks], in their order, and the times from the first [s]."""
    with _opened(file) as (box, stream):
        found = [packet.pts for packet in box.demux(stream) if packet.size and not packet.is_discard]
        tick, usual = stream.time_base or Fraction(1, TICKS), stream.average_rate
    if None in found:  # a format without times
        if rate is None:
            raise InputError(f"{file} has no times of its frames: give the rate, in frames per second.")
        found = list(range(len(found)))
    stamps = np.unique(np.array(found, dtype=float))
    if rate is not None:
        return stamps, np.arange(len(stamps)) / rate
    ticks = stamps - stamps[:1]
    step = even_step(ticks, float(1 / (usual * tick)) if usual else 0.0)
    return stamps, on_grid(ticks, step) * tick.numerator / tick.denominator


def even_step(ticks: Floats, usual: float) -> float:
    """Step of an even grid with gaps that all ticks are rounded from, as in containers that count milliseconds; 0 without one.

    ticks: shape (n,), increasing; usual: step by the header of the video [ticks].
    """
    if len(ticks) < 3:
        return 0.0
    waits = np.diff(ticks, prepend=0.0)
    number = np.cumsum(np.round(waits / np.median(waits[1:])))
    for step in (usual, float(np.polyfit(number, ticks, 1)[0])):
        if step > 1.0 and np.ptp(ticks - on_grid(ticks, step)) <= ROUNDED:
            return step
    return 0.0


def on_grid(ticks: Floats, step: float) -> Floats:
    """Return the nearest places of an even grid; a step of 0 is no grid."""
    return step * np.round(ticks / step) if step else ticks


def _local(file: Path) -> str:
    """Return a name that FFmpeg opens as a local file; otherwise it reads 'http:' or 'tcp:' as a protocol."""
    address = re.match(r"([A-Za-z][A-Za-z0-9+.-]+):[/\\]+", str(file))
    if address is not None and not file.exists():
        shown = f"{address[1]}://{str(file)[address.end() :]}"
        raise InputError(f"{shown} is an address; a film must be a file on this machine.")
    file.stat()  # fails where there is none, as for other files
    return f"file:{file}"


@contextmanager
def _opened(file: Path) -> Iterator[tuple[Any, Any]]:
    """Open a video: its container and its stream of pictures."""
    av = need("av", "track")
    try:
        with av.open(_local(file)) as box:
            if not box.streams.video:
                raise InputError(f"{file} has no video.")
            yield box, box.streams.video[0]
    except av.error.FFmpegError as error:
        reason = str(getattr(error, "strerror", None) or error).rstrip(".")
        raise InputError(f"{file} cannot be read as a video: {reason}.") from None


def _picture(frame: Any, stream: Any, row: int, t: float, file: Path) -> Picture:
    """Return a frame with square pixels, turned and mirrored by the display matrix of its file."""
    aspect, tall = stream.sample_aspect_ratio or 1, frame.height
    wide = round(frame.width * aspect / 2) * 2 if aspect != 1 else frame.width
    if min(wide, tall) < SMALLEST or max(wide, tall) > LARGEST:
        raise InputError(f"{file} has pictures of {wide} × {tall} pixels; each side must be from {SMALLEST} to {LARGEST}.")
    if frame.format.name not in ("yuv420p", "yuvj420p") or wide != frame.width:
        frame = frame.reformat(width=wide, height=tall, format="yuv420p")
    planes = [_plane(plane) for plane in frame.planes[:3]]
    chroma = (0.5 if stream.codec_context.name in CENTRED_CHROMA else 0.0, 0.5)
    matrix = next((bytes(data) for data in frame.side_data if data.type.name == "DISPLAYMATRIX"), None)
    if matrix is not None:
        a, b, _, c, d = np.frombuffer(matrix, dtype=np.int32)[:5].tolist()
        if abs(b) > abs(a):
            planes, chroma, a, d = [plane.T for plane in planes], chroma[::-1], c, b
        across, down = (-1 if way < 0 else 1 for way in (a, d))
        planes = [plane[::down, ::across] for plane in planes]
        chroma = (0.5 + across * (chroma[0] - 0.5), 0.5 + down * (chroma[1] - 0.5))
    luma, blue, red = (np.ascontiguousarray(plane) for plane in planes)
    return Picture(row, t, luma, blue, red, chroma)


def _plane(plane: Any) -> Bytes:
    values = np.frombuffer(plane, dtype=np.uint8).reshape(-1, plane.line_size)
    return values[: plane.height, : plane.width]


def sample_pictures(
    path: str | Path, rate: float | None, since: float | None = None, until: float | None = None, least: int = STILLS
) -> list[Picture]:
    """Return the first picture of a video and every n-th after it, in memory that does not grow with its length.

    rate, since, until: as in `pictures`; least: there are as many pictures or up to twice as many, or all [1].
    """
    t = picture_times(path, rate, since, until)
    wanted = set(t[:: max(1, len(t) // least)].tolist())
    found = [picture for picture in pictures(path, rate, since, until) if picture.t in wanted]
    if len(found) < 3:
        window = ("" if since is None else f" from {since:g} s on") + ("" if until is None else f" up to {until:g} s")
        count = f"{len(found)} frame{'s' if len(found) != 1 else ''}"
        raise InputError(f"{path} has {count}{window}; tracking needs at least 3.")
    return found


def rgb(picture: Picture) -> Bytes:
    """Convert a picture to RGB.

    rgb: shape (height, width, 3), cut to even sides; red, green and blue [1].
    """
    wide, tall = (side // 2 for side in picture.size)
    planes = picture.luma[: 2 * tall, : 2 * wide], picture.blue[:tall, :wide], picture.red[:tall, :wide]
    together = np.concatenate([plane.ravel() for plane in planes]).reshape(3 * tall, 2 * wide)
    frame = need("av", "track").VideoFrame.from_ndarray(together, format="yuv420p")
    return np.asarray(frame.to_ndarray(format="rgb24"))


@contextmanager
def open_writer(path: Path, size: tuple[int, int], every: int | None = None) -> Iterator[Callable[[Bytes, float], None]]:
    """Open a film for writing; it appears whole or not at all.

    path: ends in .mp4; size: width and height [pixel]; every: frames between key frames, for players that seek [1]; add:
    function that appends an RGB picture, shown from a time on [s].
    """
    av = need("av", "track")
    last = -1
    with replacing(path) as fresh, av.open(str(fresh), "w", format="mp4") as box:
        stream = box.add_stream("libx264", rate=30)
        stream.width, stream.height = size[0] // 2 * 2, size[1] // 2 * 2
        stream.pix_fmt = "yuv420p"
        stream.time_base = stream.codec_context.time_base = Fraction(1, TICKS)
        stream.options = {"crf": "20", "preset": "veryfast"} | ({} if every is None else {"g": str(every)})

        def add(colours: Bytes, t: float) -> None:
            nonlocal last
            image = np.ascontiguousarray(colours[: stream.height, : stream.width])
            frame = av.VideoFrame.from_ndarray(image, format="rgb24")
            last = max(last + 1, round(t * TICKS))
            frame.pts, frame.time_base = last, Fraction(1, TICKS)
            box.mux(stream.encode(frame))

        yield add
        box.mux(stream.encode())


def jpeg(colours: Bytes) -> bytes:
    """Encode a picture as JPEG.

    colours: shape (height, width, 3), red, green and blue [1].
    """
    file = BytesIO()
    need("PIL.Image", "track").fromarray(colours).save(file, "JPEG")
    return file.getvalue()
