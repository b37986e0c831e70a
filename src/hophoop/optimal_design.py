"""Optimal hoop, plane or start: `design` climbs by derivatives inside a class and continues across its boundaries."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.derivatives.parameters import PATHS, value_of
from hophoop.derivatives.results.friction_utilization import greatest_use
from hophoop.derivatives.results.propagation import WithDerivatives
from hophoop.derivatives.results.quantities import NotInMotion, quantity
from hophoop.derivatives.results.sensitivity import names_of
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.events import phase_starts

Floats = NDArray[np.float64]
Label = tuple[tuple[int, int, int], ...]
Limits = tuple[float | None, float | None]

FLAT = 1e-6  # relative to the range of values met: a steeper final slope means that a boundary stopped the climb
NARROW = 1e-9  # relative to the range of a parameter: final distance from a boundary


@dataclass(frozen=True)
class Climb:
    """One climb inside a class.

    Attributes
    ----------
    sequence : str
        Sequence of the final motion.
    value : float
        Final value of the objective [its unit].
    parameters : dict of str to float
        Final values [their units].
    at_border : bool
        Whether it ended at the boundary of its class, not at a maximum or a limit.
    """

    sequence: str
    value: float
    parameters: dict[str, float]
    at_border: bool


@dataclass(frozen=True)
class Design:
    """Result of `design`.

    Attributes
    ----------
    scenario : Scenario
        The best scenario.
    motion : Trajectory
        Its motion.
    of : str
        The objective that was maximized or minimized.
    value : float
        Its value in the best motion [its unit].
    parameters : dict of str to float
        The best values [their units].
    at_border : bool
        Whether it is at the boundary of its class, beyond which the motion is another one.
    climbs : tuple of Climb
        All climbs, best first.
    motions : int
        Number of motions computed.
    """

    scenario: Scenario
    motion: Trajectory
    of: str
    value: float
    parameters: dict[str, float]
    at_border: bool
    climbs: tuple[Climb, ...]
    motions: int


@dataclass
class _Trial:
    """A tried scenario: its values, its class, and its slopes by the parameters relative to their ranges."""

    place: Floats
    motion: Trajectory
    value: float
    label: Label
    excess: Floats  # of each constraint, 0 or more where it is met
    names: list[str]

    @property
    def allowed(self) -> bool:
        return bool((self.excess >= -1e-9).all())


@dataclass
class _Task:
    """The objective, the parameters and the limits, with a counter of motions."""

    scenario: Scenario
    of: str
    sign: float
    paths: tuple[str, ...]
    low: Floats
    high: Floats
    limits: Mapping[str, Limits]
    motions: int = 0
    across: dict[Label, _Trial] = field(default_factory=dict)

    def values_at(self, place: Floats) -> dict[str, float]:
        values = self.low + np.clip(place, 0.0, 1.0) * (self.high - self.low)
        return {path: float(value) for path, value in zip(self.paths, values, strict=True)}

    def try_at(self, place: Floats) -> _Trial | None:
        """Return the motion at a position; None if it is not allowed or lacks the objective."""
        self.motions += 1
        try:
            scenario = self.scenario.with_values(self.values_at(place))
            motion = simulate(scenario)
            names = [name for name in (self.of, *self.limits) if not _is_path(name)]
            last = max((_last_event(motion, name) for name in names), default=0)
            value = self.sign * _value(motion, self.of)
            excess = np.array([each for name, limits in self.limits.items() for each in _excess(_value(motion, name), limits)])
        except InputError:
            return None
        if not math.isfinite(value):
            return None
        return _Trial(np.array(place), motion, value, _label(motion, last), excess, names)

    def slopes(self, trial: _Trial) -> tuple[Floats, Floats]:
        """Return the slopes of the value and of each constraint, by the parameters relative to their ranges; 0 for none."""
        width = self.high - self.low
        rows: dict[str, Floats] = {}
        if trial.names:
            result = trial.motion.sensitivity(list(dict.fromkeys(trial.names)), self.paths)
            both = np.where(np.isfinite(result.larger), result.larger, result.smaller)
            rates = np.where(np.isfinite(result.derivatives), result.derivatives, both)
            rows = dict(zip(result.of, np.nan_to_num(rates) * width, strict=True))
        for path in (self.of, *self.limits):
            if _is_path(path):
                rows[path] = np.array([float(path == each) for each in self.paths]) * width
        of_limits = [
            sign * rows[name] for name, limits in self.limits.items() for sign in _signs(limits)
        ]  # fmt: skip
        return self.sign * rows[self.of], np.array(of_limits).reshape(-1, len(self.paths))


def _is_path(name: str) -> bool:
    return name in PATHS or name.startswith("hoop.parts.")


def _value(motion: Trajectory, name: str) -> float:
    if _is_path(name):
        return value_of(motion.scenario, name)
    return float(quantity(motion, name)(_Plain(motion)).value)  # type: ignore[arg-type]


class _Plain:
    """A motion without derivatives from which quantities read their values; it records the events that they need."""

    def __init__(self, motion: Trajectory) -> None:
        self.motion = motion
        self.last = 0

    def at_event(self, index: int, name: str) -> WithDerivatives:
        self.last = max(self.last, index)
        event: Any = self.motion.events[index]
        if name in ("kinetic", "potential", "total"):
            return WithDerivatives(getattr(self.motion.at(event.t), name), np.zeros(0))
        for step in name.split("."):
            event = getattr(event, step)
        return WithDerivatives(float(event), np.zeros(0))

    def friction_utilization(self) -> WithDerivatives:
        self.last = len(self.motion.events) - 1
        tables = self.motion.tables
        return WithDerivatives(greatest_use(self.motion.scenario.to_body(), tables["events"], tables["segments"]), np.zeros(0))

    def at_times(self, times: Floats, names: Sequence[str], left: bool = False) -> dict[str, tuple[Floats, Floats]]:
        begins = np.array([event.t for event in self.motion.events])
        self.last = max(self.last, int(np.searchsorted(begins, times[0], side="right")) - 1)
        sample = self.motion.at(times, "left" if left else "right")
        return {name: (np.asarray(getattr(sample, name), float), np.zeros((times.size, 0))) for name in names}


def _last_event(motion: Trajectory, name: str) -> int:
    plain = _Plain(motion)
    quantity(motion, name)(plain)  # type: ignore[arg-type]
    return plain.last


def _label(motion: Trajectory, last: int) -> Label:
    """Return the class of a motion: its events up to the last one that matters."""
    rows = motion.tables["events"][: last + 1]
    starts = rows[phase_starts(rows["kind"].tolist())]
    return tuple((int(r["kind"]), int(r["before_mode"]), int(r["after_mode"])) for r in starts)


def _signs(limits: Limits) -> list[float]:
    low, high = limits
    return ([] if low is None else [1.0]) + ([] if high is None else [-1.0])


def _excess(value: float, limits: Limits) -> list[float]:
    low, high = limits
    return ([] if low is None else [value - low]) + ([] if high is None else [high - value])


def design(
    scenario: Scenario | None = None,
    *,
    over: Mapping[str, tuple[float, float]],
    maximise: str | None = None,
    minimise: str | None = None,
    subject_to: Mapping[str, Limits] | None = None,
    tries: int = 64,
    climbs: int = 8,
    seed: int = 0,
) -> Design:
    """Find the parameters that maximize or minimize a quantity of the motion.

    From the best of scattered samples it climbs by derivatives inside a class of motions, those with the same events in the
    same order. At a boundary it continues in the class beyond. It finds the best of the classes that it has met, without a
    proof that there is no better one.

    Parameters
    ----------
    scenario : Scenario, optional
        All fixed parameters; by default the reference case.
    over : mapping of str to (float, float)
        Minimum and maximum of each varied parameter, by path [their units].
    maximise, minimise : str
        One of them: a quantity, such as ``"hop_height"``, as `Trajectory.sensitivity` takes it, or a parameter.
    subject_to : mapping of str to (float or None, float or None), optional
        Minimum and maximum of other quantities or parameters [their units].
    tries : int, default 64
        Number of scattered samples at the start [1].
    climbs : int, default 8
        Maximum number of climbs [1].
    seed : int, default 0
        Seed of the scattered samples [1].

    Returns
    -------
    design : Design

    Raises
    ------
    ValueError
        If not just one of maximise and minimise is given, a range is empty, or no sampled motion has the objective.
    ImportError
        If SciPy is missing (extra ``design``).

    Examples
    --------
    >>> import hophoop as hh
    >>> best = hh.design(maximise="hop_height", over={"start.speed": (2.0, 5.0)})  # doctest: +SKIP
    >>> round(best.parameters["start.speed"], 6), round(best.value, 6), best.motion.sequence  # doctest: +SKIP
    (3.616628, 0.899008, 'RKRSHRSRSRS')
    """
    task = _task_of(scenario or Scenario(), over, maximise, minimise, subject_to or {})
    found = _scattered(task, tries, seed)
    waiting = sorted(found.values(), key=lambda trial: -trial.value)
    done: dict[Label, tuple[_Trial, bool]] = {}
    while waiting and len(done) < climbs:
        begin = waiting.pop(0)
        if begin.label in done:
            continue
        done[begin.label] = _climb(task, begin)
        new = [trial for label, trial in task.across.items() if label not in done and trial.allowed]
        waiting = sorted({trial.label: trial for trial in (*waiting, *new)}.values(), key=lambda trial: -trial.value)
    ordered = sorted(done.values(), key=lambda each: -each[0].value)
    best, at_border = ordered[0]
    records = tuple(
        Climb(trial.motion.sequence, task.sign * trial.value, task.values_at(trial.place), border) for trial, border in ordered
    )
    return Design(
        best.motion.scenario, best.motion, task.of, task.sign * best.value, task.values_at(best.place), at_border, records,
        task.motions,
    )  # fmt: skip


def _task_of(
    scenario: Scenario,
    over: Mapping[str, tuple[float, float]],
    maximise: str | None,
    minimise: str | None,
    subject_to: Mapping[str, Limits],
) -> _Task:
    if (maximise is None) == (minimise is None):
        raise InputError("design needs either maximise or minimise, and not both.")
    paths = names_of(tuple(over), "over")
    for path, (least, most) in over.items():
        if not -math.inf < least < most < math.inf:
            raise InputError(
                f"over: {path} = ({least!r}, {most!r}) must be two numbers, the lower one first.", field="over", value=over
            )
    for name, limits in subject_to.items():
        if len(limits) != 2 or limits == (None, None):
            raise InputError(
                f"subject_to: {name} = {limits!r} must be a lowest and a highest value, one of which may be None.",
                field="subject_to",
                value=subject_to,
            )
    middle = scenario.with_values({path: 0.5 * (least + most) for path, (least, most) in over.items()})
    for path in paths:
        value_of(middle, path)
    low, high = (np.array([each[side] for each in over.values()], float) for side in (0, 1))
    of, sign = (maximise, 1.0) if maximise is not None else (str(minimise), -1.0)
    return _Task(scenario, of, sign, paths, low, high, subject_to)


def _scattered(task: _Task, tries: int, seed: int) -> dict[Label, _Trial]:
    """Return the best allowed motion of each class among scattered samples."""
    qmc = need("scipy.stats", "design").qmc
    places = qmc.Halton(len(task.paths), seed=seed).random(tries)
    best: dict[Label, _Trial] = {}
    reason = ""
    for place in places:
        trial = task.try_at(place)
        if trial is None:
            continue
        if not trial.allowed:
            reason = " within the limits"
            continue
        if trial.label not in best or trial.value > best[trial.label].value:
            best[trial.label] = trial
    if not best:
        _refuse_unknown(task)
        raise InputError(f"None of the {tries} motions tried has {task.of!r}{reason}; widen `over`, or try more.")
    return best


def _refuse_unknown(task: _Task) -> None:
    """Refuse a quantity that no motion can have, with the message of `quantity`."""
    motion = simulate(task.scenario)
    for name in (task.of, *task.limits):
        if not _is_path(name):
            with suppress(NotInMotion):
                quantity(motion, name)


def _climb(task: _Task, begin: _Trial) -> tuple[_Trial, bool]:
    """Return the best motion reached from one of its class, and whether a boundary stopped the climb."""
    optimize = need("scipy.optimize", "design")
    best = begin
    worst = begin.value
    size = abs(begin.value) or 1.0
    seen: dict[bytes, _Trial | None] = {}

    def at(place: Floats) -> _Trial | None:
        nonlocal best
        place = np.clip(place, 0.0, 1.0)
        key = place.tobytes()
        if key not in seen:
            trial = task.try_at(place)
            if trial is not None and trial.label != begin.label:
                known = task.across.get(trial.label)
                if trial.allowed and (known is None or trial.value > known.value):
                    task.across[trial.label] = trial
                trial = None
            seen[key] = trial
            if trial is not None and trial.allowed and trial.value > best.value:
                best = trial
        return seen[key]

    def cost(place: Floats) -> float:
        trial = at(place)
        return (worst_of() if trial is None else -trial.value) / size

    def worst_of() -> float:
        return -worst + 10.0 * size

    def slope(place: Floats) -> Floats:
        trial = at(place)
        return -task.slopes(best if trial is None else trial)[0] / size

    constraints = []
    if begin.excess.size:
        constraints = [
            {
                "type": "ineq",
                "fun": lambda place: (at(place) or best).excess,
                "jac": lambda place: task.slopes(at(place) or best)[1],
            }
        ]
    bounds = [(0.0, 1.0)] * len(task.paths)
    for _ in range(2):  # again, since a boundary at which the value falls may have stopped it too early
        before = best.value
        options = {"ftol": 1e-13, "maxiter": 20}
        optimize.minimize(cost, best.place, jac=slope, method="SLSQP", bounds=bounds, constraints=constraints, options=options)
        if not best.value > before + 1e-6 * size:
            break
    if not _is_stopped(task, best, size):
        return best, False
    _approach(task, best, at)
    if len(task.paths) > 1:
        optimize.minimize(
            lambda place: cost(place) if (at(place) or begin).allowed else worst_of() / size,
            best.place,
            method="Nelder-Mead",
            bounds=bounds,
            options={"xatol": 1e-9, "fatol": 1e-12, "maxfev": 150 * len(bounds)},
        )
        _approach(task, best, at)
    return best, _is_stopped(task, best, size)


def _uphill(task: _Task, trial: _Trial) -> Floats:
    """Return the slope of the value, without the components that leave the ranges or break active constraints."""
    slope, of_limits = task.slopes(trial)
    normals = [row for row, left in zip(of_limits, trial.excess, strict=True) if left <= 1e-7 * (1.0 + np.abs(row).max())]
    at_low, at_high = trial.place <= 0.0, trial.place >= 1.0
    for _ in range(4):
        slope = np.where((at_low & (slope < 0.0)) | (at_high & (slope > 0.0)), 0.0, slope)
        for normal in normals:
            inward = float(slope @ normal)
            if inward < 0.0:
                slope = slope - inward / float(normal @ normal) * normal
    result: Floats = slope
    return result


def _is_stopped(task: _Task, trial: _Trial, size: float) -> bool:
    if not _is_path(task.of) and np.isnan(trial.motion.sensitivity(task.of, task.paths).larger).any():
        return True  # too close to the boundary for doubles
    return bool(np.abs(_uphill(task, trial)).max() > FLAT * size)


def _approach(task: _Task, trial: _Trial, at: Any) -> None:
    """Go uphill from a motion as far as its class and the limits allow, by bisection."""
    slope = _uphill(task, trial)
    way = slope / (np.abs(slope).max() or 1.0)
    inside, outside = 0.0, 1.0
    while outside - inside > NARROW:
        middle = 0.5 * (inside + outside)
        there = at(trial.place + middle * way)
        if there is not None and there.allowed:
            inside = middle
        else:
            outside = middle
