"""Options that make a scenario, shared by the commands that need one."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from functools import wraps
from typing import Annotated, Any, NamedTuple

import typer


class ScenarioOption(NamedTuple):
    """An option that sets one parameter of the scenario."""

    flag: str
    path: str
    help: str
    panel: str
    kind: type = float
    to_si: Callable[[float], float] | None = None


HOOP, PLANE, START = "Hoop", "Plane", "Start and duration"

OPTIONS = (
    ScenarioOption(
        "--gamma", "hoop.load_fraction", "Share of the mass in the load of an ideal hoop, γ.", HOOP
    ),
    ScenarioOption("--inertia-ratio", "hoop.inertia_ratio", "Moment of inertia about G over m R², κ.", HOOP),
    ScenarioOption("--eccentricity", "hoop.eccentricity", "Distance of G from the centre over R, ε.", HOOP),
    ScenarioOption("--radius", "hoop.radius", "Rim radius, m.", HOOP),
    ScenarioOption("--mass", "hoop.mass", "Total mass, kg.", HOOP),
    ScenarioOption("--mu", "plane.mu", "Friction, static and kinetic.", PLANE),
    ScenarioOption("--mu-static", "plane.mu_static", "Static friction.", PLANE),
    ScenarioOption("--mu-kinetic", "plane.mu_kinetic", "Kinetic friction.", PLANE),
    ScenarioOption("--slope", "plane.slope", "Slope, downhill ahead, rad.", PLANE),
    ScenarioOption("--slope-deg", "plane.slope", "The same in degrees.", PLANE, to_si=math.radians),
    ScenarioOption("--gravity", "plane.gravity", "Gravity, m/s².", PLANE),
    ScenarioOption("--restitution", "plane.restitution", "Restitution of an impact, e.", PLANE),
    ScenarioOption("--law", "plane.impact_law", "stronge, newton or poisson.", PLANE, str),
    ScenarioOption("--painleve", "plane.painleve", "Where indeterminate: flight or impact.", PLANE, str),
    ScenarioOption("--v0", "start.speed", "Rolling start: velocity of the centre, m/s.", START),
    ScenarioOption("--angle", "start.angle", "Angle of the load from the top, rad.", START),
    ScenarioOption("--angle-deg", "start.angle", "The same in degrees.", START, to_si=math.radians),
    ScenarioOption("--x", "start.x", "Place of the centre along the plane, m.", START),
    ScenarioOption("--height", "start.height", "Gap between rim and plane, m.", START),
    ScenarioOption("--vx", "start.vx", "Velocity of the centre along the plane, m/s.", START),
    ScenarioOption("--vy", "start.vy", "Velocity of the centre away from the plane, m/s.", START),
    ScenarioOption("--omega", "start.omega", "Angular velocity, rad/s.", START),
    ScenarioOption("--duration", "duration", "Duration of the motion, s.", START),
)

SECTIONS = ("hoop", "plane", "start", "contact")


def with_scenario(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command FILE and the options above; it is called with `scenario` in their place."""
    own = inspect.signature(command, eval_str=True)
    names = [_name(option) for option in OPTIONS]
    added = [
        inspect.Parameter(
            "file",
            inspect.Parameter.POSITIONAL_OR_KEYWORD,
            default=None,
            annotation=Annotated[
                str | None,
                typer.Argument(
                    metavar="FILE",
                    help="Scenario in TOML or JSON; '-' is standard input. Options change what it says; "
                    "without it they change the reference case.",
                    show_default=False,
                ),
            ],
        )
    ]
    added += [
        inspect.Parameter(
            name,
            inspect.Parameter.KEYWORD_ONLY,
            default=None,
            annotation=Annotated[
                option.kind | None,
                typer.Option(option.flag, help=option.help, rich_help_panel=option.panel, show_default=False),
            ],
        )
        for name, option in zip(names, OPTIONS, strict=True)
    ]
    added.append(
        inspect.Parameter(
            "assign",
            inspect.Parameter.KEYWORD_ONLY,
            default=None,
            annotation=Annotated[
                list[str] | None,
                typer.Option(
                    "--set",
                    metavar="PATH=VALUE",
                    help="Any parameter of a scenario, such as contact.model=compliant; may be repeated.",
                    rich_help_panel=START,
                    show_default=False,
                ),
            ],
        )
    )

    @wraps(command)
    def wrapped(**values: Any) -> None:
        file = values.pop("file")
        given = {option: values.pop(name) for name, option in zip(names, OPTIONS, strict=True)}
        settings = values.pop("assign") or []
        if "file" in own.parameters:  # for a command that must know what it reads
            values["file"] = file
        command(scenario=scenario_of(file, given, settings), **values)

    rest = [
        parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY)
        for parameter in own.parameters.values()
        if parameter.name not in ("scenario", "file")
    ]
    parameters = [*added, *rest]
    wrapped.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    wrapped.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    del wrapped.__wrapped__
    return wrapped


def _name(option: ScenarioOption) -> str:
    return option.flag.removeprefix("--").replace("-", "_")


def scenario_of(file: str | None, given: dict[ScenarioOption, Any], settings: list[str]) -> Any:
    """The scenario of a file, or the reference case, with what the options change."""
    from hophoop.scenario import InputError, Scenario

    base = Scenario() if file is None else Scenario.load(file)
    changes: list[tuple[str, Any]] = []
    flags: dict[str, str] = {}
    for option, value in given.items():
        if value is None:
            continue
        if option.path in flags:
            raise InputError(f"{option.flag} cannot be given together with {flags[option.path]}.")
        flags[option.path] = option.flag
        changes.append((option.path, value if option.to_si is None else option.to_si(value)))
    for text in settings:
        path, sign, word = text.partition("=")
        if not sign or not path:
            raise InputError(f"--set {text} must be a path and a value, such as plane.mu=0.5.")
        changes.append((path.strip(), _value(word.strip())))
    return changed(base, changes)


def changed(base: Any, changes: list[tuple[str, Any]]) -> Any:
    """The scenario with new values; only the whole result must hold together, not each step."""
    from hophoop.scenario import Scenario

    named = dict(changes)
    order = {path: k for k, path in enumerate(named)}
    if "plane.mu_static" in named and "plane.mu_kinetic" in named:
        changes = [("plane.mu", named["plane.mu_static"]), *changes]
    if named.get("hoop.inertia_ratio") == 0.0 and "hoop.eccentricity" in named:
        # ε = 1 first: no other body has no moment of inertia
        changes.sort(key=lambda change: order.get(change[0], -1) + 100 * (change[0] == "hoop.inertia_ratio"))
    data = base.to_dict()
    for section in SECTIONS:
        part = Scenario.from_dict({section: data[section]} if section in data else {})
        for path, value in changes:
            if path.partition(".")[0] == section:
                part = part.replace(path, value)
        data[section] = part.to_dict()[section]
    for path, value in changes:
        if path.partition(".")[0] not in SECTIONS:
            part = Scenario().replace(path, value)  # an unknown path says so
            data[path] = value
    return Scenario.from_dict(data)


def _value(word: str) -> Any:
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            continue
    return word
