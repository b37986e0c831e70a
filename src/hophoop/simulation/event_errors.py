"""Error estimates of events: rounding at every event, amplified by the derivatives of the motion after it.

From event to event the derivatives propagate the covariance of the state, to which each event adds its own rounding. Rounding
inside a phase is attributed to the event at its start.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from hophoop._support.errors import InputError
from hophoop.derivatives.layout import MU_K, MU_S, OM, PARAMETERS, STATE_ROWS, TH, VN, VT, T, X, Y
from hophoop.derivatives.results.propagation import transitions
from hophoop.kernel.model import Mode
from hophoop.kernel.numerics.arithmetic import matrix_product, weighted_sum
from hophoop.results.records import EventErrors, Motion

ROUNDING = 4e-16  # relative rounding of a quantity at an event
FIELDS = ("t", "x", "height", "angle", "vx", "vy", "omega", "slip")
FRICTION = STATE_ROWS  # the direction of both coefficients of friction; those before it are of the state
DIRECTIONS = STATE_ROWS + 1


def _variances_of(row: np.void) -> NDArray[np.float64]:
    """Return the variance of each direction by the rounding of an event, in units of R, m and √(R/g)."""
    speed = abs(row["omega"]) + abs(row["slip"])
    sizes = np.zeros(DIRECTIONS)
    sizes[TH] = 1.0
    sizes[OM] = abs(row["omega"])
    sizes[FRICTION] = 1.0  # rounding of the margins to the friction cone acts like rounding of the coefficients
    if row["after_mode"] == Mode.FLIGHT:
        sizes[Y] = row["height"]
    if row["slip"] != 0.0:  # else zero by the definition of the event, as v_n
        sizes[VT] = speed
    if row["vy"] != 0.0:
        sizes[VN] = speed + abs(row["vy"])
    return np.square(ROUNDING * sizes)


def estimated_errors(motion: Motion) -> NDArray[np.float64]:
    """Return estimated errors of the events of a rigid motion, shape (n, len(FIELDS)), in units of R, m and √(R/g).

    inf from an event on that has no derivatives.
    """
    body, events = motion.scenario.to_body(), motion.tables["events"]
    friction = np.zeros((PARAMETERS, 1))
    if not math.isinf(body.mu_s):
        friction[[MU_S, MU_K], 0] = body.mu_s, body.mu_k
    table = np.stack([events[name] for name in FIELDS], axis=1)
    squares = np.square(ROUNDING * (1.0 + np.abs(table)))
    covariance = np.zeros((DIRECTIONS, DIRECTIONS))
    for first, last, rates in transitions(motion, friction):
        covariance += np.diag(_variances_of(events[first]))
        tangents = np.where(covariance.any(axis=0), rates, 0.0)
        changes = tangents[:, [T, X, Y, TH, OM, VN, OM, VT]]
        changes[:, FIELDS.index("vx")] += tangents[:, VT]
        flat = changes.reshape(-1, DIRECTIONS)
        found = weighted_sum(matrix_product(flat, covariance).T, flat.T).reshape(-1, len(FIELDS))
        if not np.isfinite(found).all():
            squares[first + 1 :] = math.inf
            break
        squares[first + 1 : last + 1] += np.maximum(found, 0.0)
        covariance[:STATE_ROWS, :STATE_ROWS] = matrix_product(matrix_product(tangents[-1], covariance), tangents[-1].T)
        covariance[FRICTION] = covariance[:, FRICTION] = 0.0
    result: NDArray[np.float64] = np.sqrt(squares)
    return result


def event_errors(motion: Motion) -> EventErrors:
    """Compute `Trajectory.errors`."""
    if motion.scenario.contact.model != "rigid":
        raise InputError("motion.errors needs rigid contact; in compliant contact contact.rtol controls the error.")
    table, unit = estimated_errors(motion), motion.units
    return EventErrors(**{name: table[:, i] * unit.of(name) for i, name in enumerate(FIELDS)})
