"""The tables of the solver: what they are, found another way, and that they are those that the generator writes."""

import numpy as np
import pytest
from numpy.polynomial import chebyshev, legendre

from hophoop.kernel.numerics import tables
from hophoop.kernel.panels.panel import SINES
from kernel_tables import text

POINTS = tables.NODES


def test_the_generator_writes_these_tables():
    assert tables.FILE.read_bytes() == text().encode()


def test_quadrature_is_that_of_gauss():
    nodes, weights = legendre.leggauss(16)
    np.testing.assert_allclose(POINTS, nodes, rtol=1e-15)
    np.testing.assert_allclose(tables.WEIGHTS, weights, rtol=1e-14)
    assert np.array_equal(POINTS, -POINTS[::-1])
    assert np.array_equal(tables.WEIGHTS, tables.WEIGHTS[::-1])


@pytest.mark.parametrize("degree", range(16))
def test_series_antiderivative_and_halves_of_a_polynomial(degree):
    series = np.zeros(16)
    series[degree] = 1.0
    values = chebyshev.chebval(POINTS, series)
    np.testing.assert_allclose(tables.SERIES @ values, series, atol=5e-15)
    integral = chebyshev.chebint(series, lbnd=-1)
    np.testing.assert_allclose(tables.ANTIDERIVATIVE_T.T @ values, chebyshev.chebval(POINTS, integral), atol=2e-15)
    for table, place in ((tables.LEFT_T, -1.0), (tables.RIGHT_T, 1.0)):
        half = chebyshev.chebval(POINTS, table.T @ series)
        np.testing.assert_allclose(half, chebyshev.chebval(0.5 * (POINTS + place), series), atol=5e-15)


def test_panels_are_tabulated_at_their_nodes():
    widths = 0.9 * 2.0 ** (-0.5 * np.arange(96))
    np.testing.assert_allclose(tables.WIDTHS, widths, rtol=1e-15)
    offsets = widths[:, None] * (1.0 + POINTS) / 2.0
    np.testing.assert_allclose(tables.NODE_SINES, np.sin(offsets), rtol=1e-15)
    np.testing.assert_allclose(tables.NODE_VERSINES, 2.0 * np.sin(0.5 * offsets) ** 2, rtol=1e-15)
    np.testing.assert_allclose(tables.END_SINES, np.sin(widths), rtol=1e-15)
    np.testing.assert_allclose(tables.END_VERSINES, 2.0 * np.sin(0.5 * widths) ** 2, rtol=1e-15)
    assert np.array_equal(SINES[0], -SINES[1])


def test_radau_integrates_polynomials_and_is_diagonal_in_its_eigenvectors():
    c = tables.RADAU_NODES
    powers = np.arange(5)
    np.testing.assert_allclose(tables.RADAU_A @ c[:, None] ** powers, c[:, None] ** (powers + 1) / (powers + 1), atol=1e-15)
    # quadrature of order 9: the last row of A integrates degrees up to 8 over the whole step
    degrees = np.arange(9)
    np.testing.assert_allclose(tables.RADAU_A[-1] @ c[:, None] ** degrees, 1.0 / (degrees + 1), rtol=1e-14)
    np.testing.assert_allclose(tables.RADAU_A_INVERSE @ tables.RADAU_A, np.eye(5), atol=1e-13)
    np.testing.assert_allclose(
        tables.RADAU_A_INVERSE @ tables.RADAU_FROM_REAL, tables.RADAU_GAMMA * tables.RADAU_FROM_REAL, rtol=1e-13
    )
    vectors = tables.RADAU_FROM_PAIR
    np.testing.assert_allclose(tables.RADAU_A_INVERSE @ vectors, vectors * tables.RADAU_LAMBDA, rtol=1e-13)
    # from stages to eigenvectors and back
    back = np.outer(tables.RADAU_FROM_REAL, tables.RADAU_TO_REAL) + (vectors @ tables.RADAU_TO_PAIR).real
    np.testing.assert_allclose(back, np.eye(5), atol=1e-13)


def test_radau_estimates_its_error_by_a_solution_of_order_five():
    c = tables.RADAU_NODES
    # h f(y0)/γ + Σ DEFECT_i h f_i vanishes for polynomials up to degree 4
    for degree in range(5):
        start = 1.0 if degree == 0 else 0.0
        assert start / tables.RADAU_GAMMA + tables.RADAU_DEFECT @ c**degree == pytest.approx(0.0, abs=1e-13)
    np.testing.assert_allclose(tables.RADAU_ERROR, tables.RADAU_DEFECT @ tables.RADAU_A_INVERSE, atol=1e-12)
    values = np.sin(np.concatenate(([0.0], c)))
    dense = tables.RADAU_POWERS @ values[1:]
    np.testing.assert_allclose(c[:, None] ** np.arange(1, 6) @ dense, values[1:], atol=1e-14)
