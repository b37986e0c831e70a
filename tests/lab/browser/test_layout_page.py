"""Where everything is on the page: low and narrow windows, large letters, long words, other directions of writing, paper."""

import io

import numpy as np
import pytest

from lab_page_tools import PHONE, SETTLED, SHOWN, each_of, picture, take, wait_for

# pairs of texts on the picture that lie over one another, and those that leave it
CROSSING = """
  const stage = document.querySelector(".stage").getBoundingClientRect();
  const view = lab.stage.flat.views[0];
  const [, foot] = view.point(view.pose.x, 0);
  const { px } = lab.theme.look;
  const texts = all(".readout, .legend, .stage-keys").filter((one) => one.checkVisibility());
  const boxes = texts.map((one) => ({ name: one.className, ...one.getBoundingClientRect().toJSON() }));
  // the numbers on the plane
  const [top, bottom] = [8, 20].map((below) => stage.top + foot + below * px);
  boxes.push({ name: "axis", left: stage.left, right: stage.right, top, bottom });
  globalThis.crossing = boxes.filter(({ left, right, bottom }) =>
    left < stage.left || right > stage.right || bottom > stage.bottom);
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(0, i))
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
        crossing.push(`${a.name} over ${b.name}`)"""
# controls of the player that are not inside of it, or cannot be read
OUTSIDE = """
  const player = first(".player").getBoundingClientRect();
  globalThis.outside = all(".transport button, .transport select")
    .filter((one) => one.checkVisibility())
    .filter((one) => one.getBoundingClientRect().right > player.right || one.scrollWidth > one.clientWidth + 1)
    .map((one) => one.outerHTML.slice(0, 90))"""
# how much wider the menu would be with room
CUT = """
  const menu = first(".language");
  const free = menu.cloneNode(true);
  free.style.cssText = "position: absolute; max-width: none; width: auto";
  menu.after(free);
  globalThis.cut = free.getBoundingClientRect().width - menu.getBoundingClientRect().width;
  free.remove()"""
LARGE = "addEventListener('DOMContentLoaded', () => { document.documentElement.style.fontSize = '200%'; })"
SIZES = """['.hophoop', '.readout', '.hint', '.control label']
    .map((one) => parseFloat(getComputedStyle(first(one)).fontSize)).join()"""
# the canvases that are seen: device pixels to a pixel of the page across and down, and how wide the page is
DRAWN = """all("canvas").filter((one) => one.checkVisibility()).map((one) => {
    const { width, height } = one.getBoundingClientRect();
    return [one.width / width, one.height / height, first(".hophoop").clientWidth];
  })"""
# which numbers of the dial its mark covers
COVERED = """
  const { prototype } = CanvasRenderingContext2D;
  const { fillText } = prototype;
  globalThis.texts = [];
  prototype.fillText = function (text, x, y) {
    if (this.canvas.className === "dial-canvas") texts.push([text, x, y, this.measureText(text).width]);
    fillText.call(this, text, x, y);
  };
  lab.extras.visit.guess.redraw();
  prototype.fillText = fillText;
  // the ring's radius less that of the mark
  globalThis.covered = texts.filter(([, x, y, width]) => Math.hypot(Math.abs(x - 84) + width / 2, y - 4 - 84) >= 58 - 12)"""

# which numbers on the plane lie under the words on the picture
UNDER = """
  const { prototype } = CanvasRenderingContext2D;
  const { fillText } = prototype;
  globalThis.numbers = [];
  prototype.fillText = function (text, x, y) {
    const { width } = this.measureText(text);
    if (/^[−\\d.]+ m$/.test(text)) numbers.push({ text, left: x - width / 2, right: x + width / 2, top: y - 9, bottom: y });
    fillText.call(this, text, x, y);
  };
  lab.drawStage();
  prototype.fillText = fillText;
  const stage = first(".stage").getBoundingClientRect();
  globalThis.under = all(".readout, .legend, .stage-keys").filter(shown).flatMap((one) => {
    const { left, right, top, bottom } = one.getBoundingClientRect();
    return numbers.filter((box) => box.left + stage.left < right && left < box.right + stage.left
      && box.top + stage.top < bottom && top < box.bottom + stage.top).map(({ text }) => `${text} under ${one.className}`);
  })"""
# what Tab reaches, in its order, by the column in which it is, and whether each is below or to the right of the one before
ORDER = """
  const single = getComputedStyle(first(".columns")).display === "flex";
  const places = all("a[href], button, input, select, summary, [tabindex='0']")
    .filter((one) => shown(one) && !one.disabled && !one.closest("dialog, .skip, .grips, .stage, .menu-body, .story-list"))
    .map((one) => ({ one, box: one.getBoundingClientRect(), part: one.closest(".top, .side, .middle, .why") }));
  globalThis.reached = places.length;
  globalThis.astray = places.filter(({ box, part }, k) => {
    const before = places[k - 1];
    if (!before || (before.part !== part && !single)) return false;
    const below = box.top >= before.box.bottom - 4;
    const right = box.left >= before.box.right - 4 && box.bottom > before.box.top;
    return !below && !right && !before.one.contains(places[k].one);
  }).map(({ one }) => one.outerHTML.slice(0, 90))"""
# the table is below the player, with all of its head
BELOW = """(([player, table, head]) => table.top >= player.bottom && head.bottom <= innerHeight)(
    [".player", ".table:not(.more)", ".table:not(.more) thead"].map((one) => first(one).getBoundingClientRect()))"""


def opened_table(simple):
    return ("#t=0.8", {"simple": simple, "viewport": {"width": 1280, "height": 800}}, """
        until $SHOWN
        click .learn summary
        button Table of the motion
        until $BELOW
        wait 300
        is $BELOW
    """)  # fmt: skip


def in_order(simple, **options):
    return ("#t=0.8", {"simple": simple, **options}, [
        f"until {SHOWN}",
        f"do {ORDER}",
        "is reached > 15 && astray.length === 0",
        *(["is all('.controls .slider').filter(shown)[0].dataset.path === 'start.speed'"] if simple else []),
    ])  # fmt: skip


def window(width, height):
    """A window is no wider than it is, and no text covers another."""
    return [
        f"size {width} {height}",
        f"until document.documentElement.clientHeight === {height} && {SETTLED}",
        # the picture is drawn for its new size in the next frame
        "do await new Promise(requestAnimationFrame); await new Promise(requestAnimationFrame)",
        f"is document.documentElement.scrollWidth === {width}",
        f"do {CROSSING}",
        "is crossing.length === 0",
        f"do {OUTSIDE}",
        "is outside.length === 0 && first('.transport select').offsetWidth >= 55",
    ]


# what paper has none of
PRESSED = "button, [type=range], [type=checkbox], .top, .transport, .grips, .map"
PARTS = [".readout dd", ".legend", ".timeline", ".summary", ".controls .exact", ".plot"]


def on_paper(simple, parts, curves):
    """The motion and what happens, and nothing to press; the worksheet alone, with its speeds."""
    return ("#t=0.8", {"simple": simple, "color_scheme": "dark"}, [
        f"until {SHOWN}",
        "do lab.extras.table.open(true)",
        "until seen('.stuck')",  # the player is small now
        "media print",
        "do dispatchEvent(new Event('beforeprint'))",
        f"is all('{PRESSED}').every((one) => !one.checkVisibility() || one.closest('.story-list'))",
        f"is {PARTS}.map((part) => all(part).filter((one) => one.checkVisibility()).length).join() === '{parts}'",
        "is first('.story-list').scrollHeight === first('.story-list').clientHeight",
        # the canvas of the cursor would hide the curves
        "do globalThis.drawn = all('.plot-canvas').filter((one) => one.checkVisibility()).map((one) =>"
        " one.getContext('2d').getImageData(0, 0, one.width, one.height).data.some(Boolean))",
        f"is drawn.length === {curves} && drawn.every(Boolean)",
        "do lab.extras.teach.showModal()",
        "is !seen('.page')",
        "is all('.sheet-table button').filter(shown).map((one) => one.innerText).join() === '1.0,1.3,1.6,1.9,2.2,2.3'",
        "is first('.teach').scrollHeight === first('.teach').clientHeight",
        "sheets 2",  # answers are on the teacher's
        "do dispatchEvent(new Event('beforeprint'))",
        "do lab.extras.teach.close()",
        "is lab.theme.look.paper === '#ffffff'",  # ink on paper, also of a dark page
        "do dispatchEvent(new Event('afterprint'))",
        "media screen",
        "is lab.root.dataset.theme === 'dark'",
    ])  # fmt: skip


# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "paper": on_paper(False, "6,1,1,1,11,5", 6),
    "paper of the simple view": on_paper(True, "6,1,1,1,3,1", 1),
    "a small window": ("", {"viewport": {"width": 320, "height": 256}}, [*window(320, 256), *window(360, 320)]),
    "a small phone, and one held across, with all of its player": ("", PHONE, [
        f"do {CUT}",
        "is cut <= 0.5",  # the names of languages are whole
        *window(320, 568),
        *window(844, 390),
        "is first('.player').getBoundingClientRect().bottom <= 390",
    ]),
    "the table opens below the player": opened_table(False),
    "the table opens below the player of the simple view": opened_table(True),
    "the order of Tab is the order seen": in_order(False, viewport={"width": 1280, "height": 800}),
    "the order of Tab in the simple view": in_order(True, viewport={"width": 1280, "height": 800}),
    "the order of Tab on a phone": in_order(False, **PHONE),
    "the order of Tab on a phone in the simple view": in_order(True, **PHONE),
    "the order of Tab follows the window and the view": ("#t=0.8", {"viewport": {"width": 1280, "height": 800}}, [
        f"until {SHOWN}",
        *(step for size, button in (("390 844", "Simple view"), ("1280 800", "Everything")) for step in (
            f"size {size}",
            f"until innerWidth === {size.split()[0]} && {SETTLED}",
            f"do {ORDER}",
            "is astray.length === 0",
            "do lab.view.choose()",
            f"until {SETTLED}",
            f"do {ORDER}",
            "is astray.length === 0",
        )),
    ]),
    "numbers on a slope are covered by no words": ("#t=0.8", {"viewport": {"width": 1280, "height": 800}}, [
        f"until {SHOWN}",
        *(step for slope in (0.17, -0.17, 0.35, -0.35, 0.7, -0.7) for step in (
            f"do return lab.load('plane.slope={slope}')",
            f"until lab.film().slope === {slope} && {SETTLED}",
            *(step for time in (0, 0.8, 3) for step in (f"do lab.clock.seek({time})", f"until {SETTLED}",
                f"do {UNDER}", "is numbers.length > 0 && under.length === 0")),
        )),
    ]),
    "a time in the list stays in one line": ("?start.speed=3.53", {"viewport": {"width": 1280, "height": 800}}, """
        until $SHOWN
        is all('.when').some((one) => /^0[.]0[0-9]{4} s$/.test(one.innerText))
        is all('.when').every((one) => one.offsetHeight < 24 && one.scrollWidth <= one.clientWidth)
    """),
    "at 200 % the read-out stays, and what is below the player can be read": (
        "#t=0.8", {"simple": True, "viewport": {"width": 640, "height": 400}}, """
        until $SHOWN
        is all('.readout dd').filter(shown).length === 6
        do scrollTo(0, 300)
        until first('.player').matches('.stuck')
        until $SETTLED
        is all('.readout dd').filter(shown).length === 2
        is first('.player').getBoundingClientRect().height < 0.6 * innerHeight
    """),
    "what theory says stays in its card": ("", {"locale": "fr"}, """
        until lab.theory.list.children.length > 4
        is all('.theory dd').every((one) => one.getBoundingClientRect().right <
            first('.theory').getBoundingClientRect().right)
        # no word a line
        is all('.theory dd').every((one) => one.scrollWidth <= one.clientWidth && one.clientWidth > 110)
    """),
    "larger letters of the browser are taken over also in pictures": ("", {"script": LARGE}, """
        is $SIZES === '28,24,24,26' && lab.theme.look.px === 2 && document.documentElement.scrollWidth === 1440
        until $SHOWN
        do first('[data-plot=velocities] .plot-body').scrollIntoView({ block: 'center' })
        until lab.plots.plots[0].box
        # its middle
        click [data-plot=velocities] .plot-body
        is near(lab.clock.time, (({ offsetWidth }) => 6 * (0.5 * offsetWidth - 104) / (offsetWidth -
            124))(first('[data-plot=velocities] .plot-body')), 0.02)
    """),
    "a presentation shows the player alone in proportion": ("#t=0.8", {"viewport": {"width": 1920, "height": 1080}}, """
        until $SETTLED
        do globalThis.before = lab.theme.look.px; lab.extras.present.turn(true)
        until !lab.surrounding && lab.theme.look.px > 1
        is (({ x, y, width, height }) => near(x + y, 0, 1) && near(width, 1920, 1) && near(height, 1080,
            1))(first('.player').getBoundingClientRect())
        is first('.legend').getBoundingClientRect().right < first('.leave').getBoundingClientRect().left
        is all('.readout dd').filter(shown).length === 6
        is !seen('.why, .words, .map, .side, .top') && document.documentElement.scrollHeight <= 1080
        # numbers on the axes are as high as a line on a blackboard
        is 11 * lab.theme.look.px >= 0.02 * 1080
        do lab.extras.present.turn(false)
        until lab.theme.look.px === before
    """),
    "letters are usual, and pictures are drawn for the width of a sheet": ("#t=0.8", {}, """
        until $SHOWN
        is $SIZES === '14,12,12,13' && lab.theme.look.px === 1
        # at once
        do globalThis.before = $DRAWN; dispatchEvent(new Event('beforeprint')); globalThis.printed = $DRAWN
        is printed.length > 3 && printed.every(([across, down, width]) => near(across / down, 1, 0.02) && near(width, 180 /
            25.4 * 96, 1))
        do dispatchEvent(new Event('afterprint'))
        until $SETTLED
        is JSON.stringify($DRAWN) === JSON.stringify(before)
        # the mark of the dial covers no number
        do lab.extras.visit.go(3)
        until text('.visit-count').startsWith('Step 4 ')
        wait 100
        do $COVERED
        is texts.map(([text]) => text).join() === '0°,90°,180°,270°' && covered.length === 0
    """),
}  # fmt: skip


@each_of(
    FLOWS,
    "paper of the simple view",
    "larger letters of the browser are taken over also in pictures",
    "a presentation shows the player alone in proportion",
    "letters are usual, and pictures are drawn for the width of a sheet",
    "the order of Tab follows the window and the view",
    "the order of Tab on a phone",
    "the table opens below the player of the simple view",
    "the order of Tab in the simple view",
    "the order of Tab on a phone in the simple view",
    "numbers on a slope are covered by no words",
)
def test_it_is_in_its_place(visit, flow, request):
    picture(take(visit, flow, globals()), request.node.name)


def shot(page, selector):
    """An element as it is seen, in grey."""
    image = pytest.importorskip("PIL.Image")
    return np.asarray(image.open(io.BytesIO(page.locator(selector).first.screenshot())).convert("L"), float)


@pytest.mark.parametrize("size", [pytest.param((1280, 800), marks=pytest.mark.long), (390, 844)])
def test_the_list_of_events_cuts_no_letters(visit, size):
    page = visit("#t=0", simple=size[0] < 1000, viewport={"width": size[0], "height": size[1]})
    wait_for(page, SHOWN)
    for time in (0, 0.8, 2.5, 6):
        page.evaluate(f"hophoopLab.clock.seek({time})")
        wait_for(page, SETTLED)
        seen = shot(page, ".story-list")
        assert np.ptp(seen[0]) < 10, time
        assert np.ptp(seen[-1]) < 10, time
        now = page.locator(".story-list [aria-current]").bounding_box()
        around = page.locator(".story-list").bounding_box()
        assert around["y"] <= now["y"], time
        assert now["y"] + now["height"] <= around["y"] + around["height"], time


def test_a_hint_is_read_in_forced_colours(visit):
    page = visit(simple=True, forced_colors="active", reduced_motion="reduce")
    page.wait_for_selector(".grip-hint")
    seen = shot(page, ".grip-hint")
    assert np.ptp(seen[8:-8, 24:-24]) > 100  # letters on their ground
