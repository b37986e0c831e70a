"""Steps that outlive a reload, and hands on the map."""

import pytest

uvicorn = pytest.importorskip("uvicorn", reason="the extra 'lab' is not installed")

from lab_page_tools import SHOWN, wait_for  # noqa: E402


def test_undo_and_redo_are_there_after_a_reload(visit):
    page = visit("?start.speed=2")
    wait_for(page, SHOWN)
    steps = ["start.speed=2"]
    for path, value in (("plane.mu", 0.5), ("plane.restitution", 0.25), ("hoop.mass", 2)):
        page.evaluate("change => hophoopLab.motions.change([change], true)", [path, value])
        wait_for(page, f"lab.film().values['{path}'] === {value} && lab.motions.history.past.length === {len(steps)}")
        steps.append(page.evaluate("hophoopLab.film().query"))
    page.keyboard.press("z")
    wait_for(page, f"lab.film().query === '{steps[2]}' && lab.motions.history.future.length === 1")
    page.reload()
    wait_for(page, SHOWN)
    assert page.get_by_role("button", name="Undo (z)").is_enabled()
    page.keyboard.press("y")
    wait_for(page, f"lab.film().query === '{steps[3]}' && lab.motions.history.future.length === 0")
    for step in (2, 1, 0):
        page.keyboard.press("z")
        wait_for(page, f"lab.film().query === '{steps[step]}' && lab.motions.history.past.length === {step}")
    # another link in the same tab has no such steps
    page.goto(page.url.split("?")[0] + "?start.speed=4")
    wait_for(page, SHOWN)
    assert page.get_by_role("button", name="Undo (z)").is_disabled()


def test_buttons_zoom_the_map_about_the_mark(visit):
    page = visit("?start.speed=3.1&plane.mu=0.4")
    wait_for(page, SHOWN)
    page.locator(".map-body").scroll_into_view_if_needed()
    for _ in range(6):
        page.get_by_role("button", name="Zoom into the map").click()
    windows = page.evaluate("hophoopLab.map.axes.windows")
    assert windows["x"][0] < 3.1 < windows["x"][1]
    assert windows["y"][0] < 0.4 < windows["y"][1]
    assert windows["x"][1] - windows["x"][0] < 0.2
    for _ in range(3):
        page.get_by_role("button", name="Zoom out of the map").click()
    windows = page.evaluate("hophoopLab.map.axes.windows")
    assert windows["x"][0] < 3.1 < windows["x"][1]


@pytest.mark.parametrize(("way", "moves"), [((0, -60), False), ((6, -50), False), ((60, 4), True)])
def test_a_finger_moves_the_map_only_when_it_starts_across(visit, way, moves):
    page = visit(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    wait_for(page, SHOWN)
    if not page.locator(".map-body").is_visible():
        page.evaluate("hophoopLab.view.show(true)")
    page.locator(".map-body").scroll_into_view_if_needed()
    page.evaluate("hophoopLab.map.zoom(0.5)")
    before = page.evaluate("hophoopLab.map.axes.windows")
    box = page.locator(".map-body").bounding_box()
    x, y = box["x"] + 0.6 * box["width"], box["y"] + 0.5 * box["height"]
    session = page.context.new_cdp_session(page)

    def touch(kind, *places):
        points = [{"x": px, "y": py} for px, py in places]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    query = page.evaluate("hophoopLab.film().query")
    touch("touchStart", (x, y))
    for k in range(1, 7):
        touch("touchMove", (x + way[0] * k / 6, y + way[1] * k / 6))
    touch("touchEnd")
    page.wait_for_timeout(200)
    assert (page.evaluate("hophoopLab.map.axes.windows") != before) is moves
    assert page.evaluate("hophoopLab.film().query") == query
