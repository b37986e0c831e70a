"""Roots of polynomials that are found, excluded, or ask for more digits."""

from fractions import Fraction

import pytest

from hophoop.precise.series import Judge, MorePrecision, sign_changes


def polynomial(coefficients, bits=200):
    return [int(Fraction(c) * 2**bits) for c in coefficients]


def test_close_pairs_of_roots_are_found_or_excluded():
    """(x − 1/3)² ∓ 1e-30: two roots 1e-15 apart, or none, told by the sign of the minimum alone."""
    third = Fraction(1, 3)
    for shift, count in ((Fraction(1, 10**30), 2), (-Fraction(1, 10**30), 0)):
        series = polynomial([third**2 - shift, -2 * third, 1])
        roots = sign_changes(series, 1, 200, Judge(200, False), first=False)
        assert len(roots) == count
        if roots:
            gap = Fraction(roots[1] - roots[0], 2**200)
            assert abs(gap - Fraction(2, 10**15)) < Fraction(1, 10**40)


def test_a_root_that_cannot_be_told_asks_for_more_digits():
    """An exact double root: more precision is asked for, and where there is none it is no crossing."""
    series = polynomial([Fraction(1, 9), -Fraction(2, 3), 1])
    with pytest.raises(MorePrecision):
        sign_changes(series, 1, 200, Judge(200, False))
    assert sign_changes(series, 1, 200, Judge(200, True)) == []


def test_many_roots_in_order():
    """Every sign change of a polynomial with roots at 1/7, 2/7 … 6/7."""
    coefficients = [Fraction(1)]
    for k in range(1, 7):
        root = Fraction(k, 7)
        coefficients = [
            (coefficients[i - 1] if i else 0) - root * (coefficients[i] if i < len(coefficients) else 0)
            for i in range(len(coefficients) + 1)
        ]
    roots = sign_changes(polynomial(coefficients), 1, 200, Judge(200, False), first=False)
    assert [round(root / 2**200 * 7) for root in roots] == [1, 2, 3, 4, 5, 6]
