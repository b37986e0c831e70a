"""The input, output and working arrays of derivatives."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from hophoop.derivatives.layout import EVENT_ROWS, STATE_ROWS
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.steps import DRIVEN, STRETCH, from_reference

# Rows of the array that a panel is worked out in: dθ̇²/dθ; the change of θ̇² by its value at the start (of an arriving panel by
# θ there), by θ at the start (by the turning point), and by ρ where it is 0; weights of the nodes; the change by parameters, a
# row per direction.
SLOPE, BEGIN, SHIFT, RESISTED, INTERPOLATE, INTEGRATE, WEIGH, OWN = range(8)


class KnownMotion(NamedTuple):
    """A computed motion in kernel units."""

    events: Any  # of records.EVENT
    segments: Any  # of records.SEGMENT
    t_end: float  # its duration
    doubt: float  # the time after which doubles do not decide what follows, inf if they always do


class Solution(NamedTuple):
    """The derivatives of a motion in n directions, which the kernels fill in."""

    at_events: Any  # shape (events, EVENT_ROWS, n)
    at_segments: Any  # shape (segments, STATE_ROWS, n), at their starts
    reasons: Any  # of int, shape (n,): why there is no derivative after some event, −1 if it is one-sided, else 0
    failed: Any  # of int, shape (n,): the first event without a derivative, else −1


class Pieces(NamedTuple):
    """The segments of a motion and their tangents."""

    segments: Any  # of records.SEGMENT
    at_segments: Any  # shape (segments, STATE_ROWS, n)
    parameter_tangents: Any  # shape (PARAMETERS, n)


class Samples(NamedTuple):
    """States and tangents at some times, which `sample_tangents` fills in."""

    states: Any  # shape (times, 6)
    tangents: Any  # shape (times, STATE_ROWS, n)


class Workspace(NamedTuple):
    """The arrays that a computation of derivatives works in."""

    scratch: Any  # records.Scratch
    local: Any  # shape (OWN + n, ORDER), values at the nodes of a panel


def new_solution(events: int, segments: int, directions: int) -> Solution:
    """A solution to be filled in."""
    return Solution(
        np.zeros((events, EVENT_ROWS, directions)),
        np.zeros((segments, STATE_ROWS, directions)),
        np.zeros(directions, np.int64),
        np.full(directions, -1, np.int64),
    )


def new_workspace(scratch, directions):
    """A workspace for n directions."""
    return Workspace(scratch, np.zeros((OWN + directions, ORDER)))


@noinline
def integrate_row(panel, row, growth, work):
    """Integrate a rate of dθ̇²/dθ from the panel's reference, with the integrating factor `growth`."""
    integral = work[DRIVEN]
    for i in range(ORDER):
        row[i] *= work[STRETCH, i] / growth[i]
    from_reference(panel, row, integral)
    for i in range(ORDER):
        row[i] = growth[i] * integral[i]
