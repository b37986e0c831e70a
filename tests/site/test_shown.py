"""The pages in a browser: no request leaves them, no formula is cut off, nothing bars the way of those who cannot see."""

import os
from pathlib import Path

import pytest

WIDTHS = (1280, 375)
# in a page: formulas that are wider than their place, or stick out of the text
CUT_OFF = """() => {
  const right = document.querySelector('article').getBoundingClientRect().right + 1;
  const shown = element => element.getClientRects().length > 0;
  const wide = [...document.querySelectorAll('div.math')].filter(box => box.scrollWidth > box.clientWidth + 1);
  const out = [...document.querySelectorAll('span.math')].filter(
    box => shown(box) && !box.closest('.table-wrapper') && box.getBoundingClientRect().right > right);
  return [...wide, ...out].map(box => box.textContent.trim());
}"""


@pytest.mark.parametrize("width", WIDTHS)
def test_no_formula_is_cut_off_and_nothing_is_fetched(browser, site, address, width):
    pages = [page for page in sorted(site.rglob("*.html")) if "<math" in page.read_text(encoding="utf-8")]
    assert len(pages) > 15
    context = browser.new_context(viewport={"width": width, "height": 800})
    page = context.new_page()
    foreign, cut, wide = [], [], []
    page.on("request", lambda request: request.url.startswith((address, "data:")) or foreign.append(request.url))
    for file in pages:
        name = file.relative_to(site).as_posix()
        page.goto(address + name)
        page.evaluate("document.fonts.ready")
        cut += [f"{name}: {text}" for text in page.evaluate(CUT_OFF)]
        if page.evaluate("document.documentElement.scrollWidth") > width:
            wide.append(name)
    fonts = page.evaluate("[...document.fonts].filter(font => font.status === 'loaded').map(font => font.family)")
    context.close()
    assert foreign == []
    assert cut == []
    assert wide == []
    assert any("Hoop Math" in family for family in fonts)


def test_a_formula_that_is_too_wide_is_found(browser):
    page = browser.new_page(viewport={"width": 375, "height": 400})
    page.set_content(
        "<article style='width: 300px'><div class=math style='overflow: auto'><div style='width: 400px'>wide</div></div>"
        "<p><span class=math style='white-space: nowrap'>" + "long " * 20 + "</span> <span class=math>good</span></article>"
    )
    found = page.evaluate(CUT_OFF)
    page.close()
    assert found[0] == "wide"
    assert len(found) == 2


@pytest.mark.parametrize("name", ["index.html", "learn/first-hop.html", "learn/why.html", "model.html"])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(browser, site, address, name, scheme):
    assert serious(browser, address + name, scheme) == []


def test_axe_finds_what_is_serious(browser, tmp_path):
    (tmp_path / "bad.html").write_text("<html><title>Bad</title><img src='data:,'><p>No text</p></html>", encoding="utf-8")
    assert {"image-alt", "html-has-lang"} <= {rule for rule, _ in serious(browser, (tmp_path / "bad.html").as_uri())}


def serious(browser, address, scheme="light"):
    """Rules that axe-core finds broken, of serious or critical impact, with the elements that break them."""
    script = os.environ.get("HOPHOOP_AXE")
    if script is None:
        pytest.skip("HOPHOOP_AXE names no axe.min.js (npm install axe-core)")
    context = browser.new_context(color_scheme=scheme)
    page = context.new_page()
    page.goto(address)
    page.wait_for_load_state("networkidle")
    page.evaluate(Path(script).read_text(encoding="utf-8"))
    found = page.evaluate("axe.run({resultTypes: ['violations']})")["violations"]
    context.close()
    return [
        (each["id"], sorted(" ".join(node["target"]) for node in each["nodes"]))
        for each in found
        if each["impact"] in ("serious", "critical")
    ]
