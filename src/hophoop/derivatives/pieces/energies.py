"""Kinetic and potential energy of a state, with their slopes by the state and by the parameters."""

from __future__ import annotations

from typing import Any

import numpy as np

from hophoop.derivatives.layout import EPS, GT, VN, X
from hophoop.derivatives.parameters import Floats
from hophoop.kernel.numerics import elementwise
from hophoop.kernel.numerics.arithmetic import weighted_sum
from hophoop.kernel.physics.body import Body

COLUMNS = "x", "height", "theta", "omega", "slip", "vy"  # rows X to VN of what is carried
ENERGIES = ("kinetic", "potential", "total", "friction")


def energy_rates(field: str, body: Body, state: Floats, rates: Floats, parameter_tangents: Floats) -> tuple[Floats, Floats]:
    """An energy and how it changes in all directions.

    Parameters
    ----------
    field : {'kinetic', 'potential', 'total'}
    body : Body
    state : ndarray, shape (6,) or (m, 6)
        By COLUMNS.
    rates : ndarray, shape (STATE_ROWS or more, n) or (m, STATE_ROWS or more, n)
        Of the state.
    changes : ndarray, shape (PARAMETERS, n)
        Of the parameters.

    Returns
    -------
    value : ndarray, shape () or (m,)
    rates : ndarray, shape (n,) or (m, n)
        All in kernel units.
    """
    columns = state.tolist() if state.ndim == 1 else list(np.moveaxis(state, -1, 0))
    if field == "total":
        (one, state_one, parameters_one), (other, state_other, parameters_other) = (
            part(body, *columns) for part in (_kinetic, _potential)
        )
        value = one + other
        by_state = np.array([a + b for a, b in zip(state_one, state_other, strict=True)])
        by_parameters = np.array([a + b for a, b in zip(parameters_one, parameters_other, strict=True)])
    else:
        value, *slopes = (_kinetic if field == "kinetic" else _potential)(body, *columns)
        by_state, by_parameters = (np.array(each) for each in slopes)
    by_place = weighted_sum(by_state[..., None], [rates[..., row, :] for row in range(X, VN + 1)])
    return value, by_place + weighted_sum(by_parameters[..., None], parameter_tangents[EPS : GT + 1])


def _kinetic(body: Body, x: Any, y: Any, th: Any, om: Any, vt: Any, vn: Any) -> tuple[Any, list[Any], list[Any]]:
    """The energy, its slopes by x, y, θ, θ̇, v_t, v_n, and those by ε, κ, μs, μk, g_n, g_t."""
    s, c = elementwise.sine_and_cosine(th)
    arm = 1.0 + body.eps * c
    along = vt + om * arm
    up = vn - body.eps * om * s
    none = 0.0 * om
    value = 0.5 * (along * along + up * up + body.kap * om * om)
    by_angle = -body.eps * om * (s * along + c * up)
    by_turning = along * arm - body.eps * s * up + body.kap * om
    by_load = om * (c * along - s * up)
    return value, [none, none, by_angle, by_turning, along, up], [by_load, 0.5 * om * om, none, none, none, none]


def _potential(body: Body, x: Any, y: Any, th: Any, om: Any, vt: Any, vn: Any) -> tuple[Any, list[Any], list[Any]]:
    """As `_kinetic`."""
    s, c = elementwise.sine_and_cosine(th)
    half = elementwise.sine(0.5 * th)
    fallen = -2.0 * half * half
    drop = y + body.eps * fallen
    ahead = x + body.eps * s
    none = 0.0 * th
    value = body.gn * drop - body.gt * ahead
    by_angle = -body.eps * (body.gn * s + body.gt * c)
    by_load = body.gn * fallen - body.gt * s
    return value, [none - body.gt, none + body.gn, by_angle, none, none, none], [by_load, none, none, none, drop, -ahead]
