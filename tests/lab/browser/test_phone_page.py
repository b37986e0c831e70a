"""The page on a phone, in every language: its head in two rows, and nothing over the numbers of the picture."""

import pytest

from lab_page_tools import SETTLED, SHOWN, picture, wait_for

FINGERS = {"has_touch": True, "is_mobile": True, "device_scale_factor": 1}
# the one with the longest words every time, and the others in CI
LOCALES = ["es-ES", *(pytest.param(one, marks=pytest.mark.long) for one in ["en-GB", "de-DE", "fr-FR", "zh-CN"])]

# the tops of what is seen in the head
ROWS = """() => new Set([...document.querySelectorAll(".top :is(button, select, summary)")]
  .filter((one) => one.checkVisibility())
  .map((one) => one.getBoundingClientRect())
  .map(({ top, height }) => Math.round(top + height / 2))).size"""

# at which times the hint covers numbers or the legend, or leaves the picture
COVERED = """() => {
  const { clock } = hophoopLab;
  const find = (name) => document.querySelector(name);
  const [hint, readout, legend, stage] = [".grip-hint", ".readout", ".legend", ".stage"].map(find);
  const found = [];
  clock.play(false);
  for (let k = 0; k <= 240; k++) {
    clock.time = (k / 240) * clock.duration;
    hophoopLab.frame(performance.now());
    const a = hint.getBoundingClientRect();
    for (const other of [readout, legend]) {
      const b = other.getBoundingClientRect();
      if (other.checkVisibility() && a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
        found.push([clock.time, other.className]);
    }
    const all = stage.getBoundingClientRect();
    if (a.left < all.left || a.right > all.right || a.top < all.top || a.bottom > all.bottom) found.push([clock.time, "out"]);
  }
  return found;
}"""


@pytest.mark.parametrize("width", [360, pytest.param(390, marks=pytest.mark.long)])
@pytest.mark.parametrize("simple", [True, False])
@pytest.mark.parametrize("locale", LOCALES)
def test_the_head_takes_two_rows(visit, locale, simple, width):
    page = visit(simple=simple, locale=locale, viewport={"width": width, "height": 844}, **FINGERS)
    wait_for(page, SETTLED)
    assert page.evaluate(ROWS) <= 2
    assert page.evaluate("document.documentElement.scrollWidth") == width
    # each can be hit, and none is cut
    small = page.evaluate(
        """() => [...document.querySelectorAll(".top :is(button, select, summary)")]
          .filter((one) => one.checkVisibility())
          .filter((one) => {
            const { width, height } = one.getBoundingClientRect();
            return width < 34 || height < 36 || (one.tagName !== "SELECT" && one.scrollWidth > one.clientWidth + 1);
          })
          .map((one) => one.outerHTML.slice(0, 90))"""
    )
    assert small == []
    picture(page, f"phone-head-{locale[:2]}-{'simple' if simple else 'all'}-{width}")


@pytest.mark.parametrize("size", [(390, 844), (320, 568), (1440, 900)])
@pytest.mark.parametrize("locale", LOCALES)
def test_the_hint_of_the_load_covers_no_numbers(visit, locale, size):
    options = FINGERS if size[0] < 1000 else {}
    page = visit(simple=True, locale=locale, viewport={"width": size[0], "height": size[1]}, **options)
    wait_for(page, f"{SHOWN} && !document.querySelector('.grip-hint').hidden")
    picture(page, f"hint-{locale[:2]}-{size[0]}")
    assert page.evaluate(COVERED) == []
