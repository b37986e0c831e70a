"""The page in the visitor's language: chosen by the browser, switched by hand, and nothing left in English."""

import pytest

from lab_page_tools import wait_for

LOCALES = {"de": "de-DE", "es": "es-MX", "fr": "fr-CA", "zh": "zh-TW"}


@pytest.fixture(scope="module")
def address(site_address):
    """The page that computes by itself."""
    return site_address


@pytest.mark.long
def test_the_browser_chooses_and_the_visitor_switches(visit):
    page = visit("?start.speed=2.8", locale="de-AT")
    wait_for(page, "!lab.surrounding && lab.theory.list.children.length > 4")
    assert page.evaluate("document.documentElement.lang") == "de"
    assert page.locator(".summary").inner_text().startswith("Rollt, rutscht ab 65,5°")
    assert "würde über 2,043 m/s gleiten" in page.locator(".theory").inner_text()
    assert page.locator(".readout .mode").inner_text() == "Rollen"
    page.get_by_label("Sprache").select_option("fr")
    wait_for(page, "!lab.surrounding")
    assert page.evaluate("document.documentElement.lang") == "fr"
    assert page.locator(".summary").inner_text().startswith("Roule, dérape à partir de 65,5°")
    assert page.get_by_role("button", name="Lecture (espace)").is_visible()
    page.reload()
    page.wait_for_selector("[data-ready]")
    assert page.evaluate("document.documentElement.lang") == "fr"  # the choice is kept
    page.get_by_label("Langue").select_option("en")
    wait_for(page, "!lab.surrounding")
    assert page.locator(".summary").inner_text().startswith("Rolls, skids at 65.5°")


def test_another_language_falls_back_to_english(visit):
    page = visit(locale="fi-FI")
    assert page.evaluate("document.documentElement.lang") == "en"


# one language every time, and the others in CI
@pytest.mark.parametrize("code", [code if code == "zh" else pytest.param(code, marks=pytest.mark.long) for code in LOCALES])
def test_nothing_stays_in_english(visit, code):
    page = visit(locale=LOCALES[code], reduced_motion="reduce", viewport={"width": 390, "height": 844})
    # longer words still fit on a phone
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    assert page.evaluate("document.documentElement.lang") == code
    wait_for(page, "!lab.surrounding && lab.theory.list.children.length > 4")
    page.evaluate(
        """async () => {
          const lab = hophoopLab;
          const { visit, challenges, table, teach } = lab.extras;
          table.open(true);
          for (let step = 0; step < 8; step++) {
            await visit.go(step);
            document.querySelector(".guess-choice input")?.click();
            const key = new KeyboardEvent("keydown", { key: "ArrowUp", bubbles: true });
            document.querySelector(".dial, .sketch-point")?.dispatchEvent(key);
            if (step < 7) visit.show();
          }
          visit.leave();
          challenges.open();
          for (const tab of challenges.tabs.values()) tab.click();
          await challenges.load("plane.slope=0.1");
          lab.motions.compare();
          lab.transport.jump(1, "takeoff");
          await new Promise((resolve) => setTimeout(resolve, 400));
        }"""
    )
    wait_for(page, "!lab.surrounding")
    assert page.evaluate("[...hophoopLab.extras.words.untranslated]") == []
    # every label that is read to people as well
    latin = page.evaluate(
        """() => [...document.querySelectorAll("button, summary, option, label, h2, h3, th")]
          .map((element) => element.textContent.trim()).filter((text) => /[a-z]{4}/.test(text))"""
    )
    if code == "zh":
        names = {"English", "Deutsch", "Español", "Français", "Shift ← →"}
        assert [text for text in latin if text not in names and not any(sign >= "\u4e00" for sign in text)] == []
