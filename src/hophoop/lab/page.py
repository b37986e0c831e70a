"""The page: one HTML document, one style sheet and one script, read once and served from memory.

The script is the same for the page and the notebook widget, which takes a single file. It is built from the modules
in the repository's web/lab and web/space, see CONTRIBUTING.md.
"""

from __future__ import annotations

import hashlib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from fastapi import FastAPI, Request, Response
from fastapi.responses import FileResponse, JSONResponse

from hophoop.lab.site import POLICY, site_files

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

SECURITY_HEADERS = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'self'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}


def static_text(name: str) -> str:
    """Text of a file of static/."""
    return (files("hophoop.lab") / "static" / name).read_text(encoding="utf-8")


@cache
def script() -> str:
    """The page's script, whose default export is the widget's."""
    return static_text("lab.js")


@cache
def style() -> str:
    """The style sheet, also of the widget."""
    return static_text("style.css")


@cache
def _assets() -> dict[str, tuple[bytes, str, str]]:
    """Name → content, type and tag."""
    kinds = {".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8", ".svg": "image/svg+xml"}
    found = {}
    for path, content in site_files().items():
        folder, _, name = path.rpartition("/")
        if folder == "static":
            kind = kinds.get(Path(name).suffix, "application/wasm")
            found[name] = (content, kind, hashlib.sha256(content).hexdigest()[:16])
    return found


def html(filmed: bool = False) -> str:
    """The document; the names of its assets change with their content, so that caches may keep them.

    Parameters
    ----------
    filmed : bool, default False
        Whether a film lies under the hoop.

    Returns
    -------
    text : str
    """
    text = static_text("index.html")
    if filmed:
        text = text.replace("</head>", '<script type="module" src="backdrop.js"></script>\n</head>')
    for name, (_, _, tag) in _assets().items():
        text = text.replace(f"static/{name}", f"static/{tag}/{name}")
    return text


def mount(app: FastAPI, backdrop: Backdrop | None = None) -> None:
    """Add the page to the application, and the film under its hoop."""
    if backdrop is not None:
        _mount_film(app, backdrop)

    # those who watch over a server ask with HEAD
    @app.api_route("/", methods=["GET", "HEAD"], include_in_schema=False)
    async def index() -> Response:
        return Response(
            html(backdrop is not None), media_type="text/html; charset=utf-8", headers={"Cache-Control": "no-cache"}
        )

    # A table of names, not a folder: no other file can be reached.
    @app.get("/static/{tag}/{name}", include_in_schema=False)
    async def asset(request: Request, tag: str, name: str) -> Response:
        found: Any = _assets().get(name)
        if found is None:
            return Response("There is no such file.", 404, media_type="text/plain")
        content, kind, _ = found
        return Response(content, media_type=kind, headers={"Cache-Control": "public, max-age=31536000, immutable"})

    @app.get("/favicon.ico", include_in_schema=False)
    async def icon() -> Response:
        content, kind, _ = _assets()["icon.svg"]
        return Response(content, media_type=kind, headers={"Cache-Control": "public, max-age=86400"})


def _mount_film(app: FastAPI, backdrop: Backdrop) -> None:
    @app.get("/film.json", include_in_schema=False)
    async def place() -> JSONResponse:
        return JSONResponse(backdrop.to_dict())

    @app.get("/film.mp4", include_in_schema=False)
    async def film() -> FileResponse:
        return FileResponse(backdrop.film, media_type="video/mp4")

    @app.get("/backdrop.js", include_in_schema=False)
    async def script() -> Response:
        return Response(static_text("backdrop.js"), media_type="text/javascript; charset=utf-8")
