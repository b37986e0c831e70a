"""A phone fixed to the hoop measures the angular velocity alone, with noise and an offset."""

import numpy as np
import pytest

import hophoop as hh
from checkout import ROOT
from fitting_tools import RADIUS, TRUTH, hopping, is_told, posed, pulls
from hophoop.fitting.guess import guess
from hophoop.tracking import Reading, read_track
from hophoop.tracking.table import track_of

SIGMA = 0.02
RECORDED = {name: value for name, value in TRUTH.items() if name != "x0"}


@pytest.mark.parametrize(
    ("rate", "digits", "noise", "offset"),
    # in the draw small basins are on both sides of a step, where an impact passes a value; without noise rounding is the error
    [pytest.param(200, 12, SIGMA, 0.02, marks=pytest.mark.long), (120, 2, 0.0, 0.0)],
)
def test_a_record_of_the_angular_velocity_gives_hoop_contact_and_start(rate, digits, noise, offset):
    t = np.arange(rate) / rate
    omega = np.round(hopping().at(t).omega + offset + np.random.default_rng(13).normal(0, noise, rate), digits)
    fit = hh.fit(track_of(t, {"omega": omega}, radius=RADIUS), sigma_omega=noise or None)
    assert fit.good
    # static friction is the least certain, and has a limit in some draws
    assert {*RECORDED, "omega_offset"} - set(fit.free) <= {"mu_excess"}
    assert np.nanmax(np.abs(pulls(fit, RECORDED | {"omega_offset": offset}))) < 3.0
    assert fit.error("gamma") < (1e-3 if not noise else 1e-2)


def test_in_rolling_the_energy_gives_the_load():
    t = np.arange(200) / 200.0
    omega = hopping(start=hh.Start.rolling(1.0, angle=0.1)).at(t).omega
    problem, values = posed(track_of(t, {"omega": omega}, radius=RADIUS))
    found = guess(problem.runs[0], values, {"gamma", "angle0"})
    assert (found["gamma"], found["angle0"]) == pytest.approx((0.6, 0.1), abs=1e-3)


def test_a_phone_does_not_tell_how_high_a_hoop_flies():
    """A record of flight and landing alone gave an angular velocity 'explained', and a restitution 13 errors off."""
    with pytest.raises(ValueError, match="start = 'flying' must be auto, rolling or sliding for angular velocities alone"):
        hh.fit(track_of(np.arange(30) / 100, {"omega": np.full(30, 5.0)}, radius=RADIUS), start="flying")


@pytest.mark.long
def test_the_error_may_be_given():
    t = np.arange(40) / 100.0
    track = track_of(t, {"omega": hopping().at(t).omega}, radius=RADIUS)
    fits = [hh.fit(track, sigma_omega=sigma) for sigma in (0.01, 0.02)]
    assert fits[1].error("gamma") == pytest.approx(2 * fits[0].error("gamma"), rel=0.05)
    with pytest.raises(ValueError, match=r"sigma_omega = -1.* above 0"):
        hh.fit(track, sigma_omega=-1.0)


@pytest.fixture(scope="module")
def sample():
    return hh.fit(read_track(ROOT / "examples" / "phone" / "gyroscope.csv", Reading(radius=RADIUS)))


@pytest.mark.long
def test_the_sample_record_gives_what_the_page_says(sample):
    is_told(sample, "docs/teach/phone.md", ("gamma", "mu_kinetic", "restitution"))


@pytest.mark.long
def test_a_plan_predicts_what_a_record_determines(sample):
    plan = hh.plan(hopping().scenario, rate=200.0, sigma_omega=SIGMA)
    assert set(plan.errors) == set(sample.free)
    assert all(plan.errors[name] == pytest.approx(sample.error(name), rel=0.5) for name in sample.free)
    slow = hh.plan(hopping(start=hh.Start.rolling(1.0), duration=1.0).scenario, rate=200.0, sigma_omega=SIGMA)
    assert {"mu_kinetic", "restitution"} <= {row[0] for row in slow.rows() if row[1] == "not determined"}
    assert slow.least_static_friction > 0.2


@pytest.mark.long
def test_a_second_of_free_motion_is_found_in_ten():
    """A timed run of a phone has rest, the hand and the catch around it."""
    t = np.arange(1000) / 100.0
    free = (t >= 5.2) & (t < 6.2)
    omega = np.where((t > 4.6) & (t < 5.2), 9.0 * (t - 4.6), 0.0)
    omega[free] = hopping().at(t[free] - 5.2).omega
    omega += np.random.default_rng(13).normal(0, SIGMA, len(t))
    notes = " ".join(hh.fit(track_of(t, {"omega": omega}, radius=RADIUS)).notes)
    assert "give --from 5.2 --to 6" in notes
