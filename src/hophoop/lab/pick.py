"""A small page on which to click the rim, the marker and the ground in a still of a film, as hints for tracking."""

from __future__ import annotations

import json
import threading
import webbrowser
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from http.server import ThreadingHTTPServer
from importlib.resources import files
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlparse

import numpy as np

from hophoop.lab.server import LOOPBACK, Answer
from hophoop.scenario import InputError
from hophoop.tracking.circle import fit_circle
from hophoop.tracking.hints import Hints
from hophoop.tracking.video import Bytes, Picture, jpeg, rgb, sample_pictures

MOST_BYTES = 10_000  # of a request


def pick(video: str | Path, hints: Hints | None = None, show: Callable[[str], Any] = webbrowser.open) -> Hints:
    """Open a page with stills of a film and wait until the user has clicked in one.

    Parameters
    ----------
    video : str or Path
    hints : Hints, optional
        Known hints, which remain unless clicked.
    show : callable, optional
        Called with the page's address; opens a browser by default.

    Returns
    -------
    hints : Hints
        Hints with the rim, and with the marker's colour and the ground if they were clicked.

    Raises
    ------
    ValueError
        If the film cannot be read.
    OSError
        If it cannot be opened.
    ImportError
        If PyAV is missing.
    """
    known = hints or Hints()
    stills = sample_pictures(video, known.rate)
    page = Page(stills, known, Path(video).name)
    server = ThreadingHTTPServer((LOOPBACK, 0), partial(_Answer, page))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        show(f"http://{LOOPBACK}:{server.server_address[1]}/")
        page.done.wait()
    finally:
        server.shutdown()
        server.server_close()
    return page.hints


class Page:
    """The stills shown, and the hints clicked."""

    def __init__(self, stills: list[Picture], hints: Hints, name: str) -> None:
        self.stills, self.hints, self.name = stills, hints, name
        self.done = threading.Event()

    def html(self) -> str:
        """Return the page."""
        times = json.dumps([round(still.t, 6) for still in self.stills])
        text = files("hophoop.lab").joinpath("static/pick.html").read_text(encoding="utf-8")
        return text.replace("__TIMES__", times).replace("__NAME__", json.dumps(self.name).replace("<", "\\u003c"))

    def still(self, number: int) -> bytes:
        """Return a still as JPEG."""
        return jpeg(rgb(self.stills[number]))

    def take(self, said: Any) -> None:
        """Convert clicks to hints.

        Raises
        ------
        ValueError
            If the clicks do not make a circle, or the data is malformed.
        """
        self.hints = clicked(said, self.stills, self.hints)
        self.done.set()


def clicked(said: Any, stills: list[Picture], hints: Hints) -> Hints:
    """Return hints from clicks.

    Parameters
    ----------
    said : dict
        ``still``, the number of the picture; ``rim``, three or more points; ``marker``, a point or None; ``ground``, two points
        or none.
    stills : list of Picture
    hints : Hints
        Known hints.

    Returns
    -------
    hints : Hints

    Raises
    ------
    ValueError
        If the clicks do not make a circle, or the data is malformed.
    """
    try:
        still = stills[int(said["still"])]
        rim = np.array(said["rim"], dtype=float).reshape(-1, 2)
        ground = np.array(said.get("ground") or [], dtype=float).reshape(-1, 2)
        marker = said.get("marker")
        spot = None if marker is None else np.array(marker, dtype=float).reshape(2)
    except (KeyError, IndexError, TypeError, ValueError, AttributeError):
        raise InputError("The clicks cannot be read.") from None
    if len(rim) < 3:
        raise InputError(f"{len(rim)} points on the rim are not enough: click at least 3.")
    (centre, radius), _ = fit_circle(rim @ [1.0, 1.0j])
    wide, tall = still.size
    if not (np.isfinite([centre, radius]).all() and 5 < radius < 2 * max(wide, tall)):
        raise InputError("The points on the rim do not lie on a circle.")
    values: dict[str, Any] = {"centre": (centre.real, centre.imag), "rim": radius, "at": still.t}
    if spot is not None:
        values["marker_color"] = colour_at(rgb(still), spot[0], spot[1])
    if len(ground) == 2:
        values["ground"] = (ground[0, 0], ground[0, 1], ground[1, 0], ground[1, 1])
    return replace(hints, **values)


def colour_at(image: Bytes, x: float, y: float) -> str:
    """Return the colour around a point, as #rrggbb.

    Parameters
    ----------
    image : ndarray, shape (height, width, 3)
        [1]
    x, y : float
        [pixel]

    Returns
    -------
    colour : str
    """
    column, row = (round(v) for v in (x, y))
    near = image[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].reshape(-1, 3)
    if not len(near):
        raise InputError("The marker was clicked outside the picture.")
    return "#" + "".join(f"{round(value):02x}" for value in np.median(near, axis=0))


def _read(body: bytes) -> Any:
    try:
        return json.loads(body)
    except (ValueError, RecursionError):
        raise InputError("The clicks cannot be read.") from None


class _Answer(Answer):
    def __init__(self, page: Page, *args: Any) -> None:
        self.page = page
        super().__init__(*args)

    def do_GET(self) -> None:
        """Answer with the page or a still."""
        address = urlparse(self.path)
        if address.path == "/":
            self.send("text/html; charset=utf-8", self.page.html().encode())
        elif address.path == "/still":
            try:
                image = self.page.still(int(parse_qs(address.query)["k"][0]))
            except (KeyError, ValueError, IndexError):
                self.send_error(404)
                return
            self.send("image/jpeg", image)
        else:
            self.send_error(404)

    def do_POST(self) -> None:
        """Receive the clicks."""
        length = int(self.headers.get("Content-Length") or 0)
        try:
            if not 0 < length <= MOST_BYTES:
                raise InputError("The clicks cannot be read.")
            self.page.take(_read(self.rfile.read(length)))
        except InputError as error:
            self.send("application/json", json.dumps({"error": str(error)}).encode(), 422)
            return
        self.send("application/json", b"{}")
