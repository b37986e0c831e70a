"""The lab over HTTP: the page with its files, and the files of a motion that need Python."""

from __future__ import annotations

import asyncio
import hashlib
import ipaddress
import json
import logging
import re
import socket
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import anyio
from starlette.applications import Starlette
from starlette.datastructures import Headers, MutableHeaders
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Route

from hophoop.lab.api.files import TYPES
from hophoop.lab.server.work import REFUSED
from hophoop.lab.site.export import POLICY, page_text, site_files, static_text

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

logger = logging.getLogger("hophoop.lab")

MAKER = (sys.executable, "-m", "hophoop.lab.server.work")
PATIENCE = 180.0  # seconds that a file may take
READING = 15.0  # seconds in which a body has to arrive
BODY = 65_536  # bytes
WAITING = 8  # files that may wait for the one that is made
GONE = 499  # nginx's status for a client that has disconnected; nobody reads it
LOOK = 0.2  # seconds between checks whether a client is still there
SECURITY = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'self'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
MEDIA = {
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".txt": "text/plain; charset=utf-8",
    ".json": "application/json",
    ".wasm": "application/wasm",
}
# Of the page, what only an exported folder needs.
FOLDER_ONLY = re.compile(
    r'<(?:meta http-equiv|meta name="hophoop-site"|link rel="manifest").*\n|\n<p class="loading late">.*?</p>'
)
FOREVER = {"Cache-Control": "public, max-age=31536000, immutable"}


def create_app(names: Iterable[str] = (), backdrop: Backdrop | None = None) -> Starlette:
    """Return the whole lab as an ASGI application.

    Parameters
    ----------
    names : iterable of str, optional
        Names under which the lab is reached, besides addresses, localhost and this machine's own.
    backdrop : Backdrop, optional
        A film to show under the hoop.

    Returns
    -------
    app : Starlette
    """
    known = {"localhost", socket.gethostname().lower(), *(name.lower() for name in names)}
    routes = [
        Route("/", _page(backdrop is not None)),
        Route("/static/{tag}/{name}", _asset),
        Route("/favicon.ico", _icon),
        Route("/files/{name}", _file, methods=["POST"]),
    ]
    app = Starlette(
        routes=routes + ([] if backdrop is None else _film_routes(backdrop)),
        middleware=[Middleware(_Guard, known=known), Middleware(GZipMiddleware, minimum_size=1000, compresslevel=6)],
        exception_handlers={HTTPException: _refused},
    )
    app.state.one = anyio.CapacityLimiter(1)  # films and netCDF, one at a time
    return app


# --- the page ------------------------------------------------------------------------------------------------


@cache
def _assets() -> dict[str, bytes]:
    return {path.removeprefix("static/"): content for path, content in site_files().items() if path.startswith("static/")}


@cache
def _tag() -> str:
    """Return a hash of all files: scripts name each other relative to themselves."""
    return hashlib.sha256(b"".join(_assets().values())).hexdigest()[:16]


def html(filmed: bool = False) -> str:
    """Return the document; addresses of its files hold a hash of their content, so that browsers may keep them.

    Parameters
    ----------
    filmed : bool, default False
        True if a film is shown under the hoop.

    Returns
    -------
    text : str
    """
    text = FOLDER_ONLY.sub("", page_text("index.html"))
    if filmed:
        text = text.replace("</head>", '<script type="module" src="backdrop.js"></script>\n</head>')
    return text.replace('="static/', f'="static/{_tag()}/')


def _page(filmed: bool) -> Any:
    async def page(request: Request) -> Response:
        return Response(html(filmed), media_type="text/html", headers={"Cache-Control": "no-cache"})

    return page


# Not StaticFiles: the files lie in two folders, and no other file of these may be reached.
async def _asset(request: Request) -> Response:
    name = request.path_params["name"]
    if name not in _assets():
        raise HTTPException(404, "There is no such file.")
    return Response(_assets()[name], media_type=MEDIA[Path(name).suffix], headers=FOREVER)


async def _icon(request: Request) -> Response:
    return Response(_assets()["icon.svg"], media_type=MEDIA[".svg"], headers={"Cache-Control": "public, max-age=86400"})


def _film_routes(backdrop: Backdrop) -> list[Route]:
    async def place(request: Request) -> Response:
        return JSONResponse(backdrop.to_dict())

    async def film(request: Request) -> Response:
        return FileResponse(backdrop.film, media_type="video/mp4")

    async def following(request: Request) -> Response:
        return Response(static_text("backdrop.js"), media_type=MEDIA[".js"])

    return [Route("/film.json", place), Route("/film.mp4", film), Route("/backdrop.js", following)]


# --- files of a motion -----------------------------------------------------------------------------------------


async def _file(request: Request) -> Response:
    """Make a file of the scenario in the body; the work ends when the client is gone or the time is over."""
    name = request.path_params["name"]
    if name not in TYPES:
        raise HTTPException(404, f"The file must be one of {', '.join(TYPES)}.")
    body = await _body(request)
    one: anyio.CapacityLimiter = request.app.state.one
    if one.statistics().tasks_waiting >= WAITING:
        raise HTTPException(503, "The lab is busy; try again in a minute.", {"Retry-After": "60"})
    try:
        return await _answer(request, name, body, one)
    except anyio.get_cancelled_exc_class():  # the server stops
        return Response(status_code=GONE)


async def _answer(request: Request, name: str, body: bytes, one: anyio.CapacityLimiter) -> Response:
    status, content = GONE, b""
    async with anyio.create_task_group() as group:
        group.start_soon(_end_when_gone, request, group.cancel_scope)
        async with one:
            with anyio.move_on_after(PATIENCE) as deadline:
                status, content = await _made(name, body)
            if deadline.cancelled_caught:
                status, content = 413, json.dumps({"detail": f"The file takes longer than {PATIENCE:g} s."}).encode()
        group.cancel_scope.cancel()
    if status == GONE:
        return Response(status_code=GONE)
    headers = {"Content-Disposition": f'attachment; filename="hophoop-{name}"'} if status == 200 else {}
    return Response(content, status, headers, TYPES[name] if status == 200 else "application/json")


async def _made(name: str, body: bytes) -> tuple[int, bytes]:
    """Return the status of HTTP and the content; the process that makes it ends when this is cancelled."""
    pipe = subprocess.PIPE
    process = await asyncio.create_subprocess_exec(*MAKER, name, stdin=pipe, stdout=pipe, stderr=pipe)
    try:
        made, complaint = await process.communicate(body)
    finally:
        if process.returncode is None:
            process.kill()
    if process.returncode == 0:
        return 200, made
    if process.returncode == REFUSED:
        status, said = json.loads(made)
        return status, json.dumps(said).encode()
    logger.error("The process that made %s ended with status %s: %s", name, process.returncode, complaint.decode()[-2000:])
    return 500, json.dumps({"detail": "The computation failed."}).encode()


async def _body(request: Request) -> bytes:
    """Return the body, which has to be JSON: a form on another site can send any type but this one."""
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise HTTPException(415, f"Content-Type = {kind[:60]!r} must be application/json.")
    body = b""
    try:
        with anyio.fail_after(READING):
            async for piece in request.stream():
                body += piece
                if len(body) > BODY:
                    raise HTTPException(413, f"The body has more than {BODY} bytes.", {"Connection": "close"})
    except TimeoutError:
        raise HTTPException(408, "The body of the request did not arrive.", {"Connection": "close"}) from None
    except ClientDisconnect:
        raise HTTPException(GONE) from None
    return body


async def _end_when_gone(request: Request, work: anyio.CancelScope) -> None:
    while not await request.is_disconnected():
        await anyio.sleep(LOOK)
    work.cancel()


async def _refused(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    return JSONResponse({"detail": error.detail}, error.status_code, error.headers)


# --- who may ask -----------------------------------------------------------------------------------------------


class _Guard:
    """Refuse requests under foreign names: a page elsewhere may let its own name resolve to this machine (DNS rebinding).

    Addresses cannot be rebound. Starlette's TrustedHostMiddleware has patterns of names, but none for any address.
    """

    def __init__(self, app: Any, known: set[str]) -> None:
        self.app = app
        self.known = known

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return

        async def secured(message: Any) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message).update(SECURITY)
            await send(message)

        host = Headers(scope=scope).get("host", "")
        if self._knows(host_name(host)):
            await self.app(scope, receive, secured)
            return
        said = f"Host = {host[:80]!r} is not a name of this lab; `hophoop lab --name` says under which it is reached."
        await JSONResponse({"detail": said}, 403)(scope, receive, secured)

    def _knows(self, name: str) -> bool:
        if name in self.known or name.endswith(".localhost"):
            return True
        try:
            ipaddress.ip_address(name)
        except ValueError:
            return False
        return True


def host_name(header: str) -> str:
    """Return the name in a Host header, without its port.

    Parameters
    ----------
    header : str
        For example ``localhost:8765`` or ``[::1]:8765``.

    Returns
    -------
    name : str
        In lower case; empty if the header is invalid.
    """
    name = header.strip().lower()
    if name.startswith("["):
        return name[1:].partition("]")[0]
    return name.partition(":")[0] if name.count(":") <= 1 else ""
