"""Motions in many digits: against the Taylor oracle, closed forms, symmetries, and the cases where doubles fail."""

from __future__ import annotations

import dataclasses
import math
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.precise import solve
from hophoop.precise.contact import advance
from hophoop.precise.jam import approach, ending
from hophoop.precise.problem import Body, Problem
from hophoop.precise.series import Judge
from oracle_program import essential, highest_apexes, scenario_of
from oracles import elliptic
from oracles import precise as oracle
from oracles.cases import CASES, JAM, by_name
from oracles.cases import rolling as rolling_case
from precise_tools import HOOP, STATE, events_of, precise, rolling, stored

COUNTED = [case.name for case in CASES if not case.rest_below]
ENDLESS = [case.name for case in CASES if case.rest_below]


def same(ours, true, digits, names=("t", *STATE)):
    """Two lists of events agree in kinds and, to so many digits beside 1 or themselves, in numbers."""
    assert [event["kind"] for event in ours] == [event["kind"] for event in true]
    for mine, right in zip(ours, true, strict=True):
        for name in names:
            error = abs(mpf(mine[name]) - mpf(right[name])) / max(1, abs(mpf(right[name])))
            assert error < mpf(10) ** -digits, (right["kind"], name, mine[name], right[name])


# Against the oracle, a Taylor solution written apart from this one


@pytest.mark.long
@pytest.mark.parametrize("name", COUNTED)
def test_reference_motions_to_all_digits_of_the_data(name):
    """25 digits are stored."""
    motion = hh.simulate(scenario_of(by_name(name)), digits=30)
    assert motion.digits_right >= 30
    true = stored(name)
    ours, theirs = essential(events_of(motion)), essential(highest_apexes(true["events"]))
    if true["status"] == "event_limit":
        ours = ours[: len(theirs)]
    else:
        assert motion.sequence == true["sequence"]
        for part in ("kinetic", "potential", "friction", "impact_normal", "impact_tangential"):
            assert abs(mpf(str(motion.energy[part])) - true["energy"][part]) < mpf(10) ** -21, part
    same(ours, theirs, 22)
    assert abs(motion.energy["residual"]) < Decimal("1e-28")


@pytest.mark.slow
@pytest.mark.parametrize("name", COUNTED)
def test_reference_motions_to_more_digits(name):
    """The oracle itself at 50 digits, apart from what it says to have."""
    case = by_name(name)
    truth = oracle.solve(case, digits=56)
    ours = essential(events_of(hh.simulate(scenario_of(case), digits=50)))
    theirs = essential(highest_apexes(truth.events))
    same(ours[: len(theirs)], theirs, 45)


@pytest.mark.parametrize("name", ENDLESS)
def test_limit_of_endless_bounces(name):
    """The oracle follows the bounces down to 1e-17 m/s; after that it stops counting, and so its digits end there."""
    motion = hh.simulate(scenario_of(by_name(name)), digits=20)
    true = [event for event in stored(name)["events"] if event["to"] != "H"]
    (limit,) = motion.find("bounce_limit")
    assert abs(mpf(str(limit.t)) - true[0]["t"]) < mpf(10) ** -15
    later = [event for event in events_of(motion) if event["t"] > mpf(str(limit.t)) and event["kind"] != "end"]
    same(later, essential(true[1:]), 14)


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
    start = hh.Start(angle=2.0)
    motion = precise(plane=hh.Plane(mu=5.0), start=start, duration=60.0)
    turns = [event.t for event in motion.find("turn")]
    assert len(turns) > 40
    halves = {round(b - a, 26) for a, b in pairwise(turns)}
    assert len(halves) == 1
    whole = precise(plane=hh.Plane(mu=5.0), start=start, duration=float(turns[30]) + 1e-3)
    assert whole.find("turn")[-1].t == turns[30]


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


# Symmetry and scale


def test_mirror_image():
    """(x, θ, β) → −(x, θ, β) mirrors the motion, S into K."""
    case = by_name("slope_10deg")
    mirrored = dataclasses.replace(case, slope=-case.slope, vx=-case.vx)
    one, other = (hh.simulate(scenario_of(c), digits=25) for c in (case, mirrored))
    assert other.sequence == one.sequence.translate(str.maketrans("SK", "KS"))
    for a, b in zip(one.events, other.events, strict=True):
        assert abs(a.t - b.t) < Decimal("1e-24")
        for name in ("x", "angle", "vx", "omega"):
            assert abs(getattr(a, name) + getattr(b, name)) < Decimal("1e-23")


def test_size_and_gravity_only_scale():
    """R and g times four: the same angles at the same times, speeds times four; the mass changes nothing but energies."""
    one = rolling(3.0, 0.8)
    other = precise(hh.Hoop.ideal(0.75, radius=4.0, mass=3.0), hh.Plane(mu=0.8, gravity=4 * 9.81), hh.Start.rolling(12.0))
    for a, b in zip(one.events, other.events, strict=True):
        assert abs(a.t - b.t) < Decimal("1e-29")
        assert abs(a.angle - b.angle) < Decimal("1e-28")
        assert abs(4 * a.vx - b.vx) < Decimal("1e-27")
        assert abs(48 * a.friction - b.friction) < Decimal("1e-25")


# What doubles cannot tell


def test_immediate_hop_is_decided_by_the_exact_doubles():
    """Beside √(gR/γ): the last double below rolls first, for 1e-13 s, the next ones above hop at once."""
    below = rolling(3.6166282640049716)
    assert below.sequence.startswith("RKRSH")
    assert 0 < below.find("slip_start")[0].t < Decimal("1e-12")
    speed = math.sqrt(9.81 / 0.75)
    for _ in range(4):
        exact = Fraction(speed) ** 2 * 3 / 4 - Fraction(9.81)
        motion = rolling(speed, duration=0.1)
        assert motion.sequence[0] == ("H" if exact > 0 else "R"), speed
        speed = math.nextafter(speed, 9.0)
    speed = math.sqrt(9.81 / 0.75)
    for _ in range(3):
        speed = math.nextafter(speed, 0.0)
        exact = Fraction(speed) ** 2 * 3 / 4 - Fraction(9.81)
        assert rolling(speed, duration=0.1).sequence[0] == ("H" if exact > 0 else "R"), speed


def need_of_friction(mu, speed, angle):
    """abs(F)/N − μ at its top beside an angle, from the closed form of rolling and Lagrange's equations, in 50 digits."""
    e, v0, g = mpf(0.75), mpf(speed), mpf(9.81)

    def ratio(th):
        c, s = mp.cos(th), mp.sin(th)
        u = (e * (1 - c) + v0**2 / g * (1 + e)) / (1 + e * c)
        alpha = e * s * (u + 1) / (2 * (1 + e * c))
        force = alpha * (1 + e * c) - e * s * u
        return abs(force / (1 - e * s * alpha - e * c * u))

    top = mp.findroot(lambda th: mp.diff(ratio, th), angle)
    return ratio(top) - mpf(mu)


def test_grazing_friction_is_told_from_slip():
    """The need of friction stays 6.1e-13 below what is there: it rolls on; with μ two parts in 10¹² lower it slips."""
    mu, speed = 0.386061279296875, 0.30991464919018996
    need = need_of_friction(mu, speed, 2.19)
    assert -7e-13 < need < -6e-13
    assert rolling(speed, mu).sequence == "R"
    lower = mu - 1e-12
    assert need_of_friction(lower, speed, 2.19) > 0
    slipped = rolling(speed, lower)
    assert slipped.sequence.startswith("RKR")
    slip, stick = slipped.events[1:3]
    assert stick.t - slip.t < Decimal("1e-4")


@pytest.mark.parametrize("digits", [20, 30])
def test_graze_by_a_hair(digits):
    """Margins of 1e-20 and less need friction that no double has: μ from two sides of the need, as close as doubles go."""
    speed = 0.30991464919018996
    exact = need_of_friction(0.0, speed, 2.19)
    nearest = float(exact)
    sides = (math.nextafter(nearest, 0.0), nearest, math.nextafter(nearest, 1.0))
    for mu in sides:
        motion = rolling(speed, mu, digits=digits)
        assert motion.sequence == ("R" if mpf(mu) > exact else motion.sequence)
        assert (len(motion.sequence) > 1) == (mpf(mu) < exact)


def test_minute_phases_are_found():
    """A roll of 8e-14 s between two slips, once the end of the motion."""
    motion = rolling(1.0421218631155353, 0.2511102238185704, duration=6.0)
    assert motion.sequence.startswith("RSRKRSRKR")
    stick, slip = motion.events[6:8]
    assert (stick.kind, slip.kind) == ("stick", "slip_start")
    assert Decimal("1e-14") < slip.t - stick.t < Decimal("1e-12")


def test_slip_that_begins_again_at_once_on_a_slope():
    """One of those that ended undetermined in double precision."""
    hoop = hh.Hoop(radius=0.15208666450676422, eccentricity=0.9999996776578876, inertia_ratio=2.533135274746937e-6)
    plane = hh.Plane(mu=0.25835497867717905, slope=-0.23898338276734932)
    start = hh.Start.rolling(-0.38972433046605987, angle=-0.5056541081270356)
    motion = precise(hoop, plane, start, duration=1.0, digits=20)
    assert motion.ok
    assert motion.digits_right >= 20
    assert set(motion.sequence) <= set("RSKH")


@pytest.mark.parametrize("offset", [1e-15, 5e-15, -1e-12])
def test_beside_an_unstable_equilibrium_it_moves(offset):
    """θ grows as cosh(λ t) at first, λ² = γ g/(2 R (1 + γ)) in rolling."""
    motion = precise(start=hh.Start(angle=offset), duration=2.0)
    assert motion.sequence == "R"
    rate = mp.sqrt(mpf(0.75) * mpf(9.81) / mpf(3.5))
    true = mpf(offset) * mp.cosh(2 * rate)
    assert abs(mpf(str(motion.events[-1].angle)) / true - 1) < mpf(10) ** -20


def test_rest_stays_at_rest():
    """Exactly at the top or the bottom of a level plane, and the disk anywhere."""
    top = precise()
    assert (top.status, [event.kind for event in top.events]) == ("at_rest", ["start", "rest", "end"])
    assert top.find("rest")[0].stable is False
    disk = precise(hh.Hoop(eccentricity=0.0, inertia_ratio=1.0), start=hh.Start(angle=1.0))
    assert disk.status == "at_rest"
    smooth = precise(plane=hh.Plane(mu=0.0))
    assert smooth.status == "at_rest"


def test_sliding_without_rotation():
    """μ = 0, load at the top, no spin: it slides on for ever, and with friction on a disk v_t falls as a line."""
    motion = precise(plane=hh.Plane(mu=0.0), start=hh.Start(vx=1.5), duration=2.0)
    assert motion.sequence == "K"
    assert motion.events[-1].x == 3
    disk = precise(hh.Hoop(eccentricity=0.0, inertia_ratio=1.0), hh.Plane(mu=0.25), hh.Start(vx=2.0))
    (stick,) = disk.find("stick")
    with mp.workdps(40):  # v_t falls at μ g (1 + 1/κ)
        assert abs(mpf(str(stick.t)) - 2 / (mpf(9.81) / 2)) < mpf(10) ** -29


def test_the_massless_hoop_is_refused():
    with pytest.raises(ValueError, match=r"^digits = 30 needs a rim with mass: the massless hoop .* double precision only\.$"):
        rolling(0.5, 2.0, hoop=hh.Hoop.ideal(1.0), duration=6.0)


INDETERMINATE = by_name("indeterminate_as_impact")


def ideal(start, **plane):
    return hh.Scenario(hoop=HOOP, plane=hh.Plane(**plane), start=start, duration=3.0)


@pytest.mark.parametrize(
    ("scenario", "what"),
    [
        # nothing holds the rim: it flies; with the load behind the contact rolling pulls, with it ahead it presses
        (ideal(hh.Start.rolling(1.0), gravity=0.0), "start"),
        (ideal(hh.Start.rolling(1.0, angle=2.5), gravity=0.0), "start"),
        # rolling until N = 0; where free motion would enter the plane, nothing is determined
        *((ideal(hh.Start.rolling(speed), mu=math.inf), "end") for speed in (1.0, 3.0)),
        # indeterminate: as the plane asks for
        *((scenario_of(INDETERMINATE, painleve=one), "painleve_indeterminate") for one in ("flight", "impact")),
    ],
)
def test_it_goes_as_the_kernel_has_it(scenario, what):
    ours, kernel = hh.simulate(scenario, digits=20), hh.simulate(scenario)
    assert [event.kind for event in ours.events] == [event.kind for event in kernel.events]
    assert (ours.sequence, ours.status) == (kernel.sequence, kernel.status)
    assert float(ours.duration) == pytest.approx(kernel.duration, rel=1e-12)
    assert ours.find(what)


def test_kanes_gain():
    """Newton's law with friction that stops the slip creates energy: the event, and the ledger that shows it."""
    newton = {"impact_law": "newton", "restitution": 0.9, "mu_static": 1.5, "mu_kinetic": 1.5}
    case = dataclasses.replace(by_name("reversal_in_impact"), **newton)
    ours, kernel = hh.simulate(scenario_of(case), digits=20), hh.simulate(scenario_of(case))
    gains = [float(event.gain) for event in ours.find("kane_gain")][:5]
    assert gains == pytest.approx([event.gain for event in kernel.find("kane_gain")][: len(gains)], rel=1e-9)
    assert abs(ours.energy["residual"]) < Decimal("1e-19")


def test_apex_is_higher_than_the_start():
    """Thrown down in free space with spin, the gap has tops on its way; none is as high as the start: no apex."""
    plane = hh.Plane(gravity=0.0, mu=0.0)
    hoop = hh.Hoop(radius=1.4183860456955892, eccentricity=0.28770369934905493, inertia_ratio=0.26132841846141935)
    start = hh.Start(
        angle=-3.983657756686453, vx=1.8, omega=-3.517763724036154, height=0.9771388712089832, vy=-1.4800663946968728
    )
    motion = precise(hoop, plane, start, duration=7.6)
    kernel = hh.simulate(hoop, plane, start, duration=7.6)
    impact = motion.find("impact")[0]
    assert float(impact.t) == pytest.approx(kernel.find("impact")[0].t, rel=1e-12)
    rates = [kernel.at(t).vy for t in kernel.times(2000) if t < impact.t]
    assert any(a > 0 > b for a, b in pairwise(rates))  # there is a top
    assert not [event for event in motion.find("apex") if event.t < impact.t]


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
