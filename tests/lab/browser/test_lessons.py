"""The visit, the challenges and what a class needs: every answer and score is that of the computed motion."""

from lab_page_tools import SETTLED, each_of, take

CALM = {"reduced_motion": "reduce"}
ANSWERED = ["button Play", "until text('.visit-answer')"]
METER, RESULT, OWN = "first('.challenges meter').value", "text('.challenge-result')", "text('.challenges .hint')"
# Where the speeds of the motion lie on the sheet, from its middle.
SPEEDS = """all('.sketch-point').map((point, k) => {
  const [sheet, here] = [first('.sketch-canvas'), point].map((one) => one.getBoundingClientRect());
  const { angle, vx } = lab.film().columns;
  const speed = vx[angle.findIndex((one) => one >= k * Math.PI / 4)];
  return [here.x + here.width / 2 - sheet.x - sheet.width / 2, 12 + (1 - speed / 10) * (sheet.height - 38) - sheet.height / 2];
})"""
APEXES = "film.events.filter(({ kind }) => kind === 'apex').map(({ height }) => height)"
# the longest number in a file, in digits without zeros at its start
LONGEST = """Math.max(...kept.split(/[,\\r\\n]+/).filter((cell) => /\\d/.test(cell) && !/[[]/.test(cell))
  .map((cell) => cell.replace(/e.*/, '').replace(/\\D/g, '').replace(/^0+/, '').length))"""
ROW = """const film = lab.film();
  globalThis.wrong = [...lab.extras.table.body.rows].filter((row, k) => {
    const { angle, x, vx, omega, normal_force, friction_force, mode } = film.at(k / 2);
    const cells = [...row.cells].map((cell) => cell.textContent.replace('−', '-'));
    const states = [k / 2, angle * 180 / Math.PI, x, vx, omega, normal_force, friction_force];
    return cells.pop() !== { R: 'roll', S: 'spin', K: 'skid', H: 'flight' }[mode]
      || states.some((state, i) => !near(cells[i], state, 2e-3 * (1 + Math.abs(state))));
  })"""
HEARD = """const { heard, knocks } = lab.extras.sound.constructor;
  const film = lab.film();
  globalThis.wrong = [0, 0.2, 0.4, 1.3, 2].filter((time) => {
    const { normal_force, mode } = film.at(time);
    const { tone, hiss } = heard(film, time);
    const force = mode === 'H' ? 0 : normal_force / 9.81;
    return !near(tone, force / (1 + force), 1e-6) || (hiss > 0) !== 'SK'.includes(mode);
  });
  const landings = film.events.filter(({ kind }) => kind === 'impact');
  const falls = landings.map(({ before }) => Math.abs(before.vy) / Math.sqrt(2 * 9.81));
  globalThis.apart = knocks(film, 0, film.duration).map((one, k) => one - falls[k]).filter((one) => !near(one, 0, 1e-9))"""


def step(number):
    """Another step of the visit."""
    return [f"do lab.extras.visit.go({number})", f"until text('.visit-count').startsWith('Step {number + 1} ')"]


def challenge(name, right):
    """A challenge whose solution is shown; it does not count, nor does what is made of it."""
    return ("", {}, [
        "do lab.extras.challenges.open()",
        f"until {METER} === 18",
        f"button {name}",
        f"do globalThis.before = {OWN}",
        "button Show a best solution",
        f"until {METER} === 100 && {SETTLED}",
        f"is {right}",
        f"is {RESULT}.includes('points, shown and not counted.') && {OWN} === before",
        "do globalThis.best = lab.film().query; lab.motions.change([['hoop.mass', 2]], true)",
        f"until lab.film().mass === 2 && {SETTLED}",
        f"is {OWN} === before",
        "button Start again",
        f"until lab.film().mass === 1 && {SETTLED} && !{RESULT}.includes('not counted')",
        "do lab.load(best)",  # neither does the way back make it one
        f"until {METER} === 100 && {RESULT}.includes('points, shown and not counted.')",
        "is Object.keys(localStorage).every((key) => localStorage[key] !== '100')",
    ])  # fmt: skip


# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "nothing tells the answer before the guess": ("", CALM, [
        "button Start the visit",
        f"until seen('.visit-count') && {SETTLED}",
        "is !seen('.timeline, .words, .why, .map, .transport') && first('.visit-body .main').disabled",
        "is first('.stage').ariaLabel === 'The hoop, before it is let go.'",
        "is text('.visit h2') === 'The hop' && lab.film().sequence.includes('H')",  # it begins with what it is about
        *step(5),
        "click .guess-choice input[value=hop]",
        *ANSWERED,
        "is text('.visit-answer').startsWith('Not so.') && text('.visit-answer').includes(degrees(event('skim').angle))",
        "is text('.guess-choice.right').startsWith('The weight falls freely') && seen('.timeline')",
        # a drawn curve is compared with the motion
        *step(2),
        "until first('.sketch-point').style.transform",
        f"drag .sketch-canvas: {SPEEDS}",
        "drop",
        *ANSWERED,
        "is parseInt(text('.visit-answer')) >= 97",
        "is text('.visit-answer').includes(`${digits(Math.max(...lab.film().columns.vx), 2)} m/s`)",
        # a mark on the circle is compared with the take-off
        *step(0),
        "do first('.dial').focus()",
        "press PageDown",
        "is first('.dial').getAttribute('aria-valuetext') === '315°'",
        *ANSWERED,
        "is text('.visit-answer').startsWith('100 of 100 points')",
        "is text('.visit-answer').includes(degrees(event('takeoff').angle)) && lab.clock.time === event('takeoff').t",
        # the landing is that of the motion
        *step(1),
        "click .guess-choice input",
        *ANSWERED,
        "is text('.visit-answer').includes(`${digits(event('impact').t - event('takeoff').t)} s`)",
        "is text('.visit-answer').includes(`${digits(100 * event('apex').height)} cm`)",
        "is first('.guess-choice.right input').value === { R: 'roll', S: 'spin', K: 'skid' }[event('impact').to]",
        # the highest hop of three is that of the motions
        *step(4),
        "click .guess-choice:nth-child(2) input",
        *ANSWERED,
        "is text('.visit-answer').startsWith('100 of 100 points')",
        "is lab.extras.visit.films.length === 3 && lab.extras.visit.films.every((film) =>"
        f" text('.visit-answer').includes(`${{digits(100 * Math.max(...{APEXES}))}} cm`))",
        # a question is not about another motion
        "do await lab.extras.visit.go(0); lab.load('start.speed=2')",
        "until !seen('.visit') && seen('.transport')",
    ]),
    "the highest hop is scored by its height": challenge(
        "Hop highest", f"(({{ film }}) => {RESULT}.endsWith(`${{digits(Math.max(...{APEXES}))}} m.`))({{ film: lab.film() }})",
    ),
    "an upright landing is scored by its angle": challenge(
        "Land upright",
        "((angle) => Math.cos(angle) > Math.cos(Math.PI / 360) && text('.challenge-result').includes("
        "degrees(Math.abs(Math.asin(Math.sin(angle))))))"
        "(lab.film().events.find(({ kind, t }) => kind === 'impact' && t > event('takeoff').t).angle)",
    ),
    "a hop without skidding is scored by its first height": challenge(
        "Hop without skidding",
        "/^R[^KH]*H/.test(lab.film().sequence)"
        " && text('.challenge-result').endsWith(`${digits(100 * event('apex').height)} cm.`)",
    ),
    "a start of one's own counts, and a motion that breaks a rule has no points": ("", {}, """
        do lab.extras.challenges.open()
        button Hop highest
        do lab.load('plane.mu=0.8')
        until lab.film().scenario.plane.mu === 0.8 && $SETTLED
        do globalThis.points = $METER
        do lab.motions.change([['plane.slope', 0.1]], true)
        until points > 0 && $METER === 0 && $RESULT.includes('The plane must be level.')
        is $OWN === `Your best: ${points} points.`
    """),
    "the table holds the states of the motion, and any quantity stands on either axis": ("", {}, r"""
        do lab.extras.table.open(true)
        choose .table-step>select 0.5
        do $ROW
        is lab.extras.table.body.rows.length === 13 && wrong.length === 0
        save Save as CSV
        is kept.startsWith('time [s],angle') && kept.split('\r\n').length === 15
        # the plain file is that of English
        is all('.table .check').length > 0 && !seen('.table .check')
        is $LONGEST <= 9
        # a spreadsheet in another language reads other signs, and programs the plain ones
        choose .language de
        until text('.table .check') === 'für Programme (Komma, Dezimalpunkt)'
        save Als CSV speichern
        is kept.startsWith('\xef\xbb\xbf' + 'Zeit [s];Winkel') && /\r\n0,5;107,\d+;/.test(kept)
        is kept.split('\r\n').every((line) => !line || line.split(';').length === 8)
        click .table .check input
        save Als CSV speichern
        is kept.startsWith('Zeit [s],Winkel') && /\r\n0.5,107\.\d+,/.test(kept)
        click .table .check input
        choose .language en
        until text('.table h2') === 'Table'
        choose .plots-head>select x
        choose [data-plot=own]>header>select total
        until lab.plots.plots.at(-1).definition.unit === 'W [J]'
        is first('[data-plot=own] .plot-body').ariaLabel.includes('total energy from')
        do globalThis.end = lab.film().at(6)
        is near(lab.plots.plots.at(-1).abscissa(lab.film()).at(-1), end.x, 1e-4)
        is near(lab.plots.plots.at(-1).definition.curves(lab.film())[0].values.at(-1), end.kinetic + end.potential, 1e-4)
        # to the sample that is nearest on the chosen axis
        do lab.plots.plots[0].seek(7)
        is near(lab.film().at(lab.clock.time).x, 7, 0.1)
    """),
    "sound follows the contact force": ("", {}, """
        do $HEARD
        is wrong.length === 0 && apart.length === 0
        # in flight there is nothing to hear
        is lab.extras.sound.constructor.heard(lab.film(), 1.3).tone === 0
        is lab.extras.sound.made === null
        button Sound of the contact
        is lab.extras.sound.made.context instanceof AudioContext
    """),
    "a visit uses the window and halts at the event it speaks of": ("", {}, [
        *step(3),
        "is (({ width, right }) => right > 1420 && width + first('.visit').offsetWidth > 0.95 * 1440)"
        "(first('.stage').getBoundingClientRect())",
        "do first('.dial').focus()",
        "press PageDown",
        "press PageDown",
        "do lab.clock.speed = 0.05",  # time to press a button, also on a busy machine
        "button Play",
        "until lab.clock.time > 0.001",
        "button Pause",
        "do globalThis.at = lab.clock.time",
        "wait 200",
        "is lab.clock.time === at && at < event('slip_start').t && text('.visit-answer') === ''",
        "button Skip to the answer",
        "until text('.visit-answer').includes(degrees(event('slip_start').angle))",
        "is text('.visit-answer').startsWith('Not so.') && !text('.visit-answer').includes('0 of 100')",
        "is lab.clock.time === event('slip_start').t && lab.extras.visit.play.hidden",
        # both arrows of which it speaks are in the picture, and as long
        "is text('.visit-answer').includes('The arrows of F and N have the same length')",
        "is lab.stage.options.forces && (({ normal_force: N, friction_force: F }) => near(Math.abs(F) / N, 1, 1e-6)"
        " && lab.film().newton * N * lab.stage.flat.views[0].scale > 6)(lab.film().at(lab.clock.time))",
        "until all('.readout dd')[3].textContent === degrees(event('slip_start').angle)",
    ]),
}  # fmt: skip


@each_of(
    FLOWS,
    "the highest hop is scored by its height",
    "an upright landing is scored by its angle",
    "a hop without skidding is scored by its first height",
    "a start of one's own counts, and a motion that breaks a rule has no points",
    "sound follows the contact force",
)
def test_a_lesson(visit, flow):
    take(visit, flow, globals())
