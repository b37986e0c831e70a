"""The hoop in the visitor's hand: by mouse, finger and keys; what is computed is what the hand has chosen."""

import math

import pytest

import hophoop as hh
from lab_page_tools import PHONE, wait_for


@pytest.fixture(scope="module")
def address(site_address):
    """The page that computes by itself."""
    return site_address


def middle(page, grip):
    box = page.locator(f".grip-{grip}").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def scenario(page):
    return hh.Scenario.from_query(page.evaluate("hophoopLab.film().query"))


def still(page):
    """Nothing is under way, and the picture is that of the motion."""
    wait_for(page, "!lab.motions.lanes[0].busy && !lab.motions.lanes[0].pending && !lab.surrounding && !lab.requested")


def drag(page, grip, places, hold=250):
    """Take the hoop, pass these places (from where it was taken), and let go after a while [ms]."""
    x, y = middle(page, grip)
    page.mouse.move(x, y)
    page.mouse.down()
    for dx, dy in places:
        page.mouse.move(x + dx, y + dy)
    page.wait_for_timeout(hold)
    still(page)


def test_the_load_is_turned_and_the_motion_follows_the_hand(visit):
    page = visit("?start.speed=2", reduced_motion="reduce")
    still(page)
    center = middle(page, "hoop")
    _x, y = middle(page, "load")
    radius = center[1] - y
    # a quarter turn: the load comes to where the finger is
    # so long that the address of the page is written while the hoop is in the hand
    drag(page, "load", [(0.7 * radius, 0.3 * radius), (radius, radius)], hold=600)
    assert page.evaluate("location.search") == "?start.speed=2"
    assert scenario(page).start.angle == pytest.approx(math.pi / 2, abs=0.03)
    assert page.evaluate("hophoopLab.motions.history.past.length") == 0  # still in the hand
    assert page.evaluate("hophoopLab.stage.options.ahead") is True
    page.mouse.up()
    wait_for(page, "lab.motions.history.past.length === 1")
    assert scenario(page).start.speed == 2.0  # the hand was at rest: the hoop keeps its speed
    assert page.evaluate("[hophoopLab.clock.time, hophoopLab.stage.options.ahead]") == [0, False]
    page.keyboard.press("z")
    wait_for(page, "lab.film().query === 'start.speed=2'")


def test_a_flick_gives_the_speed_of_the_hand(visit):
    page = visit("?start.speed=0", reduced_motion="reduce")
    still(page)
    # what the hand did, with times of its own: 2 m/s along the plane in the last tenth of a second
    held = page.evaluate(
        """async () => {
          const lab = hophoopLab;
          const view = lab.stage.flat.views[0];
          const { Pull } = lab.extras.grips.constructor;
          const [x, y] = view.point(0, 1);
          const pull = new Pull("hoop", lab.film(), 0, view, { clientX: x, clientY: y });
          for (let k = 0; k <= 20; k++) pull.move({ clientX: x + view.scale * 2 * 0.01 * k, clientY: y }, 10 * k);
          return pull.release(200);
        }"""
    )
    assert held["vx"] == pytest.approx(2.0, rel=1e-6)
    assert held["height"] == 0
    assert held["angle"] == pytest.approx(0.4, rel=1e-6)  # it has rolled 0.4 m in the hand
    # a hand that has come to rest before it lets go gives none
    assert (
        page.evaluate(
            """() => {
          const view = hophoopLab.stage.flat.views[0];
          const { Pull } = hophoopLab.extras.grips.constructor;
          const pull = new Pull("load", hophoopLab.film(), 0, view, { clientX: 300, clientY: 100 });
          for (let k = 0; k <= 20; k++) pull.move({ clientX: 300 + 4 * k, clientY: 100 }, 10 * k);
          return pull.release(400).omega;
        }"""
        )
        == 0
    )


PULL_LOAD = """([time, speed]) => {
  const lab = hophoopLab;
  const view = lab.stage.flat.views[0];
  const { Pull } = lab.extras.grips.constructor;
  const R = lab.film().radius;
  const pose = lab.film().at(time);
  const center = [pose.x, R + pose.height];
  const at = (angle) => {
    const [x, y] = view.point(center[0] + R * Math.sin(angle), center[1] + R * Math.cos(angle));
    return { clientX: x, clientY: y };
  };
  const pull = new Pull("load", lab.film(), time, view, at(0));
  for (let k = 0; k <= 20; k++) pull.move(at((speed / R) * 0.01 * k), 10 * k);
  const { vx, vy, omega, height } = pull.release(200);
  return { vx, vy, omega, height, pose: { vx: pose.vx, vy: pose.vy, omega: pose.omega } };
}"""


def test_a_load_keeps_the_speed_of_the_hoop_unless_it_is_flicked(visit):
    page = visit("?start.speed=3.1", reduced_motion="reduce")
    still(page)
    slow = page.evaluate(PULL_LOAD, [0, 0.3])
    assert slow["vx"] == 3.1
    later = page.evaluate(PULL_LOAD, [0.5, 0.3])  # also where the film is stopped while it rolls or slips
    assert later["vx"] == 3.1
    flying = page.evaluate(PULL_LOAD, [1.4, 0.3])
    assert flying["height"] > 0
    assert {name: flying[name] for name in ("vx", "vy", "omega")} == flying["pose"]
    fast = page.evaluate(PULL_LOAD, [0, 2.0])
    assert fast["vx"] == pytest.approx(2.0, rel=1e-6)
    # the speed of the scenario stays as it is, to its last digit
    page = visit("?start.speed=3.616628264005025", reduced_motion="reduce")
    still(page)
    page.locator(".grip-load").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    wait_for(page, "lab.motions.history.past.length === 1")
    assert scenario(page).start.speed == 3.616628264005025


@pytest.mark.long
def test_it_is_pulled_up_and_dropped_and_escape_takes_it_back(visit):
    page = visit("?start.speed=0&start.angle=0.5", reduced_motion="reduce")
    still(page)
    scale = page.evaluate("hophoopLab.stage.flat.views[0].scale")
    drag(page, "hoop", [(0, -10), (0, -0.3 * scale)])
    start = scenario(page).start
    assert start.height == pytest.approx(0.3, abs=0.02)
    # the hoop stays under the hand: the picture keeps its scale
    assert page.evaluate("hophoopLab.stage.flat.views[0].scale") == pytest.approx(scale)
    page.mouse.up()
    wait_for(page, "lab.motions.history.past.length === 1")
    motion = hh.simulate(scenario(page))
    assert motion.sequence.startswith("H")
    fall = math.sqrt(2 * start.height / 9.81)
    assert motion.find("impact")[0].t == pytest.approx(fall, rel=1e-3)
    # what is let go by Escape was never taken
    page.locator(".grip-load").focus()
    page.keyboard.press("ArrowRight")
    wait_for(page, "lab.stage.options.ahead")
    page.keyboard.press("Escape")
    wait_for(page, f"lab.film().query === {hh.Scenario.to_query(motion.scenario)!r}")


@pytest.mark.long
def test_a_finger_tilts_the_plane_without_scrolling_the_page(visit):
    page = visit(**PHONE)
    still(page)
    x, y = middle(page, "plane")
    foot = page.evaluate(
        """() => {
          const view = hophoopLab.stage.flat.views[0];
          const box = hophoopLab.stage.element.getBoundingClientRect();
          const [x, y] = view.point(view.pose.x, 0);
          return [x + box.left, y + box.top];
        }"""
    )
    session = page.context.new_cdp_session(page)

    def touch(kind, *places):
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": a, "y": b, "id": 0} for a, b in places]})

    reach = x - foot[0]
    touch("touchStart", (x, y))
    for k in range(1, 7):
        touch("touchMove", (x, y + k / 6 * reach * math.tan(math.radians(10))))
    touch("touchEnd")
    wait_for(page, "lab.motions.history.past.length === 1")
    assert math.degrees(scenario(page).plane.slope) == pytest.approx(10, abs=0.6)
    assert page.evaluate("scrollY") == 0
    wait_for(page, "lab.clock.playing")  # it runs when the hand lets go
