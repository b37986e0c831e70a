"""A phone fixed to the hoop measures the angular velocity alone, with noise and an offset."""

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import RADIUS, TRUTH, hopping
from hophoop.tracking.table import track_of

pytestmark = pytest.mark.compiled

NAMES = ("gamma", "mu_kinetic", "mu_excess", "restitution", "angle0", "speed")
OFFSET, SIGMA = 0.02, 0.02


def pulls(seed):
    """Errors over uncertainties of a fit to a computed record of 200 values a second."""
    t = np.arange(200) / 200.0
    omega = hopping().at(t).omega + OFFSET + np.random.default_rng(seed).normal(0, SIGMA, len(t))
    fit = hh.fit(track_of(t, {"omega": omega, "sigma_omega": np.full(len(t), SIGMA)}, radius=RADIUS))
    assert fit.good
    # static friction is the least certain, and has a limit in some draws
    assert {*NAMES, "omega_offset"} - set(fit.free) <= {"mu_excess"}
    truth = TRUTH | {"omega_offset": OFFSET}
    names = (*NAMES, "omega_offset")
    return [(fit.values[name] - truth[name]) / fit.error(name) if name in fit.free else np.nan for name in names]


def test_a_record_of_the_angular_velocity_gives_hoop_contact_and_start():
    assert np.nanmax(np.abs(pulls(1))) < 3.5


@pytest.mark.slow
def test_pulls_of_twenty_records():
    found = np.array([pulls(seed) for seed in range(20)])
    assert np.sqrt(np.nanmean(found**2)) == pytest.approx(1.0, abs=0.25)
    assert np.abs(np.nanmean(found, axis=0)).max() < 4 / np.sqrt(20)
