"""Outputs of commands: names of files, checked before anything is computed; JSON; errors in terms of options."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import typer

from hophoop._support.errors import InputError

PICTURES = (".png", ".svg", ".pdf", ".jpg")


def check_outputs(
    outputs: Mapping[str, tuple[Path | None, tuple[str, ...] | None]],
    source: str | Path | None = None,
    what: str = "the scenario",
) -> None:
    """Refuse names of outputs before anything is computed.

    outputs: by option, the path and its possible endings, empty for any, None for a folder that is created; source: the file
    that is read, and what it is.
    """
    named = {option: (path, endings) for option, (path, endings) in outputs.items() if path is not None}
    for option, (path, endings) in named.items():
        if endings:
            check_ending(option, path, endings)
        if endings is not None:
            check_folder(option, path)
    check_apart([path for path, _ in named.values()], source, what)


def check_ending(option: str, path: Path, endings: tuple[str, ...]) -> None:
    """Refuse a name without the ending of a known format."""
    if not path.name.lower().endswith(endings):
        known = " or ".join(part for part in (", ".join(endings[:-1]), endings[-1]) if part)
        raise InputError(f"{option} = {path} must end in {known}.", field=option, value=path, allowed=known)


def check_folder(option: str, path: Path) -> None:
    """Refuse a name in a folder that does not exist, before anything long is computed."""
    if not path.absolute().parent.is_dir():
        raise InputError(
            f"{option} = {path} must be in an existing folder; {path.parent} does not exist.", field=option, value=path
        )


def check_apart(paths: list[Path], source: str | Path | None, what: str) -> None:
    """Refuse two outputs into one file, or one over the file that is read."""
    whole = [path.absolute() for path in paths]
    for k, path in enumerate(whole):
        if path in whole[:k]:
            raise InputError(f"{paths[k]} is used for two outputs.")
        if source not in (None, "-") and path == Path(str(source)).absolute():
            raise InputError(f"{paths[k]} is {what} itself: name another file for the output.")


def save_picture(axes: Any, path: Path, dpi: float | str = 150) -> None:
    """Write the figure of some axes, whole or not at all."""
    from hophoop._support.files import replacing

    with replacing(path) as picture:
        axes.figure.savefig(picture, dpi=dpi)


@contextmanager
def named_options(names: Mapping[str, str]) -> Iterator[None]:
    """Rename arguments in errors to options; for a command's own arguments this is done already."""
    try:
        yield
    except InputError as error:
        if error.field is None or error.field not in names:
            raise
        raise error.renamed(names[error.field]) from None


def print_json(data: object, indent: int | None = 2) -> None:
    """Print a result as JSON, numbers in full precision."""
    typer.echo(json.dumps(data, indent=indent, ensure_ascii=False, allow_nan=False))


def write_json(data: object, path: Path, indent: int = 2) -> None:
    """Write a result as JSON, whole or not at all."""
    from hophoop._support.files import replacing

    with replacing(path) as file:
        file.write_text(json.dumps(data, indent=indent, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")
