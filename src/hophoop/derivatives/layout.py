"""Rows of the arrays of derivatives that the kernels fill, with one column per direction.

A direction changes all parameters and the start together. Its tangent is the state of the changed motion at a time that may
change too: at t + dt it is at x + dx, θ + dθ and so on. A step along the motion changes all of them and describes the same
motion, so that each piece uses the form that suits it.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from hophoop.kernel.model import Body
from hophoop.kernel.native import inline

# What changes in a body; END is the duration.
EPS, KAP, MU_S, MU_K, GN, GT, REST, END, RESIST = range(9)
PARAMETERS = 9

# A state and its ledger, which are propagated from event to event.
T, X, Y, TH, OM, VT, VN, IMPACT_N, IMPACT_T, ROLLING_LOSS = range(10)
STATE_ROWS = 10

# Of an event also the velocities before it, and its impulse.
BEFORE_OM, BEFORE_VT, BEFORE_VN, P_N, P_T = range(STATE_ROWS, STATE_ROWS + 5)
EVENT_ROWS = STATE_ROWS + 5

STILL = Body(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0, False, 0.0, 0.0)  # the tangent of a body that does not change


@inline
def body_tangent(parameter_tangents: Any, k: int) -> Body:
    """Return the tangent of a body in a direction."""
    return Body(
        parameter_tangents[EPS, k], parameter_tangents[KAP, k], parameter_tangents[MU_S, k], parameter_tangents[MU_K, k],
        parameter_tangents[GN, k], parameter_tangents[GT, k], parameter_tangents[REST, k], 0, False, 0.0,
        parameter_tangents[RESIST, k],
    )  # fmt: skip


class Reason(IntEnum):
    """Why a derivative does not exist, or is not computed."""

    NONE = 0
    GRAZE = 1
    BORDER = 2
    PLASTIC = 3
    CONTACT = 4
    SINGULAR = 5
    MASSLESS = 6
    FRICTIONLESS = 7
    ENDED = 8


REASONS = {
    Reason.GRAZE: "a quantity that sets off the event only touches zero there",
    Reason.BORDER: "the motion lies on the border of two classes: the least change may lead to other events",
    Reason.PLASTIC: "restitution is 0 and the rim has landed: with any restitution it would bounce",
    Reason.CONTACT: "the motion starts in contact: with the rim lifted or thrown it would bounce, and its events are others",
    Reason.SINGULAR: "the slip runs into p_σ = 0, where the contact force has no bound",
    Reason.MASSLESS: "the massless hoop (γ = 1) is a singular limit once the contact force is lost",
    Reason.FRICTIONLESS: "without friction the hoop rests on no more than a border of two classes",
    Reason.ENDED: "the motion has no answer from there on",
}
