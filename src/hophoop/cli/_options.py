"""Options for a scenario, shared by the commands that need one."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from functools import partial, wraps
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import typer

from hophoop._support.errors import InputError
from hophoop.vocabulary.parameters import TABLE, WORD, section_of


class ScenarioOption(NamedTuple):
    """An option that sets one parameter of the scenario."""

    flag: str
    path: str
    help: str
    panel: str
    kind: type = float
    to_si: Callable[[float], float] | None = None


START, ADVANCED = "Start and duration", "Advanced"


def panel(name: str) -> Callable[..., Any]:
    """Return what makes an option in a panel of the help."""
    return partial(typer.Option, rich_help_panel=name)


Quiet = Annotated[bool, typer.Option("--quiet", help="Show no progress.")]
Json = Annotated[bool, typer.Option("--json", help="Print JSON, in SI units and radians.")]
Picture = Annotated[Path | None, typer.Option("--plot", metavar="FILE", help="Draw it: .png, .svg, .pdf or .jpg.")]
File = Annotated[
    str | None,
    typer.Argument(
        metavar="FILE",
        help="Scenario in TOML or JSON; '-' is standard input. Options change it; without it they change the reference case.",
        show_default=False,
    ),
]
Assign = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="PATH=VALUE",
        help="Any parameter of a scenario, such as contact.model=compliant; may be repeated.",
        rich_help_panel=START,
    ),
]
_PANELS = {"hoop": "Hoop", "plane": "Plane", "start": START, "motion": START}
OPTIONS = tuple(
    ScenarioOption(
        option.flag, row.path, option.help, ADVANCED if option.rare else _PANELS[section_of(row)],
        str if row.unit == WORD else float, math.radians if option.in_degrees else None,
    )
    for row in TABLE for option in row.options
)  # fmt: skip


def with_scenario(command: Callable[..., None]) -> Callable[..., None]:
    """Add FILE and the options above to a command, which is called with `scenario` instead."""
    own = inspect.signature(command, eval_str=True)
    names = {_name(option): option for option in OPTIONS}
    shown = [name for name, option in names.items() if option.panel != ADVANCED]
    rare = [name for name in names if name not in shown]

    @wraps(command)
    def run(**values: Any) -> None:
        file = values.pop("file")
        given = {option: values.pop(name) for name, option in names.items()}
        settings = values.pop("assign") or []
        if "file" in own.parameters:  # for commands that need the name of the file
            values["file"] = file
        command(scenario=scenario_of(file, given, settings), **values)

    rest = [parameter for name, parameter in own.parameters.items() if name not in ("scenario", "file")]
    parameters = [
        _added("file", File),
        *(_added(name, _annotation(names[name])) for name in shown),
        _added("assign", Assign),
        *(parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY) for parameter in rest),
        *(_added(name, _annotation(names[name])) for name in rare),
    ]
    run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    run.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    del run.__wrapped__
    return run


def _added(name: str, annotation: Any) -> inspect.Parameter:
    """One more parameter of a command."""
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=annotation)


def _annotation(option: ScenarioOption) -> Any:
    """What Typer makes an option of."""
    told = typer.Option(option.flag, help=option.help, rich_help_panel=option.panel, show_default=False)
    return Annotated[option.kind | None, told]


def _name(option: ScenarioOption) -> str:
    return option.flag.removeprefix("--").replace("-", "_")


def scenario_of(file: str | None, given: dict[ScenarioOption, Any], settings: list[str]) -> Any:
    """Return the scenario of a file, or the reference case, changed by the options."""
    from hophoop.scenario import Scenario

    base = Scenario() if file is None else Scenario.load(file)
    values: dict[str, Any] = {}
    names: dict[str, str] = {}  # option used for each path
    for option, value in given.items():
        if value is None:
            continue
        if option.path in names:
            raise InputError(f"{option.flag} cannot be given together with {names[option.path]}.")
        names[option.path] = option.flag
        values[option.path] = value if option.to_si is None else option.to_si(value)
    for text in settings:
        path, word = assigned("--set", text, "a path and a value, such as plane.mu=0.5")
        if path in names:
            raise InputError(f"--set {path} cannot be given together with {names[path]}.")
        names[path] = f"--set {path}"
        values[path] = value_of(word)
    _check_redundancy(base, names)
    return base.with_values(values)


def _check_redundancy(base: Any, names: dict[str, str]) -> None:
    """Refuse redundant options, and options that make a rolling start an incomplete free one."""
    from hophoop.scenario.paths import contradiction

    pair = contradiction(names)
    if pair is not None:
        raise InputError(f"{names[pair[0]]} cannot be given together with {names[pair[1]]}.")
    free = [path for path in ("start.vx", "start.vy", "start.omega", "start.height") if path in names]
    missing = [option for path, option in (("start.vx", "--vx"), ("start.omega", "--omega")) if path not in names]
    if free and missing and base.start.speed is not None:
        raise InputError(
            f"{names[free[0]]} cannot be given without {' and '.join(missing)}: the start is a rolling one "
            f"(start.speed = {base.start.speed:g} m/s), which does not determine a free one."
        )


def value_of(word: str) -> Any:
    """Return a value as a number if it is one, else as text."""
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            continue
    return word


def assigned(option: str, text: str, wanted: str = "a name and a value, such as restitution=0.3") -> tuple[str, str]:
    """Split NAME=VALUE, or say what is wanted."""
    name, sign, value = (part.strip() for part in text.partition("="))
    if not (sign and name and value):
        raise InputError.of_field(option, text, wanted)
    return name, value


def numbers(option: str, text: str, count: int, wanted: str = "", comma: str = ",") -> Any:
    """Return the numbers of a text, or say what is wanted."""
    try:
        values = tuple(float(word) for word in text.split(comma))
    except ValueError:
        values = ()
    if len(values) != count:
        raise InputError.of_field(option, text, wanted or f"{count} numbers with commas between them")
    return values
