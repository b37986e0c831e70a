"""The hoop in the visitor's hand: by mouse, finger and keys; what is computed is what the hand has chosen."""

from lab_page_tools import PHONE, each_of, take

CALM = {"reduced_motion": "reduce"}
START = "lab.film().scenario.start"
DONE = "until lab.motions.history.past.length === 1"
RADIUS = """const [hoop, load] = ['hoop', 'load'].map((one) => first(`.grip-${one}`).getBoundingClientRect());
  globalThis.radius = hoop.top + hoop.height / 2 - load.top - load.height / 2"""
# What the hand did, with times of its own: along the plane, or sideways, in the last fifth of a second.
PULL = """
  const view = lab.stage.flat.views[0];
  const { Pull } = lab.extras.grips.constructor;
  const pull = (grip, time, at, until = 200) => {
    const made = new Pull(grip, lab.film(), time, view, at(0));
    for (let k = 0; k <= 20; k++) made.move(at(k), 10 * k);
    return made.release(until);
  };
  const place = (x, y) => (([clientX, clientY]) => ({ clientX, clientY }))(view.point(x, y));
  const turned = (time, speed) => pull('load', time, (k) => {
    const { x, height } = lab.film().at(time);
    return place(x + Math.sin(speed * 0.01 * k), 1 + height + Math.cos(speed * 0.01 * k));
  });"""
TOUCH = """const { view } = { view: lab.stage.flat.views[0] };
  const box = lab.stage.element.getBoundingClientRect();
  const grip = first('.grip-plane').getBoundingClientRect();
  const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  globalThis.reach = x - view.point(view.pose.x, 0)[0] - box.left"""

# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "the load is turned, and the motion follows the hand": ("?start.speed=2", CALM, """
        until $SETTLED
        do $RADIUS
        # a quarter turn
        drag .grip-load: [[0.7 * radius, 0.3 * radius], [radius, radius]]
        # so long that the address of the page is written while the hoop is in the hand
        wait 600
        until $SETTLED
        is location.search === '?start.speed=2' && near($START.angle, Math.PI / 2, 0.03)
        # still in the hand
        is lab.motions.history.past.length === 0 && lab.stage.options.ahead
        drop
        $DONE
        # as the hand was at rest
        is $START.speed === 0
        is lab.clock.time === 0 && !lab.stage.options.ahead
        press z
        until lab.film().query === 'start.speed=2'
    """),
    "what is let go has the speed of the hand, and what is turned by keys keeps that of the hoop": ("?start.speed=0", CALM, """
        until $SETTLED
        # 2 m/s
        do $PULL globalThis.held = pull('hoop', 0, (k) => place(0.02 * k, 1))
        # it has rolled 0.4 m in the hand
        is near(held.vx, 2, 1e-6) && held.height === 0 && near(held.angle, 0.4, 1e-6)
        do $PULL globalThis.held = pull('load', 0, (k) => ({ clientX: 300 + 4 * k, clientY: 100 }), 400)
        # a hand that has come to rest before it lets go gives none
        is held.omega === 0
        do return lab.load('start.speed=3.1')
        until $SETTLED
        # also where it rolls or slips later
        do $PULL globalThis.held = [0, 0.5].map((time) => turned(time, 0.3).vx)
        is held.every((vx) => near(vx, 0.3, 1e-6))
        # in flight
        do $PULL globalThis.held = turned(1.4, 0.3)
        is held.height > 0 && held.vx === 0 && held.vy === 0 && near(held.omega, 0.3, 1e-6)
        do $PULL globalThis.held = turned(0, 2)
        is near(held.vx, 2, 1e-6)
        # which stays as it is, to its last digit
        do return lab.load('start.speed=3.616628264005025')
        until $SETTLED
        do first('.grip-load').focus()
        press ArrowRight
        press Enter
        until $START.angle !== 0 && lab.motions.history.holds(lab.motions.queries())
        is $START.speed === 3.616628264005025
    """),
    "a hoop at rest with its load at the top falls to a side": ("?start.speed=0&start.angle=0.3", CALM, """
        until $SETTLED
        do const { grips } = lab.extras; grips.change('load', { ...lab.film().at(0), angle: 0, slope: 0 }, true)
        until $START.angle === 0.02 && $SETTLED
        is lab.film().at(3).angle > 0.3
        do const { grips } = lab.extras; grips.change('hoop', { ...lab.film().at(0), angle: 0, height: 0.2, slope: 0 }, true)
        until $START.height === 0.2 && $SETTLED
        is $START.angle === 0.02 && Math.abs(lab.film().at(5).angle) > 0.3
    """),
    "it is pulled up and dropped, and Escape takes it back": ("?start.speed=0&start.angle=0.5", CALM, """
        until $SETTLED
        do globalThis.scale = lab.stage.flat.views[0].scale
        drag .grip-hoop: [[0, -10], [0, -0.3 * scale]]
        wait 250
        until $SETTLED
        is near($START.height, 0.3, 0.02)
        # the hoop stays under the hand
        is near(lab.stage.flat.views[0].scale / scale, 1, 1e-9)
        drop
        $DONE
        is lab.film().sequence[0] === 'H' && near(event('impact').t / Math.sqrt(2 * $START.height / 9.81), 1, 1e-3)
        do globalThis.before = lab.film().query; first('.grip-load').focus()
        press ArrowRight
        until lab.stage.options.ahead
        press Escape
        # what is let go by Escape was never taken
        until lab.film().query === before
    """),
    "a finger tilts the plane without scrolling the page": ("", PHONE, """
        until $SETTLED
        do $TOUCH
        touch .grip-plane: Array.from({ length: 7 }, (_, k) => [0, k / 6 * reach * Math.tan(Math.PI / 18)])
        $DONE
        is near(lab.film().scenario.plane.slope, Math.PI / 18, 0.011) && scrollY === 0
        # it runs when the hand lets go
        until lab.clock.playing
    """),
}  # fmt: skip


@each_of(FLOWS, "it is pulled up and dropped, and Escape takes it back", "a finger tilts the plane without scrolling the page")
def test_a_hand(visit, flow):
    take(visit, flow, globals())
