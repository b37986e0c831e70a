"""The page on a phone, in every language: its head in two rows, and nothing over the numbers of the picture."""

import pytest

from lab_page_tools import SHOWN, follow, picture

FINGERS = {"has_touch": True, "is_mobile": True, "device_scale_factor": 1}
LANGUAGES = ("en", "de", "es", "fr", "zh")

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
  for (let k = 0; k <= 24; k++) {
    lab.clock.time = (k / 24) * lab.clock.duration;
    lab.frame(performance.now());
    const a = hint.getBoundingClientRect();
    for (const other of [readout, legend].filter((one) => one.checkVisibility())) {
      const b = other.getBoundingClientRect();
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) covered.push(other.className);
    }
    const all = stage.getBoundingClientRect();
    if (a.left < all.left || a.right > all.right || a.top < all.top || a.bottom > all.bottom) covered.push("out");
  }"""


def speaking(language):
    return [f"choose .language {language}", f"until document.documentElement.lang === '{language}' && {SHOWN}"]


@pytest.mark.parametrize("simple", [True, pytest.param(False, marks=pytest.mark.long)])
def test_the_head_takes_two_rows(visit, simple):
    page = visit(simple=simple, reduced_motion="reduce", viewport={"width": 390, "height": 844}, **FINGERS)
    for width in (390, 360):
        for language in LANGUAGES:
            narrow = f"document.documentElement.scrollWidth === {width}"
            rows = f"is {ROWS} <= 2 && {SMALL}.length === 0 && {narrow}"
            follow(page, [f"size {width} 844", *speaking(language), rows])
    picture(page, f"phone-head-{'simple' if simple else 'all'}")


@pytest.mark.parametrize("sizes", [[(390, 844), (320, 568)], [(1440, 900)]])
def test_the_hint_of_the_load_covers_no_numbers(visit, sizes):
    options = FINGERS if len(sizes) > 1 else {}
    page = visit(simple=True, viewport=dict(zip(("width", "height"), sizes[0], strict=True)), **options)
    follow(page, ["until seen('.grip-hint')", "do lab.clock.play(false)"])
    for width, height in sizes:
        for language in LANGUAGES:
            follow(page, [f"size {width} {height}", *speaking(language), f"do {COVERED}", "is covered.length === 0"])
