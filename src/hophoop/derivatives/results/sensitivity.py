"""The derivatives of some quantities of a motion with respect to some parameters: `motion.sensitivity`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support import tables
from hophoop.derivatives.layout import REASONS, Reason
from hophoop.derivatives.parameters import allowed_sides, value_of
from hophoop.derivatives.results.propagation import TangentSolution, WithDerivatives, propagate
from hophoop.derivatives.results.quantities import quantity, unit_of_quantity
from hophoop.results.records import Motion
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.paths import parameter

Floats = NDArray[np.float64]
AGREE = 1e-9  # relative: the derivatives of two sides that differ by less are one
EDGE = "the parameter is at the edge of what is allowed"
SIDED = "the derivatives of the two sides differ"


@dataclass(frozen=True)
class Sensitivity:
    """Derivatives of quantities of a motion with respect to parameters of its scenario.

    Indexed by a quantity and a parameter it gives one derivative: ``result["takeoff.angle", "plane.mu"]``.

    Attributes
    ----------
    scenario : Scenario
        Of the motion.
    of : tuple of str
        Quantities.
    wrt : tuple of str
        Parameters.
    values : ndarray, shape (n,)
        The quantities [SI, see `units`].
    at : ndarray, shape (m,)
        The parameters [SI, see `wrt_units`].
    derivatives : ndarray, shape (n, m)
        nan where there is none, see `reasons` [unit of the quantity over that of the parameter].
    smaller, larger : ndarray, shape (n, m)
        The one-sided derivatives, towards smaller and larger parameters; both are `derivatives` where that exists
        [as derivatives].
    reasons : tuple of tuple of str
        Why a derivative is nan; empty where it is a number.
    units, wrt_units : tuple of str
        SI units of the quantities and of the parameters.

    Examples
    --------
    >>> import hophoop as hh
    >>> motion = hh.simulate(hh.Scenario(duration=2.0))
    >>> result = motion.sensitivity(of=["takeoff.angle", "hop.height"], wrt=["start.speed", "plane.mu"])
    >>> round(result["takeoff.angle", "plane.mu"], 6)
    0.221788
    """

    scenario: Scenario
    of: tuple[str, ...]
    wrt: tuple[str, ...]
    values: Floats
    at: Floats
    derivatives: Floats
    smaller: Floats
    larger: Floats
    reasons: tuple[tuple[str, ...], ...]
    units: tuple[str, ...]
    wrt_units: tuple[str, ...]

    def __getitem__(self, key: tuple[str, str]) -> float:
        of, wrt = key
        if of not in self.of or wrt not in self.wrt:
            raise KeyError(f"{of!r} by {wrt!r} was not asked for.")
        return float(self.derivatives[self.of.index(of), self.wrt.index(wrt)])

    def relative(self) -> Floats:
        """By how many per cent a quantity changes when a parameter changes by one per cent.

        Returns
        -------
        elasticities : ndarray, shape (n, m)
            derivative × parameter / quantity [1].
        """
        with np.errstate(divide="ignore", invalid="ignore"):
            result: Floats = self.derivatives * self.at[None, :] / self.values[:, None]
        return result

    def to_dict(self) -> dict[str, Any]:
        """The derivatives as JSON.

        Returns
        -------
        result : dict
            Numbers in SI units; None where there is no derivative, with its reason [1].
        """
        rows = []
        for i, of in enumerate(self.of):
            for k, wrt in enumerate(self.wrt):
                row: dict[str, Any] = {"of": of, "wrt": wrt, "derivative": _number(self.derivatives[i, k])}
                if self.reasons[i][k]:
                    row |= {"reason": self.reasons[i][k], "smaller": _number(self.smaller[i, k])}
                    row["larger"] = _number(self.larger[i, k])
                rows.append(row)
        values = [{"of": of, "value": float(v), "unit": u} for of, v, u in zip(self.of, self.values, self.units, strict=True)]
        at = [{"wrt": wrt, "value": float(v), "unit": u} for wrt, v, u in zip(self.wrt, self.at, self.wrt_units, strict=True)]
        return {"quantities": values, "parameters": at, "derivatives": rows}

    def __str__(self) -> str:
        width = max(len(name) for name in self.of)
        return "\n".join(f"{of:<{width}}  {by}: {told}" for of, by, told in self._rows())

    def __repr__(self) -> str:
        return tables.report("Sensitivity of a motion", self._rows(), left=(0, 1, 2))

    def _repr_html_(self) -> str:
        return tables.html(self._rows(), left=(0, 1, 2))

    def _rows(self) -> list[tuple[str, str, str]]:
        return [(of, f"by {wrt}", self._told(i, k)) for i, of in enumerate(self.of) for k, wrt in enumerate(self.wrt)]

    def _told(self, i: int, k: int) -> str:
        unit = _over(self.units[i], self.wrt_units[k])
        if not self.reasons[i][k]:
            return f"{self.derivatives[i, k]:+.9g} {unit}"
        sides = [
            f"; towards {side} values {table[i, k]:+.9g} {unit}"
            for side, table in (("smaller", self.smaller), ("larger", self.larger))
            if np.isfinite(table[i, k])
        ]
        return "".join([f"none, {self.reasons[i][k]}", *sides])


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _over(unit: str, by: str) -> str:
    return unit if by == "1" else f"{unit}/({by})"


@lru_cache(maxsize=256)
def _unit_of_parameter(path: str) -> str:
    return parameter(path).unit


def agree(one: Floats, other: Floats) -> NDArray[np.bool_]:
    """Return where the derivatives of two sides are one."""
    return np.abs(one - other) <= AGREE * np.maximum(np.abs(one), np.abs(other))


def names_of(given: str | Sequence[str], what: str) -> tuple[str, ...]:
    """Names as a tuple, of one name or some.

    Parameters
    ----------
    given : str or sequence of str
    what : str
        What an error calls them.

    Returns
    -------
    names : tuple of str

    Raises
    ------
    ValueError
        If there is none, or one comes twice.
    """
    names = (given,) if isinstance(given, str) else tuple(given)
    if not names or len(set(names)) != len(names):
        raise InputError(
            f"{what} = {list(names)!r} must name at least one thing, and none twice.", field=what, value=list(names)
        )
    return names


def sensitivity_of(motion: Motion, of: str | Sequence[str], wrt: str | Sequence[str]) -> Sensitivity:
    """Derivatives of quantities of a motion: see `Trajectory.sensitivity`.

    Parameters
    ----------
    motion : Motion
        With rigid contact.
    of, wrt : str or sequence of str
        Quantities and parameters.

    Returns
    -------
    sensitivity : Sensitivity

    Raises
    ------
    ValueError
        If a name is unknown, the motion has no such event, or its contact is compliant.
    """
    quantities, paths = names_of(of, "of"), names_of(wrt, "wrt")
    larger = propagate(motion, paths)
    reads = [quantity(motion, name) for name in quantities]
    derived = [read(larger) for read in reads]
    values = np.array([each.value for each in derived])
    upward = np.array([each.rates for each in derived])
    downward = np.array([_downward(each) for each in derived])
    sides = larger.one_sided
    if sides:
        smaller = propagate(motion, [paths[k] for k in sides], -1.0)
        downward[:, sides] = np.array([_downward(read(smaller)) for read in reads])
    at = [value_of(motion.scenario, path) for path in paths]
    sided = np.array([allowed_sides(motion.scenario, path, value) for path, value in zip(paths, at, strict=True)])
    downward[:, ~sided[:, 0]] = np.nan
    upward[:, ~sided[:, 1]] = np.nan
    same = agree(upward, downward)
    derivatives = np.where(same, upward, np.nan)
    neither = (np.isnan(upward) & np.isnan(downward)).tolist()
    reasons = [[""] * len(paths) for _ in quantities]
    for k in np.flatnonzero(~same.all(axis=0)).tolist():
        own = _reason(larger, k)
        at_edge, fixed = not sided[k].all(), not sided[k].any()
        for i in np.flatnonzero(~same[:, k]).tolist():
            reasons[i][k] = EDGE if fixed or (at_edge and not neither[i][k]) else own
    return Sensitivity(
        motion.scenario, quantities, paths, values, np.array(at),
        derivatives, downward, upward, tuple(map(tuple, reasons)),
        tuple(unit_of_quantity(name) for name in quantities), tuple(_unit_of_parameter(path) for path in paths),
    )  # fmt: skip


def _downward(derived: WithDerivatives) -> Floats:
    return derived.rates if derived.smaller is None else derived.smaller


def _reason(solution: TangentSolution, k: int) -> str:
    reason = int(solution.reasons[k])
    return REASONS[Reason(reason)] if reason > 0 else SIDED
