"""Checks of the names of output files, before anything is computed."""

from __future__ import annotations

from pathlib import Path

from hophoop.scenario import InputError

PICTURES = (".png", ".svg", ".pdf", ".jpg")


def check_ending(option: str, path: Path, endings: tuple[str, ...]) -> None:
    """Refuse a name that does not tell a known format."""
    if not path.name.lower().endswith(endings):
        raise InputError(f"{option} = {path} must end in {', '.join(endings[:-1])} or {endings[-1]}.")


def check_folder(option: str, path: Path) -> None:
    """Refuse a name in a folder that is not there, before anything long is computed."""
    if not path.absolute().parent.is_dir():
        raise InputError(f"{option} = {path} must be in a folder that is there; {path.parent} is not.")


def check_apart(paths: list[Path], source: str | None = None) -> None:
    """Refuse two outputs into one file, or one over the scenario that is read."""
    whole = [path.absolute() for path in paths]
    for k, path in enumerate(whole):
        if path in whole[:k]:
            raise InputError(f"{paths[k]} is named for two outputs.")
        if source not in (None, "-") and path == Path(str(source)).absolute():
            raise InputError(f"{paths[k]} is the scenario itself: name another file for the output.")
