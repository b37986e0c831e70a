"""Small systems of linear equations, beside NumPy's solver."""

import numpy as np
import pytest

from hophoop.kernel.compliant import radau as el
from hophoop.kernel.native import forced


def systems(kind, count=20):
    random = np.random.default_rng(11)
    for _ in range(count):
        matrix = random.normal(size=(6, 6)) * 10.0 ** random.uniform(-3, 3, (6, 1))
        side = random.normal(size=6)
        if kind is complex:
            matrix = matrix + 1j * random.normal(size=(6, 6))
            side = side + 1j * random.normal(size=6)
        yield matrix, side


@pytest.mark.parametrize(
    ("kind", "factor", "solve"), [(float, el.factor, el.solve), (complex, el.factor_complex, el.solve_complex)]
)
def test_solutions_are_those_of_numpy(kind, factor, solve):
    for matrix, side in systems(kind):
        expected = np.linalg.solve(matrix, side)
        factors, pivots, found = matrix.copy(), np.zeros(6, np.int64), side.copy()
        assert factor(factors, pivots)
        solve(factors, pivots, found)
        np.testing.assert_allclose(found, expected, rtol=1e-15 * np.linalg.cond(matrix) + 1e-14)


@pytest.mark.parametrize(("kind", "factor"), [(float, el.factor), (complex, el.factor_complex)])
def test_a_singular_matrix_is_told(kind, factor):
    for entry in (1.0, np.nan):
        assert not factor(np.full((3, 3), entry, kind), np.zeros(3, np.int64))


def test_compiled_and_interpreted_have_the_same_bits():
    for matrix, side in systems(complex, 5):
        results = []
        for mode in ("interpreted", "compiled"):
            factors, pivots, found = matrix.copy(), np.zeros(6, np.int64), side.copy()
            with forced(mode):
                el.factor_complex(factors, pivots)
                el.solve_complex(factors, pivots, found)
            results.append((factors.tobytes(), found.tobytes()))
        assert results[0] == results[1]
