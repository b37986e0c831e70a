"""The (θ, θ̇) plane on the page: it is finer where it is zoomed, and whole again when asked."""

import pytest

pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

from lab_page_tools import wait_for

# An answer that comes when the test says so, also where nobody wants it any more.
HELD = """() => {
  const { phase } = hophoopLab;
  const { backend } = phase;
  phase.backend = {
    regions: async (...asked) => {
      const reply = await backend.regions(...asked);
      await new Promise((resolve) => { globalThis.letGo = resolve; });
      return reply;
    },
  };
}"""
SETTLED = "async () => { letGo(); await new Promise((resolve) => setTimeout(resolve, 50)); }"


@pytest.fixture
def zoomed(visit):
    """A page whose plane is zoomed by the keyboard, and what waits until the finer part is there."""
    page = visit()
    wait_for(page, "lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding")
    page.locator(".phase .plot-body").scroll_into_view_if_needed()
    page.locator(".phase .plot-body").focus()
    return page


def test_it_sharpens_where_it_is_zoomed(zoomed):
    page = zoomed
    page.keyboard.press("+")
    page.keyboard.press("+")
    wait_for(page, "Math.abs((lab.phase.pictures[1]?.window[0] ?? 0) - lab.phase.range[0]) < 1e-9")
    window, shown = page.evaluate("[hophoopLab.phase.pictures[1].window, hophoopLab.phase.range]")
    assert window[:2] == pytest.approx(shown)
    page.keyboard.press("0")
    wait_for(page, "lab.phase.pictures.length === 1")


@pytest.mark.long
def test_a_part_that_comes_after_the_whole_was_asked_for_is_not_shown(zoomed):
    page = zoomed
    page.evaluate(HELD)
    page.keyboard.press("+")
    wait_for(page, "globalThis.letGo")
    page.keyboard.press("0")
    page.evaluate(SETTLED)
    assert page.evaluate("hophoopLab.phase.pictures.length") == 1


@pytest.mark.long
def test_a_part_of_an_earlier_zoom_does_not_take_the_place_of_a_later_one(zoomed):
    page = zoomed
    page.evaluate(HELD)
    page.keyboard.press("+")
    wait_for(page, "globalThis.letGo")
    page.evaluate("() => { globalThis.earlier = letGo; letGo = null; }")
    page.keyboard.press("+")
    # theory that is told once more asks for it again
    wait_for(page, "(globalThis.letGo?.(), lab.phase.pictures.length === 2)")
    later = page.evaluate("hophoopLab.phase.pictures[1].window")
    page.evaluate("() => { letGo = earlier; }")
    page.evaluate(SETTLED)
    assert page.evaluate("hophoopLab.phase.pictures[1].window") == later


def test_zooming_out_to_the_whole_leaves_no_part(zoomed):
    page = zoomed
    page.keyboard.press("+")
    wait_for(page, "lab.phase.pictures.length === 2")
    for _ in range(9):
        page.keyboard.press("-")
    reach = page.evaluate("hophoopLab.phase.reach()")
    assert page.evaluate("[hophoopLab.phase.window, hophoopLab.phase.pictures.length]") == [[-reach, reach], 1]


def hatched(page, turning):
    """Share of the columns of (0, π) that are hatched below (0) or above (1) θ̇ = 0."""
    return page.evaluate(
        """(turning) => {
          const { paradox } = hophoopLab.phase.pictures[0];
          const columns = paradox.length / 2;
          const half = paradox.slice(turning * columns, turning * columns + columns / 2);
          return half.filter((side) => side !== 0).length / half.length;
        }""",
        turning,
    )


@pytest.mark.parametrize(("couple", "below", "above"), [(0.0, 0.085, 0.085), (0.1, 0.0, 0.186)])
def test_the_paradox_is_hatched_with_the_couple_of_rolling_resistance(visit, couple, below, above):
    page = visit(f"?hoop.load_fraction=0.75&plane.mu=0.9&plane.rolling_resistance={couple}")
    wait_for(page, "lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding")
    assert hatched(page, 0) == pytest.approx(below, abs=0.01)
    assert hatched(page, 1) == pytest.approx(above, abs=0.01)
    assert page.evaluate("!hophoopLab.phase.hatched.hidden")


def test_nothing_is_said_to_be_hatched_where_nothing_is(visit):
    page = visit("?plane.mu=0.2")
    wait_for(page, "lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding")
    assert hatched(page, 0) == hatched(page, 1) == 0.0
    assert page.evaluate("hophoopLab.phase.hatched.hidden")
