"""The figures of pages show what the pages say. Drawn anew where pages are built, as some need a film or a fit."""

import math
import re
import runpy
import tomllib
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import hophoop as hh

ROOT = Path(__file__).parents[2]
MODEL, PAGES = (runpy.run_path(str(ROOT / "examples" / f"{name}_figures.py")) for name in ("model", "page"))
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
    for degrees in (30.0, 200.0, 240.0):  # the lines cross at the rolling force
        angle = math.radians(degrees)
        forces = hh.theory.rolling_forces(angle, hoop, v0=speed)
        found = MODEL["rolling_force"](angle, float(hh.theory.rolling_speed(angle, hoop, v0=speed)))
        assert found == pytest.approx([forces.friction, forces.normal], rel=1e-12)
    rolls, slips = (hh.theory.friction_utilization(math.radians(angle), hoop, v0=speed, plane=plane) for angle in (30.0, 240.0))
    assert abs(rolls) < 1.0 < abs(slips)
    angle, normal = math.radians(-45.0), np.linspace(0.0, 1e3, 101)  # the line never meets the edge of a skid
    matrix, free = MODEL["contact_matrix"](angle), MODEL["free_acceleration"](angle, 0.0)
    assert np.all(free[1] + matrix[1, 1] * normal - matrix[0, 1] * normal < 0.0)
    start = hh.Start(angle=angle, vx=1.0, omega=0.0)
    assert hh.simulate(hoop, plane, start, duration=0.01).find("painleve_inconsistent")


def test_colours_of_classes_are_the_same_on_dark_pages():
    """In the field, which is a picture, and beside it, where they are drawn."""
    text = (ROOT / "docs" / "figures" / "drawn" / "atlas-mu-v0-sequence.svg").read_text(encoding="utf-8")
    named = re.findall(r'<g id="on-color-legend-(\w+)">', text)
    assert named[:3] == ["R", "H", "RKRSR"]
    assert len(named) == 16


def test_required_friction_is_largest_at_its_dot(drawn):
    curves = {line.get_label(): line.get_ydata() for line in drawn("draw_required_friction")[0].lines}
    assert np.nanmax(curves["0.1 m/s"]) == pytest.approx(0.378154, abs=1e-5)
    assert np.nanmax(curves["2 m/s"]) == pytest.approx(0.957454, abs=1e-5)


def test_phases_join_at_their_events_except_at_the_landing(drawn):
    phases = [line.get_xydata() for line in drawn("draw_phases")[0].lines if len(line.get_xydata()) > 2]
    steps = [abs(after[0, 1] - before[-1, 1]) for before, after in pairwise(phases)]
    assert len(phases) == 6
    assert max(steps[:4]) < 0.2
    assert steps[4] > 2.0


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
    """The film's marker is red, and in the frame where the true motion has it."""
    PAGES["draw_marked_frame"](tmp_path / "a.jpg")
    image = np.asarray(Image.open(tmp_path / "a.jpg").convert("RGB")).astype(int)
    red = np.argwhere((image[..., 0] > 150) & (image[..., 1:].max(axis=-1) < 100))
    cyan = np.argwhere((image[..., 1:].min(axis=-1) > 180) & (image[..., 0] < 90))
    way = (red.mean(axis=0) - 0.5 * np.array(image.shape[:2])) * [-1.0, 1.0]
    truth = hh.simulate(hh.Scenario.load(PAGES["FILM"] / "truth.toml"))
    angle = float(truth.at(hh.read_track(PAGES["FILM"] / "track.json").t[118]).angle)
    assert math.atan2(way[1], way[0]) == pytest.approx(math.remainder(angle, 2.0 * math.pi), abs=0.05)
    assert np.hypot(*(cyan - red.mean(axis=0)).T).min() < 12.0


def test_the_map_of_the_code_has_the_order_of_the_contracts():
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
    layers = [re.findall(r"\w+", line) for contract in contracts[:2] for line in contract["layers"]]
    rank = {name: place for place, layer in enumerate(layers) for name in layer}
    names = [name for row in PAGES["CODE"] for name, _ in row if name in rank]
    assert [rank[name] for name in names] == sorted(rank[name] for name in names)
    assert set(rank) - set(names) <= {
        "__main__", "cite", "io", "kernel", "_support", "_version", "build", "entries", "numerics", "native",
    }  # fmt: skip
