"""The transformation of a kernel's source into that of its tangent."""

from __future__ import annotations

import inspect
import math
from typing import NamedTuple

import pytest

from hophoop.derivatives.rules import RULES
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.contact import delassus, load_height, rolling_forces
from hophoop.kernel.physics.impact import impact

BODY = Body(0.6, 0.5, 0.4, 0.3, 0.9, 0.3, 0.5, 2, False, 0.3)
STEP = 1e-6


class Pair(NamedTuple):
    """Two numbers that a kernel takes as one argument."""

    first: float
    second: float


def branches(pair, x, count):
    """A sum that a loop, branches and a choice change."""
    total = 0.0
    for i in range(count):
        if i == 3:
            continue
        total += pair.first * x if i < 2 else pair.second / x
        if total > 50.0:
            break
    low, high = min(total, x), max(total, x)
    return low - high, -total


def unknown(x):
    """A power, for which there is no rule."""
    return x**2


def test_loops_branches_and_named_tuples():
    tangent = tangent_of(branches, "pair", "x")
    for x, count in ((1.3, 2), (0.2, 6), (90.0, 6)):
        found, change = tangent(Pair(0.7, 0.3), x, count, Pair(1.0, -2.0), 0.5)
        assert found == branches(Pair(0.7, 0.3), x, count)
        sides = [branches(Pair(0.7 + step, 0.3 - 2.0 * step), x + 0.5 * step, count) for step in (STEP, -STEP)]
        assert change == pytest.approx([(a - b) / (2.0 * STEP) for a, b in zip(*sides, strict=True)], rel=1e-8)


@pytest.mark.parametrize("rule", RULES, ids=lambda each: each.__name__)
def test_elementary_functions(rule):
    given = (0.4, -0.3)[: (rule.__name__ in ("min", "max", "copysign") and 2) or 1]
    changes = (0.7, 0.2)[: len(given)]
    found, change = RULES[rule](*given, *changes)
    assert found == rule(*given)
    sides = [rule(*(x + side * STEP * d for x, d in zip(given, changes, strict=True))) for side in (1.0, -1.0)]
    if isinstance(found, tuple):
        expected = [(a - b) / (2.0 * STEP) for a, b in zip(*sides, strict=True)]
        assert list(change) == pytest.approx(expected, rel=1e-8, abs=1e-9)
    else:
        assert change == pytest.approx((sides[0] - sides[1]) / (2.0 * STEP), rel=1e-8)


def test_one_field_changes_as_all_of_them_do():
    s, c = math.sin(0.7), math.cos(0.7)
    value, by_eps = tangent_of(rolling_forces, "body.eps")(BODY, s, c, 1.3, 0.0, 1.0)
    only = BODY._replace(eps=1.0, kap=0.0, mu_s=0.0, mu_k=0.0, gn=0.0, gt=0.0, rest=0.0)
    assert (value, by_eps) == tangent_of(rolling_forces, "body")(BODY, s, c, 1.3, 0.0, only)


def test_what_does_not_change_has_no_tangent():
    assert "d_" not in inspect.getsource(tangent_of(load_height, "s")).split(":", 1)[1].split("if")[0]
    assert tangent_of(delassus, "c")(BODY, 0.6, 0.8, 0.0)[1] == (0.0, 0.0, 0.0)


def test_the_values_are_those_of_the_kernel():
    """To the last bit, since each operation is there as it was."""
    tangent = tangent_of(impact, "body", "s", "c", "vt")
    still = BODY._replace(eps=0.0, kap=0.0, mu_s=0.0, mu_k=0.0, gn=0.0, gt=0.0, rest=0.0)
    for k in range(40):
        s, c = math.sin(0.3 * k), math.cos(0.3 * k)
        given = (BODY._replace(law=k % 3), 0.4, s, c, 0.1 * k - 2.0, -1.1, math.nan)
        assert tangent(*given, still, c, -s, 1.0)[0] == impact(*given)


def test_the_source_can_be_read():
    text = inspect.getsource(tangent_of(rolling_forces, "u"))
    assert text.startswith("def d_rolling_forces_by_u(body, s, c, u, rho, d_u):")
    assert tangent_of(rolling_forces, "u").__module__ == rolling_forces.__module__


def test_what_cannot_be_transformed_is_named():
    with pytest.raises(NotImplementedError, match=r"x \*\* 2"):
        tangent_of(unknown, "x")
