"""Sample the posterior of a fit with emcee, through lmfit."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.fitting.channels import Autocorrelation
from hophoop.fitting.covariance import autocorrelations
from hophoop.fitting.judging import count_sequences
from hophoop.fitting.losses import loss
from hophoop.fitting.parameters import parts_of
from hophoop.fitting.problem import Problem
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from hophoop.fitting.result import Fit

Floats = NDArray[np.float64]

LEAST_STEPS, MOST_STEPS = 10, 1_000_000
BURNT = 0.25  # share of the steps dropped at the start
DRAWN = 1000  # samples for the shares of sequences
TRIES, NEAR = 60, 25.0  # draws of a walker's start, and its maximum rise of the sum of squares
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
        parts = parts_of(name)
        if not set(parts) <= set(self.names):
            raise InputError(f"{name!r} was not sampled; sampled were {', '.join(self.names)}.")
        column = self.samples[:, [self.names.index(part) for part in parts]].sum(axis=1)
        return tuple(np.quantile(column, shares).tolist())

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary, with long chains thinned.

        Returns
        -------
        posterior : dict
            Ready for `json.dumps`; SI units and radians.
        """
        step = max(1, -(-len(self.samples) // KEPT))
        return dataclasses.asdict(self) | {"names": list(self.names), "samples": self.samples[::step].tolist()}


def posterior_from_dict(data: dict[str, Any]) -> Posterior:
    """Return the posterior that `Posterior.to_dict` wrote."""
    samples = np.array(data["samples"], dtype=float).reshape(-1, len(data["names"]))
    return Posterior(**data | {"names": tuple(data["names"]), "samples": samples})


def sample(
    fit: Fit,
    steps: int = 1000,
    walkers: int | None = None,
    seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> Fit:
    """Return the fit with its posterior from a chain, which has curved and one-sided uncertainties.

    All free parameters of the fit are sampled, also those with a limit or without effect. The prior is uniform within the
    bounds.

    Parameters
    ----------
    fit : Fit
    steps : int, default 1000
        Steps of each walker [1].
    walkers : int, optional
        By default four times the number of parameters [1].
    seed : int, default 0
        Seed of the draws [1].
    progress : callable, optional
        Called with the number of steps done and of all.

    Returns
    -------
    fit : Fit
        With `posterior`, and with `shares` from it.

    Raises
    ------
    ValueError
        If there are too few or too many steps or walkers, or nothing was fitted.
    ImportError
        If lmfit or emcee is missing.
    """
    problem, params, names = fit.problem, fit.params, tuple(fit.settings["free"])
    if not names:
        raise InputError("Nothing was fitted, so there is nothing to sample.")
    count = 4 * len(names) if walkers is None else walkers
    if not LEAST_STEPS <= steps <= MOST_STEPS:
        raise InputError.of_field("steps", steps, f"from {LEAST_STEPS} to {MOST_STEPS:,}")
    if not 2 * len(names) <= count <= 10_000:
        raise InputError.of_field("walkers", count, f"from {2 * len(names)}, twice the number of parameters, to 10,000")
    # not by lmfit's own call, which has other moves, no progress, and prints a traceback at Ctrl-C
    emcee = need("emcee", "fit")
    ends = np.array([(params[name].min, params[name].max) for name in names])
    memory, scale = autocorrelations(problem, problem.residuals(fit.values), fit.settings["robust"]), fit.inflation

    def values_at(place: Floats) -> dict[str, float]:
        for name, value in zip(names, place.tolist(), strict=True):
            params[name].value = value
        return dict(params.valuesdict())

    def likelihood(place: Floats) -> float:
        """Logarithm of the posterior up to a constant; −∞ outside the bounds."""
        if (place < ends[:, 0]).any() or (place > ends[:, 1]).any():
            return -np.inf
        fresh = innovations(problem, problem.residuals(values_at(place)), memory)
        return -0.5 * loss(fresh, fit.settings["robust"]) / scale**2

    rng = np.random.default_rng(seed)
    begin = _begin(fit, names, ends, likelihood, count, rng)
    moves = [(emcee.moves.DEMove(), 0.8), (emcee.moves.DESnookerMove(), 0.2)] if count > 5 else None
    sampler = emcee.EnsembleSampler(count, len(names), likelihood, moves=moves)
    sampler.log_prob_fn = likelihood  # emcee's own prints a traceback at Ctrl-C
    sampler.random_state = np.random.RandomState(seed).get_state()
    for done, _ in enumerate(sampler.sample(begin, iterations=steps), 1):
        if progress is not None:
            progress(done, steps)
    longest = float(np.max(sampler.get_autocorr_time(tol=0, quiet=True)))
    samples = sampler.get_chain(discard=int(BURNT * steps), flat=True)
    some = samples[rng.choice(len(samples), min(DRAWN, len(samples)), replace=False)]
    parts = count_sequences(problem, [values_at(one) for one in some])
    acceptance = float(np.mean(sampler.acceptance_fraction))
    found = Posterior(names, samples, parts, steps, count, longest if np.isfinite(longest) else float(steps), acceptance)
    return dataclasses.replace(fit, posterior=found, shares=parts)


def innovations(problem: Problem, residuals: Floats, memory: list[Autocorrelation]) -> Floats:
    """Innovation of each residual given those before it, in standard deviations.

    Errors are a correlated share and independent noise, so a Kalman filter predicts each from those before.

    memory: by piece; innovations: shape (count,), the residuals themselves without autocorrelation [1].
    """
    result = residuals.copy()
    for (_, channel, part), (share, fade) in zip(problem.pieces, memory, strict=True):
        if share:
            fading = [0.0, *(fade ** np.diff(channel.rows).astype(float)).tolist()]
            expected, unsure = 0.0, share
            for k, value in enumerate(residuals[part].tolist()):
                expected, unsure = fading[k] * expected, share + fading[k] ** 2 * (unsure - share)
                spread = unsure + 1.0 - share
                result[part.start + k] = (value - expected) / spread**0.5
                expected, unsure = expected + unsure / spread * (value - expected), unsure * (1.0 - share) / spread
    return result


def _begin(
    fit: Fit, names: tuple[str, ...], ends: Floats, likelihood: Callable[[Floats], float], count: int, rng: np.random.Generator
) -> Floats:
    """Starts of the walkers: around the minimum, and anywhere along parameters that the data do not determine."""
    best = np.array([fit.values[name] for name in names])
    seen = [names.index(name) for name in fit.free]
    unseen = [k for k in range(len(names)) if k not in seen]
    spread = np.zeros((len(best), len(best)))
    spread[np.ix_(seen, seen)] = fit.covariance
    reach = np.clip(ends, -1e3, 1e3)
    for k in unseen:
        limit = fit.limits.get(names[k], ("", np.nan))[1]
        if np.isfinite(limit):
            reach[k] = sorted((best[k], limit))

    def drawn(share: float, number: int) -> Floats:
        return rng.multivariate_normal(best, share * spread, number, check_valid="ignore", method="eigh")

    least = likelihood(np.clip(best, *ends.T)) - NEAR
    places = drawn(1.0, TRIES * count)
    low, high = reach[unseen].T
    places[:, unseen] = rng.uniform(low, high, (len(places), len(unseen)))
    good = list(islice((place for place in places.clip(*ends.T) if likelihood(place) > least), count))
    return np.array([*good, *drawn(1e-6, count - len(good)).clip(*ends.T)])
