"""A gait with many digits: the solver of `simulate(digits=...)` over a period, which shares no panel with the kernel.

Newton's method leads to the point of the section that comes back. Its derivative is that of the kernel's map, right to about 11
digits: so many are added by each step. At the bottom the section is θ = π with all digits, not the double next to it.
"""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal, localcontext
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from hophoop._support.errors import check_whole
from hophoop.gaits.maps import coordinates
from hophoop.kernel.model import Event, Status
from hophoop.precise.motion import Record
from hophoop.precise.problem import Problem
from hophoop.precise.result import Units
from hophoop.precise.solver import Solution, solve_problem
from hophoop.scenario import InputError, time_unit
from hophoop.vocabulary.names import sequence_of

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait

State = dict[str, Decimal]

LEAST, MOST = 16, 40  # digits
SPARE = 10  # digits computed beyond
LEVELS, WIDEST = 4, 2**-14  # of differences for the multiplier, and the first step relative to θ̇
STEPS = 8  # of Newton's method
BEYOND = 1e-6  # √(R/g), by which a motion is solved beyond the landing that ends a period
FAR = 0.5  # rad: a passage that is farther from the kernel's is another one


class PreciseGait(NamedTuple):
    """A gait in arbitrary precision.

    Attributes
    ----------
    state : dict of str to Decimal
        The coordinates on the section that repeat themselves, in SI units; the others are those of the gait's start, with the
        load exactly at the bottom in that section.
    multiplier : Decimal or None
        By extrapolated differences of motions on both sides; None where the section has several coordinates [1].
    multiplier_error : Decimal or None
        Change by the last extrapolation [1].
    sequence : str
        Phases of the period, as in `Gait`.
    """

    state: State
    multiplier: Decimal | None
    multiplier_error: Decimal | None
    sequence: str


def check_digits(digits: int) -> None:
    """Refuse digits that are not allowed."""
    check_whole("digits", digits, LEAST, MOST)


def precise_gait(gait: Gait, digits: int) -> PreciseGait:
    """Compute a gait in arbitrary precision; `Gait.digits` calls this and describes it."""
    check_digits(digits)
    names = coordinates(gait.section, gait.passages.mode[-1])
    with localcontext() as context:
        context.prec = digits + 2 * SPARE
        state = _solved(gait, names, digits)
        multiplier, error = _multiplier(gait, state, digits) if len(names) == 1 else (None, None)
        context.prec = digits
        rounded = {name: +value for name, value in state.items()}
        return PreciseGait(rounded, None if multiplier is None else +multiplier, error, gait.sequence)


def _solved(gait: Gait, names: tuple[str, ...], digits: int) -> State:
    """Return the coordinates that come back after a period, by Newton's method."""
    state = {name: Decimal(float(getattr(gait.state, name))) for name in names}
    size = {name: abs(value) + 1 for name, value in state.items()}
    inverse = np.linalg.inv(np.eye(len(names)) - gait.derivative.matrix)
    for _ in range(STEPS):
        image = _image(gait, state, digits)
        step = inverse @ np.array([float(image[name] - state[name]) for name in names])
        state = {name: state[name] + Decimal(float(change)) for name, change in zip(names, step, strict=True)}
        if all(abs(change) < 10.0 ** (-digits - 2) * float(size[name]) for name, change in zip(names, step, strict=True)):
            return state
    raise InputError(f"In {digits} digits no motion near the gait comes back to the section.")


def _multiplier(gait: Gait, state: State, digits: int) -> tuple[Decimal, Decimal]:
    """Return the derivative by Richardson's extrapolation of central differences, and its last change."""
    omega = state["omega"]
    table: list[list[Decimal]] = []
    for level in range(LEVELS):
        step = omega * Decimal(WIDEST) / 2**level
        ahead, back = (_image(gait, {"omega": place}, digits)["omega"] for place in (omega + step, omega - step))
        row = [(ahead - back) / (2 * step)]
        for k, before in enumerate(table[-1] if table else []):
            factor = 4 ** (k + 1)
            row.append((factor * row[k] - before) / (factor - 1))
        table.append(row)
    return table[-1][-1], abs(table[-1][-1] - table[-2][-1])


def _image(gait: Gait, state: State, digits: int) -> State:
    """Return the coordinates after a period, θ within the revolution of the start."""
    exact: dict[str, Any] = {name: Fraction(value) for name, value in state.items()}
    problem = replace(Problem.of(gait.scenario), **exact)
    if gait.section == "bottom":
        problem = replace(problem, angle=Fraction(_pi(digits + 2 * SPARE)))
        solution, last = _to_bottom(gait, problem, digits)
    else:
        solution, last = _to_landing(gait, problem, digits)
    records = solution.records[: solution.records.index(last) + 1]
    found = sequence_of([one.kind for one in records], [one.after_mode for one in records], [one.state.t for one in records])
    if found != _phases(gait):
        raise InputError(f"In {digits} digits a motion near the gait has the phases {found}, not {_phases(gait)}.")
    units = Units(solution.body, digits + 2 * SPARE)
    revolved = 2 * units.ctx.pi * gait.revolutions
    values = {"omega": last.state.om, "slip": last.state.vt, "vy": last.state.vn, "angle": last.state.th - revolved}
    return {name: units.decimal(values[name], units.of(name)) for name in state}


def _to_bottom(gait: Gait, problem: Problem, digits: int) -> tuple[Solution, Record]:
    """Return the motion up to the end of the period at the bottom, by Newton's method on its time."""
    t = gait.time / time_unit(gait.scenario.hoop, gait.scenario.plane)
    for _ in range(STEPS):
        solution = solve_problem(problem, digits + SPARE, until=t)
        last, ctx = solution.records[-1], solution.body.ctx
        ahead = solution.body.number(problem.angle) + 2 * ctx.pi * gait.revolutions - last.state.th
        if solution.status != Status.COMPLETED or last.state.om == 0 or not abs(ahead) < FAR:
            break
        if abs(ahead) < ctx.mpf(10) ** -(digits + SPARE):
            return solution, last
        t = ctx.mpf(t) + ahead / last.state.om
    raise InputError(f"In {digits} digits the motion does not come back to the section.")


def _to_landing(gait: Gait, problem: Problem, digits: int) -> tuple[Solution, Record]:
    """Return the motion up to just after the landing that ends the period, and the event of this landing."""
    t = gait.time / time_unit(gait.scenario.hoop, gait.scenario.plane)
    solution = solve_problem(problem, digits + SPARE, until=t + BEYOND)
    kinds = {Event.IMPACT, Event.BOUNCE_LIMIT}
    landings = [one for one in solution.records if one.kind in kinds and one.collision is not False]
    if len(landings) < gait.period:
        raise InputError(f"In {digits} digits the motion does not come back to the section.")
    return solution, landings[gait.period - 1]


def _phases(gait: Gait) -> str:
    """Return the phases of a period; one that goes on at the bottom counts once."""
    first, *others = gait.passages.sequences
    return first + "".join(other[1:] if gait.section == "bottom" else other for other in others)


def _pi(digits: int) -> Decimal:
    import mpmath

    with mpmath.workdps(digits):
        return Decimal(mpmath.nstr(mpmath.pi, digits))
