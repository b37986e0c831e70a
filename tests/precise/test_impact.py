"""The impact that precise motions and proofs share, in exact fractions against the exact oracle."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hophoop.kernel.physics.body import ImpactLaw
from hophoop.precise.impact import Contact, impact
from hophoop.vocabulary.names import LAW_CODES
from oracles import rational


class Exact:
    """Fractions, about which every decision is exact."""

    zero = Fraction(0)

    def sign(self, value, what):
        return (value > 0) - (value < 0)

    def judged_sign(self, value, scale, what):
        return self.sign(value, what)

    def order(self, one, other):
        return self.sign(one - other, "")

    def is_zero(self, value):
        return value == 0

    def sqrt(self, value):
        return rational.root(value)

    def endless(self):
        return ArithmeticError("an impact does not end")


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
    contact = Contact(1 + eps * c, eps * s, kap, mu_s, mu_k, ImpactLaw[law.upper()])
    blow = impact(contact, Exact(), rest, slip, approach)
    found = (blow.vt, blow.vn, blow.spin, blow.p_n, blow.p_t, -blow.work_n, -blow.work_t)
    impulse = expected["impulse"]
    wanted = (vx - om, vy, om, impulse["normal"], impulse["tangential"], expected["loss_normal"], expected["loss_tangential"])
    # the roots of the energetic law are not rational
    room = Fraction(1, 10**30) if law == "stronge" else 0
    assert all(abs(one - other) <= room for one, other in zip(found, wanted, strict=True))


def test_infinite_friction_stops_the_slip_at_once_and_keeps_it():
    """The tangential impulse alone, then compression in stick; the momentum about the contact point is kept."""
    eps, kap, s, c = Fraction(3, 4), Fraction(7, 16), Fraction(-3, 5), Fraction(4, 5)
    contact = Contact(1 + eps * c, eps * s, kap, None, None, ImpactLaw.POISSON)
    blow = impact(contact, Exact(), Fraction(0), Fraction(2), Fraction(-1))
    assert blow.vt == blow.vn == 0
    # κ Δθ̇ = ε s P_n − (1 + ε c) P_t, and v_t = 0 from Δẋ_G = P_t
    assert kap * blow.spin == contact.normal_arm * blow.p_n - contact.tangential_arm * blow.p_t
    assert Fraction(2) + blow.p_t - contact.tangential_arm * blow.spin == 0
    # the loss of energy is the work of both impulses
    before = Fraction(2) ** 2 + Fraction(-1) ** 2
    along, up = contact.tangential_arm * blow.spin, -contact.normal_arm * blow.spin
    after = along**2 + up**2 + kap * blow.spin**2
    assert before - after == -2 * (blow.work_n + blow.work_t)
