"""The map on the page: a click takes its motion, and it waits for its kernel."""

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.names import class_text
from lab_page_tools import colors_on, picture, wait_for


def test_a_click_on_the_map_takes_that_motion(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 4")
    assert colors_on(page, ".map-body canvas") > 8
    box = page.locator(".map-body").bounding_box()
    place = {"x": box["x"] + 62 + 0.55 * (box["width"] - 74), "y": box["y"] + 10 + 0.4 * (box["height"] - 46)}
    page.mouse.move(**place)
    told = page.locator(".map-body .tip").inner_text()
    page.mouse.click(**place)
    wait_for(page, "lab.motions.history.past.length === 1")
    speed, mu = page.evaluate("[hophoopLab.film().values['start.speed'], hophoopLab.film().values['plane.mu']]")
    assert speed == pytest.approx(0.55 * 5.0, abs=0.02)
    assert mu == pytest.approx(0.6 * 1.5, abs=0.02)
    # no more digits than the map resolves
    assert max(len(repr(value)) for value in (speed, mu)) <= 5, (speed, mu)
    words = {letter: class_text(letter, "sequence") for letter in "RSKH"}
    sequence = page.evaluate("hophoopLab.film().sequence")
    phases = told.rpartition(": ")[2].split(" → ")
    assert [words[letter] for letter in sequence][: len(phases)] == phases
    # and deep into it
    for _ in range(6):
        page.mouse.wheel(0, -400)
    wait_for(page, "lab.map.axes.windows.x[1] - lab.map.axes.windows.x[0] < 1")
    picture(page, "map", full_page=True)


def test_the_legend_of_the_map_has_the_words_of_modes(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 4")
    said = page.locator(".map-keys").inner_text()
    assert "roll → skid → roll → spin → flight" in said
    assert "slip" not in said
    assert "for backward rotation they change places" in said


@pytest.mark.long
def test_the_map_of_a_compliant_hoop_is_that_of_rigid_contact(visit):
    page = visit("?contact.model=compliant&duration=0.5")
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 4")
    assert page.locator(".map-head .hint").inner_text() == "124416 motions with rigid contact"


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
