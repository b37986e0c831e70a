"""Where everything is on the page: low and narrow windows, large letters, long words, other directions of writing."""

from lab_page_tools import PHONE, SETTLED, SHOWN, each_of, follow, picture

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


def window(width, height):
    """A window is no wider than it is, and no text covers another."""
    return [
        f"size {width} {height}",
        f"until document.documentElement.clientHeight === {height} && {SETTLED}",
        f"is document.documentElement.scrollWidth === {width}",
        f"do {CROSSING}",
        "is crossing.length === 0",
        f"do {OUTSIDE}",
        "is outside.length === 0 && first('.transport select').offsetWidth >= 55",
    ]


# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "a small window": ("", {"viewport": {"width": 320, "height": 256}}, [*window(320, 256), *window(360, 320)]),
    "a small phone, and one held across, with all of its player": ("", PHONE, [
        f"do {CUT}",
        "is cut <= 0.5",  # the names of languages are whole
        *window(320, 568),
        *window(844, 390),
        "is first('.player').getBoundingClientRect().bottom <= 390",
    ]),
    "what theory says stays in its card": ("", {"locale": "fr"}, [
        "until lab.theory.list.children.length > 4",
        "is all('.theory dd').every((one) =>"
        " one.getBoundingClientRect().right < first('.theory').getBoundingClientRect().right)",
        "is all('.theory dd').every((one) => one.scrollWidth <= one.clientWidth && one.clientWidth > 110)",  # no word a line
    ]),
    "larger letters of the browser are taken over also in pictures": ("", {"script": LARGE}, [
        f"is {SIZES} === '28,24,24,26' && lab.theme.look.px === 2 && document.documentElement.scrollWidth === 1440",
        f"until {SHOWN}",
        "do first('[data-plot=velocities] .plot-body').scrollIntoView({ block: 'center' })",
        "until lab.plots.plots[0].box",
        "click [data-plot=velocities] .plot-body",  # its middle
        "is near(lab.clock.time, (({ offsetWidth }) => 6 * (0.5 * offsetWidth - 104) / (offsetWidth - 124))"
        "(first('[data-plot=velocities] .plot-body')), 0.02)",
    ]),
    "a presentation shows the player alone in proportion": ("#t=0.8", {"viewport": {"width": 1920, "height": 1080}}, [
        f"until {SETTLED}",
        "do globalThis.before = lab.theme.look.px; lab.extras.present.turn(true)",
        "until !lab.surrounding && lab.theme.look.px > 1",
        "is (({ x, y, width, height }) => near(x + y, 0, 1) && near(width, 1920, 1) && near(height, 1080, 1))"
        "(first('.player').getBoundingClientRect())",
        "is !seen('.why, .words, .map, .side, .top') && document.documentElement.scrollHeight <= 1080",
        "is 11 * lab.theme.look.px >= 0.02 * 1080",  # numbers on the axes are as high as a line on a blackboard
        "do lab.extras.present.turn(false)",
        "until lab.theme.look.px === before",
    ]),
    "letters are usual, and pictures are drawn for the width of a sheet": ("#t=0.8", {}, [
        f"until {SHOWN}",
        f"is {SIZES} === '14,12,12,13' && lab.theme.look.px === 1",
        f"do globalThis.before = {DRAWN}; dispatchEvent(new Event('beforeprint')); globalThis.printed = {DRAWN}",  # at once
        "is printed.length > 3 && printed.every(([across, down, width]) =>"
        " near(across / down, 1, 0.02) && near(width, 180 / 25.4 * 96, 1))",
        "do dispatchEvent(new Event('afterprint'))",
        f"until {SETTLED}",
        f"is JSON.stringify({DRAWN}) === JSON.stringify(before)",
        # the mark of the dial covers no number
        "do lab.extras.visit.go(2)",
        "until text('.visit-count').startsWith('Step 3 ')",
        "wait 100",
        f"do {COVERED}",
        "is texts.map(([text]) => text).join() === '0°,90°,180°,270°' && covered.length === 0",
    ]),
}  # fmt: skip


@each_of(FLOWS)
def test_it_is_in_its_place(visit, name):
    link, options, steps = FLOWS[name]
    page = visit(link, **options)
    follow(page, steps)
    picture(page, f"layout-{name.replace(' ', '-')}")
