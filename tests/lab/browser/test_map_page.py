"""The map on the page: a click takes its motion, and it waits for its kernel."""

import pytest

uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

from hophoop.vocabulary.classes import class_text  # noqa: E402
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
