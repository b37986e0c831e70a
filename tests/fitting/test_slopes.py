"""Derivatives of what a fit leaves over, against differences and against what can be written down."""

import dataclasses

import numpy as np
import pytest
from scipy.optimize import least_squares

import hophoop as hh
from fitting_tools import SIGMA, SIGMA_ANGLE, differences, filmed, hopping, posed
from hophoop.fitting.jacobian import exact_slopes
from hophoop.fitting.losses import SOFT, influence, influence_slope, loss
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.solving import parameters, slopes

# a fit asks for hundreds of motions
pytestmark = pytest.mark.compiled


def test_slopes_are_those_that_can_be_written_down(hop):
    track = filmed(hop)
    problem, values = posed(track)
    names = ("x0", "origin_y", "marker_angle")
    jacobian = slopes(problem, parameters(values, names))
    n = len(track.t)
    expected = np.zeros((3 * n, 3))
    expected[:n, 0] = expected[n : 2 * n, 1] = -1 / SIGMA
    expected[2 * n :, 2] = -1 / SIGMA_ANGLE
    assert jacobian == pytest.approx(expected, rel=1e-8, abs=1e-9)


STARTED = {
    "rolling": hh.Start.rolling(1.9, angle=0.1),
    "sliding": hh.Start(vx=2.0, omega=3.0, angle=0.4),
    "flying": hh.Start(vx=1.0, height=0.05, vy=0.1, omega=4.0, angle=0.4),
}


@pytest.mark.parametrize("kind", STARTED)
@pytest.mark.parametrize("marker", [False, True], ids=["centre", "marker"])
def test_slopes_are_those_of_differences(kind, marker):
    motion = hopping(start=STARTED[kind], duration=0.9)
    track = filmed(motion)
    rows = np.column_stack([np.full(len(track.t), np.nan), 300.0 - 100.0 * track.centre[:, 1]])
    track = dataclasses.replace(track, pixel=rows)
    if marker:
        arrow = 0.2 * np.stack([np.sin(track.angle), np.cos(track.angle)], axis=-1)
        none = np.full_like(track.centre, np.nan)
        error = np.full(len(track.t), SIGMA)
        track = dataclasses.replace(track, marker=track.centre + arrow, centre=none, marker_error=error)
    start, state = motion.scenario.start, motion.at(0.0)
    known = {"angle0": start.angle, "vx0": state.vx, "vy0": state.vy, "omega0": state.omega, "height0": state.height}
    known |= {"slope": 0.02, "scale": 1.01, "tilt": 0.03, "origin_y": 0.01, "row_delay": 1e-5}
    known |= {"marker_angle": 0.05, "marker_ratio": 0.7, "eccentricity": 0.6, "inertia_ratio": 0.6}
    problem, values = posed(track, kind, "general" if kind == "sliding" else "ideal", **known)
    # rolling resistance is at the end of its range at 0: see test_resistance
    names = tuple(name for name in problem.names if name != "rolling_resistance")
    jacobian = slopes(problem, parameters(values, names))
    for k, name in enumerate(names):
        expected = differences(problem, values, name, 1e-8 if name == "row_delay" else 2e-6)
        size = np.abs(expected).max() + 1.0
        # a frame within a step of an event is off in the differences
        off = np.abs(jacobian[:, k] - expected) / size
        assert np.sort(off)[-4] < 1e-6, name
        if kind == "rolling" and (marker or name not in ("marker_angle", "marker_ratio")):
            assert size > 2.0, name


def test_a_tied_parameter_may_depend_on_another():
    values = {"mu_kinetic": 0.4, "mu_excess": 0.0, "restitution": 0.0}
    params = parameters(values, ("mu_kinetic",), tied={"restitution": "2 * mu_excess", "mu_excess": "mu_kinetic / 4"})
    params["mu_kinetic"].value = 0.8
    assert params.valuesdict() == {"mu_kinetic": 0.8, "mu_excess": 0.2, "restitution": 0.4}


def test_slopes_go_along_with_what_is_tied(hop):
    track = filmed(hop)
    problem, values = posed(track)
    tied = parameters(values, ("mu_kinetic",), tied={"mu_excess": "mu_kinetic / 4.5"})
    alone = slopes(problem, parameters(values, ("mu_kinetic", "mu_excess")))
    assert slopes(problem, tied)[:, 0] == pytest.approx(alone[:, 0] + alone[:, 1] / 4.5, rel=1e-6, abs=1e-4)


def test_the_loss_is_the_one_that_is_minimized():
    """The loss compares minima and is what `sample` draws from; SciPy finds the minima."""
    off = np.array([-8.0, -2.0, -1e-3, 0.5, 3.0, 20.0])
    for soft, name in ((True, "soft_l1"), (False, "linear")):
        found = least_squares(lambda _: off, [0.0], loss=name, f_scale=SOFT)
        assert loss(off, soft) == pytest.approx(2.0 * found.cost, rel=1e-14)
    assert loss(np.array([1e-9]), True) == pytest.approx(1e-18, rel=1e-15)
    assert loss(np.array([50.0]), True) < 20.0**2 < loss(np.array([50.0]), False)


def test_the_soft_loss_has_the_slopes_that_it_is_said_to_have():
    off = np.array([-8.0, -2.0, -1e-3, 0.5, 3.0, 20.0])
    step = 1e-6
    rise = [(loss(one + step, True) - loss(one - step, True)) / (4 * step) for one in off]
    assert influence(off) == pytest.approx(rise, rel=1e-7, abs=1e-9)
    assert influence_slope(off) == pytest.approx((influence(off + step) - influence(off - step)) / (2 * step), rel=1e-7)


def test_a_landing_without_restitution_leaves_differences_of_the_restitution_only():
    track = filmed(hopping(plane=hh.Plane(mu=0.9), duration=0.9))
    problem, values = posed(track, restitution=0.0)
    names = ("gamma", "mu_kinetic", "restitution", "speed")
    missing = np.isnan(exact_slopes(problem, values, names)).any(axis=0)
    assert missing.tolist() == [False, False, True, False]
    column = slopes(problem, parameters(values, names))[:, 2]
    step = PARAMETERS["restitution"].step
    above, still = (problem.residuals({**values, "restitution": e}) for e in (step, 0.0))
    np.testing.assert_array_equal(column, (above - still) / step)
    assert np.abs(column).max() > 0.0
