"""Derivatives of what a fit leaves over, against differences and against what can be written down."""

from dataclasses import replace
from unittest.mock import Mock

import numpy as np
import pytest
from scipy.optimize import least_squares

import hophoop as hh
from fitting_tools import PLANE, SIGMA, filmed, hopping, posed
from hophoop.fitting.jacobian import exact_slopes
from hophoop.fitting.losses import SOFT, influence, loss
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.problem import Prior, problem_of
from hophoop.fitting.solving import parameters, slopes
from hophoop.scenario import InputError

SLIDING, FLYING = hh.Start(vx=2.0, omega=3.0, angle=0.4), hh.Start(vx=1.0, height=0.05, vy=0.1, omega=4.0, angle=0.4)
# start, hoop, rolling resistance, duration, and whether the marker is filmed in place of the centre
MOTIONS = {
    "rolling": (hh.Start.rolling(1.9, angle=0.1), "ideal", 0.0, 1.0, True),
    "sliding": (SLIDING, "general", 0.0, 0.9, False),
    "flying": (FLYING, "ideal", 0.0, 0.9, True),
    "slips, hops and bounces": (hh.Start.rolling(1.9, angle=0.1), "ideal", 0.004, 1.0, False),
    "rolls, turns and rocks": (hh.Start.rolling(0.6, angle=2.0), "ideal", 0.03, 2.0, False),
}


def differences(problem, values, name):
    """Derivative of the residuals, with an error of the fourth order in the step; to one side at the end of the range."""
    step = {"row_delay": 1e-8, "rolling_resistance": 2e-5}.get(name, 2e-6)
    weights = {-2: 1, -1: -8, 1: 8, 2: -1}
    if name == "rolling_resistance" and not values[name]:
        weights = {0: -25, 1: 48, 2: -36, 3: 16, 4: -3}
    return sum(by * problem.residuals(values | {name: values[name] + k * step}) for k, by in weights.items()) / (12 * step)


@pytest.mark.parametrize("name", MOTIONS)
def test_slopes_are_those_of_differences(name):
    start, hoop, resistance, duration, marker = MOTIONS[name]
    plane = PLANE.model_copy(update={"rolling_resistance": resistance})
    motion = hopping(plane=plane, start=start, duration=duration)
    track = filmed(motion)
    track = replace(track, pixel=np.column_stack([np.full(len(track.t), np.nan), 300.0 - 100.0 * track.centre[:, 1]]))
    if marker:
        arrow = 0.2 * np.stack([np.sin(track.angle), np.cos(track.angle)], axis=-1)
        none, error = np.full_like(track.centre, np.nan), np.full(len(track.t), SIGMA)
        track = replace(track, marker=track.centre + arrow, centre=none, marker_error=error)
    state = motion.at(0.0)
    known = {"angle0": state.angle, "vx0": state.vx, "vy0": state.vy, "omega0": state.omega, "height0": state.height}
    known |= {
        "speed": state.vx,
        "slope": 0.02,
        "scale": 1.01,
        "stretch": 0.01,
        "tilt": 0.03,
        "origin_y": 0.01,
        "row_delay": 1e-5,
    }
    known |= {"marker_angle": 0.05, "marker_ratio": 0.7, "eccentricity": 0.6, "inertia_ratio": 0.6}
    problem, values = posed(track, name if name in ("sliding", "flying") else "rolling", hoop, plane, **known)
    assert not marker or (problem.runs[0].channels[0].values == track.marker[:, 0]).all()
    problem = problem_of([replace(problem.runs[0], priors={"x0": Prior(0.1, 0.2), "slope": Prior(0.0, 0.5)})])
    jacobian = slopes(problem, parameters(values, problem.names))
    exact = exact_slopes(problem, values, problem.names)
    assert (np.isnan(exact) | (jacobian == exact)).all()
    for k, one in enumerate(problem.names):
        expected = differences(problem, values, one)
        size = np.abs(expected).max() + 1.0
        # a frame within a step of an event is off in the differences
        assert np.sort(np.abs(jacobian[:, k] - expected) / size)[-6] < 1e-6, one
        assert name != "rolling" or size > 2.0, one


def test_slopes_go_along_with_what_is_tied(hop, monkeypatch):
    """Also where what is tied depends on another tied parameter, and where only differences are left."""
    problem, values = posed(filmed(hop), restitution=0.2)
    params = parameters(values, ("mu_kinetic",), tied={"restitution": "2 * mu_excess", "mu_excess": "mu_kinetic / 4.5"})
    params["mu_kinetic"].value = 0.45
    assert {name: params[name].value for name in ("mu_excess", "restitution")} == pytest.approx(
        {"mu_excess": 0.1, "restitution": 0.2}
    )
    alone = slopes(problem, parameters(params.valuesdict(), ("mu_kinetic", "mu_excess", "restitution")))
    together = alone @ [1.0, 1 / 4.5, 2 / 4.5]
    assert slopes(problem, params)[:, 0] == pytest.approx(together, rel=1e-6, abs=1e-4)
    monkeypatch.setattr("hophoop.fitting.solving.exact_slopes", Mock(side_effect=InputError("No motion.")))
    assert np.median(np.abs(slopes(problem, params)[:, 0] - together)) < 1e-3 * np.abs(together).max()


OFF = np.array([-8.0, -2.0, -1e-3, 0.5, 3.0, 20.0])


def test_the_loss_is_the_one_that_is_minimized_and_has_the_slopes_that_it_is_said_to_have():
    """The loss compares minima ; SciPy finds the minima."""
    for soft, name in ((True, "soft_l1"), (False, "linear")):
        found = least_squares(lambda _: OFF, [0.0], loss=name, f_scale=SOFT)
        assert loss(OFF, soft) == pytest.approx(2.0 * found.cost, rel=1e-14)
    step = 1e-6
    rise = [(loss(one + step, True) - loss(one - step, True)) / (4 * step) for one in OFF]
    assert influence(OFF) == pytest.approx(rise, rel=1e-7, abs=1e-9)


def test_a_landing_without_restitution_leaves_differences_of_the_restitution_only():
    problem, values = posed(filmed(hopping(plane=hh.Plane(mu=0.9), duration=0.9)), restitution=0.0)
    names = ("gamma", "mu_kinetic", "restitution", "speed")
    missing = np.isnan(exact_slopes(problem, values, names)).any(axis=0)
    assert missing.tolist() == [False, False, True, False]
    column = slopes(problem, parameters(values, names))[:, 2]
    step = PARAMETERS["restitution"].step
    above, still = (problem.residuals({**values, "restitution": e}) for e in (step, 0.0))
    np.testing.assert_array_equal(column, (above - still) / step)
    assert np.abs(column).max() > 0.0
