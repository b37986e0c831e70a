"""Files and films that the served page keeps."""

import numpy as np
import pytest

import hophoop as hh


def test_it_is_kept(visit, tmp_path):
    page = visit("?start.speed=2.5")

    def kept(item):
        page.locator(".menu summary").click()
        with page.expect_download() as download:
            page.get_by_role("button", name=item).click()
        return download.value.path().read_bytes()

    assert hh.Scenario.loads(kept("Save the scenario (TOML)").decode()) == hh.Scenario(start=hh.Start.rolling(2.5))
    assert kept("Save a picture (PNG)")[:8] == b"\x89PNG\r\n\x1a\n"
    assert kept("Save the states (CSV)").startswith(b"t [s],")
    page.keyboard.press("p")
    page.locator(".code-dialog[open]").wait_for()
    assert "hh.Start.rolling(speed=2.5)" in page.locator(".code-dialog pre").first.inner_text()
    page.keyboard.press("Escape")


def decoded(block, name, folder):
    """Size and frames of a film."""
    pytest.importorskip("av", reason="the extra 'films' is not installed")
    import animate_tools

    path = folder / name
    path.write_bytes(block)
    shown, _ = animate_tools.decoded(path)
    return shown.shape[2:0:-1], shown


@pytest.mark.long
def test_a_film_is_made_by_the_server(visit, tmp_path):
    page = visit("?duration=0.4")
    page.locator(".menu summary").click()
    with page.expect_download(timeout=120_000) as download:
        page.get_by_role("button", name="Save a film (MP4)").click()
    size, shown = decoded(download.value.path().read_bytes(), "film.mp4", tmp_path)
    assert size == (960, 540)
    assert len(shown) in (10, 11)  # 25 a second
    assert np.abs(shown[0].astype(int) - shown[-1]).max() > 80
