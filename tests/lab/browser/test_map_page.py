"""The map on the page: a click takes its motion, and it waits for its kernel."""

import pytest

from lab_page_tools import SHOWN, follow

SEEN = ["do first('.map-body').scrollIntoView({ block: 'center' })", "until lab.map.level === 4"]
STEPS = [
    # the wheel scrolls on until it is clicked
    "do globalThis.before = scrollY",
    "point .map-body 0.4 0.3",
    "wheel -200",
    "until scrollY < before",
    "is lab.map.axes.windows.x.join() === '0,5'",
    *SEEN,
    "is text('.map-keys').includes('roll → skid → roll → spin → flight') && !text('.map-keys').includes('slip')",
    "is text('.map-keys').includes('for backward rotation they change places')",
    "point .map-body 0.57 0.38",
    "is /^Speed v₀ = [\\d.]+ m\\/s, Friction μ = [\\d.]+: roll/.test(text('.map-body .tip'))",
    "drag .map-body: [[0, 0]]",
    "drop",
    "until lab.motions.history.past.length === 1",
    "is near(lab.film().values['start.speed'], lab.map.pointed.x, 0.02)",
    "is near(lab.film().values['plane.mu'], lab.map.pointed.y, 0.02)",
    "is ['start.speed', 'plane.mu'].every((path) => String(lab.film().values[path]).length <= 5)",  # as the map resolves
    "do globalThis.words = { R: 'roll', S: 'spin', K: 'skid', H: 'flight' }",
    "is (([said]) => said && [...lab.film().sequence].map((one) => words[one]).join(' → ').startsWith(said))"
    "([lab.map.said(lab.map.pointed).split(': ')[1]])",
    *(6 * ["wheel -400"]),  # and deep into it
    "until lab.map.axes.windows.x[1] - lab.map.axes.windows.x[0] < 1",
    "point .map-body 0.5 0.4",
    "choose .map-head>label>[aria-label] hop_height",
    "is !seen('.map-body .tip')",
]


def test_a_click_takes_the_motion_of_the_map(visit):
    follow(visit(), [*SEEN, *STEPS])


@pytest.mark.long
def test_the_map_of_a_compliant_hoop_is_that_of_rigid_contact(visit):
    page = visit("?contact.model=compliant&duration=0.5")
    follow(page, [*SEEN, "is text('.map-head .hint') === '124416 motions with rigid contact'"])


@pytest.mark.long
def test_buttons_zoom_about_the_mark_and_not_beyond_what_is_allowed(visit):
    follow(visit("?start.speed=3.1&plane.mu=0.4"), [
        f"until {SHOWN}",
        *(6 * ["button Zoom into the map"]),
        "is (({ x, y }) => x[0] < 3.1 && 3.1 < x[1] && y[0] < 0.4 && 0.4 < y[1] && x[1] - x[0] < 0.2)(lab.map.axes.windows)",
        *(12 * ["button Zoom out of the map"]),
        "is (({ x, y }) => x[0] < 3.1 && 3.1 < x[1] && y[0] === 0 && 1.5 < y[1] && y[1] <= 1e6)(lab.map.axes.windows)",
    ])  # fmt: skip
