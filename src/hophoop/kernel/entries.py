"""The kernels that Python calls in compiled form, and what each takes.

The build makes a function of each in the library of this machine's kind; `calls` calls it. All else that Python calls is quick
interpreted. A kind is `float`, `int`, `bool`, a named tuple of such, or an `Array`.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.compliant import Compliance
from hophoop.kernel.records.layout import EVENT, SEGMENT, MapRequest, MapResults, Tables
from hophoop.kernel.records.scratch import Scratch
from hophoop.kernel.records.state import State


class Array(NamedTuple):
    """An array whose items lie one after the other, rows first.

    Attributes
    ----------
    dtype : numpy.dtype
    dimensions : int
    """

    dtype: np.dtype[Any]
    dimensions: int = 1


REAL, WHOLE = np.dtype(np.float64), np.dtype(np.int64)
EVENTS, SEGMENTS = Array(EVENT), Array(SEGMENT)
ROW, TABLE, CUBE, COUNTS = Array(REAL), Array(REAL, 2), Array(REAL, 3), Array(WHOLE)

# Arrays in named tuples, whose annotations do not tell their kind.
FIELDS: dict[type, tuple[Array, ...]] = {
    Scratch: (TABLE, TABLE, ROW, ROW, TABLE, ROW, COUNTS),
    Tables: (TABLE, EVENTS, SEGMENTS),
    MapResults: (TABLE, Array(np.dtype(np.int32), 2), Array(np.dtype(np.uint64), 2)),
}

_THEORY = "hophoop.theory.kernels."

# Each group is compiled by a process of its own, and again only where a source that it is made of has changed.
GROUPS: dict[str, dict[str, tuple[Any, ...]]] = {
    "motions": {
        "hophoop.kernel.rigid.run.run": (Body, State, float, float, int, EVENTS, SEGMENTS, Scratch, EVENTS),
        "hophoop.kernel.rigid.run.run_cell": (Tables, EVENTS),
        "hophoop.maps.grid.kernel.evaluate_block": (
            TABLE, int, int, MapRequest, EVENTS, MapResults,
        ),
        _THEORY + "critical.hop_speed": (Body, float),
    },
    "compliant": {
        "hophoop.kernel.compliant.run.run_into": (
            Body, Compliance, ROW, bool, float, float, int, EVENTS, SEGMENTS, ROW, TABLE,
        ),
        "hophoop.kernel.compliant.sampling.sample": (Body, Compliance, TABLE, ROW, bool, TABLE),
    },
    "derivatives": {
        "hophoop.derivatives.events.ending.go_through": (
            Body, EVENTS, SEGMENTS, TABLE, TABLE, float, float, bool, CUBE, CUBE, COUNTS, COUNTS, Scratch, TABLE,
        ),
        "hophoop.derivatives.pieces.sampling.sample_changes": (
            Body, SEGMENTS, CUBE, TABLE, ROW, ROW, bool, TABLE, CUBE, Scratch, TABLE,
        ),
        "hophoop.derivatives.pieces.required_friction.need_at_rest": (Body, float),
        "hophoop.derivatives.pieces.required_friction.needs_on_panel": (Body, SEGMENTS, int, Scratch, ROW, ROW, ROW),
        "hophoop.derivatives.pieces.required_friction.peak_on_panel": (Body, SEGMENTS, int, float, float, Scratch),
        "hophoop.derivatives.pieces.required_friction.use_changes": (Body, float, float, float, TABLE, TABLE, ROW, ROW),
    },
    "answers": {
        "hophoop.kernel.rigid.sampling.sample": (Body, SEGMENTS, ROW, bool, TABLE),
        "hophoop.kernel.records.times.kernel_times": (ROW, float, ROW, float, ROW),
        "hophoop.kernel.physics.friction.utilizations": (Array(np.dtype(np.bool_)), ROW, ROW, ROW, ROW, ROW),
        _THEORY + "critical.slip_speeds": (TABLE, ROW),
        _THEORY + "painleve.border": (Body, float, bool),
        _THEORY + "painleve.minima": (TABLE, TABLE),
        _THEORY + "painleve.regions": (TABLE, ROW, ROW, COUNTS),
        _THEORY + "painleve.thresholds": (TABLE, ROW, ROW),
        _THEORY + "phase_plane.lift_off": (Body, float),
        _THEORY + "phase_plane.lift_off_speeds": (TABLE, ROW, ROW),
        _THEORY + "phase_plane.modes": (TABLE, ROW, ROW, COUNTS),
        _THEORY + "phase_plane.rolling_ranges": (TABLE, ROW, TABLE),
        _THEORY + "rolling.contact_losses": (TABLE, ROW, TABLE),
        _THEORY + "rolling.forces": (TABLE, ROW, ROW, TABLE),
        _THEORY + "rolling.kinetic": (TABLE, ROW, ROW, ROW),
        _THEORY + "rolling.needed_frictions": (TABLE, ROW, TABLE),
        _THEORY + "rolling.rocking_periods": (TABLE, ROW, ROW),
        _THEORY + "rolling.speeds": (TABLE, ROW, ROW, ROW),
        _THEORY + "rolling.times": (TABLE, ROW, ROW, ROW),
    },
}  # fmt: skip


def kernel_named(name: str) -> Any:
    """The kernel of an entry."""
    module, _, function = name.rpartition(".")
    return getattr(import_module(module), function)


def fields_of(kind: Any) -> tuple[tuple[str, Any], ...]:
    """Names and kinds of a named tuple's fields."""
    if kind in FIELDS:
        return tuple(zip(kind._fields, FIELDS[kind], strict=True))
    import typing

    hints = typing.get_type_hints(kind)
    return tuple((name, hints[name]) for name in kind._fields)


def is_tuple(kind: Any) -> bool:
    """Whether a kind is that of a named tuple."""
    return isinstance(kind, type) and issubclass(kind, tuple)
