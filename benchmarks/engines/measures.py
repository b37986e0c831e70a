"""Measures of a record, the same for the truth and every engine: phases, take-off, hop, landing, energies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from phases import FREE, SHORT, Phase, normal_force, phases
from record import thin
from task import Floats, States, Task

BACK = 0.010  # s of contact before a take-off, for its time
BEFORE, AFTER = 0.005, 0.020  # s around a landing


@dataclass(frozen=True)
class Measures:
    """Measures of a record; None if the motion has no such quantity."""

    sequence: str  # letters of the phases of at least 20 ms
    chatter: int  # removed runs below 20 ms
    takeoff_time: float | None  # s: zero of N before the highest flight; None if the record starts in flight
    takeoff_angle: float | None  # rad
    hop_height: float | None  # m: maximum gap from take-off to landing, minus the gap at take-off
    landing_time: float | None  # s: first landing of that flight, or of the one in which the record starts
    landing_angle: float | None  # rad
    slip_loss: float  # J: energy lost up to that take-off or landing, or to the end without one
    impact_loss: float | None  # J: energy lost from 5 ms before to 20 ms after that landing
    total_loss: float  # J: energy lost from the start to the end
    penetration: float  # m: maximum depth of the rim in the plane


def energy(task: Task, states: States) -> Floats:
    """Return the sum of kinetic and potential energy [J]."""
    sine, cosine = np.sin(states.angle), np.cos(states.angle)
    vx, vy = states.vx + task.arm * states.omega * cosine, states.vy - task.arm * states.omega * sine
    along, off = task.pull
    work = along * (states.x + task.arm * sine) + off * (states.y + task.arm * cosine)
    return 0.5 * task.mass * (vx**2 + vy**2) + 0.5 * task.inertia * states.omega**2 - task.mass * work


def interpolate(t: Floats, value: Floats, rate: Floats, when: float) -> float:
    """Interpolate a quantity between two states by the cubic Hermite polynomial, from its values and rates."""
    k = int(np.clip(np.searchsorted(t, when) - 1, 0, len(t) - 2))
    step = t[k + 1] - t[k]
    s = (when - t[k]) / step
    a, b = value[k], value[k + 1]
    first, second = step * rate[k], step * rate[k + 1]
    return float(a * (1 + 2 * s) * (1 - s) ** 2 + first * s * (1 - s) ** 2 + b * s * s * (3 - 2 * s) + second * s * s * (s - 1))


def takeoff_time(task: Task, states: States, flight: Phase) -> float:
    """Return the time when N fell to zero before a flight [s].

    It is the root of a parabola through N over the last 10 ms of contact, or the start of the flight if N scatters too much.
    """
    middle, force = normal_force(task, states)
    found = flight.begin
    step = float(np.median(np.diff(states.t)))
    for _ in range(4):
        near = (middle > found - max(BACK, 4.5 * step)) & (middle < found - 0.5 * step)
        if near.sum() < 3:
            return flight.begin
        shape = np.polynomial.Polynomial.fit(middle[near], force[near], 2 if near.sum() >= 6 else 1)
        scatter = float(np.sqrt(np.mean((shape(middle[near]) - force[near]) ** 2)))
        roots = [float(root.real) for root in shape.roots() if abs(root.imag) < 1e-9]
        close = [root for root in roots if abs(root - flight.begin) < max(0.02, 2.0 * step)]
        if scatter > 2.0 * FREE * task.mass * task.gravity or not close:
            return flight.begin
        found = min(close, key=lambda root: abs(root - flight.begin))
    return found


def find_landing(task: Task, states: States, flight: Phase, level: float) -> tuple[float, float] | None:
    """Return time [s] and angle [rad] where a flight comes down to the level [m], None without a landing.

    It is where the force exceeds m g/2, after half of the maximum height, extrapolated to the level.
    """
    t, y = states.t, states.y - level
    middle, force = normal_force(task, states)
    inside = np.flatnonzero((t >= flight.begin) & (t <= flight.end))
    high = t[inside[int(np.argmax(y[inside] >= 0.5 * y[inside].max()))]]
    struck = np.flatnonzero((middle > max(high, flight.begin + 0.5 * SHORT)) & (force > 0.5 * task.mass * task.gravity))
    if not struck.size:
        return None
    # the state before the impact is in flight: extrapolate forwards, or backwards if the rim is below the level
    k = int(struck[0])
    fall = states.vy[k]
    pull = (states.vy[k] - states.vy[k - 1]) / (t[k] - t[k - 1]) if k else task.pull[1]
    root = fall * fall - 2.0 * pull * y[k]
    step, tau = t[k + 1] - t[k], 0.0
    if root > 0.0 and fall < 0.0:
        tau = float(np.clip(2.0 * y[k] / (np.sqrt(root) - fall), -2.0 * step, step))
    return float(t[k] + tau), float(states.angle[k] + tau * states.omega[k])


def measure(task: Task, record: States) -> Measures:
    """Measure a record."""
    states = thin(record)
    t = states.t
    pieces, chatter = phases(task, states)
    total = energy(task, states)
    place = _measured_flight(task, states, pieces)
    falls = place == 0 and task.height > 0.0  # the motion starts in flight, without a take-off
    lift = angle = height = landing = landing_angle = blow = None
    until = float(t[-1])
    if place is not None:
        flight = pieces[place]
        level = 0.0
        if not falls:
            lift = until = takeoff_time(task, states, flight)
            angle = interpolate(t, states.angle, states.omega, lift)
            level = interpolate(t, states.y, states.vy, lift)
        landed = find_landing(task, states, flight, level)
        if landed is not None:
            landing, landing_angle = landed
            until = landing if falls else until
            step = float(np.median(np.diff(t)))
            around = landing - max(BEFORE, 1.5 * step), landing + max(AFTER, 1.5 * step)
            blow = float(np.interp(around[0], t, total) - np.interp(around[1], t, total))
        if lift is not None:
            inside = (t >= lift) & (t <= (t[-1] if landing is None else landing))
            height = float(states.y[inside].max() - level) if inside.any() else 0.0
    last = until - BEFORE if falls else until
    return Measures(
        sequence="".join(piece.letter for piece in pieces),
        chatter=chatter,
        takeoff_time=lift,
        takeoff_angle=angle,
        hop_height=height,
        landing_time=landing,
        landing_angle=landing_angle,
        slip_loss=float(total[0] - np.interp(max(last, 0.0), t, total)),
        impact_loss=blow,
        total_loss=float(total[0] - np.interp(task.duration, t, total)),
        penetration=float(max(0.0, -states.y.min())),
    )


def _measured_flight(task: Task, states: States, pieces: list[Phase]) -> int | None:
    """Return the index of the measured flight: that of the start, otherwise the highest."""
    tops = {
        k: float(states.y[(states.t >= piece.begin) & (states.t <= piece.end)].max())
        for k, piece in enumerate(pieces)
        if piece.letter == "H"
    }
    if not tops:
        return None
    return 0 if 0 in tops and task.height > 0.0 else max(tops, key=tops.__getitem__)
