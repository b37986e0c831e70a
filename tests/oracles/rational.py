r"""Impacts in exact fractions, and three of them worked by hand.

At an impact the place does not change, so the velocity q̇ = (ẋ, ẏ, θ̇) moves along straight pieces as the
normal impulse p grows: dq̇/dp = M⁻¹ (r, 1, −rR)ᵀ with a constant ratio r of the tangential to the normal
impulse on each piece. With rational sin θ, cos θ and rational data all is rational but for Stronge's law,
whose end is the root of a quadratic.

Disk dropped with spin (ε = 0, κ = 1/2, R = m = 1)
    M = diag(1, 1, 1/2); friction moves ẋ by r p and θ̇ by −2 r p, so the slip velocity v_t = ẋ − θ̇ by 3 r p,
    and v_n by p. Take ẋ = 0, v_n = −2, θ̇ = 3: v_t = −3, r = +μ until v_t = 0 at p = 1/μ.

    * Stick, μ = 1: slip stops at p = 1 < 2, then r* = 0 holds it. Compression ends at p = 2.
      ẋ = 1, θ̇ = 1, impulse (1, 2). Losses: tangential 3·1/2 = 3/2, normal 2²/2 = 2.
    * Slip, μ = 1/4: slip would stop at p = 4 > 2. At p = 2: ẋ = 1/2, θ̇ = 2, v_t = −3/2, impulse (1/2, 2).
      Tangential loss: mean slip (3 + 3/2)/2 = 9/4 over 1/2 gives 9/8; normal 2.
    * With e = 1/2, normal and tangential motion being uncoupled, every law gives p = 3, v_n = 1. Under μ = 1
      again ẋ = θ̇ = 1; under μ = 1/4 ẋ = 3/4, θ̇ = 3/2.

Rod-like body (ε = 1/2, κ = 39/100, sin θ = −4/5, cos θ = 3/5, R = m = 1), ẋ = −1, v_n = −3, θ̇ = 0
    With a = 1 + ε cos θ = 13/10 and b = ε sin θ = −2/5, the contact point answers a unit normal impulse by
    (−ab/κ, 1 + b²/κ) = (4/3, 55/39) and a unit tangential one by (1 + a²/κ, −ab/κ) = (16/3, 4/3).
    Holding the slip at zero needs r* = −(4/3)/(16/3) = −1/4: sticking is possible for μ ≥ 1/4.

    * At the sticking limit, μ = 1/4: v_t = −1 grows at 4/3 + (1/4)(16/3) = 8/3 and stops at p = 3/8.
      Meanwhile v_n grows at 55/39 + (1/4)(4/3) = 68/39 to −61/26. Then it sticks with r = −1/4: v_n grows at
      55/39 − 1/3 = 14/13 and is zero at p = 3/8 + 61/28 = 143/56. Tangential impulse (1/4)(3/8) −
      (1/4)(61/28) = −101/224. Reversed slip would have the same ratio: the limit is continuous.
    * Reversal, μ = 1/8: v_t grows at 4/3 + 2/3 = 2, stops at p = 1/2; v_n grows at 55/39 + 1/6 = 41/26 to
      −115/52. Now r = −1/8 (slip forwards): v_t grows at 4/3 − 2/3 = 2/3, v_n at 55/39 − 1/6 = 97/78 and is
      zero after 345/194 more. p = 221/97, v_t = 115/97. Tangential impulse (1/8)(1/2 − 345/194) = −31/194.

It repeats the laws of impact on purpose and shares no code with hophoop.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

Triple = tuple[Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class Contact:
    """A body about to strike the plane, in exact numbers; R = m = 1."""

    eccentricity: Fraction
    inertia_ratio: Fraction
    sine: Fraction
    cosine: Fraction
    mu_static: Fraction
    mu_kinetic: Fraction
    radius: int = 1

    def __post_init__(self) -> None:
        if self.sine**2 + self.cosine**2 != 1:
            raise ValueError("sine and cosine must belong to one angle")

    def answer(self, tangential: Fraction, normal: Fraction) -> Triple:
        """Change of (ẋ, ẏ, θ̇) under an impulse, by Cramer's rule on the 3 × 3 mass matrix."""
        c, s = self.eccentricity * self.cosine, self.eccentricity * self.sine
        one, zero = Fraction(1), Fraction(0)
        rows = [[one, zero, c], [zero, one, -s], [c, -s, self.eccentricity**2 + self.inertia_ratio]]
        right = [tangential, normal, -tangential]

        def determinant(a: list[list[Fraction]]) -> Fraction:
            return (
                a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1])
                - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0])
                + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0])
            )

        whole = determinant(rows)
        columns = []
        for j in range(3):
            replaced = [[right[i] if k == j else rows[i][k] for k in range(3)] for i in range(3)]
            columns.append(determinant(replaced) / whole)
        return columns[0], columns[1], columns[2]


def root(square: Fraction) -> Fraction:
    """Square root: exact where it is rational, else to 40 digits."""
    top, bottom = isqrt(square.numerator), isqrt(square.denominator)
    if top**2 == square.numerator and bottom**2 == square.denominator:
        return Fraction(top, bottom)
    unit = 10**45
    return Fraction(isqrt(square.numerator * unit**2 // square.denominator), unit)


def collide(contact: Any, velocity: Triple, restitution: Any, law: str, root: Any = root) -> dict[str, Any]:
    """Velocity after the impact, impulse and losses, in the numbers that are given: fractions, or mpmath's.

    On each straight piece the slip keeps its direction, or friction holds it at zero.
    """
    radius = contact.radius
    along, off = contact.answer(1, 0), contact.answer(0, 1)
    push, pull = off[0] - radius * off[2], along[0] - radius * along[2]
    hold = -push / pull
    now, approach = tuple(velocity), velocity[1]
    impulse = tangential = work = loss = 0 * approach
    stuck, closed, at_closure = now[0] == radius * now[2], False, (impulse, work)
    while True:
        slip, separation = now[0] - radius * now[2], now[1]
        holds = stuck and abs(hold) <= contact.mu_static
        forwards = slip > 0 or (stuck and push > 0)
        ratio = hold if holds else -contact.mu_kinetic if forwards else contact.mu_kinetic
        change = [off[i] + ratio * along[i] for i in range(3)]
        rate, opening = 0 if holds else push + ratio * pull, change[1]
        length = -slip / rate if slip * rate < 0 else None
        if not closed:
            end = -separation / opening if opening > 0 else None
        elif law == "newton":
            end = (-restitution * approach - separation) / opening
        elif law == "poisson":
            end = (1 + restitution) * at_closure[0] - impulse
        else:
            target = -(restitution**2) * at_closure[1] - (work - at_closure[1])
            end = (root(separation**2 + 2 * opening * target) - separation) / opening
        finishes = end is not None and (length is None or end <= length)
        step = end if finishes else length
        if step is None:
            raise ValueError("the impact never ends")
        loss -= ratio * step * (slip + rate * step / 2)
        work += step * (separation + opening * step / 2)
        stuck = holds or step == length
        turn = now[2] + change[2] * step
        now = (radius * turn if stuck else now[0] + change[0] * step, separation + opening * step, turn)
        impulse, tangential = impulse + step, tangential + ratio * step
        if finishes and not closed:
            closed, at_closure, now = True, (impulse, work), (now[0], 0 * approach, now[2])
            if restitution == 0 or (law == "newton" and approach == 0):
                break
        elif finishes:
            break
    return {
        "velocity": now,
        "impulse": {"normal": impulse, "tangential": tangential},
        "loss_normal": -work,
        "loss_tangential": loss,
    }
