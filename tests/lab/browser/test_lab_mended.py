"""The page in use: what one types, presses and goes back from, on screens large and small, with a screen reader."""

import pytest

from lab_page_tools import SETTLED, wait_for


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


def test_a_server_that_is_gone_is_named(visit):
    page = visit("?start.speed=2")
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


@pytest.mark.long
def test_a_map_scrolls_on_until_it_is_clicked(visit):
    page = visit()
    page.locator(".map-body").scroll_into_view_if_needed()
    wait_for(page, "lab.map.level === 4")
    before = page.evaluate("scrollY")
    box = page.locator(".map-body").bounding_box()
    page.mouse.move(box["x"] + 300, box["y"] + 100)
    page.mouse.wheel(0, -200)
    page.wait_for_function(f"() => scrollY < {before}")
    assert page.evaluate("hophoopLab.map.axes.windows.x") == [0, 5]


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


@pytest.mark.parametrize(("query", "times"), [("duration=20", 1), ("duration=120", 2)])
def test_a_compliant_motion_is_computed_again_only_where_it_has_many_events(visit, query, times):
    page = visit("?duration=1")
    count = page.evaluate(
        """async (query) => {
          const { mechanics, kernel } = hophoopLab.backend;
          let called = 0;
          const call = mechanics.call.bind(mechanics);
          mechanics.call = (name, ...values) => {
            called += Number(name === "compliant_motion");
            return call(name, ...values);
          };
          kernel.ask = async (name, values) => mechanics[name](...values);
          await hophoopLab.backend.film({ query });
          return called;
        }""",
        f"contact.model=compliant&{query}",
    )
    assert count == times
