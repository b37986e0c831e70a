"""Results of a motion: records in SI units, poses, saved files, and a picture for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hophoop.results.records import (
        ArraySample,
        EventErrors,
        EventRecord,
        Events,
        Ledger,
        Motion,
        Sample,
        ScalarSample,
        Velocity,
    )  # fmt: skip

__all__ = [
    "ArraySample", "EventErrors", "EventRecord", "Events", "Ledger", "Motion",
    "Sample", "ScalarSample", "Velocity",
]  # fmt: skip


def __getattr__(name: str) -> Any:  # imported on first use, so that `hophoop --help` starts quickly
    if name not in __all__:
        raise AttributeError(f"module 'hophoop.results' has no attribute {name!r}")
    from hophoop.results import records

    return getattr(records, name)
