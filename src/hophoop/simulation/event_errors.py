"""Error estimates of events: rounding at every event, amplified by the sensitivity of the motion after it.

The motion is computed again from each event with a small change of θ, θ̇, v_t, v_n, the height or friction. The shift of the
later events gives their sensitivity, by which the rounding of the event is multiplied. The contributions of all events add up
in squares. Rounding inside a phase is attributed to the event at its start.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from hophoop._support.errors import InputError
from hophoop._support.progress import compute_reporting
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.physics.body import Body, Event, Mode, Status
from hophoop.kernel.physics.contact import resistance_arm, slip_coefficients
from hophoop.kernel.physics.impact import singular_angle
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.writing import state_of
from hophoop.kernel.rigid.run import run
from hophoop.results.records import EventErrors, Motion

ROUNDING = 4e-16  # relative rounding of a quantity at an event
CHANGES = (1e-8, 1e-11)  # relative changes; the smaller one is tried if the larger leads to other events
FIELDS = ("t", "x", "height", "angle", "vx", "vy", "omega", "slip")
CHANGED = ("theta", "omega", "slip", "vy", "height", "friction")


def _numbers(events: np.ndarray) -> np.ndarray:
    """Return a table of time and state, shape (events, fields)."""
    return np.stack([events[name] for name in FIELDS], axis=1)


def _natural_sizes(row: np.void) -> dict[str, float]:
    """Return the sizes to which the rounding of each quantity of an event is relative, in units of R, m and √(R/g)."""
    speed = abs(float(row["omega"])) + abs(float(row["slip"]))
    flies = row["after_mode"] == Mode.FLIGHT
    return {
        "theta": 1.0,
        "omega": abs(float(row["omega"])),
        "slip": speed,
        "vy": speed + abs(float(row["vy"])),
        "height": 1.0 + float(row["height"]) if flies else 0.0,
        "friction": 1.0,  # rounding of the margins to the friction cone acts like rounding of the coefficients
    }


def _recompute(body: Body, row: np.void, t_end: float, room: int) -> np.ndarray | None:
    """Return the events of a motion computed again from the event `row`, which they start with; None if there is no room."""
    events = np.empty(room, EVENT)
    status, count, _ = compiled(run)(
        body, state_of(row), int(row["after_mode"]), t_end, math.nan, 0, events, np.empty(0, SEGMENT), new_scratch()
    )
    return None if status == Status.EVENT_LIMIT else events[:count]


def _count_alike(first: np.ndarray, second: np.ndarray) -> int:
    """Return the number of leading events with the same kinds and modes."""
    count = min(len(first), len(second))
    same = np.ones(count, bool)
    for name in ("kind", "before_mode", "after_mode"):
        same &= first[name][:count] == second[name][:count]
    return int(np.argmin(same)) if not same.all() else count


def _impulse_fraction(body: Body, row: np.void, following: np.void) -> float:
    """Return the fraction of an impulse at p_σ → 0 that rounding of time and angle moves across the event before it.

    N is unbounded there, so that the velocities belong to an instant that is not exactly known.
    """
    if row["kind"] != Event.PAINLEVE_INCONSISTENT or not following["impulse_normal"] > 0.0:
        return 0.0
    th, low, om, slip = (float(row[name]) for name in ("theta", "theta_low", "omega", "slip"))
    sigma = 1 if slip > 0.0 else -1
    s, c = sine_cosine(th, low)
    rho = resistance_arm(body, s, c, om, sigma)
    torque, distance = slip_coefficients(body, th, low, s, c, sigma, rho)
    found, exact, _ = singular_angle(body, s, c, om * om, sigma, torque, distance)
    if not (found and exact) or om == 0.0:
        return 0.0
    late = ROUNDING * (1.0 + abs(float(row["t"])) + (1.0 + abs(th)) / abs(om))
    reached = body.kap * abs(body.gn - body.eps * c * om * om) * late
    whole = abs(distance) * float(following["impulse_normal"])
    return min(reached / whole, 1.0) if whole > 0.0 else 1.0


def estimated_errors(body: Body, events: np.ndarray, t_end: float, reached: np.ndarray | None = None) -> np.ndarray:
    """Return estimated errors of the events of a rigid motion, shape (n, len(FIELDS)), in units of R, m and √(R/g).

    inf if the smallest change leads to other events. t_end: The motion's duration [√(R/g)]; reached: shape (1,), Progress: the
    computed fraction is written here repeatedly [1].
    """
    count = len(events)
    squares = np.zeros((count, len(FIELDS)))
    table = _numbers(events)
    own = ROUNDING * (1.0 + np.abs(table))
    squares += own * own
    for i in range(count - 1):
        row = events[i]
        jump = _impulse_fraction(body, row, events[i + 1]) * (table[i + 1] - table[i])
        squares[i] += jump * jump
        if reached is not None:
            reached[0] = 1.0 - (1.0 - i / count) * (1.0 - i / count)  # each event requires all later events
        sizes = _natural_sizes(row)
        plain = _recompute(body, row, t_end, 2 * count + 8)
        if plain is None:
            continue
        reach = 1 + _count_alike(plain[1:], events[i + 1 :])
        for name in CHANGED:
            if sizes[name] == 0.0 or (name in ("slip", "vy") and row[name] == 0.0):
                continue  # zero by the definition of the event
            for change in CHANGES:
                moved, rougher = row.copy(), body
                if name == "friction":
                    rougher = body._replace(mu_s=body.mu_s * (1.0 + change), mu_k=body.mu_k * (1.0 + change))
                else:
                    moved[name] = row[name] + change * sizes[name]
                other = _recompute(rougher, moved, t_end, 2 * count + 8)
                alike = 0 if other is None else min(_count_alike(other, plain), reach)
                if alike == reach or change == CHANGES[-1]:
                    break
            if other is not None and alike > 1:
                rate = (_numbers(other[1:alike]) - _numbers(plain[1:alike])) / change
                squares[i + 1 : i + alike] += (rate * ROUNDING) * (rate * ROUNDING)
            if alike < reach:
                squares[i + max(alike, 1) :] = math.inf
    result: np.ndarray = np.sqrt(squares)
    return result


def event_errors(motion: Motion, progress: Callable[[float], object] | None = None) -> EventErrors:
    """Compute `Trajectory.errors`.

    progress: Called with the share that is computed, 0 to 1: about ten times a second, and at the end.
    """
    if motion.scenario.contact.model != "rigid":
        raise InputError("motion.errors needs rigid contact; in compliant contact contact.rtol controls the error.")
    unit = motion.units
    given = (motion.scenario.to_body(), motion.tables["events"], motion.scenario.duration / unit.time)
    if progress is None:
        table = estimated_errors(*given)
    else:
        table = compute_reporting(lambda share: estimated_errors(*given, share), progress)
        progress(1.0)
    return EventErrors(**{name: table[:, i] * unit.of(name) for i, name in enumerate(FIELDS)})
