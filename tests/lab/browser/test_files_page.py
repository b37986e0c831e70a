"""Files and films that the served page keeps."""

import numpy as np
import pytest

import hophoop as hh
from lab_page_tools import follow


def test_it_is_kept(visit):
    page = visit("?start.speed=2.5")
    follow(page, [
        "click .menu summary",
        "save Save a picture (PNG)",
        "is kept.startsWith('\\x89PNG\\r\\n\\x1a\\n')",
        "click .menu summary",
        "save Save the states (CSV)",
        "is kept.startsWith('t [s],')",
        "press p",
        "until text('.code-dialog[open] pre').includes('hh.Start.rolling(speed=2.5)')",
        "press Escape",
        "click .menu summary",
        "save Save the scenario (TOML)",
    ])  # fmt: skip
    assert hh.Scenario.loads(page.evaluate("kept")) == hh.Scenario(start=hh.Start.rolling(2.5))


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
