"""The page on which a person points at the hoop, in a browser: what is clicked is what is tracked."""

from dataclasses import replace
from queue import SimpleQueue
from threading import Thread

import numpy as np
import pytest

pytest.importorskip("av")

from film_maker import SMALL, article_like, make
from hophoop.lab.pick import pick
from hophoop.tracking import Hints
from lab_page_tools import PATIENCE

FILM = replace(SMALL, frames=12)
RIM = 39.0
ROUND = [[60, 92], [99, 131], [60, 170]]
# clicks that make no sense
REFUSED = [
    ([], "The clicks cannot be read."),
    ({"still": 99, "rim": ROUND}, "The clicks cannot be read."),
    ({"still": 0, "rim": ROUND[:2]}, "2 points on the rim are not enough: click at least 3."),
    ({"still": 0, "rim": [[1, 1], [2, 2], [3, 3]]}, "The points on the rim do not lie on a circle."),
    ({"still": 0, "rim": ROUND, "marker": [9999, 9999]}, "The marker was clicked outside the picture."),
]
POST = """async (said) => {
  const answer = await fetch("/", { method: "POST", body: JSON.stringify(said) });
  return [answer.status, (await answer.json()).error];
}"""


def test_clicks_are_hints(new_page, tmp_path):
    """On a phone: another frame is chosen, and clicks are taken back."""
    motion = article_like(duration=0.2)
    film = make(tmp_path / "hoop.mp4", motion, FILM)
    addresses, answers, troubles = SimpleQueue(), SimpleQueue(), []
    Thread(target=lambda: answers.put(pick(film, Hints(ring="dark"), addresses.put)), daemon=True).start()
    page = new_page(viewport={"width": 390, "height": 760})
    page.set_default_timeout(PATIENCE)
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.goto(addresses.get(timeout=60))
    page.wait_for_function("document.getElementById('still').naturalWidth > 0")
    assert page.locator("h1").inner_text() == "Where is the hoop in hoop.mp4?"
    for said, message in REFUSED:
        assert page.evaluate(POST, said) == [422, message]
    # nothing sticks out
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    send, count = page.locator("#send"), page.locator("#count")

    def click(*places):
        """At pixels of the film, wherever the page shows them."""
        box = page.locator("#still").bounding_box()
        for across, down in places:
            page.mouse.click(box["x"] + (across + 0.5) / 320 * box["width"], box["y"] + (down + 0.5) / 192 * box["height"])

    page.fill("#time", "3")
    page.wait_for_function("document.getElementById('still').complete")
    assert count.inner_text() == "3 more points on the rim"
    at = float(page.locator("#shown").inner_text().split()[0])
    state = motion.at(at)
    middle = np.array([60.0 + 130.0 * state.x, 170.0 - RIM])
    click((20, 20), (40, 20), (60, 20))
    assert "on a line" in count.inner_text()
    assert send.is_disabled()
    for _ in range(3):
        page.click("#undo")
    click((middle[0] + RIM, middle[1]), (20, 20))
    page.click("#undo")  # the last one
    click(*(middle + RIM * np.array([np.cos(around), np.sin(around)]) for around in np.linspace(0.3, 5.5, 6)))
    assert send.is_enabled()
    # what is drawn lies where the hoop is
    drawn = page.locator("#marks circle").last
    assert [float(drawn.get_attribute(key)) for key in ("cx", "cy", "r")] == pytest.approx([*middle, RIM], abs=1.5)
    page.click("[data-what=marker]")
    assert page.locator("[data-what=marker]").get_attribute("aria-pressed") == "true"
    click(middle + 0.86 * RIM * np.array([np.sin(state.angle), -np.cos(state.angle)]))
    page.click("[data-what=ground]")
    click((10, 170), (310, 170))
    send.click()
    page.wait_for_selector("text=Thank you")
    hints = answers.get(timeout=30)
    assert troubles == []
    assert hints.ring == "dark"
    assert hints.at == pytest.approx(at, abs=1e-3)
    assert hints.centre == pytest.approx(middle, abs=1.5)
    assert hints.rim == pytest.approx(RIM, abs=1.5)
    assert hints.ground == pytest.approx((10, 170, 310, 170), abs=1.0)
    assert int(hints.marker_color[1:3], 16) > 2 * int(hints.marker_color[3:5], 16)
