"""Where everything is on the page: low and narrow windows, large letters, long words, other directions of writing."""

import math

import pytest

import hophoop as hh
from lab_page_tools import PHONE, SETTLED, SHOWN, picture, wait_for

FINGERS = {"has_touch": True, "is_mobile": True, "device_scale_factor": 1}

# pairs of texts on the picture that lie over one another, and those that leave it
CROSSING = """() => {
  const stage = document.querySelector(".stage").getBoundingClientRect();
  const shown = [...document.querySelectorAll(".readout, .legend, .stage-keys")].filter((one) => one.checkVisibility());
  const view = hophoopLab.stage.flat.views[0];
  const [, foot] = view.point(view.pose.x, 0);
  const { px } = hophoopLab.theme.look;
  const boxes = shown.map((one) => ({ name: one.className, ...one.getBoundingClientRect().toJSON() }));
  // the numbers on the plane
  const [top, bottom] = [8, 20].map((below) => stage.top + foot + below * px);
  boxes.push({ name: "axis", left: stage.left, right: stage.right, top, bottom });
  const found = boxes.filter(({ left, right, bottom }) => left < stage.left || right > stage.right || bottom > stage.bottom);
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(0, i))
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) found.push(`${a.name} over ${b.name}`);
  return found;
}"""


@pytest.mark.parametrize("size", [(320, 256), (360, 320), (320, 568), (844, 390)])
def test_a_small_window_is_no_wider_than_it_is_and_no_text_covers_another(visit, size):
    options = FINGERS if size[1] in (390, 568) else {}
    page = visit(viewport={"width": size[0], "height": size[1]}, **options)
    wait_for(page, SETTLED)
    assert page.evaluate("document.documentElement.scrollWidth") == size[0]
    assert page.evaluate(CROSSING) == []
    # every control of the player is inside of it, and the speed can be read
    outside = page.evaluate(
        """() => {
          const player = document.querySelector(".player").getBoundingClientRect();
          return [...document.querySelectorAll(".transport button, .transport select")]
            .filter((one) => one.checkVisibility())
            .filter((one) => one.getBoundingClientRect().right > player.right || one.scrollWidth > one.clientWidth + 1)
            .map((one) => one.outerHTML.slice(0, 90));
        }"""
    )
    assert outside == []
    assert page.locator(".transport select").bounding_box()["width"] >= 55
    if size == (844, 390):
        player = page.locator(".player").bounding_box()
        assert player["y"] + player["height"] <= 390
    picture(page, f"small-{size[0]}-{size[1]}")


def test_the_names_of_languages_are_whole(visit):
    page = visit(**PHONE)
    cut = page.evaluate(
        """() => {
          const menu = document.querySelector(".language");
          const free = menu.cloneNode(true);
          free.style.cssText = "position: absolute; max-width: none; width: auto";
          menu.after(free);
          const [shown, wanted] = [menu, free].map((one) => one.getBoundingClientRect().width);
          free.remove();
          return wanted - shown;
        }"""
    )
    assert cut <= 0.5


def test_what_theory_says_stays_in_its_card(visit):
    page = visit(locale="fr")
    wait_for(page, "lab.theory.list.children.length > 4")
    wide = page.evaluate(
        """() => {
          const card = document.querySelector(".theory").getBoundingClientRect();
          const values = [...document.querySelectorAll(".theory dd")];
          return [
            Math.max(...values.map((one) => one.getBoundingClientRect().right)) - card.right,
            Math.max(...values.map((one) => one.scrollWidth - one.clientWidth)),
            Math.min(...values.map((one) => one.clientWidth)),
          ];
        }"""
    )
    assert wide[0] < 0
    assert wide[1] <= 0
    assert wide[2] > 110  # no word a line


LARGE = "addEventListener('DOMContentLoaded', () => { document.documentElement.style.fontSize = '200%'; })"


def test_larger_letters_of_the_browser_are_taken_over_also_in_pictures(visit):
    usual, large = visit(), visit(script=LARGE)
    sizes = """['.hophoop', '.readout', '.hint', '.control label']
      .map((one) => parseFloat(getComputedStyle(document.querySelector(one)).fontSize))"""
    before, after = usual.evaluate(sizes), large.evaluate(sizes)
    assert after == pytest.approx([2 * size for size in before])
    assert large.evaluate("hophoopLab.theme.look.px") == 2 * usual.evaluate("hophoopLab.theme.look.px") == 2
    assert large.evaluate("document.documentElement.scrollWidth") == 1440
    # what is drawn larger is still found where it is pointed at
    wait_for(large, SHOWN)
    line = large.locator("[data-plot=velocities] .plot-body")
    line.scroll_into_view_if_needed()
    wait_for(large, "lab.plots.plots[0].box")
    box = line.bounding_box()
    line.click(position={"x": 2 * 52 + 0.25 * (box["width"] - 2 * 62), "y": 60})
    assert large.evaluate("hophoopLab.clock.time") == pytest.approx(1.5, abs=0.02)


def test_a_presentation_shows_the_player_alone_in_proportion(visit):
    size = (1920, 1080)
    page = visit("#t=0.8", viewport={"width": size[0], "height": size[1]})
    wait_for(page, SETTLED)
    before = page.evaluate("hophoopLab.theme.look.px")
    page.evaluate("hophoopLab.extras.present.turn(true)")
    wait_for(page, "!lab.surrounding && lab.theme.look.px > 1")
    player = page.locator(".player").bounding_box()
    assert [player[side] for side in ("x", "y", "width", "height")] == pytest.approx([0, 0, *size], abs=1)
    assert not page.locator(".why, .words, .map, .side, .top").filter(visible=True).count()
    assert page.evaluate("document.documentElement.scrollHeight") <= size[1]
    # the numbers on the axes have the size of a line on a blackboard, as the readout has
    assert page.evaluate("11 * hophoopLab.theme.look.px") >= 0.02 * size[1]
    picture(page, f"presentation-{size[0]}")
    page.evaluate("hophoopLab.extras.present.turn(false)")
    wait_for(page, f"lab.theme.look.px === {before}")


def test_pictures_are_drawn_for_the_width_of_a_sheet(visit):
    page = visit("#t=0.8")
    wait_for(page, SHOWN)
    measure = """() => [...document.querySelectorAll("canvas")].filter((one) => one.checkVisibility()).map((one) => {
      const { width, height } = one.getBoundingClientRect();
      return [one.width / width, one.height / height, document.querySelector(".hophoop").clientWidth];
    })"""
    before = page.evaluate(measure)
    # at once: the sheet is filled while the event is handled
    printed = page.evaluate(f"() => {{ dispatchEvent(new Event('beforeprint')); return ({measure})(); }}")
    assert len(printed) > 3
    for across, down, width in printed:
        assert across == pytest.approx(down, rel=0.02)
        assert width == pytest.approx(180 / 25.4 * 96, abs=1)
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    wait_for(page, SETTLED)
    assert page.evaluate(measure) == before


def step(page, number):
    page.evaluate("number => hophoopLab.extras.visit.go(number)", number)
    page.wait_for_function(
        "number => document.querySelector('.visit-count')?.textContent.startsWith(`Step ${number + 1} `)", arg=number
    )


def test_a_visit_uses_the_window_and_halts_at_the_event_it_speaks_of(visit):
    page = visit()
    step(page, 2)
    card, stage = (page.locator(one).bounding_box() for one in (".visit", ".stage"))
    assert stage["x"] + stage["width"] > 1420
    assert card["width"] + stage["width"] > 0.95 * 1440
    dial = page.locator(".dial")
    dial.focus()
    page.keyboard.press("PageDown")
    page.keyboard.press("PageDown")
    play = page.locator(".visit").get_by_role("button", name="Play", exact=True)
    page.evaluate("hophoopLab.clock.speed = 0.05")  # time to press a button, also on a busy machine
    play.click()
    wait_for(page, "lab.clock.time > 0.001")
    # it can be halted, goes on, and can be skipped
    page.locator(".visit").get_by_role("button", name="Pause", exact=True).click()
    at = page.evaluate("hophoopLab.clock.time")
    page.wait_for_timeout(200)
    slip = hh.simulate(hh.Scenario.from_query("start.speed=2.8")).find("slip_start")[0]
    assert page.evaluate("hophoopLab.clock.time") == at < slip.t
    assert page.locator(".visit-answer").inner_text() == ""
    page.locator(".visit").get_by_role("button", name="Skip to the answer").click()
    page.wait_for_function("() => document.querySelector('.visit-answer').textContent")
    said = page.locator(".visit-answer").inner_text()
    assert f"{math.degrees(slip.angle):.1f}°" in said
    assert said.startswith("Not so.")
    assert "0 of 100" not in said
    assert page.evaluate("hophoopLab.clock.time") == slip.t
    assert page.locator(".readout dd").nth(3).inner_text() == f"{math.degrees(slip.angle):.1f}°"
    assert not page.locator(".visit").get_by_role("button", name="Play", exact=True).count()


def test_the_mark_of_the_dial_covers_no_number(visit):
    page = visit()
    step(page, 2)
    page.wait_for_timeout(100)
    # where texts are drawn on the dial, and how far they reach
    texts = page.evaluate(
        """() => {
          const { prototype } = CanvasRenderingContext2D;
          const { fillText } = prototype;
          const found = [];
          prototype.fillText = function (text, x, y) {
            if (this.canvas.className === "dial-canvas") found.push([text, x, y, this.measureText(text).width]);
            fillText.call(this, text, x, y);
          };
          hophoopLab.extras.visit.guess.redraw();
          prototype.fillText = fillText;
          return found;
        }"""
    )
    assert [text for text, *_ in texts] == ["0°", "90°", "180°", "270°"]
    for text, x, y, width in texts:
        far = math.hypot(abs(x - 84) + width / 2, y - 4 - 84)
        assert far < 58 - 12, text  # the ring's radius less that of the mark
