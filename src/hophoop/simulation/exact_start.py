"""Decisions beyond double precision: the first events of a motion in extended precision, as a script for the kernel.

If a deciding margin is zero within rounding, `hophoop.precise` solves the motion from its start, with the given doubles as
exact numbers, until all margins are clear of zero. The kernel then repeats these events and continues on its own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.records.layout import EVENT
from hophoop.scenario import Scenario, time_unit

DIGITS = 20
MOST = 12  # maximum of such decisions per motion
# Later than this, in units of √(R/g), double precision decides: extended precision would take minutes.
LATEST = 100.0
FAST = 30.0  # √(g R): for a faster start extended precision is used for a shorter time, over as many revolutions
# A lighter ring rotates fast at the bottom, where extended precision takes short time steps.
LIGHT = 1e-3
# Maximum of steps in extended precision per motion, about 1 ms each, so that they end within 5 s. A step with more bits counts
# as several. Doubts beyond it are left to double precision.
ALL_STEPS = 3500
MOST_BITS = 100  # with smaller numbers, below 1e-30, double precision decides
CLEAR = 0.05  # in √(R/g): time without an event after which margins count as clear of zero
# With more than FEW events, waiting for a gap of CLEAR might never end: a gap of BETWEEN · CLEAR suffices.
FEW, BETWEEN = 4, 1.0 / 16.0
MOST_TURNED = 10.0  # rad: maximum rotation of a fast start within this time
NO_SCRIPT = np.empty(0, EVENT)

_LAST = (Event.REST, Event.JAM, Event.END)


def exact_horizon(scenario: Scenario) -> float:
    """Return the time until which doubts of a motion are decided in extended precision.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    t : float
        −1 without friction, with infinite friction and for a massless ring [√(R/g)].
    """
    light = scenario.hoop.inertia_ratio
    if scenario.contact.model != "rigid" or light == 0.0 or not 0.0 < scenario.plane.mu_static < math.inf:
        return -1.0
    return LATEST * min(1.0, math.sqrt(light / LIGHT), FAST / max(initial_speed(scenario), FAST))


def initial_speed(scenario: Scenario) -> float:
    """Return the speed at the start of a motion.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    speed : float
        [√(g R)].
    """
    given, radius = scenario.start.state(scenario.hoop), scenario.hoop.radius
    rate = (abs(given.vx) + abs(given.vy)) / radius + abs(given.omega)
    return rate * time_unit(scenario.hoop, scenario.plane)


def steps_allowed(scenario: Scenario) -> int:
    """Return the steps in extended precision that a motion may take.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.

    Returns
    -------
    steps : int
        Steps with 106 bits, in both precisions together; a step with more bits counts as several. 0 with numbers below 1e-30
        [1].
    """
    from hophoop.precise.problem import Problem

    return 0 if Problem.of(scenario).tiny() > MOST_BITS else ALL_STEPS


@dataclass
class Budget:
    """Remaining steps for the decisions of a motion.

    Attributes
    ----------
    steps : float
        Remaining steps in extended precision [1].
    least : float
        Steps of the farthest solution so far; a farther one has to repeat all of them [1].
    reached : float
        Time that it reached [√(R/g)].
    """

    steps: float
    least: float = 0.0
    reached: float = 0.0


def first_quiet_gap(times: list[float], least: float) -> float | None:
    """Find the first gap of a minimum length between successive events.

    Parameters
    ----------
    times : list of float
        Times of the events, in order.
    least : float
        Minimum length of the gap, in the same unit.

    Returns
    -------
    t : float or None
        The middle of the first such gap; None if there is none, or if there are few events.
    """
    if len(times) > FEW:
        for before, after in pairwise(times):
            if after - before >= least:
                return 0.5 * (before + after)
    return None


def script_until(scenario: Scenario, end: float, budget: Budget | None = None) -> np.ndarray:
    """Return the events of a motion until it is clear of a doubt.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.
    end : float
        Time at which the doubt ends [√(R/g)].
    budget : Budget, optional
        Remaining steps of the motion, reduced here; by default the full budget.

    Returns
    -------
    script : ndarray of records.EVENT, shape (n,)
        The last one, of kind END, is the state from which the kernel continues. Length 0 if extended precision does not help.
    """
    from hophoop.precise import solve
    from hophoop.precise.series import TooManySteps

    clear = min(CLEAR, MOST_TURNED / max(initial_speed(scenario), 1.0))
    until = end + clear
    last = scenario.duration / time_unit(scenario.hoop, scenario.plane)
    whole = steps_allowed(scenario)
    budget = Budget(whole) if budget is None else budget
    if whole == 0:
        return NO_SCRIPT
    between = None
    for _ in range(8):
        try:
            if until >= budget.reached and budget.least > budget.steps:
                raise TooManySteps
            solution = solve(scenario, DIGITS, until=until if until < last else None, most_steps=budget.steps)
        except ArithmeticError:
            budget.steps = 0
            return NO_SCRIPT
        left = solution.body.work.left
        if until >= budget.reached:
            budget.least, budget.reached = budget.steps - left, until
        budget.steps = left
        records = list(solution.records)
        if solution.status != Status.COMPLETED:
            break
        before = [float(record.state.t) for record in records if record.kind != Event.END]
        if not before or until >= last or until - before[-1] >= 0.5 * clear or until == between:
            break
        between = first_quiet_gap([t for t in before if t >= end], BETWEEN * clear)
        until = before[-1] + clear if between is None else between
    if solution.status != Status.COMPLETED:
        # the kernel decides how the motion ends: it continues from the last event before the end
        while records and records[-1].kind in _LAST:
            records.pop()
        if not records:
            return NO_SCRIPT
        records.append(records[-1])
    script = np.zeros(len(records), EVENT)
    for row, record in zip(script, records, strict=True):
        state = record.state
        turns, theta = solution.turns(state.th)
        row["t"], row["t_low"] = solution.pair(state.t)
        row["x"], row["x_low"] = solution.pair(state.x)
        row["theta"], row["theta_low"] = solution.pair(theta)
        row["turns"] = turns
        row["angle"] = float(state.th)
        row["height"] = float(state.y)
        row["slip"], row["vy"], row["omega"] = float(state.vt), float(state.vn), float(state.om)
        row["vx"] = float(state.vt + state.om)
        row["before_slip"], row["before_vy"] = float(record.before_vt), float(record.before_vn)
        row["before_omega"] = float(record.before_om)
        row["before_vx"] = float(record.before_vt + record.before_om)
        row["impulse_normal"], row["impulse_tangential"] = float(record.p_n), float(record.p_t)
        row["friction"], row["gain"] = float(state.friction), float(record.gain)
        row["impact_normal"], row["impact_tangential"] = float(state.impact_n), float(state.impact_t)
        row["rolling_resistance"] = float(state.resisted)
        row["kind"] = record.kind
        row["before_mode"] = -1 if record.before_mode is None else record.before_mode
        row["after_mode"] = record.after_mode
        row["collision"] = -1 if record.collision is None else int(record.collision)
        row["stable"] = -1 if record.stable is None else int(record.stable)
    late = script["t"] > last  # rounding of the duration in these units
    script["t"][late], script["t_low"][late] = last, 0.0
    return script


class Decisions:
    """Decisions in extended precision about the doubts of a motion, one after the other.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._budget: Budget | None = None
        self._taken = 0

    def script(self, until: float) -> np.ndarray | None:
        """Return the first events of the motion, which decide a doubt.

        Parameters
        ----------
        until : float
            End of the doubt, nan if there is none [√(R/g)].

        Returns
        -------
        script : ndarray of records.EVENT or None
            None if nothing is to be decided, or it cannot be decided.
        """
        last = exact_horizon(self._scenario)
        if self._taken == MOST or not until <= last:
            return None
        if self._budget is None:
            self._budget = Budget(steps_allowed(self._scenario))
        # decide later doubts together, because each solution starts from t = 0
        end = min(until * (1.5 if self._taken else 1.0), last)
        self._taken += 1
        found = script_until(self._scenario, end, self._budget)
        return found if 0 < len(found) <= self._scenario.contact.max_events else None
