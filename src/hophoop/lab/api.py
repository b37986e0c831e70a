"""The lab over HTTP: the programming interface under /api/v1, the page's own calls, the page itself.

Stateless: every answer follows from its request alone, so that any number of workers can serve it and any
cache may keep it. That is also why the page is plain modules on FastAPI and not a NiceGUI page, which keeps a
session for each visitor in one process.
"""

from __future__ import annotations

import asyncio
import json
import logging
from collections.abc import Callable, Coroutine
from typing import TYPE_CHECKING, Annotated, Any

import anyio
from anyio import to_thread
from fastapi import Body, FastAPI, HTTPException, Path, Query, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from fastapi.routing import APIRoute, APIRouter
from pydantic import AfterValidator

import hophoop
from hophoop._jit.beside import busy as compiling
from hophoop.lab import calls, files, page, replies, requests
from hophoop.lab.limits import USUAL, Limits, TooBusy, TooMuch
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.sentences import findings_sentence

if TYPE_CHECKING:
    from hophoop.fitting import Backdrop

logger = logging.getLogger("hophoop.lab")

Compute = Callable[[], bytes]
LOOK = 0.5  # seconds between two looks whether code is compiled meanwhile


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
            If it takes too long; time in which code is compiled does not count.
        """
        if self.inside >= self.waiting:
            raise TooBusy("The lab is busy; try again in a second.")
        if self._limiter is None:
            self._limiter = anyio.CapacityLimiter(self._threads)
        self.inside += 1
        work = asyncio.ensure_future(to_thread.run_sync(compute, limiter=self._limiter, abandon_on_cancel=True))
        left = self.patience
        try:
            while left > 0.0:
                look = min(left, LOOK)
                done, _ = await asyncio.wait({work}, timeout=look)
                if done:
                    return work.result()
                if not compiling():  # which is no fault of the request
                    left -= look
            raise TooMuch(f"This takes longer than {self.patience:g} s; ask for a shorter motion or fewer cells.")
        finally:
            work.cancel()
            self.inside -= 1


def create_app(limits: Limits = USUAL, backdrop: Backdrop | None = None) -> FastAPI:
    """The whole lab as an ASGI application.

    Parameters
    ----------
    limits : Limits, optional
        Bounds of one request.
    backdrop : Backdrop, optional
        A film to lay under the hoop.

    Returns
    -------
    app : FastAPI
    """
    # The usual documentation pages load scripts from elsewhere; /openapi.json is enough for any tool.
    app = FastAPI(
        title="hophoop lab",
        version=hophoop.__version__,
        description="Exact motion of a loaded hoop on a plane. Equal requests have equal ETags.",
        docs_url=None,
        redoc_url=None,
        generate_unique_id_function=lambda route: route.name,
    )
    app.state.limits = limits
    app.state.gate = Gate(2, limits.waiting, limits.patience)
    # a film keeps a core busy for a while: one at a time, and few that wait
    app.state.film_gate = Gate(1, 3, limits.film_patience)

    @app.exception_handler(InputError)
    async def _bad_input(request: Request, error: InputError) -> JSONResponse:
        return JSONResponse({"detail": str(error)}, 413 if isinstance(error, TooMuch) else 422)

    @app.exception_handler(RequestValidationError)
    async def _not_valid(request: Request, error: RequestValidationError) -> JSONResponse:
        # the first step says where a value stood: in the body, the address or the query
        found = [{**finding, "loc": finding["loc"][1:]} for finding in error.errors()]
        return JSONResponse({"detail": findings_sentence(found)}, 422)

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

    app.include_router(router)
    page.mount(app, backdrop)
    return app


class LabRequest(Request):
    """A request whose body is JSON, no longer than allowed, and refused before it is read whole if it is."""

    async def body(self) -> bytes:
        """The body; an empty one is an empty object, so that the reference case needs none.

        Raises
        ------
        HTTPException
            If it is too long or of another type.
        """
        if not hasattr(self, "_body"):
            kind = self.headers.get("content-type", JSON).partition(";")[0].strip().lower()
            if kind != JSON:
                raise HTTPException(422, f"Content-Type = {kind[:60]!r} must be {JSON}.")
            most = self.app.state.limits.body
            size, pieces = 0, []
            async for piece in self.stream():
                size += len(piece)
                if size > most:
                    raise HTTPException(413, f"The body has more than {most} bytes.")
                pieces.append(piece)
            self._body = b"".join(pieces) or b"{}"
        return self._body

    async def json(self) -> Any:
        """The body as JSON.

        Raises
        ------
        HTTPException
            If it is not valid.
        """
        try:
            return json.loads(await self.body(), parse_constant=_no_constant)
        except (ValueError, RecursionError) as error:
            why = str(error).rstrip(".")
            raise HTTPException(422, f"The body is not valid JSON: {why}.") from None


class LabRoute(APIRoute):
    """A route whose requests are `LabRequest`."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """What FastAPI calls, with the request read our way."""
        following = super().get_route_handler()

        async def handle(request: Request) -> Response:
            scope = request.scope
            if "content-type" not in request.headers:
                # FastAPI would take a body without a type for bytes
                scope = {**scope, "headers": [*scope["headers"], (b"content-type", JSON.encode())]}
            return await following(LabRequest(scope, request.receive))

        return handle


JSON = "application/json"
router = APIRouter(route_class=LabRoute)


async def _reply(request: Request, call: str, body: Any, packed: bool = False) -> Response:
    limits, gate = request.app.state.limits, request.app.state.gate
    asked = calls.read(call, body, limits)
    tag = f'"{asked.tag}{"-b" if packed else ""}"'
    headers = {"ETag": tag, "Cache-Control": "public, max-age=0, must-revalidate", "Vary": "Accept"}
    if tag in _tags(request.headers.get("if-none-match", "")):
        return Response(status_code=304, headers=headers)

    def compute() -> bytes:
        answered = calls.answer(asked, limits)
        return answered.packed() if packed else answered.json()

    kind = "application/octet-stream" if packed else JSON
    return Response(await gate.run(compute), media_type=kind, headers=headers)


@router.post(
    "/api/v1/simulate",
    summary="Compute a motion",
    response_model=replies.Result,
    responses=replies.responses(413, 422, 429),
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
    """Events, final state and energies of the motion of a scenario."""
    return await _reply(request, "simulate", requests.SimulateRequest(scenario=scenario, samples=samples))


@router.post(
    "/api/v1/theory",
    summary="Thresholds of theory",
    response_model=replies.Theory,
    responses=replies.responses(413, 422, 429),
)
async def theory(request: Request, scenario: Annotated[Scenario, Body()]) -> Response:
    """What theory says about the hoop of a scenario."""
    return await _reply(request, "theory", requests.ScenarioRequest(scenario=scenario))


@router.post(
    "/api/v1/map",
    summary="A map over two parameters",
    response_model=replies.Map,
    responses=replies.responses(413, 422, 429),
)
async def map_of_motions(request: Request, body: Annotated[requests.MapRequest, Body()]) -> Response:
    """One quantity of the motion in the middle of each cell; packed as bytes if `Accept` asks for them."""
    return await _reply(request, "map", body, packed=_wants_bytes(request))


@router.post("/lab/{call}", include_in_schema=False)
async def page_call(request: Request, call: str, body: Annotated[Any, Body()]) -> Response:
    """The page's own calls."""
    if call not in calls.CALLS:
        raise HTTPException(404, f"There is no call {call!r}.")
    asked = calls.read(call, body, request.app.state.limits)
    waiting = await to_thread.run_sync(calls.waits_for, asked)
    if waiting:  # the page says it and asks again
        return JSONResponse({"detail": waiting}, 202, headers={"Cache-Control": "no-store"})
    return await _reply(request, call, asked.body, packed=True)


@router.get(
    "/api/v1/files/{name}",
    summary="A file of a motion",
    response_class=Response,
    responses={
        **replies.responses(404, 413, 422, 429, 501),
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
    """The scenario, the motion or a film of it."""
    limits = request.app.state.limits
    if name not in files.KINDS:
        raise HTTPException(404, f"file = {name!r} must be one of {', '.join(files.KINDS)}.")
    asked = calls.read("film", {"query": request.url.query}, limits)
    tag = f'"{asked.tag}-{name}"'
    headers = {"ETag": tag, "Content-Disposition": f'attachment; filename="hophoop-{name}"'}
    if tag in _tags(request.headers.get("if-none-match", "")):
        return Response(status_code=304, headers=headers)
    kind = files.KINDS[name]
    gate = request.app.state.film_gate if kind.slow else request.app.state.gate
    content = await gate.run(lambda: kind.make(asked.scenario, limits))
    return Response(content, media_type=kind.media_type, headers=headers)


@router.get("/healthz", summary="Whether the server answers")
async def health() -> replies.Health:
    """The version that answers."""
    return replies.Health(status="ok", version=hophoop.__version__)


@router.head("/healthz", include_in_schema=False)
async def health_head() -> Response:
    """The same without a body, as those ask who watch over a server."""
    return Response()


def _tags(header: str) -> set[str]:
    return {tag.strip().removeprefix("W/") for tag in header.split(",")}


def _wants_bytes(request: Request) -> bool:
    return "application/octet-stream" in request.headers.get("accept", "")


def _no_constant(name: str) -> float:
    raise ValueError(f"it holds {name}, which JSON does not have")
