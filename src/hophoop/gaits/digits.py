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
from numpy.typing import NDArray

from hophoop._support.errors import check_whole
from hophoop.gaits.maps import coordinates
from hophoop.precise.problem import Problem
from hophoop.precise.result import Units
from hophoop.scenario import InputError, time_unit
from hophoop.simulation.precise_until import solve_until
from hophoop.simulation.until import NOTHING
from hophoop.vocabulary.names import sequence_of

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait

State = NDArray[Any]  # decimals, in the order of the coordinates

LEAST, MOST = 16, 40  # digits
SPARE = 10  # digits computed beyond
STEPS = 8  # of Newton's method


class PreciseGait(NamedTuple):
    """A gait in arbitrary precision.

    Attributes
    ----------
    state : dict of str to Decimal
        The coordinates on the section that repeat themselves, in SI units; the others are those of the gait's start, with the
        load exactly at the bottom in that section.
    multiplier : Decimal or None
        By differences of motions on both sides; None where the section has several coordinates [1].
    multiplier_error : Decimal or None
        Change by a difference twice as wide [1].
    sequence : str
        Phases of the period, as in `Gait`.
    """

    state: dict[str, Decimal]
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
        context.prec = 2 * (digits + SPARE)
        state = _solved(gait, names, digits)
        multiplier, error = _multiplier(gait, names, state, digits) if len(names) == 1 else (None, None)
        context.prec = digits
        rounded = {name: +value for name, value in zip(names, state, strict=True)}
        return PreciseGait(rounded, None if multiplier is None else +multiplier, error, gait.sequence)


def _solved(gait: Gait, names: tuple[str, ...], digits: int) -> State:
    """Return the coordinates that come back after a period, by Newton's method."""
    state = np.array([Decimal(float(getattr(gait.state, name))) for name in names])
    inverse = np.linalg.inv(np.eye(len(names)) - gait.derivative.matrix)
    for _ in range(STEPS):
        step = inverse @ (_image(gait, names, state, digits) - state).astype(float)
        state = state + [Decimal(change) for change in step.tolist()]
        if np.all(np.abs(step) < 10.0 ** (-digits - 2) * (1.0 + np.abs(state.astype(float)))):
            return state
    raise InputError(f"In {digits} digits no motion near the gait comes back to the section.")


def _multiplier(gait: Gait, names: tuple[str, ...], state: State, digits: int) -> tuple[Decimal, Decimal]:
    """Return the derivative by a central difference with half as many digits more, and its change by one twice as wide."""
    step, more = state * Decimal(10) ** -(digits // 2 + 1), digits + digits // 2 - SPARE
    narrow, wide = (
        (_image(gait, names, state + width, more) - _image(gait, names, state - width, more)) / (2 * width)
        for width in (step, 2 * step)
    )
    return narrow[0], abs(wide[0] - narrow[0])


def _image(gait: Gait, names: tuple[str, ...], state: State, digits: int) -> State:
    """Return the coordinates after a period, θ within the revolution of the start."""
    exact: dict[str, Any] = {name: Fraction(value) for name, value in zip(names, state, strict=True)}
    until = NOTHING._replace(landings=gait.period)
    if gait.section == "bottom":
        exact["angle"] = Fraction(_pi(digits + 2 * SPARE))
        until = NOTHING._replace(revolutions=abs(gait.revolutions))
    about = gait.time / time_unit(gait.scenario.hoop, gait.scenario.plane)
    solution = solve_until(replace(Problem.of(gait.scenario), **exact), digits + SPARE, until, about)
    if solution is None:
        raise InputError(f"In {digits} digits the motion does not come back to the section.")
    records, units = solution.records, Units(solution.body, digits + 2 * SPARE)
    found = sequence_of([one.kind for one in records], [one.after_mode for one in records], [one.state.t for one in records])
    if found != _phases(gait):
        raise InputError(f"In {digits} digits a motion near the gait has the phases {found}, not {_phases(gait)}.")
    last, revolved = records[-1].state, 2 * units.ctx.pi * gait.revolutions
    values = {"omega": last.om, "slip": last.vt, "vy": last.vn, "angle": last.th - revolved}
    return np.array([units.decimal(values[name], units.of(name)) for name in names])


def _phases(gait: Gait) -> str:
    """Return the phases of a period; one that goes on at the bottom counts once."""
    first, *others = gait.passages.sequences
    return first + "".join(other[1:] if gait.section == "bottom" else other for other in others)


def _pi(digits: int) -> Decimal:
    import mpmath

    with mpmath.workdps(digits):
        return Decimal(mpmath.nstr(mpmath.pi, digits))
