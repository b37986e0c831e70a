"""Links in which something is wrong: nothing of the rest is lost, and the address stays as it is."""

import pytest

from lab_page_tools import SHOWN, follow

# link, its rest, what is said
LINKS = [
    ("plane.mu=-1&start.speed=2", "start.speed=2", "plane.mu = -1"),
    ("plane.my=0.5&start.speed=2", "start.speed=2", "plane.my is not a known key"),
    ("plane.mu=x&hoop.mass=2&fbclid=1&duration=2000000", "hoop.mass=2", "plane.mu"),
    (
        "plane.mu=0.5&plane.mu_static=0.6&plane.mu_kinetic=0.4&duration=3",
        "duration=3&plane.mu_static=0.6&plane.mu_kinetic=0.4",
        "mu_static",
    ),
    ("start.vx=1&start.speed=2&hoop.load_fraction=0.5", "hoop.load_fraction=0.5&start.speed=2", "start.speed"),
    ("contact.model=compliant&contact.low=1&plane.mu=0.3", "plane.mu=0.3&contact.model=compliant", "contact.low"),
]


@pytest.mark.parametrize(("query", "rest", "said"), LINKS)
def test_a_wrong_part_of_a_link_leaves_the_rest_and_the_address(visit, query, rest, said):
    shown = f"lab.film().query.split('&').sort().join('&') === '{'&'.join(sorted(rest.split('&')))}'"
    follow(visit(f"?{query}"), [
        f"until {SHOWN}",
        f"is {shown} && text('.message').includes('{said}') && text('.message').includes('The rest of the link is shown.')",
        "do lab.clock.seek(0.5)",  # what the lab writes by itself while one looks at it
        "wait 600",
        f"is location.search === '?{query}'",
        "do lab.motions.change([['plane.restitution', 0.25]], true)",  # a step of its own, from which a way leads back
        "until location.search.includes('plane.restitution=0.25')",
        "back",
        f"until !lab.film().query.includes('restitution') && location.search === '?{query}'",
        f"is {shown}",
    ])  # fmt: skip
