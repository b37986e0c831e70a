"""The pages in a browser: no request leaves them, no formula is cut off, nothing bars the way of those who cannot see."""

import io
import os
import re
from pathlib import Path

import pytest
from PIL import Image

from lab_page_tools import accessible
from page_tools import text_sizes

WIDTHS = (1280, 375)
# in a page: formulas that are wider than their place, or stick out of the text
CUT_OFF = """() => {
  const right = (document.querySelector('article') ?? document.body).getBoundingClientRect().right + 1;
  const shown = element => element.getClientRects().length > 0;
  const wide = [...document.querySelectorAll('div.math')].filter(box => box.scrollWidth > box.clientWidth + 1);
  const out = [...document.querySelectorAll('span.math')].filter(
    box => shown(box) && !box.closest('.table-wrapper') && box.getBoundingClientRect().right > right);
  return [...wide, ...out].map(box => box.textContent.trim());
}"""


@pytest.mark.parametrize("width", WIDTHS)
def test_no_formula_is_cut_off_and_nothing_is_fetched(site, new_page, address, width):
    pages = [page for page in sorted(site.rglob("*.html")) if "<math" in page.read_text(encoding="utf-8")]
    assert len(pages) > 15
    page = new_page(viewport={"width": width, "height": 800})
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
    assert foreign == []
    assert cut == []
    assert wide == []
    assert any("Hoop Math" in family for family in fonts)


@pytest.mark.parametrize(("scheme", "theme"), [("dark", "auto"), ("light", "dark"), ("dark", "light"), ("light", "auto")])
def test_a_drawing_takes_the_colours_of_its_page(address, new_page, scheme, theme):
    dark = theme == "dark" or (theme == "auto" and scheme == "dark")
    page = new_page(color_scheme=scheme)
    page.add_init_script(f"localStorage.setItem('theme', '{theme}')")
    page.goto(f"{address}model.html")
    picture = page.locator("article img[src$='.svg']").first
    picture.scroll_into_view_if_needed()
    shot = Image.open(io.BytesIO(picture.screenshot())).convert("L")
    assert (shot.getpixel((2, 2)) < 60) == dark
    darkest, lightest = shot.getextrema()
    assert lightest - darkest > 150  # what it shows stands out from its ground


def test_maps_keep_their_colours_on_dark_pages(address, new_page):
    page = new_page(color_scheme="dark")
    page.goto(f"{address}atlas.html")
    filters = {
        name: page.locator(f"article img[src*='{name}']").evaluate("one => getComputedStyle(one).filter")
        for name in ("atlas-phase-plane", "atlas-mu-v0-sequence", "atlas-mu-v0-hop-height")
    }
    assert filters["atlas-phase-plane"] != "none"
    assert filters["atlas-mu-v0-sequence"] == filters["atlas-mu-v0-hop-height"] == "none"


def test_every_drawing_beside_the_pages_has_text_to_read(site):
    drawings = [path for path in (site / "_images").glob("*.svg") if "Matplotlib" in path.read_text(encoding="utf-8")]
    assert len(drawings) > 30
    small = [path.name for path in drawings if min(text_sizes(path.read_text(encoding="utf-8")), default=9.0) < 8.95]
    assert [name for name in small if "thumb" not in name] == []


MEDIA = 16  # MSO_SHAPE_TYPE of a film
PAPER = 718  # A4 less its margins, in pixels
STICKS_OUT = """() => [...document.querySelectorAll('article *, section *')].filter(
  element => element.getClientRects().length && element.getBoundingClientRect().right > innerWidth + 0.5
    && !element.closest('math, video')).map(element => element.tagName + ' ' + element.textContent.trim().slice(0, 40))"""


TEACHING = ["worksheet", "solutions", "exercises", "lesson-45", "lesson-90", "build", "slides/index"]


def test_pages_fit_on_paper(site, new_page, address):
    """Pictures, tables and code of all pages, and all of those for teaching, with boxes open and folded."""
    page = new_page(viewport={"width": PAPER, "height": 1000})
    page.emulate_media(media="print")
    for file in sorted(site.rglob("*.html")):
        name = file.relative_to(site).as_posix()
        if name.startswith(("play/", "_")):
            continue
        page.goto(address + name)
        teaching = name.removeprefix("teach/").removesuffix(".html") in TEACHING
        wide = page.evaluate(STICKS_OUT)
        assert [words for words in wide if teaching or re.match("TABLE|PRE|IMG|VIDEO|DIV", words)] == [], name
        if teaching:
            assert not any(box.is_visible() for box in page.locator("details, .skip-to-content").all()), name
            page.evaluate("document.querySelectorAll('details').forEach(box => { box.open = true; })")
            assert all(box.is_visible() for box in page.locator("details").all()), name
            assert page.evaluate(STICKS_OUT) == [], name


def test_slides_and_worksheet_are_there_to_hand_out(site):
    pptx = pytest.importorskip("pptx")
    folder = site / "teach"
    shown = pptx.Presentation(str(folder / "slides" / "slides.pptx"))
    media = [[shape for shape in slide.shapes if shape.shape_type == MEDIA] for slide in shown.slides]
    page = (folder / "slides" / "index.html").read_text(encoding="utf-8")
    assert len(media) == page.count("<section>") == 10
    assert sum(map(len, media)) == page.count("<video") == 4
    for name, sheets in (("slides/slides.pdf", 10), ("worksheet.pdf", 2)):
        assert len(re.findall(rb"/Type /Page\b", (folder / name).read_bytes())) == sheets, name


@pytest.mark.parametrize("width", [1280, 1920])
def test_slides_fit_on_the_screen_and_answer_on_demand(address, new_page, width):
    page = new_page(viewport={"width": width, "height": width * 9 // 16})
    page.goto(f"{address}teach/slides/index.html")
    page.wait_for_function("() => [...document.querySelectorAll('video')].every(film => film.readyState)")
    heights = page.evaluate("[...document.querySelectorAll('section')].map(slide => slide.scrollHeight)")
    assert set(heights) == {width * 9 // 16}
    box = page.locator("section:nth-of-type(2) details")
    assert not box.locator("p").is_visible()
    box.locator("summary").press(" ")
    assert box.locator("p").inner_text() == "At 312°, on the way up."


def test_what_moves_is_drawn_on_paper(address, new_page):
    page = new_page(viewport={"width": PAPER, "height": 1000})
    page.goto(f"{address}learn/hops-for-ever.html")
    drawn = page.locator("img.on-paper-only")
    assert not drawn.is_visible()
    page.emulate_media(media="print")
    assert drawn.is_visible()
    page.wait_for_function("document.querySelector('img.on-paper-only').naturalWidth > 100")
    assert not page.locator("hophoop-motion").is_visible()


def test_every_example_of_the_gallery_shows_something_also_on_paper(site):
    pages = sorted((site / "gallery").rglob("plot_*.html"))
    assert len(pages) > 30
    for page in pages:
        body = page.read_text(encoding="utf-8").split("<article", 1)[1]
        assert re.search("<img [^>]*sphx_glr_plot", body), page
        if "<video" in body:  # on paper there is a picture of it
            assert re.search(r'<video class="on-paper-not".*<img [^>]*class="[^"]*on-paper-only', body, re.DOTALL), page


PAGES = [
    "index",
    "learn/first-hop",
    "learn/why",
    "learn/real-hoop",
    "model",
    "howto/commands",
    "gallery/index",
    "teach/slides/index",
]


@pytest.mark.parametrize("name", [f"{page}.html" for page in PAGES])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(site, new_page, address, name, scheme):
    assert serious(new_page, address + name, scheme) == []


@pytest.mark.skipif("HOPHOOP_REPORT" not in os.environ, reason="HOPHOOP_REPORT names no report of hophoop reproduce")
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious_in_the_report(new_page, scheme):
    assert serious(new_page, Path(os.environ["HOPHOOP_REPORT"]).resolve().as_uri(), scheme) == []


def serious(new_page, address, scheme="light"):
    """Rules that axe-core finds broken, of serious or critical impact, each with an element that breaks it."""
    if "HOPHOOP_AXE" not in os.environ:
        pytest.skip("HOPHOOP_AXE names no axe.min.js (npm install axe-core)")
    page = new_page(color_scheme=scheme)
    page.goto(address)
    page.wait_for_load_state("networkidle")
    return [found for found in accessible(page) if found[0] in ("serious", "critical")]


def test_the_lab_beside_the_pages_computes(address, new_page):
    page = new_page()
    foreign = []
    page.on("request", lambda request: request.url.startswith((address, "data:", "blob:")) or foreign.append(request.url))
    page.goto(f"{address}play/index.html?start.speed=3.1")
    page.wait_for_selector("[data-ready]", timeout=60_000)
    page.wait_for_function("() => globalThis.hophoopLab?.film()?.sequence?.startsWith('RKRSH')", timeout=60_000)
    assert foreign == []
