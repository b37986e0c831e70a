"""The map on the page: a click takes its motion, and it waits for its kernel."""

import numpy as np

import hophoop as hh
from lab_page_tools import each_of, follow, picture, wait_for

SEEN = ["do first('.map-body').scrollIntoView({ block: 'center' })", "until lab.map.level === 4"]
# name: (link, steps), as in test_flows.py
FLOWS = {
    "a click takes that motion": ("", [
        *SEEN,
        "point .map-body 0.57 0.38",
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
    ]),
    "what is pointed at is said": ("", [
        *SEEN,
        "point .map-body 0.57 0.38",
        "is /^Speed v₀ = [\\d.]+ m\\/s, Friction μ = [\\d.]+: roll/.test(text('.map-body .tip'))",
    ]),
    "the legend has the words of modes": ("", [
        *SEEN,
        "is text('.map-keys').includes('roll → skid → roll → spin → flight') && !text('.map-keys').includes('slip')",
        "is text('.map-keys').includes('for backward rotation they change places')",
    ]),
    "the map of a compliant hoop is that of rigid contact": ("?contact.model=compliant&duration=0.5", [
        *SEEN,
        "is text('.map-head .hint') === '124416 motions with rigid contact'",
    ]),
}  # fmt: skip


@each_of(FLOWS, "the map of a compliant hoop is that of rigid contact")
def test_a_map(visit, name):
    link, steps = FLOWS[name]
    page = visit(link)
    follow(page, steps)
    picture(page, f"map-{name.replace(' ', '-')}")


SIDES = 24  # that are compared

CHANGES = """() => {
  const { header, values } = hophoopLab.map.layers.at(-1);
  const { cells } = header.x;
  const changes = [];
  for (let k = 0; k + cells < values.length; k++) {
    const [low, high] = [values[k], values[k + cells]];
    if (low >= 0 && high >= 0 && low !== high) changes.push([k % cells, Math.floor(k / cells)]);
  }
  return [header, changes];
}"""


def test_the_classes_of_the_map_change_where_those_of_the_library_do(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 4")
    header, changes = page.evaluate(CHANGES)
    x, y = header["x"], header["y"]
    size = (x["to"] - x["from"]) / x["cells"], (y["to"] - y["from"]) / y["cells"]
    ranges = {"start.speed": (x["from"], x["to"]), "plane.mu": (y["from"], y["to"])}
    assert len(changes) > 500
    for column, row in changes[:: len(changes) // SIDES]:
        across = x["from"] + (column + 0.5) * size[0]
        one, other = ((across, y["from"] + (row + half) * size[1]) for half in (0.5, 1.5))
        found = hh.maps.boundary(None, ranges, one, other, most=1)
        assert np.any(np.abs(found.x - across) < 1e-12)
