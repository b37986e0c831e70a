"""The page and its files, read once and served from memory."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from fastapi import FastAPI, Response
from fastapi.responses import FileResponse, JSONResponse

from hophoop.lab.site.export import POLICY, site_files, static_text

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

SECURITY_HEADERS = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'self'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
SCRIPT = "text/javascript; charset=utf-8"


@cache
def _assets() -> dict[str, tuple[bytes, str, str]]:
    """Return name → content, type and tag."""
    kinds = {
        ".js": SCRIPT,
        ".css": "text/css; charset=utf-8",
        ".svg": "image/svg+xml",
        ".png": "image/png",
        ".txt": "text/plain; charset=utf-8",
        ".json": "application/json",
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


def mount(app: FastAPI, backdrop: Backdrop | None = None) -> None:
    """Add the page, and the film under its hoop, to the application."""
    if backdrop is not None:
        _mount_film(app, backdrop)

    @app.get("/", include_in_schema=False)
    async def index() -> Response:
        return Response(html(backdrop is not None), media_type="text/html", headers={"Cache-Control": "no-cache"})

    # Not StaticFiles: served names differ from those on disk, and no other file of the folder may be reached.
    @app.get("/static/{tag}/{name}", include_in_schema=False)
    async def asset(tag: str, name: str) -> Response:
        if name not in _assets():
            return Response("There is no such file.", 404, media_type="text/plain")
        content, kind, _ = _assets()[name]
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
    async def following() -> Response:
        return Response(static_text("backdrop.js"), media_type=SCRIPT)
