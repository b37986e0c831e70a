"""Fingers and the wheel: one rule for all pictures of the page."""

from lab_page_tools import PHONE, SHOWN, each_of, take

# what two fingers zoom, and how wide the part is that it shows
ZOOMED = {
    ".stage canvas": "1 / lab.stage.flat.zoom",
    "[data-plot=forces] .plot-body": "(lab.plots.shared.range?.reduce((low, high) => high - low) ?? 6)",
    ".phase .plot-body": "(lab.phase.windows.x[1] - lab.phase.windows.x[0])",
    ".map-body": "(lab.map.axes.windows.x[1] - lab.map.axes.windows.x[0])",
}
# the browser tells which diagrams are in view after a picture of the page or two, and fingers can be there before
NO_DIAGRAM_SEEN = """
window.IntersectionObserver = class extends IntersectionObserver {
  constructor(tell, options) {
    const unseen = (entry) =>
      entry.target.matches(".plot") ? { target: entry.target, isIntersecting: false } : entry;
    super((entries) => tell(entries.map(unseen)), options);
  }
};
"""

PLACES = "all('.plot-body').map((body) => body.getBoundingClientRect().y - first('.plots').getBoundingClientRect().y)"


# name: (link, options, steps), as in test_flows.py
MAP = [
    "do first('.map-body').scrollIntoView({ block: 'center' }); lab.map.zoom(0.5); globalThis.before = String(Object.values("
    "lab.map.axes.windows)); globalThis.query = lab.film().query",
]
MOVED = "String(Object.values(lab.map.axes.windows)) !== before"
FLOWS = {
    "two fingers zoom and take no motion": ("", PHONE, [
        *(step for selector, width in ZOOMED.items() for step in (
            f"do first('{selector}').scrollIntoView({{ block: 'center' }}); globalThis.before = {width}",
            "until !lab.surrounding",
            f"pinch {selector}",
            f"until near({width} / before, 0.25, 0.04)",
        )),
        "wait 300",
        "is lab.motions.history.past.length === 0 && lab.film().query === ''",
    ]),
    "a diagram that is not drawn yet zooms and keeps its place": ("", {**PHONE, "script": NO_DIAGRAM_SEEN}, """
        until !lab.surrounding && [...lab.plots.seen.values()].every((seen) => !seen)
        do first('[data-plot=forces] .plot-body').scrollIntoView({ block: 'center' })
        wait 300
        do globalThis.before = $PLACES
        pinch [data-plot=forces] .plot-body
        is near(lab.plots.shared.range[1] - lab.plots.shared.range[0], 1.5, 0.25)
        do for (const plot of lab.plots.plots) lab.plots.seen.set(plot.element, true); lab.plots.redraw()
        # a line of a legend has 16 pixels
        is $PLACES.every((place, k) => near(place, before[k], 0.5))
    """),
    "the wheel scrolls on unless the stage is chosen": ("", {}, """
        point .stage 0.4 0.4
        wheel 300
        until scrollY > 100
        is lab.stage.flat.zoom === 1
        do scrollTo(0, 0)
        click .stage
        wheel -300
        until lab.stage.flat.zoom > 1.2
        is scrollY === 0
    """),
    "a finger moves the map when it starts across, and leaves it when it starts upwards": ("", PHONE, [
        f"until {SHOWN}",
        *(step for across, down, moves in ((0, -60, "false"), (6, -50, "false"), (60, 4, "true")) for step in (
            *MAP,
            f"touch .map-body: [1, 2, 3, 4, 5, 6].map((k) => [{across} * k / 6, {down} * k / 6])",
            "wait 200",
            f"is {MOVED} === {moves} && lab.film().query === query",
        )),
    ]),
}  # fmt: skip


@each_of(
    FLOWS,
    "a diagram that is not drawn yet zooms and keeps its place",
    "two fingers zoom and take no motion",
    "a finger moves the map when it starts across, and leaves it when it starts upwards",
)
def test_wheel_and_finger(visit, flow):
    take(visit, flow, globals())
