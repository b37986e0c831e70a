"""The hybrid motion of the hoop in double precision: SciPy's DOP853 in the time domain, for any scenario.

The equations are those of :mod:`oracles.mechanics`. Events are bracketed on the dense output with several
sub-samples a step and extrema between them looked at, then settled by integrating again from the step's
beginning up to the root. Ties of the mode rule are decided by trying: the candidate motion is integrated for
a thousandth of √(R/g), and the signs of slip velocity and normal force there are read off. Impacts are
integrated numerically over the normal impulse.

It repeats the laws of impact on purpose and shares no code with hophoop.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.integrate import DOP853, solve_ivp
from scipy.optimize import brentq, minimize_scalar

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
TOLERANCES = {"rtol": 1e-13, "atol": 1e-15}
SUBSAMPLES = 16


@dataclass
class Piece:
    """One integrator step in one mode, with the state it began from."""

    mode: str
    start: float
    state: Vector


@dataclass
class Motion:
    """Pieces, events and losses of one motion; the state vector is (x, y, θ, ẋ, ẏ, θ̇, friction work)."""

    case: Case
    pieces: list[Piece] = field(default_factory=list)
    events: list[dict[str, Any]] = field(default_factory=list)
    sequence: str = ""
    status: str = "completed"
    end: float = 0.0
    loss_normal: float = 0.0
    loss_tangential: float = 0.0
    ledger: dict[str, float] = field(default_factory=dict)

    def at(self, t: float) -> dict[str, Any]:
        """State, mode and contact force at t (right limit at an event)."""
        piece = next(p for p in reversed(self.pieces) if p.start <= t)
        # the dense output is of lower order than the step, so the step is taken anew up to t
        state = advance(self.case, piece.mode, piece.state, t - piece.start)
        force = solve_mode(self.case, piece.mode, state[2], state[5])
        return {
            "t": t,
            "mode": piece.mode,
            **named(state),
            "friction": force[3],
            "normal": force[4],
            "work": state[6],
        }


def named(state: Vector) -> dict[str, float]:
    """Names for the six numbers of a state."""
    return dict(zip(STATE, map(float, state[:6]), strict=True))


def time_scale(case: Case) -> float:
    """√(R/g), or √(R / 1 m/s²) without gravity."""
    return math.sqrt(case.radius / (case.gravity or 1.0))


def slip_velocity(case: Case, state: Vector) -> float:
    """Velocity of the rim's lowest point along the plane."""
    return float(state[3] - case.radius * state[5])


def rates(case: Case, mode: str) -> Callable[[float, Vector], Vector]:
    """Right-hand side in a mode."""

    def right(_: float, state: Vector) -> Vector:
        solution = solve_mode(case, mode, state[2], state[5])
        power = -solution[3] * slip_velocity(case, state) if mode in DIRECTION else 0.0
        return np.array([*state[3:6], *solution[:3], power])

    return right


def advance(case: Case, mode: str, state: Vector, tau: float) -> Vector:
    """State a time τ later in one mode."""
    if tau == 0.0:
        return state
    return solve_ivp(rates(case, mode), (0.0, tau), state, method="DOP853", rtol=3e-14, atol=1e-15).y[:, -1]


def choose(case: Case, state: Vector) -> tuple[str, str]:
    """Mode that follows from contact at rest off the plane, and a Painlevé event if there is one."""
    tiny = 1e-9 * case.mass * (case.gravity or 1.0)
    probe = 1e-3 * time_scale(case)

    def decided(quantity: Callable[[Vector], float], mode: str, scale: float) -> float:
        now = quantity(state)
        return now if abs(now) > scale else quantity(advance(case, mode, state, probe))

    def normal(mode: str) -> Callable[[Vector], float]:
        return lambda s: float(solve_mode(case, mode, s[2], s[5])[4])

    vt = slip_velocity(case, state)
    if vt == 0.0:

        def margin(s: Vector) -> float:
            friction, pressure = solve_mode(case, ROLL, s[2], s[5])[3:]
            return float(case.mu_static * pressure - abs(friction))

        # rolling lasts only where it also can go on; equality with no motion away from it (μ = 0, F = 0) is
        # allowed
        if decided(normal(ROLL), ROLL, tiny) > 0 and decided(margin, ROLL, tiny) >= -1e-12 * tiny:
            return ROLL, ""
        for mode in (SPIN, SKID):
            if normal_response(case, state[2], DIRECTION[mode]) <= 0:
                continue
            later = advance(case, mode, state, probe)
            if decided(normal(mode), mode, tiny) > 0 and slip_velocity(case, later) * DIRECTION[mode] > 0:
                return mode, ""
        return FLIGHT, ""
    mode = SKID if vt > 0 else SPIN
    if normal_response(case, state[2], DIRECTION[mode]) > 0:
        return (mode if decided(normal(mode), mode, tiny) > 0 else FLIGHT), ""
    if free_normal_acceleration(case, state[2], state[5]) < 0:
        return "impact", "painleve_inconsistent"
    return ("impact" if case.painleve == "impact" else FLIGHT), "painleve_indeterminate"


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
    after = np.array([*state[:3], *s[:3], state[6]])
    return after, {
        "impulse": {"normal": p, "tangential": float(s[5])},
        "loss_normal": -float(s[3]),
        "loss_tangential": float(s[4]),
    }


def guards(case: Case, mode: str) -> dict[str, Callable[[Vector], float]]:
    """Functions that are positive while the mode lasts (turn and apex: cross zero)."""
    if mode == FLIGHT:
        return {"impact": lambda s: float(s[1]), "apex": lambda s: float(s[4])}
    both: dict[str, Callable[[Vector], float]] = {"turn": lambda s: float(s[5])}
    if mode == ROLL:

        def cone(sign: float) -> Callable[[Vector], float]:
            def margin(s: Vector) -> float:
                force = solve_mode(case, ROLL, s[2], s[5])
                return float(case.mu_static * force[4] - sign * force[3])

            return margin

        return {SPIN: cone(1.0), SKID: cone(-1.0), **both}
    return {
        "rest": lambda s: DIRECTION[mode] * slip_velocity(case, s),
        "takeoff": lambda s: float(solve_mode(case, mode, s[2], s[5])[4]),
        **both,
    }


def crossings(
    guard: Callable[[Vector], float],
    dense: Callable[[float], Vector],
    start: float,
    end: float,
    armed: bool,
    small: float,
) -> list[tuple[float, float]]:
    """Brackets in a step; a guard just handled (not armed) is zero at the start and must leave zero first."""
    times = np.linspace(start, end, SUBSAMPLES + 1)
    values = np.array([guard(dense(float(t))) for t in times])
    if not armed:
        first = next((i for i, v in enumerate(values) if abs(v) > small), len(values))
        times, values = times[first:], values[first:]
    found = []
    for i in range(len(values) - 1):
        if values[i] * values[i + 1] <= 0 and values[i] != 0:
            found.append((float(times[i]), float(times[i + 1])))
    for i in range(1, len(values) - 1):
        a, b, c = np.abs(values[i - 1 : i + 2])
        same = values[i - 1] * values[i] > 0 and values[i] * values[i + 1] > 0
        if same and b <= a and b <= c:
            sign = math.copysign(1.0, values[i])
            inside = minimize_scalar(
                lambda t, sign=sign: sign * guard(dense(t)),
                bounds=(times[i - 1], times[i + 1]),
                method="bounded",
            )
            if inside.fun < 0:
                found += [(float(times[i - 1]), float(inside.x)), (float(inside.x), float(times[i + 1]))]
    return sorted(found)


def solve(case: Case) -> Motion:
    """Solve a case until its duration or its number of events is reached."""
    motion = Motion(case)
    omega = case.vx / case.radius if case.rolling else case.omega
    vx = case.radius * omega if case.rolling else case.vx
    state = np.array([case.x, case.height, case.angle, vx, case.vy, omega, 0.0])
    origin = state.copy()
    t, mode = 0.0, FLIGHT
    if case.height > 0:
        motion.events.append({"t": t, "kind": "start", "from": "start", "to": FLIGHT, **named(state)})
    else:
        mode, state = settle(motion, t, state, "start", "")
    motion.sequence = mode
    small = {"impact": 1e-14 * case.radius}
    while t < case.duration and len(motion.events) <= case.max_events:
        tau, state, name = flow(motion, mode, t, state, small)
        t += tau
        if name == "":
            break
        if name in ("turn", "apex"):
            state[5 if name == "turn" else 4] = 0.0
            if name == "turn" and mode == ROLL:
                state[3] = 0.0
            motion.events.append({"t": t, "kind": name, "from": mode, "to": mode, **named(state), "work": state[6]})
            continue
        if name == "impact":
            state[1] = 0.0
        elif mode != FLIGHT:
            state[1] = state[4] = 0.0
        forced = FLIGHT if name == "takeoff" else ""
        if name in DIRECTION:
            forced = FLIGHT if free_normal_acceleration(case, state[2], state[5]) >= 0 else name
        if name == "rest":
            state[3] = case.radius * state[5]
        mode, state = settle(motion, t, state, mode, forced)
        motion.sequence += mode
    if t < case.duration:
        motion.status = "event_limit"
    motion.end = t
    motion.events.append({"t": t, "kind": "end", "from": mode, "to": mode, **named(state), "work": state[6]})
    energies = [(kinetic_energy(case, s[2], s[3:6]), potential_energy(case, s[0], s[1], s[2])) for s in (origin, state)]
    lost = state[6] + motion.loss_normal + motion.loss_tangential
    motion.ledger = {
        "kinetic": energies[1][0],
        "potential": energies[1][1],
        "friction": float(state[6]),
        "impact_normal": motion.loss_normal,
        "impact_tangential": motion.loss_tangential,
        "residual": sum(energies[1]) + lost - sum(energies[0]),
    }
    return motion


def flow(motion: Motion, mode: str, t: float, state: Vector, small: dict[str, float]) -> tuple[float, Vector, str]:
    """Integrate in one mode to its next event: time taken, state there, name ('' at the end)."""
    case, start = motion.case, t
    remaining = case.duration - t
    solver = DOP853(rates(case, mode), 0.0, state, remaining, max_step=0.2 * time_scale(case), **TOLERANCES)
    tests = guards(case, mode)
    armed = {name: abs(guard(state)) > small.get(name, 1e-11) for name, guard in tests.items()}
    while solver.status == "running":
        begin = solver.y.copy()
        solver.step()
        if solver.status == "failed":
            raise RuntimeError(f"{case.name}: the integrator failed at t = {start + solver.t}")
        dense, left, right = solver.dense_output(), solver.t_old, solver.t
        roots = []
        for name, guard in tests.items():
            scale = small.get(name, 1e-11)
            for a, b in crossings(guard, dense, left, right, armed[name], scale):
                falling = guard(dense(a)) > guard(dense(b))
                if falling or name == "turn":
                    roots.append((polish(case, mode, begin, left, guard, dense, a, b), name))
            armed[name] = armed[name] or abs(guard(solver.y)) > scale
        motion.pieces.append(Piece(mode, start + left, begin))
        if roots:
            tau, name = min(roots)
            return tau, advance(case, mode, begin, tau - left), name
    return remaining, solver.y.copy(), ""


def polish(
    case: Case,
    mode: str,
    begin: Vector,
    left: float,
    guard: Callable[[Vector], float],
    dense: Callable[[float], Vector],
    a: float,
    b: float,
) -> float:
    """Root of a guard in [a, b]: first on the dense output, then on the motion integrated anew."""
    rough = float(brentq(lambda t: guard(dense(t)), a, b, xtol=1e-14))

    def exact(t: float) -> float:
        return guard(advance(case, mode, begin, t - left))

    width = 1e-9 * time_scale(case)
    low, high = max(left, rough - width), rough + width
    while exact(low) * exact(high) > 0:
        width *= 4.0
        low, high = max(left, rough - width), rough + width
        if width > b - left + time_scale(case):
            return rough
    return float(brentq(exact, low, high, xtol=1e-16))


def settle(motion: Motion, t: float, state: Vector, mode: str, forced: str) -> tuple[str, Vector]:
    """Impact where the state moves into the plane, then the mode rule, with the events of both."""
    case = motion.case

    def record(kind: str, new: str, **more: Any) -> dict[str, Any]:
        event = {
            "t": t,
            "kind": kind,
            "from": mode,
            "to": new,
            **named(state),
            "work": float(state[6]),
            **more,
        }
        motion.events.append(event)
        return event

    def collide(collision: bool) -> dict[str, Any]:
        nonlocal state
        before = {"vx": float(state[3]), "vy": float(state[4]), "omega": float(state[5])}
        state, more = impact(case, state)
        motion.loss_normal += more["loss_normal"]
        motion.loss_tangential += more["loss_tangential"]
        return record("impact", FLIGHT, before=before, collision=collision, **more)

    if forced:
        record("takeoff" if forced == FLIGHT else "slip_start", forced)
        return forced, state
    pending = []
    if state[4] < 0:
        pending.append(collide(True))
    following = FLIGHT
    if state[4] == 0:
        following, painleve = choose(case, state)
        if painleve:
            pending.append(record(painleve, following))
        if following == "impact":
            pending.append(collide(False))
            following = FLIGHT if state[4] > 0 else choose(case, state)[0]
    for event in pending:
        event["to"] = following
    if not pending:
        kind = {ROLL: "stick", FLIGHT: "takeoff"}.get(following, "slip_reversal")
        record("start" if mode == "start" else kind, following)
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
    start = np.array([*state, t])
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
