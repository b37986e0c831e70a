"""What visitors do with the page, step by step: a table, one line for each thing that is done, awaited or seen.

The verbs are those of `lab_page_tools.Steps`; behind `until` and `is` stands JavaScript that knows `lab` and its `WORDS`.
"""

from lab_page_tools import PHONE, each_of, take
from slow_page import also_delayed

ERROR = ".control .error"
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
# An answer that comes when the test says so, also where nobody wants it any more.
REGIONS_HELD = (
    "do const { phase } = lab; const { backend } = phase; phase.backend = { regions: async (...asked) => {"
    " const reply = await backend.regions(...asked);"
    " await new Promise((resolve) => { globalThis.letGo = resolve; }); return reply; } }; return null"
)
LET_GO = "do letGo(); return new Promise((resolve) => setTimeout(resolve, 50))"
NO_STORAGE = "Object.defineProperty(globalThis, 'localStorage', { get() { throw new Error('forbidden'); } });"
# Share of the columns of (0, π) that are hatched, for θ̇ below or above zero
BELOW, ABOVE = (
    f"((all, n) => all.slice({side} * n, {side} * n + n / 2).filter(Boolean).length / (n / 2))"
    "(lab.phase.pictures[0].paradox, 360)"
    for side in (0, 1)
)
CALM = {"reduced_motion": "reduce"}
SIMPLE = "lab.root.classList.contains('simple')"

# name: (link, options, steps as `lab_page_tools.steps_of` reads them)
FLOWS = {
    "a sentence stays until its field changes": ("", {}, """
        until $SHOWN
        type Mass, exact value in kg = -1
        until text('$ERROR') === 'Mass = −1 kg must be from 1·10⁻¹² to 1·10¹² kg.'
        # as after another size of the window
        do lab.show()
        # an answer that comes later
        fill start.speed 2.5
        until lab.film().values['start.speed'] === 2.5 && $SETTLED
        is seen('$ERROR') && value('Mass, exact value in kg') === '-1'
        press Escape in Mass, exact value in kg
        is !seen('$ERROR') && value('Mass, exact value in kg') === '1'
        type Mass, exact value in kg = -1
        until seen('$ERROR')
        do document.querySelector("input[data-path='hoop.mass']").dispatchEvent(new Event('input'))
        # whatever the slider says holds
        until !seen('$ERROR')
        type Mass, exact value in kg = -1
        until seen('$ERROR')
        # another motion, and its fields
        do lab.travel(-1)
        until !seen('$ERROR') && value('Mass, exact value in kg') === '1'
        # that of a rule goes with the next motion
        do return lab.load('plane.mu_static=0.5&plane.mu_kinetic=0.4')
        until !lab.surrounding
        type Kinetic friction, exact value = 0.6
        until seen('$ERROR')
        do lab.show()
        is seen('$ERROR') && value('Kinetic friction, exact value') === '0.6'
        fill plane.mu_static 0.7
        until !seen('$ERROR') && value('Kinetic friction, exact value') === '0.4'
        # an entry is read as people type, and refused in its own unit
        do return lab.load('')
        until $SHOWN
        type Slope, exact value in ° = abc
        until text('$ERROR').includes('must be a number')
        type Slope, exact value in ° = 100
        until text('$ERROR').includes('from −89.95 to 89.95°')
        is document.querySelector('[aria-invalid=true]').getAttribute('aria-describedby') === first('$ERROR').id
        press Escape in Slope, exact value in °
        is value('Slope, exact value in °') === '0' && !document.querySelector('[aria-invalid]')
        type Slope, exact value in ° = 3,1
        until Math.abs(lab.film().scenario.plane.slope - 3.1 * Math.PI / 180) < 1e-12
        type Friction, exact value = inf
        until lab.film().scenario.plane.mu === 'inf' && value('Friction, exact value') === '∞'
    """),
    "a slider loses no key, and an answer does not take it from the hand": ("?start.speed=3.1", {}, """
        until lab.film()
        do first("input[data-path='start.speed']").focus()
        # as fast as keys can come
        do const now = performance.now(); performance.now = () => now
        20 × press ArrowLeft
        until lab.film().values['start.speed'] === 2.9 && lab.motions.history.past.length === 1 && $SETTLED
        do delete performance.now
        do const slider = first("input[data-path='start.speed']"); slider.dispatchEvent(new Event('pointerdown'));
            slider.value = '1.5'; lab.show()
        is first("input[data-path='start.speed']").value === '1.5'
        do first("input[data-path='start.speed']").dispatchEvent(new Event('pointerup')); lab.show()
        is first("input[data-path='start.speed']").value === '2.9'
    """),
    "two hoops are told apart": ("?start.speed=2", {}, """
        button Compare two hoops
        until lab.films().length === 2
        fill start.speed 3.1
        until lab.motions.history.past.length === 2 && lab.film().values['start.speed'] === 3.1 && $SETTLED
        until text('.story h2') === 'What happens to hoop B' && text('.theory h2') === 'Theory for hoop B'
        until text('[data-plot=velocities] .value') === '3.1' && all('.story-list li').length > 10
        button Hoop A
        until text('.story h2') === 'What happens to hoop A' && text('[data-plot=velocities] .value') === '2'
        until all('.story-list li').length === 1
        # all curves of the one that is chosen, and the total of the other
        until first('[data-plot=energies] .plot-body').ariaLabel.includes('B: total from')
        is !first('[data-plot=energies] .plot-body').ariaLabel.includes('B: kinetic')
        # the hop of B is marked and found while A is chosen
        press h
        is lab.clock.time === lab.film(1).events.find(({ kind }) => kind === 'takeoff').t
    """),
    "single keys can be switched off, and Escape leaves": ("", {}, r"""
        until $SETTLED
        press Tab
        is document.activeElement.textContent === 'Skip to the player'
        press Enter
        is document.activeElement.className === 'timeline'
        click .share summary
        press Escape
        click .learn summary
        press Escape
        is !document.querySelector('details:is(.menu, .learn)[open]')
        press ?
        is all('dialog[open] tr').some((row) => row.innerText.startsWith('S\tspin\tslip: the rim turns too fast'))
        is all('dialog[open] tr').some((row) => row.innerText.startsWith('K\tskid\tslip: the rim slides ahead'))
        click dialog[open] .check input
        press Escape
        press h
        press f
        is lab.clock.time === 0 && lab.stage.options.forces
        do first('.stage').focus()
        press Space
        until lab.clock.playing
        press Space
        reload
        until $SHOWN
        do lab.clock.seek(0)
        press h
        # the choice is kept
        is lab.clock.time === 0
    """),
    "a refused click on the map is said in sight": ("", {}, """
        until $SETTLED
        do scrollTo(0, first('.map-body').getBoundingClientRect().top - 50)
        do lab.motions.change([['hoop.load_fraction', 1], ['plane.slope', 0.1]], true)
        until seen('.toast') && text('.toast').includes('plane.slope')
        is (({ top, bottom }) => top >= 0 && bottom <= innerHeight)(first('.toast').getBoundingClientRect())
    """),
    "all that stands there has a name, is high enough and leaves numbers alone in right-to-left writing": ("", {}, """
        until $SHOWN
        is all('[role=img][tabindex]').length === 0
        # the hoop, five diagrams, the plane of angle and rate
        is all('[role=figure]').length === 7 && all('[role=figure]').every((one) => one.tabIndex === 0 && one.ariaLabel)
        is all('.slider, .quiet').filter(shown).length > 8
        # WCAG 2.5.8
        is all('.slider, .quiet').filter(shown).every((one) => one.getBoundingClientRect().height >= 24)
        do document.documentElement.dir = 'rtl'
        is getComputedStyle(first('.legend')).direction === 'ltr' && document.documentElement.scrollWidth === 1440
        is (([a, , b]) => a.getBoundingClientRect().x < b.getBoundingClientRect().x)(all('.legend span'))
        do document.documentElement.dir = ''
        is all('button, input, select, summary, [role=slider], [role=figure]').every((one) => one.ariaLabel ||
            one.textContent.trim() || one.labels?.length || one.title)
        press h
        # said with the next picture
        until first('.timeline').getAttribute('aria-valuetext') === '1.045 seconds, flight'
        is first('[data-plot=forces] .plot-body').ariaLabel.includes('from')
        is first('.stage').ariaLabel.includes('hops at 315.6°')
        fill start.speed 2
        until document.querySelector('.spoken').textContent === 'Rolls.'
    """),
    "forced colours are the system's": ("", {"forced_colors": "active", "color_scheme": "dark"}, """
        until $SETTLED
        is (({ paper, ink, dark }) => paper === '#000000' && ink === '#ffffff' && dark)(lab.theme.look)
    """),
    "nothing repeats by itself for those who want no motion": ("", CALM, """
        is lab.clock.loop === false
        do lab.clock.run({ to: 1.25 })
        is !lab.clock.playing && lab.clock.time === 1.25
        # asked for, it plays, once
        press Space
        until lab.clock.playing
        do lab.clock.time = lab.clock.duration - 0.05
        until !lab.clock.playing && lab.clock.time === lab.clock.duration
    """),
    "a page whose first motion is stopped shows the reference motion": (
        "?contact.model=compliant&duration=300", {"ready": False, "script": HOLD % "true"}, """
        until seen('.computing') && text('.computing').startsWith('Computing …') && !seen('.controls')
        until lab.computing.bar.value > 0.01 && lab.computing.bar.value < lab.computing.bar.max
        do held = false
        button Stop
        until !seen('.computing') && seen('.controls') && lab.film().query === ''
        until text('.message') === '$STOPPED' && location.search === '?contact.model=compliant&duration=300'
    """),
    "stop keeps the motion before and forgets what waits": ("?duration=2", {"script": HOLD % "false"}, """
        until $SETTLED
        is !seen('.computing')
        do held = true; for (const mu of [0.5, 0.4]) lab.motions.change([['plane.mu', mu]], true)
        until seen('.computing')
        do held = false
        button Stop
        until !seen('.computing') && $SETTLED
        is lab.film().query === 'duration=2' && lab.motions.history.past.length === 0
        is text('.side').includes('$STOPPED')
        do lab.motions.change([['plane.mu', 0.3]], true)
        until lab.film().values['plane.mu'] === 0.3 && lab.film().duration === 2
    """),
    "the plane of angle and rate is finer where it is zoomed, and whole again": ("", {}, """
        until lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding
        do document.querySelector('.phase .plot-body').focus()
        press +
        press +
        until lab.phase.pictures[1] && Math.abs(lab.phase.pictures[1].window[0] - lab.phase.windows.x[0]) < 1e-9
        press 0
        until lab.phase.pictures.length === 1
        press +
        until lab.phase.pictures.length === 2
        9 × press -
        is lab.phase.windows.y[1] === lab.phase.reach && lab.phase.pictures.length === 1
        # a part that comes after the whole was asked for is not shown
        $REGIONS_HELD
        press +
        until globalThis.letGo
        press 0
        $LET_GO
        is lab.phase.pictures.length === 1
        # a part of an earlier zoom does not take the place of a later one
        do letGo = null
        press +
        until globalThis.letGo
        do globalThis.earlier = letGo; letGo = null
        press +
        until (globalThis.letGo?.(), lab.phase.pictures.length === 2)
        do globalThis.later = String(lab.phase.pictures[1].window); letGo = earlier
        $LET_GO
        is String(lab.phase.pictures[1].window) === later
    """),
    "a first visit is offered once": ("", {}, """
        button Not now
        is !seen('.visit')
        # without what the page has written into its address
        open
        until lab.root.dataset.ready
        is !seen('.visit')
    """),
    "a presentation is left where there is no full screen": (
        "#t=0.8", {"script": "delete Element.prototype.requestFullscreen", **PHONE}, """
        until $SETTLED
        click .learn summary
        button Presentation
        until lab.root.classList.contains('presenting') && !seen('.side')
        is Math.min(first('.leave').offsetWidth, first('.leave').offsetHeight) >= 44
        press Escape
        until !lab.root.classList.contains('presenting') && $SETTLED
        do lab.extras.present.turn(true)
        click .leave
        until !lab.root.classList.contains('presenting') && seen('.top')
    """),
    "what is seen first runs once, and any touch ends it": ("", {"simple": True}, """
        until lab.clock.playing && lab.clock.time > 0.1 && text('.grip-hint') === 'Drag the load'
        is lab.extras.sound.on === false
        # once, then it is back at the start, and the address holds no time
        do lab.clock.time = lab.clock.duration - 0.05
        until !lab.clock.playing && lab.clock.time === 0
        wait 700
        is location.hash === '' && seen('.grip-hint')
        click .timeline-canvas
        is !seen('.grip-hint') && Math.abs(lab.clock.time - 3) < 0.02
        # from now on it plays as it is asked to
        press Space
        do lab.clock.time = lab.clock.duration - 0.05
        until lab.clock.playing && lab.clock.time < 1
    """),
    "a key is a touch too": ("", {"simple": True}, """
        until seen('.grip-hint')
        press ArrowRight
        until !seen('.grip-hint')
    """),
    "everything is remembered, and there is a way back": ("#t=0.5", {"simple": True}, """
        is $SIMPLE
        button Everything
        until !$SIMPLE && $SHOWN
        is all('.controls .slider').filter(shown).length > 8 && all('.plot').filter(shown).length === 5
        reload
        is !$SIMPLE
        button Simple view
        reload
        is $SIMPLE
    """),
    "without storage the address holds the view": ("#t=0.5", {"simple": True, "script": NO_STORAGE}, """
        button Everything
        until !$SIMPLE && $SHOWN && location.hash.includes('view=everything')
        reload
        is !$SIMPLE
    """),
    "the title names the motion, unless it is to be guessed": ("?start.speed=2", {}, """
        until document.title === 'Rolls – hophoop'
        choose .presets jam
        until document.title === 'Dynamic jam – hophoop'
        choose .language de
        until document.title.endsWith(' – hophoop') && !document.title.includes('Dynamic')
        choose .language en
        do lab.extras.visit.go(0)
        until document.title === 'hophoop lab: play with the hopping hoop'
    """),
    "another motion has no answer, and what has no end says so": ("?start.speed=2", {}, """
        button And in the end?
        until text('.ending span').length > 20
        do lab.motions.change([['plane.mu', 0.5]], true)
        until text('.ending span') === ''
        do lab.motions.change([['plane.gravity', 0]], true)
        until lab.film().scenario.plane.gravity === 0 && $SETTLED
        button And in the end?
        until text('.ending span') === 'What becomes of it in the end is known for rigid contact with gravity.'
    """),
    "a class sees the player alone, repeats it and slows it down": ("", {}, """
        button Presentation in full screen
        until lab.root.classList.contains('presenting') && !seen('.side') && first('.stage').offsetHeight > 500
        button Repeat
        is lab.clock.loop === false
        button Slow motion: a tenth of the speed
        is lab.clock.speed === 0.1
        button Presentation in full screen
        until seen('.side')
        # with all of its buttons, which this view has not
        button Simple view
        is !seen('.tools')
        click .learn summary
        button Presentation
        until lab.root.classList.contains('presenting') && all('.tools button').every(shown)
        button Sound of the contact
        is lab.extras.sound.on
        click .leave
        button Everything
        do lab.extras.visit.start()
        until seen('.visit-count') && $SETTLED
        click .learn summary
        button For teachers
        # nothing hops before all have voted
        click .teach[open] tbody button
        until lab.film().radius === 0.4 && !seen('.teach, .visit') && seen('.transport')
        is !lab.film().sequence.includes('H')
        click .learn summary
        button For teachers
        click .teach[open] .sheet-table tr:nth-child(4) button
        until lab.film().values['start.speed'] === 1.9 && lab.film().radius === 0.4 && !seen('.teach')
    """),
    "the simple view has three sliders, one diagram and one row of buttons": ("#t=0.5", {"simple": True}, """
        # nothing moves where a link names a time
        is !lab.clock.playing && lab.clock.time === 0.5
        until $SETTLED
        is all('.controls .slider').filter(shown).sort((a, b) => a.getBoundingClientRect().y -
            b.getBoundingClientRect().y).map((one) => one.dataset.path).join() === 'start.speed,hoop.load_fraction,plane.mu'
        is all('.plot').filter(shown).length === 1
        is !seen('.map, .phase, .theory')
        is new Set(all('.transport button').filter(shown).map((one) => Math.round(one.getBoundingClientRect().y))).size === 1
        fill plane.mu 0.5
        until lab.film().scenario.plane.mu === 0.5 && $SETTLED
        is !seen('.beyond')
        # a motion with other settings says so
        do lab.motions.change([['plane.slope', 0.05]], true)
        until seen('.beyond') && $SIMPLE
        button Show everything
        is !$SIMPLE && seen("[data-path='plane.slope']")
    """),
    "keys turn, lift, push and tilt the hoop": ("?start.speed=0", CALM, """
        until $SETTLED
        do first('.grip-load').focus()
        3 × press ArrowRight
        until lab.motions.history.past.length === 1 && Math.abs(lab.film().scenario.start.angle - Math.PI / 12) < 1e-4
        is first('.grip-load').getAttribute('aria-valuetext') === '15.0°'
        do first('.grip-hoop').focus()
        2 × press ArrowRight
        until lab.motions.history.past.length === 2 && Math.abs(lab.film().scenario.start.speed - 0.2) < 1e-9
        press ArrowUp
        until lab.film().scenario.start.height === 0.05
        do first('.grip-plane').focus()
        press ArrowRight
        until Math.abs(lab.film().scenario.plane.slope - Math.PI / 180) < 1e-4
        press Enter
        # who wants no motion plays by hand
        is lab.clock.playing === false
    """),
    "the browser chooses the language and the visitor another one": ("?start.speed=2.8", {"locale": "de-AT"}, """
        until $SHOWN
        is document.documentElement.lang === 'de' && text('.summary').startsWith('Rollt, rutscht ab 65,5°')
        until text('.theory').includes('würde über 2,043 m/s gleiten') && text('.readout .mode') === 'Rollen'
        choose .language fr
        until document.documentElement.lang === 'fr' && text('.summary').startsWith('Roule, dérape à partir de 65,5°')
        until text('.theory').includes('glisserait au-delà de 2,043 m/s')
        is first('.play').ariaLabel === 'Lecture (espace)'
        reload
        # the choice is kept
        is document.documentElement.lang === 'fr'
        choose .language en
        until document.documentElement.lang === 'en' && text('.summary').startsWith('Rolls, skids at 65.5°')
    """),
    "a picture in space keeps its sharpness where it is still": ("", {}, """
        press 3
        press h
        until lab.stage.options.three && !lab.requested
        # a machine that draws in software may lose it while the film runs
        do lab.stage.deep.share = 0.5
        press Space
        until lab.stage.space.width < 0.9 * lab.stage.space.clientWidth
        press Space
        until lab.stage.space.width === lab.stage.space.clientWidth
    """),
    "the paradox is hatched with the couple of rolling resistance, and nothing where nothing is": (
        "?hoop.load_fraction=0.75&plane.mu=0.9&plane.rolling_resistance=0.1", {}, """
        until lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding
        do document.querySelector('.phase .plot-body').focus()
        is $BELOW === 0 && near($ABOVE, 0.186, 0.01) && !lab.phase.hatched.hidden
        do lab.phase.pictures = null; return lab.load('plane.mu=0.2')
        until lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding
        is lab.phase.hatched.hidden && lab.phase.pictures[0].paradox.every((side) => side === 0)
    """),
}  # fmt: skip


@also_delayed
@each_of(
    FLOWS,
    "a sentence stays until its field changes",
    "what is seen first runs once, and any touch ends it",
    "stop keeps the motion before and forgets what waits",
    "a page whose first motion is stopped shows the reference motion",
    "a presentation is left where there is no full screen",
    "nothing repeats by itself for those who want no motion",
    "all that stands there has a name, is high enough and leaves numbers alone in right-to-left writing",
    "a picture in space keeps its sharpness where it is still",
    "another motion has no answer, and what has no end says so",
    "without storage the address holds the view",
    "single keys can be switched off, and Escape leaves",
    "everything is remembered, and there is a way back",
    "keys turn, lift, push and tilt the hoop",
    "a class sees the player alone, repeats it and slows it down",
    "the plane of angle and rate is finer where it is zoomed, and whole again",
)
def test_a_visitor(visit, flow):
    take(visit, flow, globals())
