"""Small systems of linear equations, beside NumPy's solver."""

import numpy as np

from hophoop.kernel.compliant.radau import factor, solve


def systems(count):
    random = np.random.default_rng(11)
    for _ in range(count):
        matrix = random.normal(size=(6, 6)) * 10.0 ** random.uniform(-3, 3, (6, 1)) + 1j * random.normal(size=(6, 6))
        yield matrix, random.normal(size=6) + 1j * random.normal(size=6)


def test_solutions_are_those_of_numpy():
    for matrix, side in systems(20):
        expected = np.linalg.solve(matrix, side)
        factors, pivots, found = matrix.copy(), np.zeros(6, np.int64), side.copy()
        assert factor(factors, pivots)
        solve(factors, pivots, found)
        np.testing.assert_allclose(found, expected, rtol=1e-15 * np.linalg.cond(matrix) + 1e-14)


def test_a_singular_matrix_is_told():
    for entry in (1.0, np.nan):
        assert not factor(np.full((3, 3), entry, complex), np.zeros(3, np.int64))
