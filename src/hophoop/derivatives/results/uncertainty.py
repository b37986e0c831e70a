"""Uncertainty of a motion from that of its parameters: their spread times the derivatives, to first order."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support import tables
from hophoop.derivatives.results.propagation import propagate
from hophoop.derivatives.results.quantities import AT_TIMES
from hophoop.derivatives.results.sensitivity import Sensitivity, agree, names_of, sensitivity_of
from hophoop.kernel.numerics.arithmetic import matrix_product, weighted_sum
from hophoop.results.records import Motion, documented
from hophoop.scenario import InputError
from hophoop.vocabulary.quantities import QUANTITIES

Floats = NDArray[np.float64]


@documented("ndarray, shape (m,)")
@dataclass(frozen=True)
class Deviations:
    """Standard deviations of the state and energies at some times."""

    t: Floats
    x: Floats
    height: Floats
    angle: Floats
    vx: Floats
    vy: Floats
    omega: Floats
    slip: Floats
    kinetic: Floats
    potential: Floats
    total: Floats
    friction: Floats
    impact_normal: Floats
    impact_tangential: Floats
    rolling_resistance: Floats

    def __repr__(self) -> str:
        found = {name: np.max(values, initial=0.0) for name, values in vars(self).items() if name != "t"}
        rows = [(name, f"{most:.3g} {QUANTITIES[name].unit}") for name, most in found.items() if most]
        return tables.report(f"Standard deviations at {np.size(self.t)} times, at most", rows, left=(0, 1))


@dataclass(frozen=True)
class Uncertainty:
    """The spread of a motion's parameters, and what it makes of the motion; made by `Trajectory.uncertainty`.

    Attributes
    ----------
    motion : Motion
    wrt : tuple of str
        The uncertain parameters.
    parameter_covariance : ndarray, shape (m, m)
        Of the parameters [products of their units].
    """

    motion: Motion
    wrt: tuple[str, ...]
    parameter_covariance: Floats

    def sensitivity(self, of: str | Sequence[str]) -> Sensitivity:
        """The derivatives that the answers rest on, with the reasons where there are none.

        Parameters
        ----------
        of : str or sequence of str
            As `Trajectory.sensitivity` takes them.

        Returns
        -------
        sensitivity : Sensitivity

        Raises
        ------
        ValueError
            If there is no such quantity.
        """
        return sensitivity_of(self.motion, of, self.wrt)

    def covariance(self, of: str | Sequence[str]) -> Floats:
        """Covariance of some quantities.

        Parameters
        ----------
        of : str or sequence of str

        Returns
        -------
        covariance : ndarray, shape (n, n)
            nan where a quantity has no derivative [products of their units].

        Raises
        ------
        ValueError
            If there is no such quantity.
        """
        slopes = self.sensitivity(of).derivatives
        return matrix_product(matrix_product(slopes, self.parameter_covariance), slopes.T)

    def deviation(self, of: str | Sequence[str]) -> Floats:
        """Standard deviations of some quantities.

        Parameters
        ----------
        of : str or sequence of str

        Returns
        -------
        deviations : ndarray, shape (n,)
            nan where a quantity has no derivative [units of the quantities].

        Raises
        ------
        ValueError
            If there is no such quantity.
        """
        result: Floats = np.sqrt(np.diag(self.covariance(of)))
        return result

    def shares(self, of: str) -> dict[str, float]:
        """The standard deviation of a quantity that each parameter would make alone.

        Parameters
        ----------
        of : str

        Returns
        -------
        shares : dict of str to float
            By parameter [unit of the quantity].

        Raises
        ------
        ValueError
            If there is no such quantity.
        """
        slopes = self.sensitivity(of).derivatives[0]
        spread = np.sqrt(np.diag(self.parameter_covariance))
        return {path: float(abs(slope) * each) for path, slope, each in zip(self.wrt, slopes, spread, strict=True)}

    def at(self, t: ArrayLike, side: str = "right") -> Deviations:
        """Standard deviations of the state at some times.

        Parameters
        ----------
        t : float or array_like
            Times from 0 to the end of the motion [s].
        side : {'right', 'left'}
            At an event: just after or just before it.

        Returns
        -------
        deviations : Deviations

        Raises
        ------
        ValueError
            If a time is outside the motion or `side` is neither.
        """
        if side not in ("left", "right"):
            raise InputError.of_field("side", side, "'left' or 'right'")
        times = np.atleast_1d(np.asarray(t, float))
        self.motion.at(times)  # refuses times outside
        rates = _rates_at(self.motion, self.wrt, times, side == "left")
        found = {name: np.sqrt(np.maximum(self._variances(slopes), 0.0)) for name, slopes in rates.items()}
        return Deviations(t=times, **found)

    def _variances(self, slopes: Floats) -> Floats:
        """Return the variances of quantities with these derivatives, one row each."""
        columns = matrix_product(slopes, self.parameter_covariance)
        result: Floats = weighted_sum(columns.T, slopes.T)
        return result


def _rates_at(motion: Motion, paths: Sequence[str], times: Floats, left: bool) -> dict[str, Floats]:
    """Derivatives at times; nan where the two sides differ."""
    larger = propagate(motion, paths)
    rates = {name: slopes for name, (_, slopes) in larger.at_times(times, AT_TIMES, left).items()}
    sides = larger.one_sided
    if sides:
        smaller = propagate(motion, [paths[k] for k in sides], -1.0).at_times(times, AT_TIMES, left)
        for name, slopes in rates.items():
            up, down = slopes[:, sides], smaller[name][1]
            slopes[:, sides] = np.where(agree(up, down), up, np.nan)
    return rates


def uncertainty_of(
    motion: Motion, spread: Mapping[str, float], correlations: Mapping[tuple[str, str], float] | None = None
) -> Uncertainty:
    """Return the uncertainty of a motion: see `Trajectory.uncertainty`.

    Parameters
    ----------
    motion : Motion
        With rigid contact.
    spread : mapping of str to float
        Standard deviations of parameters by path [their units].
    correlations : mapping of (str, str) to float, optional
        Between −1 and 1 [1].

    Returns
    -------
    uncertainty : Uncertainty

    Raises
    ------
    ValueError
        If a deviation is negative, a path no parameter, a correlation not possible, or the contact compliant.
    """
    paths = names_of(tuple(spread), "the uncertain parameters")
    for path, deviation in spread.items():
        if not 0.0 <= deviation < math.inf:
            raise InputError(f"{path}: the standard deviation {deviation!r} must be finite and not negative.")
    matrix = np.eye(len(paths))
    for (one, other), value in (correlations or {}).items():
        if one not in paths or other not in paths or one == other:
            raise InputError(f"correlations: {one!r} and {other!r} must be two of {', '.join(paths)}.")
        if not -1.0 <= value <= 1.0:
            raise InputError(f"correlations: {value!r} of {one} and {other} must be from -1 to 1.")
        if correlations and correlations.get((other, one), value) != value:
            raise InputError(f"correlations: {one} and {other} must have one correlation, in whichever order they are named.")
        i, k = paths.index(one), paths.index(other)
        matrix[i, k] = matrix[k, i] = value
    if np.linalg.eigvalsh(matrix)[0] < -1e-12:  # noqa: TID251 - decides only whether to refuse
        raise InputError("correlations: no parameters can be correlated like that; the matrix has a negative eigenvalue.")
    sizes = np.array([spread[path] for path in paths])
    propagate(motion, paths)  # refuses those that are not possible
    return Uncertainty(motion, paths, matrix * np.outer(sizes, sizes))
