"""The map on the page: a click takes its motion, and it waits for its kernel."""

import math
from collections import defaultdict

import numpy as np
import pytest

uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

import hophoop as hh  # noqa: E402
from hophoop.vocabulary.names import class_text  # noqa: E402
from lab_page_tools import colors_on, picture, wait_for  # noqa: E402


def test_a_click_on_the_map_takes_that_motion(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 3")
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
    wait_for(page, "lab.map.level === 3")
    said = page.locator(".map-keys").inner_text()
    assert "roll → skid → roll → spin → flight" in said
    assert "slip" not in said
    assert "for backward rotation they change places" in said


@pytest.mark.long
def test_the_map_of_a_compliant_hoop_is_that_of_rigid_contact(visit):
    page = visit("?contact.model=compliant&duration=0.5")
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 3")
    assert page.locator(".map-head .hint").inner_text() == "31104 motions with rigid contact"


SIDES = 24  # that are compared


def test_the_boundaries_of_the_map_are_those_of_the_library(visit):
    """Lines cross the sides of cells where the library's own bisection finds the change, to a thousandth of a cell."""
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.layers.at(-1)?.shapes")
    header, lines = page.evaluate("(({ header, shapes }) => [header, shapes.lines])(hophoopLab.map.layers.at(-1))")
    x, y = header["x"], header["y"]
    size = (x["to"] - x["from"]) / x["cells"], (y["to"] - y["from"]) / y["cells"]
    ranges = {"start.speed": (x["from"], x["to"]), "plane.mu": (y["from"], y["to"])}
    # on sides between the middles of cells, one over the other
    cuts = defaultdict(list)
    for u, v, *_ in lines:
        if u % 1 == 0.5 and v % 1 != 0.5 and 1 < v < y["cells"] - 1:
            cuts[u, math.floor(v - 0.5) + 0.5].append(v)
    assert len(cuts) > 100
    for u, low in sorted(cuts)[:: len(cuts) // SIDES]:
        across = x["from"] + u * size[0]
        one, other = ((across, y["from"] + end * size[1]) for end in (low, low + 1))
        found = hh.maps.boundary(None, ranges, one, other, most=1)
        (mu,) = found.y[np.abs(found.x - across) < 1e-12]
        assert min(abs((mu - y["from"]) / size[1] - v) for v in cuts[u, low]) < 1e-3, (u, low, found.classes)


def test_the_speed_of_the_immediate_hop_is_a_straight_line_of_the_map(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.layers.at(-1)?.shapes")
    header, lines = page.evaluate("(({ header, shapes }) => [header, shapes.lines])(hophoopLab.map.layers.at(-1))")
    x, y = header["x"], header["y"]
    hop = hh.theory.immediate_hop_speed(hh.Scenario().hoop)
    place = (hop - x["from"]) / (x["to"] - x["from"]) * x["cells"]
    across = {v: u for u, v, *_ in lines if v % 1 == 0.5 and abs(u - place) < 0.5}
    assert len(across) == y["cells"]
    assert max(abs(u - place) for u in across.values()) < 1e-3
    # and what is said there is what is drawn, on both sides of it
    said = "value => hophoopLab.map.said({ x: value, y: 1.2 })"
    before, after = (page.evaluate(said, hop + shift).rpartition(": ")[2] for shift in (-1e-4, 1e-4))
    assert before != "flight"
    assert after == "flight"
