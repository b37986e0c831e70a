"""Sample the posterior of a fit with an ensemble sampler (emcee)."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.fitting.channels import Autocorrelation
from hophoop.fitting.covariance import autocorrelations
from hophoop.fitting.guess import merge_bounces
from hophoop.fitting.losses import influence, loss
from hophoop.fitting.posterior import Posterior
from hophoop.fitting.problem import Problem
from hophoop.fitting.result import Fit
from hophoop.fitting.solving import Choice, complete
from hophoop.scenario import InputError

Floats = NDArray[np.float64]

LEAST_STEPS, MOST_STEPS = 10, 1_000_000
BURNT = 0.25  # share of the steps dropped at the start
DRAWN = 1000  # samples for the shares of sequences
TRIES, NEAR = 60, 25.0  # draws of a walker's start, and its maximum rise of the sum of squares


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
        If emcee is missing.
    """
    emcee = need("emcee", "fit")
    problem, choice = fit.problem, fit.choice
    names = choice.free
    if not names:
        raise InputError("Nothing was fitted, so there is nothing to sample.")
    count = 4 * len(names) if walkers is None else walkers
    if not LEAST_STEPS <= steps <= MOST_STEPS:
        raise InputError.of_field("steps", steps, f"from {LEAST_STEPS} to {MOST_STEPS:,}")
    if not 2 * len(names) <= count <= 10_000:
        raise InputError.of_field("walkers", count, f"from {2 * len(names)}, twice the number of parameters, to 10,000")
    likelihood = _likelihood(fit, problem, choice)
    rng = np.random.default_rng(seed)
    begin = _places(fit, choice, likelihood, count, rng)
    moves = [(emcee.moves.DEMove(), 0.8), (emcee.moves.DESnookerMove(), 0.2)] if count > 5 else None
    sampler = emcee.EnsembleSampler(count, len(names), likelihood, moves=moves)
    sampler.log_prob_fn = likelihood  # emcee's own prints a traceback at Ctrl-C
    sampler.random_state = np.random.RandomState(seed).get_state()
    for done, _ in enumerate(sampler.sample(begin, iterations=steps), 1):
        if progress is not None:
            progress(done, steps)
    memory = float(np.max(sampler.get_autocorr_time(tol=0, quiet=True)))
    samples = sampler.get_chain(discard=int(BURNT * steps), flat=True)
    found = Posterior(
        names,
        samples,
        _shares(problem, choice, samples, rng),
        steps,
        count,
        memory if np.isfinite(memory) else float(steps),
        float(np.mean(sampler.acceptance_fraction)),
    )
    return dataclasses.replace(fit, posterior=found, shares=found.shares)


def _likelihood(fit: Fit, problem: Problem, choice: Choice) -> Callable[[Floats], float]:
    """Logarithm of the posterior up to a constant; −∞ outside the bounds."""
    names, robust = choice.free, bool(fit.settings["robust"])
    low, high = (np.array([choice.limits(name)[k] for name in names]) for k in (0, 1))
    off = problem.residuals(fit.values)
    memory = autocorrelations(problem, influence(off) if robust else off)
    scale = fit.inflation

    def likelihood(place: Floats) -> float:
        if (place < low).any() or (place > high).any():
            return -np.inf
        values = complete(choice, dict(zip(names, place.tolist(), strict=True)))
        fresh = innovations(problem, problem.residuals(values), memory)
        return -0.5 * loss(fresh, robust) / scale**2

    return likelihood


def innovations(problem: Problem, residuals: Floats, memory: dict[str, Autocorrelation]) -> Floats:
    """Innovation of each residual given those before it, in standard deviations.

    Errors are a correlated share and independent noise, so a Kalman filter predicts each from those before.

    residuals shape (count,) [1]; memory: by quantity [1]; innovations: shape (count,), the residuals themselves without
    autocorrelation [1].
    """
    result, begin = residuals.copy(), 0
    for channel in problem.channels:
        share, fade = memory[channel.name]
        if share:
            own = residuals[begin : begin + len(channel.rows)].tolist()
            fading = [0.0, *(fade ** np.diff(channel.rows).astype(float)).tolist()]
            expected, unsure = 0.0, share
            for k, value in enumerate(own):
                expected, unsure = fading[k] * expected, share + fading[k] ** 2 * (unsure - share)
                spread = unsure + 1.0 - share
                result[begin + k] = (value - expected) / spread**0.5
                expected, unsure = expected + unsure / spread * (value - expected), unsure * (1.0 - share) / spread
        begin += len(channel.rows)
    return result


def _places(fit: Fit, choice: Choice, likelihood: Callable[[Floats], float], count: int, rng: np.random.Generator) -> Floats:
    """Starts of the walkers: around the minimum, and anywhere along parameters that the data do not determine."""
    names = choice.free
    best = np.array([fit.values[name] for name in names])
    seen = [names.index(name) for name in fit.free]
    spread = np.zeros((len(names), len(names)))
    spread[np.ix_(seen, seen)] = fit.covariance
    size, vectors = np.linalg.eigh(0.5 * (spread + spread.T))
    root = vectors * np.sqrt(np.maximum(size, 0.0))
    top = likelihood(_inside(choice, best))
    result = []
    for _ in range(count):
        for _ in range(TRIES):
            place = best + root @ rng.normal(size=len(names))
            for k, name in enumerate(names):
                if k not in seen:
                    low, high = choice.limits(name)
                    limit = fit.limits.get(name, ("", np.nan))[1]
                    ends = (min(best[k], limit), max(best[k], limit)) if np.isfinite(limit) else (low, high)
                    place[k] = rng.uniform(*np.clip(ends, -1e3, 1e3))
            place = _inside(choice, place)
            if likelihood(place) > top - NEAR:
                break
        else:
            place = _inside(choice, best + 1e-3 * (root @ rng.normal(size=len(names))))
        result.append(place)
    return np.array(result)


def _inside(choice: Choice, place: Floats) -> Floats:
    limits = np.array([choice.limits(name) for name in choice.free])
    return np.asarray(np.clip(place, limits[:, 0], limits[:, 1]), dtype=float)


def _shares(problem: Problem, choice: Choice, samples: Floats, rng: np.random.Generator) -> dict[str, float]:
    found: dict[str, int] = {}
    for place in samples[rng.choice(len(samples), min(DRAWN, len(samples)), replace=False)]:
        values = complete(choice, dict(zip(choice.free, place.tolist(), strict=True)))
        sequence = merge_bounces(problem.motion(values).sequence)
        found[sequence] = found.get(sequence, 0) + 1
    total = sum(found.values())
    return {name: number / total for name, number in sorted(found.items(), key=lambda item: -item[1])}
