"""What docs/atlas.md prints is what just those starts do."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from hophoop import maps

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "atlas.md").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def script():
    spec = importlib.util.spec_from_file_location("atlas", ROOT / "examples" / "figures" / "atlas.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def rows():
    for line in PAGE.splitlines():
        if line.startswith(("| highest", "| longest")):
            yield [cell.strip() for cell in line.strip("| ").split("|")]


def test_printed_optima_hop_as_printed(script):
    found = list(rows())
    assert len(found) == len(script.OPTIMA)
    for (what, hop, gamma, mu, part), (quantity, most_friction) in zip(found, script.OPTIMA, strict=True):
        assert what == f"{script.WORDS[quantity]}, μ up to {most_friction:g}"
        assert float(mu) <= most_friction
        assert float(part) < 1.0
        value = float(script.hops(quantity, float(gamma), float(mu), float(part)))
        assert f"{value:.3f} m" == hop
        # at the limit itself the hoop leaves the plane at once, and hardly
        limit = math.sqrt(9.81 / float(gamma))
        place = {"hoop.load_fraction": float(gamma), "plane.mu": float(mu), "start.speed": 1.000001 * limit}
        at_once = maps.points(None, place, ["hop_height", "sequence"])
        assert str(at_once["sequence"]) == "H"
        assert float(at_once["hop_height"]) < 1e-4


def test_printed_optima_are_no_worse_than_what_lies_about_them(script):
    rng = np.random.default_rng(3)
    for (_, hop, gamma, mu, part), (quantity, most_friction) in zip(rows(), script.OPTIMA, strict=True):
        gammas = np.clip(float(gamma) + rng.uniform(-0.03, 0.03, 3000), 0.01, 0.999)
        frictions = np.minimum(float(mu) * 10.0 ** rng.uniform(-0.3, 0.3, 3000), most_friction)
        parts = np.minimum(float(part) - 10.0 ** rng.uniform(-6.0, -2.0, 3000), 1.0 - 1e-9)
        assert np.nanmax(script.hops(quantity, gammas, frictions, parts)) < float(hop.split()[0]) + 1.5e-3


def test_a_row_of_a_short_search_is_that_of_its_start(script, monkeypatch):
    best = {"load_fraction": 0.80001, "mu": 0.5004, "part_of_immediate_hop": 0.99999951}
    monkeypatch.setattr(script, "best_hop", lambda quantity, most_friction: best)
    cells = [cell.strip() for cell in script.row_of("hop_height", 1.0).strip("| ").split("|")]
    assert cells[2:] == ["0.800", "0.5", "0.999999"]
    assert cells[1] == f"{float(script.hops('hop_height', 0.8, 0.5, 0.999999)):.3f} m"
