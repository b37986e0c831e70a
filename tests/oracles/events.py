"""What happens where a motion meets the plane or leaves a mode: bookkeeping that both integrations share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .mechanics import FLIGHT, ROLL

STATE = ("x", "height", "angle", "vx", "vy", "omega")
Mode = tuple[str, int]  # what the rim does, and which way the hoop turns against rolling resistance


def settle(
    events: list[dict[str, Any]],
    now: dict[str, Any],
    state: Any,
    choose: Callable[[Any], tuple[Mode, str]],
    impact: Callable[[Any], tuple[Any, dict[str, Any]]],
) -> tuple[Mode, Any]:
    """Impact where the state moves into the plane, then the mode rule, with the events of both."""
    pending: list[dict[str, Any]] = []

    def record(kind: str, **more: Any) -> None:
        pending.append({"kind": kind, **now, **dict(zip(STATE, state, strict=False)), **more})

    def collide(collision: bool) -> None:
        nonlocal state
        before = dict(zip(STATE[3:], state[3:], strict=False))
        state, more = impact(state)
        record("impact", before=before, collision=collision, **more)

    if state[4] < 0:
        collide(True)
    following: Mode = (FLIGHT, 0)
    if state[4] == 0:
        following, painleve = choose(state)
        if painleve:
            record(painleve)
        if following[0] == "impact":
            collide(False)
            following = (FLIGHT, 0) if state[4] > 0 else choose(state)[0]
    if not pending:
        kind = {ROLL: "stick", FLIGHT: "takeoff"}.get(following[0], "slip_reversal")
        record("start" if now["from"] == "start" else kind)
    events += [event | {"to": following[0]} for event in pending]
    return following, state
