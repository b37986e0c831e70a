"""'And in the end?' on the page: the fate of what is shown, and the gait that it settles on; by the exported page too."""

import math
import os
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.lab.site.presets import presets
from hophoop.vocabulary.names import FATES
from lab_page_tools import expect, picture, wait_for

WHERE = {
    "wide": {},
    "dark": {"color_scheme": "dark"},
    "phone": {"viewport": {"width": 390, "height": 844}},
    "narrow": {"viewport": {"width": 320, "height": 640}},
}
SCENARIOS = {preset.key: preset.scenario for preset in presets()}


@pytest.fixture(scope="module", params=["server", "folder"])
def address(request, address):
    """The lab on its server, and as a folder of files."""
    return address if request.param == "server" else request.getfixturevalue("site_address")


def asked(page):
    """Ask by keyboard, and return the answer."""
    button = page.get_by_role("button", name="And in the end?")
    button.focus()
    page.keyboard.press("Enter")
    expect(page.locator(".ending span")).not_to_have_text("Computing …")
    return page.locator(".ending span").inner_text()


@pytest.mark.parametrize("key", ["hops-for-ever", "gear", "chaos", "standstill"])
def test_an_example_ends_as_in_python(visit, key):
    page = visit(f"?{SCENARIOS[key].to_query()}")
    expect(page.locator(".ending span")).to_be_empty()
    found = hh.passages(SCENARIOS[key], 1000)
    said = asked(page)
    assert FATES[found.fate].sentence in said
    gait = page.get_by_role("button", name="Show the gait")
    if found.fate != "gait":
        assert gait.is_hidden()
        return
    speed = (found.x[-1] - found.x[-2]) / (found.t[-1] - found.t[-2])
    turns = round((found.angle[-1] - found.angle[-2]) / (2.0 * math.pi))
    assert turns == {"hops-for-ever": 1, "gear": 2}[key]
    assert f"Revolutions per period: {turns}; hops: 1; mean speed: {speed:.4g} m/s." in said
    gait.click()
    wait_for(page, f"lab.film().scenario.start.angle === {math.pi!r} && !lab.surrounding && !lab.requested")
    shown = page.evaluate("hophoopLab.film().scenario.start.speed")
    assert shown == pytest.approx(found.omega[-1], rel=1e-8)  # R = 1 m
    # what is shown is the gait from the first revolution on, and has no answer yet
    begins = hh.passages(SCENARIOS[key].replace("start", hh.Start.rolling(shown, angle=math.pi)), 5)
    assert begins.hops.tolist() == [1] * 5
    assert begins.omega == pytest.approx(found.omega[-1], rel=1e-8)
    expect(page.locator(".ending span")).to_be_empty()
    assert gait.is_hidden()
    assert FATES["gait"].sentence in asked(page)
    picture(page, f"ending-{key}")


def test_another_motion_has_no_answer_and_what_has_no_end_says_so(visit):
    page = visit("?start.speed=2")
    assert asked(page) == FATES["rolls ahead"].sentence
    page.evaluate("hophoopLab.motions.change([['plane.mu', 0.5]], true)")
    expect(page.locator(".ending span")).to_be_empty()
    page.evaluate("hophoopLab.motions.change([['plane.gravity', 0]], true)")
    wait_for(page, "lab.film().scenario.plane.gravity === 0")
    assert asked(page) == "What becomes of it in the end is known for rigid contact with gravity."


@pytest.mark.long
@pytest.mark.parametrize("language", ["en", "de", "es", "fr", "zh"])
@pytest.mark.parametrize("where", WHERE)
def test_the_answer_fits_and_is_accessible(visit, where, language):
    page = visit(f"?{SCENARIOS['gear'].to_query()}", locale=language, **WHERE[where])
    page.locator(".ending button").first.click()
    expect(page.locator(".ending button").nth(1)).to_be_visible()
    wide = page.evaluate("[document.documentElement.scrollWidth, innerWidth]")
    assert wide[0] <= wide[1]
    box = page.locator(".ending").bounding_box()
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= wide[1]
    for index in (0, 1):
        assert page.locator(".ending button").nth(index).bounding_box()["height"] >= 24
    page.locator(".ending").scroll_into_view_if_needed()
    picture(page, f"ending-{language}-{where}")
    axe = os.environ.get("HOPHOOP_AXE", "")
    if axe:  # npm install axe-core
        page.evaluate(Path(axe).read_text(encoding="utf-8"))
        found = page.evaluate("async () => (await axe.run(document)).violations.map((one) => [one.id, one.nodes[0].html])")
        assert found == []
