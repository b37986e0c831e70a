"""Why sequential impulses let go too early: the iteration alone, against pymunk and against its own condition."""

import math

import pytest
import sequential_impulses as impulses
from measures import measure
from truth import truths

TASK = truths()["hop"].task


def test_the_sweeps_stop_settling_where_the_formula_says():
    # for the ideal hoop and μ = 1, r = 1 is γ (abs(sin θ) + cos θ) = 1
    edge = 2.0 * math.pi - (0.25 * math.pi + math.acos(1.0 / (0.75 * math.sqrt(2.0))))
    assert impulses.settles(TASK, edge) == pytest.approx(1.0, abs=1e-12)
    assert impulses.settles(TASK, edge - 0.01) < 1.0 < impulses.settles(TASK, edge + 0.01)


@pytest.mark.parametrize("sweeps", [10, 11])
def test_pymunk_is_this_iteration(sweeps):
    pytest.importorskip("pymunk")
    from adapters.pymunk import run

    theirs = measure(TASK, run(TASK, 2e-4, iterations=sweeps))
    ours = measure(TASK, impulses.run(TASK, 2e-4, sweeps, impulses.together))
    assert ours.hop_height == pytest.approx(theirs.hop_height, abs=3e-3)
    assert ours.penetration == pytest.approx(theirs.penetration, rel=0.1, abs=1e-4)
