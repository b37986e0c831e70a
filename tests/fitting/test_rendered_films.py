"""From a rendered film to parameters: the truth within the uncertainties that are told."""

import dataclasses

import numpy as np
import pytest

import hophoop as hh
from film_maker import Film, article_like, make, project
from hophoop.tracking import Hints

pytestmark = pytest.mark.compiled

RADIUS = 0.3
TRUTH = {"gamma": 0.6, "mu_kinetic": 0.45, "mu_excess": 0.1, "restitution": 0.3, "scale": 1.0, "slope": 0.0, "tilt": 0.0}
# slips, hops and bounces, with marker and hoop away for a while
HOPPING = Film(
    size=(848, 480), scale=220.0, origin=(80.0, 400.0), focal=760.0, frames=240, marker_size=0.04, busy=True,
    hidden=((60, 70),), without=((100, 103),),
)  # fmt: skip
ROCKING = Film(frames=100, rate=60.0, shutter=1 / 500, origin=(150.0, 240.0), busy=True, marker_size=0.04)


def tracked(path, motion, film):
    return hh.track(make(path, motion, film), RADIUS, Hints(exposure=film.shutter))


def hopping(folder, seed):
    """A fit to a film of its own background, noise, start and place in the picture."""
    rng = np.random.default_rng(100 + seed)
    motion = article_like(speed=1.9 + rng.uniform(-0.1, 0.1), angle=rng.uniform(-0.1, 0.2))
    origin = (80 + rng.uniform(0, 1), 400 + rng.uniform(0, 1))
    return hh.fit(tracked(folder / "film.mp4", motion, dataclasses.replace(HOPPING, seed=seed + 1, origin=origin)))


def pulls(fit):
    """Errors over uncertainties; nan where the film says nothing."""
    return [(fit.values[name] - true) / fit.error(name) if name in fit.free else np.nan for name, true in TRUTH.items()]


@pytest.mark.long
def test_a_film_of_a_hoop_that_rocks(tmp_path):
    """Let go beside its lowest place it rolls to and fro about that, and never slips."""
    motion = hh.simulate(hh.Hoop.ideal(0.6, radius=RADIUS), hh.Plane(mu=0.6), hh.Start(angle=2.2), duration=2.0)
    assert [event.kind for event in motion.events] == ["start", "turn", "turn", "end"]
    track = tracked(tmp_path / "film.mp4", motion, ROCKING)
    state = motion.at(track.t)
    assert track.found.all()
    assert np.hypot(*(track.pixel - project(ROCKING, state.x, state.height + RADIUS)).T).max() < 0.2
    assert np.nanstd(track.angle - state.angle) < 3e-3
    fit = hh.fit(track)
    assert fit.good
    assert fit.motion.sequence == "R"
    assert len(fit.motion.find("turn")) == 2
    assert np.nanmax(np.abs(pulls(fit))) < 4
    first = motion.at(track.t[0])
    assert abs(fit.values["angle0"] - first.angle) < 4 * fit.error("angle0")
    assert abs(fit.values["speed"] - first.vx) < 4 * fit.error("speed")
    assert fit.error("gamma") < 1e-3
    # the friction that rolling to and fro asks for is greatest where the force along the plane is
    all_of_it = motion.at(motion.times(4000))
    asked = np.max(np.abs(all_of_it.friction_force / all_of_it.normal_force))
    sign, least = fit.limits["mu_static"]
    assert sign == "≥"
    assert 0.9 * asked < least < 1.005 * asked


@pytest.mark.slow
def test_pulls_of_rendered_films(tmp_path):
    found = np.array([pulls(hopping(tmp_path, seed)) for seed in range(8)])
    assert np.isfinite(found[:, :3]).all()
    # with the scale held, that of static friction was 5
    assert np.nanmax(np.abs(found)) < 3.5
    assert np.sqrt(np.nanmean(found**2, axis=0)).max() < 1.8
    assert np.sqrt(np.nanmean(found**2)) == pytest.approx(1.0, abs=0.35)
