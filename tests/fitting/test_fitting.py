"""Fits against motions whose parameters are known, and against what can be known without a fit."""

import re
import runpy
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

import hophoop as hh
from checkout import ROOT
from fitting_tools import PLANE, RADIUS, SIGMA, SIGMA_ANGLE, TRUTH, filmed, hopping, lasting, posed, read_again
from hophoop.fitting import report
from hophoop.fitting.channels import GYROSCOPE, evened, scatter
from hophoop.fitting.covariance import autocorrelation_time, correlated_frames, inverse
from hophoop.fitting.judging import runs_deviation
from hophoop.fitting.limits import least_static_friction
from hophoop.fitting.mistakes import shutter
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.reporting import places_in_film
from hophoop.fitting.solving import minimize, parameters, slopes, solve
from hophoop.tracking import Camera, View
from hophoop.tracking.scatter import third_differences
from hophoop.tracking.table import track_of


def test_the_truth_is_found_within_its_uncertainties(found):
    assert found.good
    assert found.reduced == pytest.approx(1.0, abs=0.15)
    assert set(found.free) == set(TRUTH)
    for name, value in TRUTH.items():
        assert abs(found.values[name] - value) < 4 * found.error(name), name
    assert found.error("gamma") < 1e-3
    assert found.error("mu_static") < 0.02
    assert any(": gamma (to 0.0" in sentence for sentence in found.sentences())
    assert found.shares["RKRSH+KR"] > 0.9
    (sequence,) = (one for one in found.details() if one.startswith("Sequence RKRSH+KR: "))
    assert sequence.endswith(" %).") == (len(found.shares) > 1)
    assert found.scenario.plane.mu_static == pytest.approx(0.55, abs=0.04)


def test_the_centre_alone_tells_as_well(hop):
    fit = hh.fit(filmed(hop, angle=False))
    assert fit.good
    assert fit.values["gamma"] == pytest.approx(0.6, abs=0.01)
    assert np.cos(fit.values["angle0"]) == pytest.approx(np.cos(0.1), abs=0.02)
    # and says what it cannot tell apart
    assert {"gamma", "speed"} in [{*pair} for *pair, _ in fit.correlated]
    assert any("can hardly be distinguished" in sentence for sentence in fit.details())


PARTS = hh.Hoop.from_parts(radius=RADIUS, parts=[hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27)])
SLIDING, FLYING = hh.Start(vx=2.34, omega=7.2, angle=1.1), hh.Start(vx=1.0, height=0.05, omega=4.0, angle=0.4)
RESISTED = PLANE.model_copy(update={"rolling_resistance": 0.03})

# how it moves, how it is filmed, what is asked for, and what must come out
FITS = {
    "fixed, tied and bounded": (
        {}, {}, {"fixed": {"restitution": 0.3}, "tied": {"mu_excess": "mu_kinetic / 4.5"}, "bounds": {"gamma": (0.5, 0.7)}},
        {"restitution": 0.3, "mu_kinetic": 0.45},
    ),
    "known from its parts": (
        {"hoop": PARTS, "start": hh.Start.rolling(2.4)}, {},
        {"hoop": PARTS, "start": "rolling"}, {"mu_kinetic": 0.45, "restitution": 0.3},
    ),
    # hardly yet, so that one that starts rolling is nearly as close
    "sliding": ({"start": SLIDING, "duration": 0.8}, {}, {}, {"omega0": 7.2, "vx0": 2.34, "mu_kinetic": 0.45}),
    "sliding or rolling": ({"start": hh.Start.rolling(2.2, angle=0.4)}, {}, {}, {"mu_kinetic": 0.45, "vx0": 2.2}),
    "flying": ({"start": FLYING, "duration": 0.8}, {}, {}, {"height0": 0.05, "vx0": 1.0}),
    # a slope shifts the lowest place and takes nothing away
    "resisted": (
        {"plane": RESISTED, "start": hh.Start.rolling(0.6, angle=2.0), "duration": 2.0}, {"seed": 3},
        {"free": ["rolling_resistance", "slope"]}, {"rolling_resistance": 0.03, "slope": 0.0, "gamma": 0.6},
    ),
    "resisted by nothing": (
        {"start": hh.Start.rolling(1.2, angle=0.1), "duration": 0.8}, {"seed": 2},
        {"free": ["rolling_resistance"], "fixed": {"restitution": 0.0}}, {"rolling_resistance": 0.0},
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", FITS)
def test_what_is_asked_for_is_found(name):
    moves, film, asked, truth = FITS[name]
    fit = hh.fit(filmed(hopping(**moves), rate=60.0, **film), **asked)
    assert fit.good
    assert fit.settings["starts"] == [name[:7] if name[:7] in ("sliding", "flying") else "rolling"]
    assert any("--start rolling" in note for note in fit.notes) == (name == "sliding or rolling")
    for one, value in truth.items():
        assert abs(fit.values[one] - value) <= 4 * fit.error(one), one
    if "tied" in asked:
        assert fit.values["mu_excess"] == pytest.approx(fit.values["mu_kinetic"] / 4.5)
        assert not {"mu_excess", "restitution"} & set(fit.free)
    if "hoop" in asked:
        assert fit.scenario.hoop == PARTS
    assert fit.scenario.plane.rolling_resistance == fit.values["rolling_resistance"]
    if name == "resisted by nothing":
        sign, limit = fit.limits["rolling_resistance"]
        assert sign == "≤"
        assert 0.0 < limit < 0.02


def test_a_scatter_that_is_large_and_alternates_is_doubted(hop):
    track = filmed(hop, rate=60.0, sigma=0.03, alike=-0.95)
    large, alternates = hh.fit(replace(track, centre_error=np.full_like(track.centre, np.nan))).sentences()[1:3]
    assert "% of the radius: are" in large
    assert alternates.startswith("The residuals alternate")


def test_axes_of_the_data_that_do_not_lie_along_the_plane(hop):
    track, turn = filmed(hop, rate=60.0), 0.05
    turned = track.centre @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) + [0.3, -0.2]
    fit = hh.fit(replace(track, centre=turned, angle=track.angle - turn, placed=False))
    assert fit.good
    assert fit.values["tilt"] == pytest.approx(turn, abs=1e-3)
    assert fit.values["gamma"] == pytest.approx(0.6, abs=5e-3)


@pytest.mark.parametrize(
    ("load", "static", "kinetic", "restitution", "speed", "angle", "duration"),
    [
        (0.7, 0.4, 0.3, 0.5, 2.3, 0.5, 1.5),
        pytest.param(
            0.795931295452128,
            0.6196176352915649,
            0.5266653176996758,
            0.507350747986,
            2.530978175830234,
            5.21425720033928,
            1.86,
            marks=pytest.mark.long,
        ),
    ],
)
def test_a_hoop_that_hops_at_once_and_bounces_is_found(load, static, kinetic, restitution, speed, angle, duration):
    """Many landings make the sum of squares rough: the search begins with a part of the record."""
    plane = hh.Plane(mu_static=static, mu_kinetic=kinetic, restitution=restitution)
    motion = hopping(hh.Hoop.ideal(load, radius=RADIUS), plane, hh.Start.rolling(speed, angle=angle), duration)
    found = hh.fit(filmed(motion, sigma=2e-4, sigma_angle=7e-4))
    assert found.good
    assert found.values["gamma"] == pytest.approx(load, abs=4 * found.error("gamma"))


def test_outliers_count_little(hop):
    track = filmed(hop, rate=60.0)
    places = track.centre.copy()
    places[5::15] += 0.02

    def speed(track, robust):
        problem, values = posed(track)
        return minimize(replace(problem, robust=robust), parameters(values, tuple(TRUTH))).values["speed"]

    soft, hard = (abs(speed(replace(track, centre=places), robust) - speed(track, robust)) for robust in (True, False))
    assert soft < 0.3 * hard


# --- what a plan says ------------------------------------------------------------------------------


def test_a_plan_says_what_the_fit_then_has(hop, found):
    def planned(rate=240.0, size=1.0):
        return hh.plan(hop.scenario, rate, size * SIGMA, size * SIGMA_ANGLE, sigma_scale=0.0)

    plan = planned()
    assert not plan.limits
    assert plan.good
    for name in TRUTH:
        # another place of the minimum costs some per cent
        assert found.error(name) == pytest.approx(plan.errors[name], rel=0.35), name
    assert planned(size=2.0).errors["gamma"] == pytest.approx(2 * plan.errors["gamma"], rel=1e-6)
    assert planned(960.0).errors["gamma"] == pytest.approx(0.5 * plan.errors["gamma"], rel=0.1)
    # bounces in a row are named once
    assert any("Sequence RKRSH+KR:" in one for one in plan.details())
    assert not plan.misfits  # rounding is none


@pytest.mark.parametrize(
    ("restitution", "limited"),
    # one that a film of this scatter could not tell from 0, and one that it could
    [(0.01, {"restitution"}), (0.1, set())],
)
def test_a_plan_has_limits_of_what_may_be_at_an_end_of_its_range(restitution, limited):
    plane = hh.Plane(mu_static=0.6, mu_kinetic=0.5, restitution=restitution)
    scenario = hopping(hh.Hoop.ideal(0.7, radius=RADIUS), plane, hh.Start.rolling(2.1)).scenario
    plan = hh.plan(scenario, rate=240.0, sigma=3e-4, sigma_angle=1e-3)
    assert set(plan.limits) == limited
    assert all(sign == "≤" and 0 < limit < 0.3 for sign, limit in plan.limits.values())
    assert not limited & {*plan.errors}
    assert max(plan.errors.values()) < 0.1  # nothing that cannot be told has a spread


# --- how uncertain ---------------------------------------------------------------------------------


def test_a_share_of_the_errors_that_lasts_is_found():
    """Under errors that are new in each frame a slow one hides, whose neighbours correlate by little, and for long."""
    rng = np.random.default_rng(6)
    errors = np.sqrt(0.3) * lasting(rng.normal(size=1000), 0.9) + np.sqrt(0.7) * rng.normal(size=1000)
    assert autocorrelation_time(3.0 * errors) == pytest.approx(1 + 2 * 0.3 * 0.9 / 0.1, rel=0.4)
    assert autocorrelation_time(rng.normal(size=1000)) == 1.0
    # every second frame is missing
    assert autocorrelation_time(np.column_stack([errors, np.full(1000, np.nan)]).ravel()) == autocorrelation_time(errors)


def test_times_in_whole_milliseconds_are_evened():
    t = np.arange(100) / 240.0
    even, derived = evened(track_of(np.round(t, 3), {"x": t, "y": t}))
    assert derived == {"rate": pytest.approx(240.0, rel=1e-3)}
    assert even.t == pytest.approx(t, abs=2e-4)


def test_usual_values_lie_within_their_limits_and_have_units():
    for one in PARAMETERS.values():
        assert one.low <= one.usual <= one.high
        assert one.unit in ("1", "m", "1/m", "m/s", "rad", "rad/s", "s")


def test_errors_that_last_over_frames_count_less(hop, found):
    track = replace(filmed(hop), centre=filmed(hop, 5, alike=0.7).centre)
    problem, values = posed(track)
    problem = replace(problem, robust=False)
    solution = solve(problem, parameters(values, tuple(TRUTH)))
    memory = correlated_frames(problem, solution.minimum.residuals)
    assert memory[:2] == pytest.approx([17 / 3, 17 / 3], rel=0.5)  # (1 + 0.7)/(1 − 0.7) of them say as much as one
    assert memory[2] == 1.0
    # nearly A⁻¹ Jᵀ P J A⁻¹ with all of P
    jacobian = slopes(problem, solution.minimum.params)
    apart = np.abs(np.subtract.outer(*2 * [np.arange(len(jacobian) // 3)]))
    blocks = [0.7**apart, 0.7**apart, 1.0 * (apart == 0)]
    known = np.linalg.inv(jacobian.T @ jacobian)
    middle = sum(part.T @ block @ part for part, block in zip(np.split(jacobian, 3), blocks, strict=True))
    errors = np.sqrt(np.diag(known @ middle @ known))
    assert np.sqrt(np.diag(solution.covariance)) == pytest.approx(errors, rel=0.25)
    assert (errors > 1.3 * np.sqrt(np.diag(known))).any()
    assert "Errors of x are correlated" in " ".join(replace(found, tracks=(track,)).details())


def test_beside_a_minimum_the_sum_of_squares_rises_by_the_square_of_the_distance(hop):
    """With the other parameters by regression, in standard deviations."""
    problem, values = posed(filmed(hop, rate=60.0))
    problem = replace(problem, robust=False)
    solution = solve(problem, parameters(values, tuple(TRUTH)))
    for name, far in product(("mu_kinetic", "mu_excess", "restitution"), (-0.5, 0.5)):
        value = solution.minimum.values[name] + far * solution.error(name)
        there = solution.values_at(name, value)
        assert there[name] == pytest.approx(value)
        assert problem.cost(values | there) - solution.minimum.cost == pytest.approx(0.25 * solution.spread, rel=0.2), name
        held = solution.held(solution.params, name, value)
        assert held[name].value == pytest.approx(value)
        assert not held[name].vary
        assert problem.cost(held.valuesdict()) <= problem.cost(values | there)
    assert solution.values_at("slope", 0.1) == {}


# --- what the film does not tell -------------------------------------------------------------------

GENTLE = {"plane": hh.Plane(mu=0.9, restitution=0.2), "start": hh.Start.rolling(1.0), "duration": 0.9}


def test_a_hoop_that_never_slips_gives_a_lower_limit():
    motion = hopping(**GENTLE)
    fit = hh.fit(filmed(motion, rate=120.0))
    sign, least = fit.limits["mu_static"]
    assert sign == "≥"
    # the friction that rolling needs, in closed form, over the way that was filmed
    theta = np.linspace(0.0, motion.at(motion.duration).angle, 4000)
    forces = hh.theory.rolling_forces(theta, motion.scenario.hoop, 1.0)
    expected = np.max(np.abs(forces.friction / forces.normal))
    # a slip that is too short is not seen
    assert 0.85 * expected < least < 1.001 * expected
    assert least_static_friction(motion) == pytest.approx(expected, rel=1e-4)
    assert fit.free == ("gamma", "x0", "angle0", "speed")
    assert any("never slips: static friction is at least" in note for note in fit.sentences())
    assert any("no impact" in note for note in fit.sentences())
    assert {row[0]: row[1] for row in fit.rows()}["restitution"] == "not determined"


def test_a_slip_without_which_the_data_are_explained_as_well_is_none():
    """In this draw the lowest minimum slips for a moment."""
    motion = hopping(plane=hh.Plane(mu=0.9, restitution=0.2), start=hh.Start.rolling(1.4), duration=0.5)
    fit = hh.fit(filmed(motion, 0, rate=60.0))
    assert fit.motion.sequence == "R"
    assert {name: sign for name, (sign, _) in fit.limits.items()} == {
        "mu_static": "≥", "mu_kinetic": "", "mu_excess": "", "restitution": "",
    }  # fmt: skip


def plastic(seed):
    """A film of two landings of a hoop that does not bounce: the sum of squares is flat from e = 0 to 0.02."""
    motion = hopping(hh.Hoop.ideal(0.7, radius=RADIUS), hh.Plane(mu=0.5, restitution=0.0), hh.Start.rolling(2.1), 1.0)
    return filmed(motion, seed, sigma=3e-4, sigma_angle=1e-3)


@pytest.mark.long
def test_a_restitution_that_may_be_0_has_a_limit():
    """Slopes of the minimum, which is anywhere on the flat, made it 0.029 ± 0.005 before."""
    fit = hh.fit(plastic(2))
    sign, limit = fit.limits["restitution"]
    assert sign == "≤"
    assert 0.01 < limit < 0.06
    assert fit.values["restitution"] == 0.0
    assert "restitution" not in fit.to_dict()["errors"]
    assert dict(row[:2] for row in fit.rows())["restitution"] == f"≤ {limit:.3g}"
    # what has a limit leaves the others less certain than if it were known
    known = hh.fit(plastic(2), fixed={"mu_excess": 0.0, "restitution": 0.0})
    assert fit.limits["mu_excess"][0] == "≤"
    assert 1.1 < fit.error("mu_kinetic") / known.error("mu_kinetic") < 3.0


@pytest.mark.long
def test_near_an_end_an_uncertainty_is_at_least_what_the_sum_of_squares_there_says():
    """In this draw 0 is excluded by between two and three standard deviations; the slopes made it nine before."""
    track = plastic(39)
    fit, without = hh.fit(track), hh.fit(track, fixed={"restitution": 0.0})
    assert "restitution" not in fit.limits
    assert 2.0 < fit.values["restitution"] / fit.error("restitution") < 3.05
    assert 4.0 < without.chi_square - fit.chi_square < 10.0


@pytest.mark.parametrize(
    ("track", "limited", "held", "parts"),
    [
        (filmed(hopping(**GENTLE), rate=120.0), "mu_static", "mu_kinetic", (1.2, 0.98, 1.02)),
        (plastic(1), "restitution", "restitution", (0.5, 1.02, 0.98)),
    ],
    ids=["friction", "restitution"],
)
def test_a_limit_is_where_the_sum_of_squares_has_risen(track, limited, held, parts):
    """By 2.71 above what it is at least, with the parameter held there."""
    known = {name: 0.0 for name in ("mu_excess", "restitution") if name != limited}
    _, limit = hh.fit(track, fixed=known, robust=False).limits[limited]
    least, beyond, within = (hh.fit(track, fixed=known | {held: limit * part}, robust=False).chi_square for part in parts)
    assert beyond - least > 2.6
    assert within - least < 2.8


@pytest.mark.long
def test_what_the_model_lacks_is_told(hop):
    """A brake: the shutter, which was not given, is no cause of it."""
    track = filmed(hop, rate=60.0)
    braked = track.centre - 0.05 * np.outer(track.t**2, [1.0, 0.0])
    view = View(Camera(1280, 720, 1150.0), 330.0, 0.0, 0.0, 0.0)
    fit = hh.fit(replace(track, centre=braked, view=view), fixed={"restitution": 0.3, "scale": 1.0, "stretch": 0.0})
    assert any(place["quantity"] == "x" for place in fit.misfits)
    assert not fit.good
    assert fit.usable
    said = fit.sentences()
    assert said[0].startswith("Not perfect, but usable")
    assert not any("shutter" in one for one in said)


def test_a_rolling_shutter_that_was_not_given_is_named(hop):
    """Rows are exposed one after the other: the hoop goes up and down the picture while it hops."""
    track, delay = filmed(hop, sigma=2e-4, sigma_angle=1e-3), 4e-6
    rows = 400.0 - 1500.0 * track.centre[:, 1]
    late = hop.at(np.clip(track.t + delay * (rows - rows.mean()), 0.0, hop.duration))
    errors = np.random.default_rng(2).normal(0.0, 2e-4, (2, len(track.t)))
    centre = np.column_stack([late.x + errors[0], late.height + RADIUS + errors[1]])
    seen = replace(track, centre=centre, angle=late.angle, pixel=np.column_stack([rows, rows]))
    view = View(Camera(1280, 720, 1150.0), 1500.0, 0.0, 0.0, 0.0)
    said = [
        shutter(solve(problem, parameters(values, tuple(TRUTH))), [one])
        for one in (replace(seen, view=view), replace(seen, view=replace(view, row_delay=delay)))
        for problem, values in [posed(one)]
    ]
    assert "The likely cause is the shutter" in said[0][0]
    assert said[1] == []
    slow = replace(seen, view=replace(view, camera=Camera(1280, 40_000, 1150.0)))  # rows that are read faster than this delay
    problem, values = posed(slow)
    assert shutter(solve(problem, parameters(values, tuple(TRUTH))), [slow]) == []


# --- pieces ----------------------------------------------------------------------------------------


def test_deviation_of_runs():
    # 3 runs of 10 and 10: expected 11 ± √(10·9/19)
    assert runs_deviation(np.repeat([1.0, -1.0, 1.0], [5, 10, 5])) == pytest.approx((3 - 11) / np.sqrt(10 * 9 / 19))


def test_scatter_from_third_differences():
    t = np.sort(np.random.default_rng(3).uniform(0, 1, 4000))
    values = 3.0 + t - 2.0 * t**2 + np.random.default_rng(4).normal(0, 0.01, 4000)
    assert scatter([(t, values)], "x") == pytest.approx(0.01, rel=0.1)
    even = np.arange(40) / 100.0
    assert scatter([(even, np.round(even**2, 1))], "x") >= 0.1 / np.sqrt(12.0)  # of the rounding
    assert scatter([(even, np.exp(even))], "omega") == GYROSCOPE
    with pytest.raises(ValueError, match="do not scatter: give --sigma"):
        scatter([(t, 0.0 * t)], "x")
    # weights of a third difference are 1/Π(t_i − t_j), with which t³ gives 1; a four with a gap is left out
    t, cubic = np.array([0.0, 1.0, 3.0, 4.0, 6.0, 7.0]), np.array([0.0, 1.0, 27.0, 64.0, 216.0, np.nan])
    sizes = np.sqrt([2 / 12**2 + 2 / 6**2, 2 / 30**2 + 2 / 6**2])
    assert third_differences(t, cubic) == pytest.approx(1 / sizes)


def test_the_recipe_of_a_sample_takes_the_residuals_of_the_fit(found):
    recipe = runpy.run_path(str(ROOT / "examples" / "posterior.py"))
    sampler = recipe["sampler"](found)
    off = sampler.userfcn(sampler.params)
    assert (off**2).sum() == pytest.approx(found.chi_square / found.inflation**2)
    assert {name for name, one in sampler.params.items() if one.vary} == set(found.settings["free"])
    pytest.importorskip("emcee")
    drawn = recipe["posterior"](found, steps=200, burn=100, walkers=20)
    assert drawn["gamma"].mean() == pytest.approx(found.values["gamma"], abs=2 * found.error("gamma"))


# --- files and pages -------------------------------------------------------------------------------


def test_a_page_of_a_fit_and_a_fit_that_is_read_again(found, tmp_path):
    named = replace(found, tracks=(replace(found.track, source="<script>&\"'.mp4"),))
    text = report(named, tmp_path).read_text(encoding="utf-8")
    assert re.findall(r">(\w+ \(\w+\)), one standard deviation", text) == ["x (mm)", "y (mm)", "angle (mrad)"]
    assert text.count("Fit of &lt;script&gt;&amp;&#34;&#39;.mp4") == 2
    assert "<script" not in text
    assert "mu_static" in text
    assert hh.Scenario.load(tmp_path / "scenario.toml") == found.scenario
    assert read_again(named, tmp_path).source == named.source
    (tmp_path / "other.json").write_text("{}")
    with pytest.raises(ValueError, match="is not a fit of hophoop"):
        hh.load_fit(tmp_path / "other.json")
    centre, angle = places_in_film(found)
    assert np.nanmax(np.abs(centre - found.track.centre)) < 5 * SIGMA
    assert np.nanmax(np.abs(angle - found.track.angle)) < 5 * SIGMA_ANGLE
    assert "<table>" in found._repr_html_()
    # a singular problem
    assert np.isnan(replace(found, covariance=-found.covariance).error("speed"))


# --- what goes wrong is one sentence ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"hoop": "round"}, "hoop = 'round' must be 'ideal', 'general' or a Hoop"),
        ({"hoop": hh.Hoop.ideal(0.6, radius=0.311)}, r"has the radius 0\.311 m and the data 0\.3 m"),
        ({"start": "late"}, "start = 'late' must be auto, rolling"),
        ({"free": ["spin"]}, "'spin' is no parameter of this fit; it has gamma"),
        ({"fixed": {"gamma": 0.5}, "free": ["gamma"]}, "gamma cannot be fixed and free"),
        ({"fixed": {"gamma": float("nan")}}, "fixed gamma = nan must be a finite number"),
        ({"bounds": {"gamma": (0.5, 0.2)}}, "bounds of gamma = 0.5, 0.2"),
        ({"tied": {"mu_excess": "nonsense +"}}, "tied mu_excess = 'nonsense \\+' is no expression"),
        ({"tied": {"mu_excess": "log(restitution)"}}, "tied mu_excess = 'log\\(restitution\\)' is no expression"),
        ({"tied": {"mu_excess": "len(open('/dev/null').read())"}}, "is no expression"),
        ({"tied": {"mu_excess": "gamma * restitution", "restitution": "mu_excess / 2"}}, "depend on each other in a circle"),
        ({"free": ["row_delay"]}, "row_delay cannot be fitted"),
        ({"free": ["mu_static"]}, "mu_static is no parameter of a fit: "),
    ],
)
def test_bad_input(hop, options, message):
    with pytest.raises(ValueError, match=message):
        hh.fit(filmed(hop, frames=40), **options)


def test_data_that_do_not_suffice(hop):
    for track, message in (
        (filmed(hop, frames=3), "too few frames to fit anything"),
        (replace(filmed(hop), radius=np.nan), "radius of the hoop is missing"),
    ):
        with pytest.raises(ValueError, match=message):
            hh.fit(track)
    for options, message in (({"rate": 2.0}, "would have 3 frames"), ({"sigma": 0.0}, "sigma = 0")):
        with pytest.raises(ValueError, match=message):
            hh.plan(hop.scenario, **options)


def test_a_matrix_that_rounding_makes_indefinite_has_no_inverse():
    """Its variances were below zero, and a fit to degrees in place of radians ended there."""
    almost = np.nextafter(1.0, 2.0)
    assert (inverse(np.array([[1.0, almost], [almost, 1.0]])) == np.inf).all()
    assert inverse(np.array([[4.0, 0.0], [0.0, 0.25]])).tolist() == [[0.25, 0.0], [0.0, 4.0]]
