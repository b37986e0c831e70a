"""Slides and worksheet as files to hand out: PDF, and PowerPoint with a picture, the film and the words of each slide.

Chromium makes them from the pages; where there is none, the build goes on without them.
"""

from __future__ import annotations

import io
import shutil
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Locator, Page, sync_playwright
from pptx import Presentation
from pptx.util import Emu
from sphinx.util import logging

CHROMIUM = (
    *("chromium", "chromium-browser", "google-chrome", "chrome", "msedge", "microsoft-edge"),
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
)
SIZE = {"width": 1280, "height": 720}
MARGIN: Any = dict.fromkeys(("top", "right", "bottom", "left"), "14mm")
PIXEL = 9525  # EMU, at 96 pixels an inch
# what a picture of a slide does not show: its film, which lies above it, and what is opened on demand
PLAIN = "video { visibility: hidden } details, footer { display: none } html { scroll-snap-type: none }"
# the words of a section, a line each; formulas as one word, answers too
WORDS = """section => [...section.querySelectorAll('h1, h2, p, li, tr, .formula')].map(line => {
  const parts = line.cells ? [...line.cells] : [line];
  return parts.map(part => part.textContent.trim()).join(': ');
}).join('\\n')"""
# each film stands still at an instant that shows something
STILL = """() => Promise.all([...document.querySelectorAll('video')].map(film => new Promise(resolve => {
  film.removeAttribute('controls');
  film.pause();
  film.play = () => Promise.resolve();
  film.preload = 'auto';
  film.onseeked = resolve;
  const seek = () => { film.currentTime = 0.6 * film.duration; };
  if (film.readyState) seek(); else film.onloadedmetadata = seek;
})))"""
log = logging.getLogger(__name__)


def opened(browser: Browser, page: Path) -> Page:
    """A page with its font, and its films at rest."""
    shown = browser.new_page(viewport=SIZE, color_scheme="light", device_scale_factor=2)
    shown.goto(page.resolve().as_uri())
    shown.evaluate("document.fonts.ready")
    shown.evaluate(STILL)
    return shown


def pdf(browser: Browser, page: Path, out: Path) -> None:
    """Print a page as its style sheet has it for paper."""
    shown = opened(browser, page)
    shown.pdf(
        path=str(out), format="A4", prefer_css_page_size=True, margin=dict.fromkeys(("top", "right", "bottom", "left"), "14mm")
    )
    shown.close()


def powerpoint(browser: Browser, page: Path, out: Path) -> None:
    """Make a presentation of the sections of a page; their films lie next to it."""
    shown = opened(browser, page)
    made = Presentation()
    made.slide_width, made.slide_height = (Emu(SIZE[name] * PIXEL) for name in ("width", "height"))
    for section in shown.locator("section").all():
        add_slide(made, section, page.parent)
    made.save(str(out))
    shown.close()


def add_slide(made: Any, section: Locator, folder: Path) -> None:
    """Add the slide of a section."""
    slide = made.slides.add_slide(made.slide_layouts[6])  # an empty one
    words = section.evaluate(WORDS)
    section.scroll_into_view_if_needed()
    film = section.locator("video")
    first = film.screenshot() if film.count() else b""
    style = section.page.add_style_tag(content=PLAIN)
    corner = section.bounding_box()
    picture = slide.shapes.add_picture(io.BytesIO(section.screenshot()), 0, 0, made.slide_width, made.slide_height)
    picture._element.nvPicPr.cNvPr.set("descr", words)
    if film.count() and corner:
        box = film.bounding_box()
        place = [Emu(round(PIXEL * box[name])) for name in ("width", "height")] if box else []
        left, top = (Emu(round(PIXEL * (box[name] - corner[name]))) for name in ("x", "y")) if box else (0, 0)
        source = folder / (film.get_attribute("src") or "")
        slide.shapes.add_movie(str(source), left, top, *place, poster_frame_image=io.BytesIO(first), mime_type="video/mp4")
    style.evaluate("style => style.remove()")
    slide.notes_slide.notes_text_frame.text = words


def after_the_pages(app: Any, error: Exception | None) -> None:
    """Make them next to the pages that link to them."""
    if error is not None or app.builder.name != "html":
        return
    chromium = next((found for name in CHROMIUM if (found := shutil.which(name))), None)
    if chromium is None:
        log.info("Slides and worksheet are not made as PDF and PowerPoint: there is no Chromium.")
        return
    teach = Path(app.outdir) / "teach"
    slides = teach / "slides" / "index.html"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        pdf(browser, slides, slides.parent / "slides.pdf")
        powerpoint(browser, slides, slides.parent / "slides.pptx")
        pdf(browser, teach / "worksheet.html", teach / "worksheet.pdf")
        browser.close()


def setup(app: Any) -> dict[str, Any]:
    """When slides and pages are written."""
    app.connect("build-finished", after_the_pages, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
