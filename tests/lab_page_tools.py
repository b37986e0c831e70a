"""What the tests of the lab's page in a browser share."""

import contextlib
import os
import re
import textwrap
import threading
import time
from pathlib import Path
from string import Template
from urllib.parse import urljoin

import pytest

PICTURES = os.environ.get("HOPHOOP_SCREENSHOTS")  # a folder for pictures that people look at


# Conditions to wait for: nothing is under way and the diagrams are those of the motion; all that opens with the page is there.
SETTLED = "!lab.motions.lanes.some((lane) => lane.busy || lane.pending) && !lab.surrounding && !lab.requested"
SHOWN = f"lab.theory.list.children.length > 0 && {SETTLED}"
PATIENCE = 120_000  # milliseconds, on a machine with other work
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True, "device_scale_factor": 1}


@contextlib.contextmanager
def serving(**options):
    """The address of the lab's server on loopback; options of `server_of`."""
    from hophoop.lab.server import server_of

    with server_of(**options) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/"
        server.shutdown()


AXE = "async () => (await axe.run(document)).violations.map(({ impact, id, nodes }) => [impact, id, nodes[0].html])"


def accessible(page):
    """What axe-core finds, with its impact, where HOPHOOP_AXE names its axe.min.js (npm install axe-core)."""
    if not os.environ.get("HOPHOOP_AXE"):
        return []
    # evaluated, not put into the page: a policy that allows nothing foreign stays in force
    page.evaluate(Path(os.environ["HOPHOOP_AXE"]).read_text(encoding="utf-8"))
    # on the way from one colour to another, contrast is neither's
    page.wait_for_function("() => !document.getAnimations().some((one) => one instanceof CSSTransition)")
    return page.evaluate(AXE)


def expect(locator):
    """Playwright's, with the patience of the other waits."""
    from playwright.sync_api import expect

    expect.set_options(timeout=PATIENCE)
    return expect(locator)


def summary(page):
    return page.locator(".summary").inner_text()


def wait_for(page, expression):
    page.wait_for_function(f"() => {{ const lab = hophoopLab; return {expression}; }}")


# What the conditions of steps know: elements, whether they are seen, what they say, and what stands in a field by its name.
WORDS = """
  const all = (selector) => [...document.querySelectorAll(selector)];
  const shown = (element) => element.checkVisibility({ visibilityProperty: true });
  const first = (selector) => all(selector).find(shown) ?? document.querySelector(selector);
  const seen = (selector) => all(selector).some(shown);
  const text = (selector) => first(selector)?.innerText ?? "";
  const value = (label) => first(`[aria-label="${label}"]`).value;
  const event = (kind) => lab.film().events.find((one) => one.kind === kind);
  const near = (one, other, size) => Math.abs(one - other) <= size;
  const degrees = (angle) => `${(angle * 180 / Math.PI).toFixed(1)}°`;
  const digits = (number, count = 3) => String(Number(number.toPrecision(count)));
"""


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


class Steps:
    """What a step of a flow does, by its first word; the rest of its line is `said`."""

    def __init__(self, page):
        self.page = page

    def until(self, said):
        self.page.wait_for_function(f"() => {{ const lab = globalThis.hophoopLab; {WORDS} return lab && ({said}); }}")

    def do(self, said):
        return self.page.evaluate(f"async () => {{ const lab = hophoopLab; {WORDS} {said}; }}")

    def check(self, said):
        found = self.page.evaluate(f"() => {{ const lab = hophoopLab; {WORDS} return Boolean({said}); }}")
        assert found, said

    def press(self, said):
        key, _, label = said.partition(" in ")
        if label:
            self.page.get_by_label(label, exact=True).press(key)
        else:
            self.page.keyboard.press(key)

    def type(self, said):
        label, _, text = said.rpartition(" = ")
        field = self.page.get_by_label(label, exact=True)
        field.fill(text)
        field.press("Enter")

    def fill(self, said):
        path, text = said.split()
        self.page.locator(f"input[data-path='{path}']").fill(text)

    def choose(self, said):
        selector, value = said.split()
        self.page.locator(selector).select_option(value)

    def click(self, said):
        self.page.locator(said).first.click()

    def button(self, said):
        self.page.get_by_role("button", name=said, exact=True).click()

    def way(self, said):
        """The middle of what is named, and places behind a colon, given in pixels from there."""
        selector, _, places = said.partition(": ")
        box = self.page.locator(selector).first.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        return [(x + dx, y + dy) for dx, dy in [(0, 0), *self.do(f"return {places}")]]

    def drag(self, said):
        """Along a way; `drop` lets go."""
        first, *others = self.way(said)
        self.page.mouse.move(*first)
        self.page.mouse.down()
        for place in others:
            self.page.mouse.move(*place)

    def drop(self, _):
        self.page.mouse.up()

    def touch(self, said):
        """A finger along a way, lifted at the end."""
        first, *others = self.way(said)
        touch = fingers(self.page)
        touch("touchStart", first)
        for place in others:
            touch("touchMove", place)
        touch("touchEnd")

    def pinch(self, said):
        """Two fingers spread to four times their distance."""
        box = at_rest(self.page, self.page.locator(said).first)
        x, y = box["x"] + 0.6 * box["width"], box["y"] + 0.4 * box["height"]
        touch = fingers(self.page)
        touch("touchStart", (x - 20, y))
        for spread in range(20, 81, 5):
            touch("touchMove" if spread > 20 else "touchStart", (x - spread, y), (x + spread, y))
        touch("touchEnd", (x - 80, y))
        touch("touchEnd")

    def point(self, said):
        """At a part of the width and the height of what is named."""
        selector, across, down = said.rsplit(maxsplit=2)
        box = self.page.locator(selector).first.bounding_box()
        self.page.mouse.move(box["x"] + float(across) * box["width"], box["y"] + float(down) * box["height"])

    def wheel(self, said):
        self.page.mouse.wheel(0, float(said))

    def save(self, said):
        """What a button saves is a text, `kept`."""
        with self.page.expect_download() as download:
            self.button(said)
        text = download.value.path().read_bytes().decode("latin-1")
        self.page.evaluate("text => { globalThis.kept = text; }", text)

    def write(self, said):
        selector, text = said.split()
        self.page.locator(selector).fill(text)
        self.page.locator(selector).press("Enter")

    def size(self, said):
        width, height = map(int, said.split())
        self.page.set_viewport_size({"width": width, "height": height})

    def media(self, said):
        self.page.emulate_media(media=said)

    def sheets(self, said):
        """So many pages of A4 in print."""
        assert self.page.pdf(format="A4").count(b"/Type /Page\n") == int(said)

    def back(self, _):
        self.page.go_back()

    def forward(self, _):
        self.page.go_forward()

    def goto(self, said):
        """A link that the page gives, as somebody else opens it."""
        link = urljoin(self.page.url, self.do(f"return {said}"))
        self.page.goto("about:blank")
        self.page.goto(link)
        self.page.wait_for_selector("[data-ready]")

    def open(self, said):
        self.page.goto(re.split("[?#]", self.page.url)[0] + said)

    def reload(self, _):
        self.page.reload()
        self.page.wait_for_selector("[data-ready]")

    def wait(self, said):
        self.page.wait_for_timeout(float(said))


def each_of(flows, *long):
    """A test for each flow; the long ones in CI only."""
    marked = [pytest.param(flow, id=name, marks=pytest.mark.long if name in long else ()) for name, flow in flows.items()]
    return pytest.mark.parametrize("flow", marked)


def steps_of(text, names):
    """Steps of a text, a line each that goes on where it is indented; `#` begins a comment, `3 ×` tells how often.

    `$NAME` stands for one of the names; all know SETTLED and SHOWN.
    """
    for line in re.sub(r"\n +", " ", textwrap.dedent(text)).split("\n"):
        often, step = re.fullmatch(r"(?:(\d+) × )?(.*)", line).groups()
        if step and not step.startswith("# "):
            yield from int(often or 1) * [Template(step).safe_substitute(names, SETTLED=SETTLED, SHOWN=SHOWN)]


def follow(page, steps):
    """Take steps, each a line that begins with a verb of `Steps`; `is` checks that something holds at once."""
    does = Steps(page)
    for step in steps:
        print(step)  # pytest shows it where one fails
        verb, _, said = step.partition(" ")
        getattr(does, {"is": "check"}.get(verb, verb))(said)


def take(visit, flow, names):
    """Take the steps of a flow, which has a link, options and these, as a list or as a text with names; return the page."""
    link, options, steps = flow
    page = visit(link, **options)
    follow(page, steps_of(steps, names) if isinstance(steps, str) else steps)
    return page


def until(page, holds, seconds=30.0):
    """Wait for something outside of the page; what the page says is heard meanwhile."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, f"not so after {seconds:g} s"
        page.wait_for_timeout(20)


def picture(page, name, **options):
    if PICTURES:
        page.screenshot(path=Path(PICTURES) / f"{name}.png", **options)


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
