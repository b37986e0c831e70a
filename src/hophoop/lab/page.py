"""The page: one HTML document, one style sheet and one script, read once and served from memory.

Page and notebook widget share the script, because a widget takes a single file. It is built from the repository's web/lab and
web/space, see CONTRIBUTING.md.
"""

from __future__ import annotations

import gzip
import hashlib
from collections.abc import Mapping
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
    """Return the text of a file of static/."""
    return (files("hophoop.lab") / "static" / name).read_text(encoding="utf-8")


@cache
def script() -> str:
    """Return the page's script, whose default export is the widget's."""
    return static_text("lab.js")


@cache
def style() -> str:
    """Return the style sheet of page and widget."""
    return static_text("lab.css")


@cache
def _assets() -> dict[str, tuple[bytes, str, str]]:
    """Return name → content, type and tag."""
    kinds = {
        ".js": "text/javascript; charset=utf-8",
        ".css": "text/css; charset=utf-8",
        ".json": "application/json",
        ".svg": "image/svg+xml",
        ".txt": "text/plain; charset=utf-8",
    }
    found = {}
    for path, content in site_files().items():
        folder, _, name = path.rpartition("/")
        if folder == "static":
            kind = kinds.get(Path(name).suffix, "application/wasm")
            found[name] = (content, kind, hashlib.sha256(content).hexdigest()[:16])
    return found


def html(filmed: bool = False) -> str:
    """Return the document; names of assets contain a hash of their content, so that caches may keep them.

    Parameters
    ----------
    filmed : bool, default False
        True if a film is shown under the hoop.

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


def takes_gzip(headers: Mapping[str, str]) -> bool:
    """Return True if the client accepts a compressed answer.

    Parameters
    ----------
    headers : mapping of str to str
        Headers of the request.

    Returns
    -------
    takes : bool
    """
    for part in headers.get("accept-encoding", "").split(","):
        name, _, quality = part.partition(";")
        if name.strip().lower() == "gzip":
            return quality.replace(" ", "") not in ("q=0", "q=0.0", "q=0.00", "q=0.000")
    return False


@cache
def _compressed(content: bytes) -> bytes:
    return gzip.compress(content, 9, mtime=0)


def _sent(request: Request, content: bytes, kind: str, headers: dict[str, str]) -> Response:
    headers = {**headers, "Vary": "Accept-Encoding"}
    if not takes_gzip(request.headers):
        return Response(content, media_type=kind, headers=headers)
    return Response(_compressed(content), media_type=kind, headers={**headers, "Content-Encoding": "gzip"})


def mount(app: FastAPI, backdrop: Backdrop | None = None) -> None:
    """Add the page, and the film under its hoop, to the application."""
    if backdrop is not None:
        _mount_film(app, backdrop)

    @app.get("/", include_in_schema=False)
    async def index(request: Request) -> Response:
        return _sent(request, html(backdrop is not None).encode(), "text/html; charset=utf-8", {"Cache-Control": "no-cache"})

    # A table of names instead of a folder: no other file can be reached.
    @app.get("/static/{tag}/{name}", include_in_schema=False)
    async def asset(request: Request, tag: str, name: str) -> Response:
        found: Any = _assets().get(name)
        if found is None:
            return Response("There is no such file.", 404, media_type="text/plain")
        content, kind, _ = found
        return _sent(request, content, kind, {"Cache-Control": "public, max-age=31536000, immutable"})

    @app.get("/favicon.ico", include_in_schema=False)
    async def icon(request: Request) -> Response:
        content, kind, _ = _assets()["icon.svg"]
        return _sent(request, content, kind, {"Cache-Control": "public, max-age=86400"})


def _mount_film(app: FastAPI, backdrop: Backdrop) -> None:
    @app.get("/film.json", include_in_schema=False)
    async def place() -> JSONResponse:
        return JSONResponse(backdrop.to_dict())

    @app.get("/film.mp4", include_in_schema=False)
    async def film() -> FileResponse:
        return FileResponse(backdrop.film, media_type="video/mp4")

    @app.get("/backdrop.js", include_in_schema=False)
    async def following(request: Request) -> Response:
        return _sent(request, static_text("backdrop.js").encode(), "text/javascript; charset=utf-8", {})
