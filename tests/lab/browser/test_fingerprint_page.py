"""The fingerprint of the motion on the page: that of Python; and comparisons."""

from urllib.parse import urlsplit

import pytest

import hophoop as hh
from lab_page_tools import wait_for

AS_IN_LINK = "✓ Same bits as where the link was made"


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


def said(page, kind):
    return page.locator(f".fingerprint .{kind}").all_inner_texts()


def link_of(page, address, name="Copy a link with its fingerprint"):
    """What the page copies as its link, after the address."""
    page.locator("summary", has_text="Share").click()
    page.get_by_role("button", name=name).click()
    page.locator(".toast", has_text="Link copied.").wait_for()
    return page.evaluate("navigator.clipboard.readText()").removeprefix(address)


def test_a_copied_link_carries_the_fingerprint(visit, address):
    page = visit("?start.speed=2.9", permissions=["clipboard-read", "clipboard-write"])
    page.locator(".fingerprint code").wait_for(state="attached")
    assert "fingerprint" not in page.url  # it is of here, and says nothing until it is elsewhere
    link = link_of(page, address)
    assert f"fingerprint={code_of(page)}" in urlsplit(link).fragment.split("&")
    other = visit(link)
    other.locator(".fingerprint .same").wait_for()
    assert said(other, "same") == [AS_IN_LINK]
    other.locator("input[data-path='start.speed']").fill("2.8")
    other.locator(".fingerprint .same").wait_for(state="detached")
    wait_for(other, "!location.hash.includes('fingerprint')")


def test_each_of_two_hoops_has_its_own(visit, address):
    page = visit("?start.speed=2.9", permissions=["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Compare two hoops").click()
    page.locator("input[data-path='plane.mu']").fill("0.5")
    wait_for(page, "lab.films().length === 2 && lab.motions.history.past.length === 2")
    link = link_of(page, address)
    found = page.evaluate("hophoopLab.films().map((film) => film.fingerprint)")
    assert link.endswith(f"&fingerprint={','.join(found)}")
    other = visit(link.replace(found[1], "0123456789abcdef"))
    other.locator(".fingerprint .same").wait_for()
    wait_for(other, "lab.films().length === 2")
    other.evaluate("hophoopLab.motions.choose(1)")
    other.locator(".fingerprint .differs").wait_for()
    assert found[1] in said(other, "differs")[0]
