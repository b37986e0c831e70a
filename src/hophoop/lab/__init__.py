"""The lab: an interactive page, and the same player as a notebook widget."""

from typing import Any

__all__ = ["serve", "show"]


def __getattr__(name: str) -> Any:
    # server and widget need different libraries
    if name == "show":
        from hophoop.lab.widget import show

        return show
    if name == "serve":
        from hophoop.lab.server import serve

        return serve
    raise AttributeError(f"module 'hophoop.lab' has no attribute {name!r}")
