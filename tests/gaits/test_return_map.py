"""The one-dimensional return map against single motions."""

import math

import pytest

import hophoop as hh
from slopes import on_slope


@pytest.mark.parametrize("degrees", [1.0, 10.0, -4.0])
def test_the_map_is_that_of_single_motions(degrees):
    ends = sorted(math.copysign(size, degrees) for size in (3.0, 3.8))
    found = hh.gaits.return_map(on_slope(degrees), *ends, 60)
    for piece in found.pieces:
        for place in {0, len(piece.omega) // 2, len(piece.omega) - 1}:
            omega = float(piece.omega[place])
            motion = hh.passages(on_slope(degrees, omega=omega), 1)
            assert motion.sequences == (piece.sequence,)
            assert motion.omega[0] == pytest.approx(piece.after[place], rel=1e-9)
            assert found(omega) == pytest.approx(piece.after[place], rel=1e-9)


def test_pieces_meet_in_corners_and_jumps():
    """The sequence changes from one double to the next; at a corner the map does not."""
    found = hh.gaits.return_map(on_slope(1.0), 3.0, 3.8)
    assert [piece.sequence for piece in found.pieces] == ["RKR", "RSRKR", "RSHSRKR", "RSHRKR", "RSHKR", "RSHR", "RSHR"]
    assert [end.kind for end in found.ends] == ["corner"] * 5 + ["jump"]
    jump = found.ends[-1].omega
    assert found(jump) > 2.0
    assert found(jump + 1e-9) < -2.0
    corner = found.ends[3].omega
    assert abs(found(corner + 1e-9) - found(corner - 1e-9)) < 1e-8
    assert "7 pieces from 3 to 3.8 rad/s, 5 corners, 1 jumps" in repr(found)


def test_a_hoop_that_is_fast_at_the_bottom():
    """With γ = 0.999 it gets over the top from 31.6 √(g/R) on: the default range is above."""
    plane = hh.Plane(slope=math.radians(3), gravity=1.0)
    pieces = hh.gaits.return_map(hh.Scenario(hoop=hh.Hoop.ideal(0.999), plane=plane), points=20).pieces
    assert math.sqrt(2 * 0.999 / 0.002) == pytest.approx(31.6, abs=0.1)
    assert 31.5 < pieces[0].omega[0] < pieces[-1].omega[-1] <= 64.0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((3.0, 2.0), "low = 3.0 and high = 2.0 must be finite"),
        ((3.0, math.inf), "must be finite"),
        ((3.0, 3.5, 1), "points = 1 must be an integer from 2"),
    ],
)
def test_refusals(arguments, message):
    with pytest.raises(ValueError, match=message):
        hh.gaits.return_map(on_slope(1.0), *arguments)


def test_the_picture():
    pytest.importorskip("matplotlib")
    found = hh.gaits.return_map(on_slope(4.0), 3.0, 3.6, 50)
    ax = hh.plots.return_map(found, start=3.4, passages=20, skip=3)
    steps = ax.lines[1].get_xydata()
    assert len(steps) == 40
    assert steps[1, 1] == pytest.approx(found(steps[0, 0]))
    assert steps[2, 0] == steps[1, 1]
    assert "rad/s" in ax.get_xlabel()
    with pytest.raises(ValueError, match="passages = 0 must be"):
        hh.plots.return_map(found, passages=0)
