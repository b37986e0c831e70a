"""The posterior from a chain, against what it must be where that is known."""

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import RADIUS, filmed, hopping, posed
from hophoop.fitting import sample
from hophoop.fitting.channels import Autocorrelation
from hophoop.fitting.judging import least_static_friction
from hophoop.fitting.sampling import innovations

# a chain asks for thousands of motions
pytestmark = pytest.mark.compiled

STEPS = 300
KNOWN = {"mu_excess": 0.0, "restitution": 0.0}


def rolled(frames=40):
    """A track of a hoop that rolls for 0.9 s."""
    motion = hopping(plane=hh.Plane(mu=0.9), start=hh.Start.rolling(1.2, angle=0.1), duration=0.9)
    return filmed(motion, 2, (frames - 1) / 0.9, sigma=2e-3, sigma_angle=2e-3, frames=frames)


@pytest.fixture(scope="module")
def rolling():
    return hh.fit(rolled(), fixed=KNOWN)


@pytest.fixture(scope="module")
def sampled(rolling):
    seen = []
    found = sample(rolling, STEPS, seed=1, progress=lambda done, total: seen.append((done, total)))
    assert seen == [(k, STEPS) for k in range(1, STEPS + 1)]
    return found


@pytest.mark.long
def test_where_all_is_linear_it_is_the_normal_distribution_of_the_fit(rolling, sampled):
    assert rolling.posterior is None
    assert set(sampled.posterior.names) == {"gamma", "mu_kinetic", "x0", "angle0", "speed"}
    for name in rolling.free:
        low, middle, high = sampled.posterior.quantiles(name)
        assert middle == pytest.approx(rolling.values[name], abs=0.35 * rolling.error(name)), name
        assert 0.5 * (high - low) == pytest.approx(rolling.error(name), rel=0.25), name
    place = [sampled.posterior.names.index(name) for name in rolling.free]
    drawn = np.corrcoef(sampled.posterior.samples[:, place].T)
    size = np.sqrt(np.diag(rolling.covariance))
    assert drawn == pytest.approx(rolling.covariance / np.outer(size, size), abs=0.15)


def test_a_sequence_has_the_share_of_the_samples_whose_friction_suffices(sampled):
    posterior = sampled.posterior
    column = dict(zip(posterior.names, posterior.samples.T, strict=True))
    gamma, angle, speed = (float(np.median(column[name])) for name in ("gamma", "angle0", "speed"))
    start = hh.Start.rolling(speed, angle=angle)
    needed = least_static_friction(hopping(hh.Hoop.ideal(gamma, radius=RADIUS), hh.Plane(mu=10.0), start, 0.9))
    # the prior is flat from 0 to 3, and far below what rolling needs the film contradicts
    assert np.min(column["mu_kinetic"]) > 0.8 * needed
    assert posterior.quantiles("mu_kinetic", (0.5,))[0] == pytest.approx(0.5 * (needed + 3.0), abs=0.25)
    assert sum(posterior.shares.values()) == pytest.approx(1.0)
    assert posterior.shares["R"] == pytest.approx((column["mu_kinetic"] > needed).mean(), abs=0.03)
    assert sampled.shares == posterior.shares


@pytest.mark.long
def test_bounds_are_the_prior_and_what_is_tied_goes_along():
    known = {"fixed": {"restitution": 0.0}, "bounds": {"mu_kinetic": (0.5, 0.7)}, "tied": {"mu_excess": "gamma / 10"}}
    found = sample(hh.fit(rolled(), **known), 200).posterior
    low, middle, high = found.quantiles("mu_kinetic", (0.0, 0.5, 1.0))
    assert low >= 0.5
    assert high <= 0.7
    assert middle == pytest.approx(0.6, abs=0.04)
    assert "mu_excess" not in found.names


def test_the_same_seed_gives_the_same_chain(rolling):
    one, other, third = (sample(rolling, 20, seed=seed).posterior.samples for seed in (3, 3, 4))
    assert (one == other).all()
    assert not (one == third).all()


def test_it_is_told_and_saved(sampled, tmp_path):
    rows = {name: text for name, text, _ in sampled.rows()}
    assert " +" in rows["gamma"]
    assert " −" in rows["gamma"]
    (said,) = [sentence for sentence in sampled.sentences() if f"chain of 20 walkers and {STEPS} steps" in sentence]
    assert ("50 times as many are needed" in said) == (50 * sampled.posterior.memory > STEPS)
    assert any("of the posterior has it" in sentence for sentence in sampled.details())
    sampled.save(tmp_path / "fit.json")
    back = hh.load_fit(tmp_path / "fit.json").posterior
    assert back.shares == sampled.posterior.shares
    assert back.quantiles("gamma")[1] == pytest.approx(sampled.posterior.quantiles("gamma")[1], rel=1e-3)
    assert back.memory == sampled.posterior.memory
    with pytest.raises(ValueError, match="'slope' was not sampled"):
        back.quantiles("slope")


def test_news_of_lasting_errors_have_their_likelihood():
    """The sum of the squares of the innovations is rᵀ P⁻¹ r with all of P written down."""
    track = rolled(20)
    problem, _ = posed(track)
    off = np.random.default_rng(3).normal(size=problem.count)
    memory = [Autocorrelation(1.0, 0.6), Autocorrelation(0.0, 0.0), Autocorrelation(0.4, 0.8)]
    found = innovations(problem, off, memory)
    apart = np.abs(np.subtract.outer(np.arange(20), np.arange(20)))
    for k, (share, fade) in enumerate(memory):
        own, part = off[20 * k : 20 * k + 20], found[20 * k : 20 * k + 20]
        whole = np.where(apart == 0, 1.0, share * fade ** apart.astype(float))
        assert part == pytest.approx(np.linalg.solve(np.linalg.cholesky(whole), own), rel=1e-9)


def test_bad_values(rolling):
    for options, message in (({"steps": 2}, "steps = 2 must be from 10"), ({"walkers": 3}, "from 10, twice the number")):
        with pytest.raises(ValueError, match=message):
            sample(rolling, **options)
