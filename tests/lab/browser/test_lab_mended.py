"""The page in use: what one types, presses and goes back from, on screens large and small, with a screen reader."""

from lab_page_tools import PHONE, SETTLED, each_of, take

# what is said to a screen reader, and how often it changes
REGIONS = "all('[aria-live], [role=status], [role=alert], output').filter((one) => one.checkVisibility())"
LISTEN = """
  globalThis.said = 0;
  const watch = new MutationObserver((changes) => { globalThis.said += changes.length; });
  for (const region of all("[aria-live], [role=status], [role=alert], output"))
    watch.observe(region, { childList: true, characterData: true, subtree: true });
  watch.observe(first(".timeline"), { attributes: true, attributeFilter: ["aria-valuetext"] })"""
SMALL = """all("button, select, summary, input:not([type=checkbox])").filter((one) => one.checkVisibility())
    .filter((one) => (({ width, height }) => width && Math.min(width, height) < 43.5)(one.getBoundingClientRect()))"""
# how long after its due time a call ends, with which error, and whether the next one is answered
ENDED = """
  const { backend } = lab;
  const pool = backend.kernel.motions;
  const usual = pool.limit;
  if (!given) pool.limit = 150;
  const giving = new AbortController();
  // the longest motion that the lab takes, far more work than the test waits for
  const asked = backend.film({ query: "contact.model=compliant&duration=600" }, giving.signal);
  let due = performance.now() + 150;
  if (given) setTimeout(() => { due = performance.now(); giving.abort(); }, 150);
  try { await asked; } catch (error) { globalThis.said = `${error.name} ${error.message}`; }
  globalThis.took = performance.now() - due;
  pool.limit = usual;
  globalThis.after = (await backend.film({ query: "duration=1" })).header.status"""
COUNTED = """
  const { mechanics, kernel } = lab.backend;
  globalThis.called = 0;
  const call = mechanics.call.bind(mechanics);
  mechanics.call = (name, ...values) => {
    called += Number(name === "compliant_motion");
    return call(name, ...values);
  };
  kernel.ask = async (name, values) => mechanics[name](...values)"""


def on_a_phone(width, height, *more):
    """The player stays, and fingers find their targets."""
    return ("", {**PHONE, "viewport": {"width": width, "height": height}}, [
        f"until {SETTLED}",
        f"is document.documentElement.scrollWidth === {width} && {SMALL}.length === 0",
        "is all('input, select').every((one) => parseFloat(getComputedStyle(one).fontSize) >= 16)",
        *more,
        "do scrollTo(0, 900)",
        "until first('.player').classList.contains('stuck')",
        "wait 300",
        "is near(first('.player').getBoundingClientRect().y, 0, 1)",
        f"is first('.play').getBoundingClientRect().y + 44 <= {height}",
        f"is first('.player').offsetHeight < 0.45 * {height} || {width} > {height}",
        "do globalThis.before = scrollY",
        "wait 300",
        "is scrollY === before",  # nothing jumps to and fro
    ])  # fmt: skip


def speed(value):
    """A change of its own, not one with the change before."""
    return [f"fill start.speed {value}", f"until lab.film().values['start.speed'] === {value} && {SETTLED}", "wait 1100"]


def at(value):
    return f"until lab.film().values['start.speed'] === {value}"


# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "back goes one change at a time": ("?start.speed=2", {}, [
        *speed(2.2), *speed(2.4), "back", at(2.2), "back", at(2),
        "is lab.motions.history.past.length === 0 && lab.motions.history.future.length === 2",
        "forward", at(2.2), "press z", at(2),
        "until location.search === '?start.speed=2'",
    ]),
    "a link holds what is seen": ("?start.speed=2", {}, """
        until $SETTLED
        press f
        do lab.clock.seek(1.25); lab.map.axes.windows = { x: [1, 2], y: [0.5, 1] }
        drag .stage-keys: (({ offsetWidth, offsetHeight }) => [[0, -9], [-0.25 * offsetWidth, 0.1 *
            offsetHeight]])(first('.stage'))
        drop
        is lab.link().includes('&pan=-0.25,0.1')
        do location.href = lab.link()
        size 1000 800
        reload
        until near(lab.stage.flat.pan()[0], -0.25, 2e-3) && near(lab.stage.flat.pan()[1], 0.1, 2e-3)
        is lab.clock.time === 1.25 && !lab.stage.options.forces
        is lab.map.axes.windows.x[0] === 1 && lab.map.axes.windows.y[1] === 1
    """),
    "a screen reader hears little and what matters": ("", {}, """
        until $SETTLED
        is $REGIONS.length <= 4
        do $LISTEN
        press Space
        until lab.clock.time > 1.2
        press Space
        # some changes of mode, no frames
        is said <= 12
        press Home
        press h
        until first('.spoken').textContent === 'take-off at 315.6°, 1.045 s'
        until first('.timeline').getAttribute('aria-valuetext') === '1.045 seconds, flight'
    """),
    "on a phone": on_a_phone(390, 844),
    "on a phone held across": on_a_phone(844, 390, "is first('.transport .play').getBoundingClientRect().y + 44 <= 390"),
    "what is given up or takes too long ends at once": ("?duration=1", {}, """
        until $SETTLED
        do const given = true; $ENDED
        is said.includes('AbortError') && took < 5000 && after === 'completed'
        do const given = false; $ENDED
        is said.includes('Stopped after 0.15 s') && took < 5000 && after === 'completed'
        # a compliant motion is computed again only where it has many events
        do $COUNTED
        do await lab.backend.film({ query: 'contact.model=compliant&duration=20' })
        is called === 1
        do await lab.backend.film({ query: 'contact.model=compliant&duration=120' })
        is called === 3
    """),
}  # fmt: skip


@each_of(
    FLOWS,
    "back goes one change at a time",
    "a link holds what is seen",
    "a screen reader hears little and what matters",
    "on a phone held across",
    "what is given up or takes too long ends at once",
)
def test_in_use(visit, flow):
    take(visit, flow, globals())
