"""What the page lets a visitor keep: pictures larger than the screen, and films recorded by the browser."""

import io
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from lab_page_tools import wait_for

Image = pytest.importorskip("PIL.Image")

TWO = "?duration=0.6#t=0.3&with=start.speed%3D2.5%26duration%3D0.6"


def kept(page, name, path):
    """What an item of the menu saves."""
    page.locator(".menu summary", has_text="Share").click()
    with page.expect_download() as download:
        page.get_by_role("button", name=name).click()
    download.value.save_as(path)
    return path


def on_screen(page):
    """The stage as it is, with the words that pictures have."""
    shot = page.locator(".stage canvas:not([hidden])").screenshot()
    return Image.open(io.BytesIO(shot)).convert("RGB")


def difference(one, other):
    """Mean difference of two pictures below the words, of 255, both at a quarter of the size on the screen."""
    size = (other.width // 4, other.height // 4)
    a, b = (picture.convert("RGB").resize(size, Image.Resampling.BOX) for picture in (one, other))
    return np.abs(np.subtract(a, b, dtype=float))[20:, 40:-40].mean()


@pytest.mark.long
def test_a_picture_in_space_has_more_pixels_too_and_the_screen_keeps_its_own(visit, tmp_path):
    page = visit("?duration=1#t=0.5&show=tfc3&from=-0.5,0.31,6", viewport={"width": 1440, "height": 540})
    wait_for(page, "!lab.surrounding && lab.stage.options.three")
    assert "&from=-0.5,0.31,6&" in page.evaluate("hophoopLab.link()")
    before = page.evaluate("hophoopLab.stage.canvas().width")
    picture = Image.open(kept(page, "Save a picture (PNG)", tmp_path / "space.png"))
    assert picture.width == 3840
    assert difference(picture, on_screen(page)) < 4.0
    assert page.evaluate("hophoopLab.stage.canvas().width") == before
    page.locator(".menu summary", has_text="Share").click()
    page.get_by_role("button", name="Save a picture (SVG)").click()
    page.wait_for_selector("text=SVG works in 2D only")


@pytest.mark.long
def test_pictures_are_what_the_screen_shows(visit, new_page, tmp_path):
    """Of more pixels than the screen has, and of lines."""
    page = visit(TWO)
    wait_for(page, "!lab.surrounding && lab.films().length === 2")
    screen = on_screen(page)
    large = Image.open(kept(page, "Save a picture (PNG)", tmp_path / "hoop.png"))
    assert large.width == 3840
    assert difference(large, screen) < 3.0
    # drawn at that size, not blown up: an edge of the ring is a few pixels wide
    assert np.abs(np.diff(np.asarray(large.convert("L"), float), axis=1)).max() > 100
    path = kept(page, "Save a picture (SVG)", tmp_path / "hoop.svg")
    root = ElementTree.parse(path).getroot()
    words = "".join(root.itertext())
    assert "A: " in words
    assert "t = 0.300 s" in words
    reader = new_page(viewport={"width": screen.width, "height": screen.height})
    reader.goto(path.as_uri())
    assert difference(Image.open(io.BytesIO(reader.screenshot())), screen) < 3.0


def test_a_film_of_two_hoops_is_recorded_in_the_browser(visit, tmp_path):
    pytest.importorskip("av")
    from animate_tools import decoded

    page = visit(TWO, viewport={"width": 1000, "height": 700})
    wait_for(page, "!lab.surrounding && lab.films().length === 2")
    film = kept(page, "Record one run as a film", tmp_path / "hoop")
    head = film.read_bytes()[:12]
    assert (
        b"ftyp" in head
        if page.evaluate("MediaRecorder.isTypeSupported('video/mp4;codecs=avc1')")
        else head[:4] == b"\x1aE\xdf\xa3"
    )
    pictures = decoded(film)[0].astype(float)
    height = pictures.shape[1]
    assert len(pictures) >= 5
    first, last = pictures[0], pictures[-1]
    for part in (slice(30, height // 2), slice(height // 2 + 30, height)):  # A above, B below; both move
        assert np.abs(first[part] - last[part]).mean() > 2.0
    wait_for(page, "!lab.clock.playing && lab.afterFrame === null")
