"""The kernel's impact over exact fractions, against the exact oracle."""

import math
from fractions import Fraction
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.impacts import impact
from hophoop.precise.kernels import Kernels
from hophoop.vocabulary.names import LAW_CODES
from oracles import rational

FRACTIONS = {"math": SimpleNamespace(inf=math.inf, isinf=lambda value: abs(value) == math.inf, sqrt=rational.root)}
exact_impact = Kernels(Fraction, FRACTIONS)(impact)


shares = st.fractions(0, 1, max_denominator=12)
speeds = st.fractions(-3, 3, max_denominator=8)


@pytest.mark.parametrize("law", LAW_CODES)
@given(
    shares, st.fractions(Fraction(1, 8), 1, max_denominator=8), st.fractions(-3, 3, max_denominator=6),
    st.fractions(0, 2, max_denominator=6), shares, shares, speeds, st.fractions(-2, Fraction(-1, 8), max_denominator=8),
)  # fmt: skip
def test_it_is_the_impact_of_the_exact_oracle(law, eps, kap, slope, mu_s, ratio, rest, slip, approach):
    s, c = 2 * slope / (1 + slope**2), (1 - slope**2) / (1 + slope**2)  # sine and cosine of a rational point of the circle
    mu_k = mu_s * ratio
    body = rational.Contact(eps, kap, s, c, mu_s, mu_k)
    # from v_t and v_n to the velocities of the centre, with θ̇ = 0
    expected = rational.collide(body, (slip, approach, Fraction(0)), rest, law)
    vx, vy, om = expected["velocity"]
    level = Body(eps, kap, mu_s, mu_k, Fraction(1), Fraction(0), Fraction(0), LAW_CODES[law], False, Fraction(0))
    found = exact_impact(level, rest, s, c, slip, approach)
    impulse = expected["impulse"]
    wanted = (vx - om, vy, om, impulse["normal"], impulse["tangential"], expected["loss_normal"], expected["loss_tangential"])
    # the roots of the energetic law are not rational
    room = Fraction(1, 10**30) if law == "stronge" else 0
    assert all(abs(one - other) <= room for one, other in zip(found, wanted, strict=True))
