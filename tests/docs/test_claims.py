"""The claims of the literature (docs/claims.toml): each number of ours is computed here, and some again by hand."""

import math
import tomllib
from decimal import Decimal
from functools import cache

import pytest
from scipy.optimize import bisect

from checkout import text_of
from hophoop import theory
from hophoop.article.scenarios import GAMMA, scenarios
from hophoop.maps import catalogue, catalogued
from hophoop.scenario import Disk, Hoop, Plane, Start
from hophoop.simulation.simulate import simulate

CLAIMS = tomllib.loads(text_of("docs/claims.toml"))
WORKS = CLAIMS.pop("works")
HOOP, PLANE = Hoop.ideal(GAMMA), Plane(mu=1.0)
WITHOUT_LIMIT = Plane(mu=math.inf)


def _angle(motion, kind):
    """Angle at the first event of a kind [°]."""
    return math.degrees(motion.find(kind)[0].angle)


# The massless hoop


@cache
def _skimming():
    return simulate(Hoop.ideal(1.0), Plane(mu=2.0), Start.rolling(1e-3), duration=6.0)


def massless_loss_angle():
    """Angle at which the contact force of the massless hoop vanishes after the smallest push [°]."""
    return math.degrees(float(theory.massless_loss(0.0, plane=Plane(mu=2.0)).angle))


def massless_skim_angle():
    """The same in the computed motion from 1 mm/s [°]."""
    return _angle(_skimming(), "skim")


@cache
def massless_height():
    """Maximum height of the massless hoop above the plane, at and between events [m]."""
    motion = _skimming()
    times = motion.times(2001)
    return max(*(float(height) for height in motion.at(times).height), *(event.height for event in motion.events))


def massless_fall():
    """Time from the loss of the force until the load strikes the plane [s]."""
    motion = _skimming()
    return motion.find("impact")[0].t - motion.find("skim")[0].t


def massless_strike():
    """The angle at which the load strikes the plane [°]."""
    return _angle(_skimming(), "impact")


def massless_hop_speed():
    """Minimum speed at which the massless hoop has no contact force at the start [m/s]."""
    return float(theory.immediate_hop_speed(Hoop.ideal(1.0)))


# The hoop with mass in its rim


@cache
def _hop():
    return simulate(scenarios()["hop"])


def take_off_angle():
    """Angle of the reference hoop's take-off at 3.1 m/s [°]."""
    return _angle(_hop(), "takeoff")


def slip_before_take_off():
    """Rotation in slip before the take-off [°]."""
    off = _hop().find("takeoff")[0]
    return math.degrees(off.angle - max(event.angle for event in _hop().find("slip_start") if event.t < off.t))


def take_offs_out_of_rolling():
    """Number of classes of the first revolution, at any γ of the catalogue, with a take-off from rolling."""
    return sum(entry.sequence.endswith("RH") for gamma in catalogued() for entry in catalogue(gamma))


@cache
def force_lost_speed():
    """Minimum speed at which rolling needs a negative normal force with any friction [m/s]."""

    def sign(speed):
        return 1 if math.isinf(theory.needed_friction(HOOP, speed, WITHOUT_LIMIT).mu) else -1

    return bisect(sign, 2.0, float(theory.immediate_hop_speed(HOOP)))


def first_hop_speed():
    """Minimum speed of a take-off of the reference hoop in its first revolution [m/s]."""
    return float(theory.first_hop_speed(HOOP, PLANE))


def immediate_hop_speed():
    """Minimum speed at which the reference hoop leaves the plane at the start [m/s]."""
    return float(theory.immediate_hop_speed(HOOP))


def sequences():
    """Number of sequences of phases in the first revolution, γ = 3/4, with any ending."""
    return len({entry.sequence for entry in catalogue(GAMMA)})


def sequences_with_endings():
    """Number of sequences with their endings, γ = 3/4."""
    return len(catalogue(GAMMA))


# Friction without limit, slopes


@cache
def _quasi_jump():
    return simulate(HOOP, WITHOUT_LIMIT, Start.rolling(3.1), duration=2.0).events[-1]


def quasi_jump_angle():
    """Angle at which N vanishes in rolling with infinite friction, with 3.1 m/s at the top [°]."""
    return math.degrees(_quasi_jump().angle)


def quasi_jump_free_acceleration():
    """Free acceleration of the contact point away from the plane there [m/s²]."""
    event = _quasi_jump()
    return GAMMA * float(event.omega) ** 2 * math.cos(event.angle) - PLANE.gravity


@cache
def _cylinder(mu):
    body = Hoop.from_parts(radius=0.05, parts=[Disk(0.02, 0.05), Disk(0.06, 0.003, at=0.04)])
    slope = math.radians(30.0)
    return simulate(body, Plane(mu=mu, slope=slope), Start(angle=-slope + 0.02), duration=1.0)


def cylinder_slip_angle():
    """Angle of the first slip of a cylinder with a rod, released on 30° with μ = 1 [°]."""
    return _angle(_cylinder(1.0), "slip_start")


def cylinder_jump_angle():
    """Angle at which it leaves the slope [°]."""
    return _angle(_cylinder(1.0), "takeoff")


def cylinder_force_lost_angle():
    """Angle at which N vanishes if the same cylinder rolls without slip [°]."""
    return math.degrees(_cylinder(math.inf).events[-1].angle)


# Painlevé's paradox, impacts


def painleve_friction():
    """Minimum friction of Painlevé's paradox, γ = 3/4."""
    return float(theory.painleve_minimum(HOOP).mu)


@cache
def _jam():
    return simulate(Hoop.ideal(0.85), Plane(mu=0.8), Start.rolling(8.9), duration=2.0)


def jam_angle():
    """Angle at which a launched hoop with γ = 0.85, μ = 0.8, 8.9 m/s jams [°]."""
    return _angle(_jam(), "jam")


def jam_angle_of_theory():
    """The same from p_σ = 0 and f_n = 0 alone [°]."""
    states = theory.jam_states(Hoop.ideal(0.85), Plane(mu=0.8))
    here = math.radians(jam_angle())
    return math.degrees(min((state.angle for state in states), key=lambda angle: abs(angle - here)))


def _near_painleve(part):
    threshold = float(theory.painleve_threshold(-0.7, HOOP))
    return simulate(HOOP, Plane(mu=threshold * part), Start(angle=-0.7, vx=3.0, omega=1.0), duration=0.01)


def impulse_without_collision():
    """Impulse of the impact without collision just above Painlevé's threshold, θ = −0.7, v_t = 2 m/s [N s]."""
    return next(event for event in _near_painleve(1.0 + 1e-9).find("impact") if not event.collision).impulse_normal


def impulse_of_slip():
    """Impulse that stops the slip below the threshold by the relative distance 10⁻⁶ [N s]."""
    body = _near_painleve(1.0 - 1e-6)
    stop = body.find("stick")[0]
    # the normal impulse is the change of momentum of G plus the impulse of gravity
    rise = [one.vy - HOOP.eccentricity * one.omega * math.sin(one.angle) for one in (body.at(0.0), stop)]
    return HOOP.mass * (rise[1] - rise[0] + PLANE.gravity * float(stop.t))


@cache
def _blow(law, mu=0.5, restitution=1.0):
    body = Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.39)
    plane = Plane(mu=mu, restitution=restitution, impact_law=law)
    return simulate(body, plane, Start(angle=-math.atan2(4.0, 3.0), vx=-1.0, vy=-3.0), duration=0.01)


def kane_gain():
    """Energy gained by Newton's law in an impact of 5 J with friction [J]."""
    return float(_blow("newton").find("kane_gain")[0].gain)


def stronge_separation():
    """Velocity of separation after the same impact under Stronge's law [m/s]."""
    return float(_blow("stronge").find("impact")[0].vy)


def stronge_normal_loss():
    """Energy lost in the normal direction by the same impact under Stronge's law with e = 1 [J]."""
    return abs(float(_blow("stronge").find("impact")[0].impact_normal))


def routh_reversal():
    """Slip velocity after a plastic impact with too little friction to stop it, backwards before [m/s]."""
    return float(_blow("stronge", 0.125, 0.0).find("impact")[0].slip)


# Claims


@pytest.mark.parametrize("key", CLAIMS)
def test_our_number_comes_out_again(key):
    claim = CLAIMS[key]
    value, places = float(globals()[claim["compute"]]()), -Decimal(claim["ours"]).as_tuple().exponent
    assert abs(value - float(claim["ours"])) <= 0.5000001 * 10.0**-places
    if "theirs_number" in claim:
        near = abs(value - claim["theirs_number"]) <= claim.get("reading", 0.0)
        assert near == (claim["verdict"] != "differs")


def test_a_claim_has_all_that_its_row_needs():
    assert set(WORKS) == {claim["work"] for claim in CLAIMS.values()}
    for key, claim in CLAIMS.items():
        assert claim["verdict"] in ("agrees", "agrees within reading accuracy", "differs"), key
        assert claim["verdict"] != "differs" or len(claim["why"]) > 30, key


def test_the_page_has_a_row_for_each_claim():
    generated = pytest.importorskip("generated", reason="the extra 'docs' is not installed")
    rows = generated.claims().splitlines()[2:]
    assert len(rows) == len(CLAIMS)
    assert any(row.endswith("gains **0.573661 J**. | agrees |") for row in rows)  # our reasons only where we differ


def test_numbers_by_hand():
    assert massless_fall() == pytest.approx((math.sqrt(3.0) - 1.0) / math.sqrt(9.81), abs=2e-6)
    assert painleve_friction() == pytest.approx(math.sqrt(1.0 - 0.75**2) / 0.75, rel=1e-14)
    assert routh_reversal() == pytest.approx(115.0 / 97.0, rel=1e-12)
    assert kane_gain() == pytest.approx(257.0 / 448.0, rel=1e-12)
    assert stronge_separation() == pytest.approx(math.sqrt(20631.0) / 52.0, rel=1e-12)
    assert jam_angle() == pytest.approx(jam_angle_of_theory(), abs=1e-9)
