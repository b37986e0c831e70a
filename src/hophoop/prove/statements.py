"""The article's statements that are inequalities or sequences, proved for its own numbers.

The article's scenarios are repeated here, since `hophoop.article` is a layer above this package.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Jet, arb, coefficients, order, pi, precision, series
from hophoop.prove.enclosures.maxima import highest
from hophoop.prove.enclosures.roots import exact
from hophoop.prove.physics.equations import Model
from hophoop.prove.proof import Proof, ProvedEvent, prove
from hophoop.prove.thresholds import Rolling, first_slip, needed_friction
from hophoop.scenario import Hoop, Plane, Scenario, Start

GAMMA, GRAVITY = 0.75, 9.81
BITS, DIGITS = 120, 12
DEGREE = Fraction(314159265358979, 180 * 10**14)  # rounded: only comparisons far from equality use it


@dataclass(frozen=True)
class ProvedStatement:
    """A statement of the article and whether it is proved.

    Attributes
    ----------
    key : str
        As in the article's table of statements.
    statement : str
        What is proved, in our words.
    proved : bool
    """

    key: str
    statement: str
    proved: bool


def _scenario(speed: float, mu: float, duration: float) -> Scenario:
    return Scenario(hoop=Hoop.ideal(GAMMA), plane=Plane(mu=mu, gravity=GRAVITY), start=Start.rolling(speed), duration=duration)


def statements() -> list[ProvedStatement]:
    """Prove the article's statements that are inequalities or sequences of events.

    Returns
    -------
    statements : list of ProvedStatement

    References
    ----------
    :cite:t:`Sonnerlind2023`.
    """
    with precision(BITS):
        forces = list(_of_rolling())
    return [ProvedStatement(*one) for one in (*forces, *_of_motions())]


# --- rolling ---------------------------------------------------------------------------------------


def _w(speed: str) -> Ball:
    return arb(speed) ** 2 / arb("9.81")


def _least_normal(rolling: Rolling, w: Ball) -> Ball:
    """The least N in a turn, in units of m g."""

    def function(th: Ball, terms: int) -> Jet:
        return [-value for value in rolling.forces(th, w, terms)[1]]

    return -highest(function, arb(0), exact((2 * pi()).upper())).value


def _square(model: Model, w: Ball) -> Callable[[Ball, int], Jet]:
    """θ̇² in rolling over (1 + ε cos θ): a function of cos θ alone, whose slope in cos θ must not change sign."""

    def function(cosine: Ball, terms: int) -> Jet:
        with order(terms):
            c = series([cosine, 1])
            whole = model.inertia(arb(1)) * w / 2 + model.eps
            return coefficients(2 * (whole - model.eps * c) / model.inertia(c), terms)

    return function


def _of_rolling() -> Iterator[tuple[str, str, bool]]:
    """Statements on forces and speeds along a turn of rolling."""
    model = Model(Problem.of(_scenario(2.0, 1.0, 1.0)))
    rolling = Rolling(model)
    slow, fast = _w("0.1"), _w("2")
    for w, name in ((slow, "0.1"), (fast, "2")):
        falls = all(_square(model, w)((arb(k) / 16).union(arb(k + 1) / 16) - 1, 2)[1] < 0 for k in range(32))
        yield (
            "largest_angular_velocity",
            f"In rolling from {name} m/s the angular velocity grows until the load is down, and falls from there on.",
            falls,
        )
    needed, more = needed_friction(model, slow), needed_friction(model, fast)
    share = bool(needed > arb("0.375")) and bool(needed < arb("0.385"))
    yield "friction_needed", "Rolling through the turn at 0.1 m/s needs a friction between 0.375 and 0.385.", share
    yield "faster_friction_used", "At 2 m/s more than twice as large a part of the friction is used.", bool(more > 2 * needed)
    least = [_least_normal(rolling, w) for w in (slow, fast)]
    yield (
        "normal_force",
        "The least normal force at 2 m/s is smaller than at 0.1 m/s, and both are positive.",
        bool(least[1] > 0) and bool(least[1] < least[0]),
    )
    speed = first_slip(model) * model.speed
    yield (
        "critical_speed", "The first turn is rolled up to a speed between 2.043 and 2.044 m/s, and not above it.",
        bool(speed > arb("2.043")) and bool(speed < arb("2.044")),
    )  # fmt: skip


# --- motions ---------------------------------------------------------------------------------------


def _at(proof: Proof, kind: str, which: int = 0) -> Fraction:
    """Angle of an event, in degrees, to some digits."""
    found = [event for event in proof.events if event.kind == kind][which]
    return Fraction(found.angle.middle) / DEGREE


def _of_motions() -> Iterator[tuple[str, str, bool]]:
    """Statements on sequences of events and where they are."""
    for speed, mu in ((0.1, 1.0), (2.0, 1.0)):
        proof = prove(_scenario(speed, mu, 6.0), DIGITS)
        rolls = proof.proved and proof.sequence == "R"
        yield "rolls", f"From {speed:g} m/s the motion is pure rolling for 6 s.", rolls
    proof = prove(_scenario(2.8, 1.0, 2.0), DIGITS)
    yield (
        "slips", "From 2.8 m/s the hoop slips ahead, rolls, over-rotates and rolls again, without a hop, in its first 2 s.",
        proof.proved and proof.sequence.startswith("RKRSR") and "H" not in proof.sequence,
    )  # fmt: skip
    proof = prove(_scenario(3.1, 1.0, 3.0), DIGITS)
    takes_off = proof.proved and 270 < _at(proof, "takeoff") < 360
    yield "hops", "From 3.1 m/s the hoop leaves the plane in the last quarter of its first turn.", takes_off
    impact = next((k for k, event in enumerate(proof.events) if event.kind == "impact"), 0)
    rolls = impact > 0 and proof.events[impact].to_mode == "R"
    yield "landing", "After the landing there is pure rolling.", rolls
    again = rolls and any(event.kind == "slip_start" for event in proof.events[impact:])
    yield "landing_slips", "After the landing there is slip again within 3 s of the start.", again
    yield from _of_energies(proof)
    flight = [event.omega for event in proof.events if event.kind in ("takeoff", "apex")]
    yield "constant_rotation", "In flight the angular velocity is constant.", len(flight) == 2 and flight[0] == flight[1]
    yield (
        "massless_slips", "Hoops with γ = 0.9 on μ = 1 and γ = 0.99 on μ = 10 and 100 slip before the load is down.",
        all(_slips_on_the_way_down(gamma, mu) for gamma, mu in ((0.9, 1.0), (0.99, 10.0), (0.99, 100.0))),
    )  # fmt: skip
    proof = prove(_scenario(0.1, 0.3, 6.0), DIGITS)
    turns = [event for event in proof.events if event.kind == "turn"]
    highest_angle = max(
        (Fraction(event.angle.middle) + Fraction(event.angle.radius) for event in proof.events), default=Fraction(7)
    )
    rocks = proof.proved and len(turns) >= 1 and highest_angle < Fraction(Decimal("6.28318"))
    yield (
        "low_friction_rocks",
        "From 0.1 m/s on μ = 0.3 the hoop turns back within 6 s, before the load is at the top again.",
        rocks,
    )
    slips = sum(event.kind == "slip_start" for event in proof.events)
    yield "low_friction_slips", "With that friction it slips at least three times in 6 s.", proof.proved and slips >= 3


def _slips_on_the_way_down(gamma: float, mu: float) -> bool:
    scenario = _scenario(0.1, mu, 6.0).with_values({"hoop.load_fraction": gamma})
    events = prove(scenario, DIGITS, until="revolution").events
    slips = [event for event in events if event.kind == "slip_start"]
    return bool(slips) and Fraction(slips[0].angle.middle) / DEGREE < 179


def _energies(event: ProvedEvent) -> tuple[Ball, Ball]:
    """(kinetic, potential) energy of the article's hoop just after an event; potential is 0 with the load up [J]."""
    th, height, vx, vy, om = (
        arb(str(one.middle), str(one.radius)) for one in (event.angle, event.height, event.vx, event.vy, event.omega)
    )
    load, s, c = arb(GAMMA), th.sin(), th.cos()
    kinetic = ((vx + load * om * c) ** 2 + (vy - load * om * s) ** 2 + (1 - load**2) * om**2) / 2
    return kinetic, arb(GRAVITY) * (height + load * (c - 1))


def _of_energies(proof: Proof) -> Iterator[tuple[str, str, bool]]:
    """Statements on the energy of the hop: from the states just after its events, in which it is lost in slip and impact."""
    with precision(BITS):
        found = {event.kind: _energies(event) for event in proof.events if event.kind in ("start", "takeoff", "impact")}
        in_flight = _energies(prove(_scenario(3.1, 1.0, 1.3), DIGITS).events[-1])[1]
        kept = {kind: kinetic + potential for kind, (kinetic, potential) in found.items()}
        impact_loss, slip_loss = kept["takeoff"] - kept["impact"], kept["start"] - kept["takeoff"]
        yield (
            "positive_potential",
            "In the hop the potential energy is above zero for a while: at 1.3 s, and neither at take-off nor landing.",
            bool(in_flight > 0) and bool(found["takeoff"][1] < 0) and bool(found["impact"][1] < 0),
        )  # fmt: skip
        yield (
            "impact_loss", "The landing loses more than three times as much energy as all slip before it.",
            bool(impact_loss > 3 * slip_loss) and bool(slip_loss > 0),
        )  # fmt: skip
