"""Motions of a known hoop, and tracks of them as films would give them."""

import numpy as np

import hophoop as hh
from hophoop.tracking.table import track_of

RADIUS = 0.3
SIGMA, SIGMA_ANGLE = 1e-3, 3e-3
TRUTH = {"gamma": 0.6, "mu_kinetic": 0.45, "mu_excess": 0.1, "restitution": 0.3, "x0": 0.0, "angle0": 0.1, "speed": 1.9}
PLANE = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)


def hopping(hoop=None, plane=PLANE, start=None, duration=1.01):
    return hh.simulate(hoop or hh.Hoop.ideal(0.6, radius=RADIUS), plane, start or hh.Start.rolling(1.9, angle=0.1), duration)


def filmed(motion, seed=1, rate=240.0, angle=True, sigma=SIGMA, sigma_angle=SIGMA_ANGLE, frames=None):
    """A track as a film of a motion would give it."""
    rng = np.random.default_rng(seed)
    t = np.arange(frames or int(motion.duration * rate)) / rate
    state, n = motion.at(t), len(t)
    columns = {
        "x": state.x + rng.normal(0, sigma, n),
        "y": state.height + motion.scenario.hoop.radius + rng.normal(0, sigma, n),
        "sigma_x": np.full(n, sigma),
        "sigma_y": np.full(n, sigma),
    }
    if angle:
        columns |= {"angle": state.angle + rng.normal(0, sigma_angle, n), "sigma_angle": np.full(n, sigma_angle)}
    others = {"radius": motion.scenario.hoop.radius, "slope": motion.scenario.plane.slope, "placed": True, "source": "a film"}
    return track_of(t, columns, **others)
