"""A page's motion has a drawing for paper, where nothing moves."""

import re
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from PIL import Image

pytest.importorskip("sphinx", reason="the extra 'docs' is not installed")
sys.path.insert(0, str(Path(__file__).parents[2] / "docs" / "_ext"))
import play

QUERY = "start.speed=3.1&duration=2"


def test_a_motion_has_its_drawing_for_paper(tmp_path):
    builder = SimpleNamespace(
        outdir=tmp_path, imagedir="_images", current_docname="learn/first-hop", get_target_uri=lambda page: f"{page}.html"
    )
    writer = SimpleNamespace(builder=builder, body=[], context=[])
    play.visit_live(writer, play.live(query=QUERY))
    play.depart_live(writer, play.live(query=QUERY))
    html = "".join(writer.body)
    assert html.count("<div") == html.count("</div>") == 2
    source = re.search(r'<img class="on-paper-only"[^>]* src="\.\./(.+?)"', html)[1]
    with Image.open(tmp_path / source) as drawing:
        assert drawing.width > 900
    assert (tmp_path / source).stat().st_size < 80_000  # a page loads it before it is printed
    # what moves, and what is clicked, is not for paper
    assert re.search(r'on-paper-not">\s*<hophoop-motion', html)
    assert re.search(r'on-paper-not">\s*<a', html)


def test_two_motions_have_two_drawings(tmp_path):
    names = [play.draw_still(tmp_path, query) for query in (QUERY, "start.speed=2&duration=2", QUERY)]
    assert names[0] == names[2] != names[1]
    assert len(list(tmp_path.iterdir())) == 2
