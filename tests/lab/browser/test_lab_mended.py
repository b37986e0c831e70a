"""The page in use: what one types, presses and goes back from, on screens large and small, with a screen reader."""

import pytest

pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

from lab_page_tools import SETTLED, expect, wait_for
from slow_page import also_delayed


@also_delayed
def test_a_slider_loses_no_key_and_no_entry_is_lost_without_a_word(visit):
    page = visit("?start.speed=3.1", expected=["422"])
    slider = page.locator("input[data-path='start.speed']")
    slider.focus()
    page.evaluate("() => { const now = performance.now(); performance.now = () => now; }")  # as fast as keys can come
    for _ in range(20):
        page.keyboard.press("ArrowLeft")
    wait_for(page, f"lab.film().values['start.speed'] === 2.9 && lab.motions.history.past.length > 0 && {SETTLED}")
    page.evaluate("delete performance.now")
    assert slider.input_value() == "2.9"
    assert page.evaluate("hophoopLab.motions.history.past.length") == 1  # keys in a row are one step
    # while a hand holds it, an answer writes nothing
    slider.dispatch_event("pointerdown")
    page.evaluate("() => { document.querySelector(\"input[data-path='start.speed']\").value = '1.5'; hophoopLab.show(); }")
    assert slider.input_value() == "1.5"
    slider.dispatch_event("pointerup")
    page.evaluate("hophoopLab.show()")
    assert slider.input_value() == "2.9"

    slope = page.get_by_label("Slope, exact value in °", exact=True)
    error = page.locator(".control .error:visible")
    for typed, said in (("abc", "must be a number"), ("100", "from −89.95 to 89.95°"), ("inf", "must be from")):
        slope.fill(typed)
        slope.press("Enter")
        expect(error).to_contain_text(said)
        assert "rad" not in error.inner_text()
        assert slope.get_attribute("aria-invalid") == "true"
        assert slope.get_attribute("aria-describedby") == error.get_attribute("id")
        assert slope.input_value() == typed
    slope.press("Escape")
    assert slope.input_value() == "0"
    assert slope.get_attribute("aria-invalid") is None
    slope.fill("3,1")
    slope.press("Enter")
    wait_for(page, "Math.abs(lab.film().scenario.plane.slope - 3.1 * Math.PI / 180) < 1e-12")
    friction = page.get_by_label("Friction, exact value", exact=True)
    friction.fill("inf")
    friction.press("Enter")
    wait_for(page, "lab.film().scenario.plane.mu === 'inf'")
    assert friction.input_value() == "∞"


@pytest.mark.long
def test_what_is_said_of_a_preset_goes_when_it_is_changed_and_comes_back_with_undo(visit):
    page = visit()
    presets = page.locator(".presets")
    presets.select_option("slip")
    text = page.locator(".preset-text")
    wait_for(page, "lab.film().query.includes('2.8')")
    assert "Friction is used up twice" in text.inner_text()
    # Space plays what has just been chosen
    presets.focus()
    presets.select_option("hop")
    wait_for(page, "lab.film().query === 'duration=3'")
    page.keyboard.press(" ")
    wait_for(page, "lab.clock.playing")
    page.keyboard.press(" ")
    page.locator("input[data-path='start.speed']").fill("2.5")
    wait_for(page, "lab.film().values['start.speed'] === 2.5 && " + SETTLED)
    assert text.inner_text() == ""
    assert presets.input_value() == ""
    page.keyboard.press("Control+z")
    wait_for(page, "lab.film().query === 'duration=3'")
    assert "leaves the plane" in text.inner_text()
    assert presets.input_value() == "hop"
    page.keyboard.press("Control+Shift+z")
    wait_for(page, "lab.film().values['start.speed'] === 2.5")


@pytest.mark.long
def test_back_goes_one_change_at_a_time_and_a_link_holds_what_is_seen(visit):
    page = visit("?start.speed=2")
    for speed in ("2.2", "2.4"):
        page.locator("input[data-path='start.speed']").fill(speed)
        wait_for(page, f"lab.film().values['start.speed'] === {speed} && {SETTLED}")
        page.wait_for_timeout(1100)  # else it would be one step
    page.go_back()
    wait_for(page, "lab.film().values['start.speed'] === 2.2")
    page.go_back()
    wait_for(page, "lab.film().values['start.speed'] === 2")
    assert page.evaluate("[hophoopLab.motions.history.past.length, hophoopLab.motions.history.future.length]") == [0, 2]
    page.go_forward()
    wait_for(page, "lab.film().values['start.speed'] === 2.2")
    page.keyboard.press("z")
    wait_for(page, "lab.film().values['start.speed'] === 2")
    page.wait_for_function("() => location.search === '?start.speed=2'")
    page.keyboard.press("f")
    page.evaluate("() => { hophoopLab.clock.seek(1.25); hophoopLab.map.axes.windows = { x: [1, 2], y: [0.5, 1] }; }")
    canvas = page.locator(".stage canvas").first.bounding_box()
    x, y = canvas["x"] + 0.85 * canvas["width"], canvas["y"] + 0.15 * canvas["height"]  # beside the hoop: the picture is moved
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 0.25 * canvas["width"], y + 0.1 * canvas["height"], steps=3)
    page.mouse.up()
    link = page.evaluate("hophoopLab.link()")
    assert "&pan=-0.25,0.1" in link
    other = visit(link.split("/", 3)[3], viewport={"width": 1000, "height": 800})
    assert other.evaluate("hophoopLab.stage.flat.pan()") == pytest.approx([-0.25, 0.1], abs=2e-3)
    shown = "[lab.clock.time, lab.stage.options.forces, lab.map.axes.windows.x[0], lab.map.axes.windows.y[1]]"
    assert other.evaluate(f"(() => {{ const lab = hophoopLab; return {shown}; }})()") == [1.25, False, 1, 1]


def test_a_server_that_is_gone_is_named_and_no_step_is_lost(visit):
    page = visit("?start.speed=2", expected=["ERR_", "Failed to load"])
    page.evaluate("() => { hophoopLab.backend.film = async () => { throw new Error('The server does not answer.'); }; }")
    page.locator("input[data-path='start.speed']").fill("3.1")
    page.locator(".control .error:visible").wait_for()
    assert "does not answer" in page.locator(".control .error:visible").inner_text()
    page.evaluate("() => { delete hophoopLab.backend.film; }")
    page.locator("input[data-path='start.speed']").fill("3")
    wait_for(page, "lab.film().values['start.speed'] === 3 && " + SETTLED)
    page.evaluate("() => { hophoopLab.backend.film = async () => { throw new Error('The server does not answer.'); }; }")
    page.keyboard.press("z")
    page.wait_for_timeout(300)
    assert page.evaluate("hophoopLab.motions.history.past.length") == 1  # the step is kept
    page.evaluate("() => { delete hophoopLab.backend.film; }")
    page.keyboard.press("z")
    wait_for(page, "lab.film().values['start.speed'] === 2")
    # what it says when it does not answer
    said = page.evaluate(
        """async () => {
          const { fetch } = globalThis;
          globalThis.fetch = async () => { throw new TypeError("Failed to fetch"); };
          try { await hophoopLab.backend.python.file("motion.nc", {}); return ""; } catch (error) { return error.message; }
          finally { globalThis.fetch = fetch; }
        }"""
    )
    assert said == "backend.server_silent"


@pytest.mark.long
def test_a_screen_reader_hears_little_and_what_matters(visit):
    page = visit()
    wait_for(page, SETTLED)
    regions = (
        "[...document.querySelectorAll('[aria-live], [role=status], [role=alert], output')].filter((e) => e.checkVisibility())"
    )
    assert page.evaluate(f"{regions}.length") <= 4
    page.evaluate(
        """() => {
          globalThis.said = 0;
          const watch = new MutationObserver((changes) => { globalThis.said += changes.length; });
          for (const region of document.querySelectorAll("[aria-live], [role=status], [role=alert], output, .timeline")) {
            const own = { childList: true, characterData: true, subtree: true };
            const value = { attributes: true, attributeFilter: ["aria-valuetext"] };
            watch.observe(region, region.matches(".timeline") ? value : own);
          }
        }"""
    )
    page.keyboard.press(" ")
    wait_for(page, "lab.clock.time > 1.2")
    page.keyboard.press(" ")
    assert page.evaluate("said") <= 12  # some changes of mode, no frames
    page.keyboard.press("Home")
    page.keyboard.press("h")
    wait_for(page, "document.querySelector('.spoken').textContent === 'take-off at 315.6°, 1.045 s'")
    wait_for(page, "document.querySelector('.timeline').getAttribute('aria-valuetext') === '1.045 seconds, flight'")


def test_keys_can_be_switched_off_and_escape_leaves(visit):
    page = visit()
    wait_for(page, SETTLED)
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to the player"
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.className") == "timeline"
    page.locator(".menu summary", has_text="Share").click()
    page.keyboard.press("Escape")
    assert page.locator(".menu[open]").count() == 0
    page.keyboard.press("?")
    rows = page.locator("dialog[open] table").all_inner_texts()
    letters = next(text for text in rows if "skid" in text)
    assert "S\tspin\tslip: the rim turns too fast" in letters
    assert "K\tskid\tslip: the rim slides ahead" in letters
    page.get_by_label("Enable single-key shortcuts").uncheck()
    page.keyboard.press("Escape")
    page.keyboard.press("h")
    page.keyboard.press("f")
    assert page.evaluate("[hophoopLab.clock.time, hophoopLab.stage.options.forces]") == [0, True]
    page.locator(".stage").focus()
    page.keyboard.press(" ")
    wait_for(page, "lab.clock.playing")
    again = page.context.new_page()
    again.goto(page.url.partition("#")[0])  # the time of the film may stand behind it
    again.wait_for_selector("[data-ready]")
    again.keyboard.press("h")
    assert again.evaluate("hophoopLab.clock.time") == 0  # the choice is kept
    again.close()  # a page behind another one is slow to answer
    # the wheel zooms a picture that was clicked, until Escape
    box = page.locator(".timeline-canvas").bounding_box()
    page.mouse.click(box["x"] + 200, box["y"] + 25)
    page.mouse.wheel(0, -300)
    wait_for(page, "lab.timeline.window !== null")
    page.keyboard.press("0")
    wait_for(page, "lab.timeline.window === null")
    assert page.evaluate("document.activeElement.className") == "timeline"
    page.keyboard.press("Escape")
    page.mouse.wheel(0, 300)
    page.wait_for_function("() => scrollY > 100")
    assert page.evaluate("hophoopLab.timeline.window") is None


@pytest.mark.long
def test_a_map_does_not_leave_what_is_allowed_and_scrolls_on_until_it_is_clicked(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 4")
    before = page.evaluate("scrollY")
    box = page.locator(".map-body").bounding_box()
    page.mouse.move(box["x"] + 300, box["y"] + 100)
    page.mouse.wheel(0, -200)
    page.wait_for_function(f"() => scrollY < {before}")
    assert page.evaluate("hophoopLab.map.axes.windows.x") == [0, 5]
    for _ in range(6):
        page.get_by_role("button", name="Zoom out of the map").click()
    low, high = page.evaluate("hophoopLab.map.axes.windows.y")
    assert low == 0
    assert 1.5 < high <= 1e6
    wait_for(page, "lab.map.level === 4 && !lab.map.computing")


@pytest.mark.parametrize("size", [(390, 844), pytest.param((844, 390), marks=pytest.mark.long)])
def test_on_a_phone_the_player_stays_and_fingers_find_their_targets(visit, size):
    page = visit(viewport={"width": size[0], "height": size[1]}, has_touch=True, is_mobile=True, device_scale_factor=1)
    wait_for(page, SETTLED)
    assert page.evaluate("document.documentElement.scrollWidth") == size[0]
    assert page.locator(".transport .play").bounding_box()["y"] + 44 <= size[1] or size[0] < size[1]
    small = page.evaluate(
        """() => [...document.querySelectorAll("button, select, summary, input:not([type=checkbox])")]
          .filter((element) => element.checkVisibility())
          .filter((element) => {
            const { width, height } = element.getBoundingClientRect();
            return width && Math.min(width, height) < 43.5;
          })
          .map((element) => element.outerHTML.slice(0, 100))"""
    )
    assert small == []
    fields = "[...document.querySelectorAll('input, select')].every((e) => parseFloat(getComputedStyle(e).fontSize) >= 16)"
    assert page.evaluate(fields)
    page.evaluate("scrollTo(0, 900)")
    page.wait_for_function("() => document.querySelector('.player').classList.contains('stuck')")
    page.wait_for_timeout(300)
    player = page.locator(".player").bounding_box()
    assert player["y"] == pytest.approx(0, abs=1)
    assert page.locator(".play").bounding_box()["y"] + 44 <= size[1]
    if size[0] < size[1]:
        assert player["height"] < 0.45 * size[1]
    y = page.evaluate("scrollY")
    page.wait_for_timeout(300)
    assert page.evaluate("scrollY") == y  # nothing jumps to and fro


def test_forced_colours_are_the_systems(visit):
    page = visit(forced_colors="active", color_scheme="dark")
    wait_for(page, SETTLED)
    look = page.evaluate("hophoopLab.theme.look")
    assert look["paper"] == "#000000"
    assert look["ink"] == "#ffffff"
    assert look["dark"] is True


def test_a_refused_click_on_the_map_is_said_in_sight(visit):
    page = visit()
    wait_for(page, SETTLED)
    page.evaluate("scrollTo(0, document.querySelector('.map-body').getBoundingClientRect().top - 50)")
    page.evaluate("hophoopLab.map.onmotion([['hoop.load_fraction', 1], ['plane.slope', 0.1]])")
    page.wait_for_selector(".toast:visible")
    toast = page.locator(".toast").bounding_box()
    assert toast["y"] >= 0
    assert toast["y"] + toast["height"] <= 900
    assert "plane.slope" in page.locator(".toast").inner_text()


# how long after its due time a call ends, with which error, and whether the next one is answered
ENDED = """async (why) => {
  const { backend } = hophoopLab;
  const crew = backend.kernel.motions;
  const usual = crew.limit;
  if (why === "too long") crew.limit = 150;
  const giving = new AbortController();
  // the longest motion that the lab takes, far more work than the test waits for
  const asked = backend.film({ query: "contact.model=compliant&duration=600" }, giving.signal);
  let due = performance.now() + 150;
  if (why === "given up") setTimeout(() => { due = performance.now(); giving.abort(); }, 150);
  let said = "";
  try { await asked; } catch (error) { said = `${error.name} ${error.message}`; }
  const took = performance.now() - due;
  crew.limit = usual;
  const { header } = await backend.film({ query: "duration=1" });
  return [took, said, header.status];
}"""


def test_what_the_page_computes_stops_at_once(visit):
    page = visit("?duration=1")
    wait_for(page, SETTLED)
    for why, told in (("given up", "AbortError"), ("too long", "Stopped after 0.15 s")):
        took, said, after = page.evaluate(ENDED, why)
        assert told in said
        assert took < 5000
        assert after == "completed"
