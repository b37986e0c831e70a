"""The article's statements, each computed another way as well, and the whole report."""

import contextlib
import dataclasses
import importlib
import json
import math
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar
from typer.testing import CliRunner

import hophoop as hh
from hophoop.article import rolling, slipping
from hophoop.article.figures import FIGURES
from hophoop.article.runs import Runs
from hophoop.article.scenarios import scenarios
from hophoop.article.statement import DIFFERS, FAILS, VERDICTS, WITHIN_READING
from hophoop.article.statements import STATED
from hophoop.cli import app

# the package gives its name to the function
module = importlib.import_module("hophoop.article.reproduce")

DATA = Path(__file__).parents[1] / "data"
GAMMA, G = 0.75, 9.81


@pytest.fixture(scope="module")
def runs():
    return Runs()


@pytest.fixture(scope="module")
def found(runs):
    return {one.key: one for one in hh.article.statements(runs)}


def forces_in_rolling(theta, v0):
    """F and N of the rolling ideal hoop from its energy and Newton's law alone, R = m = 1."""

    def u(angle):
        return (GAMMA * G * (1 - np.cos(angle)) + v0**2 * (1 + GAMMA)) / (1 + GAMMA * np.cos(angle))

    step = 1e-5
    acceleration = (u(theta + step) - u(theta - step)) / (4 * step)
    friction = acceleration + GAMMA * (acceleration * np.cos(theta) - u(theta) * np.sin(theta))
    normal = G - GAMMA * (acceleration * np.sin(theta) + u(theta) * np.cos(theta))
    return friction, normal


def used_in_rolling(theta, v0):
    friction, normal = forces_in_rolling(theta, v0)
    return friction / normal


def greatest_use(v0):
    grid = np.linspace(0.01, math.pi - 0.01, 2000)
    start = grid[np.argmax(np.abs(used_in_rolling(grid, v0)))]
    best = minimize_scalar(
        lambda angle: -abs(used_in_rolling(angle, v0)), bounds=(start - 0.01, start + 0.01), method="bounded"
    )
    return -best.fun


def test_every_statement_has_a_verdict_and_none_fails(found):
    assert len(found) == len(STATED) >= 25
    assert {one.verdict for one in found.values()} <= set(VERDICTS)
    assert [one.key for one in found.values() if one.verdict == FAILS] == []
    assert {one.key for one in found.values() if one.verdict == DIFFERS} == {
        "littlewood", "ends_rolling", "landing",
    }  # fmt: skip
    assert found["positive_potential"].verdict == WITHIN_READING
    for one in found.values():
        assert all((one.ours, one.article, one.statement, one.numbers)), one.key
        if one.verdict == DIFFERS:
            assert one.why


def test_five_scenarios_by_name():
    scenarios = hh.article.scenarios()
    told = {name: (one.start.speed, one.plane.mu) for name, one in scenarios.items()}
    fast = {"faster": (2.0, 1.0), "slipping": (2.8, 1.0), "hop": (3.1, 1.0)}
    assert told == {"slow": (0.1, 1.0), **fast, "low_friction": (0.1, 0.3)}
    for one in scenarios.values():
        assert (one.hoop.radius, one.hoop.mass, one.hoop.load_fraction, one.plane.gravity) == (1, 1, GAMMA, G)
        assert hh.simulate(one).ok


def test_friction_used_from_energy_and_newton_alone(found):
    assert found["friction_used"].numbers["utilization"] == pytest.approx(greatest_use(0.1), rel=1e-8)
    assert found["friction_needed"].numbers["mu"] == pytest.approx(greatest_use(0.1), rel=1e-8)
    assert found["faster_friction_used"].numbers["utilization"] == pytest.approx(greatest_use(2.0), rel=1e-8)


def test_critical_speed_from_energy_and_newton_alone(found):
    speed = brentq(lambda v0: greatest_use(v0) - 1.0, 2.0, 2.1, xtol=1e-9)
    assert found["critical_speed"].numbers["first_slip_speed"] == pytest.approx(speed, abs=1e-7)


def reference(name):
    return json.loads((DATA / name).read_text(encoding="utf-8"))


def test_hop_from_the_reference_data(found):
    events = reference("article_v3.1_mu1.json")["events"]
    off = next(event for event in events if event["kind"] == "takeoff")
    down = next(event for event in events if event["kind"] == "impact")
    numbers = found["hops"].numbers
    assert numbers["takeoff_t"] == pytest.approx(float(off["t"]), rel=1e-11)
    assert math.radians(numbers["takeoff_angle_deg"]) == pytest.approx(float(off["angle"]), rel=1e-11)
    assert math.radians(numbers["landing_angle_deg"]) == pytest.approx(float(down["angle"]), rel=1e-11)
    assert found["constant_rotation"].numbers["omega"] == pytest.approx(float(off["omega"]), rel=1e-11)


def test_potential_is_zero_where_it_is_said_to_be(found, runs):
    motion = runs.motion("hop")
    first, second = (math.radians(angle) for angle in found["positive_potential"].numbers["angles_deg"])
    flight = motion.find("takeoff")[0]
    # in flight: the gap makes up for the lowered centre of gravity
    times = [flight.t + (angle - flight.angle) / flight.omega for angle in (first, second)]
    for t, angle in zip(times, (first, second), strict=True):
        height = motion.at(t).height
        assert height == pytest.approx(GAMMA * (1.0 - math.cos(angle)), abs=1e-9)
    assert motion.at(0.5 * sum(times)).potential > 0.0


def test_extremes_of_the_hop_from_its_events(found, runs):
    """Not the largest of samples: 0.4181 J and 7.1970 m/s."""
    off, down = (runs.motion("hop").find(kind)[0] for kind in ("takeoff", "impact"))
    up = -GAMMA * off.omega * math.sin(off.angle)  # of the centre of gravity; its rise is up²/2g
    highest = GAMMA * G * (math.cos(off.angle) - 1.0) + up**2 / 2.0
    assert found["positive_potential"].numbers["largest"] == pytest.approx(highest, rel=1e-12)
    assert found["positive_potential"].ours.endswith("up to 0.4182 J")
    flight = found["centre_in_flight"]
    along = off.vx + GAMMA * off.omega * math.cos(off.angle)
    assert flight.numbers["least"] == pytest.approx(along - GAMMA * off.omega, rel=1e-12)  # the load at the top
    assert flight.numbers["largest"] == pytest.approx(down.before.vx, rel=1e-9)
    assert flight.ours.startswith("centre from 1.4831 to 7.2099 m/s")


def test_extremes_of_rolling_from_energy_and_newton_alone(found):
    peaks = [math.sqrt((2.0 * GAMMA * G + v0**2 * (1.0 + GAMMA)) / (1.0 - GAMMA)) for v0 in (0.1, 2.0)]
    assert found["slow_motion"].numbers["largest_speed"] == pytest.approx(peaks[0], rel=1e-12)
    assert found["faster_rolls"].numbers["ratio_of_speeds"] == pytest.approx([peaks[0] / 0.1, peaks[1] / 2.0], rel=1e-12)
    for name, v0 in (("slow", 0.1), ("faster", 2.0)):
        best = minimize_scalar(lambda angle, v0=v0: forces_in_rolling(angle, v0)[1], bounds=(3.3, 6.0), method="bounded")
        assert found["normal_force"].numbers["least_normal_force"][name] == pytest.approx(best.fun, abs=1e-7)


def test_largest_slip_and_peaks_by_another_search(found, runs):
    motion = hh.simulate(runs.motion("slipping").scenario.replace("duration", 9.0))

    def greatest(measure, low, high):
        return -minimize_scalar(lambda t: -measure(motion.at(t)), bounds=(low, high), method="bounded").fun

    assert found["slips"].numbers["largest_slip"] == pytest.approx(
        greatest(lambda state: abs(state.slip), *(motion.find(kind)[1].t for kind in ("slip_start", "stick"))), abs=1e-9
    )
    for k, peak in enumerate(found["peaks_fall"].numbers["peaks"]):
        grid = motion.times(901)
        near = grid[np.argmin(np.abs(motion.at(grid).angle - (2 * k + 1) * math.pi))]
        assert peak == pytest.approx(greatest(lambda state: state.vx, near - 0.05, near + 0.05), abs=1e-9)


def test_impact_loss_from_the_velocities(found, runs):
    down = runs.motion("hop").find("impact")[0]

    def kinetic(vx, vy, omega):
        along, up = vx + GAMMA * omega * math.cos(down.angle), vy - GAMMA * omega * math.sin(down.angle)
        return 0.5 * (along**2 + up**2 + (1 - GAMMA**2) * omega**2)

    lost = kinetic(down.before.vx, down.before.vy, down.before.omega) - kinetic(down.vx, down.vy, down.omega)
    numbers = found["impact_loss"].numbers
    assert numbers["lost"] == pytest.approx(lost, rel=1e-12)
    assert numbers["normal"] + numbers["tangential"] == numbers["lost"]
    ledger = runs.motion("hop").ledger
    assert numbers["lost"] == pytest.approx(ledger.impact_normal + ledger.impact_tangential, rel=1e-15)


def test_law_of_the_slow_end_against_a_long_motion(runs, found):
    motion = hh.simulate(runs.motion("slipping").scenario.replace("duration", 6000.0))
    limit = found["ends_rolling"].numbers["excess_times_t_limit"]
    critical = float(hh.theory.first_slip_speed(runs.hoop, runs.plane))
    floor = (1.0 + GAMMA) * critical**2
    products = []
    for t in (2000.0, 6000.0):
        last = next(event for event in reversed(motion.find("stick")) if event.t <= t)
        products.append((float(motion.at(last.t).total) - floor) * t)
    # from Δ₀ on, Δ = (T/c)/(t + t₀) but for smaller terms: what is missing falls as 1/t
    assert products[0] < products[1] < limit
    assert limit - products[1] == pytest.approx((limit - products[0]) / 3.0, rel=0.2)
    assert products == pytest.approx([94.50, 95.85], abs=0.005)
    assert slipping.slip_below(motion, (0.01,))[0.01] == pytest.approx(189.0, abs=0.05)


def test_the_page_tells_what_is_computed(found):
    page = " ".join((Path(__file__).parents[2] / "docs" / "article.md").read_text(encoding="utf-8").split())
    numbers = found["ends_rolling"].numbers
    assert f"{numbers['excess_times_t_limit']:.3f} J s" in page
    assert f"below 1 cm/s after {numbers['slip_below']['0.01']:.1f} s" in page
    assert f"below 0.1 m/s after {numbers['slip_below']['0.1']:.1f} s" in page
    assert f"{numbers['critical_speed']:.6f} m/s" in page


def test_turning_angles_are_at_rest(found, runs):
    motion = runs.motion("low_friction")
    turns = motion.find("turn")
    assert [math.degrees(turn.angle) for turn in turns] == found["low_friction_rocks"].numbers["turning_angles_deg"]
    assert all(abs(turn.omega) < 1e-12 for turn in turns)


def test_a_wrong_motion_fails(runs):
    """The checks can fail: they are given motions that are not the article's."""
    wrong = Runs()
    motion = wrong.motion
    names = dict.fromkeys(("slow", "faster"), "slipping") | dict.fromkeys(("slipping", "low_friction"), "slow")
    wrong.motion = lambda name: motion(names.get(name, name))
    checks = (
        rolling.slow_motion,
        rolling.kinetic_energy,
        rolling.angular_velocity,
        rolling.faster_rolls,
        slipping.low_friction_slips,
    )
    for check in checks:
        assert not check(wrong).holds, check
    wrong.sample("hop").omega[wrong.sample("hop").mode == "H"] *= np.linspace(
        1.0, 1.1, int((wrong.sample("hop").mode == "H").sum())
    )
    assert not slipping.constant_rotation(wrong).holds
    assert not slipping.centre_in_flight(wrong).holds


def test_a_motion_without_its_events_fails_in_words():
    wrong = Runs()
    motion = wrong.motion
    wrong.motion = lambda name: motion("slow")
    verdicts = {one.key: one.verdict for one in hh.article.statements(wrong)}
    assert verdicts["hops"] == verdicts["low_friction_rocks"] == FAILS


class Page(HTMLParser):
    """Links, pictures and open elements of a page."""

    VOID = frozenset({"meta", "img", "br", "link", "mspace"})

    def __init__(self, text):
        super().__init__()
        self.sources, self.links, self.ids, self.open = [], [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.sources += [values["src"]] if "src" in values else []
        self.links += [values["href"]] if "href" in values else []
        self.ids |= {values["id"]} if "id" in values else set()
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        """A MathML element that is empty."""

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@pytest.mark.slow
def test_reproduce_from_end_to_end(tmp_path):
    out = tmp_path / "new" / "article"
    done = CliRunner().invoke(app, ["reproduce", "--out", str(out), "--no-films"])
    assert done.exit_code == 0, done.stderr
    assert "differs" in done.stdout
    assert str(out / "index.html") in done.stderr
    for figure in FIGURES:
        assert (out / "figures" / f"{figure.name}.png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in (out / "figures" / f"{figure.name}.svg").read_text(encoding="utf-8")
    data = json.loads((out / "statements.json").read_text(encoding="utf-8"))
    assert data["schema"] == "hophoop-article/1"
    assert len(data["statements"]) == len(STATED)
    page = Page((out / "index.html").read_text(encoding="utf-8"))
    assert page.open == []
    assert all(source.startswith("data:image/svg+xml;base64,") for source in page.sources)
    assert len(page.sources) == len(FIGURES)
    assert {link[1:] for link in page.links if link.startswith("#")} <= page.ids
    beside = {link for link in page.links if not link.startswith(("#", "http"))}
    assert beside == {"statements.json"} | {f"figures/{figure.name}.svg" for figure in FIGURES}
    assert all((out / link).exists() for link in beside)
    assert {one["key"] for one in data["statements"]} <= page.ids


@pytest.mark.slow
def test_a_failing_statement_is_told_by_the_exit_status(tmp_path, monkeypatch):
    honest = module.statements

    def one_fails(runs, progress):
        first, *rest = honest(runs, progress)
        return (dataclasses.replace(first, verdict=FAILS), *rest)

    monkeypatch.setattr(module, "statements", one_fails)
    films = tmp_path / "films"

    @contextlib.contextmanager
    def fake(out):
        films.mkdir()
        (films / "v3.1.mp4").write_bytes(b"film")
        yield lambda progress: [films / "v3.1.mp4"]

    monkeypatch.setattr(module, "_films", fake)
    done = CliRunner().invoke(app, ["reproduce", "--out", str(tmp_path), "--quiet"])
    assert done.exit_code == 1
    assert "slow_motion" in done.stderr
    page = Page((tmp_path / "index.html").read_text(encoding="utf-8"))
    assert "films/v3.1.mp4" in page.sources


def test_the_report_counts_losses_as_its_figures_do():
    """The tangential loss of the landing at 3.1 m/s is counted as friction, in the table of motions too."""
    row = module.report._run(scenarios()["hop"], Runs().motion("hop"))
    sample = Runs().sample("hop")
    assert row.cells[2:4] == [f"{sample.friction_loss[-1]:.4f}", f"{sample.normal_loss[-1]:.4f}"]
    assert sample.impact_tangential[-1] > 0.1
