"""Motions in many digits: against the Taylor oracle, closed forms, symmetries, and the cases where doubles fail."""

import dataclasses
import math
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.kernel.physics.body import Mode
from hophoop.precise import solve
from hophoop.precise.contact import advance
from hophoop.precise.jam import approach, ending
from hophoop.precise.motion import Run
from hophoop.precise.problem import Body, Problem
from hophoop.precise.series import Judge, MorePrecision
from oracle_program import STATE, compare_events, scenario_of
from oracles import elliptic
from oracles.cases import CASES, JAM, by_name
from oracles.cases import rolling as rolling_case
from precise_tools import precise, rolling, stored

COUNTED = [case.name for case in CASES if not case.rest_below]
ENDLESS = [case.name for case in CASES if case.rest_below]


# Against the oracle, a Taylor solution written apart from this one


@pytest.mark.long
@pytest.mark.parametrize("name", COUNTED)
def test_reference_motions_to_all_digits_of_the_data(name):
    """25 digits are stored."""
    motion = hh.simulate(scenario_of(by_name(name)), digits=30)
    assert motion.digits_right >= 30
    true = stored(name)
    if true["status"] != "event_limit":
        assert motion.sequence == true["sequence"]
        for part in ("kinetic", "potential", "friction", "impact_normal", "impact_tangential"):
            assert abs(mpf(str(motion.energy[part])) - true["energy"][part]) < mpf(10) ** -21, part
    compare_events(motion, true["events"], 22, ("t", *STATE))
    assert abs(motion.energy["residual"]) < Decimal("1e-28")


@pytest.mark.parametrize("name", ENDLESS)
def test_limit_of_endless_bounces(name):
    """The oracle follows the bounces down to 1e-17 m/s; after that it stops counting, and so its digits end there."""
    motion = hh.simulate(scenario_of(by_name(name)), digits=20)
    true = [event for event in stored(name)["events"] if event["to"] != "H"]
    (limit,) = motion.find("bounce_limit")
    assert abs(mpf(str(limit.t)) - true[0]["t"]) < mpf(10) ** -15
    compare_events(motion, true[1:], 14, ("t", *STATE), limit.t)


def test_limit_of_a_disks_bounces_is_a_geometric_series():
    """t∞ = √(2h/g) (1 + e)/(1 − e), to the digits asked."""
    plane = hh.Plane(mu=0.3, restitution=0.5)
    motion = precise(hh.Hoop(eccentricity=0.0, inertia_ratio=0.5), plane, hh.Start(height=0.25), digits=40)
    limit = mp.sqrt(2 * mpf(0.25) / mpf(9.81)) * 3
    assert abs(mpf(str(motion.find("bounce_limit")[0].t)) - limit) < mpf(10) ** -40


# Closed forms


@pytest.mark.parametrize("speed", [1e-9, 0.5, 2.0])
def test_rolling_against_elliptic_integrals(speed):
    """Time and rate of rolling, also past the top at a nanometre a second."""
    case = rolling_case("arc", speed, 1.0)
    motion = rolling(speed, mu=50.0, duration=7.0, digits=40)
    end = motion.events[-1]
    angle = mpf(str(end.angle))
    assert abs(elliptic.rolling_time(case, angle) - 7) < mpf(10) ** (-37 if speed > 0.1 else -28)
    assert abs(elliptic.rolling_rate(case, angle) - mpf(str(end.omega))) < mpf(10) ** -37


def test_many_turns_keep_their_digits():
    """A thousand turns of rolling: whole ones are counted, not added up."""
    motion = rolling(2.0, mu=50.0, duration=2500.0)
    end = motion.events[-1]
    assert end.angle > 6000
    true = elliptic.rolling_time(rolling_case("turns", 2.0, 50.0), mpf(str(end.angle)))
    assert abs(true - 2500) < mpf(10) ** -25


def test_rocking_repeats():
    """Rolling to and fro: all turns are there, half a period apart, as the theory has it."""
    motion = precise(plane=hh.Plane(mu=5.0), start=hh.Start(angle=2.0), duration=60.0)
    turns = [event.t for event in motion.find("turn")]
    assert len(turns) > 40
    halves = {round(b - a, 26) for a, b in pairwise(turns)}
    assert len(halves) == 1


def test_jam_in_closed_form():
    """At the jam p_σ = 0 and f_n = 0, both to the digits asked, though f_n falls as a small power of p_σ."""
    motion = hh.simulate(scenario_of(JAM), digits=30)
    assert motion.status == "jammed"
    (jam,) = motion.find("jam")
    assert jam.digits_right >= 30
    th, om = mpf(str(jam.angle)), mpf(str(jam.omega))
    eps, kap, mu = mpf(JAM.eccentricity), mpf(JAM.inertia_ratio), mpf(JAM.mu_kinetic)
    p = kap + eps * mp.sin(th) * (eps * mp.sin(th) + mu * (1 + eps * mp.cos(th)))
    assert abs(p) < mpf(10) ** -28
    assert abs(eps * mp.cos(th) * om**2 - mpf(JAM.gravity)) < mpf(10) ** -27
    assert jam.slip > 0
    # the kernel comes as near as its panels go
    assert float(jam.t) == pytest.approx(hh.simulate(scenario_of(JAM)).duration, rel=1e-9)


# What doubles cannot tell


def test_immediate_hop_is_decided_by_the_exact_doubles():
    """Beside √(gR/γ): the last double below rolls first, for 1e-13 s, the next ones above hop at once."""
    below = rolling(3.6166282640049716)
    assert below.sequence.startswith("RKRSH")
    assert 0 < below.find("slip_start")[0].t < Decimal("1e-12")
    speed = math.sqrt(9.81 / 0.75)
    for ulps in range(-3, 4):
        close = speed + ulps * math.ulp(speed)
        hops = Fraction(close) ** 2 * 3 / 4 > Fraction(9.81)
        assert rolling(close, duration=0.1).sequence[0] == ("H" if hops else "R"), close


def needed_friction(speed, angle):
    """abs(F)/N at its top beside an angle, from the closed form of rolling and Lagrange's equations, in 50 digits."""
    e, v0, g = mpf(0.75), mpf(speed), mpf(9.81)

    def ratio(th):
        c, s = mp.cos(th), mp.sin(th)
        u = (e * (1 - c) + v0**2 / g * (1 + e)) / (1 + e * c)
        alpha = e * s * (u + 1) / (2 * (1 + e * c))
        force = alpha * (1 + e * c) - e * s * u
        return abs(force / (1 - e * s * alpha - e * c * u))

    return ratio(mp.findroot(lambda th: mp.diff(ratio, th), angle))


@pytest.mark.parametrize("digits", [20, 30])
def test_graze_by_a_hair(digits):
    """Margins of 1e-20 and less need friction that no double has: μ from two sides of the need, as close as doubles go."""
    speed = 0.30991464919018996
    exact = needed_friction(speed, 2.19)
    nearest = float(exact)
    sides = (math.nextafter(nearest, 0.0), nearest, math.nextafter(nearest, 1.0))
    for mu in sides:
        motion = rolling(speed, mu, digits=digits)
        assert (len(motion.sequence) > 1) == (mpf(mu) < exact)


@pytest.mark.parametrize("offset", [1e-15, 5e-15, -1e-12])
def test_beside_an_unstable_equilibrium_it_moves(offset):
    """θ grows as cosh(λ t) at first, λ² = γ g/(2 R (1 + γ)) in rolling."""
    motion = precise(start=hh.Start(angle=offset), duration=2.0)
    assert motion.sequence == "R"
    rate = mp.sqrt(mpf(0.75) * mpf(9.81) / mpf(3.5))
    true = mpf(offset) * mp.cosh(2 * rate)
    assert abs(mpf(str(motion.events[-1].angle)) / true - 1) < mpf(10) ** -20


def test_the_massless_hoop_is_refused():
    with pytest.raises(ValueError, match=r"^digits = 30 needs a rim with mass: the massless hoop .* double precision only\.$"):
        rolling(0.5, 2.0, hoop=hh.Hoop.ideal(1.0), duration=6.0)


INDETERMINATE = "hoop.eccentricity=0.75&hoop.inertia_ratio=0.4375&plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5"


@pytest.mark.parametrize(
    ("link", "what"),
    [
        # nothing holds the rim: it flies; with the load behind the contact rolling pulls, with it ahead it presses
        ("plane.gravity=0&start.speed=1", "start"),
        ("plane.gravity=0&start.angle=2.5&start.speed=1", "start"),
        # rest at the top; slip without rotation goes on for ever
        ("start.angle=0", "rest"),
        ("plane.mu=0&start.vx=1.5", "end"),
        # rolling until N = 0; where free motion would enter the plane, nothing is determined
        ("plane.mu=inf&start.speed=1", "end"),
        ("plane.mu=inf&start.speed=3", "end"),
        # indeterminate: as the plane asks for
        (INDETERMINATE, "painleve_indeterminate"),
        (f"{INDETERMINATE}&plane.painleve=impact", "painleve_indeterminate"),
    ],
)
def test_it_goes_as_the_kernel_has_it(link, what):
    scenario = hh.Scenario.from_query(f"duration=3&{link}")
    ours, kernel = hh.simulate(scenario, digits=20), hh.simulate(scenario)
    assert [event.kind for event in ours.events] == [event.kind for event in kernel.events]
    assert (ours.sequence, ours.status) == (kernel.sequence, kernel.status)
    assert float(ours.duration) == pytest.approx(kernel.duration, rel=1e-12)
    assert ours.find(what)


# Exact input


def test_doubles_are_exact_numbers():
    """κ of an ideal hoop is 1 − γ², of parts what follows from their numbers; neither is rounded."""
    gamma = 1 - 1e-9
    assert Problem.of(hh.Scenario(hoop=hh.Hoop.ideal(gamma))).kap == 1 - Fraction(gamma) ** 2
    parts = [hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27), hh.Rod(0.1, 0.2, at=0.1), hh.PointMass(0.1, at=-0.2)]
    hoop = hh.Hoop.from_parts(radius=0.3, parts=parts)
    problem = Problem.of(hh.Scenario(hoop=hoop))
    assert float(problem.eps) == pytest.approx(hoop.eccentricity, rel=1e-15)
    assert float(problem.kap) == pytest.approx(hoop.inertia_ratio, rel=1e-14)
    assert float(problem.mass) == hoop.mass
    start = Problem.of(hh.Scenario(hoop=hoop, start=hh.Start.rolling(0.1)))
    assert (start.slip, start.omega) == (0, Fraction(0.1) / Fraction(0.3))


@pytest.mark.parametrize("hair", [0.3, 1e-3, 1e-5])
def test_slip_stops_just_before_the_jam(hair):
    """With a slip velocity that is a hair too small for the jam, slip stops within a tiny angle of p_σ = 0, or sooner.

    There v_t changes its sign, and what the energy lacks is what friction took.
    """
    body = Body(Problem.of(scenario_of(JAM)), 110)
    state = solve(scenario_of(JAM), 30).records[0].state
    judge = Judge(110, True)
    begin = body.start()
    assert float(begin.vt) == pytest.approx(float(state.vt))
    _, near = advance(body, judge, 1, begin, 0, body.ctx.mpf("0.4222"))
    ahead = approach(body, near, 1)
    assert ahead is not None
    assert 0 < ahead.power < 1
    jams, last = ending(ahead)
    assert jams
    assert last.vt > 0
    slower = dataclasses.replace(ahead, state=near._replace(vt=near.vt - last.vt - body.ctx.mpf(hair)))
    found = ending(slower)
    if hair > 0.1:
        assert found is None  # soon enough for steps in time
        return
    jams, end = found
    assert not jams
    assert end.vt == 0
    missing = ahead.singular - end.th
    assert 0 < missing < ahead.extent * body.ctx.exp(-40)
    for factor, sign in ((2, 1), (0.5, -1)):
        assert sign * slower.at(factor * missing / ahead.extent).vt > 0
    assert end.friction > 0


# What the solver is made of


def test_what_a_motion_replaces_is_there():
    """Every name that extended precision replaces is one that the kernel's steps read."""
    run = Run(Problem.of(hh.Scenario(start=hh.Start.rolling(3.1))), 110, False, 1e-20)
    run.run()
    read = {name for copy in run.kernels._copies.values() for name in copy.__code__.co_names}
    assert set(run.kernels._names) - read == {"sine", "sine_cosine_change"}  # of energies and flight, by the body's own copies


def test_a_tie_asks_for_more_digits_until_there_are_none():
    """At √(gR/γ) N is zero at the start: only at the last precision the derivative decides."""
    scenario = hh.Scenario.from_query("duration=0.2&plane.gravity=3&start.speed=2")
    with pytest.raises(MorePrecision):
        Run(Problem.of(scenario), 150, False, 1e-20).run()
    assert Run(Problem.of(scenario), 150, True, 1e-20).run().records[0].after_mode == Mode.SKID
