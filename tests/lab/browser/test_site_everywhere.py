"""The exported lab on other devices, in other colours and with keys alone: nothing is missing, nothing from elsewhere."""

import os
from pathlib import Path

import pytest

from lab_page_tools import picture, wait_for

SETTLED = "!lab.surrounding && lab.theory.list.children.length > 4 && lab.phase.pictures?.length === 1"
WHERE = {
    "desktop": {},
    "phone": {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True, "device_scale_factor": 2},
    "dark": {"color_scheme": "dark"},
    "forced colours": {"forced_colors": "active"},
}


@pytest.fixture(scope="module")
def address(site_address):
    """The page that computes by itself."""
    return site_address


@pytest.mark.parametrize("where", ["desktop", *(pytest.param(name, marks=pytest.mark.long) for name in list(WHERE)[1:])])
def test_it_is_whole(visit, where):
    page = visit("?start.speed=3.1", **WHERE[where])
    wait_for(page, SETTLED)
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.layers.length > 0")
    page.evaluate("scrollTo(0, 0)")
    page.locator(".transport .play").click()
    wait_for(page, "lab.clock.time > 0.3")
    page.locator(".transport .play").click()
    assert page.evaluate("document.documentElement.scrollWidth") <= page.viewport_size["width"]
    picture(page, f"site-{where.replace(' ', '-')}", full_page=True)
    axe = os.environ.get("HOPHOOP_AXE", "")
    if axe:  # npm install axe-core
        page.evaluate(Path(axe).read_text(encoding="utf-8"))
        found = page.evaluate("async () => (await axe.run(document)).violations.map((one) => [one.id, one.nodes[0].html])")
        assert found == []


NAMED = (
    """(({ labels, textContent, ariaLabel }) => ariaLabel ?? labels?.[0]?.textContent ?? textContent)(document.activeElement)"""
)


@pytest.mark.long
def test_keys_alone_reach_and_change_everything(visit):
    page = visit("?start.speed=2")
    wait_for(page, SETTLED)
    reached = []
    while len(reached) < 120 and not (reached and reached[-1].startswith("Map of motions")):
        page.keyboard.press("Tab")
        reached.append(page.evaluate(NAMED).strip())
        if reached[-1].startswith("Speedv"):
            page.keyboard.press("End")  # the slider's greatest speed
            wait_for(page, "lab.film().values['start.speed'] > 4")
    for name in ("Skip to the player", "Examples", "Language", "Friction", "Angle of the load", "Time", "Play"):
        assert any(text.startswith(name) for text in reached), name
    assert reached[-1].startswith("Map of motions")
    page.keyboard.press("Control+z")
    wait_for(page, "lab.film().values['start.speed'] === 2")
