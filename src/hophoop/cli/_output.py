"""What commands share: names of files that are checked before anything is computed, tables that fit, words of a refusal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from hophoop._support.errors import InputError

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

PICTURES = (".png", ".svg", ".pdf", ".jpg")


def console_of(width: int) -> Console:
    """Where tables are printed; a pipe, which has no width of its own, gets one: a table that is cut is worth little."""
    from rich.console import Console

    console = Console(highlight=False)
    return console if console.is_terminal else Console(highlight=False, width=width)


def check_ending(option: str, path: Path, endings: tuple[str, ...]) -> None:
    """Refuse a name that does not tell a known format."""
    if not path.name.lower().endswith(endings):
        known = " or ".join(part for part in (", ".join(endings[:-1]), endings[-1]) if part)
        raise InputError(f"{option} = {path} must end in {known}.", field=option, value=path, allowed=known)


def check_folder(option: str, path: Path) -> None:
    """Refuse a name in a folder that is not there, before anything long is computed."""
    if not path.absolute().parent.is_dir():
        raise InputError(
            f"{option} = {path} must be in a folder that is there; {path.parent} is not.", field=option, value=path
        )


def check_apart(paths: list[Path], source: str | None = None) -> None:
    """Refuse two outputs into one file, or one over the file that is read."""
    whole = [path.absolute() for path in paths]
    for k, path in enumerate(whole):
        if path in whole[:k]:
            raise InputError(f"{paths[k]} is named for two outputs.")
        if source not in (None, "-") and path == Path(str(source)).absolute():
            raise InputError(f"{paths[k]} is the scenario itself: name another file for the output.")


def in_options(error: InputError, names: Mapping[str, str]) -> InputError:
    """An error with the option in place of the argument of a Python function; `names` maps arguments to options."""
    option = names.get(error.field or "")
    return error if option is None else error.renamed(option)


@contextmanager
def named_options(names: Mapping[str, str]) -> Iterator[None]:
    """For options whose argument has another name in Python; those of the same name need no word (see `Commands`)."""
    try:
        yield
    except InputError as error:
        raise in_options(error, names) from None


def fitted(table: Table, console: Console, spare: Sequence[str]) -> list[str]:
    """Take columns out of a table until it fits, since half of a number is worth nothing; returns their titles."""
    from rich.measure import Measurement

    left_out: list[str] = []
    endless = console.options.update(width=10_000)
    for title in spare:
        if Measurement.get(console, endless, table).maximum <= console.width:
            break
        table.columns = [column for column in table.columns if column.header != title]
        left_out.append(title)
    return left_out
