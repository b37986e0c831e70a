"""The lab over HTTP: the programming interface under /api/v1, motions that the page cannot decide, and the page itself.

Stateless: every answer follows from its request alone, so any number of workers can serve requests, and any cache may keep
answers. A NiceGUI page would keep a session per visitor in one process, so the page consists of plain modules on FastAPI.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import re
from collections.abc import AsyncIterator, Callable, Coroutine, Iterable
from typing import TYPE_CHECKING, Annotated, Any

from fastapi import Body, FastAPI, HTTPException, Path, Query, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from fastapi.routing import APIRoute, APIRouter
from pydantic import AfterValidator
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect

from hophoop._support.errors import json_words, shortened
from hophoop._support.extras import MissingExtra
from hophoop._version import __version__
from hophoop.lab.api import calls, files, replies, requests
from hophoop.lab.api.limits import USUAL, Limits, TooBusy
from hophoop.lab.api.refusals import refusal
from hophoop.lab.server import page
from hophoop.lab.server.guard import HEAD, Guard
from hophoop.lab.server.pool import FILM, HEAVY, Pool, while_connected
from hophoop.lab.server.work import Job
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.sentences import findings_sentence, parse_reason

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

PACK = 1000  # bytes; larger answers are compressed
CLOSE = {"Connection": "close"}  # the rest of a body would keep the connection
GONE = 499  # nginx's status for a client that has disconnected; nobody reads it


def create_app(
    limits: Limits = USUAL, names: Iterable[str] = (), pool: Pool | None = None, backdrop: Backdrop | None = None
) -> FastAPI:
    """Return the whole lab as an ASGI application.

    Parameters
    ----------
    limits : Limits, optional
        Bounds of one request, and the number of processes.
    names : iterable of str, optional
        Names under which the lab is reached, besides addresses, localhost and this machine's own.
    pool : Pool, optional
        Processes that compute; new ones by default.
    backdrop : Backdrop, optional
        A film to show under the hoop.

    Returns
    -------
    app : FastAPI
    """
    # The usual documentation pages load scripts from other sites; /openapi.json is enough for any tool.
    computing = Pool(limits) if pool is None else pool

    @contextlib.asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        computing.prepare()
        yield
        computing.close()

    app = FastAPI(
        title="hophoop lab",
        version=__version__,
        description="Exact motion of a loaded hoop on a plane. Equal requests have equal ETags.",
        docs_url=None,
        redoc_url=None,
        generate_unique_id_function=lambda route: route.name,
        lifespan=lifespan,
    )
    app.state.limits = limits
    app.state.pool = computing

    @app.exception_handler(InputError)
    @app.exception_handler(MissingExtra)
    async def _refused(request: Request, error: InputError | MissingExtra) -> JSONResponse:
        status, body = refusal(error)
        return JSONResponse(body, status)

    @app.exception_handler(RequestValidationError)
    async def _not_valid(request: Request, error: RequestValidationError) -> JSONResponse:
        # the first element names the location of a value: body, path or query
        found = [{**finding, "loc": finding["loc"][1:]} for finding in error.errors()]
        with json_words():
            return JSONResponse({"detail": findings_sentence(found)}, 422)

    @app.exception_handler(TooBusy)
    async def _busy(request: Request, error: TooBusy) -> JSONResponse:
        return JSONResponse({"detail": str(error)}, 503, headers={"Retry-After": str(error.seconds)})

    app.add_middleware(GZipMiddleware, minimum_size=PACK, compresslevel=6)
    app.add_middleware(Guard, names=names)  # the outermost: it also answers HEAD
    app.include_router(router)
    page.mount(app, backdrop)
    return app


class LabRequest(Request):
    """A request with a JSON body of limited size, refused before it is read completely if it is too long."""

    async def body(self) -> bytes:
        """Return the body; an empty one counts as an empty object, so that the reference case needs no body.

        Raises
        ------
        HTTPException
            If it is too long or of another type.
        """
        if not hasattr(self, "_body"):
            try:
                async with asyncio.timeout(self.app.state.limits.reading):
                    self._body = await self._whole() or b"{}"
            except TimeoutError:
                raise HTTPException(408, "The body of the request did not arrive.", CLOSE) from None
        return self._body

    async def _whole(self) -> bytes:
        most = self.app.state.limits.body
        size, pieces = 0, []
        async for piece in self.stream():
            size += len(piece)
            if size > most:
                raise HTTPException(413, f"The body has more than {most} bytes.", CLOSE)
            pieces.append(piece)
        body = b"".join(pieces)
        kind = self.scope.get(WRITTEN, "").partition(";")[0].strip().lower()
        # a form on another site can send any type but this one
        if body and kind != JSON:
            raise HTTPException(415, f"Content-Type = {kind[:60]!r} must be {JSON}.")
        coding = self.headers.get("content-encoding", "").strip().lower()
        if body and coding not in ("", "identity"):
            raise HTTPException(415, f"Content-Encoding = {coding[:60]!r} must be identity: send the body as it is.")
        return body

    async def json(self) -> Any:
        """Return the body as JSON.

        Raises
        ------
        HTTPException
            If it is not valid JSON.
        """
        try:
            body = await self.body()
            found = json.loads(body, parse_constant=_no_constant, object_pairs_hook=_no_twice)
            if re.search(rb"\\u[dD][89a-fA-F]", body):
                json.dumps(found, ensure_ascii=False).encode()  # an unpaired surrogate cannot be encoded again
            return found
        except (ValueError, RecursionError) as error:
            raise HTTPException(422, f"The body is not valid JSON: {parse_reason(error)}.") from None


class LabRoute(APIRoute):
    """A route whose requests are `LabRequest`."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Return FastAPI's handler, with requests read as `LabRequest`."""
        following = super().get_route_handler()

        async def handle(request: Request) -> Response:
            # FastAPI would pass a body of another type on as bytes, without our checks
            scope = {**request.scope, WRITTEN: request.headers.get("content-type", "")}
            others = [(name, value) for name, value in scope["headers"] if name != b"content-type"]
            scope["headers"] = [*others, (b"content-type", JSON.encode())]
            try:
                with json_words():
                    return await following(LabRequest(scope, request.receive))
            except (ClientDisconnect, asyncio.CancelledError):  # the client has disconnected, or the server stops
                return Response(status_code=GONE)

        return handle


JSON = "application/json"
WRITTEN = "hophoop.content-type"  # content type of the request, before it was replaced
router = APIRouter(route_class=LabRoute)


async def _reply(request: Request, call: str, body: Any, packed: bool = False) -> Response:
    limits = request.app.state.limits
    asked = calls.read(call, body, limits)
    tag = f'W/"{asked.tag}{"-b" if packed else ""}"'  # weak: the same content compressed or not
    headers = {"ETag": tag, "Cache-Control": "public, max-age=0, must-revalidate", "Vary": "Accept"}
    if _tag(tag) in _tags(request.headers.get("if-none-match", "")):
        return Response(status_code=304, headers=headers)
    calls.bounded(asked, limits)
    content = await _computed(request, Job(asked, limits, "packed" if packed else "json"), calls.cost(asked, limits))
    kind = "application/octet-stream" if packed else JSON
    return answered(content, kind, headers)


async def _computed(request: Request, job: Job, cost: str) -> bytes | None:
    """Compute a job in a process; None if the client disconnects, which also stops the job."""

    async def work() -> bytes:
        content: bytes = await request.app.state.pool.run(job, cost)
        return content

    async def gone() -> None:
        while (await request.receive())["type"] != "http.disconnect":
            pass

    return await while_connected(work(), gone())


def answered(content: bytes | None, kind: str, headers: dict[str, str]) -> Response:
    """Return a response of a media type; no content if the client has disconnected."""
    return Response(status_code=GONE) if content is None else Response(content, media_type=kind, headers=headers)


@router.post(
    "/api/v1/simulate",
    summary="Compute a motion",
    response_model=replies.Result,
    responses=replies.responses(413, 415, 422, 503),
)
async def simulate(
    request: Request,
    scenario: Annotated[Scenario, Body()],
    samples: Annotated[
        int,
        Query(ge=0, description="How many equally spaced states to add; 0 for none, never 1"),
        AfterValidator(requests.not_one),
    ] = 0,
) -> Response:
    """Return events, final state and energies of the motion of a scenario."""
    return await _reply(request, "simulate", requests.SimulateRequest(scenario=scenario, samples=samples))


@router.post(
    "/api/v1/theory",
    summary="Thresholds of theory",
    response_model=replies.Theory,
    responses=replies.responses(413, 415, 422, 503),
)
async def theory(request: Request, scenario: Annotated[Scenario, Body()]) -> Response:
    """Return the thresholds of theory for the hoop of a scenario."""
    return await _reply(request, "theory", requests.ScenarioRequest(scenario=scenario))


@router.post(
    "/api/v1/map",
    summary="A map over two parameters",
    response_model=replies.Map,
    responses=replies.responses(413, 415, 422, 503),
)
async def map_of_motions(request: Request, body: Annotated[requests.MapRequest, Body()]) -> Response:
    """Return one quantity of the motion at the middle of each cell, packed as bytes if `Accept` asks for them."""
    return await _reply(request, "map", body, packed=_wants_bytes(request))


@router.post("/lab/motion", include_in_schema=False)
async def motion(request: Request, body: Annotated[requests.MotionRequest, Body()]) -> Response:
    """Return results and columns of a motion that doubles do not decide, for the page."""
    return await _reply(request, "motion", body, packed=True)


@router.get(
    "/api/v1/files/{name}",
    summary="A file of a motion",
    response_class=Response,
    responses={
        **replies.responses(404, 413, 422, 501, 503),
        200: {
            "description": "The file",
            "content": {kind.media_type: {} for kind in files.KINDS.values()},
        },
    },
)
async def download(
    request: Request,
    name: Annotated[
        str,
        Path(
            description="The file; the query is a scenario's link, such as plane.mu=0.5&start.speed=2.8",
            json_schema_extra={"enum": list(files.KINDS)},
        ),
    ],
) -> Response:
    """Return the scenario, the motion or a film of it as a file."""
    limits = request.app.state.limits
    if name not in files.KINDS:
        raise HTTPException(404, f"file = {name!r} must be one of {', '.join(files.KINDS)}.")
    asked = calls.read("motion", {"query": request.url.query}, limits)
    tag = f'W/"{asked.tag}-{name}"'
    headers = {"ETag": tag, "Content-Disposition": f'attachment; filename="hophoop-{name}"'}
    if _tag(tag) in _tags(request.headers.get("if-none-match", "")):
        return Response(status_code=304, headers=headers)
    kind = files.KINDS[name]
    if HEAD in request.scope:  # no film is rendered for a HEAD request
        return Response(media_type=kind.media_type, headers=headers)
    content = await _computed(request, Job(asked, limits, name), FILM if kind.slow else HEAVY)
    return answered(content, kind.media_type, headers)


@router.get("/healthz", summary="Whether the server answers")
async def health() -> replies.Health:
    """Return the version of the server."""
    return replies.Health(status="ok", version=__version__)


def _tags(header: str) -> set[str]:
    return {_tag(tag) for tag in header.split(",")}


def _tag(tag: str) -> str:
    return tag.strip().removeprefix("W/")


def _wants_bytes(request: Request) -> bool:
    return "application/octet-stream" in request.headers.get("accept", "")


def _no_twice(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        keys = [key for key, _ in pairs]
        twice = next(key for key in keys if keys.count(key) > 1)
        raise ValueError(f"it gives the key {json.dumps(shortened(twice), ensure_ascii=False)} twice")
    return found


def _no_constant(name: str) -> float:
    raise ValueError(f"it holds {name}, which JSON does not have")
