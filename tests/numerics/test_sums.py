"""Sums and powers in a fixed order, and sines and 1 − cosines of one angle."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest

from hophoop.kernel.numerics.arithmetic import integer_power, matrix_product, weighted_sum
from hophoop.kernel.numerics.circular import sine_and_versine


def test_sums_go_from_left_to_right():
    weights, values = [[1e16, 1.0, -1e16]], np.ones((3, 2))
    assert matrix_product(np.array(weights), values).tolist() == [[(1e16 + 1.0) - 1e16] * 2]
    assert weighted_sum(weights[0], values).tolist() == [(1e16 + 1.0) - 1e16] * 2


@pytest.mark.parametrize("base", [0.3, 1.7, 1e-5])
def test_integer_powers(base):
    for exponent in range(-4, 5):
        assert integer_power(base, exponent) == pytest.approx(float(Fraction(base) ** exponent), rel=1e-15)


def test_sine_and_versine_keep_their_digits():
    for angle in (1e-300, 1e-9, 0.3, 0.9, 1.5, 2.0, 3.1, np.pi, 4.7, 6.28, 2 * np.pi, 2 * np.pi + 1e-7, 1e6, 1e16):
        with mpmath.workdps(60):
            exact = mpmath.mpf(angle)
            expected = float(mpmath.sin(exact)), float(2 * mpmath.sin(exact / 2) ** 2)
        for sign in (-1.0, 1.0):
            sine, versine = sine_and_versine(sign * angle)
            assert sine == pytest.approx(sign * expected[0], rel=2.3e-16, abs=0.0), angle
            assert versine == pytest.approx(expected[1], rel=9e-16, abs=0.0), angle
