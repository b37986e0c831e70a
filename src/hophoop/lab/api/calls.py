"""Answers to programs, page and widget, independent of HTTP: each call takes JSON and returns a reply."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from hophoop.lab.api import files, motion_map, requests
from hophoop.lab.api.limits import USUAL, Limits, TooMuch, turns_of, within
from hophoop.lab.api.motion import columns, result
from hophoop.lab.api.packing import pack
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.base import Frozen
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.theory.summary import summary_dict

LIGHT_SAMPLES, LIGHT_TURNS = 2000, 2000.0  # beyond these a request counts as heavy


@dataclass(frozen=True)
class Reply:
    """A reply: JSON, and for some calls arrays that are packed after it."""

    header: dict[str, Any]
    arrays: dict[str, Any] | None = None

    def packed(self) -> bytes:
        """Return the reply as one block of bytes."""
        return pack(finite(self.header), self.arrays or {})

    def json(self) -> bytes:
        """Return the reply as JSON; values that are not finite become null."""
        content = {**self.header, **{name: array.tolist() for name, array in (self.arrays or {}).items()}}
        content = finite(content)
        return json.dumps(content, allow_nan=False, ensure_ascii=False, separators=(",", ":")).encode()


@dataclass(frozen=True)
class Request:
    """A checked request: its call and options; its scenario is the default one if the call takes none."""

    call: str
    body: Any

    @cached_property
    def scenario(self) -> Scenario:
        """The scenario of the request."""
        asked = isinstance(self.body, requests.ScenarioRequest)
        return self.body.asked() if asked else Scenario()

    @property
    def tag(self) -> str:
        """Return a tag that is equal for equal requests to equal versions, however their scenario was written."""
        asked = isinstance(self.body, requests.ScenarioRequest)
        return requests.tag_of(self.call, self.scenario, self.body.options() if asked else {})


def finite(value: Any) -> Any:
    """Replace infinity and nan by None, because JSON has neither."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return value


def computed(scenario: Scenario, limits: Limits = USUAL) -> Trajectory:
    """Compute a motion within the limits of a request; too many events end it early with status 'event_limit'.

    Raises
    ------
    TooMuch
        If it is longer or stiffer than the limits allow.
    """
    return simulate(within(scenario, limits))


def shown(motion: Trajectory, scenario: Scenario | None = None) -> Reply:
    """Return the results and columns of a computed motion for the player; `scenario` is the one shown with it."""
    return Reply(result(motion, scenario), columns(motion))


def _motion(request: Request, limits: Limits) -> Reply:
    motion, window = computed(request.scenario, limits), request.body.window
    return shown(motion, request.scenario) if window is None else Reply({}, columns(motion, window=window))


def _simulate(request: Request, limits: Limits) -> Reply:
    """Return the motion in the format of result files, with `samples` equally spaced states."""
    motion = computed(request.scenario, limits)
    if motion.status == "event_limit" and request.scenario.contact.max_events > limits.events:
        raise TooMuch(
            f"The motion has {limits.events} events within {motion.duration:.4g} s, as many as the lab "
            f"computes; ask for a duration below {request.scenario.duration:g} s."
        )
    header = {**motion.to_dict(), "scenario": request.scenario.to_dict()}
    if request.body.samples:
        sample = motion.at(motion.times(request.body.samples))
        header["samples"] = {field.name: getattr(sample, field.name).tolist() for field in dataclasses.fields(sample)}
    return Reply(header)


def _theory(request: Request, limits: Limits) -> Reply:
    return Reply(summary_dict(request.scenario))


def _map(request: Request, limits: Limits) -> Reply:
    body = request.body
    header, values = motion_map.motion_map(request.scenario, body.x, body.y, body.what, limits)
    return Reply(header, {"values": values})


def _file(request: Request, limits: Limits) -> Reply:
    """Return a file for download, for the widget; the page has a URL for each."""
    content = files.KINDS[request.body.name].make(request.scenario, limits)
    return Reply({"name": request.body.name}, {"content": np.frombuffer(content, np.uint8)})


class Call(NamedTuple):
    """Arguments of a call, and the function that answers it."""

    takes: type[Frozen]
    answer: Callable[[Request, Limits], Reply]


CALLS: dict[str, Call] = {
    "simulate": Call(requests.SimulateRequest, _simulate),
    "theory": Call(requests.ScenarioRequest, _theory),
    "map": Call(requests.MapRequest, _map),
    "motion": Call(requests.MotionRequest, _motion),
    "file": Call(requests.FileRequest, _file),
}


def read(call: str, body: Any, limits: Limits = USUAL) -> Request:
    """Check a request.

    Parameters
    ----------
    call : str
        A key of `CALLS`.
    body : dict or Frozen
        JSON: `scenario` or `query`, optional `changes` to it (pairs of path and value), and the call's options; or a request
        that has been checked already.
    limits : Limits, optional

    Returns
    -------
    request : Request

    Raises
    ------
    ValueError
        If there is no such call, or the body does not fit it.
    """
    if call not in CALLS:
        raise InputError.of_field("call", call, f"one of {', '.join(CALLS)}")
    checked = body if isinstance(body, Frozen) else requests.validated(CALLS[call].takes, body)
    if isinstance(checked, requests.ScenarioRequest):
        checked.bounded(limits)
    request = Request(call, checked)
    request.scenario  # noqa: B018 - a link or a change that is not allowed is said now
    return request


def bounded(request: Request, limits: Limits = USUAL) -> None:
    """Refuse a request beyond the limits, before it is queued.

    Parameters
    ----------
    request : Request
    limits : Limits, optional

    Raises
    ------
    TooMuch
        If it exceeds the limits.
    """
    if request.call == "map":
        motion_map.bounded(request.scenario, request.body.x, request.body.y, request.body.what, limits)
    elif request.call in ("motion", "simulate"):
        within(request.scenario, limits)


def cost(request: Request, limits: Limits = USUAL) -> str:
    """Return the lane of the server for a request.

    Parameters
    ----------
    request : Request
    limits : Limits, optional

    Returns
    -------
    lane : {'light', 'heavy'}
        Light requests are answered at once.
    """
    scenario = request.scenario
    many = request.call == "map" or getattr(request.body, "samples", 0) > LIGHT_SAMPLES
    long = not scenario.duration <= limits.duration or turns_of(scenario) > LIGHT_TURNS
    return "heavy" if many or long or scenario.contact.model == "compliant" else "light"


def answer(request: Request, limits: Limits = USUAL) -> Reply:
    """Answer a checked request.

    Parameters
    ----------
    request : Request
    limits : Limits, optional

    Returns
    -------
    reply : Reply

    Raises
    ------
    TooMuch
        If it exceeds the limits.
    """
    return CALLS[request.call].answer(request, limits)
