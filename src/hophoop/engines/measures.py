"""Measures of a record, the same for the truth and every engine: phases, take-off, hop, landing, energies."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from hophoop.engines.phases import FREE, SHORT, Phase, normal_force, phases, slip_velocity, thin
from hophoop.engines.scenarios import BenchScenario
from hophoop.engines.task import SPACING, Floats, States, Task, task_of
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.energy import kinetic_energies, potential_energies

BACK = 0.010  # s of contact before a take-off, for its time
BEFORE, AFTER = 0.005, 0.020  # s around a landing


@dataclass(frozen=True)
class Measures:
    """Measures of a record; None if the motion has no such quantity.

    Attributes
    ----------
    sequence : str
        Letters of the phases of at least 20 ms.
    chatter : int
        Number of removed runs below 20 ms.
    takeoff_time, takeoff_angle : float or None
        Zero of N before the highest flight; None if the record starts in flight [s], [rad].
    hop_height : float or None
        Maximum gap from take-off to landing, minus the gap at take-off [m].
    landing_time, landing_angle : float or None
        First landing of that flight, or of the one in which the record starts [s], [rad].
    slip_loss : float
        Energy lost up to that take-off or landing, or to the end without one [J].
    impact_loss : float or None
        Energy lost from 5 ms before to 20 ms after that landing [J].
    total_loss : float
        Energy lost from the start to the end [J].
    penetration : float
        Maximum depth of the rim in the plane [m].
    """

    sequence: str
    chatter: int
    takeoff_time: float | None
    takeoff_angle: float | None
    hop_height: float | None
    landing_time: float | None
    landing_angle: float | None
    slip_loss: float
    impact_loss: float | None
    total_loss: float
    penetration: float

    def to_dict(self) -> dict[str, Any]:
        """Return the measures by name.

        Returns
        -------
        measures : dict
        """
        return asdict(self)


def energy(task: Task, states: States) -> Floats:
    """Return the sum of kinetic and potential energy.

    Parameters
    ----------
    task : Task
    states : States

    Returns
    -------
    energy : ndarray
        [J].
    """
    along, off = task.pull
    size = task.radius
    kappa = task.inertia / (task.mass * size**2)
    # lengths in radii, times in seconds
    body = Body(
        eps=task.arm / size,
        kap=kappa,
        mu_s=task.mu,
        mu_k=task.mu,
        gn=-off / size,
        gt=along / size,
        rest=task.restitution,
        law=0,
        strike=False,
        slope=task.slope,
    )
    slip = slip_velocity(task, states) / size
    kinetic = kinetic_energies(body, states.angle, states.omega, slip, states.vy / size)
    result: Floats = kinetic + potential_energies(body, states.x / size, states.y / size, states.angle)
    return task.mass * size**2 * result


def interpolate(t: Floats, value: Floats, rate: Floats, when: float) -> float:
    """Interpolate a quantity between two states by the cubic Hermite polynomial.

    Parameters
    ----------
    t, value, rate : ndarray
        [s], any unit, and that unit per second [1].
    when : float
        [s].

    Returns
    -------
    value : float
        [1].
    """
    k = int(np.clip(np.searchsorted(t, when) - 1, 0, len(t) - 2))
    step = t[k + 1] - t[k]
    s = (when - t[k]) / step
    a, b = value[k], value[k + 1]
    first, second = step * rate[k], step * rate[k + 1]
    return float(a * (1 + 2 * s) * (1 - s) ** 2 + first * s * (1 - s) ** 2 + b * s * s * (3 - 2 * s) + second * s * s * (s - 1))


def takeoff_time(task: Task, states: States, flight: Phase) -> float:
    """Return the time when N fell to zero before a flight: the root of a parabola through N over the last 10 ms of contact.

    Parameters
    ----------
    task : Task
    states : States
    flight : Phase

    Returns
    -------
    t : float
        The start of the flight if N scatters too much for a parabola [s].
    """
    middle, force = normal_force(task, states)
    weight = task.mass * task.gravity
    found = flight.begin
    step = float(np.median(np.diff(states.t)))
    for _ in range(4):
        near = (middle > found - max(BACK, 4.5 * step)) & (middle < found - 0.5 * step)
        order = 2 if near.sum() >= 6 else 1
        if near.sum() < 3:
            return flight.begin
        shape = np.polynomial.Polynomial.fit(middle[near], force[near], order)
        scatter = float(np.sqrt(np.mean((shape(middle[near]) - force[near]) ** 2)))
        roots = [float(root.real) for root in shape.roots() if abs(root.imag) < 1e-9]
        close = [root for root in roots if abs(root - flight.begin) < max(0.02, 2.0 * step)]
        if scatter > 2.0 * FREE * weight or not close:
            return flight.begin
        found = min(close, key=lambda root: abs(root - flight.begin))
    return found


def _flight(task: Task, states: States, pieces: list[Phase]) -> int | None:
    """Return the measured flight: that of the start, otherwise the highest."""
    tops = {
        k: float(states.y[(states.t >= piece.begin) & (states.t <= piece.end)].max())
        for k, piece in enumerate(pieces)
        if piece.letter == "H"
    }
    if not tops:
        return None
    return 0 if 0 in tops and task.height > 0.0 else max(tops, key=tops.__getitem__)


def find_landing(task: Task, states: States, flight: Phase, level: float) -> tuple[float, float] | None:
    """Find the landing of a flight: a force above m g/2, extrapolated to the level.

    The search starts at half of the maximum height, after the take-off.

    Parameters
    ----------
    task : Task
    states : States
    flight : Phase
    level : float
        Gap at the start of the flight, or 0 [m].

    Returns
    -------
    landing : (float, float) or None
        Time [s] and angle [rad]; None without a landing.
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
    """Measure a record.

    Parameters
    ----------
    task : Task
    record : States

    Returns
    -------
    measures : Measures

    Raises
    ------
    ValueError
        If the record is invalid: see `thin`.
    """
    states = thin(record)
    t = states.t
    pieces, chatter = phases(task, states)
    total = energy(task, states)
    place = _flight(task, states, pieces)
    falls = place == 0 and task.height > 0.0  # the motion starts in flight, without a take-off
    lift = angle = height = landing = landing_angle = blow = None
    until = float(t[-1])
    if place is not None:
        flight = pieces[place]
        level = 0.0
        if not falls:
            lift = takeoff_time(task, states, flight)
            angle = interpolate(t, states.angle, states.omega, lift)
            level = interpolate(t, states.y, states.vy, lift)
            until = lift
        landed = find_landing(task, states, flight, level)
        if landed is not None:
            down, landing_angle = landed
            landing = down
            until = down if falls else until
            step = float(np.median(np.diff(t)))
            blow = float(
                np.interp(down - max(BEFORE, 1.5 * step), t, total) - np.interp(down + max(AFTER, 1.5 * step), t, total)
            )
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


def exact_record(bench: BenchScenario, spacing: float = SPACING) -> States:
    """Return the exact motion of a scenario, sampled like the record of an engine.

    Parameters
    ----------
    bench : BenchScenario
    spacing : float
        Time between two states [s].

    Returns
    -------
    record : States
    """
    from hophoop.simulation.simulate import simulate

    motion = simulate(bench.scenario)
    t = np.arange(0.0, motion.duration + 0.5 * spacing, spacing)
    sample = motion.at(np.minimum(t, motion.duration))
    return States(t, sample.x, sample.height, sample.angle, sample.vx, sample.vy, sample.omega)


def measures_of_truth(bench: BenchScenario, entry: dict[str, Any]) -> dict[str, Any]:
    """Return the measures of the exact motion, with its exact events.

    Parameters
    ----------
    bench : BenchScenario
    entry : dict
        Entry of the truth, with its events.

    Returns
    -------
    measures : dict
        Fields of `Measures`, and `lossless_until`, the time from the start without loss of energy [s].

    Raises
    ------
    ValueError
        If the rule and the events disagree.
    """
    found = measure(task_of(bench), exact_record(bench)).to_dict()
    events = entry["events"]
    lift = next((event for event in events if event["kind"] == "takeoff"), None)
    land = next((event for event in events if event["kind"] == "impact" and event["from"] == "H"), None)
    top = next((event for event in events if event["kind"] == "apex"), None)
    exact = {
        "takeoff_time": float(lift["t"]) if lift else None,
        "takeoff_angle": float(lift["angle"]) if lift else None,
        "hop_height": float(top["y"]) if lift and top else None,
        "landing_time": float(land["t"]) if land else None,
        "landing_angle": float(land["angle"]) if land else None,
    }
    for name, value in exact.items():
        other = found[name]
        same = value == other if value is None or other is None else abs(value - other) < 1e-3
        if bench.scored and not same:
            raise ValueError(f"{bench.name}: {name} = {other!r} by the rule, {value!r} by the events.")
    losing = [event for event in events if event["to"] in ("S", "K") or event["kind"] == "impact"]
    found |= exact | {"penetration": 0.0}
    found["lossless_until"] = float(losing[0]["t"]) if losing else bench.scenario.duration
    return found
