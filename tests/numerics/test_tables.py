"""The tables of the solver: what they are, found another way, and that they are those that the generator writes."""

import numpy as np
import pytest
from numpy.polynomial import chebyshev

from hophoop.kernel.numerics import tables
from kernel_tables import text

POINTS = tables.NODES


def test_the_generator_writes_these_tables():
    assert tables.FILE.read_bytes() == text().encode()


@pytest.mark.parametrize("degree", [0, 1, 2, 14, 15])
def test_weights_series_antiderivative_and_halves_of_a_polynomial(degree):
    series = np.zeros(16)
    series[degree] = 1.0
    values = chebyshev.chebval(POINTS, series)
    integral = chebyshev.chebint(series, lbnd=-1)
    assert tables.WEIGHTS @ values == pytest.approx(chebyshev.chebval(1.0, integral), abs=1e-14)
    np.testing.assert_allclose(tables.SERIES @ values, series, atol=5e-15)
    np.testing.assert_allclose(tables.ANTIDERIVATIVE_T.T @ values, chebyshev.chebval(POINTS, integral), atol=2e-15)
    for table, place in ((tables.LEFT_T, -1.0), (tables.RIGHT_T, 1.0)):
        half = chebyshev.chebval(POINTS, table.T @ series)
        np.testing.assert_allclose(half, chebyshev.chebval(0.5 * (POINTS + place), series), atol=5e-15)


def test_radau_integrates_polynomials_and_estimates_its_error_by_a_solution_of_order_five():
    nodes, degrees = tables.RADAU_NODES, np.arange(9)
    powers = nodes[:, None] ** degrees
    np.testing.assert_allclose(tables.RADAU_A @ powers[:, :5], powers[:, 1:6] / np.arange(1, 6), atol=1e-15)
    # quadrature of order 9: the last row of A integrates degrees up to 8 over the whole step
    np.testing.assert_allclose(tables.RADAU_A[-1] @ powers, 1.0 / (degrees + 1), rtol=1e-14)
    # h f(y0)/γ + Σ DEFECT_i h f_i vanishes for polynomials up to degree 4
    np.testing.assert_allclose(tables.RADAU_DEFECT @ powers[:, :5], [-1.0 / tables.RADAU_GAMMA, 0.0, 0.0, 0.0, 0.0], atol=1e-13)
    np.testing.assert_allclose(powers[:, 1:6] @ (tables.RADAU_POWERS @ np.sin(nodes)), np.sin(nodes), atol=1e-14)
