"""The fingerprint of the motion on the page: that of Python; and comparisons."""

import pytest

import hophoop as hh
from lab_page_tools import wait_for


def code_of(page):
    """The fingerprint that is written, also where its group is closed."""
    return page.locator(".fingerprint code").text_content()


@pytest.mark.parametrize("query", ["", "start.speed=2.8&plane.restitution=0.5&plane.slope=0.05"])
def test_it_is_that_of_python(visit, query):
    page = visit(f"?{query}")
    assert code_of(page) == hh.simulate(hh.Scenario.from_query(query)).fingerprint
    page.locator("input[data-path='start.speed']").fill("2")
    wait_for(page, "lab.film().scenario.start.speed === 2")
    changed = hh.Scenario.from_query(query).replace("start.speed", 2.0)
    # the story is written a moment after the picture
    page.locator(".fingerprint code", has_text=hh.simulate(changed).fingerprint).wait_for(state="attached")
