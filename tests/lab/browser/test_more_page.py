"""The effect of a small change, on the page: its numbers are those of `hh.sensitivity`."""

import re

import pytest

import hophoop as hh
from differences import counted_names
from hophoop.derivatives.results.quantities import hops_of
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from lab_page_tools import wait_for

pytestmark = pytest.mark.long

RIGHT = 1e-6  # of differences
SHOWN = "lab.extras.more.changes && !lab.surrounding"
RATES = """() => [...document.querySelectorAll(".more tbody tr")]
  .map((row) => [...row.querySelectorAll("td")].map((cell) => cell.dataset.rate))"""


def turned_on(visit, query="", path="plane.mu"):
    page = visit(f"?{query}")
    wait_for(page, "!lab.surrounding")
    page.evaluate("path => hophoopLab.extras.more.turn(true, path)", path)
    return page


def test_every_hop_is_that_of_the_library(visit):
    """Bounces without number, the first of which begins with the start."""
    query = "start.height=0.3&start.vx=1&start.omega=2&plane.mu=0.3&plane.restitution=0.5&duration=1.2"
    found = hops_of(hh.simulate(hh.Scenario.from_query(query)))
    assert len(found) > 3
    page = turned_on(visit, query, "plane.mu")
    wait_for(page, SHOWN)
    hops = page.evaluate("hophoopLab.extras.more.changes.hops()")
    assert [(hop["begin"], hop["end"]) for hop in hops] == [(begin, end) for begin, _, end in found]


def test_the_table_has_the_numbers_of_the_library(visit):
    motion = hh.simulate(hh.Scenario())
    of = counted_names(motion, ("t", "x", "height", "angle"))
    page = turned_on(visit)
    for path in ("plane.mu", "start.speed"):
        page.locator(".more select").select_option(path)
        wait_for(page, f"{SHOWN} && lab.extras.more.known.startsWith('{path} ')")
        mine = [float(rate) for row in page.evaluate(RATES) for rate in row]
        assert mine == pytest.approx(hh.sensitivity(motion.scenario, of=of, wrt=path).larger[:, 0], rel=RIGHT, abs=RIGHT)


def test_sentence_arrows_and_step_are_those_of_the_library(visit):
    query = "start.speed=3.1"
    scenario = hh.Scenario.from_query(query)
    page = turned_on(visit, query)
    wait_for(page, SHOWN)
    of = ["hop.height", "hop.distance", "hop.duration", "hop.takeoff_time", "impact.x", "apex.height"]
    changes = 0.01 * hh.sensitivity(scenario, of=of, wrt="plane.mu").derivatives[:, 0]
    assert page.locator(".more-step").inner_text() == "1 → 1.01"
    said = page.locator(".more-said li").first.inner_text()
    found = re.findall(r"([\d.]+) (µm|mm|m|µs|ms|s) (higher|lower|longer|shorter|more|less|later|earlier)", said)
    scale = {"µm": 1e-6, "mm": 1e-3, "m": 1.0, "µs": 1e-6, "ms": 1e-3, "s": 1.0}
    signs = dict.fromkeys(("lower", "shorter", "less", "earlier"), -1)
    told = [float(size) * scale[unit] * signs.get(word, 1) for size, unit, word in found]
    assert told == pytest.approx(changes[:4], rel=6e-3)
    # arrows lead to where it would be
    arrows = {arrow["kind"]: arrow for arrow in page.evaluate("hophoopLab.extras.more.arrows")}
    assert [arrows["impact"]["dx"], arrows["apex"]["dy"]] == pytest.approx(changes[4:], rel=RIGHT)
    assert arrows["impact"]["dy"] == pytest.approx(0.0, abs=0.01 * RIGHT)
    factor = page.evaluate("hophoopLab.extras.more.factor")
    assert f"{factor:g} times enlarged" in page.locator(".more > .hint").inner_text().replace(",", "")
    # the motion of the next value, computed as ever, does what was told, to the second order of the step
    page.locator(".more select").select_option("start.speed")
    wait_for(page, f"{SHOWN} && lab.extras.more.known.startsWith('start.speed ')")
    top = "hophoopLab.film().events.find((event) => event.kind === 'apex').height"
    before, told = page.evaluate(f"[{top}, hophoopLab.extras.more.changes.hops()[0].height]")
    page.locator(".more").get_by_role("button", name="Apply").click()
    wait_for(page, f"lab.film().values['start.speed'] === 3.11 && {SHOWN}")
    assert page.evaluate(top) - before == pytest.approx(told, rel=0.05)
    # the arrows are seen: the picture is another without them
    shot = "document.querySelector('.stage-canvas').toDataURL()"
    page.evaluate("hophoopLab.toggle('whole')")
    wait_for(page, "lab.stage.options.whole && !lab.requested")
    with_arrows = page.evaluate(shot)
    page.keyboard.press("a")
    wait_for(page, "!lab.extras.more.on && !lab.requested")
    assert page.locator(".more").is_hidden()
    assert page.evaluate(shot) != with_arrows


# link, parameter, what is said
NONE = [
    ("", "plane.restitution", "From 1.804 s (landing) on, other events follow."),
    ("hoop.load_fraction=0.75&plane.restitution=1&duration=2", "plane.restitution", EDGE),
    ("contact.model=compliant", "plane.mu", "rigid contact model"),
    ("plane.mu=inf", "plane.mu", "infinite and cannot increase"),
    ("", "plane.rolling_resistance", EDGE),
    ("plane.mu=0.2&plane.restitution=0.4&start.height=0.5&start.angle=2&duration=0.4", "start.vx", SIDED),
]


def test_where_there_is_none_the_reason_is_said(visit):
    page = turned_on(visit)
    for query, path, words in NONE:
        page.evaluate("query => hophoopLab.load(query)", query)
        page.evaluate("path => hophoopLab.extras.more.turn(true, path)", path)
        page.locator(".more-reason:visible", has_text=words).wait_for()
