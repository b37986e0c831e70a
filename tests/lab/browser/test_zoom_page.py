"""Fingers and the wheel: one rule for all pictures of the page."""

import pytest

from lab_page_tools import PHONE, SHOWN, each_of, fingers, follow, until, wait_for


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


# name: (link, options, steps), as in test_flows.py
MAP = [
    f"until {SHOWN}",
    "do first('.map-body').scrollIntoView({ block: 'center' }); lab.map.zoom(0.5); globalThis.before = String(Object.values("
    "lab.map.axes.windows)); globalThis.query = lab.film().query",
]
MOVED = "String(Object.values(lab.map.axes.windows)) !== before"
FLOWS = {
    "the wheel scrolls on unless the stage is chosen": ("", {}, [
        "point .stage 0.4 0.4",
        "wheel 300",
        "until scrollY > 100",
        "is lab.stage.flat.zoom === 1",
        "do scrollTo(0, 0)",
        "click .stage",
        "wheel -300",
        "until lab.stage.flat.zoom > 1.2",
        "is scrollY === 0",
    ]),
    **{
        f"a finger {words} the map": ("", PHONE, [
            *MAP,
            f"touch .map-body: [1, 2, 3, 4, 5, 6].map((k) => [{across} * k / 6, {down} * k / 6])",
            "wait 200",
            f"is {MOVED} === {moves} && lab.film().query === query",
        ])
        for words, across, down, moves in (
            ("that starts upwards leaves", 0, -60, "false"),
            ("that starts nearly upwards leaves", 6, -50, "false"),
            ("that starts across moves", 60, 4, "true"),
        )
    },
}  # fmt: skip


@each_of(FLOWS)
def test_wheel_and_finger(visit, name):
    link, options, steps = FLOWS[name]
    follow(visit(link, **options), steps)
