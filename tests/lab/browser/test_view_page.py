"""What a visitor sees first: one run of the motion, the simple view, names and links of what is shown."""

import math

import pytest

import hophoop as hh
from hophoop._version import __version__
from lab_page_tools import PHONE, SETTLED, SHOWN, wait_for

SLIDERS = (
    "[...document.querySelectorAll('.controls .slider')].filter((one) => one.checkVisibility()).map((one) => one.dataset.path)"
)
SIMPLE = "lab.root.classList.contains('simple')"


def is_simple(page):
    return page.evaluate(f"(() => {{ const lab = hophoopLab; return {SIMPLE}; }})()")


@pytest.mark.parametrize(
    ("link", "simple"),
    [
        ("?plane.slope=0.1#zoom=2&show=tf3&fingerprint=0123456789abcdef", True),
        ("#with=start.speed%3D2&map=sequence,start.speed,1,2,plane.mu,0.5,1", True),
        ("#view=everything", False),
    ],
)
def test_a_link_opens_the_view_in_which_it_was_copied(visit, link, simple):
    page = visit(link, simple=True, reduced_motion="reduce")  # not waiting for the end of a first run
    wait_for(page, SETTLED)
    assert is_simple(page) == simple
    # it was the link's wish, not the visitor's
    assert page.evaluate("localStorage.getItem('hophoop-view')") is None


@pytest.mark.parametrize("simple", [True, False])
def test_a_copied_link_opens_as_it_was_copied(visit, address, simple):
    page = visit("?plane.slope=0.1", simple=simple, reduced_motion="reduce", permissions=["clipboard-read", "clipboard-write"])
    wait_for(page, SETTLED)
    page.locator("summary", has_text="Share").click()
    page.get_by_role("button", name="Copy a link to this motion").click()
    page.locator(".toast", has_text="Link copied.").wait_for()
    link = page.evaluate("navigator.clipboard.readText()").removeprefix(address)
    assert "fingerprint" not in link
    other = visit(link, simple=True, reduced_motion="reduce", **PHONE)
    wait_for(other, SETTLED)
    assert is_simple(other) == simple
    # what the simple view does not show is said
    assert other.locator(".beyond").is_visible() == simple


def test_a_phone_shows_hoop_play_and_three_sliders_without_scrolling(visit):
    for locale in ("en", "de", "fr", "es"):
        page = visit(simple=True, locale=locale, reduced_motion="reduce", **PHONE)
        wait_for(page, SETTLED)
        assert page.evaluate("document.documentElement.scrollWidth") == 390
        paths = [f"input[data-path='{path}']" for path in ("start.speed", "hoop.load_fraction", "plane.mu")]
        for seen in (".stage", ".transport .play", *paths):
            box = page.locator(seen).bounding_box()
            assert box["y"] >= 0
            assert box["y"] + box["height"] <= 844, (locale, seen)
        small = page.evaluate(
            """() => [...document.querySelectorAll("button, select, summary, input")].filter((one) => one.checkVisibility())
              .filter((one) => Math.min(one.getBoundingClientRect().width, one.getBoundingClientRect().height) < 43.5)
              .map((one) => one.outerHTML.slice(0, 90))"""
        )
        assert small == []
        # a menu lies on the screen, wherever its button is
        for menu in (".menu", ".learn"):
            page.locator(f"{menu} summary").tap()
            box = page.locator(f"{menu} .menu-body").bounding_box()
            assert box["x"] >= 0
            assert box["x"] + box["width"] <= 390
            page.locator(f"{menu} summary").tap()


def test_about_has_version_licence_and_documentation(visit):
    page = visit("#t=0.5", simple=True)
    page.locator(".learn summary").click()
    page.get_by_role("button", name="About hophoop").click()
    about = page.locator("dialog.about[open]")
    said = about.inner_text()
    assert __version__ in said
    assert "MIT" in said
    assert "Documentation" not in said  # this page was told no address
    assert "hophoop --help" in said
    licences = page.request.get(about.get_by_role("link").get_attribute("href"))
    assert licences.ok
    assert "MIT licence" in licences.text()
    about.get_by_role("button", name="Close").click()
    assert about.count() == 0


def test_words_point_to_their_place_in_picture_bar_and_diagrams(visit):
    page = visit(viewport={"width": 1440, "height": 1800})
    wait_for(page, f"lab.phase.pictures?.length === 1 && {SHOWN}")
    hop = hh.simulate(hh.Scenario()).find("takeoff")[0]
    line = page.locator(".story-list button").filter(has_text="It hops at")
    painted = """selectors => selectors.map((one) => [...document.querySelectorAll(one)]
      .map((canvas) => canvas.toDataURL()).join())"""
    places = [".stage-canvas:not([hidden])", ".timeline-canvas", ".phase .plot-over", "[data-plot=velocities] .plot-over"]
    before = page.evaluate(painted, places)
    for point, leave in (
        ("hover", lambda: page.mouse.move(5, 5)),
        ("focus", lambda: page.evaluate("document.activeElement.blur()")),
    ):
        getattr(line, point)()
        wait_for(page, f"lab.clock.pointed === {hop.t} && {SETTLED}")
        after = page.evaluate(painted, places)
        assert [one != other for one, other in zip(before, after, strict=True)] == [True] * 4, point
        assert page.evaluate("hophoopLab.clock.time") == 0  # nothing else moves
        leave()
        wait_for(page, f"lab.clock.pointed === null && {SETTLED}")
        assert page.evaluate(painted, places) == before
    # beside the picture, an arrow leads to what lies outside of it
    last = page.locator(".story-list button").last
    last.focus()
    wait_for(page, f"lab.clock.pointed > 5 && {SETTLED}")
    assert page.evaluate(painted, places[:1]) != before[:1]
    # the motion is the same: the list keeps the focus when the page is drawn anew
    page.evaluate("hophoopLab.show()")
    wait_for(page, SETTLED)
    assert last.evaluate("one => document.activeElement === one")


def test_the_load_is_dragged_in_the_simple_view(visit):
    page = visit("#t=0.001", simple=True, reduced_motion="reduce")
    wait_for(page, SETTLED)
    page.evaluate("hophoopLab.clock.seek(0)")
    wait_for(page, SETTLED)
    load, hoop = (page.locator(f".grip-{grip}").bounding_box() for grip in ("load", "hoop"))
    x, y = load["x"] + load["width"] / 2, load["y"] + load["height"] / 2
    radius = hoop["y"] + hoop["height"] / 2 - y
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + radius, y + radius, steps=3)
    page.wait_for_timeout(200)
    page.mouse.up()
    wait_for(page, f"lab.motions.history.past.length === 1 && {SETTLED}")
    assert page.evaluate("hophoopLab.film().scenario.start.angle") == pytest.approx(math.pi / 2, abs=0.05)
    assert is_simple(page)
    assert len(page.evaluate(SLIDERS)) == 3
