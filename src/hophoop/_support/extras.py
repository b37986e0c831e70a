"""Modules of optional extras: imported on use, with an error that names the extra to install."""

from __future__ import annotations

import re
from importlib import import_module
from importlib.metadata import PackageNotFoundError, requires
from pathlib import Path
from typing import Any

CHECKOUT = Path(__file__).parents[3]  # if this is one


class MissingExtra(ImportError):
    """A module of an extra is not installed; the message names the extra, and so does `extra`."""

    extra = ""


def install_command(extra: str) -> str:
    """Return the command that installs an extra where this copy of hophoop came from.

    No package index has hophoop, so outside of a checkout the command names the libraries of the extra.

    command: empty if the libraries are not known: a copy without metadata.
    """
    if (CHECKOUT / "pyproject.toml").is_file() and (CHECKOUT / "src" / "hophoop").is_dir():
        return f"pip install -e {_quoted(f'{CHECKOUT}[{extra}]')}"
    try:
        libraries = _libraries(extra, requires("hophoop") or [])
    except PackageNotFoundError:
        return ""
    return f"pip install {' '.join(map(_quoted, libraries))}" if libraries else ""


def _libraries(extra: str, required: list[str]) -> list[str]:
    """Return the requirements of an extra, and of the extras that it names."""
    found: list[str] = []
    for requirement in required:
        text, _, marker = requirement.partition(";")
        if not re.search(rf"extra == ['\"]{extra}['\"]", marker):
            continue
        own = re.match(r"hophoop\[(.*)\]", text.strip())
        names = [name for each in own[1].split(",") for name in _libraries(each.strip(), required)] if own else [text.strip()]
        found += [name for name in names if name not in found]
    return found


def _quoted(word: str) -> str:
    """Return a word as shells read it; in double quotes, which all of them know."""
    if re.search(r'["$`!\\]', word):
        import shlex

        return shlex.quote(word)
    return f'"{word}"'


def need(module: str, extra: str) -> Any:
    """Import a module that belongs to an extra.

    module: dotted name, such as ``"matplotlib.pyplot"``; extra: the extra of hophoop that installs it, such as ``"plots"``;
    result: the imported module.
    """
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        top = module.partition(".")[0]
        # A broken installation, in which a dependency of the module is missing, must not be hidden.
        if error.name is not None and error.name.partition(".")[0] != top:
            raise
        command = install_command(extra)
        found = f"{top} is not installed; it comes with the extra '{extra}'"
        missing = MissingExtra(f"{found}: {command}." if command else f"{found}.", name=module)
        missing.extra = extra
        raise missing from None
