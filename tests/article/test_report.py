"""The report: its formulas hold on the computed motions, its numbers are computed, and nothing of the article is left out."""

import html
import math
import re
import xml.etree.ElementTree as tree
from functools import cache
from importlib.resources import files

import math_core
import pytest

import hophoop as hh
from hophoop.article import report
from hophoop.article.facts import facts
from hophoop.article.figures import FIGURES
from hophoop.article.films import ARTICLE_FILMS
from hophoop.article.formulas import COMPUTED, FORMULAS
from hophoop.article.runs import first_time
from hophoop.article.scenarios import scenarios
from hophoop.article.typeset import mathml, typeset
from latex_values import sides

STORY = files("hophoop.article").joinpath("story.html").read_text(encoding="utf-8")
GAMMA, G = 0.75, 9.81
# another hoop than the article's, which moves alike: with R = m = 1 a missing factor would not be seen
RADIUS, MASS = 0.3, 2.0
BODY = {"m": MASS, "R": RADIUS, "g": G, "\\gamma": GAMMA, "\\mu": 1.0}


@cache
def scaled(speed):
    """The article's run at a speed, with another radius and mass."""
    start = hh.Start.rolling(speed * math.sqrt(RADIUS))
    return hh.simulate(hh.Hoop.ideal(GAMMA, radius=RADIUS, mass=MASS), hh.Plane(mu=1.0), start, duration=1.5)


def at(motion, t, **more):
    """The symbols of the formulas at a time of a motion; the acceleration by a difference of the angular velocity."""
    state, step = motion.at(t), 1e-6
    accelerated = (motion.at(t + step).omega - motion.at(t - step).omega) / (2.0 * step)
    return BODY | {
        "\\theta": state.angle,
        "\\dot\\theta": state.omega,
        "\\ddot\\theta": accelerated,
        "W_k": state.kinetic,
        "W_p": state.potential,
        "F": state.friction_force,
        "N": state.normal_force,
        "v": state.vx,
        "v_0": motion.scenario.start.speed,
        **more,
    }


def cases(name):
    """Values at which a formula must hold, from computed motions."""
    rolling, hop = scaled(2.0), scaled(3.1)
    off, down = hop.find("takeoff")[0], hop.find("impact")[0]
    if name in ("gap", "velocity_in_flight"):
        level = off.vx + GAMMA * RADIUS * off.omega * math.cos(off.angle)
        known = {"V": level, "\\omega": off.omega, "\\theta_0": off.angle}
        return [at(hop, off.t + tau, y=hop.at(off.t + tau).height, **known | {"\\tau": tau}) for tau in (0.1, 0.2, 0.3)]
    if name == "lift":
        return [at(hop, off.t)]
    if name == "landing":
        before, sine, cosine = down.before, math.sin(down.angle), math.cos(down.angle)
        spin = GAMMA * RADIUS * before.omega
        known = {"V": before.vx + spin * cosine, "U": before.vy - spin * sine, "\\omega": before.omega, "\\omega_a": down.omega}
        return [BODY | known | {"\\theta": down.angle}]
    if name == "slip_normal":
        spin = next(event for event in hop.find("slip_start") if event.to_mode == "S")
        return [at(hop, spin.t + share * (off.t - spin.t)) for share in (0.2, 0.5, 0.9)]
    if name == "largest_speed":
        return [at(rolling, 0.1, **{"\\omega_m": rolling.at(first_time(rolling, math.pi)).omega})]
    return [at(rolling, t) for t in ((1e-5,) if name == "top_normal" else (0.1, 0.3, 0.55))]


@pytest.mark.parametrize("name", list(COMPUTED))
def test_formulas_of_the_report_hold(name):
    for values in cases(name):
        left, right = sides(COMPUTED[name], values)
        assert left == pytest.approx(right, rel=1e-6, abs=1e-8)


def called(macro):
    """What the story calls a macro with."""
    return re.findall(rf'{{{{ {macro}\("(\w+)"\) }}}}', STORY)


def test_every_statement_figure_film_and_formula_is_in_the_story(found):
    assert set(called("see")) == set(found)
    figures = called("figure") + [name for step in called("more") for name in report.MORE[step]]
    assert sorted(figures) == sorted(figure.name for figure in FIGURES)
    films = called("film")
    assert films[0] == "hop"
    assert {report.FILMS[name][0] for name in films} == {film.name for film in ARTICLE_FILMS}
    assert set(called("formula")) == set(FORMULAS)


def test_no_number_in_the_text_is_typed(statements, runs):
    """Only what is given is: speeds and frictions of the runs, shares, right angles, years."""
    words = re.sub(r"\\[\[(].*?\\[\])]|<[^>]*>|{{.*?}}", " ", STORY)
    given = {"1953", "0.1", "1", "3", "4", "2", "2.8", "3.1", "0.3", "90", "1.0"}
    assert set(re.findall(r"\d+(?:\.\d+)?", html.unescape(words))) <= given
    told = facts(statements, runs)
    assert set(told) <= set(re.findall(r"{{ (\w+) }}", STORY))  # none is computed for nothing
    assert not any("nan" in value for value in told.values())


def test_numbers_of_the_text_another_way(statements, runs):
    """By formulas that the program does not use."""
    told = {name: float(re.match(r"[\d.]+", value)[0]) for name, value in facts(statements, runs).items()}
    off, down = (runs.motion("hop").find(kind)[0] for kind in ("takeoff", "impact"))
    assert told["flight_time"] == pytest.approx(down.t - off.t, abs=0.005)
    assert told["flight_turn"] == pytest.approx(math.degrees(off.omega * (down.t - off.t)), abs=0.5)
    # from the sum of energies: where it takes off, and with two moments of inertia at the bottom
    for name, speed, ratio, cosine in (
        ("roll_rate", 3.1, 1 - GAMMA**2, math.cos(off.angle)),
        ("right_rate", 0.1, 1 - GAMMA**2, -1),
        ("wrong_rate", 0.1, 1 - GAMMA, -1),
    ):
        top, there = (0.5 * (1 + ratio + GAMMA**2) + GAMMA * one for one in (1, cosine))
        assert told[name] == pytest.approx(math.sqrt((top * speed**2 + GAMMA * G * (1 - cosine)) / there), abs=0.005)
    assert told["parts_inertia"] == pytest.approx(1 - GAMMA**2, abs=5e-5)
    assert told["scaled_takeoff"] == told["large_takeoff"]


def test_the_report_counts_losses_as_its_figures_do(runs):
    """The tangential loss of the landing at 3.1 m/s is counted as friction, in the table of motions too."""
    row, sample = report._run(scenarios()["hop"], runs.motion("hop")), runs.sample("hop")
    assert row["cells"][2:4] == [f"{sample.friction_loss[-1]:.4f}", f"{sample.normal_loss[-1]:.4f}"]
    assert sample.impact_tangential[-1] > 0.1


def test_formulas_become_mathml_and_nothing_else_is_touched():
    made = typeset(r"<p>with \(\gamma=\frac{3}{4}\) and</p>\[F\le\mu N\]")
    every = typeset("".join(rf"\[{latex}\]" for latex in FORMULAS.values()))
    assert "\\" not in made + every
    assert (made.count("<math"), every.count("<math")) == (2, len(FORMULAS))
    assert "<mfrac>" in made
    assert tree.fromstring(f"<div>{made}</div>").find("p").text == "with "
    assert mathml(r"\dot\theta^2", displayed=False).count('<mover accent="true">') == 1
    assert 'display="block"' in mathml("x", displayed=True)
    with pytest.raises(math_core.LatexError):
        mathml(r"\nothinglikethis x", displayed=False)


def test_the_page_is_whole_and_asks_nothing_of_the_network(folder, statements, runs):
    films = folder / "films"
    films.mkdir()
    for film in ARTICLE_FILMS:
        for ending in ("mp4", "png"):
            (films / f"{film.name}.{ending}").touch()
    (films / "v3.1-3d.html").touch()
    made = [film for film in films.iterdir() if film.suffix != ".png"]
    page = report.page(statements, folder, made, runs)
    assert "{{" not in page
    assert "\\(" not in page
    places = re.findall(r'(?:src|href|poster)="([^"]*)"', page)
    assert {place for place in places if place.startswith(("http", "//"))} == {
        report.ARTICLE_URL
    }  # a link, which nothing loads
    assert not re.search(r"<(script|link)", page)
    assert re.findall(r'<iframe[^>]* src="([^"]*)"', page) == ["films/v3.1-3d.html"]
    numbers = [int(number) for number in re.findall(r"<b>Figure (\d+)\.</b>", page)]
    assert numbers == list(range(1, len(FIGURES) + 1))
    ids = re.findall(r" id=['\"]([^'\"]+)", page)
    assert len(ids) == len(set(ids))
    assert {place[1:] for place in places if place.startswith("#")} <= set(ids)
    assert {f"#{one.key}" for one in statements} <= set(places)
    assert page.index("film-v3.1") < page.index('id="why-it-rolls"') < page.index('class="statements"')
    assert page.count("<video") == page.count("poster=") == len(ARTICLE_FILMS)
    assert "prefers-color-scheme: dark" in page
