"""Entries: the kernels that Python calls in compiled form, and the types of their arguments.

The build compiles one function per entry into the library, and `calls` calls it. All other kernels that Python calls are fast
enough interpreted. A type is `float`, `int`, `bool`, a named tuple of these, or an `Array`.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple, get_type_hints

import numpy as np

from hophoop.kernel.native.sources import LIBRARY_TOOLS, TOOLS, hash_of
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.compliant import Compliance
from hophoop.kernel.records.layout import EVENT, SEGMENT, MapRequest, MapResults, Scratch, Tables, Until
from hophoop.kernel.records.state import State


class Array(NamedTuple):
    """A contiguous array in C order.

    Attributes
    ----------
    dtype : numpy.dtype
    dimensions : int
    """

    dtype: np.dtype[Any]
    dimensions: int = 1


class Named(NamedTuple):
    """A named tuple of a package above the kernel, which is imported when the library is built.

    Attributes
    ----------
    name : str
        With its module.
    kinds : tuple
        Of its fields.
    """

    name: str
    kinds: tuple[Any, ...]


REAL, WHOLE = np.dtype(np.float64), np.dtype(np.int64)
EVENTS, SEGMENTS = Array(EVENT), Array(SEGMENT)
ROW, TABLE, CUBE, COUNTS = Array(REAL), Array(REAL, 2), Array(REAL, 3), Array(WHOLE)

# Arrays in named tuples, whose annotations do not state dtype and dimensions.
FIELDS: dict[type, tuple[Array, ...]] = {
    Scratch: (TABLE, TABLE, ROW, ROW, TABLE, ROW, COUNTS),
    Tables: (TABLE, EVENTS, SEGMENTS),
    MapResults: (TABLE, Array(np.dtype(np.int32), 2), Array(np.dtype(np.uint64), 2)),
}

_THEORY = "hophoop.theory.kernels."
_GAITS = "hophoop.gaits.kernels."
REQUEST = Named(_GAITS + "layout.Request", (int, int, bool))
CODED, PACKED = Array(WHOLE, 2), Array(np.dtype(np.uint64), 2)
BUFFERS = Named(_GAITS + "layout.Buffers", (TABLE, PACKED, ROW, EVENTS, SEGMENTS))
WORKSPACE = Named("hophoop.derivatives.workspace.Workspace", (Scratch, TABLE))

# Two processes compile them in this order: what many share comes first.
ENTRIES: dict[str, tuple[Any, ...]] = {
    "hophoop.kernel.rigid.run.run": (Body, State, int, float, float, int, EVENTS, SEGMENTS, Scratch),
    "hophoop.kernel.records.refusals.mark_refused": (TABLE,),
    "hophoop.kernel.compliant.event_loop.run": (Body, Compliance, ROW, bool, float, float, int, EVENTS, TABLE, ROW),
    "hophoop.kernel.compliant.event_loop.sample": (Body, Compliance, TABLE, ROW, bool, TABLE),
    "hophoop.derivatives.tangents.propagate_tangents": (
        Body, Named("hophoop.derivatives.workspace.KnownMotion", (EVENTS, SEGMENTS, float, float)), TABLE, TABLE,
        Named("hophoop.derivatives.workspace.Solution", (CUBE, CUBE, COUNTS, COUNTS)), WORKSPACE,
    ),
    "hophoop.derivatives.pieces.sampling.sample_tangents": (
        Body, Named("hophoop.derivatives.workspace.Pieces", (SEGMENTS, CUBE, TABLE)), ROW, ROW, bool,
        Named("hophoop.derivatives.workspace.Samples", (TABLE, CUBE)), WORKSPACE,
    ),
    "hophoop.derivatives.pieces.energies.fill_energies": (Body, TABLE, CUBE, TABLE, TABLE, CUBE),
    "hophoop.derivatives.pieces.required_friction.fill_peaks": (Body, SEGMENTS, int, int, Scratch, TABLE),
    "hophoop.derivatives.pieces.required_friction.use_changes": (Body, float, float, float, TABLE, TABLE, ROW, ROW),
    "hophoop.kernel.numerics.elementwise.fill": (int, ROW, ROW, ROW),
    "hophoop.kernel.rigid.sampling.sample": (Body, SEGMENTS, ROW, bool, TABLE),
    "hophoop.kernel.records.writing.kernel_times": (ROW, float, ROW, float, ROW),
    "hophoop.kernel.physics.contact.utilizations": (Array(np.dtype(np.bool_)), ROW, ROW, ROW, ROW, ROW),
    _THEORY + "critical.slip_speed": (Body,),
    _THEORY + "painleve.border": (Body, float, bool),
    _THEORY + "painleve.minimum": (Body,),
    _THEORY + "painleve.regions": (Body, ROW, ROW, COUNTS),
    _THEORY + "painleve.thresholds": (Body, ROW, ROW),
    _THEORY + "phase_plane.lift_off": (Body, float),
    _THEORY + "phase_plane.lift_off_speeds": (Body, ROW, ROW),
    _THEORY + "phase_plane.modes": (Body, ROW, ROW, COUNTS),
    _THEORY + "phase_plane.rolling_ranges": (Body, ROW, TABLE),
    _THEORY + "rolling.contact_losses": (Body, ROW, TABLE),
    _THEORY + "rolling.forces": (Body, ROW, ROW, TABLE),
    _THEORY + "rolling.kinetic": (Body, ROW, ROW, ROW),
    _THEORY + "rolling.needed_frictions": (Body, ROW, TABLE),
    _THEORY + "rolling.speeds": (Body, ROW, ROW, ROW),
    "hophoop.kernel.rigid.run.run_cell": (Tables, Until),
    "hophoop.maps.grid.kernel.evaluate_block": (TABLE, int, int, MapRequest, MapResults),
    _THEORY + "critical.hop_speed": (Body, float),
    _GAITS + "passages.follow_passages": (Body, State, int, REQUEST, BUFFERS, Scratch),
    _GAITS + "cells.judge_cells": (TABLE, REQUEST, CODED, TABLE),
}  # fmt: skip


def kernel_named(name: str) -> Any:
    """Return the kernel of an entry, or another object by its dotted name."""
    module, _, function = name.rpartition(".")
    return getattr(import_module(module), function)


def class_of(kind: Any) -> Any:
    """Return the class of a named tuple."""
    return kernel_named(kind.name) if isinstance(kind, Named) else kind


def is_tuple(kind: Any) -> bool:
    """Return True if a kind is that of a named tuple."""
    return isinstance(kind, Named) or (isinstance(kind, type) and issubclass(kind, tuple))


def kinds_of(kind: Any) -> tuple[Any, ...]:
    """Return the kinds of a named tuple's fields."""
    if isinstance(kind, Named):
        return kind.kinds
    return FIELDS.get(kind) or tuple(get_type_hints(kind).values())


def description(kind: Any) -> Any:
    """Return the description of an argument type that `kernel.native.calls` reads."""
    if isinstance(kind, Array):
        return {"array": [kind.dtype.str if kind.dtype.names is None else kind.dtype.descr, kind.dimensions]}
    if is_tuple(kind):
        return {"items": [description(each) for each in kinds_of(kind)], "fields": class_of(kind)._fields}
    return kind.__name__


def code_hash() -> str:
    """Return a hash of all that is compiled for the entries, and of how it is compiled."""
    entries = {kernel_named(name): [description(kind) for kind in kinds] for name, kinds in ENTRIES.items()}
    return hash_of(entries, (*TOOLS, *LIBRARY_TOOLS))
