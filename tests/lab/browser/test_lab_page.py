"""The page in headless Chromium: what a visitor does, with no console error and nothing from elsewhere."""

import pytest

import hophoop as hh
from lab_page_tools import SETTLED, SHOWN, colors_on, expect, picture, summary, wait_for
from slow_page import also_delayed


def test_the_page_opens_with_the_hop(visit):
    page = visit()
    wait_for(page, "lab.theory.list.children.length > 4")
    assert "hops at 315.6°" in summary(page)
    assert "would hop in its first turn above 2.908 m/s" in page.locator(".theory").inner_text()
    assert colors_on(page, ".stage canvas") > 20
    for plot in ("velocities", "energies", "forces", "utilization"):
        assert colors_on(page, f"[data-plot={plot}] canvas") > 8
    picture(page, "desktop", full_page=True)


@also_delayed
def test_real_parts_and_compliant_contact_and_the_sentence_of_a_part_stays(visit):
    page = visit()
    wait_for(page, SHOWN)
    page.evaluate("hophoopLab.controls.way.select.closest('details').open = true")
    page.get_by_label("Defined by").select_option("parts")
    fields = page.locator(".part input")
    expect(fields).to_have_count(5)
    fields.nth(0).fill("heavy")
    fields.nth(0).press("Enter")
    wrong = page.locator(".parts .error:visible")
    expect(wrong).to_have_count(1)
    fields.nth(3).fill("0.4")
    fields.nth(3).press("Enter")
    page.locator("input[data-path='start.speed']").fill("2.5")
    wait_for(page, f"lab.film().values['start.speed'] === 2.5 && {SETTLED}")
    assert wrong.count() == 1
    assert fields.nth(0).input_value() == "heavy"
    assert page.evaluate("hophoopLab.film().scenario.hoop.parts[1].mass") == 0.4
    page.get_by_label("Add a part").select_option("disk")
    wait_for(page, "lab.film().scenario.hoop.parts.length === 3")
    page.locator("summary", has_text="Advanced").click()
    page.locator("select[data-path='contact.model']").select_option("compliant")
    wait_for(page, "lab.film().scenario.contact.model === 'compliant'")
    stiffness = page.get_by_label("Stiffness, exact value in N/m", exact=True)
    assert stiffness.get_attribute("placeholder").startswith("auto ")
    picture(page, "parts")


@also_delayed
def test_it_plays_and_is_scrubbed(visit):
    page = visit()
    wait_for(page, SHOWN)
    before = page.evaluate("hophoopLab.frames")
    page.keyboard.press(" ")
    wait_for(page, f"lab.clock.time > 0.3 && lab.frames > {before} + 5")
    page.keyboard.press(" ")
    stopped = page.evaluate("hophoopLab.clock.time")
    line = page.locator(".timeline-canvas")
    line.click(position={"x": 0.75 * line.bounding_box()["width"], "y": 25})
    assert page.evaluate("hophoopLab.clock.time") == pytest.approx(4.5, abs=0.02)
    assert page.evaluate("hophoopLab.clock.time") != stopped
    page.keyboard.press("Home")
    page.keyboard.press("h")
    motion = hh.simulate(hh.Scenario())
    assert page.evaluate("hophoopLab.clock.time") == motion.find("takeoff")[0].t
    wait_for(page, "document.querySelector('.readout .mode').textContent === 'flight'")
    page.keyboard.press("l")
    assert page.evaluate("hophoopLab.clock.time") == motion.find("impact")[0].t
    page.keyboard.press("ArrowRight")
    assert page.evaluate("hophoopLab.clock.time") == pytest.approx(motion.find("impact")[0].t + 1 / 60)
    page.keyboard.press("Shift+ArrowLeft")
    assert page.evaluate("hophoopLab.clock.time") == motion.find("impact")[0].t


def test_the_film_between_frames_is_the_motion_and_its_energies_are_booked_alike(visit):
    page = visit()
    times = [0.1234, 0.7, 1.3337, 2.7182, 5.9]
    poses = page.evaluate("times => times.map((t) => hophoopLab.film().at(t))", times)
    sample = hh.simulate(hh.Scenario()).at(times)
    for i, pose in enumerate(poses):
        assert pose["mode"] == sample.mode[i]
        for name, size in (("x", 1e-5), ("angle", 1e-5), ("height", 1e-6)):
            assert pose[name] == pytest.approx(getattr(sample, name)[i], abs=size), (name, times[i])
    # energies are booked as in every plot
    drawn = page.evaluate(
        "hophoopLab.plots.plots[1].curves(hophoopLab.film()).map(({ name, values }) => [name, values.at(-1)])"
    )
    ledger = hh.simulate(hh.Scenario()).ledger
    assert dict(drawn)["diagram.friction_loss"] == pytest.approx(ledger.friction + ledger.impact_tangential, rel=1e-6)
    assert dict(drawn)["diagram.impact_loss"] == pytest.approx(ledger.impact_normal, rel=1e-6)
    assert ledger.impact_tangential > 0.1  # what tells one convention from the other


def test_a_link_opens_the_same_motion(visit):
    page = visit("?start.speed=2.9&plane.restitution=0.4")
    page.get_by_role("button", name="Compare two hoops").click()
    page.locator("input[data-path='plane.mu']").fill("0.5")
    wait_for(page, "lab.films().length === 2 && lab.motions.history.past.length === 2")
    sequences = page.evaluate("hophoopLab.films().map((film) => film.sequence)")
    assert sequences[0] != sequences[1]
    other = visit(page.evaluate("location.pathname + location.search + location.hash").lstrip("/"))
    assert other.evaluate("hophoopLab.films().map((film) => film.sequence)") == sequences
    picture(other, "compare")


@pytest.mark.long
def test_every_preset_plays(visit):
    page = visit()
    wait_for(page, "!lab.surrounding")
    from hophoop.lab.site.presets import presets

    for preset in presets():
        page.locator(".presets").select_option(preset.key)
        page.wait_for_function("query => hophoopLab.film().query === query", arg=preset.scenario.to_query())
        page.evaluate("hophoopLab.clock.seek(0.6 * hophoopLab.clock.duration)")
        wait_for(page, "!lab.surrounding && !lab.requested")
        assert page.locator(".preset-text").inner_text() == preset.text
        assert page.locator(".message").is_hidden()
        if preset.key in ("littlewood", "jam", "downhill"):
            picture(page, f"preset-{preset.key}")


def test_the_picture_follows_the_hand(visit):
    """While the slider moves pictures come, as fast as they are computed, and the last one is of where it stopped.

    How fast that is, is measured by benchmarks/page.py: here the kernel may be compiling, and others may be at work.
    """
    page = visit()
    last = page.evaluate(
        """async () => {
          const slider = document.querySelector("input[data-path='start.speed']");
          let speed = 2;
          for (let k = 0; k < 25 || (hophoopLab.latencies.length <= 5 && k < 300); k++) {
            speed = (200 + 5 * (k % 25)) / 100;
            slider.value = String(speed);
            slider.dispatchEvent(new Event("input", { bubbles: true }));
            await new Promise((resolve) => setTimeout(resolve, 60));
          }
          return speed;
        }"""
    )
    wait_for(page, f"!lab.motions.lanes[0].busy && lab.film().values['start.speed'] === {last}")
    assert page.evaluate("hophoopLab.latencies.length") > 5
