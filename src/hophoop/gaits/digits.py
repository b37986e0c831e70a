"""A gait with many digits: the solver of `simulate(digits=...)` over a period, which shares nothing with the kernel."""

from __future__ import annotations

import math
from decimal import Decimal, localcontext
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop._support.errors import check_whole
from hophoop.gaits.section import coordinates
from hophoop.scenario import InputError, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary.modes import MODE_LETTERS

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait

LEAST, MOST, MOST_OF_SEVERAL = 16, 40, 25  # digits; where the section has several coordinates fewer
SPARE = 10  # digits computed beyond
LEVELS, WIDEST = 4, 2.0**-14  # of differences for the multiplier, and the first step relative to θ̇
LONGER = 1.5  # periods after which a motion is given up


class PreciseGait(NamedTuple):
    """A gait in arbitrary precision.

    Attributes
    ----------
    state : dict of str to Decimal
        The coordinates on the section that repeat themselves, in SI units; the others are those of the gait's start.
    multiplier : Decimal or None
        By extrapolated differences of motions on both sides; None where the section has several coordinates [1].
    multiplier_error : Decimal or None
        Change by the last extrapolation [1].
    word : str
        Phases of the period.
    """

    state: dict[str, Decimal]
    multiplier: Decimal | None
    multiplier_error: Decimal | None
    word: str


def precise_gait(gait: Gait, digits: int) -> PreciseGait:
    """Compute a gait in arbitrary precision; `Gait.digits` calls this.

    Parameters
    ----------
    gait : Gait
    digits : int

    Returns
    -------
    precise : PreciseGait

    Raises
    ------
    ValueError
        If digits is not allowed, or the motion in arbitrary precision does not come back to the section.
    """
    names = coordinates(gait.section, MODE_LETTERS.index(gait.passages.mode[-1]))
    most = MOST if len(names) == 1 else MOST_OF_SEVERAL
    check_whole("digits", digits, LEAST, most, "for this section")
    with localcontext() as context:
        context.prec = digits + 2 * SPARE
        if len(names) == 1:
            found = _of_one(gait, digits)
        else:
            found = _of_several(gait, names, digits)
        context.prec = digits
        state = {name: +value for name, value in found.state.items()}
        multiplier = None if found.multiplier is None else +found.multiplier
        return found._replace(state=state, multiplier=multiplier)


def _image(gait: Gait, scenario: Scenario, names: tuple[str, ...], digits: int) -> tuple[dict[str, Decimal], str]:
    """Return the coordinates after a period, and the word."""
    until = f"landings:{gait.period}" if gait.section == "landing" else f"revolutions:{abs(gait.revolutions)}"
    motion = simulate(scenario.replace("duration", LONGER * gait.time), digits=digits + SPARE, until=until)
    if motion.ending != until or motion.events[-1].to_mode != gait.passages.mode[-1]:
        raise InputError(f"In {digits} digits the motion does not come back to the section: it ended with {motion.ending}.")
    end = motion.events[-1]
    return {name: Decimal(getattr(end, name)) for name in names}, motion.sequence


def _at(gait: Gait, omega: float) -> Scenario:
    """Return the gait's scenario with another θ̇ in rolling."""
    start = gait.scenario.start
    radius = gait.scenario.hoop.radius
    return gait.scenario.replace("start", Start(angle=start.angle, vx=radius * omega, omega=omega, slip=0.0, mode="R"))


def _of_one(gait: Gait, digits: int) -> PreciseGait:
    """Newton's interpolation through three neighbouring doubles meets the diagonal; their distance cubed is left out."""
    omega = gait.state.omega
    step = 4.0 * math.ulp(omega)
    places = (omega - step, omega, omega + step)
    word = ""
    excess = []
    for place in places:
        image, word = _image(gait, _at(gait, place), ("omega",), digits)
        excess.append(image["omega"] - Decimal(place))
    slope = (excess[2] - excess[0]) / (2 * Decimal(step))
    bend = (excess[2] - 2 * excess[1] + excess[0]) / (2 * Decimal(step) ** 2)
    root = Decimal(0)
    for _ in range(8):
        root = -excess[1] / (slope + bend * root)
    multiplier, error = _multiplier(gait, omega, digits)
    return PreciseGait({"omega": Decimal(omega) + root}, multiplier, error, word)


def _multiplier(gait: Gait, omega: float, digits: int) -> tuple[Decimal, Decimal]:
    """Return the derivative by Richardson's extrapolation of central differences, and its last change."""
    table: list[list[Decimal]] = []
    for level in range(LEVELS):
        step = omega * WIDEST / 2.0**level
        ends = [_image(gait, _at(gait, place), ("omega",), digits)[0]["omega"] for place in (omega + step, omega - step)]
        row = [(ends[0] - ends[1]) / (Decimal(omega + step) - Decimal(omega - step))]
        for k, before in enumerate(table[-1] if table else []):
            factor = Decimal(4) ** (k + 1)
            row.append((factor * row[k] - before) / (factor - 1))
        table.append(row)
    return table[-1][-1], abs(table[-1][-1] - table[-2][-1])


def _of_several(gait: Gait, names: tuple[str, ...], digits: int) -> PreciseGait:
    """Return the step of Newton's method from the doubles, which are right to rounding, with the derivative of the kernel."""
    image, word = _image(gait, gait.scenario, names, digits)
    first = {name: Decimal(getattr(gait.state, name)) for name in names}
    off = {name: image[name] - first[name] for name in names}
    if "angle" in off:
        turn = 2 * _pi(digits + 2 * SPARE)
        off["angle"] -= turn * round(off["angle"] / turn)
    step = np.linalg.solve(np.eye(len(names)) - gait.derivative.matrix, np.array([float(off[name]) for name in names]))
    state = {name: first[name] + Decimal(float(change)) for name, change in zip(names, step, strict=True)}
    return PreciseGait(state, None, None, word)


def _pi(digits: int) -> Decimal:
    import mpmath

    with mpmath.workdps(digits):
        return Decimal(mpmath.nstr(mpmath.pi, digits))
