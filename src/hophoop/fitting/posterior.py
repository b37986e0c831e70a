"""Posterior of the parameters from a chain: quantiles, and the share of each sequence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError

Floats = NDArray[np.float64]

LONG = 50.0  # autocorrelation times that a chain should have
KEPT = 4000  # maximum number of saved samples


@dataclass(frozen=True, eq=False)
class Posterior:
    """Samples of the posterior of the parameters.

    Attributes
    ----------
    names : tuple of str
        Names of the sampled parameters.
    samples : ndarray, shape (n, len(names))
        [SI units]
    shares : dict of float
        Sequences of the sampled motions, bounces in a row as one 'H+', and their shares [1].
    steps, walkers : int
        Size of the chain [1].
    memory : float
        Longest autocorrelation time [steps].
    acceptance : float
        Share of accepted steps [1].
    """

    names: tuple[str, ...]
    samples: Floats
    shares: dict[str, float]
    steps: int
    walkers: int
    memory: float
    acceptance: float

    @property
    def long_enough(self) -> bool:
        """True if the chain has at least 50 times its autocorrelation time, so that its quantiles are reliable."""
        return self.steps > LONG * self.memory

    def quantiles(self, name: str, shares: tuple[float, ...] = (0.16, 0.5, 0.84)) -> tuple[float, ...]:
        """Return quantiles of a parameter.

        Parameters
        ----------
        name : str
            A sampled parameter, or mu_static.
        shares : tuple of float, default (0.16, 0.5, 0.84)
            [1]

        Returns
        -------
        values : tuple of float
            [SI units]

        Raises
        ------
        ValueError
            If the parameter was not sampled.
        """
        if name == "mu_static" and {"mu_kinetic", "mu_excess"} <= set(self.names):
            column = self.samples[:, [self.names.index(part) for part in ("mu_kinetic", "mu_excess")]].sum(axis=1)
        elif name in self.names:
            column = self.samples[:, self.names.index(name)]
        else:
            raise InputError(f"{name!r} was not sampled; sampled were {', '.join(self.names)}.")
        return tuple(float(value) for value in np.quantile(column, shares))

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary, with long chains thinned.

        Returns
        -------
        posterior : dict
            Ready for `json.dumps`; SI units and radians.
        """
        step = max(1, -(-len(self.samples) // KEPT))
        return {
            "names": list(self.names),
            "samples": self.samples[::step].tolist(),
            "shares": self.shares,
            "steps": self.steps,
            "walkers": self.walkers,
            "memory": self.memory,
            "acceptance": self.acceptance,
        }


def posterior_from_dict(data: Any) -> Posterior:
    """Return the posterior that `Posterior.to_dict` wrote."""
    samples = np.array(data["samples"], dtype=float).reshape(-1, len(data["names"]))
    numbers = (int(data["steps"]), int(data["walkers"]), float(data["memory"]), float(data["acceptance"]))
    return Posterior(tuple(data["names"]), samples, dict(data["shares"]), *numbers)
