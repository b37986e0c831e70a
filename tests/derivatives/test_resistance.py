"""Derivatives with rolling resistance: what is known of them beside test_events.py, which goes through all events."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.layout import REASONS, Reason
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from oracles.derivatives import RESISTANCE, one_sided

pytestmark = pytest.mark.usefixtures("interpreted")


SMALL = 2.0**-26
ROCKS = hh.Scenario.from_query("duration=2&hoop.load_fraction=0.5&start.angle=2&start.speed=0.3")
HELD = hh.Scenario(
    plane=hh.Plane(slope=0.1, mu=0.5, rolling_resistance=0.1), start=hh.Start.rolling(0.0, angle=3.0), duration=2.0
)  # fmt: skip


@pytest.mark.parametrize(
    ("scenario", "path", "side", "of"),
    [
        (ROCKS, RESISTANCE, 1.0, ["turn.t", "turn.x", "end.omega", "end.x"]),  # that there is some at all
        # a push along its way, and against it
        pytest.param(HELD, "start.speed", 1.0, ["rest.t", "rest.angle", "end.x"], marks=pytest.mark.long),
        pytest.param(HELD, "start.speed", -1.0, ["rest.t", "rest.angle", "end.x"], marks=pytest.mark.long),
    ],
)
def test_derivatives_to_one_side(scenario, path, side, of):
    result = hh.sensitivity(scenario, of, path)
    found = (result.larger if side > 0 else result.smaller)[:, 0]
    assert found == pytest.approx(one_sided(scenario, path, side * SMALL, of), rel=1e-9, abs=1e-9)
    if path == RESISTANCE:
        assert result.reasons == ((EDGE,),) * len(of)
        assert np.isnan(result.smaller).all()
    else:
        assert SIDED in {reason for row in result.reasons for reason in row}


def test_the_edge_of_rest():
    """Where the couple is just enough to hold the hoop, or just not, the least change decides which."""
    angle = math.pi - math.asin(0.05 / 0.75)
    plane = hh.Plane(rolling_resistance=0.05)
    result = hh.sensitivity(
        hh.Scenario(plane=plane, start=hh.Start.rolling(0.0, angle=angle), duration=1.0),
        "end.angle",
        ["start.angle", RESISTANCE],
    )
    assert set(result.reasons[0]) == {REASONS[Reason.BORDER]}
    inside = hh.Scenario(plane=plane, start=hh.Start.rolling(0.0, angle=angle + 1e-3), duration=1.0)
    assert hh.simulate(inside).status == "at_rest"
    result = hh.sensitivity(inside, "end.angle", ["start.angle", RESISTANCE, "hoop.load_fraction", "start.speed"])
    assert result.derivatives[0].tolist() == [1.0, 0.0, 0.0, 0.0]  # a small push is stopped at once
