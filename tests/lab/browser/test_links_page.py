"""Links with what does not belong to them, and links in which something is wrong: nothing of the rest is lost."""

import pytest

from lab_page_tools import SHOWN, wait_for


@pytest.mark.parametrize(
    ("query", "rest", "said"),
    [
        ("plane.mu=-1&start.speed=2", "start.speed=2", "plane.mu = -1"),
        ("plane.my=0.5&start.speed=2", "start.speed=2", "plane.my is not a known key"),
        ("plane.mu=x&hoop.mass=2&fbclid=1&duration=2000000", "hoop.mass=2", "plane.mu"),
        (
            "plane.mu=0.5&plane.mu_static=0.6&plane.mu_kinetic=0.4&duration=3",
            "plane.mu_static=0.6&plane.mu_kinetic=0.4&duration=3",
            "mu_static",
        ),
        ("start.vx=1&start.speed=2&hoop.load_fraction=0.5", "hoop.load_fraction=0.5&start.speed=2", "start.speed"),
        ("contact.model=compliant&contact.low=1&plane.mu=0.3", "plane.mu=0.3&contact.model=compliant", "contact.low"),
    ],
)
def test_a_wrong_part_of_a_link_leaves_the_rest_and_the_address(visit, query, rest, said):
    page = visit(f"?{query}")
    wait_for(page, SHOWN)
    shown = page.evaluate("hophoopLab.film().query")
    assert sorted(shown.split("&")) == sorted(rest.split("&"))
    assert said in page.locator(".message").inner_text()
    assert "The rest of the link is shown." in page.locator(".message").inner_text()
    # what the lab writes by itself while one looks at it leaves the address alone
    page.evaluate("hophoopLab.clock.seek(0.5)")
    page.wait_for_timeout(600)
    assert page.evaluate("location.search") == f"?{query}"
    # another motion is a step of its own, and the way back leads to the wrong link
    page.evaluate("hophoopLab.motions.change([['plane.restitution', 0.25]], true)")
    page.wait_for_function("() => location.search.includes('plane.restitution=0.25')")
    page.go_back()
    wait_for(page, "!lab.film().query.includes('restitution')")
    assert page.evaluate("location.search") == f"?{query}"
    assert sorted(page.evaluate("hophoopLab.film().query").split("&")) == sorted(rest.split("&"))


def test_python_stays_strict():
    import hophoop as hh

    with pytest.raises(ValueError, match="fbclid is not a known key"):
        hh.Scenario.from_query("start.speed=2&fbclid=1")
