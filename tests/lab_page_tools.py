"""What the tests of the lab's page in a browser share."""

import os
import time
from pathlib import Path

PICTURES = Path(os.environ.get("HOPHOOP_SCREENSHOTS", Path(__file__).parent / "results" / "lab"))


# Conditions to wait for: nothing is under way and the diagrams are those of the motion; all that opens with the page is there.
SETTLED = "!lab.motions.lanes.some((lane) => lane.busy || lane.pending) && !lab.surrounding && !lab.requested"
SHOWN = f"lab.theory.list.children.length > 0 && {SETTLED}"
PATIENCE = 120_000  # milliseconds, on a machine with other work


def expect(locator):
    """Playwright's, with the patience of the other waits."""
    from playwright.sync_api import expect

    expect.set_options(timeout=PATIENCE)
    return expect(locator)


def summary(page):
    return page.locator(".summary").inner_text()


def wait_for(page, expression):
    page.wait_for_function(f"() => {{ const lab = hophoopLab; return {expression}; }}")


def until(page, holds, seconds=30.0):
    """Wait for something outside of the page; what the page says is heard meanwhile."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, f"not so after {seconds:g} s"
        page.wait_for_timeout(20)


def picture(page, name, **options):
    PICTURES.mkdir(parents=True, exist_ok=True)
    page.screenshot(path=PICTURES / f"{name}.png", **options)


def colors_on(page, selector):
    """How many different colours a canvas shows."""
    return page.evaluate(
        """selector => {
          const source = document.querySelector(selector);
          const copy = document.createElement("canvas");
          copy.width = 200; copy.height = 120;
          const context = copy.getContext("2d");
          context.drawImage(source, 0, 0, 200, 120);
          const { data } = context.getImageData(0, 0, 200, 120);
          return new Set(new Uint32Array(data.buffer)).size;
        }""",
        selector,
    )
