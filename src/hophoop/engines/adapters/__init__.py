"""Adapters to physics engines, one module each, which imports its engine when it runs."""

from __future__ import annotations

from typing import Any

from hophoop._support import extras as _extras


def engine_module(name: str) -> Any:
    """Import a module of an engine.

    Parameters
    ----------
    name : str
        Dotted name.

    Returns
    -------
    module : module

    Raises
    ------
    ImportError
        If it is not installed; the message names the extra.
    """
    return _extras.need(name, "engines")
