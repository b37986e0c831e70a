"""Sums and powers in a fixed order."""

from fractions import Fraction

import numpy as np
import pytest

from hophoop.kernel.numerics.arithmetic import integer_power, matrix_product, weighted_sum


def test_a_matrix_product_is_summed_from_left_to_right():
    random = np.random.default_rng(3)
    one, other = random.normal(size=(4, 5)), random.normal(size=(5, 3))
    found = matrix_product(one, other)
    np.testing.assert_allclose(found, one @ other, rtol=1e-13)
    for i in range(4):
        for j in range(3):
            total = 0.0
            for k in range(5):
                total += one[i, k] * other[k, j]
            assert found[i, j] == total


def test_a_weighted_sum_broadcasts_and_keeps_its_order():
    weights, values = np.array([1e16, 1.0, -1e16]), np.ones(3)
    assert weighted_sum(weights, values) == (1e16 + 1.0) - 1e16
    columns = weighted_sum([np.array([1.0, 2.0]), np.array([3.0, 4.0])], [10.0, 100.0])
    assert columns.tolist() == [310.0, 420.0]


@pytest.mark.parametrize("exponent", range(-4, 5))
@pytest.mark.parametrize("base", [0.3, 1.7, 1e-5])
def test_integer_powers(base, exponent):
    assert integer_power(base, exponent) == pytest.approx(float(Fraction(base) ** exponent), rel=1e-15)
