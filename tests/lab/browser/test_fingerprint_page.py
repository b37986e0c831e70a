"""The fingerprint of the motion on the page: that of Python, or none where the page does not decide the motion."""

import pytest

import hophoop as hh
from lab_page_tools import wait_for

# The speed at which the contact force is zero at the start: its double may lie on either side.
UNDECIDED = "start.speed=3.616628264005025"
NONE = "No fingerprint: this motion depends on more digits than this page computes."


@pytest.fixture(params=["served", "site"])
def address(request, address, site_address):
    return address if request.param == "served" else site_address


@pytest.mark.parametrize("query", ["", "start.speed=2.8&plane.restitution=0.5&plane.slope=0.05"])
def test_it_is_that_of_python(visit, query):
    page = visit(f"?{query}")
    assert page.locator(".fingerprint code").inner_text() == hh.simulate(hh.Scenario.from_query(query)).fingerprint
    page.locator("input[data-path='start.speed']").fill("2")
    wait_for(page, "lab.film().scenario.start.speed === 2")
    changed = hh.Scenario.from_query(query).replace("start.speed", 2.0)
    assert page.locator(".fingerprint code").inner_text() == hh.simulate(changed).fingerprint


def test_it_is_copied(visit):
    page = visit(permissions=["clipboard-read", "clipboard-write"])
    page.locator(".fingerprint button").click()
    page.locator(".fingerprint button", has_text="Copied").wait_for()
    assert page.evaluate("navigator.clipboard.readText()") == page.locator(".fingerprint code").inner_text()


def test_where_nothing_can_be_copied_it_is_selected(visit):
    page = visit(script="Object.defineProperty(navigator, 'clipboard', { value: undefined })")
    page.locator(".fingerprint button").click()
    wait_for(page, "getSelection().toString() === lab.film().fingerprint")


def test_a_motion_that_doubles_do_not_decide(visit, address, site_address):
    page = visit(f"?{UNDECIDED}")
    if address == site_address:
        assert page.locator(".fingerprint").inner_text() == NONE
        assert page.locator(".fingerprint code").count() == 0
    else:
        assert page.locator(".fingerprint code").inner_text() == hh.simulate(hh.Scenario.from_query(UNDECIDED)).fingerprint
