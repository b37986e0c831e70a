"""The article's statements, each computed another way as well, and the whole report."""

import dataclasses
import importlib
import json
import math
from contextlib import contextmanager

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import hophoop as hh
from checkout import text_of
from cli_tools import done
from hophoop.article import rolling, slipping
from hophoop.article.figures import FIGURES
from hophoop.article.runs import Runs
from hophoop.article.statement import AGREES, DIFFERS, FAILS, WITHIN_READING
from hophoop.article.statements import STATED

# the package gives its name to the function
module = importlib.import_module("hophoop.article.reproduce")

GAMMA, G = 0.75, 9.81


def forces_in_rolling(theta, v0):
    """F and N of the rolling ideal hoop from its energy and Newton's law alone, R = m = 1."""

    def u(angle):
        return (GAMMA * G * (1 - np.cos(angle)) + v0**2 * (1 + GAMMA)) / (1 + GAMMA * np.cos(angle))

    step = 1e-5
    acceleration = (u(theta + step) - u(theta - step)) / (4 * step)
    friction = acceleration + GAMMA * (acceleration * np.cos(theta) - u(theta) * np.sin(theta))
    normal = G - GAMMA * (acceleration * np.sin(theta) + u(theta) * np.cos(theta))
    return friction, normal


def greatest(measure, low, high, *more):
    """The maximum of a measure, refined about the largest of some samples."""
    grid = np.linspace(low, high, 2000)
    k = int(np.argmax(measure(grid, *more)))
    bounds = grid[[max(k - 1, 0), min(k + 1, 1999)]]
    return -minimize_scalar(lambda one: -measure(one, *more), bounds=bounds, method="bounded", options={"xatol": 1e-8}).fun


def used(theta, v0):
    friction, normal = forces_in_rolling(theta, v0)
    return abs(friction / normal)


def most_used(v0):
    return greatest(used, 0.01, math.pi, v0)


def test_every_statement_has_a_verdict_and_none_fails(found):
    assert len(found) == len(STATED) >= 25
    assert {one.verdict for one in found.values()} <= {AGREES, WITHIN_READING, DIFFERS}
    assert {one.key for one in found.values() if one.verdict == DIFFERS} == {
        "littlewood", "ends_rolling", "landing",
    }  # fmt: skip
    assert found["positive_potential"].verdict == WITHIN_READING
    for one in found.values():
        assert all((one.ours, one.article, one.statement, one.numbers, one.why or one.verdict != DIFFERS)), one.key


def test_rolling_from_energy_and_newton_alone(numbers):
    assert numbers["friction_used"]["utilization"] == pytest.approx(most_used(0.1), rel=1e-8)
    assert numbers["friction_needed"]["mu"] == pytest.approx(most_used(0.1), rel=1e-8)
    assert numbers["faster_friction_used"]["utilization"] == pytest.approx(most_used(2.0), rel=1e-8)
    critical = brentq(lambda v0: most_used(v0) - 1.0, 2.0, 2.1, xtol=1e-9)
    assert numbers["critical_speed"]["first_slip_speed"] == pytest.approx(critical, abs=1e-7)
    peaks = [math.sqrt((2.0 * GAMMA * G + v0**2 * (1.0 + GAMMA)) / (1.0 - GAMMA)) for v0 in (0.1, 2.0)]
    assert numbers["slow_motion"]["largest_speed"] == pytest.approx(peaks[0], rel=1e-12)
    assert numbers["faster_rolls"]["ratio_of_speeds"] == pytest.approx([peaks[0] / 0.1, peaks[1] / 2.0], rel=1e-12)
    least = {name: -greatest(lambda one, v0: -forces_in_rolling(one, v0)[1], 3.3, 6.0, v0) for name, v0 in SLOW_ONES}
    assert numbers["normal_force"]["least_normal_force"] == pytest.approx(least, abs=1e-7)


SLOW_ONES = (("slow", 0.1), ("faster", 2.0))


def test_hop_from_the_reference_data(numbers):
    events = {event["kind"]: event for event in json.loads(text_of("tests/data/article_v3.1_mu1.json"))["events"]}
    off, down = events["takeoff"], events["impact"]
    hops = numbers["hops"]
    for ours, reference in (
        (hops["takeoff_t"], off["t"]),
        (math.radians(hops["takeoff_angle_deg"]), off["angle"]),
        (math.radians(hops["landing_angle_deg"]), down["angle"]),
        (numbers["constant_rotation"]["omega"], off["omega"]),
    ):
        assert ours == pytest.approx(float(reference), rel=1e-11)


def test_flight_and_landing_from_their_events(found, numbers, runs):
    """The largest is not the largest of samples: 0.4181 J and 7.1970 m/s."""
    motion = runs.motion("hop")
    off, down = (motion.find(kind)[0] for kind in ("takeoff", "impact"))
    potential, flight = numbers["positive_potential"], numbers["centre_in_flight"]
    # zero where the gap makes up for the lowered centre of gravity
    angle = np.radians(potential["angles_deg"])
    height = motion.at(off.t + (angle - off.angle) / off.omega).height
    assert height == pytest.approx(GAMMA * (1.0 - np.cos(angle)), abs=1e-9)
    up = -GAMMA * off.omega * math.sin(off.angle)  # of the centre of gravity; its rise is up²/2g
    highest = GAMMA * G * (math.cos(off.angle) - 1.0) + up**2 / 2.0
    assert potential["largest"] == pytest.approx(highest, rel=1e-12)
    assert found["positive_potential"].ours.endswith("up to 0.4182 J")
    along = off.vx + GAMMA * off.omega * math.cos(off.angle)
    assert flight["least"] == pytest.approx(along - GAMMA * off.omega, rel=1e-12)  # the load at the top
    assert flight["largest"] == pytest.approx(down.before.vx, rel=1e-9)
    assert found["centre_in_flight"].ours.startswith("centre from 1.4831 to 7.2099 m/s")
    kinetic = []
    for state in (down.before, down):
        along = state.vx + GAMMA * state.omega * math.cos(down.angle)
        up = state.vy - GAMMA * state.omega * math.sin(down.angle)
        kinetic.append(0.5 * (along**2 + up**2 + (1 - GAMMA**2) * state.omega**2))
    assert numbers["impact_loss"]["lost"] == pytest.approx(kinetic[0] - kinetic[1], rel=1e-12)


def test_largest_slip_and_peaks_by_another_search(numbers, runs):
    motion = hh.simulate(runs.motion("slipping").scenario.replace("duration", 9.0))
    skid = [motion.find(kind)[1].t for kind in ("slip_start", "stick")]
    assert numbers["slips"]["largest_slip"] == pytest.approx(greatest(lambda t: abs(motion.at(t).slip), *skid), abs=1e-9)
    grid = motion.times(901)
    for k, peak in enumerate(numbers["peaks_fall"]["peaks"]):
        near = grid[np.argmin(np.abs(motion.at(grid).angle - (2 * k + 1) * math.pi))]
        assert peak == pytest.approx(greatest(lambda t: motion.at(t).vx, near - 0.05, near + 0.05), abs=1e-9)


def test_law_of_the_slow_end_against_a_long_motion(runs, numbers):
    motion = hh.simulate(runs.motion("slipping").scenario.replace("duration", 6000.0))
    limit = numbers["ends_rolling"]["excess_times_t_limit"]
    critical = float(hh.theory.first_slip_speed(runs.hoop, runs.plane))
    products = []
    for t in (2000.0, 6000.0):
        last = next(event for event in reversed(motion.find("stick")) if event.t <= t)
        products.append((float(motion.at(last.t).total) - (1.0 + GAMMA) * critical**2) * t)
    # from Δ₀ on, Δ = (T/c)/(t + t₀) but for smaller terms: what is missing falls as 1/t
    assert limit - products[1] == pytest.approx((limit - products[0]) / 3.0, rel=0.2)
    assert products == pytest.approx([94.50, 95.85], abs=0.005)
    assert slipping.slip_below(motion, 0.01) == pytest.approx(189.0, abs=0.05)


def test_the_page_tells_what_is_computed(numbers):
    page = " ".join(text_of("docs/article.md").split())
    ends = numbers["ends_rolling"]
    assert f"{ends['excess_times_t_limit']:.3f} J s" in page
    assert f"below 1 cm/s after {ends['slip_below']['0.01']:.1f} s" in page
    assert f"below 0.1 m/s after {ends['slip_below']['0.1']:.1f} s" in page
    assert f"{ends['critical_speed']:.6f} m/s" in page


def test_a_wrong_motion_fails():
    """The checks can fail: they are given motions that are not the article's."""
    wrong = Runs()
    motion = wrong.motion
    names = dict.fromkeys(("slow", "faster"), "slipping") | dict.fromkeys(("slipping", "low_friction"), "slow")
    wrong.motion = lambda name: motion(names.get(name, name))
    sample = wrong.sample("hop")
    sample.omega[sample.mode == "H"] *= np.linspace(1.0, 1.1, int((sample.mode == "H").sum()))
    for check in (
        rolling.slow_motion,
        rolling.kinetic_energy,
        rolling.angular_velocity,
        rolling.faster_rolls,
        slipping.low_friction_slips,
        slipping.constant_rotation,
        slipping.centre_in_flight,
    ):
        assert not check(wrong).holds, check
    # without its events, in words
    wrong.motion = lambda name: motion("slow")
    verdicts = {one.key: one.verdict for one in hh.article.statements(wrong)}
    assert verdicts["hops"] == verdicts["low_friction_rocks"] == FAILS


@pytest.mark.parametrize("fails", [False, True])
def test_reproduce_writes_a_report_and_tells_a_failing_statement_by_its_status(folder, monkeypatch, statements, fails):
    """With one figure drawn and one film, which is none; README's first command makes all of them."""
    films, checked = folder / "films", (dataclasses.replace(statements[0], verdict=FAILS), *statements[1:])

    @contextmanager
    def fake(out):
        films.mkdir()
        (films / "v3.1.mp4").write_bytes(b"film")
        yield lambda progress: [films / "v3.1.mp4"]

    monkeypatch.setattr(module, "statements", lambda runs, progress: checked if fails else statements)
    monkeypatch.setattr(module, "FIGURES", FIGURES[:1])
    monkeypatch.setattr(module, "started_films", fake)
    found = done("reproduce --out", folder, "--films" if fails else "--no-films", status=fails)
    assert "differs" in found.stdout
    assert ("slow_motion" in found.stderr) == fails
    assert str(folder / "index.html") in found.stderr
    data = json.loads((folder / "statements.json").read_text(encoding="utf-8"))
    assert data["schema"] == "hophoop-article/1"
    assert (data["statements"][0]["verdict"] == FAILS) == fails
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert ('src="films/v3.1.mp4"' in page) == ("<video" in page) == fails
    assert ("No films: they were not requested" in found.stderr) == (not fails)
    assert page.count('src="data:image/svg+xml;base64,') == len(FIGURES)
    for ending in ("svg", "png"):
        assert (folder / "figures" / f"{FIGURES[0].name}.{ending}").stat().st_size > 1000
