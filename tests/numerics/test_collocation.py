"""Panels' arithmetic against NumPy's: sums, exponentials, extremes, roots, widths."""

import numpy as np
import pytest
from numpy.polynomial import chebyshev

from hophoop.kernel.numerics import collocation as col
from hophoop.kernel.numerics import collocation as search
from hophoop.kernel.panels import panel


@pytest.mark.parametrize("size", [1e-8, 0.3, 1.0, 1.001, 20.0])
def test_exponentials(size):
    """Both ways, by the series up to 1 and by the library above, to a few roundings."""
    values = size * np.concatenate((np.random.default_rng(3).uniform(-1, 1, col.ORDER - 2), [-1.0, 1.0]))
    out = np.empty(col.ORDER)
    col.exponentials(values, out)
    np.testing.assert_allclose(out, np.exp(values), rtol=5e-16)


def test_sums_and_extremes():
    random = np.random.default_rng(4)
    for _ in range(50):
        a, b = random.normal(size=(2, col.ORDER))
        assert col.dot(a, b) == pytest.approx(float(a @ b), abs=1e-14)
        assert col.extremes(a) == (a.min(), a.max())


def test_widths_go_on_beyond_the_tables():
    ratio = [panel.width_of(level + 1) / panel.width_of(level) for level in range(panel.LEVELS + 40)]
    np.testing.assert_allclose(ratio, np.sqrt(0.5), rtol=1e-14)


def test_falls_are_where_numpy_has_roots():
    """Resolved functions with two falls and a rise between; the first fall, to rounding.

    The condition of a root is 1/abs(slope), up to 1,000 here with roots 0.05 apart: it moves by that times the rounding of the
    function. Three units in the last place of the function's largest value are what the sixteen products of a series may add.
    """
    random = np.random.default_rng(5)
    stack = np.zeros((search.DEPTH + 3, col.ORDER + 2))
    for _ in range(200):
        roots = np.sort(random.uniform(-0.95, 0.95, 3))
        if np.diff(roots).min() < 0.05:
            continue
        slow = random.uniform(-0.3, 0.3)

        def function(x, roots=roots, slow=slow):
            return -np.prod([x - root for root in roots], axis=0) * np.exp(slow * x)

        series = np.empty(col.ORDER)
        values = function(col.NODES)
        col.coefficients(values, series)
        slope = (roots[1] - roots[0]) * (roots[2] - roots[0]) * np.exp(slow * roots[0])
        rounding = 3.0 * np.spacing(1.0) * np.abs(values).max()
        found = search.first_downcrossing(series, 0.0, stack)
        assert found == pytest.approx(roots[0], rel=0.0, abs=rounding / slope + np.spacing(1.0))


@pytest.mark.parametrize("floor", [0.0, 1e-9, 1e-3])
@pytest.mark.parametrize("place", [0.0, 0.5, -0.5, 0.25, -0.875, 0.1])
def test_a_fall_on_the_border_of_two_intervals(place, floor):
    """Rounding may leave the left one above zero at its end and the right one below it at its start: the root is in neither.

    Nor is a fall passed over that is deeper than the floor only in a later interval.
    """
    random = np.random.default_rng(8)
    stack = np.zeros((search.DEPTH + 3, col.ORDER + 2))
    exact = np.zeros(col.ORDER)
    exact[:4] = chebyshev.poly2cheb(-np.polynomial.polynomial.polymul([-place, 1.0], [place**2 + 0.01, -2.0 * place, 1.0]))
    bent = np.zeros(col.ORDER)
    bent[:3] = chebyshev.poly2cheb(-np.polynomial.polynomial.polymul([-place, 1.0], [1.0 - place, 1.0]))
    for series in (exact, bent):  # with slopes of 0.01 and 1 at the fall
        for _ in range(100):
            rounded = series + 1e-16 * random.uniform(-1.0, 1.0, col.ORDER)
            found = search.first_downcrossing(rounded, floor, stack)
            assert found == pytest.approx(place, rel=0.0, abs=1e-13)
            assert search.first_downcrossing_after(rounded, found, floor, stack) == search.NOT_FOUND
    assert search.first_downcrossing(exact, 8.0, stack) == search.NOT_FOUND  # it does not fall so far
    touching = np.zeros(col.ORDER)
    touching[:3] = chebyshev.poly2cheb(np.polynomial.polynomial.polymul([-place, 1.0], [-place, 1.0]))
    for _ in range(100):
        series = touching + 1e-16 * random.uniform(-1.0, 1.0, col.ORDER)
        assert search.first_downcrossing(series, max(floor, 1e-14), stack) == search.NOT_FOUND


def test_what_is_no_number_falls_nowhere():
    stack = np.zeros((search.DEPTH + 3, col.ORDER + 2))
    for bad in (np.nan, np.inf):
        series = np.ones(col.ORDER)
        series[3] = bad
        assert search.first_downcrossing(series, 0.0, stack) == search.NOT_FOUND


def test_a_resolved_function_stays_near_the_range_of_its_nodes():
    """What lets `fall_of` pass over margins: below its lowest node it goes by less than the range of the nodes."""
    random = np.random.default_rng(6)
    fine = np.linspace(-1.0, 1.0, 2001)
    for _ in range(500):
        # coefficients that fall by 1e-13 over the panel, as an accepted panel's do
        series = random.normal(size=col.ORDER) * 10.0 ** (-13.0 * np.arange(col.ORDER) / (col.ORDER - 1))
        nodes = chebyshev.chebval(col.NODES, series)
        assert nodes.min() - chebyshev.chebval(fine, series).min() < 0.1 * np.ptp(nodes)


@pytest.mark.parametrize("xi", [-1.0, -0.7, -1e-9, 0.0, 0.3, 0.999, 1.0])
def test_a_series_and_its_derivatives(xi):
    series = np.random.default_rng(3).normal(size=col.ORDER) * 0.3 ** np.arange(col.ORDER)
    value, slope, bend = col.value_slope_bend(series, xi)
    assert value == pytest.approx(chebyshev.chebval(xi, series), rel=1e-14, abs=1e-15)
    assert slope == pytest.approx(chebyshev.chebval(xi, chebyshev.chebder(series)), rel=1e-14, abs=1e-14)
    assert bend == pytest.approx(chebyshev.chebval(xi, chebyshev.chebder(series, 2)), rel=1e-13, abs=1e-13)
    if xi in (-1.0, 0.0, 1.0):
        assert col.end_values(series)[int(xi) + 1] == pytest.approx(value, rel=1e-15)


def test_products_and_tails_of_a_panel():
    """Against NumPy's sums, for values of any size."""
    random = np.random.default_rng(6)
    for values in (np.cos(1.3 * col.NODES) + 0.2, random.normal(size=col.ORDER), 10.0 ** random.uniform(-300, 300, col.ORDER)):
        for matrix in (col.ANTIDERIVATIVE_T, col.REMAINDER_T, col.SERIES_T, search.LEFT_T):
            out = np.full(col.ORDER, 7.0)
            col.product(matrix, values, out)
            np.testing.assert_allclose(out, matrix.T @ values, atol=1e-14 * np.abs(values).max())
        for scale in (0.0, 2.5, np.inf):
            tail = np.abs(col.SERIES[-3:] @ values).max() / max(scale, np.abs(values).max())
            assert col.truncation_error(values, scale) == pytest.approx(tail, abs=1e-15)
    values[5] = np.nan
    assert col.truncation_error(values, 1.0) == np.inf


@pytest.mark.parametrize("size", [0.9, 20.0])
def test_a_row_divided_by_exponentials(size):
    values = size * np.random.default_rng(8).uniform(-1.0, 1.0, col.ORDER)
    out, row, quotient = np.empty(col.ORDER), np.linspace(-1.0, 2.0, col.ORDER), np.empty(col.ORDER)
    col.divided_by_exponentials(values, out, row, quotient)
    np.testing.assert_allclose(out, np.exp(values), rtol=5e-16)
    np.testing.assert_allclose(quotient * np.exp(values), row, rtol=1e-14)


@pytest.mark.parametrize("xi", [-1.0, -0.7, 1e-9, 0.999])
def test_interpolation_is_exact_for_polynomials(xi):
    weights = np.empty(col.ORDER)
    col.lagrange(xi, weights)
    for degree in range(col.ORDER):
        assert weights @ col.NODES**degree == pytest.approx(xi**degree, abs=1e-14)
