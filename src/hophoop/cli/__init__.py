"""The command line: each command parses, calls one public function and prints.

A command is a function in a module of the same name: `hophoop map` is `map` in ``cli/map.py``; three short ones are in
``cli/short.py``. Its docstring lists its options, see ``cli/_options.py``. Options are made for the command that runs, and
heavy imports are inside the functions, so that ``hophoop --help`` is fast.
"""

from __future__ import annotations

import sys
import traceback
from collections.abc import Sequence
from importlib import import_module
from typing import Any

import typer
from typer.core import TyperGroup

from hophoop._support.errors import InputError, plain
from hophoop._support.extras import MissingExtra
from hophoop._support.stopping import stop_on_signals

# In the order of --help.
COMMANDS = ("run", "lab", "animate", "map", "track", "fit", "plan")
RESEARCH = ("theory", "prove", "gait", "diagram", "reproduce")
SHORT = ("plan", "theory", "reproduce")

DONE, NO_ANSWER, BAD_INPUT, DEFECT, STOPPED = 0, 1, 2, 70, 130
# in errors of Python and of the system where memory is short
TOO_LITTLE = ("can't start new thread", "failed to map segment", "annot allocate memory")


class Commands(TyperGroup):
    """The commands, each loaded on use; errors become one sentence and an exit status, in `main`."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Return the names of the commands."""
        return [*COMMANDS, *RESEARCH]

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Return a command of a name for lists, without its options, or None."""
        return command_of(cmd_name, brief=True) if cmd_name in self.list_commands(ctx) else None

    def resolve_command(self, ctx: Any, args: list[str]) -> tuple[str | None, Any, list[str]]:
        """Return the command to run, with its options."""
        name, command, rest = super().resolve_command(ctx, args)
        return name, command and command_of(str(name)), rest

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        windows_expand_args: bool = True,
        **extra: Any,
    ) -> Any:
        """Run with arguments, those of the process by default, and exit."""
        if not standalone_mode:
            return super().main(args, prog_name, complete_var, False, windows_expand_args, **extra)
        for stream in (sys.stdout, sys.stderr):
            # replace letters that the terminal does not know
            if hasattr(stream, "reconfigure") and (stream.encoding or "").lower().replace("-", "") != "utf8":
                stream.reconfigure(errors="replace")
        with stop_on_signals(alone=args is None) as stopping:
            try:
                status = super().main(args, prog_name, complete_var, False, windows_expand_args, **extra)
            except BaseException as error:
                if stopping.heard:
                    raise
                status = _report_failure(error)
            if status == STOPPED and not stopping.heard:
                stopping.say()
            sys.exit(status if isinstance(status, int) else DONE)


def command_of(name: str, brief: bool = False) -> Any:
    """Return the command of a name; a brief one has no options."""
    module = import_module(f"hophoop.cli.{'short' if name in SHORT else name}")
    function = getattr(module, name)
    from hophoop.cli._options import declared, summary

    one = typer.Typer(add_completion=False)
    one.command(
        name,
        cls=getattr(module, "COMMAND_CLASS", None),
        help=summary(function),
        rich_help_panel="Research" if name in RESEARCH else None,
        context_settings={"help_option_names": ["-h", "--help"]},
    )((lambda: None) if brief else declared(function))
    return typer.main.get_command(one)


def _report_failure(error: BaseException) -> int:
    """Report an error; return the exit status."""
    if isinstance(error, (typer.Abort, KeyboardInterrupt)):
        return STOPPED
    if isinstance(error, (OSError, InputError, MissingExtra)):
        from hophoop.scenario.checking import sentence

        _say_error(sentence(error))
        return BAD_INPUT
    if isinstance(error, MemoryError) or any(word in str(error) for word in TOO_LITTLE):
        _say_error(f"There is not enough memory: {str(error) or 'ask for less'}.".replace("..", "."))
        return BAD_INPUT
    # an error in the arguments, reported by the parser
    _explain(error)
    describe = getattr(error, "format_message", None)
    if describe is None:
        if not isinstance(error, Exception):
            raise error
        _report_defect(error)
        return DEFECT
    text = " ".join(str(describe()).split())
    command = getattr(getattr(error, "ctx", None), "command_path", "hophoop")
    if "\n" in str(describe()) or not text:  # the help, if the command is missing
        typer.echo(str(describe()), err=True)
    else:
        _say_error(f"{text.rstrip('.')}. See {command} --help.")
    return int(getattr(error, "exit_code", BAD_INPUT))


def _explain(error: BaseException) -> None:
    """Name the value that is no number, and the option for a name of Python."""
    if hasattr(error, "option_name") and hasattr(error, "possibilities"):
        from hophoop.cli._options import OPTIONS

        word = str(error.option_name).lstrip("-").replace("-", "_")
        own = {flag for param in error.ctx.command.params for flag in param.opts}  # type: ignore[attr-defined]
        named = [option.flag for option in OPTIONS if option.path.rpartition(".")[2] == word and not option.to_si]
        meant = [flag for flag in named if flag in own]
        error.possibilities = meant or error.possibilities
        return
    problems = getattr(error.__cause__, "errors", None)  # of pydantic, which parses numbers for Typer
    first = problems()[0] if problems else {"type": ""}
    allowed = {"float_parsing": "a number, such as 3.1", "int_parsing": "a whole number, such as 3"}.get(first["type"])
    param = getattr(error, "param", None)
    if allowed and param is not None:
        flag = max(param.opts, key=len)
        error.format_message = lambda: f"{flag} = {first['input']!r} must be {allowed}."  # type: ignore[attr-defined]


def say(text: str) -> None:
    """Print a line on standard error; standard output is for results."""
    typer.echo(text, err=True)


def _report_defect(error: Exception) -> None:
    """Print the traceback of a defect, and how to report it."""
    from hophoop import __version__

    traceback.print_exception(error)
    say(
        f"This is a defect of hophoop {__version__} or of its installation, not of your input. "
        "Please report it as an issue of hophoop's repository, with the lines above and the command."
    )


def _say_error(sentence: str) -> None:
    say(f"Error: {plain(sentence)}")


app = typer.Typer(
    name="hophoop",
    cls=Commands,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        from hophoop import __version__

        typer.echo(__version__)
        raise typer.Exit


@app.callback()
def main(
    version: bool = typer.Option(False, "--version", callback=_version, is_eager=True, help="Print the version."),
) -> None:
    """Exact motion of a loaded hoop that rolls, spins, skids, hops and lands on a plane."""
