"""Modules of optional extras: imported on use, with an error that names the extra to install."""

from __future__ import annotations

from importlib import import_module
from typing import Any


class MissingExtra(ImportError):
    """A module of an extra is not installed; the message names the extra, and so does `extra`."""

    extra = ""


def need(module: str, extra: str) -> Any:
    """Import a module that belongs to an extra.

    Parameters
    ----------
    module : str
        Dotted name, such as ``"matplotlib.pyplot"``.
    extra : str
        The extra of hophoop that installs it, such as ``"plots"``.

    Returns
    -------
    module : module
        The imported module.

    Raises
    ------
    MissingExtra
        If the module's distribution is not installed; the message names the extra.
    """
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        top = module.partition(".")[0]
        # A broken installation, in which a dependency of the module is missing, must not be hidden.
        if error.name is not None and error.name.partition(".")[0] != top:
            raise
        missing = MissingExtra(
            f"{top} is not installed; it comes with the extra '{extra}': pip install \"hophoop[{extra}]\".",
            name=module,
        )
        missing.extra = extra
        raise missing from None
