"""The hybrid motion of the hoop in double precision: SciPy's DOP853 in the time domain, for any scenario.

The equations are those of :mod:`oracles.mechanics`. Steps are so short that the dense output is as good as they are, and
SciPy finds the events on it. After an event every mode that the velocities allow is tried, and the first whose signs come out
right is taken; a sign that is zero is that of a thousandth of √(R/g) later. Impacts are integrated over the normal impulse.

It repeats the laws of impact on purpose and shares no code with hophoop.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from .cases import Case
from .mechanics import (
    DIRECTION,
    FLIGHT,
    ROLL,
    SKID,
    SPIN,
    Vector,
    applied_forces,
    contact_jacobian,
    free_normal_acceleration,
    kinetic_energy,
    mass_matrix,
    normal_response,
    potential_energy,
    solve_mode,
)

STATE = ("x", "height", "angle", "vx", "vy", "omega")
EXACT = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}
Mode = tuple[str, int]  # what the rim does, and which way the hoop turns against rolling resistance


@dataclass
class Motion:
    """Pieces, events and losses of one motion; the state is (x, y, θ, ẋ, ẏ, θ̇, friction work, rolling work)."""

    case: Case
    pieces: list[tuple[float, Any, str]] = field(default_factory=list)
    events: list[dict[str, Any]] = field(default_factory=list)
    sequence: str = ""
    status: str = "completed"
    end: float = 0.0
    loss_normal: float = 0.0
    loss_tangential: float = 0.0
    residual: float = 0.0

    def at(self, t: float) -> dict[str, Any]:
        """State and mode at t (right limit at an event)."""
        start, dense, mode = next(piece for piece in reversed(self.pieces) if piece[0] <= t)
        return {"t": t, "mode": mode, **named(dense(t - start))}


def named(state: Vector) -> dict[str, float]:
    """Names for the numbers of a state."""
    return dict(zip((*STATE, "work", "rolling"), map(float, state), strict=True))


def time_scale(case: Case) -> float:
    """√(R/g), or √(R / 1 m/s²) without gravity."""
    return math.sqrt(case.radius / (case.gravity or 1.0))


def slip_velocity(case: Case, state: Vector) -> float:
    """Velocity of the rim's lowest point along the plane."""
    return float(state[3] - case.radius * state[5])


def rates(case: Case, mode: Mode) -> Callable[[float, Vector], Vector]:
    """Right-hand side in a mode."""

    def right(_: float, state: Vector) -> Vector:
        found = solve_mode(case, mode[0], state[2], state[5], mode[1])
        power = -found[3] * slip_velocity(case, state) if mode[0] in DIRECTION else 0.0
        return np.array([*state[3:6], *found[:3], power, -found[5] * state[5]])

    return right


def advance(case: Case, mode: Mode, state: Vector, tau: float) -> Vector:
    """State a time τ later in one mode."""
    return solve_ivp(rates(case, mode), (0.0, tau), state, **EXACT).y[:, -1]


def choose(case: Case, state: Vector) -> tuple[Mode, str]:
    """Mode that follows from contact at rest off the plane, and a Painlevé event if there is one."""
    vt, omega = slip_velocity(case, state), state[5]
    ways = [0]
    if case.rolling_resistance:
        ways = [0, 1, -1] if omega == 0.0 else [1 if omega > 0.0 else -1]
    contacts = (ROLL, SPIN, SKID)
    if vt != 0.0:
        contact = SKID if vt > 0.0 else SPIN
        contacts = (contact,)
        if normal_response(case, state[2], DIRECTION[contact], ways[0]) <= 0.0:
            if free_normal_acceleration(case, state[2], omega) < 0.0:
                return ("impact", 0), "painleve_inconsistent"
            return ("impact" if case.painleve == "impact" else FLIGHT, 0), "painleve_indeterminate"
    for contact in contacts:
        for way in ways:
            responds = contact == ROLL or normal_response(case, state[2], DIRECTION[contact], way) > 0.0
            if responds and holds(case, (contact, way), state):
                return (contact, way), ""
    return (FLIGHT, 0), ""


def holds(case: Case, mode: Mode, state: Vector) -> bool:
    """Whether the signs come out right in a mode, now and a moment later."""
    contact, way = mode
    tiny = 1e-9 * case.mass * (case.gravity or 1.0)
    later = advance(case, mode, state, 1e-3 * time_scale(case))
    now, then = (solve_mode(case, contact, s[2], s[5], way) for s in (state, later))

    def decided(quantity: Callable[[Vector], float]) -> float:
        return float(quantity(now if abs(quantity(now)) > tiny else then))

    right = decided(lambda f: f[4]) > 0.0
    if contact == ROLL:
        # equality with no motion away from it (μ = 0, F = 0) is allowed
        right &= decided(lambda f: case.mu_static * f[4] - abs(f[3])) >= -1e-12 * tiny
    elif slip_velocity(case, state) == 0.0:
        right &= slip_velocity(case, later) * DIRECTION[contact] > 0.0
    if case.rolling_resistance and state[5] == 0.0:
        most = case.rolling_resistance * case.radius
        right &= later[5] * way > 0.0 if way else abs(now[5]) <= most * now[4]
    return bool(right)


def impact(case: Case, state: Vector) -> tuple[Vector, dict[str, Any]]:
    """State after an impact, integrated over the normal impulse p; what it took and what was lost."""
    jacobian, mass = contact_jacobian(case), mass_matrix(case, state[2])
    e, approach = case.restitution, float(state[4])
    # per unit normal impulse at a ratio r of tangential to normal impulse
    response = np.linalg.solve(mass, jacobian.T)
    delassus = jacobian @ response
    hold = -delassus[0, 1] / delassus[0, 0]
    horizon = 1e3 * case.mass * (abs(approach) + abs(slip_velocity(case, state)) + 1e-300)

    def right(_: float, s: Vector, ratio: float) -> Vector:
        velocity = s[:3]
        slip, separation = jacobian @ velocity
        return np.array([*(response @ np.array([ratio, 1.0])), separation, -ratio * slip, ratio])

    # s = (ẋ, ẏ, θ̇, ∫v_n dp, tangential loss, ∫ratio dp)
    s, p = np.array([*state[3:6], 0.0, 0.0, 0.0]), 0.0
    vt = slip_velocity(case, state)
    sliding = vt != 0.0
    direction = math.copysign(1.0, vt) if sliding else math.copysign(1.0, delassus[0, 1])
    stuck = False
    if not sliding:
        stuck = abs(hold) <= case.mu_static
    compression_impulse = compression_work = math.nan
    while True:
        ratio = hold if stuck else -direction * case.mu_kinetic

        def slip_stops(_: float, s: Vector, ratio: float) -> float:
            return float(jacobian[0] @ s[:3])

        if math.isnan(compression_impulse):

            def done(p: float, s: Vector, ratio: float) -> float:
                return float(s[1])

            done.direction = 1.0  # type: ignore[attr-defined]
        elif case.impact_law == "newton":

            def done(p: float, s: Vector, ratio: float) -> float:
                return float(s[1] + e * approach)
        elif case.impact_law == "poisson":

            def done(p: float, s: Vector, ratio: float, until: float = (1 + e) * compression_impulse) -> float:
                return p - until
        else:

            def done(p: float, s: Vector, ratio: float, gain: float = (1 - e**2) * compression_work) -> float:
                return float(s[3] - gain)

        done.terminal = slip_stops.terminal = True  # type: ignore[attr-defined]
        events = [done, slip_stops] if sliding else [done]
        run = solve_ivp(right, (p, p + horizon), s, "DOP853", events=events, args=(ratio,), rtol=1e-13, atol=1e-15)
        if run.status != 1:
            raise RuntimeError("the impact never ends")
        p, s = float(run.t[-1]), run.y[:, -1]
        if sliding and len(run.t_events[1]):
            s[0] = case.radius * s[2]
            sliding, stuck = False, abs(hold) <= case.mu_static
            direction = math.copysign(1.0, delassus[0, 1])
            continue
        if not math.isnan(compression_impulse):
            break
        s[1], compression_impulse, compression_work = 0.0, p, float(s[3])
        if e == 0.0 or (case.impact_law == "newton" and approach == 0.0):
            break
    if stuck:
        s[0] = case.radius * s[2]
    after = np.array([*state[:3], *s[:3], *state[6:]])
    return after, {
        "impulse": {"normal": p, "tangential": float(s[5])},
        "loss_normal": -float(s[3]),
        "loss_tangential": float(s[4]),
    }


def guards(case: Case, mode: Mode) -> Iterator[tuple[str, Callable[[float, Vector], float]]]:
    """Functions that are positive while the mode lasts; of a turn and an apex, which change no mode, the sign changes."""
    contact, way = mode

    def force(s: Vector) -> Vector:
        return solve_mode(case, contact, s[2], s[5], way)

    def lasts(guard: Callable[[Vector], float]) -> Callable[[float, Vector], float]:
        def test(tau: float, s: Vector) -> float:
            return guard(s) if tau > 0.0 else 1.0  # it is zero where the last event was its own

        test.terminal, test.direction = True, -1.0  # type: ignore[attr-defined]
        return test

    def mark(guard: Callable[[Vector], float], direction: float) -> Callable[[float, Vector], float]:
        def test(_: float, s: Vector) -> float:
            return guard(s)

        test.direction = direction  # type: ignore[attr-defined]
        return test

    if contact == FLIGHT:
        yield "impact", lasts(lambda s: s[1])
        yield "apex", mark(lambda s: s[4], -1.0)
        return
    if way:
        yield "turn", lasts(lambda s: way * s[5])
    elif not case.rolling_resistance:
        yield "turn", mark(lambda s: s[5], 0.0)
    if contact == ROLL:
        yield SPIN, lasts(lambda s: case.mu_static * force(s)[4] - force(s)[3])
        yield SKID, lasts(lambda s: case.mu_static * force(s)[4] + force(s)[3])
    else:
        yield "rest", lasts(lambda s: DIRECTION[contact] * slip_velocity(case, s))
        yield "takeoff", lasts(lambda s: force(s)[4])


def solve(case: Case) -> Motion:
    """Solve a case until its duration or its number of events is reached, or until it rests for good."""
    motion = Motion(case)
    omega = case.vx / case.radius if case.rolling else case.omega
    vx = case.radius * omega if case.rolling else case.vx
    state = np.array([case.x, case.height, case.angle, vx, case.vy, omega, 0.0, 0.0])
    origin = state.copy()
    t, mode = 0.0, (FLIGHT, 0)
    if case.height > 0:
        motion.events.append({"t": t, "kind": "start", "from": "start", "to": FLIGHT, **named(state)})
    else:
        mode, state = settle(motion, t, state, "start")
    motion.sequence = mode[0]
    while t < case.duration and len(motion.events) <= case.max_events:
        if mode == (ROLL, 0) and case.rolling_resistance:
            motion.status = "at_rest"
            break
        names, tests = zip(*guards(case, mode), strict=True)
        run = solve_ivp(
            rates(case, mode), (0.0, case.duration - t), state, events=tests, dense_output=True,
            max_step=0.03 * time_scale(case), **EXACT,
        )  # fmt: skip
        motion.pieces.append((t, run.sol, mode[0]))
        found = [(float(tau), name) for name, times in zip(names, run.t_events, strict=True) for tau in times if tau > 0.0]
        for tau, name in sorted(found):
            state = run.sol(tau)
            if name in ("turn", "apex"):
                state[5 if name == "turn" else 4] = 0.0
                if name == "turn" and mode[0] == ROLL:
                    state[3] = 0.0
                motion.events.append({"t": t + tau, "kind": name, "from": mode[0], "to": mode[0], **named(state)})
        state = run.y[:, -1].copy()
        t += float(run.t[-1])
        if run.status != 1:
            break
        name = max(found)[1]
        if name == "impact":
            state[1] = 0.0
        elif mode[0] != FLIGHT:
            state[1] = state[4] = 0.0
        if name == "turn":
            state[5] = 0.0
        if name == "rest" or mode[0] == ROLL:
            state[3] = case.radius * state[5]
        forced = FLIGHT if name == "takeoff" else ""
        if name in DIRECTION:
            forced = FLIGHT if free_normal_acceleration(case, state[2], state[5]) >= 0 else name
        before = mode[0]
        if name == "turn":
            mode, _ = choose(case, state)
            motion.events[-1] |= {"to": mode[0], "kind": "rest" if mode == (ROLL, 0) else "turn"}
        elif forced:
            motion.events.append(
                {"t": t, "kind": "takeoff" if forced == FLIGHT else "slip_start", "from": before, "to": forced, **named(state)}
            )
            mode = forced, 0 if forced == FLIGHT else mode[1]
        else:
            mode, state = settle(motion, t, state, before)
        if name != "turn" or mode[0] != before:
            motion.sequence += mode[0]
    if t < case.duration and motion.status == "completed":
        motion.status = "event_limit"
    motion.end = t
    motion.events.append({"t": t, "kind": "end", "from": mode[0], "to": mode[0], **named(state)})
    energies = [kinetic_energy(case, s[2], s[3:6]) + potential_energy(case, s[0], s[1], s[2]) for s in (origin, state)]
    motion.residual = energies[1] + float(state[6] + state[7]) + motion.loss_normal + motion.loss_tangential - energies[0]
    return motion


def settle(motion: Motion, t: float, state: Vector, mode: str) -> tuple[Mode, Vector]:
    """Impact where the state moves into the plane, then the mode rule, with the events of both."""
    case = motion.case
    pending: list[dict[str, Any]] = []

    def record(kind: str, **more: Any) -> None:
        pending.append({"t": t, "kind": kind, "from": mode, **named(state), **more})

    def collide(collision: bool) -> None:
        nonlocal state
        before = {"vx": float(state[3]), "vy": float(state[4]), "omega": float(state[5])}
        state, more = impact(case, state)
        motion.loss_normal += more["loss_normal"]
        motion.loss_tangential += more["loss_tangential"]
        record("impact", before=before, collision=collision, **more)

    if state[4] < 0:
        collide(True)
    following: Mode = (FLIGHT, 0)
    if state[4] == 0:
        following, painleve = choose(case, state)
        if painleve:
            record(painleve)
        if following[0] == "impact":
            collide(False)
            following = (FLIGHT, 0) if state[4] > 0 else choose(case, state)[0]
    if not pending:
        kind = {ROLL: "stick", FLIGHT: "takeoff"}.get(following[0], "slip_reversal")
        record("start" if mode == "start" else kind)
    motion.events += [event | {"to": following[0]} for event in pending]
    return following, state


def slip_over_impulse(case: Case, mode: str, t: float, state: Vector) -> tuple[float, Vector]:
    """Time and state where slip from `state` stops or the rotation turns, integrated over the normal impulse.

    With dp = N dt the rates are finite however large N becomes: 1/N, the time per unit impulse, goes to zero
    together with the response off the plane. So this passes where an integration over time cannot.
    """
    jacobian, sigma = contact_jacobian(case), DIRECTION[mode]

    def right(_: float, s: Vector) -> Vector:
        angle, omega = s[2], s[5]
        mass = mass_matrix(case, angle)
        push = np.linalg.solve(mass, jacobian[1] - sigma * case.mu_kinetic * jacobian[0])
        free = np.linalg.solve(mass, applied_forces(case, angle, omega))
        time = -push[1] / free[1]
        rate = push + time * free
        rate[1] = 0.0
        loss = sigma * case.mu_kinetic * slip_velocity(case, s)
        return np.array([s[3] * time, 0.0, omega * time, *rate, loss, time])

    def stops(_: float, s: Vector) -> float:
        return slip_velocity(case, s)

    def turns(_: float, s: Vector) -> float:
        return float(s[5])

    stops.terminal = turns.terminal = True  # type: ignore[attr-defined]
    start = np.array([*state[:7], t])
    # a bound on the impulse: what would stop the whole body many times over
    horizon = 1e3 * case.mass * (abs(slip_velocity(case, state)) + case.radius * abs(state[5]))
    run = solve_ivp(
        right,
        (0.0, horizon),
        start,
        "DOP853",
        events=[stops, turns],
        max_step=horizon,
        rtol=3e-14,
        atol=1e-15,
    )
    if run.status != 1:
        raise RuntimeError("the slip neither stops nor turns")
    return float(run.y[7, -1]), run.y[:7, -1]
