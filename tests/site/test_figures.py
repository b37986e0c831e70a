"""The figures of pages show what the pages say. Drawn anew where pages are built, as some need a film or a fit."""

import math
import re
import runpy
import tomllib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import hophoop as hh
from checkout import ROOT, text_of

MODEL, PAGES = (runpy.run_path(str(ROOT / "examples" / "figures" / f"{name}.py")) for name in ("model", "pages"))
pytestmark = pytest.mark.usefixtures("site")


@pytest.fixture
def drawn(monkeypatch):
    """The axes of a figure of a page, by the name of the function that draws it."""

    def draw(name):
        figures = []
        monkeypatch.setitem(PAGES[name].__globals__, "save", lambda figure, path: figures.append(figure))
        PAGES[name](Path("a.svg"))
        return figures[0].axes

    return draw


def test_contact_space_is_that_of_theory():
    hoop, plane, speed = MODEL["HOOP"], MODEL["PLANE"], MODEL["SPEED"]
    for degrees, slips in ((30.0, False), (240.0, True)):  # the lines cross at the rolling force
        angle = math.radians(degrees)
        forces = hh.theory.rolling_forces(angle, hoop, v0=speed)
        found = MODEL["rolling_force"](angle, float(hh.theory.rolling_speed(angle, hoop, v0=speed)))
        assert found == pytest.approx([forces.friction, forces.normal], rel=1e-12)
        assert (abs(hh.theory.friction_utilization(angle, hoop, v0=speed, plane=plane)) > 1.0) == slips


def test_required_friction_is_largest_at_its_dot(drawn):
    curves = {line.get_label(): line.get_ydata() for line in drawn("draw_required_friction")[0].lines}
    assert np.nanmax(curves["0.1 m/s"]) == pytest.approx(0.378154, abs=1e-5)
    assert np.nanmax(curves["2 m/s"]) == pytest.approx(0.957454, abs=1e-5)


def test_the_film_is_on_the_fitted_motion(drawn):
    """Within 10 mrad, which the film's time of start, 2.4 ms, would exceed."""
    fitted, film = (line.get_ydata() for line in drawn("draw_track")[0].lines)
    assert np.abs(np.radians(film - fitted[::4])).max() < 0.01


def test_the_article_s_figure_has_its_statements(drawn):
    gap, energy = drawn("draw_article")
    assert {text.get_text() for text in (*gap.texts, *energy.texts)} >= {"315.6°", "348.8°", "394.5°"}
    assert gap.lines[1].get_ydata().max() == pytest.approx(29.18481, abs=1e-4)
    assert energy.lines[1].get_ydata().max() == pytest.approx(0.418169, abs=1e-5)


def test_the_marked_frame_has_its_ring_around_the_red_marker(tmp_path):
    PAGES["draw_marked_frame"](tmp_path / "a.jpg")
    image = np.asarray(Image.open(tmp_path / "a.jpg").convert("RGB")).astype(int)
    red = np.argwhere((image[..., 0] > 150) & (image[..., 1:].max(axis=-1) < 100)).mean(axis=0)
    cyan = np.argwhere((image[..., 1:].min(axis=-1) > 180) & (image[..., 0] < 90))
    assert np.hypot(*(cyan - red).T).min() < 12.0


def test_the_map_of_the_code_has_the_order_of_the_contracts():
    contracts = tomllib.loads(text_of("pyproject.toml"))["tool"]["importlinter"]["contracts"]
    layers = [re.findall(r"\w+", line) for contract in contracts[:2] for line in contract["layers"]]
    rank = {name: place for place, layer in enumerate(layers) for name in layer}
    ranks = [rank[name] for row in PAGES["CODE"] for name, _ in row if name in rank]
    assert len(ranks) > 20
    assert ranks == sorted(ranks)
