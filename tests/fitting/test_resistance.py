"""Rolling resistance as a parameter of a fit: found, with slopes that are those of independent differences."""

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import RADIUS, differences, filmed, posed
from hophoop.fitting.jacobian import exact_slopes
from hophoop.fitting.solving import parameters, slopes

pytestmark = pytest.mark.compiled


def moving(resistance, speed=1.9, duration=1.01, angle=0.1, mu=(0.55, 0.45), restitution=0.3):
    plane = hh.Plane(mu_static=mu[0], mu_kinetic=mu[1], restitution=restitution, rolling_resistance=resistance)
    return hh.simulate(hh.Hoop.ideal(0.6, radius=RADIUS), plane, hh.Start.rolling(speed, angle=angle), duration)


# how it moves, and what the data then see
MOTIONS = {
    "slips, hops and bounces": (moving(0.004), ("gamma", "mu_kinetic", "mu_excess", "restitution", "angle0", "speed")),
    "rolls, turns and rocks": (moving(0.03, 0.6, 2.0, 2.0), ("gamma", "angle0", "speed", "slope")),
    "without resistance": (moving(0.0), ("gamma", "mu_kinetic", "mu_excess", "angle0", "speed")),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_slopes_are_those_of_finer_differences(name):
    """They are derivatives, also by the couple, to one side where there is none; the differences are of the fourth order."""
    motion, seen = MOTIONS[name]
    plane, start = motion.scenario.plane, motion.scenario.start
    known = {"mu_kinetic": plane.mu_kinetic, "mu_excess": plane.mu_static - plane.mu_kinetic, "restitution": plane.restitution}
    problem, values = posed(filmed(motion), plane=plane, angle0=start.angle, speed=start.vx, **known)
    assert values["rolling_resistance"] == plane.rolling_resistance
    names = tuple(name for name in problem.names if name in (*seen, "rolling_resistance"))
    jacobian = exact_slopes(problem, values, names)
    assert np.isfinite(jacobian).all()
    assert (slopes(problem, parameters(values, names)) == jacobian).all()
    for k, name in enumerate(names):
        expected = differences(problem, values, name, 2e-5)
        size = np.abs(expected).max()
        off = np.abs(jacobian[:, k] - expected) / size
        # frames within a step of an event are off
        assert np.sort(off)[-6] < 1e-6, name
        assert size > 2.0, name


@pytest.mark.slow
def test_it_is_found_beside_friction_and_restitution():
    """All seven usual parameters and the couple, in a motion that slips, hops and bounces: pulls of several draws."""
    truth = {"gamma": 0.6, "mu_kinetic": 0.45, "mu_excess": 0.1, "restitution": 0.3, "rolling_resistance": 0.004}
    pulls = []
    for seed in range(3):
        fit = hh.fit(filmed(MOTIONS["slips, hops and bounces"][0], seed), free=["rolling_resistance"])
        assert fit.good
        assert set(truth) < set(fit.free)
        assert 0 < fit.error("rolling_resistance") < 2e-3
        pulls.append([(fit.values[name] - true) / fit.error(name) for name, true in truth.items()])
    assert np.abs(pulls).max() < 3.5
    assert 0.5 < np.sqrt(np.mean(np.square(pulls))) < 1.5


def test_a_hoop_that_rocks_tells_it_from_what_it_loses():
    """Alone, and beside a slope, which shifts the lowest place and takes nothing away."""
    fit = hh.fit(filmed(MOTIONS["rolls, turns and rocks"][0], 3, 120.0), free=["rolling_resistance", "slope"])
    assert fit.good
    for name, true in (("rolling_resistance", 0.03), ("slope", 0.0), ("gamma", 0.6)):
        assert abs(fit.values[name] - true) < 4 * fit.error(name), name
    assert fit.error("rolling_resistance") < 1e-3


def test_none_is_a_limit_on_one_side():
    fit = hh.fit(filmed(moving(0.0, 1.2, 0.8), 2, 60.0), free=["rolling_resistance"], fixed={"restitution": 0.0})
    if "rolling_resistance" in fit.limits:
        sign, most = fit.limits["rolling_resistance"]
        assert sign == "≤"
        assert 0 <= most < 0.02
    else:
        assert fit.values["rolling_resistance"] < 4 * fit.error("rolling_resistance")


def test_a_scenario_has_the_couple_that_was_found():
    known = {"mu_kinetic": 0.5, "mu_excess": 0.0, "restitution": 0.0, "gamma": 0.6}
    motion = moving(0.02, 1.2, 0.8, 0.0, (0.5, 0.5), 0.0)
    fit = hh.fit(filmed(motion, rate=60.0), free=["rolling_resistance"], fixed=known)
    assert fit.good
    assert abs(fit.values["rolling_resistance"] - 0.02) < 5.0 * fit.error("rolling_resistance")
    assert 0.0 < fit.error("rolling_resistance") < 5e-3
    assert fit.scenario.plane.rolling_resistance == fit.values["rolling_resistance"]
    lost = fit.motion.ledger.rolling_resistance / motion.ledger.rolling_resistance
    assert lost == pytest.approx(1.0, abs=5 * fit.error("rolling_resistance") / 0.02)
