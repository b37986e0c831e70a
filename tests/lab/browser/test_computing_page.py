"""A motion that takes long: the page says that it computes, and Stop keeps what is shown."""

import pytest

uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

from lab_page_tools import SETTLED, expect, wait_for  # noqa: E402

# The workers do not hear what they are asked as long as it is held.
HOLD = """
globalThis.held = %s;
const Plain = Worker;
globalThis.Worker = class extends Plain {
  postMessage(message, ...rest) {
    if (message.call !== "film" || !globalThis.held) super.postMessage(message, ...rest);
  }
};
"""
STOPPED = "Stopped: the motion was not computed."


def test_a_page_whose_first_motion_is_stopped_shows_the_reference_motion(visit):
    page = visit("?contact.model=compliant&duration=300", ready=False, script=HOLD % "true")
    shown = page.locator(".computing")
    expect(shown).to_be_visible()
    assert shown.inner_text().split("\n")[0] == "Computing …"
    assert not page.locator(".controls").is_visible()
    early, late = (page.evaluate(f"hophoopLab.computing.bar.{part}") for part in ("value", "max"))
    assert 0 < early < late
    wait_for(page, f"lab.computing.bar.value > {early}")
    page.evaluate("held = false")
    shown.get_by_role("button", name="Stop").click()
    page.wait_for_selector("[data-ready]")
    expect(shown).to_be_hidden()
    expect(page.locator(".controls")).to_be_visible()
    assert page.evaluate("hophoopLab.film().query") == ""
    expect(page.locator(".message")).to_have_text(STOPPED)
    # the address can be tried again
    assert page.evaluate("location.search") == "?contact.model=compliant&duration=300"


def test_stop_keeps_the_motion_before_and_forgets_what_waits(visit):
    page = visit("?duration=2", script=HOLD % "false")
    wait_for(page, SETTLED)
    shown = page.locator(".computing")
    expect(shown).to_be_hidden()
    page.evaluate("held = true")
    page.evaluate("for (const mu of [0.5, 0.4]) hophoopLab.motions.change([['plane.mu', mu]], true)")
    expect(shown).to_be_visible()
    page.evaluate("held = false")
    shown.get_by_role("button", name="Stop").click()
    expect(shown).to_be_hidden()
    wait_for(page, SETTLED)
    assert page.evaluate("hophoopLab.film().query") == "duration=2"
    assert page.evaluate("hophoopLab.motions.history.past.length") == 0
    assert STOPPED in page.locator(".side").inner_text()
    page.evaluate("hophoopLab.motions.change([['plane.mu', 0.3]], true)")
    wait_for(page, "lab.film().query === 'duration=2&plane.mu=0.3' || lab.film().query === 'plane.mu=0.3&duration=2'")


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
          kernel.film = async (given) => mechanics.film(given);
          await hophoopLab.backend.film({ query });
          return called;
        }""",
        f"contact.model=compliant&{query}",
    )
    assert count == times
