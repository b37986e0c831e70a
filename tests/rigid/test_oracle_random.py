"""Random hoops, planes and starts: the program against SciPy's hybrid integration, event by event."""

import pytest

from oracle_program import compare, draw


@pytest.mark.parametrize("block", [0, *(pytest.param(block, marks=pytest.mark.slow) for block in range(1, 33))])
def test_random_motions(block):
    """Fifteen scenarios in every run; hundreds with -m slow."""
    for seed in range(15 * block, 15 * block + 15):
        compare(draw(seed))
