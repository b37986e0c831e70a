"""The lab over HTTP: the programming interface under /api/v1, the page's own calls, the page itself.

Stateless: every answer follows from its request alone, so that any number of workers can serve it and any
cache may keep it. That is also why the page is plain modules on FastAPI and not a NiceGUI page, which keeps a
session for each visitor in one process.
"""

from __future__ import annotations

import asyncio
import json
import logging
from collections.abc import Callable
from typing import Any
from urllib.parse import parse_qs

import anyio
from anyio import to_thread
from fastapi import FastAPI, Request, Response
from fastapi.responses import JSONResponse

import hophoop
from hophoop.lab import files, openapi, page, state
from hophoop.lab.limits import USUAL, Limits, TooBusy, TooMuch
from hophoop.scenario import InputError

logger = logging.getLogger("hophoop.lab")

Compute = Callable[[], bytes]


class Gate:
    """Lets so many requests compute, so many wait, and turns the others away."""

    def __init__(self, threads: int, waiting: int, patience: float) -> None:
        self.waiting = waiting
        self.patience = patience
        self.inside = 0
        self._threads = threads
        self._limiter: anyio.CapacityLimiter | None = None

    async def run(self, compute: Compute) -> bytes:
        """Compute in a thread.

        Raises
        ------
        TooBusy
            If too many requests wait already.
        TooMuch
            If it takes too long.
        """
        if self.inside >= self.waiting:
            raise TooBusy("The lab is busy; try again in a second.")
        if self._limiter is None:
            self._limiter = anyio.CapacityLimiter(self._threads)
        self.inside += 1
        try:
            async with asyncio.timeout(self.patience):
                return await to_thread.run_sync(compute, limiter=self._limiter, abandon_on_cancel=True)
        except TimeoutError:
            raise TooMuch(
                f"This takes longer than {self.patience:g} s; ask for a shorter motion or fewer cells."
            ) from None
        finally:
            self.inside -= 1


def create_app(limits: Limits = USUAL) -> FastAPI:
    """The whole lab as an ASGI application.

    Parameters
    ----------
    limits : Limits, optional
        Bounds of one request.

    Returns
    -------
    app : FastAPI
    """
    # The usual documentation pages load scripts from elsewhere; /openapi.json is enough for any tool.
    app = FastAPI(title="hophoop lab", version=hophoop.__version__, docs_url=None, redoc_url=None)
    gate = Gate(2, limits.waiting, limits.patience)
    # a film keeps a core busy for a while: one at a time, and few that wait
    film_gate = Gate(1, 3, limits.film_patience)
    app.openapi = lambda: openapi.document(app.version)  # type: ignore[method-assign]

    @app.exception_handler(InputError)
    async def _bad_input(request: Request, error: InputError) -> JSONResponse:
        return JSONResponse({"detail": str(error)}, 413 if isinstance(error, TooMuch) else 422)

    @app.exception_handler(TooBusy)
    async def _busy(request: Request, error: TooBusy) -> JSONResponse:
        return JSONResponse({"detail": str(error)}, 429, headers={"Retry-After": "1"})

    @app.exception_handler(ImportError)
    async def _missing(request: Request, error: ImportError) -> JSONResponse:
        return JSONResponse({"detail": str(error)}, 501)

    @app.middleware("http")
    async def _guard(request: Request, following: Any) -> Response:
        response: Response = await following(request)
        response.headers.update(page.SECURITY_HEADERS)
        return response

    async def reply(request: Request, call: str, body: Any, packed: bool = False) -> Response:
        asked = state.read(call, body, limits)
        tag = f'"{asked.tag}{"-b" if packed else ""}"'
        headers = {"ETag": tag, "Cache-Control": "public, max-age=0, must-revalidate", "Vary": "Accept"}
        if tag in _tags(request.headers.get("if-none-match", "")):
            return Response(status_code=304, headers=headers)

        def compute() -> bytes:
            answered = state.answer(asked, limits)
            return answered.packed() if packed else answered.json()

        kind = "application/octet-stream" if packed else "application/json"
        return Response(await gate.run(compute), media_type=kind, headers=headers)

    @app.post("/api/v1/simulate")
    async def simulate(request: Request) -> Response:
        body: dict[str, Any] = {"scenario": await _json(request, limits)}
        samples = _query_whole(request, "samples")
        if samples is not None:
            body["samples"] = samples
        return await reply(request, "simulate", body)

    @app.post("/api/v1/theory")
    async def theory(request: Request) -> Response:
        return await reply(request, "theory", {"scenario": await _json(request, limits)})

    @app.post("/api/v1/map")
    async def map_of_motions(request: Request) -> Response:
        body = await _json(request, limits)
        return await reply(request, "map", body, packed=_wants_bytes(request))

    @app.post("/lab/{call}")
    async def lab_call(request: Request, call: str) -> Response:
        if call not in state.CALLS:
            return JSONResponse({"detail": f"There is no call {call!r}."}, 404)
        return await reply(request, call, await _json(request, limits), packed=True)

    @app.get("/api/v1/files/{name}")
    async def download(request: Request, name: str) -> Response:
        if name not in files.KINDS:
            known = ", ".join(files.KINDS)
            return JSONResponse({"detail": f"file = {name!r} must be one of {known}."}, 404)
        asked = state.read("film", {"query": request.url.query}, limits)
        tag = f'"{asked.tag}-{name}"'
        headers = {"ETag": tag, "Content-Disposition": f'attachment; filename="hophoop-{name}"'}
        if tag in _tags(request.headers.get("if-none-match", "")):
            return Response(status_code=304, headers=headers)
        kind = files.KINDS[name]
        content = await (film_gate if kind.slow else gate).run(lambda: kind.make(asked.scenario, limits))
        return Response(content, media_type=kind.media_type, headers=headers)

    @app.api_route("/healthz", methods=["GET", "HEAD"])
    async def health() -> dict[str, str]:
        return {"status": "ok", "version": hophoop.__version__}

    page.mount(app)
    return app


def _tags(header: str) -> set[str]:
    return {tag.strip().removeprefix("W/") for tag in header.split(",")}


def _wants_bytes(request: Request) -> bool:
    return "application/octet-stream" in request.headers.get("accept", "")


def _query_whole(request: Request, name: str) -> int | None:
    given = parse_qs(request.url.query, keep_blank_values=True).get(name)
    if given is None:
        return None
    try:
        return int(given[-1])
    except ValueError:
        raise InputError(f"{name} = {given[-1][:60]!r} must be a whole number.") from None


async def _json(request: Request, limits: Limits) -> Any:
    """The body as JSON, refused before it is read whole if it is too large."""
    kind = request.headers.get("content-type", "application/json").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise InputError(f"Content-Type = {kind[:60]!r} must be application/json.")
    size, pieces = 0, []
    async for piece in request.stream():
        size += len(piece)
        if size > limits.body:
            raise TooMuch(f"The body has more than {limits.body} bytes.")
        pieces.append(piece)
    try:
        return json.loads(b"".join(pieces) or b"{}", parse_constant=_no_constant)
    except InputError:
        raise
    except (ValueError, RecursionError) as error:
        raise InputError(f"The body is not valid JSON: {str(error).rstrip('.')}.") from None


def _no_constant(name: str) -> float:
    raise InputError(f"The body is not valid JSON: it holds {name}, which JSON does not have.")
