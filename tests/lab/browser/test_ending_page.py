"""'And in the end?' on the page: the fate of what is shown, and the gait that it settles on; by the exported page too."""

import math

import pytest

import hophoop as hh
from hophoop.lab.presets import presets
from hophoop.vocabulary.names import FATES
from lab_page_tools import expect, wait_for

MODULE = "hophoop-fates.wasm"
SCENARIOS = {preset.key: preset.scenario for preset in presets()}


def asked(page):
    """Ask by keyboard, and return the answer."""
    button = page.get_by_role("button", name="And in the end?")
    button.focus()
    page.keyboard.press("Enter")
    expect(page.locator(".ending span")).not_to_have_text("Computing …")
    return page.locator(".ending span").inner_text()


@pytest.mark.long
def test_examples_end_as_in_python(visit):
    page = visit()
    gait = page.get_by_role("button", name="Show the gait")
    for key, turns in {"chaos": 0, "standstill": 0, "hops-for-ever": 1, "gear": 2}.items():
        page.evaluate("query => hophoopLab.load(query)", SCENARIOS[key].to_query())
        expect(page.locator(".ending span")).to_be_empty()
        found = hh.passages(SCENARIOS[key], 1000)
        said = asked(page)
        assert FATES[found.fate].sentence in said
        if found.fate != "gait":
            assert gait.is_hidden()
            continue
        speed = (found.x[-1] - found.x[-2]) / (found.t[-1] - found.t[-2])
        assert f"Revolutions per period: {turns}; hops: 1; mean speed: {speed:.4g} m/s." in said
        gait.click()
        wait_for(page, f"lab.film().scenario.start.angle === {math.pi!r} && !lab.surrounding && !lab.requested")
        shown = page.evaluate("hophoopLab.film().scenario.start.speed")
        assert shown == pytest.approx(found.omega[-1], rel=1e-8)  # R = 1 m
        # what is shown has no answer yet
        expect(page.locator(".ending span")).to_be_empty()
        assert gait.is_hidden()
    assert FATES["gait"].sentence in asked(page)


def test_its_module_is_fetched_when_it_is_asked_for_and_asked_for_again(visit):
    page = visit(service_workers="block", expected=["Failed to load resource"])
    wait_for(page, "lab.theory.list.children.length > 4")
    loaded = page.evaluate("performance.getEntriesByType('resource').map((entry) => entry.name)")
    assert any("hophoop.wasm" in url for url in loaded)
    assert not any(MODULE in url for url in loaded)
    page.route(f"**/{MODULE}*", lambda route: route.abort())
    assert "could not be loaded" in asked(page)
    assert page.evaluate("hophoopLab.film().sequence.includes('H')")  # all else goes on
    page.unroute(f"**/{MODULE}*")
    assert "could not be loaded" not in asked(page)
