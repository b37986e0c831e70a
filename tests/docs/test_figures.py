"""The figures of the model's page show what the model says."""

import math
import runpy
import sys
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh

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
