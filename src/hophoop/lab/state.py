"""What the page and the widget ask for, without a browser: each call takes JSON and gives a reply."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

import hophoop
from hophoop.lab import explore, files, frames, words
from hophoop.lab.controls import controls
from hophoop.lab.limits import USUAL, Limits, TooMuch, whole_number, within
from hophoop.lab.presets import presets
from hophoop.physics.body import MODE_LETTERS
from hophoop.scenario import Compliant, InputError, Scenario, time_unit
from hophoop.scenario.paths import contradiction
from hophoop.simulation import simulate
from hophoop.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.words import STATUSES


@dataclass(frozen=True)
class Reply:
    """An answer: JSON, and for some calls arrays that are packed behind it."""

    header: dict[str, Any]
    arrays: dict[str, Any] | None = None

    def packed(self) -> bytes:
        """As one block of bytes."""
        return frames.pack(finite(self.header), self.arrays or {})

    def json(self) -> bytes:
        """As JSON; what is not finite becomes null."""
        content = {**self.header, **{name: array.tolist() for name, array in (self.arrays or {}).items()}}
        content = finite(content)
        return json.dumps(content, allow_nan=False, ensure_ascii=False, separators=(",", ":")).encode()


def read_scenario(keys: Any) -> Scenario:
    """A scenario from JSON.

    Raises
    ------
    ValueError
        If it is not a table of a scenario's keys.
    """
    if not isinstance(keys, dict):
        raise InputError(f"scenario = {json.dumps(keys)[:60]} must be a table of keys.")
    return Scenario.from_dict(keys)


def changed(scenario: Scenario, changes: Any) -> Scenario:
    """The scenario with other values at some paths; where two say one thing, the later one counts.

    Raises
    ------
    ValueError
        If a path is unknown or a value not allowed.
    """
    if not isinstance(changes, list):
        raise InputError(f"changes = {json.dumps(changes)[:60]} must be a list of pairs of path and value.")
    values: dict[str, Any] = {}
    for change in changes:
        if not (isinstance(change, list) and len(change) == 2 and isinstance(change[0], str)):
            raise InputError(
                f"changes holds {json.dumps(change)[:60]}, which is not a pair of path and value."
            )
        if contradiction([*values, change[0]]):
            scenario, values = scenario.with_values(values), {}
        values[change[0]] = change[1]
    return scenario.with_values(values)


def computed(scenario: Scenario, limits: Limits = USUAL) -> Trajectory:
    """The motion, within the limits of a request; too many events end it early with status 'event_limit'.

    Raises
    ------
    TooMuch
        If it is longer or stiffer than the limits allow.
    """
    return simulate(within(scenario, limits))


def film(request: Request, limits: Limits) -> Reply:
    """A motion for the player: words, events and frames."""
    return film_of(computed(request.scenario, limits), request.scenario)


def film_of(motion: Trajectory, scenario: Scenario | None = None) -> Reply:
    """The same for a motion that is there already; `scenario` is what it is shown as."""
    scenario = motion.scenario if scenario is None else scenario
    hoop, plane = scenario.hoop, scenario.plane
    result = motion.to_dict()
    del result["scenario"]
    many = len(result["events"]) > 2000
    if many:
        result["events"] = result["events"][:2000]
    state = scenario.start.state(hoop)
    header = {
        **result,
        "scenario": scenario.to_dict(),
        "query": scenario.to_query(),
        "duration": motion.duration,
        # as the sliders show them, whichever way the scenario is given
        "values": {
            "hoop.radius": hoop.radius,
            "hoop.mass": hoop.mass,
            "hoop.load_fraction": hoop.load_fraction,
            "hoop.eccentricity": hoop.eccentricity,
            "hoop.inertia_ratio": hoop.inertia_ratio,
            "plane.mu": _finite(plane.mu),
            "plane.mu_static": _finite(plane.mu_static),
            "plane.mu_kinetic": _finite(plane.mu_kinetic),
            "start.speed": scenario.start.speed,
            "start.height": state.height,
            "start.vx": state.vx,
            "start.vy": state.vy,
            "start.omega": state.omega,
        },
        # what is chosen by itself where the scenario leaves it open
        "automatic": _automatic(scenario),
        "massless": hoop.massless,
        "summary": words.summary(motion),
        "story": words.story(motion),
        "ending": STATUSES[motion.status],
        "shortened": many,
    }
    return Reply(header, frames.columns(motion))


def _automatic(scenario: Scenario) -> dict[str, float]:
    contact = scenario.contact
    if not isinstance(contact, Compliant):
        return {}
    from hophoop.compliant.parameters import to_compliance

    _, chosen, _, _ = to_compliance(scenario)
    second = time_unit(scenario.hoop, scenario.plane)
    return {
        "contact.stiffness": chosen.k * scenario.hoop.mass / second**2,
        "contact.slip_speed": chosen.v_s * scenario.hoop.radius / second,
        "contact.restitution": scenario.plane.restitution,
    }


def _finite(value: float | None) -> float | str | None:
    return "inf" if value == float("inf") else value


def setup(request: Request, limits: Limits) -> Reply:
    """What the page needs once: controls, presets, colours, version."""
    return Reply(
        {
            "version": hophoop.__version__,
            "controls": controls(),
            "map_quantities": [[name, words] for name, (words, _) in explore.MAP_QUANTITIES.items()],
            "presets": [
                {
                    "key": p.key,
                    "group": p.group,
                    "title": p.title,
                    "text": p.text,
                    "query": p.scenario.to_query(),
                }
                for p in presets()
            ],
            "colors": {
                # by the letters of a hoop that rolls ahead; what is shown has the letter of its word
                "modes": dict(zip(MODE_LETTERS, colors.MODES.values(), strict=True)),
                "mode_names": dict(zip(MODE_LETTERS, colors.MODES, strict=True)),
                "gravity_center": colors.GRAVITY_CENTER,
                "airborne": colors.GRAVITY_CENTER_AIRBORNE,
                "center_speed": colors.CENTER_SPEED,
                "rotation_speed": colors.ROTATION_SPEED,
                "kinetic": colors.KINETIC,
                "potential": colors.POTENTIAL,
                "friction_loss": colors.FRICTION_LOSS,
                "impact_loss": colors.IMPACT_LOSS,
                "normal_force": colors.NORMAL_FORCE,
                "friction_force": colors.FRICTION_FORCE,
                "limit": colors.LIMIT,
            },
        }
    )


def code(request: Request, limits: Limits) -> Reply:
    """Python and TOML that make the same motion."""
    return Reply({"python": python_code(request.scenario), "toml": request.scenario.to_toml()})


def simulated(request: Request, limits: Limits) -> Reply:
    """The motion in the format of result files, with `samples` equally spaced states."""
    motion = computed(request.scenario, limits)
    if motion.status == "event_limit" and request.scenario.contact.max_events > limits.events:
        raise TooMuch(
            f"The motion has {limits.events} events within {motion.duration:.4g} s, as many as the lab "
            f"computes; ask for a duration below {request.scenario.duration:g} s."
        )
    header = {**motion.to_dict(), "scenario": request.scenario.to_dict()}
    count = request.options["samples"]
    if count:
        sample = motion.at(motion.times(count))
        header["samples"] = {
            field.name: getattr(sample, field.name).tolist() for field in dataclasses.fields(sample)
        }
    return Reply(header)


def finite(value: Any) -> Any:
    """JSON has no infinity and no nan: both become null."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return value


def python_code(scenario: Scenario) -> str:
    """Python that makes the same motion.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    code : str
        Its variable `motion` is the Trajectory.
    """
    contact = (
        "" if scenario.contact == type(scenario)().contact else f"    contact={_call(scenario.contact)},\n"
    )
    return (
        "import hophoop as hh\n\n"
        "motion = hh.simulate(\n"
        f"    {_call(scenario.hoop)},\n"
        f"    {_call(scenario.plane)},\n"
        f"    {_call(scenario.start)},\n"
        f"    duration={scenario.duration!r},\n"
        f"{contact}"
        ")\n"
        "print(motion.sequence, motion.status)\n"
        "for event in motion.events:\n"
        '    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")\n'
    )


def _call(model: Any) -> str:
    name = type(model).__name__
    keys = model.to_dict()
    if name == "Start" and "speed" in keys:
        name = "Start.rolling"
    parts = keys.pop("parts", None)
    usual = {"angle": 0.0, "x": 0.0} if name == "Start.rolling" else type(model)().to_dict()
    # what a reader will want to change is written out also where it is as usual
    arguments = [
        f"{key}={_argument(value)}"
        for key, value in keys.items()
        if key in ("load_fraction", "mu") or key not in usual or usual[key] != value
    ]
    if parts is not None:
        listed = ", ".join(_part(part) for part in model.parts)
        arguments.append(f"parts=[{listed}]")
    return f"hh.{name}({', '.join(arguments)})"


def _argument(value: Any) -> str:
    return 'float("inf")' if value == "inf" else repr(value)


def _part(part: Any) -> str:
    keys = {key: value for key, value in part.to_dict().items() if key != "shape"}
    return f"hh.{type(part).__name__}({', '.join(f'{key}={value!r}' for key, value in keys.items())})"


def thresholds(request: Request, limits: Limits) -> Reply:
    """What theory says about the scenario's hoop."""
    return Reply({"thresholds": explore.thresholds(request.scenario)})


def regions(request: Request, limits: Limits) -> Reply:
    """The regions of the (θ, θ̇) plane."""
    window = request.options["window"]
    return Reply({"window": window}, explore.regions(request.scenario, tuple(window)))


def motion_map(request: Request, limits: Limits) -> Reply:
    """A map over two parameters."""
    header, values = explore.motion_map(request.scenario, request.options, limits)
    return Reply(header, {"values": values})


def file(request: Request, limits: Limits) -> Reply:
    """A file for download, for the widget; the page has an address for each."""
    content = files.KINDS[request.options["name"]].make(request.scenario, limits)
    return Reply({"name": request.options["name"]}, {"content": np.frombuffer(content, np.uint8)})


@dataclass(frozen=True)
class Request:
    """A checked request: which call, for which scenario, with which options."""

    call: str
    scenario: Scenario
    options: dict[str, Any]

    @property
    def tag(self) -> str:
        """Equal for equal requests to equal versions, whatever way their scenario was written."""
        text = json.dumps(
            [hophoop.__version__, self.call, self.scenario.to_query(), self.options], sort_keys=True
        )
        return hashlib.sha256(text.encode()).hexdigest()[:32]


class Call(NamedTuple):
    """How a call's options are read, and how it is answered."""

    options: Callable[[Mapping[str, Any], Limits], dict[str, Any]]
    answer: Callable[[Request, Limits], Reply]


def no_options(body: Mapping[str, Any], limits: Limits) -> dict[str, Any]:
    """For calls that take a scenario only."""
    return {}


def sampling_options(body: Mapping[str, Any], limits: Limits) -> dict[str, Any]:
    """`samples`: how many equally spaced states, 0 for none."""
    return {"samples": whole_number(body.get("samples", 0), "samples", 0, limits.samples, but_not=1)}


def region_options(body: Mapping[str, Any], limits: Limits) -> dict[str, Any]:
    """`window`: the part of the (θ, θ̇) plane: θ from and to [rad], θ̇ from and to [rad/s].

    Raises
    ------
    ValueError
        If it is not four numbers, each pair rising.
    """
    window = body.get("window", [0.0, 2.0 * math.pi, -12.0, 12.0])
    numbers = isinstance(window, list) and all(
        isinstance(end, int | float) and not isinstance(end, bool) and abs(end) < 1e300 for end in window
    )
    if not numbers or len(window) != 4 or not (window[0] < window[1] and window[2] < window[3]):
        raise InputError(
            f"window = {json.dumps(window)[:60]} must be four numbers: θ from and to [rad], θ̇ from and to [rad/s]."
        )
    return {"window": [float(end) for end in window]}


def file_options(body: Mapping[str, Any], limits: Limits) -> dict[str, Any]:
    """`name`: which file.

    Raises
    ------
    ValueError
        If there is no such file.
    """
    name = body.get("name")
    if name not in files.KINDS:
        raise InputError(f"name = {json.dumps(name)[:60]} must be one of {', '.join(files.KINDS)}.")
    return {"name": name}


CALLS: dict[str, Call] = {
    "setup": Call(no_options, setup),
    "film": Call(no_options, film),
    "code": Call(no_options, code),
    "simulate": Call(sampling_options, simulated),
    "theory": Call(no_options, thresholds),
    "regions": Call(region_options, regions),
    "map": Call(explore.map_options, motion_map),
    "file": Call(file_options, file),
}


def read(call: str, body: Any, limits: Limits = USUAL) -> Request:
    """Check a request.

    Parameters
    ----------
    call : str
        A key of `CALLS`.
    body : dict
        JSON: `scenario` or `query`, optional `changes` to it (pairs of path and value), and its options.
    limits : Limits, optional

    Returns
    -------
    request : Request

    Raises
    ------
    ValueError
        If there is no such call, or the body is not what it takes.
    """
    if call not in CALLS:
        raise InputError(f"call = {call!r} must be one of {', '.join(CALLS)}.")
    if not isinstance(body, dict):
        raise InputError(f"The body must be a JSON object, not {json.dumps(body)[:60]}.")
    if "query" in body:
        scenario = Scenario.from_query(str(body["query"]))
    else:
        scenario = read_scenario(body.get("scenario", {}))
    scenario = changed(scenario, body.get("changes", []))
    return Request(call, scenario, CALLS[call].options(body, limits))


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
        If it is more than the limits allow.
    """
    return CALLS[request.call].answer(request, limits)
