"""Options of the commands: declared where their values are used, and listed in the docstring of each command.

A parameter of a command is an option with its type and default. A parameter that is annotated with the address of a dataclass
or function, such as ``Annotated[Any, "hophoop.tracking:Hints"]``, has the options of that one, and gets the given ones as a
dict. The docstring lists the options; a heading is a panel of the help, and behind the colon are the flag and what it takes,
where they are not the usual ones::

    Camera
    ------
    focal
    level : --level-deg
    ground : C,R,C,R
        Two points of the ground line below the rim, pixels.

An option without a text has that of the dataclass or function. ``scenario`` has FILE and the options of a scenario.
"""

from __future__ import annotations

import inspect
import math
import re
import sys
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from pkgutil import resolve_name
from types import NoneType, UnionType
from typing import Annotated, Any, NamedTuple, Union, get_args, get_origin

import typer

from hophoop._support.errors import InputError
from hophoop.cli._output import named_options
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
_PANELS = {"hoop": "Hoop", "plane": "Plane", "start": START, "motion": START}
OPTIONS = tuple(
    ScenarioOption(
        option.flag, row.path, option.help, ADVANCED if option.rare else _PANELS[section_of(row)],
        str if row.unit == WORD else float, math.radians if option.in_degrees else None,
    )
    for row in TABLE for option in row.options
)  # fmt: skip
# of options that several commands have
_TEXTS = {
    "quiet": "Show no progress.",
    "json": "Print JSON, in SI units and radians.",
    "plot": "Draw it: .png, .svg, .pdf or .jpg.",
    **{option.flag.removeprefix("--"): option.help for option in OPTIONS},
}
_FILE = typer.Argument(
    metavar="FILE",
    help="Scenario in TOML or JSON; '-' is standard input. Options change it; without it they change the reference case.",
    show_default=False,
)
_SET = typer.Option(
    "--set",
    metavar="PATH=VALUE",
    help="Any parameter of a scenario, such as contact.model=compliant; may be repeated.",
    rich_help_panel=START,
)


class Entry(NamedTuple):
    """An entry of a docstring: the heading above it, what is behind its colon, and its text."""

    heading: str
    sign: str
    text: str


class Declared(NamedTuple):
    """The parameter that an option sets: of the command itself, or in the dict for one of its parameters."""

    parameter: inspect.Parameter
    holder: str = ""
    text: str = ""


def declared(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command as Typer reads it, with the options of its docstring."""
    own = inspect.signature(command, eval_str=True).parameters
    entries = entries_of(command.__doc__)
    known = _known(own, entries)
    options = {name: _option(name, entry, known[name]) for name, entry in entries.items()}
    parameters = [parameter for parameter, _, _ in options.values()]
    shared = {_python_name(option): option for option in OPTIONS} if "scenario" in own else {}
    if shared:
        common = [_scenario_option(name, option) for name, option in shared.items() if option.panel != ADVANCED]
        rare = [_scenario_option(name, option) for name, option in shared.items() if option.panel == ADVANCED]
        file, assign = _parameter("file", str | None, _FILE, None), _parameter("assign", list[str] | None, _SET, None)
        parameters = [file, *common, assign, *parameters, *rare]

    # by argument, for errors; a scenario has a start, too
    flags = {name: flag for name, (_, flag, _) in options.items() if not (shared and name == "start")}

    def run(**values: Any) -> None:
        arguments: dict[str, Any] = {one.holder: {} for one in known.values() if one.holder}
        for name, (_, _, read) in options.items():
            holder, value = known[name].holder, values[name]
            if value is not None:
                (arguments[holder] if holder else arguments)[name] = read(value)
        if shared:
            given = {option: values[name] for name, option in shared.items()}
            arguments["scenario"] = scenario_of(values["file"], given, values["assign"] or [])
            if "file" in own:  # for commands that need its name
                arguments["file"] = values["file"]
        with named_options(flags):
            command(**arguments)

    run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    run.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    run.__doc__ = summary(command)
    return run


def summary(command: Callable[..., None]) -> str:
    """Return the first paragraph of a command's docstring."""
    return " ".join((command.__doc__ or "").partition("\n\n")[0].split())


def entries_of(docstring: str | None) -> dict[str, Entry]:
    """Return the entries under the headings of a docstring, by name."""
    if docstring is None:
        raise InputError("Commands need their docstrings, which list the options: start Python without -OO.")
    _, *parts = re.split(r"^(\S.*)\n-{3,}$", inspect.cleandoc(docstring), flags=re.MULTILINE)
    found: dict[str, Entry] = {}
    for heading, body in zip(parts[::2], parts[1::2], strict=True):
        for entry in re.split(r"\n+(?=\S)", body.strip()):
            line, _, text = entry.partition("\n")
            names, _, sign = line.partition(" : ")
            found |= dict.fromkeys(names.split(", "), Entry(heading, sign, " ".join(text.split())))
    return found


def _known(own: Mapping[str, inspect.Parameter], wanted: Collection[str]) -> dict[str, Declared]:
    """Return everything that an option of a command may set, by name."""
    found = {}
    for holder, parameter in own.items():
        address = getattr(parameter.annotation, "__metadata__", [None])[0]
        if isinstance(address, str):
            source = resolve_name(address)
            texts, names = entries_of(source.__doc__), vars(sys.modules[source.__module__])
            for name, one in inspect.signature(source).parameters.items():
                if name in wanted and name not in own:
                    found[name] = Declared(one.replace(annotation=eval(one.annotation, names)), holder, _text(texts[name]))
    return found | {name: Declared(parameter) for name, parameter in own.items()}


def _text(entry: Entry) -> str:
    """Return the text of a library's docstring for the help."""
    text = re.sub(r" \[([^]]+)\]", r", \1", entry.text.replace(" [1]", ""))
    choices = re.findall(r"'([^']*)'", entry.sign.partition("}")[0]) if entry.sign.startswith("{") else []
    return f"{text.rstrip('.')}: {', '.join(choices[:-1])} or {choices[-1]}." if choices else text


def _option(name: str, entry: Entry, known: Declared) -> tuple[inspect.Parameter, str, Callable[[Any], Any]]:
    """Return an option as a parameter for Typer, its flag, and what makes the value of what Typer has read."""
    sign, _, place = entry.sign.partition(" ") if entry.sign.startswith("--") else ("", "", entry.sign)
    flag, default = sign or f"--{name.replace('_', '-')}", known.parameter.default
    kind, read, complete = _reading(known.parameter.annotation, flag)
    if "Path" in str(known.parameter.annotation):
        place, default = place or "FILE", str(default) if isinstance(default, Path) else default
    text = entry.text or known.text or _TEXTS[flag.removeprefix("--")]
    if kind == list[str]:
        text = f"{text.rstrip('.')}; may be repeated."
    if flag.endswith("-deg"):
        text, default = re.sub(r", rad\b", ", degrees", text), default and math.degrees(default)
    if default is not inspect.Parameter.empty and kind is not bool and (kind == list[str] or not isinstance(default, kind)):
        kind, default = kind | None, None
    if entry.heading == "Arguments":
        return _parameter(name, kind, typer.Argument(metavar=place, help=text, show_default=False), default), flag, read
    made = typer.Option(
        *(() if default is True else (flag,)),  # else Typer adds --no-…
        metavar=place or None,
        help=text,
        autocompletion=complete,
        rich_help_panel=None if entry.heading == "Options" else entry.heading,
    )
    return _parameter(name, kind, made, default), flag, read


def _reading(annotation: Any, flag: str) -> tuple[Any, Callable[[Any], Any], Callable[..., Any] | None]:
    """Return the type that Typer reads for an annotation, what makes the value of it, and what completes it in a shell."""
    complete = None
    if get_origin(annotation) is Annotated:
        annotation, complete = get_args(annotation)
    kinds = get_args(annotation) if get_origin(annotation) in (Union, UnionType) else (annotation,)
    kind = next(one for one in kinds if one is not NoneType)
    origin, parts = get_origin(kind), get_args(kind)
    turned = math.radians if flag.endswith("-deg") else lambda value: value
    if kind is Path:
        return str, lambda text: _path(flag, text), None
    if origin is tuple:
        return str, lambda text: tuple(map(turned, numbers(flag, text, len(parts)))), None
    if origin is Mapping:
        return list[str], lambda texts: _table(flag, texts, parts[1]), None
    if origin is Sequence:
        return list[str], lambda texts: tuple(texts if parts[0] is str else map(value_of, texts)), None
    return kind, turned, complete


def _path(flag: str, text: str) -> Path:
    """Return the name of a file or folder; pathlib would read an empty one as the current folder."""
    if not text:
        raise InputError.of_field(flag, text, "a file or a folder", rule="must name")
    return Path(text)


def _table(flag: str, texts: Sequence[str], kind: Any) -> dict[str, Any]:
    """Return NAME=VALUE, NAME=NUMBER or NAME=LOW:HIGH as a dict, by the type of the values."""
    pairs = dict(assigned(flag, text) for text in texts)
    if kind is str:
        return pairs
    if kind is float:
        return {name: numbers(f"{flag} {name}", text, 1, "a number")[0] for name, text in pairs.items()}
    return {name: numbers(f"{flag} {name}", text, 2, "two numbers, such as 0:0.5", ":") for name, text in pairs.items()}


def _parameter(name: str, kind: Any, made: Any, default: Any) -> inspect.Parameter:
    """Return a parameter as Typer reads it."""
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=Annotated[kind, made])


def _scenario_option(name: str, option: ScenarioOption) -> inspect.Parameter:
    """Return an option that sets one parameter of the scenario."""
    made = typer.Option(option.flag, help=option.help, rich_help_panel=option.panel, show_default=False)
    return _parameter(name, option.kind | None, made, None)


def _python_name(option: ScenarioOption) -> str:
    return option.flag.removeprefix("--").replace("-", "_")


def scenario_of(file: str | None, given: dict[ScenarioOption, Any], settings: list[str]) -> Any:
    """Return the scenario of a file, or the reference case, changed by the options."""
    from hophoop.cli._output import named_options
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
    shown = {option.path: option.flag for option, value in given.items() if value is not None and option.to_si is None}
    with named_options(shown):
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
