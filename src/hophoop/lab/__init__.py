"""The lab: an interactive page, its programming interface over HTTP, and the same player as a notebook widget."""

from typing import Any

__all__ = ["show"]


def __getattr__(name: str) -> Any:
    # the widget imports its own libraries, which the server does not need
    if name == "show":
        from hophoop.lab.widget import show

        return show
    raise AttributeError(f"module 'hophoop.lab' has no attribute {name!r}")
