"""The (θ, θ̇) plane on the page: it is finer where it is zoomed, and whole again when asked."""

import pytest

from lab_page_tools import wait_for


def hatched(page, turning):
    """Share of the columns of (0, π) that are hatched below (0) or above (1) θ̇ = 0."""
    return page.evaluate(
        """(turning) => {
          const { paradox } = hophoopLab.phase.pictures[0];
          const columns = paradox.length / 2;
          const half = paradox.slice(turning * columns, turning * columns + columns / 2);
          return half.filter((side) => side !== 0).length / half.length;
        }""",
        turning,
    )


@pytest.mark.parametrize(("couple", "below", "above"), [(0.0, 0.085, 0.085), (0.1, 0.0, 0.186)])
def test_the_paradox_is_hatched_with_the_couple_of_rolling_resistance(visit, couple, below, above):
    page = visit(f"?hoop.load_fraction=0.75&plane.mu=0.9&plane.rolling_resistance={couple}")
    wait_for(page, "lab.phase.pictures?.length === 1 && lab.phase.films && !lab.surrounding")
    assert hatched(page, 0) == pytest.approx(below, abs=0.01)
    assert hatched(page, 1) == pytest.approx(above, abs=0.01)
    assert page.evaluate("!hophoopLab.phase.hatched.hidden")
