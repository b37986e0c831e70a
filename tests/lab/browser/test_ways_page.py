"""Steps back and forth, links and the address of the page: a table as in test_flows.py."""

from lab_page_tools import SETTLED, SHOWN, each_of, take
from slow_page import also_delayed

UNTIL_SETTLED, UNTIL_SHOWN = f"until {SETTLED}", f"until {SHOWN}"
ERROR = ".control .error"
HAND = "button Reset: back to the motion that was opened or chosen last"
# A busy browser goes to another entry of its history a while after it was asked to.
SLOW_WAYS = "const go = history.go.bind(history); history.go = (way) => setTimeout(go, 700, way);"
# link, its rest in order, what is said
WRONG = [
    ("plane.mu=-1&start.speed=2", "start.speed=2", "plane.mu = -1"),
    ("plane.my=0.5&start.speed=2", "start.speed=2", "plane.my is not a known key"),
    (
        "plane.mu=0.5&plane.mu_static=0.6&plane.mu_kinetic=0.4&duration=3",
        "duration=3&plane.mu_kinetic=0.4&plane.mu_static=0.6",
        "mu_static",
    ),
    ("start.vx=1&start.speed=2&hoop.load_fraction=0.5", "hoop.load_fraction=0.5&start.speed=2", "start.speed"),
    ("contact.model=compliant&contact.low=1&plane.mu=0.3", "contact.model=compliant&plane.mu=0.3", "contact.low"),
]
CLIPBOARD = {"permissions": ["clipboard-read", "clipboard-write"]}
CALM = {"reduced_motion": "reduce"}
OTHER_BITS = (
    "until text('.fingerprint .differs').startsWith("
    "`The bits differ: ${lab.film().fingerprint} here, 0123456789abcdef where the link was made`)"
)


def copied(button):
    return ["click .share summary", f"button {button}", "until text('.toast') === 'Link copied.'"]


# name: (link, options, steps); the browser's own history is at `lab.address.number` only a while after a step
FLOWS = {
    "a slider makes it hop and undo takes it back": ("?start.speed=2", {}, """
        until !lab.surrounding && text('.summary') === 'Rolls.'
        fill start.speed 3.1
        until lab.film().sequence.includes('H') && lab.motions.history.past.length === 1
        # the reference case
        until text('.summary').includes('hops') && location.search === ''
        press z
        until lab.film().sequence === 'R' && location.search === '?start.speed=2' && lab.address.number === 0
        press y
        until lab.film().sequence.includes('H') && lab.address.number === 1
        press z
        until lab.film().query === 'start.speed=2' && lab.motions.history.past.length === 0 && lab.address.number === 0
        until $SHOWN
        do lab.motions.change([['plane.mu', 0.5]], true)
        until lab.film().values['plane.mu'] === 0.5 && lab.motions.history.past.length === 1
        do lab.motions.change([['hoop.mass', 2]], true)
        until lab.film().mass === 2 && lab.motions.history.past.length === 2
        press z
        until lab.film().mass === 1 && lab.motions.history.future.length === 1 && lab.address.number === 1
        reload
        until $SHOWN
        is !lab.header.undo.disabled
        press y
        until lab.film().mass === 2 && lab.motions.history.future.length === 0 && lab.address.number === 2
        press z
        until lab.film().mass === 1 && lab.motions.history.past.length === 1 && lab.address.number === 1
        press z
        until lab.film().query === 'start.speed=2' && lab.motions.history.past.length === 0
        # another link in the same tab has no such steps
        open ?start.speed=4
        until $SHOWN
        is lab.header.undo.disabled
    """),
    "a browser that is late to follow an undo keeps every step": ("?start.speed=2", {"script": SLOW_WAYS}, """
        until $SHOWN
        fill start.speed 3.1
        until lab.film().sequence.includes('H') && location.search === ''
        press z
        until lab.film().sequence === 'R'
        # written into the entry that is to come, not into the one that is left
        do lab.clock.seek(0.5)
        until location.search === '?start.speed=2' && location.hash.startsWith('#t=0.5') && lab.address.number === 0
        press y
        until lab.film().sequence.includes('H') && location.search === '' && lab.address.number === 1
        is lab.motions.history.past.length === 1 && lab.motions.history.future.length === 0
        back
        until lab.film().sequence === 'R' && location.search === '?start.speed=2' && lab.address.number === 0
        # there is no step before
        press z
        press y
        until lab.film().sequence.includes('H') && lab.address.number === 1
    """),
    "what is said of a preset goes when it is changed and comes back with undo": ("", {}, """
        choose .presets slip
        until lab.film().query.includes('2.8') && text('.preset-text').includes('Friction is used up twice')
        do first('.presets').focus()
        choose .presets hop
        until lab.film().query === 'duration=3'
        # plays what has just been chosen
        press Space
        until lab.clock.playing
        press Space
        fill start.speed 2.5
        until lab.film().values['start.speed'] === 2.5 && $SETTLED
        is text('.preset-text') === '' && first('.presets').value === ''
        press Control+z
        until lab.film().query === 'duration=3' && text('.preset-text').includes('leaves the plane') && lab.address.number ===
            2
        is first('.presets').value === 'hop'
        press Control+Shift+z
        until lab.film().values['start.speed'] === 2.5
    """),
    "reset goes back to what was opened or chosen": ("?start.speed=2", CALM, """
        until $SETTLED
        is lab.header.reset.disabled
        fill plane.mu 0.5
        until lab.film().scenario.plane.mu === 0.5 && $SETTLED
        $HAND
        until lab.film().query === 'start.speed=2' && lab.header.reset.disabled
        choose .presets moon
        until lab.film().scenario.plane.gravity < 2 && lab.header.reset.disabled
        fill plane.mu 0.5
        until lab.film().scenario.plane.mu === 0.5 && $SETTLED
        $HAND
        until lab.film().scenario.plane.mu === 1 && lab.film().scenario.plane.gravity < 2
    """),
    "a motion that cannot be had is said, and no step is lost": ("?start.speed=2", {}, """
        do lab.backend.film = async () => { throw new Error('It does not answer.'); }
        fill start.speed 3.1
        until text('$ERROR').includes('does not answer')
        do delete lab.backend.film
        fill start.speed 3
        until lab.film().values['start.speed'] === 3 && $SETTLED
        do lab.backend.film = async () => { throw new Error('It does not answer.'); }
        press z
        wait 300
        is lab.motions.history.past.length === 1
        do delete lab.backend.film
        press z
        until lab.film().values['start.speed'] === 2
    """),
    "a link keeps the arrows": ("?start.speed=2.9", {}, """
        until $SHOWN
        do lab.extras.more.turn(true, 'hoop.load_fraction')
        until lab.extras.more.changes && location.href.includes('more=hoop.load_fraction')
        reload
        until lab.extras.more.changes && first('.more select').value === 'hoop.load_fraction'
    """),
    "a preset has the bits of Python while it is unchanged": ("?duration=3", {}, """
        until document.querySelector('.fingerprint .same')
        is !seen('.fingerprint')
        fill start.speed 2.9
        until !document.querySelector('.fingerprint .same')
        do first('.group:last-child').open = true
        choose .presets moon
        until text('.fingerprint .same') === '✓ Same bits as in Python' && !seen('.fingerprint .differs')
        # where they differ both are named
        do lab.sameness.python.set(lab.film().query, '0123456789abcdef'); lab.show()
        until text('.fingerprint .differs') === `The bits differ: ${lab.film().fingerprint} here, 0123456789abcdef in Python.`
        is !seen('.fingerprint .same')
    """),
    "a link with other bits says so, also after a reload": ("?start.speed=2.9#fingerprint=0123456789ABCDEF", CLIPBOARD, [
        OTHER_BITS,
        "until location.hash.includes('fingerprint=0123456789abcdef')",
        "reload",
        OTHER_BITS,
        *copied("Copy a link to this motion"),  # by default it has none
        "do globalThis.kept = await navigator.clipboard.readText()",
        "is kept.includes('start.speed=2.9') && !kept.includes('fingerprint')",
        "goto '?start.speed=2.9#fingerprint=0123456789abcdeg'",  # which is none
        "until document.querySelector('.fingerprint code')",
        "is !document.querySelector('.fingerprint :is(.same, .differs)')",
        "until !location.hash.includes('fingerprint')",
    ]),
    "a fingerprint is copied, alone and in a link": ("?start.speed=2.9", CLIPBOARD, [
        "until document.querySelector('.fingerprint code')",
        *copied("Copy a link with its fingerprint"),
        "is !location.href.includes('fingerprint')",  # it is of here, and says nothing until it is elsewhere
        "goto navigator.clipboard.readText()",
        "until text('.fingerprint .same') === '✓ Same bits as where the link was made'",
        "fill start.speed 2.8",
        "until !document.querySelector('.fingerprint .same') && !location.hash.includes('fingerprint')",
        "button Compare two hoops",  # each has its own
        "fill plane.mu 0.5",
        f"until lab.films().length === 2 && lab.film().values['plane.mu'] === 0.5 && {SETTLED}",
        *copied("Copy a link with its fingerprint"),
        "do sessionStorage.found = lab.films().map((film) => film.fingerprint).join()",
        "goto (await navigator.clipboard.readText()).replace(sessionStorage.found.split(',')[1], '0123456789abcdef')",
        "until document.querySelector('.fingerprint .same') && lab.films().length === 2",
        "do lab.motions.choose(1)",
        "until text('.fingerprint .differs').includes(lab.film(1).fingerprint)",
        "do first('.group:last-child').open = true",
        "click .fingerprint button",
        "until text('.fingerprint button') === 'Copied'",
        "do globalThis.kept = await navigator.clipboard.readText()",
        "is kept === lab.film().fingerprint && kept.length === 16",
        "do Object.defineProperty(navigator, 'clipboard', { value: undefined })",  # where nothing can be copied it is selected
        "click .fingerprint button",
        "until getSelection().toString() === lab.film().fingerprint",
    ]),
    "what others add to a link is ignored and said": ("?fbclid=IwAR2x.y&gclid=1&start.speed=2&plane.mu=0.5", {}, """
        until $SHOWN
        is lab.film().query === 'plane.mu=0.5&start.speed=2' && !seen('.message')
        is text('.toast') === 'Ignored in the link: fbclid, gclid.'
        # both links of a comparison are read so
        goto '?start.speed=2&fbclid=1#with=start.speed%3D4%26plane.mu%3D-3'
        until $SHOWN
        is lab.motions.queries().join() === 'start.speed=2,start.speed=4' && text('.message').includes('plane.mu = -3')
    """),
    "a wrong part of a link leaves the rest and the address": ("?plane.mu=x&hoop.mass=2&fbclid=1&duration=2000000", {}, [
        UNTIL_SHOWN,
        "is lab.film().query === 'hoop.mass=2' && text('.message').includes('plane.mu')",
        "is text('.message').includes('The rest of the link is shown.')",
        "do lab.clock.seek(0.5)",  # what the lab writes by itself while one looks at it
        "wait 600",
        "is location.search === '?plane.mu=x&hoop.mass=2&fbclid=1&duration=2000000'",
        "do lab.motions.change([['plane.restitution', 0.25]], true)",  # a step of its own, from which a way leads back
        "until location.search.includes('plane.restitution=0.25')",
        "back",
        "until lab.film().query === 'hoop.mass=2' && location.search === '?plane.mu=x&hoop.mass=2&fbclid=1&duration=2000000'",
        *(f"is (({{ query, error }}) => query.split('&').sort().join('&') === '{rest}' && error.message.includes('{said}'))"
          f"(lab.backend.readable('{link}'))" for link, rest, said in WRONG),
    ]),
    "a motion that doubles do not decide says so": ("?start.speed=3.616628264005025", {}, """
        until text('.story').includes('Run it with `--digits 30` for the exact answer.')
        do lab.motions.change([['start.speed', 3.1]], true)
        until lab.film().values['start.speed'] === 3.1 && !lab.surrounding
        is !seen('.story .hint')
    """),
    **{
        f"a link that is copied in the {view} view opens it": ("?plane.slope=0.1", {"simple": simple, **CLIPBOARD, **CALM}, [
            "is !lab.clock.playing && lab.clock.time === 0",  # for those who want no motion
            UNTIL_SETTLED,
            *copied("Copy a link to this motion"),
            "do localStorage.clear()",
            "goto navigator.clipboard.readText()",
            UNTIL_SETTLED,
            # what the simple view does not show is said
            f"is lab.root.classList.contains('simple') === {str(simple).lower()} && seen('.beyond') === {str(simple).lower()}",
        ])
        for view, simple in (("simple", True), ("whole", False))
    },
}  # fmt: skip


@also_delayed
@each_of(
    FLOWS,
    "a motion that cannot be had is said, and no step is lost",
    "a link that is copied in the whole view opens it",
    "what is said of a preset goes when it is changed and comes back with undo",
    "a fingerprint is copied, alone and in a link",
    "a browser that is late to follow an undo keeps every step",
    "a link that is copied in the simple view opens it",
    "a link with other bits says so, also after a reload",
    "reset goes back to what was opened or chosen",
    "a link keeps the arrows",
    "a wrong part of a link leaves the rest and the address",
)
def test_a_way(visit, flow):
    take(visit, flow, globals())
