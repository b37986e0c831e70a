"""Fingers and the wheel: one rule for all pictures of the page."""

import pytest

from lab_page_tools import PHONE, SHOWN, until, wait_for


def fingers(page):
    """What puts fingers down, moves them and lifts them."""
    session = page.context.new_cdp_session(page)

    def touch(kind, *places):
        points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    return touch


def at_rest(page, target):
    """Where a part of the page is when what is computed for the page moves it no more."""
    boxes = [target.bounding_box()]

    def rests():
        page.wait_for_timeout(100)
        boxes.append(target.bounding_box())
        return boxes[-1] == boxes[-2]

    until(page, rests)
    return boxes[-1]


# what two fingers zoom, and how wide the part is that it shows
ZOOMED = {
    ".stage canvas": "1 / hophoopLab.stage.flat.zoom",
    "[data-plot=forces] .plot-body": "hophoopLab.plots.shared.range?.reduce((low, high) => high - low) ?? 6",
    ".phase .plot-body": "hophoopLab.phase.range[1] - hophoopLab.phase.range[0]",
    ".map-body": "hophoopLab.map.axes.windows.x[1] - hophoopLab.map.axes.windows.x[0]",
}


@pytest.mark.long
def test_two_fingers_zoom_and_take_no_motion(visit):
    page = visit(**PHONE)
    touch = fingers(page)
    for selector, width in ZOOMED.items():
        target = page.locator(selector).first
        target.scroll_into_view_if_needed()
        wait_for(page, "!lab.surrounding")
        before = page.evaluate(width)
        box = at_rest(page, target)
        x, y = box["x"] + 0.6 * box["width"], box["y"] + 0.4 * box["height"]
        touch("touchStart", (x - 20, y))
        touch("touchStart", (x - 20, y), (x + 20, y))
        for spread in range(25, 81, 5):
            touch("touchMove", (x - spread, y), (x + spread, y))
        touch("touchEnd", (x - 80, y))
        touch("touchEnd")
        until(page, lambda width=width, wanted=pytest.approx(before / 4, rel=0.15): page.evaluate(width) == wanted)
    page.wait_for_timeout(300)
    assert page.evaluate("hophoopLab.motions.history.past.length") == 0
    assert page.evaluate("hophoopLab.film().query") == ""


# the browser tells which diagrams are in view after a picture of the page or two, and fingers can be there before
NO_DIAGRAM_SEEN = """
window.IntersectionObserver = class extends IntersectionObserver {
  constructor(tell, options) {
    const unseen = (entry) =>
      entry.target.matches(".plot") ? { target: entry.target, isIntersecting: false } : entry;
    super((entries) => tell(entries.map(unseen)), options);
  }
};
"""

PLACES_IN_SECTION = """() => {
  const top = document.querySelector(".plots").getBoundingClientRect().y;
  return [...document.querySelectorAll(".plot-body")].map((body) => body.getBoundingClientRect().y - top);
}"""


def test_a_diagram_that_is_not_drawn_yet_zooms_and_keeps_its_place(visit):
    page = visit(**PHONE, script=NO_DIAGRAM_SEEN)
    wait_for(page, "!lab.surrounding && [...lab.plots.seen.values()].every(seen => !seen)")
    target = page.locator("[data-plot=forces] .plot-body")
    target.scroll_into_view_if_needed()
    box = at_rest(page, target)  # the stage shrinks after a scroll, and the browser scrolls again to make up for it
    before = page.evaluate(PLACES_IN_SECTION)
    x, y = box["x"] + 0.6 * box["width"], box["y"] + 0.4 * box["height"]
    touch = fingers(page)
    touch("touchStart", (x - 20, y))
    touch("touchStart", (x - 20, y), (x + 20, y))
    touch("touchMove", (x - 80, y), (x + 80, y))
    touch("touchEnd")
    low, high = page.evaluate("hophoopLab.plots.shared.range")
    assert high - low == pytest.approx(6 / 4, rel=0.15)
    page.evaluate("for (const plot of hophoopLab.plots.plots) hophoopLab.plots.seen.set(plot.element, true)")
    page.evaluate("hophoopLab.plots.redraw()")
    assert page.evaluate(PLACES_IN_SECTION) == pytest.approx(before, abs=0.5)  # a line of a legend has 16 pixels


def test_the_wheel_scrolls_on_unless_the_stage_is_chosen(visit):
    page = visit()
    box = page.locator(".stage").bounding_box()
    page.mouse.move(box["x"] + 300, box["y"] + 200)
    page.mouse.wheel(0, 300)
    page.wait_for_function("() => scrollY > 100")
    assert page.evaluate("hophoopLab.stage.flat.zoom") == 1
    page.evaluate("scrollTo(0, 0)")
    page.mouse.click(box["x"] + 300, box["y"] + 200)
    page.mouse.wheel(0, -300)
    page.wait_for_function("() => hophoopLab.stage.flat.zoom > 1.2")
    assert page.evaluate("scrollY") == 0


@pytest.mark.parametrize(("way", "moves"), [((0, -60), False), ((6, -50), False), ((60, 4), True)])
def test_a_finger_moves_the_map_only_when_it_starts_across(visit, way, moves):
    page = visit(**PHONE)
    wait_for(page, SHOWN)
    if not page.locator(".map-body").is_visible():
        page.evaluate("hophoopLab.view.show(true)")
    page.locator(".map-body").scroll_into_view_if_needed()
    page.evaluate("hophoopLab.map.zoom(0.5)")
    before = page.evaluate("hophoopLab.map.axes.windows")
    box = page.locator(".map-body").bounding_box()
    x, y = box["x"] + 0.6 * box["width"], box["y"] + 0.5 * box["height"]
    touch = fingers(page)
    query = page.evaluate("hophoopLab.film().query")
    touch("touchStart", (x, y))
    for k in range(1, 7):
        touch("touchMove", (x + way[0] * k / 6, y + way[1] * k / 6))
    touch("touchEnd")
    page.wait_for_timeout(200)
    assert (page.evaluate("hophoopLab.map.axes.windows") != before) is moves
    assert page.evaluate("hophoopLab.film().query") == query
