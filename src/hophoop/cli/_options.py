"""Options for a scenario, shared by the commands that need one."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from functools import wraps
from typing import Annotated, Any, NamedTuple

import typer

from hophoop.vocabulary.parameters import TABLE, WORD, section_of


class ScenarioOption(NamedTuple):
    """An option that sets one parameter of the scenario."""

    flag: str
    path: str
    help: str
    panel: str
    kind: type = float
    to_si: Callable[[float], float] | None = None


START = "Start and duration"
_PANELS = {"hoop": "Hoop", "plane": "Plane", "start": START, "motion": START}
OPTIONS = tuple(
    ScenarioOption(
        option.flag, row.path, option.help, _PANELS[section_of(row)],
        str if row.unit == WORD else float, math.radians if option.in_degrees else None,
    )
    for row in TABLE for option in row.options
)  # fmt: skip


def with_scenario(command: Callable[..., None]) -> Callable[..., None]:
    """Add FILE and the options above to a command, which is called with `scenario` instead."""
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
                    help="Scenario in TOML or JSON; '-' is standard input. Options change it; "
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
    def run(**values: Any) -> None:
        file = values.pop("file")
        given = {option: values.pop(name) for name, option in zip(names, OPTIONS, strict=True)}
        settings = values.pop("assign") or []
        if "file" in own.parameters:  # for commands that need the name of the file
            values["file"] = file
        command(scenario=scenario_of(file, given, settings), **values)

    rest = [
        parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY)
        for parameter in own.parameters.values()
        if parameter.name not in ("scenario", "file")
    ]
    parameters = [*added, *rest]
    run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    run.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    del run.__wrapped__
    return run


def _name(option: ScenarioOption) -> str:
    return option.flag.removeprefix("--").replace("-", "_")


def scenario_of(file: str | None, given: dict[ScenarioOption, Any], settings: list[str]) -> Any:
    """Return the scenario of a file, or the reference case, changed by the options."""
    from hophoop.scenario import InputError, Scenario

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
        path, sign, word = text.partition("=")
        path = path.strip()
        if not sign or not path:
            raise InputError(f"--set {text} must be a path and a value, such as plane.mu=0.5.")
        if path in names:
            raise InputError(f"--set {path} cannot be given together with {names[path]}.")
        names[path] = f"--set {path}"
        values[path] = value_of(word.strip())
    _check_redundancy(base, names)
    return base.with_values(values)


def _check_redundancy(base: Any, names: dict[str, str]) -> None:
    """Refuse redundant options, and options that make a rolling start an incomplete free one."""
    from hophoop.scenario import InputError
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
