"""Points of a section, fixed ones by Newton's method, and derivatives of the map there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.computing import check, passages
from hophoop.gaits.differences import Floats
from hophoop.gaits.kernels.layout import MODE, OMEGA
from hophoop.gaits.maps import SOLVED, Image, SectionMap, coordinates, eigenvalues, place_of
from hophoop.gaits.results import Passages
from hophoop.kernel.numerics.arithmetic import TWO_PI
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait

ON_SECTION = 1e-9  # rad: within it a start is on the section
NEARLY = 1e-11  # largest difference of a fixed point from its image that is accepted if rounding allows no less
STEPS = 25  # of Newton's method
SLOW = 0.1  # of a difference that is left by a step: then the derivative is computed again
BORDER = "the motion is on the border of two classes: on both sides the derivatives differ"


@dataclass(frozen=True, eq=False)
class Point:
    """A point of a section, a gait if the map leads back to it.

    Attributes
    ----------
    map : SectionMap
    place : ndarray
        Coordinates, and the scaled parameter if the map has one.
    """

    map: SectionMap
    place: Floats

    @cached_property
    def image(self) -> Image:
        """What follows the point."""
        return self.map(self.place)

    # --- how far the map leads away ----------------------------------------------------------------

    @property
    def comes_back(self) -> bool:
        """Whether the motion passes the section often enough, and in the end in the mode of the map."""
        return self.map.comes_back(self.image)

    def change(self, passage: int) -> Floats:
        """Return the coordinates of a passage, less those of the point."""
        place = place_of(self.map.section, self.image.rows[passage])
        return self.map.change(place, self.place[: len(self.map.names)])

    def off(self, passage: int = -1) -> float:
        """Return the largest such difference, relative to 1 + θ̇; inf in another mode."""
        row = self.image.rows[passage]
        if row[MODE] != self.map.code:
            return math.inf
        return float(np.abs(self.change(passage)).max() / (1.0 + abs(row[OMEGA])))

    @cached_property
    def apart(self) -> float:
        """The least one after a part of the period."""
        period = self.map.period
        return min((self.off(part - 1) for part in range(1, period) if period % part == 0), default=math.inf)

    # --- the derivative ----------------------------------------------------------------------------

    @cached_property
    def rates(self) -> Floats:
        """Derivative of the map by the place."""
        return self.map.rates(self.image, self.place)

    @cached_property
    def exact_rates(self) -> Floats:
        """The same from wider differences."""
        return self.map.rates(self.image, self.place, exact=True)

    @property
    def known(self) -> bool:
        """Whether the derivative exists."""
        return bool(np.isfinite(self.rates).all())

    def multipliers(self, *, exact: bool = False) -> Floats | NDArray[np.complex128]:
        """Return the eigenvalues of the derivative by the coordinates, the largest modulus first [1]."""
        rates = self.exact_rates if exact else self.rates
        return eigenvalues(rates[:, : len(rates)])

    @cached_property
    def multiplier(self) -> complex:
        """The eigenvalue of the largest modulus [1]."""
        return complex(self.multipliers()[0])

    def determinant(self, critical: float, *, exact: bool = False) -> float:
        """Return det(derivative − critical), which is 0 where a multiplier has this value; nan without a derivative."""
        rates = self.exact_rates if exact else self.rates
        return float(np.linalg.det(rates[:, : len(rates)] - critical * np.eye(len(rates))))

    @cached_property
    def tangent(self) -> Floats:
        """Unit vector along the branch."""
        found: Floats = np.linalg.svd(self.rates - np.eye(*self.rates.shape))[2][-1]
        return found

    # --- other points ------------------------------------------------------------------------------

    def solve(self, normal: Floats | None = None, rates: Floats | None = None, *, patient: bool = False) -> Point | None:
        """Return the fixed point near by, by Newton's method with a derivative that is kept while it is good enough.

        With a parameter it is that on the plane through the point with a given normal.
        patient: go on where a step leads farther away.
        """
        here, last, fresh = self, math.inf, False
        plane = np.empty((0, len(self.place))) if normal is None else normal[None]
        for _ in range(STEPS):
            if not here.comes_back:
                return None
            excess = np.append(here.change(-1), plane @ (here.place - self.place))
            size = float(np.abs(excess).max())
            slow = size > SLOW * last
            if size < SOLVED or (fresh and last <= size < NEARLY):
                return here
            if fresh and size >= last and not patient:
                return None
            fresh = rates is None or slow
            if rates is None or slow:
                rates = here.rates
            try:
                step = np.linalg.solve(np.vstack([rates - np.eye(*rates.shape), plane]), -excess)
            except np.linalg.LinAlgError:
                return None
            if not np.abs(step).max() < 1.0:  # also without a derivative, next to a border
                return here if size < NEARLY else None
            here, last = Point(self.map, here.place + step), size
        return None

    def near(self, guess: Floats, normal: Floats) -> Point | None:
        """Return the gait near a guess, on the plane through it with a normal."""
        return Point(self.map, guess).solve(normal, self.rates if self.known else None)

    def ahead(self, way: Floats, step: float) -> Point | None:
        """Return the gait a step further along a direction."""
        return self.near(self.place + step * way, way)

    def beside(self, distance: float, *ways: Floats) -> Iterator[Point]:
        """Yield the points at a distance along directions and coordinates that are on other pieces of the map."""
        for shift in (*ways, *np.eye(len(self.place)), *-np.eye(len(self.place))):
            other = Point(self.map, self.map.in_mode(self.place + distance * shift))
            if len(other.image.rows) and other.image.key != self.image.key:
                yield other

    # --- in SI units -------------------------------------------------------------------------------

    @property
    def omega(self) -> float:
        """θ̇ at the section [rad/s]."""
        return float(self.place[self.map.names.index("omega")]) * self.map.unit

    @property
    def parameter(self) -> float:
        """The parameter [SI]."""
        return float(self.place[-1]) * self.map.scale

    @property
    def gait(self) -> Gait:
        """The gait."""
        from hophoop.gaits.gait import Gait

        return Gait(passages(self.map.at(self.place), self.map.period, section=self.map.section))


def point_of(found: Passages) -> Point:
    """Return the point of the start of some passages, on the map to the last one of them."""
    mode = found.scenario.start.mode or found.sequences[0][0]
    image_of = SectionMap(found.scenario, len(found), found.section, mode)
    return Point(image_of, image_of.point(found.scenario.start))


@dataclass(frozen=True)
class SectionDerivative:
    """Derivative of the state at a passage with respect to the state at an earlier one.

    Attributes
    ----------
    matrix : ndarray, shape (rows, columns)
        In SI units; nan where there is none.
    rows : tuple of str
        Coordinates of the later passage: 'omega' [rad/s] in rolling at the bottom, with 'slip' [m/s] in slip; at a landing
        'angle' [rad], 'omega', 'slip' and 'vy' [m/s], as far as its mode leaves them free.
    columns : tuple of str
        Those of the earlier one.
    """

    matrix: Floats
    rows: tuple[str, ...]
    columns: tuple[str, ...]

    @property
    def reason(self) -> str:
        """Why there is no derivative; empty if there is one."""
        return "" if np.isfinite(self.matrix).all() else BORDER

    @cached_property
    def multipliers(self) -> Floats | NDArray[np.complex128]:
        """Eigenvalues, the largest modulus first, complex only in pairs; for a whole period of a gait its multipliers.

        Raises
        ------
        ValueError
            If both passages have different coordinates.
        """
        if self.rows != self.columns:
            raise InputError(f"multipliers need equal coordinates at both passages, not {self.columns} and {self.rows}.")
        return eigenvalues(self.matrix)


def derivative(scenario: Scenario, passages_on: int = 1, *, section: str = "bottom") -> SectionDerivative:
    """Return the derivative of the return map at a scenario's start.

    Parameters
    ----------
    scenario : Scenario
        Its start is on the section: the load at the bottom (θ = π) in contact, or a state just after a landing.
    passages_on : int, default 1
        How many passages further [1].
    section : {'bottom', 'landing'}, default 'bottom'
        As in `hophoop.passages`.

    Returns
    -------
    derivative : SectionDerivative

    Raises
    ------
    ValueError
        If the start is not on the section, or the motion has no such passage.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> start = hh.Start.rolling(3.4081869457017134, angle=math.pi)
    >>> gait = hh.Scenario(plane=hh.Plane(slope=math.radians(1), gravity=1.0), start=start)
    >>> round(float(hh.gaits.derivative(gait).matrix[0, 0]), 9)
    0.610983568
    """
    check(scenario, section)
    start = scenario.start.state(scenario.hoop)
    off = math.remainder(start.angle - math.pi, TWO_PI)
    if section == "bottom" and (abs(off) > ON_SECTION or start.height != 0.0 or start.vy != 0.0):
        raise InputError("start.angle must be pi, with start.height = start.vy = 0: the section is the load at the bottom.")
    if section == "landing" and (start.height != 0.0 or start.vy < 0.0):
        raise InputError("start.height must be 0, with start.vy at least 0: the section is just after a landing.")
    found = passages(scenario, passages_on, section=section)
    if len(found) < passages_on:
        raise InputError(f"passages_on = {passages_on} must be at most {len(found)}: the motion passes its section no more.")
    point, rows = point_of(found), coordinates(section, found.mode[-1])
    units = Units.of_scenario(scenario)
    scale = np.array([units.of(name) for name in rows])[:, None] / point.map.units
    return SectionDerivative(point.map.rates(point.image, point.place, exact=True, sided=False) * scale, rows, point.map.names)
