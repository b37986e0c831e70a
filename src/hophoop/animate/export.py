"""Pictures into films: mp4, webm, gif and PNG, streamed to the encoder that imageio-ffmpeg ships."""

from __future__ import annotations

import os
import queue
import re
import shutil
import subprocess
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from hophoop._support.extras import need
from hophoop._support.files import replacing, require_folder_of
from hophoop._support.stopping import child, temporary_folder
from hophoop.animate.canvas import Bytes
from hophoop.scenario import InputError

Progress = Callable[[int, int], None]
FORMATS = (".mp4", ".webm", ".gif", ".png")
PALETTE_PICTURES = 32
MAX_GIF_FPS = 50.0
WAITING = 3  # pictures between the painter and the encoder


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
        """Pictures a second [1/s]."""

    def draw(self, k: int) -> Bytes:
        """The k-th picture, height × width × RGBA."""


def format_of(path: str | Path) -> str:
    """The format that a file's name asks for.

    Parameters
    ----------
    path : str or Path
        Ends in .mp4, .webm, .gif or .png; without an ending, or with a slash, a folder for PNG pictures.

    Returns
    -------
    format : str
        'mp4', 'webm', 'gif' or 'png'.

    Raises
    ------
    ValueError
        If it ends otherwise.
    """
    suffix = Path(path).suffix.lower()
    if suffix == "" or str(path).endswith(("/", os.sep)):
        return "png"
    if suffix not in FORMATS:
        raise InputError.of_field("out", str(path), f"{', '.join(FORMATS)}, or be a folder for pictures", rule="must end in")
    return suffix[1:]


def write(pictures: Pictures, path: str | Path, progress: Progress | None = None) -> Path:
    """Draw and encode a film.

    The pictures go to the encoder as they are drawn. The file gets its name when it is whole; what was there
    before stays until then.

    Parameters
    ----------
    pictures : Pictures
    path : str or Path
        By its ending mp4 (H.264), webm (VP9), gif, or numbered PNG pictures: `film.png` gives film-00000.png
        and so on, a folder gets 00000.png and so on. The folder of a file must exist; a folder for pictures is made.
    progress : callable, optional
        Called with the number of pictures done and of all.

    Returns
    -------
    path : Path
        The film; of PNG pictures their folder.

    Raises
    ------
    ValueError
        If the format is unknown, or cannot hold the size or the number of pictures a second.
    FileExistsError
        If a folder for pictures holds something already.
    OSError
        If the file cannot be written, or the encoder fails.
    ImportError
        If the encoder is missing.
    """
    kind = format_of(path)
    target = Path(path)
    if kind == "png":
        return _write_png(pictures, target, progress)
    check_film(kind, pictures.size, pictures.fps)
    with temporary_folder() as folder, replacing(target) as part:
        inputs: list[str] = []
        if kind == "gif":
            palette = folder / "palette.png"
            _encode(_sampled(pictures), _command(pictures, _PALETTE, palette))
            inputs = ["-i", str(palette)]
        _encode(_all(pictures, progress), _command(pictures, _OPTIONS[kind], part, inputs))
    return target


def check_film(kind: str, size: tuple[int, int], fps: float) -> None:
    """Refuse what a format cannot hold.

    Parameters
    ----------
    kind : {'mp4', 'webm', 'gif', 'png'}
    size : (int, int)
        Width and height [pixels].
    fps : float
        Pictures a second [1/s].

    Raises
    ------
    ValueError
        If mp4 or webm have an odd side, or a gif more than 50 pictures a second.
    """
    if kind in ("mp4", "webm") and (size[0] % 2 or size[1] % 2):
        raise InputError.of_field("size", size, f"even numbers in a film of kind {kind}")
    if kind == "gif" and fps > MAX_GIF_FPS:
        raise InputError.of_field("fps", fps, f"at most {MAX_GIF_FPS:g} in a gif: browsers slow down faster ones")


_PALETTE = ["-vf", "palettegen=max_colors=255:reserve_transparent=0:stats_mode=full", "-frames:v", "1"]
# H.264 in the profile that every browser plays, its index in front; colours as in HDTV, and said so.
_BT709 = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
_TAGS = ["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"]
_OPTIONS = {
    "mp4": [
        "-vf", _BT709, "-c:v", "libx264", "-preset", "veryfast", "-crf", "19", "-profile:v", "high",
        "-movflags", "+faststart", *_TAGS,
    ],
    "webm": [
        "-vf", _BT709, "-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "30", "-deadline", "realtime",
        "-cpu-used", "6", "-row-mt", "1", *_TAGS,
    ],
    # Without dithering, flat areas stay flat, and only the rectangle that changed is stored.
    "gif": ["-lavfi", "[0:v][1:v]paletteuse=dither=none:diff_mode=rectangle", "-loop", "0"],
}  # fmt: skip


def _command(pictures: Pictures, options: list[str], out: Path, inputs: list[str] | None = None) -> list[str]:
    width, height = pictures.size
    return [
        need("imageio_ffmpeg", "films").get_ffmpeg_exe(),
        *("-hide_banner", "-loglevel", "error", "-nostdin", "-y"),
        *("-f", "rawvideo", "-pix_fmt", "rgb0", "-s", f"{width}x{height}", "-r", f"{pictures.fps:.9g}"),
        *("-i", "pipe:0"),
        *(inputs or []),
        *options,
        *("-an", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"),
        str(out),
    ]  # fmt: skip


def _all(pictures: Pictures, progress: Progress | None) -> Iterator[Bytes]:
    for k in range(pictures.count):
        yield pictures.draw(k)
        if progress is not None:
            progress(k + 1, pictures.count)


def _sampled(pictures: Pictures) -> Iterator[Bytes]:
    # A palette from every picture would need the film twice, or all of it in memory.
    for k in np.unique(np.linspace(0, pictures.count - 1, min(PALETTE_PICTURES, pictures.count)).astype(int)):
        yield pictures.draw(int(k))


def _encode(pictures: Iterable[Bytes], command: list[str]) -> None:
    """Send pictures to the encoder, drawing the next while it takes the last."""
    with (
        tempfile.TemporaryFile() as said,
        child(subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said)) as encoder,
    ):
        assert encoder.stdin is not None
        waiting: queue.Queue[bytes | None] = queue.Queue(WAITING)
        broken = threading.Event()

        def send() -> None:
            while (data := waiting.get()) is not None:
                try:
                    if not broken.is_set():
                        encoder.stdin.write(data)  # type: ignore[union-attr]
                except OSError:
                    broken.set()  # the encoder has gone; what it said is reported below

        sender = threading.Thread(target=send, name="film", daemon=True)
        sender.start()
        try:
            for picture in pictures:
                if broken.is_set():
                    break
                waiting.put(picture.tobytes())
        except BaseException:
            broken.set()
            encoder.kill()
            raise
        finally:
            waiting.put(None)
            sender.join()
            try:
                encoder.stdin.close()
            except OSError:
                broken.set()
            code = encoder.wait()
        if code != 0 or broken.is_set():
            said.seek(0)
            words = "; ".join(said.read().decode(errors="replace").split("\n")).strip("; ")[:400]
            raise OSError(f"The encoder failed ({code}): {words or 'it said nothing'}")


def _write_png(pictures: Pictures, target: Path, progress: Progress | None) -> Path:
    if target.suffix:
        folder, stem = target.parent, f"{target.stem}-"
        require_folder_of(target, target)
    else:
        folder, stem = target, ""
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise FileExistsError(f"{folder} is there already and not an empty folder.")
    home = folder if target.suffix else folder.parent
    home.mkdir(parents=True, exist_ok=True)
    with temporary_folder(".film-", home) as part:
        for k, picture in enumerate(_all(pictures, progress)):
            save_png(picture, part / f"{stem}{k:05d}.png")
        folder.mkdir(exist_ok=True)
        if target.suffix:
            # a longer film of before must not go on behind this one
            for old in folder.iterdir():
                if re.fullmatch(re.escape(stem) + r"\d{5,}\.png", old.name):
                    old.unlink()
        for file in sorted(part.iterdir()):
            shutil.move(file, folder / file.name)
    return folder


def save_png(picture: Bytes, path: Path) -> None:
    """Write one picture.

    Parameters
    ----------
    picture : ndarray of uint8, shape (height, width, 3 or 4)
        Values from 0 to 255 [1].
    path : Path
    """
    image = need("PIL.Image", "films")
    image.fromarray(np.ascontiguousarray(picture[..., :3])).save(path, compress_level=4)


@contextmanager
def bar(title: str) -> Iterator[Progress]:
    """A progress bar on standard error.

    Parameters
    ----------
    title : str
        What stands before it.

    Returns
    -------
    progress : callable
        To be given to `write`.
    """
    progress_module: Any = import_module("rich.progress")
    console = import_module("rich.console").Console(stderr=True)
    with progress_module.Progress(
        *progress_module.Progress.get_default_columns(),
        progress_module.MofNCompleteColumn(),
        console=console,
        transient=True,
        disable=not (console.is_terminal or console.is_jupyter),  # a file would get an empty line
    ) as shown:
        task = shown.add_task(title, total=None)

        def tell(done: int, total: int) -> None:
            shown.update(task, completed=done, total=total)

        yield tell
