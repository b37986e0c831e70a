"""What a visitor sees first: one run of the motion, the simple view, names and links of what is shown."""

from hophoop._version import __version__
from lab_page_tools import PHONE, SETTLED, each_of, take

VERSION = __version__
CALM = {"reduced_motion": "reduce"}
SIMPLE = "lab.root.classList.contains('simple')"
PAINTED = """['.stage-canvas:not([hidden])', '.timeline-canvas', '.phase .plot-over', '[data-plot=velocities] .plot-over']
    .map((one) => all(one).map((canvas) => canvas.toDataURL()).join())"""
LINE = "all('.story-list button').find((one) => one.textContent.includes('It hops at'))"
# whether the colour of the flight's trace is in the picture
FLIGHT = """(({ data }) => data.some((red, k) =>
    k % 4 === 0 && red > 200 && data[k + 1] < 150 && data[k + 2] < 190 && data[k + 3]))
    (first('.stage-canvas').getContext('2d').getImageData(0, 0, 2000, 2000))"""
SMALL = """all('button, select, summary, input').filter((one) => one.checkVisibility())
    .filter((one) => Math.min(one.getBoundingClientRect().width, one.getBoundingClientRect().height) < 43.5)"""
IN_WINDOW = """(({ left, right, top, bottom }) => left >= 0 && right <= 390 && top >= 0 && bottom <= 844)"""


def opened(link, simple):
    """The view in which it was copied; it was the link's wish, not the visitor's."""
    return (link, {"simple": True, **CALM}, [
        f"until {SETTLED}",
        f"is {SIMPLE} === {simple} && localStorage.getItem('hophoop-view') === null",
    ])  # fmt: skip


def phone_in(language):
    """Hoop, play and three sliders without scrolling, and menus on the screen."""
    shown = [".stage", ".transport .play"]
    shown += [f"input[data-path='{path}']" for path in ("start.speed", "hoop.load_fraction", "plane.mu")]
    return [
        f"choose .language {language}",
        f"until document.documentElement.lang === '{language}' && {SETTLED}",
        "is document.documentElement.scrollWidth === 390",
        f"is {SMALL}.length === 0",
        *(f'is {IN_WINDOW}(first("{one}").getBoundingClientRect())' for one in shown),
        *(
            step
            for menu in (".share", ".learn")
            for step in (
                f"click {menu} summary",
                f"is {IN_WINDOW}(first('{menu} .menu-body').getBoundingClientRect())",
                f"click {menu} summary",
            )
        ),
    ]


# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "a link without a view is simple": opened(
        "?plane.slope=0.1#with=start.speed%3D2&zoom=2&show=tf3&fingerprint=0123456789abcdef&map=sequence,start.speed,1,2,plane.mu,0.5,1",
        "true",
    ),
    "a link to everything opens everything": opened("#view=everything", "false"),
    "a phone shows the hoop and its sliders": ("", {"simple": True, **CALM, **PHONE}, [
        step for language in ("en", "de", "fr", "es") for step in phone_in(language)
    ]),
    "about has version, licence and documentation": ("#t=0.5", {"simple": True}, """
        click .learn summary
        button About hophoop
        is ['$VERSION', 'MIT', 'hophoop --help'].every((one) => text('.about[open]').includes(one))
        # this page was told no address
        is !text('.about[open]').includes('Documentation')
        do globalThis.licences = await (await fetch(first('.about a').href)).text()
        is licences.includes('MIT licence')
        click .about .close
        is !seen('.about')
    """),
    "words point to their place in picture, bar and diagrams": ("", {"viewport": {"width": 1440, "height": 1800}}, """
        until lab.phase.pictures?.length === 1 && $SHOWN
        do globalThis.before = $PAINTED; $LINE.id = 'hop'
        point #hop 0.5 0.5
        until lab.clock.pointed === event('takeoff').t && $SETTLED
        is $PAINTED.every((one, k) => one !== before[k]) && lab.clock.time === 0
        point .top 0.5 0.1
        until lab.clock.pointed === null && $SETTLED
        is $PAINTED.every((one, k) => one === before[k])
        do first('#hop').focus()
        until lab.clock.pointed === event('takeoff').t && $SETTLED
        is $PAINTED.every((one, k) => one !== before[k]) && lab.clock.time === 0
        do document.activeElement.blur()
        until lab.clock.pointed === null && $SETTLED
        is $PAINTED.every((one, k) => one === before[k])
        # beside the picture, an arrow leads to what lies outside of it
        do all('.story-list button').at(-1).focus()
        until lab.clock.pointed > 5 && $SETTLED
        is $PAINTED[0] !== before[0]
        # the motion is the same: the list keeps the focus
        do lab.show()
        until $SETTLED
        is document.activeElement === all('.story-list button').at(-1)
    """),
    "the whole path holds what is still to come": ("?duration=2#t=0.3&show=t", {}, """
        do return lab.toggle('whole')
        until lab.stage.options.whole && !lab.requested
        # it has not flown yet
        is $FLIGHT
    """),
    "the load is dragged in the simple view": ("#t=0.001", {"simple": True, **CALM}, """
        until $SETTLED
        do lab.clock.seek(0)
        until $SETTLED
        # R = 1 m
        do globalThis.radius = lab.stage.flat.views[0].scale
        drag .grip-load: [[0, 5], [radius, radius]]
        wait 200
        drop
        until lab.motions.history.past.length === 1 && $SETTLED
        is near(lab.film().scenario.start.angle, Math.PI / 2, 0.05)
        is $SIMPLE && all('.controls .slider').filter(shown).length === 3
    """),
}  # fmt: skip


@each_of(FLOWS, "words point to their place in picture, bar and diagrams", "about has version, licence and documentation")
def test_a_first_look(visit, flow):
    take(visit, flow, globals())
