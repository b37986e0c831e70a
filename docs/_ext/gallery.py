"""The gallery: films and pages that an example has written become part of its page, and plots show their own pictures.

Matplotlib's figures are Sphinx-Gallery's business. What an example writes beside them is taken in and removed again.
"""

from __future__ import annotations

import base64
import re
import shutil
from pathlib import Path
from typing import Any

import av
from sphinx.application import Sphinx
from sphinx_gallery.scrapers import matplotlib_scraper

import hophoop as hh

# From simple to hard, in each part of the gallery.
SCALES = re.compile(r"maps/|strobe|diagram")  # examples whose colours mean numbers or classes
ORDER = [
    *("overview", "velocities", "path", "strobe", "gap", "contact_forces", "friction_utilization", "energies", "geometry"),
    *("strobe_forces", "phase_plane", "own_axes", "velocities_uncertain", "return_map", "diagram", "branch", "track"),
    *("sweep", "hop_height", "fates", "open_map", "points", "boundary", "borders", "logarithmic"),
    *("design", "catalogue", "paradoxes"),
    *("film", "picture", "panels", "compare", "film_3d", "scene", "jam", "gears", "player"),
]
SHOWN = ("hophoop.plots.", "hophoop.maps.", "hophoop.animate.")
VIDEO = (
    '<video class="on-paper-not" controls loop muted playsinline aria-label="{title}" style="max-width:100%;height:auto" '
    'width="{width}" height="{height}" src="data:video/mp4;base64,{data}"></video>'
)


class FromSimpleToHard:
    """Sphinx-Gallery's key of an example."""

    def __init__(self, folder: str) -> None:
        """Sphinx-Gallery gives the folder, which does not matter."""

    def __call__(self, name: str) -> int:
        return ORDER.index(name.removeprefix("plot_").removesuffix(".py"))


def drawings(block: Any, variables: dict[str, Any], conf: dict[str, Any], **options: Any) -> str:
    """A scraper: what Matplotlib has drawn; the class of maps and scales of colours keeps their colours on dark pages."""
    drawn = str(matplotlib_scraper(block, variables, conf, format="svg", **options))
    return drawn.replace(":class: ", ":class: scale ") if SCALES.search(variables["src_file"]) else drawn


def films(block: Any, variables: dict[str, Any], conf: dict[str, Any]) -> str:
    """A scraper: what the last block has made, as reStructuredText; its first picture serves as the thumbnail."""
    space, parts = variables["example_globals"], []
    last = space.get("___")
    if hasattr(last, "data") and hasattr(last, "size") and isinstance(last.data, bytes):
        parts.append(_film(last.data, variables))
        space["___"] = None
    if hasattr(last, "savefig") and getattr(last, "number", None) is None:  # a figure that pyplot does not know
        image = Path(next(variables["image_path_iterator"])).with_suffix(".svg")
        last.savefig(image)
        parts.append(
            f".. image:: images/{image.name}\n   :alt: {block[1].strip().splitlines()[-1]}\n   :class: sphx-glr-single-img\n"
        )
        space["___"] = None
    folder = Path(variables["src_file"]).parent
    for path in sorted(folder.glob("[!.]*.mp4")):
        parts.append(_film(path.read_bytes(), variables))
        path.unlink()
    for path in sorted(folder.glob("*.html")):
        image = Path(next(variables["image_path_iterator"]))
        shutil.move(path, image.with_suffix(".html"))
        _picture_of_scene(space["motion"], image)
        parts.append(f".. image:: images/{image.name}\n   :alt: The scene of the page\n")
        parts.append(f":download:`Open the page <images/{image.with_suffix('.html').name}>`\n")
    return "\n".join(parts)


def _film(data: bytes, variables: dict[str, Any]) -> str:
    """The film as an element of the page, and a picture from its middle as a file."""
    path = Path(next(variables["image_path_iterator"]))
    film = path.with_suffix(".mp4")
    film.write_bytes(data)
    size = _picture_of_film(film, path)
    film.unlink()
    video = VIDEO.format(
        title="Film of the example", width=size[0], height=size[1], data=base64.b64encode(data).decode("ascii")
    )
    still = f".. image:: images/{path.name}\n   :alt: A picture of the film\n   :class: on-paper-only\n"
    return f".. raw:: html\n\n    {video}\n\n{still}"


def _picture_of_film(film: Path, path: Path) -> tuple[int, int]:
    with av.open(str(film)) as box:
        frames = list(box.decode(video=0))
    shown = frames[len(frames) * 6 // 10].to_image()
    shown.save(path)
    size: tuple[int, int] = shown.size
    return size


def _picture_of_scene(motion: Any, path: Path) -> None:
    film = path.with_suffix(".mp4")
    look = hh.animate.Look3D(size=(800, 450), camera="side")
    hh.animate.film_3d(motion, film, hh.animate.Timing(fps=10, start=0.0, end=0.3), look)
    _picture_of_film(film, path)
    film.unlink()


def add_pictures(app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Under a function of plots, maps and animate: the gallery's pictures that use it."""
    if what in ("function", "class") and name.startswith(SHOWN):
        file = Path(app.srcdir, "gallery", "used", f"{name}.examples")
        if file.is_file() and file.stat().st_size:
            lines += ["", ".. rubric:: In the gallery", "", f".. minigallery:: {name}", ""]


def setup(app: Sphinx) -> dict[str, Any]:
    """After numpydoc has read the docstring."""
    app.connect("autodoc-process-docstring", add_pictures, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
