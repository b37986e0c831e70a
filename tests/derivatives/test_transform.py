"""The transformation of a kernel's source into that of its tangent."""

import math

import numpy as np
import pytest

from hophoop.derivatives.rules import RULES
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.impacts import impact

BODY = Body(0.6, 0.5, 0.4, 0.3, 0.9, 0.3, 0.5, 2, False, 0.3)
STEP = 1e-6


def unknown(x):
    """A power, for which there is no rule."""
    return x**2


@pytest.mark.parametrize("rule", RULES)
def test_elementary_functions(rule):
    count = 2 if rule.__name__ in ("min", "max", "copysign") else 1
    given, changes = np.array([0.4, -0.3])[:count], np.array([0.7, 0.2])[:count]
    found, change = RULES[rule](*given.tolist(), *changes.tolist())
    ahead, behind = (np.array(rule(*(given + way * changes).tolist())) for way in (STEP, -STEP))
    assert found == rule(*given.tolist())
    assert np.array(change) == pytest.approx((ahead - behind) / (2.0 * STEP), rel=1e-8, abs=1e-9)


def test_the_values_are_those_of_the_kernel():
    """To the last bit, since each operation is there as it was."""
    tangent = tangent_of(impact, "body", "s", "c", "vt")
    still = BODY._replace(eps=0.0, kap=0.0, mu_s=0.0, mu_k=0.0, gn=0.0, gt=0.0, rest=0.0)
    for k in range(40):
        s, c = math.sin(0.3 * k), math.cos(0.3 * k)
        given = (BODY._replace(law=k % 3), 0.4, s, c, 0.1 * k - 2.0, -1.1)
        assert tangent(*given, still, c, -s, 1.0)[0] == impact(*given)


def test_what_cannot_be_transformed_is_named():
    with pytest.raises(NotImplementedError, match=r"x \*\* 2"):
        tangent_of(unknown, "x")
