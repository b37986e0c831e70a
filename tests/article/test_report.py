"""The report: its formulas hold on the computed motions, its numbers are computed, and nothing of the article is left out."""

import base64
import html
import io
import json
import math
import re
import unicodedata
import xml.etree.ElementTree as tree
from functools import cache
from importlib.resources import files
from pathlib import Path

import math_core
import matplotlib.pyplot as plt
import pytest

import hophoop as hh
from hophoop.animate.article import ARTICLE_FILMS
from hophoop.article import report
from hophoop.article.facts import facts
from hophoop.article.figures import FIGURES
from hophoop.article.formulas import COMPUTED, FORMULAS
from hophoop.article.inks import INK, PAPER, for_both, in_the_dark
from hophoop.article.runs import Runs, first_time
from hophoop.article.typeset import mathml, typeset
from hophoop.vocabulary import colors
from latex_values import sides

STORY = files("hophoop.article").joinpath("story.html").read_text(encoding="utf-8")
GAMMA, G = 0.75, 9.81
# another hoop than the article's, which moves alike: with R = m = 1 a missing factor would not be seen
RADIUS, MASS = 0.3, 2.0
BODY = {"m": MASS, "R": RADIUS, "g": G, "\\gamma": GAMMA, "\\mu": 1.0}


@pytest.fixture(scope="module")
def runs():
    return Runs()


@pytest.fixture(scope="module")
def statements(runs):
    return hh.article.statements(runs)


@cache
def scaled(speed):
    """The article's run at a speed, with another radius and mass."""
    start = hh.Start.rolling(speed * math.sqrt(RADIUS))
    return hh.simulate(hh.Hoop.ideal(GAMMA, radius=RADIUS, mass=MASS), hh.Plane(mu=1.0), start, duration=1.5)


def at(motion, t, **more):
    """The symbols of the formulas at a time of a motion; the acceleration by a difference of the angular velocity."""
    state = motion.at(t)
    step = 1e-6
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
        **more,
    }


def cases(name):
    """Values at which a formula must hold, from computed motions."""
    rolling, hop = scaled(2.0), scaled(3.1)
    speed = rolling.scenario.start.speed
    off, down = hop.find("takeoff")[0], hop.find("impact")[0]
    spin = next(event for event in hop.find("slip_start") if event.to_mode == "S")
    before = down.before
    along = before.vx + GAMMA * RADIUS * before.omega * math.cos(down.angle)
    up = before.vy - GAMMA * RADIUS * before.omega * math.sin(down.angle)
    if name in ("gap", "velocity_in_flight"):
        level = off.vx + GAMMA * RADIUS * off.omega * math.cos(off.angle)
        for tau in (0.1, 0.2, 0.3):
            values = at(hop, off.t + tau, V=level)
            yield values | {"y": hop.at(off.t + tau).height, "\\tau": tau, "\\omega": off.omega, "\\theta_0": off.angle}
    elif name == "lift":
        yield at(hop, off.t)
    elif name == "landing":
        yield BODY | {"\\theta": down.angle, "V": along, "U": up, "\\omega": before.omega, "\\omega_a": down.omega}
    elif name == "slip_normal":
        for share in (0.2, 0.5, 0.9):
            yield at(hop, spin.t + share * (off.t - spin.t))
    elif name == "largest_speed":
        yield BODY | {"v_0": speed, "\\omega_m": rolling.at(first_time(rolling, math.pi)).omega}
    elif name == "top_normal":
        yield at(rolling, 1e-5, v_0=speed)
    else:
        for t in (0.1, 0.3, 0.55):
            yield at(rolling, t, v_0=speed)


@cache
def cases_of(name):
    return list(cases(name))


def holds(name, latex):
    return all(math.isclose(*sides(latex, values), rel_tol=1e-6, abs_tol=1e-8) for values in cases_of(name))


def changed(latex):
    """The formula with one sign turned, one factor changed or one square left out, each in its turn."""
    for match in re.finditer(r"[+\-]|(?<![_\^\d])2|\^2|sin|cos", latex):
        other = {"+": "-", "-": "+", "2": "3", "^2": "", "sin": "cos", "cos": "sin"}[match[0]]
        yield latex[: match.start()] + other + latex[match.end() :]


@pytest.mark.parametrize("name", list(COMPUTED))
def test_formulas_of_the_report_hold_and_changed_ones_do_not(name):
    assert holds(name, COMPUTED[name])
    for wrong in changed(COMPUTED[name]):
        assert not holds(name, wrong), wrong


def called(macro):
    """What the story calls a macro with."""
    return re.findall(rf'{{{{ {macro}\("(\w+)"\) }}}}', STORY)


def test_every_statement_figure_film_and_formula_is_in_the_story(statements):
    assert set(called("see")) == {one.key for one in statements}
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
    """Against the reference solution, and by formulas that the program does not use."""
    told = facts(statements, runs)
    data = json.loads((Path(__file__).parents[1] / "data" / "article_v3.1_mu1.json").read_text(encoding="utf-8"))
    off = next(event for event in data["events"] if event["kind"] == "takeoff")
    down = next(event for event in data["events"] if event["kind"] == "impact")
    assert told["takeoff_angle"] == f"{math.degrees(float(off['angle'])):.1f}°"
    assert told["flight_time"] == f"{float(down['t']) - float(off['t']):.2f}\u00a0s"
    assert told["flight_turn"] == f"{math.degrees(float(down['angle']) - float(off['angle'])):.0f}°"
    # rolling would turn that fast: from the sum of energies
    angle = float(off["angle"])
    rate = math.sqrt((GAMMA * G * (1 - math.cos(angle)) + 3.1**2 * (1 + GAMMA)) / (1 + GAMMA * math.cos(angle)))
    assert told["roll_rate"] == f"{rate:.2f}\u00a0rad/s"
    for ratio, name in ((1 - GAMMA**2, "right_rate"), (1 - GAMMA, "wrong_rate")):
        top, bottom = (0.5 * (1 + ratio + GAMMA**2 + 2 * GAMMA * sign) for sign in (1, -1))
        assert told[name] == f"{math.sqrt((top * 0.01 + 2 * GAMMA * G) / bottom):.2f}\u00a0rad/s"
    assert told["parts_inertia"] == f"{1 - GAMMA**2:.4f}"
    assert told["scaled_takeoff"] == told["large_takeoff"]


def test_formulas_become_mathml_and_nothing_else_is_touched():
    made = typeset(r"<p>with \(\gamma=\frac{3}{4}\) and</p>\[F\le\mu N\]")
    assert "\\" not in made
    assert made.count("<math") == 2
    assert "<mfrac>" in made
    root = tree.fromstring(f"<div>{made}</div>")
    assert root.find("p") is not None
    assert mathml(r"\dot\theta^2", displayed=False).count('<mover accent="true">') == 1
    assert 'display="block"' in mathml("x", displayed=True)


def test_every_formula_of_the_report_can_be_set():
    for name, latex in FORMULAS.items():
        made = typeset(rf"\[{latex}\]")
        assert "<math" in made, name
        assert "\\" not in made, name
    with pytest.raises(math_core.LatexError):
        mathml(r"\nothinglikethis x", displayed=False)


def light(color):
    parts = [int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    a, b = sorted((light(one), light(other)), reverse=True)
    return (a + 0.05) / (b + 0.05)


def test_colours_can_be_seen_on_dark_pages():
    assert in_the_dark("#000000") == INK
    assert in_the_dark("#ffffff") == PAPER
    inks = {colors.KINETIC, colors.POTENTIAL, colors.NORMAL_FORCE, colors.FRICTION_FORCE, colors.IMPACT_LOSS,
            colors.ROTATION_SPEED, colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE, *colors.MODES.values()}  # fmt: skip
    for color in inks:
        assert contrast(in_the_dark(color), PAPER) > 3.0, color
    assert len({in_the_dark(color) for color in inks}) == len(inks)


def test_figures_follow_the_page():
    svg = (
        "<?xml version='1.0'?><!DOCTYPE svg><svg xmlns='http://www.w3.org/2000/svg'><g style=\"fill: #ffffff\"/>"
        '<path style="fill: none; stroke: #1B3A78; stroke-width: 2"/><g id=\'on-color-3\'><g style="fill: #ffffff"/></g></svg>'
    )
    made = for_both(svg)
    tree.fromstring(made)
    assert made.startswith("<svg")
    assert "stroke: var(--i1b3a78)" in made
    bright, dark, kept = re.findall(r"--iffffff:(#\w+);", made)
    assert (bright, dark, kept) == ("#ffffff", PAPER, "#ffffff")


def test_a_scale_of_colours_stays_as_its_bar_is():
    paths = "".join(f'<path style="fill: #{k:02x}80f0"/>' for k in range(40)) + '<path style="stroke: #000000"/>'
    made = for_both(f"<svg xmlns='http://www.w3.org/2000/svg'>{paths}</svg>")
    assert set(re.findall(r"--i0080f0:(#\w+);", made)) == {"#0080f0"}
    assert INK in re.findall(r"--i000000:(#\w+);", made)


def test_colours_that_fade_into_paper_keep_their_paper():
    motion = hh.simulate(hh.Scenario(duration=0.5))
    drawing = io.StringIO()
    hh.plots.strobe(motion).figure.savefig(drawing, format="svg")
    plt.close("all")
    assert "prefers-color-scheme" not in for_both(drawing.getvalue())


def test_the_report_brings_its_font_for_mathematics(page):
    pytest.importorskip("brotli")  # to read WOFF2
    fonts = pytest.importorskip("fontTools.ttLib")
    code = re.search(r"src: url\(data:font/woff2;base64,([^)]+)\)", page)[1]
    font = fonts.TTFont(io.BytesIO(base64.b64decode(code)))
    text = "".join(re.sub("<[^>]+>", "", formula) for formula in re.findall("<math.*?</math>", page, re.DOTALL))
    known = set(font.getBestCmap())
    drawn = {sign for sign in html.unescape(text) if not sign.isspace() and unicodedata.category(sign) != "Cf"}
    assert {sign for sign in drawn if ord(sign) not in known} == set()
    assert "MATH" in font


@pytest.fixture
def page(tmp_path, statements, runs):
    (tmp_path / "figures").mkdir()
    (tmp_path / "films").mkdir()
    for figure in FIGURES:
        text = "<svg xmlns='http://www.w3.org/2000/svg'></svg>"
        (tmp_path / "figures" / f"{figure.name}.svg").write_text(text, encoding="utf-8")
    made = []
    for film in ARTICLE_FILMS:
        made.append(tmp_path / "films" / f"{film.name}.mp4")
        made[-1].write_bytes(b"film")
        made[-1].with_suffix(".png").write_bytes(b"still")
    made.append(tmp_path / "films" / "v3.1-3d.html")
    made[-1].write_text("<!DOCTYPE html>", encoding="utf-8")
    return report.page(statements, tmp_path, made, runs)


def test_the_page_is_whole_and_asks_nothing_of_the_network(page, statements):
    assert "{{" not in page
    assert "\\(" not in page
    places = re.findall(r'(?:src|href|poster)="([^"]*)"', page)
    outside = {place for place in places if place.startswith(("http", "//"))}
    assert outside == {report.ARTICLE_URL}  # a link, which nothing loads
    assert not re.search(r"<(script|link)", page)
    assert re.findall(r'<iframe[^>]* src="([^"]*)"', page) == ["films/v3.1-3d.html"]
    numbers = [int(number) for number in re.findall(r"<b>Figure (\d+)\.</b>", page)]
    assert numbers == list(range(1, len(FIGURES) + 1))
    ids = re.findall(r" id=['\"]([^'\"]+)", page)
    assert len(ids) == len(set(ids))
    for one in statements:
        assert f'href="#{one.key}"' in page
    assert page.index("film-v3.1") < page.index('id="why-it-rolls"') < page.index('class="statements"')
    assert page.count("<video") == page.count("poster=") == len(ARTICLE_FILMS)
    assert "prefers-color-scheme: dark" in page


def test_without_films_there_is_a_page_as_well(tmp_path, statements, runs):
    (tmp_path / "figures").mkdir()
    for figure in FIGURES:
        (tmp_path / "figures" / f"{figure.name}.svg").write_text("<svg></svg>", encoding="utf-8")
    assert "<video" not in report.page(statements, tmp_path, [], runs)
