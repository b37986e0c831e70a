"""The page in headless Chromium: what a visitor does, with no console error and nothing from elsewhere."""

import pytest

import hophoop as hh
from lab_page_tools import colors_on, each_of, picture, summary, take, wait_for
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
    # energies are booked as in every plot
    drawn = page.evaluate(
        "hophoopLab.plots.plots[1].definition.curves(hophoopLab.film()).map(({ name, values }) => [name, values.at(-1)])"
    )
    ledger = hh.simulate(hh.Scenario()).ledger
    assert dict(drawn)["curve.friction_loss"] == pytest.approx(ledger.friction + ledger.impact_tangential, rel=1e-6)
    assert dict(drawn)["curve.normal_loss"] == pytest.approx(ledger.impact_normal, rel=1e-6)
    assert ledger.impact_tangential > 0.1  # what tells one convention from the other


# name: (link, options, steps), as in test_flows.py
FLOWS = {
    "real parts and compliant contact, and the sentence of a part stays": ("", {}, """
        until $SHOWN
        do lab.controls.way.select.closest('details').open = true
        choose .group:first-child>.choice>select parts
        until all('.part input').length === 5
        do all('.part input')[0].id = 'mass'; all('.part input')[3].id = 'load'
        write #mass heavy
        until all('.parts .error').filter(shown).length === 1
        write #load 0.4
        fill start.speed 2.5
        until lab.film().values['start.speed'] === 2.5 && $SETTLED
        is all('.parts .error').filter(shown).length === 1 && first('#mass').value === 'heavy'
        is lab.film().scenario.hoop.parts[1].mass === 0.4
        choose .parts+select disk
        until lab.film().scenario.hoop.parts.length === 3
        click .group:last-child>summary
        choose select[data-path='contact.model'] compliant
        until lab.film().scenario.contact.model === 'compliant'
        is first('[aria-label="Stiffness, exact value in N/m"]').placeholder.startsWith('auto ')
    """),
    "it plays and is scrubbed": ("", {}, """
        until $SHOWN
        do globalThis.before = lab.frames
        press Space
        until lab.clock.time > 0.3 && lab.frames > before + 5
        press Space
        do first('.timeline-canvas').scrollIntoView({ block: 'center' })
        drag .timeline-canvas: [[0.25 * first('.timeline-canvas').offsetWidth, 0]]
        drop
        is near(lab.clock.time, 4.5, 0.02)
        press Home
        press h
        is lab.clock.time === event('takeoff').t
        until text('.readout .mode') === 'flight'
        press l
        is lab.clock.time === event('impact').t
        press ArrowRight
        is near(lab.clock.time, event('impact').t + 1 / 60, 1e-9)
        press Shift+ArrowLeft
        is lab.clock.time === event('impact').t
    """),
    "a link opens the same motions": ("?start.speed=2.9&plane.restitution=0.4", {}, """
        button Compare two hoops
        fill plane.mu 0.5
        until lab.films().length === 2 && lab.motions.history.past.length === 2
        do sessionStorage.kept = lab.films().map((film) => film.sequence).join()
        is new Set(sessionStorage.kept.split(',')).size === 2
        reload
        is lab.films().map((film) => film.sequence).join() === sessionStorage.kept
    """),
}  # fmt: skip


@also_delayed
@each_of(
    FLOWS,
    "real parts and compliant contact, and the sentence of a part stays",
)
def test_a_page(visit, flow, request):
    picture(take(visit, flow, globals()), request.node.name)


def test_the_picture_follows_the_hand(visit):
    """While the slider moves pictures come, as fast as they are computed, and the last one is of where it stopped.

    How fast that is, is measured by benchmarks/page.py: here the kernel may be compiling, and others may be at work.
    """
    page = visit()
    last = page.evaluate(
        """async () => {
          const slider = document.querySelector("input[data-path='start.speed']");
          let speed = 2;
          for (let k = 0; k < 8 || (hophoopLab.latencies.length <= 5 && k < 300); k++) {
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
