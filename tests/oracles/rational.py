"""Impacts in exact fractions, or in the numbers of any library; tests/physics/test_impact.py works some by hand.

At an impact the place does not change, so the velocity q̇ = (ẋ, ẏ, θ̇) moves along straight pieces as the
normal impulse p grows: dq̇/dp = M⁻¹ (r, 1, −rR)ᵀ with a constant ratio r of the tangential to the normal
impulse on each piece. With rational sin θ, cos θ and rational data all is rational but for Stronge's law,
whose end is the root of a quadratic.

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

    def answer(self, tangential: Fraction, normal: Fraction) -> Triple:
        """Change of (ẋ, ẏ, θ̇) under an impulse: of G by the impulse, of θ̇ by its moment about G."""
        arm, lever = 1 + self.eccentricity * self.cosine, self.eccentricity * self.sine
        turn = (lever * normal - arm * tangential) / self.inertia_ratio
        return tangential - (arm - 1) * turn, normal + lever * turn, turn


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
