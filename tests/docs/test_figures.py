"""The figures of the model's page show what the model says."""

import math
import re
import runpy
import sys
import tomllib
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

import hophoop as hh
from hophoop.article.inks import for_both
from page_tools import text_sizes

ROOT = Path(__file__).parents[2]
FIGURES = runpy.run_path(str(ROOT / "examples" / "model_figures.py"))


@pytest.mark.parametrize("degrees", [30.0, 200.0, 240.0])
def test_the_lines_cross_at_the_rolling_force(degrees):
    angle = math.radians(degrees)
    omega = float(hh.theory.rolling_speed(angle, FIGURES["HOOP"], v0=FIGURES["SPEED"]))
    forces = hh.theory.rolling_forces(angle, FIGURES["HOOP"], v0=FIGURES["SPEED"])
    assert FIGURES["rolling_force"](angle, omega) == pytest.approx([forces.friction, forces.normal], rel=1e-12)


def test_the_three_states_are_what_their_titles_say():
    hoop, plane = FIGURES["HOOP"], FIGURES["PLANE"]
    share = [
        abs(float(hh.theory.friction_utilization(math.radians(degrees), hoop, v0=FIGURES["SPEED"], plane=plane)))
        for degrees in (30.0, 240.0)
    ]
    assert share[0] < 1.0 < share[1]
    motion = hh.simulate(hoop, plane, hh.Start(angle=math.radians(-45.0), vx=1.0, omega=0.0), duration=0.01)
    assert motion.find("painleve_inconsistent")


def test_the_line_never_meets_the_edge_of_a_skid():
    angle = math.radians(-45.0)
    matrix, free = FIGURES["contact_matrix"](angle), FIGURES["free_acceleration"](angle, 0.0)
    normal = np.linspace(0.0, 1e3, 101)
    assert np.all(free[1] + matrix[1, 1] * normal - matrix[0, 1] * normal < 0.0)


def test_the_kept_figures_are_those_that_are_drawn(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["model_figures.py", str(tmp_path)])
    FIGURES["main"]()
    drawn = {path.name: path for path in tmp_path.iterdir()}
    assert sorted(drawn) == ["contact-space.svg", "model-body.svg", "painleve-push.svg"]
    for name in drawn:
        assert (ROOT / "docs" / "figures" / name).exists()


DRAWINGS = [
    path for path in sorted((ROOT / "docs" / "figures").glob("*.svg")) if "Matplotlib" in path.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("path", DRAWINGS, ids=lambda path: path.stem)
def test_a_drawing_has_colours_for_dark_pages(path):
    made = for_both(path.read_text(encoding="utf-8"))
    ElementTree.fromstring(made)
    assert "prefers-color-scheme:dark" in made
    assert not re.search(r"(fill|stroke): ?#", re.sub(r"<style>.*?</style>|<defs>.*?</defs>", "", made, flags=re.DOTALL))


@pytest.mark.parametrize("path", DRAWINGS, ids=lambda path: path.stem)
def test_the_text_of_a_drawing_can_be_read(path):
    sizes = text_sizes(path.read_text(encoding="utf-8"))
    assert sizes
    assert min(sizes) >= 8.95


def test_small_text_is_found():
    assert text_sizes('<svg height="3pt" width="1104pt"><g transform="scale(0.08 -0.08)">') == pytest.approx([5.33], abs=0.01)


def test_colours_of_classes_are_the_same_on_dark_pages():
    """In the field, which is a picture, and beside it, where they are drawn."""
    text = (ROOT / "docs" / "figures" / "atlas-mu-v0-sequence.svg").read_text(encoding="utf-8")
    named = re.findall(r'<g id="on-color-legend-(\w+)">', text)
    assert named[:3] == ["R", "H", "RKRSR"]
    assert len(named) == 16


PAGES = runpy.run_path(str(ROOT / "examples" / "page_figures.py"))


def test_the_figures_of_pages_are_drawn_and_shown():
    shown = "".join(page.read_text(encoding="utf-8") for page in (ROOT / "docs").rglob("*.md"))
    for name in PAGES["FIGURES"]:
        assert (ROOT / "docs" / "figures" / name).exists()
        assert f"figures/{name})" in shown


def test_the_figure_of_friction_has_the_largest_one_at_its_dot(tmp_path, monkeypatch):
    figures = []
    monkeypatch.setitem(PAGES["draw_required_friction"].__globals__, "save", lambda figure, path: figures.append(figure))
    PAGES["draw_required_friction"](tmp_path / "a.svg")
    curves = {line.get_label(): line.get_ydata() for line in figures[0].axes[0].lines}
    assert np.nanmax(curves["0.1 m/s"]) == pytest.approx(0.378154, abs=1e-5)
    assert np.nanmax(curves["2 m/s"]) == pytest.approx(0.957454, abs=1e-5)
    assert np.nanmax(curves["2.5 m/s"]) > 1.0


def test_the_figure_of_phases_joins_at_its_events(tmp_path, monkeypatch):
    """The ends of a phase are near those of its neighbours, except at the landing."""
    figures = []
    monkeypatch.setitem(PAGES["draw_phases"].__globals__, "save", lambda figure, path: figures.append(figure))
    PAGES["draw_phases"](tmp_path / "a.svg")
    phases = [line.get_xydata() for line in figures[0].axes[0].lines if len(line.get_xydata()) > 2]
    steps = [abs(after[0, 1] - before[-1, 1]) for before, after in pairwise(phases)]
    assert len(phases) == 6
    assert max(steps[:4]) < 0.2
    assert steps[4] > 2.0


def test_the_figure_of_the_track_has_the_film_on_the_fitted_motion(tmp_path, monkeypatch):
    """Within 10 mrad, which the film's time of start, 2.4 ms, would exceed."""
    figures = []
    monkeypatch.setitem(PAGES["draw_track"].__globals__, "save", lambda figure, path: figures.append(figure))
    PAGES["draw_track"](tmp_path / "a.svg")
    fitted, film = (line.get_ydata() for line in figures[0].axes[0].lines)
    assert np.abs(np.radians(film - fitted[::4])).max() < 0.01


def test_the_figure_of_the_article_has_its_statements(tmp_path, monkeypatch):
    """Take-off and the angles of zero potential energy, as `hophoop reproduce` states them."""
    figures = []
    monkeypatch.setitem(PAGES["draw_article"].__globals__, "save", lambda figure, path: figures.append(figure))
    PAGES["draw_article"](tmp_path / "a.svg")
    gap, energy = figures[0].axes
    assert {text.get_text() for text in gap.texts} >= {"315.6°"}
    assert {text.get_text() for text in energy.texts} >= {"348.8°", "394.5°"}
    assert gap.lines[1].get_ydata().max() == pytest.approx(29.18481, abs=1e-4)
    assert energy.lines[1].get_ydata().max() == pytest.approx(0.418169, abs=1e-5)


def test_the_marked_frame_has_its_ring_around_the_red_marker(tmp_path):
    """The film's marker is red, and in the frame where the true motion has it."""
    pytest.importorskip("av")
    PAGES["draw_marked_frame"](tmp_path / "a.jpg")
    image = np.asarray(Image.open(tmp_path / "a.jpg").convert("RGB")).astype(int)
    red = np.argwhere((image[..., 0] > 150) & (image[..., 1:].max(axis=-1) < 100))
    cyan = np.argwhere((image[..., 1:].min(axis=-1) > 180) & (image[..., 0] < 90))
    assert len(red) > 50
    assert len(cyan) > 300
    hub = 0.5 * np.array(image.shape[:2])
    way = (red.mean(axis=0) - hub) * [-1.0, 1.0]
    truth = hh.simulate(hh.Scenario.load(PAGES["FILM"] / "truth.toml"))
    track = hh.read_track(PAGES["FILM"] / "track.json")
    angle = float(truth.at(track.t[118]).angle)
    assert math.atan2(way[1], way[0]) == pytest.approx(math.remainder(angle, 2.0 * math.pi), abs=0.05)
    assert np.hypot(*(cyan - red.mean(axis=0)).T).min() < 12.0


def test_the_picture_of_the_film_is_its_film_at_a_page_s_size(tmp_path):
    kept = ROOT / "docs" / "figures" / "film-frame.png"
    PAGES["draw_film"](tmp_path / "a.png")
    drawn, shown = (np.asarray(Image.open(path).convert("RGB")).astype(int) for path in (tmp_path / "a.png", kept))
    assert drawn.shape == (720, 1280, 3)
    assert np.mean(np.abs(drawn - shown).max(axis=-1) > 40) < 0.01
    assert kept.stat().st_size < 150_000


def test_the_map_of_the_code_has_the_order_of_the_contracts():
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
    layers = [re.findall(r"\w+", line) for contract in contracts[:2] for line in contract["layers"]]
    rank = {name: place for place, layer in enumerate(layers) for name in layer}
    drawn = [name for row in PAGES["CODE"] for name, _ in row if name in rank]
    assert [rank[name] for name in drawn] == sorted(rank[name] for name in drawn)
    assert set(rank) - set(drawn) <= {
        "__main__", "cite", "io", "kernel", "_support", "_version", "build", "entries", "numerics", "native",
    }  # fmt: skip
