"""The page on a phone, in every language: its head in two rows, and nothing over the numbers of the picture."""

import pytest

from lab_page_tools import SETTLED, SHOWN, follow, picture

FINGERS = {"has_touch": True, "is_mobile": True, "device_scale_factor": 1}
# the one with the longest words every time, and the others in CI
LOCALES = ["es-ES", *(pytest.param(one, marks=pytest.mark.long) for one in ["en-GB", "de-DE", "fr-FR", "zh-CN"])]

# the middles of what is seen in the head
HEAD = "all('.top :is(button, select, summary)').filter((one) => one.checkVisibility())"
ROWS = (
    f"new Set({HEAD}.map((one) => one.getBoundingClientRect()).map(({{ top, height }}) => Math.round(top + height / 2))).size"
)
# what is too small to be hit, or cut
SMALL = f"""{HEAD}.filter((one) => one.offsetWidth < 34 || one.offsetHeight < 36
    || (one.tagName !== "SELECT" && one.scrollWidth > one.clientWidth + 1))"""
# how often the hint covers numbers or the legend, or leaves the picture
COVERED = """
  const [hint, readout, legend, stage] = [".grip-hint", ".readout", ".legend", ".stage"].map((one) => first(one));
  globalThis.covered = [];
  lab.clock.play(false);
  for (let k = 0; k <= 240; k++) {
    lab.clock.time = (k / 240) * lab.clock.duration;
    lab.frame(performance.now());
    const a = hint.getBoundingClientRect();
    for (const other of [readout, legend].filter((one) => one.checkVisibility())) {
      const b = other.getBoundingClientRect();
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) covered.push(other.className);
    }
    const all = stage.getBoundingClientRect();
    if (a.left < all.left || a.right > all.right || a.top < all.top || a.bottom > all.bottom) covered.push("out");
  }"""


@pytest.mark.parametrize("width", [360, pytest.param(390, marks=pytest.mark.long)])
@pytest.mark.parametrize("simple", [True, False])
@pytest.mark.parametrize("locale", LOCALES)
def test_the_head_takes_two_rows(visit, locale, simple, width):
    page = visit(simple=simple, locale=locale, viewport={"width": width, "height": 844}, **FINGERS)
    narrow = f"document.documentElement.scrollWidth === {width}"
    follow(page, [f"until {SETTLED}", f"is {ROWS} <= 2 && {SMALL}.length === 0 && {narrow}"])
    picture(page, f"phone-head-{locale[:2]}-{'simple' if simple else 'all'}-{width}")


@pytest.mark.parametrize("size", [(390, 844), (320, 568), (1440, 900)])
@pytest.mark.parametrize("locale", LOCALES)
def test_the_hint_of_the_load_covers_no_numbers(visit, locale, size):
    options = FINGERS if size[0] < 1000 else {}
    page = visit(simple=True, locale=locale, viewport={"width": size[0], "height": size[1]}, **options)
    follow(page, [f"until {SHOWN} && seen('.grip-hint')", f"do {COVERED}", "is covered.length === 0"])
    picture(page, f"hint-{locale[:2]}-{size[0]}")
