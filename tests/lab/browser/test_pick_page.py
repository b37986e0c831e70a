"""The page on which a person points at the hoop, in a browser: what is clicked is what is tracked."""

import threading

import numpy as np
import pytest

pytest.importorskip("av", reason="the extra 'track' is not installed")

import hophoop as hh
from film_maker import Film, article_like, make
from hophoop.lab.server.pick import pick
from hophoop.tracking import Hints
from lab_page_tools import PATIENCE

FILM = Film(size=(320, 192), scale=130.0, origin=(60.0, 170.0), frames=12, marker_size=0.06)
MIDDLE, RIM = np.array([60.0, 131.0]), 39.0


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    return make(tmp_path_factory.mktemp("film") / "hoop.mp4", article_like(duration=0.2), FILM)


@pytest.fixture
def asked(browser, film):
    """Opens the page in a browser of some kind; gives the page, and what was told in the end."""
    contexts, answers = [], {}

    def open_page(**options):
        found, ready = {}, threading.Event()

        def show(address):
            found["address"] = address
            ready.set()

        def wait():
            answers["hints"] = pick(film, Hints(), show)

        thread = threading.Thread(target=wait, daemon=True)
        thread.start()
        assert ready.wait(60)
        context = browser.new_context(**options)
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(PATIENCE)
        troubles = []
        page.on("pageerror", lambda error: troubles.append(str(error)))
        page.goto(found["address"])
        page.wait_for_function("document.getElementById('still').naturalWidth > 0")

        def end():
            page.wait_for_selector("text=Thank you")
            thread.join(30)
            assert not thread.is_alive()
            assert troubles == []
            return answers["hints"]

        return page, end

    yield open_page
    for context in contexts:
        context.close()


def click(page, place):
    """At a pixel of the film, wherever the page shows it."""
    box = page.locator("#still").bounding_box()
    page.mouse.click(box["x"] + (place[0] + 0.5) / 320 * box["width"], box["y"] + (place[1] + 0.5) / 192 * box["height"])


@pytest.mark.parametrize("dark", [False, True])
def test_clicks_are_hints(asked, dark):
    page, end = asked(viewport={"width": 1200, "height": 900}, color_scheme="dark" if dark else "light")
    send, count = page.locator("#send"), page.locator("#count")
    assert send.is_disabled()
    assert count.inner_text() == "3 more points on the rim"
    for around in (0.4, 2.5, 4.6):
        click(page, MIDDLE + RIM * np.array([np.cos(around), np.sin(around)]))
    assert send.is_enabled()
    # what is drawn lies where the hoop is
    drawn = page.locator("#marks circle").last
    assert [float(drawn.get_attribute(key)) for key in ("cx", "cy", "r")] == pytest.approx([*MIDDLE, RIM], abs=0.7)
    page.click("[data-what=marker]")
    assert page.locator("[data-what=marker]").get_attribute("aria-pressed") == "true"
    click(page, MIDDLE + 0.86 * RIM * np.array([np.sin(0.1), -np.cos(0.1)]))
    page.click("[data-what=ground]")
    click(page, (10, 170))
    click(page, (310, 170))
    send.click()
    hints = end()
    assert hints.centre == pytest.approx(MIDDLE, abs=0.7)
    assert hints.rim == pytest.approx(RIM, abs=0.7)
    assert hints.at == 0.0
    assert hints.ground == pytest.approx((10, 170, 310, 170), abs=0.6)
    assert int(hints.marker_color[1:3], 16) > 2 * int(hints.marker_color[3:5], 16)


def test_another_frame_and_clicks_taken_back(asked):
    page, end = asked(viewport={"width": 390, "height": 760})
    # nothing sticks out on a phone
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.fill("#time", "3")
    page.wait_for_function("document.getElementById('still').complete")
    at = float(page.locator("#shown").inner_text().split()[0])
    state = article_like(duration=0.2).at(at)
    middle = np.array([60.0 + 130.0 * state.x, 170.0 - RIM])
    for spot in ((20, 20), (40, 20), (60, 20)):
        click(page, spot)
    assert "on a line" in page.locator("#count").inner_text()
    assert page.locator("#send").is_disabled()
    for _ in range(3):
        page.click("#undo")
    for around in np.linspace(0.3, 5.5, 6):
        click(page, middle + RIM * np.array([np.cos(around), np.sin(around)]))
    page.click("#send")
    hints = end()
    assert hints.at == pytest.approx(at, abs=1e-3)
    assert hints.centre == pytest.approx(middle, abs=1.5)


def test_what_was_clicked_finds_the_hoop(asked, film):
    page, end = asked(viewport={"width": 1000, "height": 800})
    for around in (0.4, 2.5, 4.6):
        click(page, MIDDLE + RIM * np.array([np.cos(around), np.sin(around)]))
    page.click("#send")
    track = hh.track(film, 0.3, end())
    assert track.found.all()
