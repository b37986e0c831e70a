"""Fits against motions whose parameters are known, and against what can be known without a fit."""

import json
from dataclasses import replace

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import PLANE, RADIUS, SIGMA, SIGMA_ANGLE, TRUTH, filmed, hopping, lasting, posed
from hophoop.fitting import report
from hophoop.fitting.channels import Autocorrelation, Sigma, scatter
from hophoop.fitting.covariance import autocorrelations, covariance_of
from hophoop.fitting.guess import merge_bounces, rates
from hophoop.fitting.judging import least_static_friction, runs_deviation
from hophoop.fitting.problem import problem_of, run_of
from hophoop.fitting.reporting import energies, places_in_film
from hophoop.fitting.solving import parameters, slopes
from hophoop.tracking.scatter import third_differences
from hophoop.tracking.table import track_of

# a fit asks for hundreds of motions
pytestmark = pytest.mark.compiled


def test_the_truth_is_found_within_its_uncertainties(found):
    assert found.good
    assert found.reduced == pytest.approx(1.0, abs=0.15)
    assert set(found.free) == set(TRUTH)
    for name, value in TRUTH.items():
        assert abs(found.values[name] - value) < 4 * found.error(name), name
    assert found.error("gamma") < 1e-3
    assert found.error("mu_static") < 0.02
    assert merge_bounces(found.motion.sequence) == "RKRSH+KR"
    assert found.shares["RKRSH+KR"] > 0.9
    assert found.scenario.plane.mu_static == pytest.approx(0.55, abs=0.04)


def test_the_centre_alone_tells_as_well(hop):
    fit = hh.fit(filmed(hop, angle=False))
    assert fit.good
    assert fit.values["gamma"] == pytest.approx(0.6, abs=0.005)
    assert np.cos(fit.values["angle0"]) == pytest.approx(np.cos(0.1), abs=0.01)
    # and says what it cannot tell apart
    assert {"gamma", "speed"} in [{first, second} for first, second, _ in fit.correlated]
    assert any("can hardly be distinguished" in sentence for sentence in fit.details())


def test_a_plan_says_what_the_fit_then_has(hop, found):
    how = {"sigma_angle": SIGMA_ANGLE, "sigma_scale": 0.0}
    plan = hh.plan(hop.scenario, rate=240.0, sigma=SIGMA, **how)
    assert plan.unseen == ()
    for name in TRUTH:
        # the soft loss costs some per cent, and so does another place of the minimum
        assert found.error(name) == pytest.approx(plan.errors[name], rel=0.35), name
    twice = hh.plan(hop.scenario, rate=240.0, sigma=2 * SIGMA, sigma_angle=2 * SIGMA_ANGLE, sigma_scale=0.0)
    assert twice.errors["gamma"] == pytest.approx(2 * plan.errors["gamma"], rel=1e-6)
    more = hh.plan(hop.scenario, rate=960.0, sigma=SIGMA, **how)
    assert more.errors["gamma"] == pytest.approx(0.5 * plan.errors["gamma"], rel=0.1)


def test_a_plan_has_limits_of_what_is_at_an_end_of_its_range():
    plan = hh.plan(hopping(plane=hh.Plane(mu=0.5), duration=1.01).scenario, rate=240.0, sigma=SIGMA, sigma_angle=SIGMA_ANGLE)
    told = {row[0]: row[1] for row in plan.rows()}
    assert set(plan.limits) == {"mu_excess", "restitution"}
    for name in plan.limits:
        sign, limit = plan.limits[name]
        assert sign == "≤"
        assert 0 < limit < 0.3
        assert told[name] == f"≤ {limit:.3g}"
        assert name not in plan.errors
        assert name not in plan.unseen
    assert max(plan.errors.values()) < 0.1  # nothing that cannot be told has a spread


def test_a_plan_has_limits_of_what_may_be_at_an_end_of_its_range():
    """A restitution that a film of this scatter could not tell from 0, and one that it could."""
    for restitution, told in ((0.01, "≤ "), (0.1, "0.1")):
        plane = hh.Plane(mu_static=0.6, mu_kinetic=0.5, restitution=restitution)
        scenario = hopping(hh.Hoop.ideal(0.7, radius=RADIUS), plane, hh.Start.rolling(2.1), 1.0).scenario
        plan = hh.plan(scenario, rate=240.0, sigma=3e-4, sigma_angle=1e-3)
        assert {row[0]: row[1] for row in plan.rows()}["restitution"].startswith(told)
        assert ("restitution" in plan.errors) == (restitution == 0.1)


def test_a_plan_names_bounces_in_a_row_once(hop):
    plan = hh.plan(hop.scenario, rate=60.0)
    assert "HHH" in plan.sequence
    assert f"{plan.frames} frames of the sequence RKRSH+KR." in plan.sentences()


def test_a_fit_has_a_limit_of_what_has_no_slope_at_the_end_of_its_range():
    """A landing so low that a small restitution changes nothing: a greater one does."""
    fit = hh.fit(
        filmed(hopping(hh.Hoop.ideal(0.75, radius=RADIUS), hh.Plane(mu=1.0), hh.Start.rolling(3.1 * RADIUS**0.5), 1.0))
    )
    assert fit.motion.find("impact")
    assert fit.values["restitution"] == 0.0
    sign, limit = fit.limits["restitution"]
    assert sign == "≤"
    assert 0.02 < limit < 0.5


# --- how uncertain ---------------------------------------------------------------------------------


def test_a_share_of_the_errors_that_lasts_is_found():
    """Under errors that are new in each frame a slow one hides, whose neighbours correlate by little, and for long."""
    track = track_of(np.arange(1000.0), {"x": np.arange(1000.0), "y": np.zeros(1000)}, radius=0.3, placed=True)
    problem = problem_of([run_of(track, "ideal", "rolling", PLANE, Sigma(1.0))])
    rng = np.random.default_rng(6)
    slow = np.sqrt(0.3) * lasting(rng.normal(size=1000), 0.9) + np.sqrt(0.7) * rng.normal(size=1000)
    found = dict(zip("xy", autocorrelations(problem, np.concatenate([slow, rng.normal(size=1000)]), False), strict=True))
    assert found["x"].frames == pytest.approx(1 + 2 * 0.3 * 0.9 / 0.1, rel=0.4)
    assert found["x"].share < 0.6
    assert found["y"].share == 0.0
    assert Autocorrelation(0.3, 0.9).frames == pytest.approx(1 + 2 * sum(0.3 * 0.9**k for k in range(1, 200)))


def test_errors_that_last_over_frames_count_less(hop):
    track, n = filmed(hop), int(hop.duration * 240)
    track = replace(track, centre=filmed(hop, 5, alike=0.7).centre)
    problem, values = posed(track)
    off = problem.residuals(values)
    found = dict(zip(("x", "y", "angle"), autocorrelations(problem, off, False), strict=True))
    for name in ("x", "y"):  # (1 + 0.7)/(1 − 0.7) of them say as much as one
        assert found[name].share * found[name].fade == pytest.approx(0.7, abs=0.2)
        assert found[name].frames == pytest.approx(17 / 3, rel=0.5)
    assert found["angle"].share == 0.0
    # A⁻¹ Jᵀ P J A⁻¹ with all of P written down
    names = tuple(TRUTH)
    jacobian = slopes(problem, parameters(values, names))
    apart = np.abs(np.subtract.outer(np.arange(n), np.arange(n)))
    whole = np.zeros((3 * n, 3 * n))
    for k, name in enumerate(("x", "y", "angle")):
        whole[k * n : k * n + n, k * n : k * n + n] = np.where(
            apart == 0, 1.0, found[name].share * found[name].fade ** apart.astype(float)
        )
    known = np.linalg.inv(jacobian.T @ jacobian)
    expected = known @ jacobian.T @ whole @ jacobian @ known
    assert covariance_of(problem, jacobian, off, False) == pytest.approx(expected, rel=1e-6)
    fit = hh.fit(track)
    assert fit.error("gamma") > 1.3 * hh.fit(filmed(hop)).error("gamma")
    assert any("Errors of x are correlated" in sentence for sentence in fit.details())


# --- what the film does not tell -------------------------------------------------------------------


def test_a_hoop_that_never_slips_gives_a_lower_limit(hop):
    motion = hopping(plane=hh.Plane(mu=0.9, restitution=0.2), start=hh.Start.rolling(1.0), duration=0.9)
    assert motion.sequence == "R"
    fit = hh.fit(filmed(motion))
    sign, least = fit.limits["mu_static"]
    assert sign == "≥"
    # the friction that rolling needs, in closed form, over the way that was filmed
    theta = np.linspace(0.0, motion.at(motion.duration).angle, 4000)
    forces = hh.theory.rolling_forces(theta, motion.scenario.hoop, 1.0)
    expected = np.max(np.abs(forces.friction / forces.normal))
    # a slip that is too short is not seen
    assert 0.85 * expected < least < 1.001 * expected
    assert fit.free == ("gamma", "x0", "angle0", "speed")
    assert any("never slips: static friction is at least" in note for note in fit.sentences())
    assert any("no impact" in note for note in fit.sentences())
    assert {row[0]: row[1] for row in fit.rows()}["restitution"] == "not determined"
    assert least_static_friction(motion) == pytest.approx(expected, rel=1e-4)
    assert least_static_friction(fit.motion) == pytest.approx(expected, rel=0.02)


def test_the_least_friction_is_where_the_sum_of_squares_has_risen(hop):
    """By 2.71 when friction is held there, and not when it is held a little higher."""
    motion = hopping(plane=hh.Plane(mu=0.9, restitution=0.2), start=hh.Start.rolling(1.0), duration=0.9)
    track = filmed(motion)
    known = {"mu_excess": 0.0, "restitution": 0.0}
    fit = hh.fit(track, fixed=known, robust=False)
    least = fit.limits["mu_static"][1]
    rise = [hh.fit(track, fixed={**known, "mu_kinetic": least * part}, robust=False).chi_square for part in (0.99, 1.01)]
    assert rise[0] - fit.chi_square > 2.6
    assert rise[1] - fit.chi_square < 2.8


@pytest.mark.long
def test_slip_must_be_seen_to_be_believed():
    """Noise is explained a little better by a short slip than by none, which does not make it one."""
    for seed in range(4):
        motion = hopping(plane=hh.Plane(mu=0.9), start=hh.Start.rolling(1.2, angle=0.1), duration=0.9)
        fit = hh.fit(filmed(motion, seed=seed, rate=44.0, sigma=2e-3, sigma_angle=2e-3))
        assert fit.limits["mu_static"][0] == "≥"
        assert "mu_kinetic" not in fit.free


def plastic(seed):
    """A film of two landings of a hoop that does not bounce: the sum of squares is flat from e = 0 to 0.02."""
    motion = hopping(hh.Hoop.ideal(0.7, radius=RADIUS), hh.Plane(mu=0.5, restitution=0.0), hh.Start.rolling(2.1), 1.0)
    return filmed(motion, seed, sigma=3e-4, sigma_angle=1e-3)


@pytest.mark.parametrize("seed", range(5))
def test_a_restitution_that_may_be_0_has_a_limit(seed):
    """Slopes of the minimum, which is anywhere on the flat, made it 0.029 ± 0.005 before."""
    fit = hh.fit(plastic(seed))
    sign, limit = fit.limits["restitution"]
    assert sign == "≤"
    assert 0.01 < limit < 0.06
    assert fit.values["restitution"] == 0.0
    assert "restitution" not in fit.to_dict()["errors"]
    assert dict(row[:2] for row in fit.rows())["restitution"] == f"≤ {limit:.3g}"


def test_near_an_end_an_uncertainty_is_at_least_what_the_sum_of_squares_there_says():
    """In this draw 0 is excluded by between two and three standard deviations; the slopes made it nine before."""
    track = plastic(39)
    fit, without = hh.fit(track), hh.fit(track, fixed={"restitution": 0.0})
    assert "restitution" not in fit.limits
    assert 2.0 < fit.values["restitution"] / fit.error("restitution") < 3.05
    assert 4.0 < without.chi_square - fit.chi_square < 10.0


def test_the_limit_is_where_the_sum_of_squares_has_risen():
    """By 2.71, above what it is at least; friction, that the restitution does not change, is known."""
    track, fixed = plastic(1), {"mu_excess": 0.0}
    limit = hh.fit(track, fixed=fixed, robust=False).limits["restitution"][1]
    grid = np.append(np.linspace(0.0, 1.1, 12), [0.98, 1.02]) * limit
    costs = [hh.fit(track, fixed={**fixed, "restitution": value}, robust=False).chi_square for value in grid]
    assert costs[-2] - min(costs) < 2.8
    assert costs[-1] - min(costs) > 2.6


def test_what_has_a_limit_leaves_the_others_less_certain_than_if_it_were_known():
    track = plastic(2)
    fit, known = hh.fit(track), hh.fit(track, fixed={"mu_excess": 0.0, "restitution": 0.0})
    assert fit.limits["mu_excess"][0] == "≤"
    assert fit.error("mu_kinetic") > 1.1 * known.error("mu_kinetic")
    assert fit.error("mu_kinetic") < 3.0 * known.error("mu_kinetic")


def test_residuals_that_run_together_are_told(hop):
    # pieces of one sign, and signs that change as chance has it
    assert runs_deviation(np.repeat([1.0, -1.0], 50)) < -9
    assert abs(runs_deviation(np.random.default_rng(1).normal(size=1000))) < 3
    # 3 runs of 10 and 10: expected 11 ± √(10·9/19)
    assert runs_deviation(np.array([1.0] * 5 + [-1.0] * 10 + [1.0] * 5)) == pytest.approx((3 - 11) / np.sqrt(10 * 9 / 19))
    track = filmed(hop)
    braked = track.centre.copy()
    braked[:, 0] -= 0.05 * track.t**2  # something that the model has not
    fit = hh.fit(replace(track, centre=braked), fixed={"restitution": 0.3})
    assert not fit.good
    assert any(place["quantity"] == "x" for place in fit.misfits)
    assert fit.sentences()[0].startswith("Not perfect, but usable" if fit.usable else "Wrong")


# --- what is fitted, fixed, tied -------------------------------------------------------------------


def test_fixed_tied_and_bounded(hop):
    track = filmed(hop)
    fit = hh.fit(track, fixed={"restitution": 0.3}, tied={"mu_excess": "mu_kinetic / 4.5"}, bounds={"gamma": (0.5, 0.7)})
    assert fit.good
    assert fit.values["restitution"] == 0.3
    assert fit.values["mu_excess"] == pytest.approx(fit.values["mu_kinetic"] / 4.5)
    assert "mu_excess" not in fit.free
    assert fit.error("restitution") == 0.0


def test_a_hoop_known_from_its_parts(hop):
    hoop = hh.Hoop.from_parts(radius=RADIUS, parts=[hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27)])
    motion = hopping(hoop=hoop, start=hh.Start.rolling(2.4))
    fit = hh.fit(filmed(motion), hoop=hoop)
    assert fit.good
    assert "gamma" not in fit.values
    assert fit.scenario.hoop == hoop


def test_outliers_count_little(hop):
    track = filmed(hop)
    places, rng = track.centre.copy(), np.random.default_rng(2)
    places[rng.choice(len(track.t), 12, replace=False)] += 0.02
    spoilt = replace(track, centre=places)
    soft, hard = hh.fit(spoilt), hh.fit(spoilt, robust=False)
    clean = hh.fit(track)
    off = [abs(one.values["speed"] - clean.values["speed"]) for one in (soft, hard)]
    assert off[0] < 0.3 * off[1]


def test_axes_of_the_data_that_do_not_lie_along_the_plane(hop):
    track = filmed(hop)
    turn = 0.05
    turned = track.centre @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) + [0.3, -0.2]
    fit = hh.fit(replace(track, centre=turned, angle=track.angle - turn, placed=False))
    assert fit.good
    assert fit.values["tilt"] == pytest.approx(turn, abs=1e-3)
    assert fit.values["gamma"] == pytest.approx(0.6, abs=5e-3)


def test_a_start_that_slides_or_flies(hop):
    sliding = hopping(start=hh.Start(vx=2.0, omega=3.0, angle=0.4), duration=0.8)
    fit = hh.fit(filmed(sliding))
    assert fit.settings["starts"] == ["sliding"]
    assert fit.good
    assert fit.values["omega0"] == pytest.approx(3.0, abs=0.1)
    flying = hopping(start=hh.Start(vx=1.0, height=0.05, omega=4.0, angle=0.4), duration=0.8)
    fit = hh.fit(filmed(flying))
    assert fit.settings["starts"] == ["flying"]
    assert fit.good
    assert fit.values["height0"] == pytest.approx(0.05, abs=2e-3)


# --- pieces ----------------------------------------------------------------------------------------


def test_rates_of_a_parabola_are_its_own():
    t = np.arange(40) / 240.0
    found = rates(t, 1.0 + 2.0 * t - 5.0 * t**2, np.full(40, 1e-3))
    assert found.rate == pytest.approx(2.0 - 10.0 * t, abs=1e-8)


def test_scatter_from_third_differences():
    t = np.sort(np.random.default_rng(3).uniform(0, 1, 4000))
    values = 3.0 + t - 2.0 * t**2 + np.random.default_rng(4).normal(0, 0.01, 4000)
    assert scatter(t, values) == pytest.approx(0.01, rel=0.1)
    with pytest.raises(ValueError, match="do not scatter: give sigma"):
        scatter(t, 0.0 * t)
    # weights of a third difference are 1/Π(t_i − t_j), with which t³ gives 1; a four with a gap is left out
    t, cubic = np.array([0.0, 1.0, 3.0, 4.0, 6.0, 7.0]), np.array([0.0, 1.0, 27.0, 64.0, 216.0, np.nan])
    sizes = np.sqrt([2 / 12**2 + 2 / 6**2, 2 / 30**2 + 2 / 6**2])
    assert third_differences(t, cubic) == pytest.approx(1 / sizes)


def test_energies_from_the_data_are_those_of_the_motion(found):
    for times, measured, computed in energies(found).values():
        assert np.ptp(times) > 0.9
        # both are smoothed alike, so that the peaks agree as well; at the ends there are fewer data
        inside = slice(6, -6)
        assert measured[inside] == pytest.approx(computed[inside], abs=0.06 * np.ptp(computed))


# --- files and pages -------------------------------------------------------------------------------


def test_a_saved_fit_is_the_same(found, tmp_path):
    found.save(tmp_path / "fit.json")
    back = hh.load_fit(tmp_path / "fit.json")
    assert back.values == found.values
    assert (back.covariance == found.covariance).all()
    assert back.motion.sequence == found.motion.sequence
    assert back.rows() == found.rows()
    assert back.sentences() == found.sentences()
    assert back.details() == found.details()
    for name, off in found.residuals.items():
        assert (back.residuals[name] == off).all()
    (tmp_path / "other.json").write_text("{}")
    with pytest.raises(ValueError, match="is not a fit of hophoop"):
        hh.load_fit(tmp_path / "other.json")


def test_a_page_of_a_fit(found, tmp_path):
    page = report(found, tmp_path / "out")
    text = page.read_text(encoding="utf-8")
    assert text.count('<div class="plot">') == 5
    assert "mu_static" in text
    assert json.loads((tmp_path / "out" / "fit.json").read_text())["good"] is True
    assert hh.Scenario.load(tmp_path / "out" / "scenario.toml") == found.scenario
    centre, angle = places_in_film(found)
    assert np.nanmax(np.abs(centre - found.track.centre)) < 5 * SIGMA
    assert np.nanmax(np.abs(angle - found.track.angle)) < 5 * SIGMA_ANGLE
    assert "<table>" in found._repr_html_()


def test_a_page_of_a_fit_escapes_names(found, tmp_path):
    named = replace(found, tracks=(replace(found.track, source="<script>&\"'.mp4"),))
    text = report(named, tmp_path).read_text(encoding="utf-8")
    assert text.count("Fit of &lt;script&gt;&amp;&#34;&#39;.mp4") == 2
    assert "<script" not in text


# --- what goes wrong is one sentence ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"hoop": "round"}, "hoop = 'round' must be 'ideal', 'general' or a Hoop"),
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
        *(
            ({"free": [name]}, f"{name} is no parameter of a fit: ")
            for name in ("t0", "mass", "radius", "mu_static", "gravity")
        ),
    ],
)
def test_bad_input(hop, options, message):
    with pytest.raises(ValueError, match=message):
        hh.fit(filmed(hop, frames=40), **options)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda hop: hh.fit(filmed(hop, frames=3)), "too few frames to fit anything"),
        (lambda hop: hh.fit(replace(filmed(hop), radius=np.nan)), "radius of the hoop is missing"),
        (lambda hop: hh.plan(hop.scenario, rate=2.0), "would have 3 frames"),
        (lambda hop: hh.plan(hop.scenario, sigma=0.0), "sigma = 0"),
    ],
)
def test_data_that_do_not_suffice(hop, call, message):
    with pytest.raises(ValueError, match=message):
        call(hop)
