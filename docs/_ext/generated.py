"""Parts of pages that are made from the code: commands, the scenario file, quantities, tables, addresses.

A line ``% generated: name`` of a page becomes what the function of that name here gives, as MyST. The JSON schema of a
scenario file is written beside the pages.
"""

from __future__ import annotations

import json
import math
import re
import sys
import tomllib
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, get_args

import typer
from pydantic_core import PydanticUndefined
from sphinx.application import Sphinx

import hophoop.cli
from hophoop import maps
from hophoop.cli._options import OPTIONS
from hophoop.kernel.physics.body import MOST_DEPTH
from hophoop.maps.grid.quantities import QUANTITIES, SETTLED
from hophoop.scenario import Compliant, Disk, Hoop, Plane, PointMass, Rigid, Ring, Rod, Scenario, Start
from hophoop.scenario.checking import Frozen, Number, unit_of
from hophoop.scenario.paths import ONWARD
from hophoop.vocabulary.names import EVENTS, STATUSES
from hophoop.vocabulary.parameters import PARAMETERS, RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS, Range

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks" / "engines"))
import table as engine_tables

CLAIMS = Path(__file__).parents[1] / "claims.toml"
SCHEMA = "scenario.schema.json"
LINE = re.compile(r"^% generated: ([\w-]+)$", re.MULTILINE)
KINDS = {"float": "NUMBER", "int": "N", "str": "WORD", "path": "FILE"}
KIND = re.compile(r"\s*<(?:list\[)?(\w+)\]?>$")
REFERENCE = Scenario()
SHARED = {option.flag for option in OPTIONS} | {"--set"}


def table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table of Markdown."""
    lines = [list(head), ["---"] * len(list(head)), *(list(row) for row in rows)]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines) + "\n"


# Commands


def commands() -> str:
    """Every command with its arguments and options, and first those that most of them share."""
    group = typer.main.get_command(hophoop.cli.app)
    context = group.make_context("hophoop", [], resilient_parsing=True)
    known = {name: hophoop.cli.command_of(name) for name in group.list_commands(context)}
    sharing = [name for name, command in known.items() if "--v0" in flags(command)]
    parts = [
        "## Options that make a scenario\n",
        f"These are the same in {_listed(f'`hophoop {name}`' for name in sharing)}. Each changes what FILE says; without "
        "FILE they change the reference case. {doc}`scenario-file` has the same keys with their limits.\n",
        _options(known["run"], context, lambda flag: flag in SHARED),
    ]
    for name, command in known.items():
        parts += [f"## hophoop {name}\n", f"{command.help}\n", f"```text\n{_usage(name, command, context)}\n```\n"]
        if name in sharing:
            parts.append("FILE and the [options that make a scenario](#options-that-make-a-scenario), and:\n")
        parts.append(_options(command, context, lambda flag, shared=name in sharing: not (shared and flag in SHARED)))
    return "\n".join(parts)


def flags(command: Any) -> set[str]:
    """All flags of a command."""
    return {flag for parameter in command.params for flag in (*parameter.opts, *parameter.secondary_opts)}


def _usage(name: str, command: Any, context: Any) -> str:
    pieces = [re.sub(r"^\[\[(\w+)\](\.\.\.)?\](\.\.\.)?$", r"[\1]\2", piece) for piece in command.collect_usage_pieces(context)]
    return " ".join([f"hophoop {name}", *pieces]).replace("{", "").replace("}", "")


def _options(command: Any, context: Any, wanted: Callable[[str], bool]) -> str:
    rows = []
    for parameter in command.params:
        if getattr(parameter, "hidden", False) or not wanted(parameter.opts[0]):
            continue
        signs, words = parameter.get_help_record(context)
        words, _, default = words.partition("[default:")
        needed = "[required]" in words or parameter.required
        sign = KIND.sub(_kind, signs) if signs.startswith("-") else KIND.sub("", signs)
        several = " Can be given several times." if parameter.multiple and "repeated" not in words else ""
        rows.append(
            [
                f"`{sign.replace(', ', '`, `')}`",
                words.replace("[required]", "").strip() + several,
                "needed" if needed else f"`{default.strip(' ]')}`" if default else _of_reference(parameter.opts[0]),
            ]
        )
    return table(["option", "what it does", "default"], rows) if rows else "It has no further options.\n"


def _kind(found: re.Match[str]) -> str:
    return f" {KINDS.get(found[1], found[1].upper())}"


def _of_reference(flag: str) -> str:
    """What the reference case says where a scenario's option is not given."""
    for option in OPTIONS:
        if option.flag == flag and option.path not in ("start.vx", "start.vy", "start.omega", "start.height"):
            value: Any = REFERENCE
            for step in option.path.split("."):
                value = getattr(value, step)
            return f"`{value:g}`" if isinstance(value, float) else f"`{value}`"
    return ""


def _listed(words: Iterable[str]) -> str:
    *most, last = words
    return f"{', '.join(most)} and {last}" if most else last


# The scenario file


def scenario_file() -> str:
    """Every key of a scenario file, section by section: meaning, unit, default, what it may be."""
    sections: list[tuple[str, str, tuple[type[Frozen], ...]]] = [
        ("At the top of the file", "", (Scenario,)),
        ("`[hoop]`", "hoop.", (Hoop,)),
        ("`[plane]`", "plane.", (Plane,)),
        ("`[start]`", "start.", (Start,)),
        ('`[contact]` with `model = "rigid"`', "contact.", (Rigid,)),
        ('`[contact]` with `model = "compliant"`', "contact.", (Compliant,)),
    ]
    parts = []
    for title, place, models in sections:
        parts.append(f"### {title}\n\n" + _keys(place, models))
    for part in (Ring, Disk, PointMass, Rod):
        shape = part.model_fields["shape"].default
        parts.append(
            f'### A part with `shape = "{shape}"`\n\n{(part.__doc__ or "").splitlines()[0]}\n\n' + _keys("hoop.parts.", (part,))
        )
    return "\n".join(parts)


def _keys(place: str, models: tuple[type[Frozen], ...]) -> str:
    rows = []
    for model in models:
        for name, field in model.model_fields.items():
            if name in ONWARD:  # written by Start.of, not by people
                continue
            if isinstance(field.default_factory, object) and field.default_factory is not None:
                continue  # a section of its own
            unit = unit_of(field)
            rows.append(
                [
                    f"`{name}`",
                    field.description or "",
                    "" if unit in ("", "1") else unit,
                    _default(field),
                    limits(place + name, field),
                ]
            )
    return table(["key", "meaning", "unit", "default", "may be"], rows)


def _default(field: Any) -> str:
    if field.default is PydanticUndefined:
        return "needed"
    if field.default is None:
        return "not given"
    return f'`"{field.default}"`' if isinstance(field.default, str) else f"{field.default:g}"


def limits(path: str, field: Any) -> str:
    """What the value of a key may be: a range, some words, parts."""
    words = [
        word for part in (field.annotation, *get_args(field.annotation)) for word in get_args(part) if isinstance(word, str)
    ]
    if words:
        return _listed([f'`"{word}"`' for word in words]).replace(" and ", " or ")
    if path == "hoop.parts":
        return "a list of the parts below"
    if path == "hoop.parts.at":
        return "within the rim"
    if path == "hoop.parts.inner_radius":
        return "from 0 to outer_radius"
    allowed = next((mark.range for mark in field.metadata if isinstance(mark, Number)), None)
    return spoken(allowed or RANGES[path])


def spoken(allowed: Range) -> str:
    """A range with its powers of ten as people write them."""
    words = f"{_power(allowed.least)} to {_power(allowed.most)}"
    return ("0 or " if 0.0 in allowed.also else "") + words + (' or `"inf"`' if math.inf in allowed.also else "")


def _power(value: float) -> str:
    text = f"{value:g}"
    if "e" not in text:
        return text.replace("-", "−")
    mantissa, _, exponent = text.partition("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    sign = "−" if mantissa.startswith("-") else ""
    mantissa = mantissa.lstrip("-")
    return f"{sign}{'' if mantissa == '1' else mantissa + '·'}10{raised}"


# Maps


def quantities() -> str:
    """The quantities that a map can hold."""
    rows = [
        [f"`{name}`", quantity.meaning, "" if quantity.unit in ("", "1") else quantity.unit]
        for name, quantity in {**QUANTITIES, **SETTLED}.items()
    ]
    return table(["quantity", "meaning", "unit"], rows)


# Events and statuses


def events() -> str:
    """Every kind of event, and when it occurs."""
    return table(["kind", "when"], ([f"`{kind}`", facts.when] for kind, facts in EVENTS.items()))


def statuses() -> str:
    """Every status of a motion, and what it means."""
    return table(["`motion.status`", "means"], ([f"`{status}`", facts.means] for status, facts in STATUSES.items()))


# Ranges

PARTS = {"hoop.parts.mass": "kg", "hoop.parts.length": "m"}
FRICTIONS = ("plane.mu", "plane.mu_static", "plane.mu_kinetic")  # of one range


def ranges() -> str:
    """What the numbers of a scenario may be, and what those of a compliant contact may be relative to its hoop."""
    rows = []
    sections = list(Scenario.model_fields)
    for path, allowed in sorted(RANGES.items(), key=lambda item: sections.index(item[0].partition(".")[0])):
        if path not in FRICTIONS[1:]:
            unit = PARTS.get(path) or PARAMETERS[path].unit
            names = FRICTIONS if path in FRICTIONS else (path,)
            rows.append([", ".join(f"`{name}`" for name in names), "" if unit == "1" else unit, allowed.words()])
    rows += [
        ["`contact.stiffness`, `contact.tangential_stiffness`, also", "m g/R", RELATIVE_STIFFNESS.words()],
        ["`contact.slip_speed`, also", "√(g R)", RELATIVE_SLIP_SPEED.words()],
        ["depth to which the speeds of a start press the rim of a compliant contact", "R", f"up to {MOST_DEPTH:g}"],
    ]
    return table(["number", "unit", "may be"], rows)


# Physics engines


def engines(make: Callable[[dict[str, Any]], str]) -> str:
    """A table of the kept scores."""
    return make(json.loads(engine_tables.KEPT.read_text(encoding="utf-8")))


# Claims of the literature


def claims() -> str:
    """The claims of each work and our numbers, with a reason where we differ."""
    known = tomllib.loads(CLAIMS.read_text(encoding="utf-8"))
    rows = []
    for work, read in known.pop("works").items():
        head = [f"{{cite:t}}`{work}`", read]
        for claim in known.values():
            if claim["work"] == work:
                unit = claim.get("unit", "")
                number = claim["ours"].replace("-", "−") + ("°" if unit == "°" else f" {unit}" if unit else "")
                why = "" if claim["verdict"] == "agrees" else f" {claim['why']}"
                rows.append([*head, claim["claim"], f"{claim['quantity']} **{number}**.{why}", claim["verdict"]])
                head = ["", ""]
    return table(["work", "read", "what it says", "our number", "verdict"], rows)


# The catalogue


def catalogue() -> str:
    """The classes of γ = 3/4 with at least 2 % of the window."""
    head = ("sequence", "ending", "share of the window", "width", "example μ", "example $v_0$ (m/s)")
    return table(
        head,
        (
            (one.sequence, one.ending, f"{100 * one.area:.3g} %", f"{one.width:.2g}", f"{one.mu:.10g}", f"{one.speed:.10g}")
            for one in maps.catalogue()
            if one.area >= 0.02
        ),
    )


# Addresses

ADDRESSES = Path(__file__).parents[2] / "addresses.toml"
ASKED = {
    "issues": "Questions, wishes and defects",
    "security": "Weaknesses, privately",
    "repository": "The source",
    "lab": "The lab",
}


def addresses() -> str:
    """Where to write, as far as the owners have said it."""
    known = tomllib.loads(ADDRESSES.read_text(encoding="utf-8"))
    lines = [f"* {words}: <{known[name]}>" for name, words in ASKED.items() if known[name]]
    return (
        "\n".join(lines)
        or "This copy has no public address yet. Ask those who gave it to you (`addresses.toml` is where they name one)."
    )


MAKERS: dict[str, Callable[[], str]] = {
    "commands": commands,
    "scenario-file": scenario_file,
    "quantities": quantities,
    "events": events,
    "statuses": statuses,
    "ranges": ranges,
    "engines-short": lambda: engines(engine_tables.short),
    "engines-full": lambda: engines(engine_tables.full),
    "claims": claims,
    "catalogue": catalogue,
    "addresses": addresses,
}


def put_in(app: Sphinx, page: str, source: list[str]) -> None:
    """Replace the marks of a page."""
    source[0] = LINE.sub(lambda found: MAKERS[found[1]](), source[0])


def write_schema(app: Sphinx, error: Exception | None) -> None:
    """The JSON schema, for editors that check a scenario file while it is written."""
    if error is None and app.builder.format == "html":
        schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **Scenario.model_json_schema()}
        Path(app.outdir, SCHEMA).write_text(json.dumps(schema, indent=1, ensure_ascii=False), encoding="utf-8")


def outdated(app: Sphinx, environment: Any, added: Any, changed: Any, removed: Any) -> Iterator[str]:
    """Pages with such a mark are read anew each time: the code may have changed."""
    for name in environment.found_docs:
        if LINE.search(Path(environment.doc2path(name)).read_text(encoding="utf-8")):
            yield name


def setup(app: Sphinx) -> dict[str, Any]:
    """Before a page is read, and when all are written."""
    app.connect("source-read", put_in)
    app.connect("env-get-outdated", lambda *values: list(outdated(*values)))
    app.connect("build-finished", write_schema)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
