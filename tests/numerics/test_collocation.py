"""Panels' tables against the generator, their arithmetic against NumPy's: sums, series, the first fall through zero."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial, chebyshev

from hophoop.kernel.numerics import collocation as col
from hophoop.kernel.numerics import tables
from hophoop.kernel.panels import panel
from kernel_tables import text


def test_the_tables_are_those_of_the_generator():
    assert tables.FILE.read_bytes() == text().encode()


def cheb(polynomial):
    """The Chebyshev series of a polynomial, as long as a panel's."""
    series = np.zeros(col.ORDER)
    series[: len(polynomial.coef)] = chebyshev.poly2cheb(polynomial.coef)
    return series


def fall(series, floor=0.0, after=None):
    """The first fall of a series below zero, and below minus the floor before it rises again; after an earlier one."""
    stack = np.zeros((col.DEPTH + 3, col.ORDER + 2))
    if after is None:
        return col.first_downcrossing(series, floor, stack)
    return col.first_downcrossing_after(series, after, floor, stack)


@pytest.mark.parametrize("size", [1e-8, 0.9, 1.0, 1.001, 20.0])
def test_exponentials(size):
    """Both ways, by the series up to 1 and by the library above, to a few roundings."""
    values = size * np.concatenate((np.random.default_rng(3).uniform(-1, 1, col.ORDER - 2), [-1.0, 1.0]))
    out, other, quotient = np.empty((3, col.ORDER))
    col.exponentials(values, out)
    np.testing.assert_allclose(out, np.exp(values), rtol=5e-16)
    row = np.linspace(-1.0, 2.0, col.ORDER)
    col.divided_by_exponentials(values, other, row, quotient)
    assert np.array_equal(out, other)
    np.testing.assert_allclose(quotient * out, row, rtol=1e-14)


def test_sums_products_and_tails():
    """For values of any size."""
    random = np.random.default_rng(6)
    for values in (np.cos(1.3 * col.NODES) + 0.2, random.normal(size=col.ORDER), 10.0 ** random.uniform(-300, 300, col.ORDER)):
        size = np.abs(values).max()
        assert col.dot(values, col.WEIGHTS) == pytest.approx(float(values @ col.WEIGHTS), abs=1e-14 * size)
        for shift in range(col.ORDER):
            assert col.extremes(np.roll(values, shift)) == (values.min(), values.max())
        for matrix in (col.ANTIDERIVATIVE_T, col.REMAINDER_T, col.SERIES_T, col.LEFT_T):
            out = np.full(col.ORDER, 7.0)
            col.product(matrix, values, out)
            np.testing.assert_allclose(out, matrix.T @ values, atol=1e-14 * size)
        for scale in (0.0, 2.5, np.inf):
            tail = np.abs(col.SERIES[-3:] @ values).max() / max(scale, size)
            assert col.truncation_error(values, scale) == pytest.approx(tail, abs=1e-15)
    values[5] = np.nan
    assert col.truncation_error(values, 1.0) == np.inf


def test_widths_go_on_beyond_the_tables():
    ratio = [panel.width_of(level + 1) / panel.width_of(level) for level in range(panel.LEVELS + 40)]
    np.testing.assert_allclose(ratio, np.sqrt(0.5), rtol=1e-14)


@pytest.mark.parametrize("xi", [-1.0, -0.7, -1e-9, 0.0, 0.3, 0.999, 1.0])
def test_a_series_its_derivatives_and_interpolation(xi):
    series = np.random.default_rng(3).normal(size=col.ORDER) * 0.3 ** np.arange(col.ORDER)
    value, slope, bend = col.value_slope_bend(series, xi)
    assert value == pytest.approx(chebyshev.chebval(xi, series), rel=1e-14, abs=1e-15)
    assert slope == pytest.approx(chebyshev.chebval(xi, chebyshev.chebder(series)), rel=1e-14, abs=1e-14)
    assert bend == pytest.approx(chebyshev.chebval(xi, chebyshev.chebder(series, 2)), rel=1e-13, abs=1e-13)
    if xi in (-1.0, 0.0, 1.0):
        assert col.end_values(series)[int(xi) + 1] == pytest.approx(value, rel=1e-15)
    weights = np.empty(col.ORDER)
    col.lagrange(xi, weights)
    for degree in range(col.ORDER):
        assert weights @ col.NODES**degree == pytest.approx(xi**degree, abs=1e-14)


def test_falls_are_where_numpy_has_roots():
    """Resolved functions with two falls and a rise between; the first fall, to rounding.

    The condition of a root is 1/abs(slope), up to 1,000 here with roots 0.05 apart: it moves by that times the rounding of the
    function. Three units in the last place of the function's largest value are what the sixteen products of a series may add.
    """
    random = np.random.default_rng(5)
    for _ in range(200):
        roots, slow = np.sort(random.uniform(-0.95, 0.95, 3)), random.uniform(-0.3, 0.3)
        if np.diff(roots).min() < 0.05:
            continue
        values = -np.prod([col.NODES - root for root in roots], axis=0) * np.exp(slow * col.NODES)
        series = np.empty(col.ORDER)
        col.coefficients(values, series)
        slope = (roots[1] - roots[0]) * (roots[2] - roots[0]) * np.exp(slow * roots[0])
        rounding = 3.0 * np.spacing(1.0) * np.abs(values).max()
        assert fall(series) == pytest.approx(roots[0], rel=0.0, abs=rounding / slope + np.spacing(1.0))


@pytest.mark.parametrize("floor", [0.0, 1e-3])
@pytest.mark.parametrize("place", [0.0, 0.5, -0.5, 0.25, -0.875, 0.1])
def test_a_fall_on_the_border_of_two_intervals(place, floor):
    """Rounding may leave the left one above zero at its end and the right one below it at its start: the root is in neither.

    Nor is a fall passed over that is deeper than the floor only in a later interval.
    """
    random = np.random.default_rng(8)
    root = Polynomial([-place, 1.0])
    steep, flat = cheb(-root * Polynomial([1.0 - place, 1.0])), cheb(-root * Polynomial([place**2 + 0.01, -2.0 * place, 1.0]))
    for _ in range(30):
        rounding = 1e-16 * random.uniform(-1.0, 1.0, col.ORDER)
        for series in (steep + rounding, flat + rounding):  # with slopes of 1 and 0.01 at the fall
            found = fall(series, floor)
            assert found == pytest.approx(place, rel=0.0, abs=1e-13)
            assert fall(series, floor, found) == col.NOT_FOUND
        assert fall(cheb(root * root) + rounding, max(floor, 1e-14)) == col.NOT_FOUND  # it touches zero
    assert fall(flat, 8.0) == col.NOT_FOUND  # it does not fall so far


def test_what_is_no_number_falls_nowhere():
    for bad in (np.nan, np.inf):
        assert fall(np.where(np.arange(col.ORDER) == 3, bad, 1.0)) == col.NOT_FOUND
