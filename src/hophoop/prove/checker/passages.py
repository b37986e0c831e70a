"""All motions that roll past the bottom with θ̇ in an interval, up to their next passage: phase after phase.

A certificate names the phases, and for the end of each a bracket that holds it for all motions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from itertools import groupby
from typing import Any

from hophoop.prove._flint import Ball, Jet, arb, bits, pi, rational, symmetric
from hophoop.prove.checker.equations import Equations, Refused, State
from hophoop.prove.checker.family import Family, Pick, change, every, middle
from hophoop.prove.checker.flight import flown, gap
from hophoop.prove.checker.intervals import positive, require, root
from hophoop.prove.checker.panels import number
from hophoop.prove.checker.rolling import Rolling
from hophoop.prove.checker.rule import SIGMA, collide, next_mode, opening, sign
from hophoop.prove.checker.slip_families import Field, Stretch, moved

STEP, LEAST_STEP = 0.0625, 1e-5  # rad, of a stretch of slip
MOST_STRETCHES = 1000
MOST_GROWTH = 2.0  # of a stretch from one to the next
GUARD = 14  # bits
LIFT, STOP, SPAN, LAND = "lift", "stop", "span", "land"


class Motions:
    """The motions of an interval of θ̇, as far as they are verified.

    Parameters
    ----------
    equations : Equations
    low, high : Fraction
        Of θ̇ at the bottom [rad/s].
    terms : int
        Of the polynomials of slip.
    """

    def __init__(self, equations: Equations, low: Fraction, high: Fraction, terms: int) -> None:
        self.equations, self.terms = equations, terms
        require(not equations.resisted, "there is no rolling resistance, which boxes do not cover")
        require(equations.mu_s is not None and bool(equations.kap > 0), "the friction is finite and the ring has mass")
        self.reach = symmetric(rational((high - low) / 2))
        wide = (self.reach * equations.time).abs_upper()
        self.tolerance = arb(2) ** (GUARD - bits()) + wide * wide / 1000  # of the remainders of a stretch
        om = Family(rational((low + high) / 2) * equations.time, equations.time, self.reach)
        zero = arb(0)
        self.state = State(zero, zero, zero, pi(), zero, zero, om)
        self.finish = 3 * pi()
        self.energy = self._energy()
        self.mode, self.zeros = self._next(), 0
        self.drive: Ball | None = None  # ∂u/∂ω where slip begins out of rolling
        self.letters: list[str] = []

    def follow(self, phases: list[Any]) -> Family:
        """θ̇ at the next passage [rad/s]."""
        for one in phases:
            self.pass_phase(*one)
        require(not self.mode, "the motions come to their next passage")
        omega: Family = self.state.om / self.equations.time
        return omega

    def pass_phase(self, mode: str, what: str, low: float, high: float) -> None:
        """Go through a phase, whose end lies in a bracket."""
        require(bool(self.mode), "nothing comes after the next passage")
        require(mode == self.mode, f"phase {len(self.letters) + 1} has the mode that is said, not {self.mode}")
        self.letters.append(mode)
        phase = {"R": self.roll, "S": self.slip, "K": self.slip, "H": self.fly}[mode]
        phase(what, number(low), number(high))

    @property
    def word(self) -> str:
        """One letter for each phase."""
        return "".join(letter for letter, _ in groupby(self.letters))

    def _energy(self) -> Family:
        equations, state = self.equations, self.state
        s, c = state.th.sin_cos()
        energy: Family = equations.height(state.th, s, c) + equations.inertia(c) * state.om * state.om / 2
        return energy

    # --- phases --------------------------------------------------------------------------------

    def roll(self, what: str, low: Ball, high: Ball) -> None:
        """Rolling, in which energy is kept: its margins are functions of θ and that."""
        equations, energy, begin = self.equations, self.energy, every(self.state.th).lower()

        def functions(pick: Pick) -> Callable[[Ball, int], list[Jet]]:
            rolling = Rolling(equations, replace(self.state, th=begin, om=every(self.state.om)), 1)
            shift = pick(energy - energy.at)

            def found(th: Ball, terms: int) -> list[Jet]:  # linear in the energy
                rolling.energy = energy.at
                here = rolling.margins(th, terms)
                rolling.energy = energy.at + 1
                more = rolling.margins(th, terms)
                return [[a + (b - a) * shift for a, b in zip(*jets, strict=True)] for jets in zip(here, more, strict=True)]

            return found

        if what == SPAN:
            positive(functions(every), begin, self.finish.upper(), "rolling goes on to the next passage")
            s, c = self.finish.sin_cos()
            square = 2 * (energy - equations.height(self.finish, s, c)) / equations.inertia(c)
            self.state, self.mode = replace(self.state, th=self.finish, om=square.sqrt()), ""
            return
        require(what in ("ahead", "back"), "rolling ends in slip or at the next passage")
        index = ("ahead", "back").index(what)
        self._ahead(low, high)
        positive(functions(every), begin, low, f"rolling goes on up to its end ({what})")
        x = root(functions(every), index, low, high, f"rolling ends ({what})")
        exact = root(functions(middle), index, low, high, f"rolling ends ({what})")
        s, c = x.sin_cos()
        contact = equations.contact(s, c, 2 * (energy - equations.height(x, s, c)) / equations.inertia(c), 0)
        margin = equations.mu_s * contact.normal + (contact.friction if index else -contact.friction)
        th = Family(exact, -margin.by / functions(every)(x, 2)[index][1], self.reach, x)
        self.drive = 2 * energy.by / equations.inertia(c) if equations.equal_friction else None
        s, c = th.sin_cos()
        square = 2 * (energy - equations.height(th, s, c)) / equations.inertia(c)
        self.state = replace(self.state, th=th, om=square.sqrt())
        require(opening(equations, self.state) < 0, "contact goes on where rolling ends")
        self.mode, self.zeros = "K" if index else "S", 2 if equations.equal_friction else 1

    def slip(self, what: str, low: Ball, high: Ball) -> None:
        """Slip, from its start to its end."""
        state, equations, sigma = self.state, self.equations, SIGMA[self.mode]
        require(what in (LIFT, STOP), "slip ends by a stop or by lift-off")
        self._ahead(low, high)
        require(bool(low > every(state.th).upper()), "the end of slip is ahead")
        field = Field(equations, sigma)
        stretch = self._last(field, low, high)
        index, end = (LIFT, STOP).index(what), high - stretch.centre
        x = root(stretch.functions(every), index, arb(0), end, f"slip ends ({what})")
        exact = root(stretch.functions(middle), index, arb(0), end, f"slip ends ({what})")
        th, u, v = stretch.crossing(index, x, exact, self.reach)
        self.state = replace(state, th=th, vt=v, om=u.sqrt())
        self.drive, self.zeros = None, 3
        if what == LIFT:
            self.mode = "H"
            return
        # energy, which v_t = 0 makes stationary: how it varies does not depend on where slip stops
        arm, inertia = 1 + equations.eps * every(th).cos(), equations.inertia(every(th).cos())
        self.state = replace(self.state, vt=arb(0))
        found = self._energy()
        by = inertia * stretch.square(x).by / 2 + every(self.state.om) * arm * stretch.velocity(x).by
        self.energy = Family(found.at, by, self.reach, found.over)
        was = self.mode
        self._settle()
        require(self.mode != was, "slip that stops does not go on")

    def _last(self, field: Field, low: Ball, high: Ball) -> Stretch:
        """The stretch that slip ends on: it goes on up to the bracket of that."""
        state = self.state
        centre, u, v = moved(field, state.th, state.om * state.om, state.vt, self.reach, self.drive)
        begin, zeros, length = every(state.th) - centre, [0, self.zeros], arb(STEP)
        for _ in range(MOST_STRETCHES):
            end = (centre + length).min(low).mid()
            x = end - centre
            stretch = Stretch(field, centre, u, v, begin, x, self.terms)
            share = float(self.tolerance / stretch.rest(x).max(self.tolerance / MOST_GROWTH**self.terms))
            if share < 1 and length > LEAST_STEP:
                length *= max(0.9 * share ** (1 / self.terms), 0.2)
                continue
            positive(stretch.functions(every), begin, x, "slip goes on", zeros)
            centre, u, v = end, stretch.square(x), stretch.velocity(x)
            if not centre < low:
                return Stretch(field, centre, u, v, arb(0), high - centre, self.terms)
            begin, zeros, length = arb(0), [], length * (0.9 * share ** (1 / self.terms))
        raise Refused(f"slip takes no more than {MOST_STRETCHES} stretches")

    def fly(self, what: str, low: Ball, high: Ball) -> None:
        """Flight and the impact that ends it; the bracket is one of the time in flight."""
        equations, state = self.equations, self.state
        require(what == LAND and bool(low > 0), "flight ends in a landing")
        require(bool(equations.rest.is_zero()), "there is no restitution, which boxes with a hop do not cover")

        def functions(pick: Pick) -> Callable[[Ball, int], list[Jet]]:
            return lambda tau, terms: [[pick(one) for one in gap(equations, state, tau, terms)]]

        positive(functions(every), arb(0), low, "the gap is positive in flight", [self.zeros])
        tau = root(functions(every), 0, low, high, "the rim lands")
        exact = root(functions(middle), 0, low, high, "the rim lands")
        value, rate = gap(equations, state, tau, 2)
        landed = flown(equations, state, Family(exact, -change(value) / every(rate), self.reach, tau))
        require(bool(every(landed.th) < self.finish), "a landing comes before the next passage")
        self.state, _ = collide(equations, replace(landed, y=arb(0)), equations.rest)
        require(bool(self.state.vn.is_zero()), "the rim stays on the plane after a landing")
        self._settle()
        self.energy = self._energy()

    def _ahead(self, low: Ball, high: Ball) -> None:
        require(bool(every(self.state.th).lower() < low) and bool(low < high), "an event is ahead")
        require(bool(high < self.finish), "an event comes before the next passage")

    def _settle(self) -> None:
        """The mode that follows an event."""
        state = self.state
        require(bool(state.om > 0), "the hoop turns ahead")
        self.mode = self._next()
        self.zeros = 0 if sign(state.vt, "v_t") else 1

    def _next(self) -> str:
        try:
            mode = next_mode(self.equations, self.state)
        except TypeError:  # a tie: further derivatives break it for a single motion, not for all of them
            mode = ""
        require(mode in ("R", "S", "K"), "the mode that follows is one of contact, and is certain for all motions")
        return mode
