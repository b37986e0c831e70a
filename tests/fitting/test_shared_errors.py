"""What is off by the same in all frames of a film, or for a while: in the uncertainties, though no single frame knows of it."""

import dataclasses

import numpy as np
import pytest

import fitting_tools
import hophoop as hh
from fitting_tools import PLANE, RADIUS, TRUTH, read_again
from hophoop.fitting.channels import PATCH, PLACE_ERROR, channels_of
from hophoop.fitting.covariance import correlated_frames
from hophoop.fitting.problem import Prior, problem_of, run_of, shared_errors
from hophoop.tracking import Camera, View
from hophoop.tracking.ground import ground_line, line_through
from hophoop.tracking.table import track_from_dict

RATE, PIXELS = 120.0, 330.0
SIGMA, SIGMA_ANGLE = 6e-5, 1e-3
CONTACT = ("gamma", "mu_kinetic", "mu_excess", "restitution")


def filmed(motion, off=0.0, rate=RATE, **view):
    """A track as of a film whose scale is off: lengths come out too large by that, and the centre stands R over the plane."""
    track = fitting_tools.filmed(motion, rate=rate, sigma=SIGMA, sigma_angle=SIGMA_ANGLE)
    state = motion.at(track.t)
    centre = track.centre + off * np.column_stack([state.x, state.height])
    known = {"scale_error": 1e-3, "height_error": 3e-5, "rise_error": 3e-5, "marker_ratio": 0.8} | view
    seen = View(Camera(1280, 720, 1150.0), PIXELS, 0.0, 0.0, 0.0, **known)
    pixel = [0, 600] + PIXELS * centre * [1, -1]
    return dataclasses.replace(track, centre=centre, pixel=pixel, view=seen, slope_error=known["rise_error"])


@pytest.fixture(scope="module")
def found(hop):
    return hh.fit(filmed(hop, 5e-4))


@pytest.mark.long
def test_a_scale_that_is_off_does_not_spoil_the_parameters(hop, found):
    assert {"scale", "stretch", "origin_y", "tilt", "slope"} <= set(found.free)
    for name in CONTACT:
        assert abs(found.values[name] - TRUTH[name]) < 3 * found.error(name), name
    assert found.values["scale"] == pytest.approx(1 + 5e-4, abs=3 * found.error("scale"))
    assert found.error("scale") < 3e-4  # rolling tells it better than the rim does
    # held, the scale makes another friction of it, and a small uncertainty
    held = hh.fit(filmed(hop, 5e-4), fixed={"scale": 1.0, "stretch": 0.0, "origin_y": 0.0, "tilt": 0.0, "slope": 0.0})
    assert abs(held.values["mu_excess"] - 0.1) > 5 * held.error("mu_excess")


@pytest.mark.long
def test_a_scale_that_changes_along_the_film_makes_no_slope(hop):
    """By a tenth of a pixel of a rim of 22: the plane seemed to fall by 0.4° ± 0.04°."""
    small = filmed(hop, rate=60.0)
    small = dataclasses.replace(small, view=dataclasses.replace(small.view, scale=22 / RADIUS, scale_error=0.02))
    x = small.centre[:, :1]
    bent = dataclasses.replace(small, centre=small.centre + np.hstack([0.0022 * x**2, 0.0 * x]), slope_error=0.035)
    fit = hh.fit(bent)
    assert fit.values["stretch"] == pytest.approx(0.0022, abs=3 * fit.error("stretch"))
    assert abs(fit.values["slope"]) < 3 * fit.error("slope")
    assert abs(fit.values["gamma"] - 0.6) < 3 * fit.error("gamma")
    without = hh.fit(bent, fixed={"stretch": 0.0})
    assert not without.good or abs(without.values["slope"]) > 3 * without.error("slope")


@pytest.mark.long
def test_a_plan_counts_with_the_scale(hop, found):
    known, off = (hh.plan(hop.scenario, RATE, SIGMA, SIGMA_ANGLE, sigma_scale=size) for size in (0.0, 1e-3))
    assert off.errors["mu_excess"] > 2 * known.errors["mu_excess"]
    assert "scale" not in known.errors
    assert off.errors["scale"] == pytest.approx(found.error("scale"), rel=0.6)
    coarse = hh.plan(hop.scenario, RATE, 0.02, 0.1, sigma_scale=1e-3)
    assert coarse.errors["stretch"] < 1e-3  # which the size of the rim tells
    fixed = hh.plan(hop.scenario, RATE, SIGMA, SIGMA_ANGLE, fixed=("scale", "stretch", "origin_y"))
    assert fixed.errors == known.errors
    with pytest.raises(ValueError, match="sigma_scale = -1"):
        hh.plan(hop.scenario, sigma_scale=-1.0)


def test_priors_are_saved_and_those_of_what_is_asked_for_are_left_out(hop, found, tmp_path):
    track = filmed(hop, rate=60.0)
    fit = hh.fit(track, free=["scale"], fixed={"tilt": 0.0})
    assert set(fit.settings["priors"][0]) == {"stretch", "origin_y", "slope"}
    # three numbers known beforehand are three that were measured
    assert fit.degrees_of_freedom == 3 * len(track.t) + 3 - len(fit.free)
    back = read_again(found, tmp_path)
    assert back.problem.priors == found.problem.priors == shared_errors(found.track)
    assert (back.track.view, back.track.slope_error) == (found.track.view, found.track.slope_error)


def test_where_the_scale_is_off_so_is_the_plane(hop):
    priors = shared_errors(filmed(hop))
    assert priors["scale"] == Prior(1.0, 1e-3)
    assert priors["origin_y"] == Prior(0.0, pytest.approx(np.hypot(3e-4, 3e-5)))
    given = dataclasses.replace(filmed(hop), slope_error=float("nan"))
    assert set(shared_errors(given)) == {"scale", "stretch", "origin_y", "tilt"}
    assert set(shared_errors(filmed(hop, scale_error=0.0, height_error=0.0, rise_error=-1.0))) == {"stretch"}


def test_errors_last_as_long_as_the_hoop_is_in_one_place(hop):
    track = filmed(hop)
    x, _, angle = channels_of(track)
    step = float(np.hypot(*np.diff(track.pixel, axis=0).T).mean())
    assert x.frames == pytest.approx(1 + 2 * (PLACE_ERROR / PIXELS / SIGMA) ** 2 * PATCH / step)
    assert angle.frames == pytest.approx(1 + 2 * (PLACE_ERROR / PIXELS / (0.8 * RADIUS) / SIGMA_ANGLE) ** 2 * PATCH / step)
    still = dataclasses.replace(track, pixel=np.zeros_like(track.pixel))
    assert channels_of(still)[0].frames == pytest.approx(1 + (x.frames - 1) * step)
    # what the residuals say counts where it is more
    problem = problem_of([run_of(track, "ideal", "rolling", PLANE)], robust=False)
    fresh = np.random.default_rng(5).normal(size=problem.count)
    assert correlated_frames(problem, fresh)[0] == x.frames
    slow = np.repeat(fresh, 40)[: problem.count]
    assert correlated_frames(problem, slow)[0] > 3 * x.frames


def test_a_run_has_the_errors_of_each_quantity_and_times_from_its_first_value(hop):
    track = filmed(hop)
    late = dataclasses.replace(track, t=track.t + 5.0, centre_error=track.centre_error * [1.0, 2.0])
    late.centre[:3] = late.angle[:3] = np.nan
    run = run_of(late, "ideal", "rolling", PLANE)
    assert run.first == 3
    assert run.t == pytest.approx(track.t[:-3])
    assert [one.errors[0] for one in run.channels] == pytest.approx([SIGMA, 2.0 * SIGMA, SIGMA_ANGLE])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"scale": 0.0}, r"a track: view\.scale = 0\.0: input should be greater than 0\.$"),
        ({"strange": 1.0}, "a track is incomplete: .*strange"),
        ({"camera": {"width": 1280, "height": 720, "focal": -1.0}}, r"view\.camera\.focal = -1"),
        ({"chroma": [1.0]}, r"view\.chroma\.1 is missing"),
    ],
)
def test_a_view_that_is_none(hop, change, message):
    data = filmed(hop).to_dict()
    with pytest.raises(ValueError, match=message):
        track_from_dict(data | {"view": data["view"] | change}, "a track")


def test_the_line_of_the_ground_knows_how_well_it_is_known():
    """Errors that are alike for ten frames: over uncertainties they have the spread 1."""
    rng, pulls = np.random.default_rng(7), []
    for _ in range(60):
        x = np.linspace(0, 600, 200)
        line = ground_line(np.stack([x, 40 + np.repeat(rng.normal(0, 0.05, 20), 10)], axis=-1), np.full(200, 0.05), 100.0)
        pulls.append([(line.y - 40) / line.height_error, line.angle / line.angle_error])
    assert np.std(pulls, axis=0) == pytest.approx([1.0, 1.0], abs=0.35)
    clicked = line_through(np.array([[0.0, 10.0], [400.0, 10.0]]), 50.0)
    assert (clicked.height_error, clicked.angle_error) == pytest.approx((1.0, np.sqrt(2) / 400))


def test_a_turned_camera_is_told_from_a_slope_by_gravity(hop):
    """In the picture both look the same: the plane falls by 2°, and the camera may be off by as much."""
    turn = np.radians(2.0)
    track = filmed(hop)
    turned = dataclasses.replace(track, slope=-turn, slope_error=turn, view=dataclasses.replace(track.view, rise=turn))
    fit = hh.fit(turned)
    assert fit.good
    assert abs(fit.values["slope"]) < 3 * fit.error("slope")
    assert abs(fit.values["gamma"] - TRUTH["gamma"]) < 3 * fit.error("gamma")
    (said,) = (sentence for sentence in fit.sentences() if "The camera is turned by " in sentence)
    assert said.startswith(("The camera is turned by 1.9", "The camera is turned by 2.0"))
    assert "the plane falls by" in said
