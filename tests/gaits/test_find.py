"""Gaits that the search finds, against motions in 30 digits, symmetries and energy."""

import math
from decimal import Decimal

import pytest

import hophoop as hh
from slopes import on_slope

# Point and multiplier of gaits, from motions in 22 and 30 digits and Richardson's extrapolation of their differences.
KNOWN = [
    (0.5, 0.75, "RSRKR", 3.3143604633366742, 0.783248837804),
    (1.15, 0.75, "RSHRKR", 3.4296716668326048, 1.14297256056),
    (3.0, 0.5, "RSHKR", 2.77150688780492, -0.768024180087),
    (5.0, 0.25, "RSHR", 3.03277936338688, 0.548110306670),
]


@pytest.fixture(scope="module")
def usual():
    """The gait with one hop a revolution on 3°."""
    return hh.gaits.find(on_slope(3, 0.5), near=2.77)[0]


@pytest.mark.parametrize(("degrees", "gamma", "sequence", "omega", "multiplier"), KNOWN)
def test_gaits_of_the_bottom(degrees, gamma, sequence, omega, multiplier):
    gait = hh.gaits.find(on_slope(degrees, gamma), near=omega)[0]
    assert gait.sequence == sequence
    assert gait.state.omega == pytest.approx(omega, rel=3e-15)
    assert gait.multipliers.tolist() == [pytest.approx(multiplier, rel=2e-10)]
    assert gait.stable == (abs(multiplier) < 1.0)
    assert gait.residual < 1e-14
    again = hh.gaits.derivative(gait.scenario, 3)
    assert again.rows == again.columns == ("omega",)
    assert again.matrix[0, 0] == pytest.approx(gait.multipliers[0] ** 3, rel=1e-9)
    motion = hh.simulate(gait.scenario)
    assert motion.duration == gait.time
    assert motion.events[-1].omega == pytest.approx(omega, rel=1e-13)
    assert "".join(phase.mode for phase in gait.phases) == motion.sequence
    gain = math.sin(gait.scenario.plane.slope) * gait.distance
    assert sum(gait.losses.values()) == pytest.approx(gain, rel=1e-12)
    assert gait.speed == pytest.approx(gait.distance / gait.time, rel=1e-14)


@pytest.mark.parametrize(
    ("gear", "omega", "speed", "multiplier"), [(1, 3.598, 3.34154, 0.856540), (2, 6.165, 5.65743, 0.673546)]
)
def test_gears_are_the_same_at_the_bottom_and_at_landings(gear, omega, speed, multiplier):
    """One hop in 1 and 2 revolutions; a multiplier does not depend on the section."""
    at_bottom = [gait for gait in hh.gaits.find(on_slope(3, 0.15), near=omega) if gait.revolutions == gear and gait.stable]
    at_landing = [gait for gait in hh.gaits.find(on_slope(3, 0.15), near=omega, section="landing") if gait.revolutions == gear]
    for gait in (at_bottom[0], at_landing[0]):
        assert gait.hops == 1
        assert gait.speed == pytest.approx(speed, rel=2e-6)
        assert abs(gait.multipliers[0]) == pytest.approx(multiplier, rel=2e-6)
    assert at_landing[0].derivative.rows == ("angle", "omega")
    assert abs(at_landing[0].multipliers[1]) < 1e-9  # what the landing forgets


def test_the_mirrored_hoop_has_the_mirrored_gait():
    ahead, back = (hh.gaits.find(on_slope(sign * 3, 0.5), near=sign * 2.77)[0] for sign in (1, -1))
    assert back.state.omega == pytest.approx(-ahead.state.omega, rel=1e-15)
    assert back.revolutions == -1
    assert back.sequence == "RKHSR"
    assert back.multipliers[0] == pytest.approx(ahead.multipliers[0], rel=1e-12)


def test_units(usual):
    plane = hh.Plane(slope=math.radians(3))
    real = hh.gaits.find(hh.Scenario(hoop=hh.Hoop.ideal(0.5, radius=0.3, mass=2.0), plane=plane), near=16.0)[0]
    rate = math.sqrt(plane.gravity / 0.3)
    assert real.state.omega == pytest.approx(usual.state.omega * rate, rel=1e-14)
    assert real.time == pytest.approx(usual.time / rate, rel=1e-14)
    assert real.hop_height == pytest.approx(0.3 * usual.hop_height, rel=1e-12)
    assert real.losses["friction"] == pytest.approx(2.0 * 0.3 * plane.gravity * usual.losses["friction"], rel=1e-12)


def test_a_longer_period_is_not_a_shorter_one():
    """All gaits of period 2 turn up once, whichever passage they start from, and none of period 1 is among them."""
    found = hh.gaits.find(on_slope(1.18, 0.75), 2, near=3.46)
    assert len(found) >= 1
    for gait in found:
        assert gait.sequence.count("·") == 1
        assert abs(gait.passages.omega[0] - gait.passages.omega[1]) > 1e-4
    assert any(gait.stable for gait in found)


def test_multipliers_on_both_sides_of_a_corner():
    """At 1.027551° the hop's landing just stops the slip, where the multiplier jumps."""
    near, beyond = (hh.gaits.find(on_slope(degrees, 0.75), near=3.457)[0] for degrees in (1.0275, 1.0276))
    assert (near.stable, beyond.stable) == (True, False)
    assert [round(one.multipliers[0].real, 2) for one in (near, beyond)] == [-0.31, -1.35]


@pytest.mark.long
def test_a_pair_next_to_its_fold_is_found():
    """1e-7° before the fold both gaits are closer together than the values of θ̇ that the search compares."""
    found = hh.gaits.find(on_slope(1.167217696421 - 1e-7), near=3.4255)
    pair = [gait for gait in found if abs(gait.state.omega - 3.42552) < 1e-4]
    assert [gait.stable for gait in pair] == [True, False]


@pytest.mark.long
def test_digits_are_those_of_the_section_at_pi(usual):
    """Not of the double next to π, which is 1.2e-16 before it; `hophoop prove` encloses the same point."""
    precise = usual.digits(18)
    assert abs(precise.state["omega"] - Decimal("2.77150688780492032575576155430")) < Decimal("1e-17")
    assert float(precise.multiplier) == pytest.approx(usual.multipliers[0], rel=1e-9)
    assert precise.sequence == usual.sequence == "RSHKR"


def test_the_last_stable_gear_at_a_slope():
    """Unstable gaits at landings are found too: at 6.5° the gear of 21 revolutions is the first unstable one."""
    found = hh.gaits.find(on_slope(6.5, 0.15), near=21.3, section="landing")
    gears = {gait.revolutions: gait for gait in found if gait.sequence == "RSH"}
    assert {20, 21} <= gears.keys()
    assert gears[20].multipliers[0].real == pytest.approx(-0.9603998897, abs=1e-9)
    assert (gears[20].stable, gears[21].stable) == (True, False)


def test_digits_at_landings():
    gait = hh.gaits.find(on_slope(3, 0.15), near=3.58, section="landing")[0]
    precise = gait.digits(22)
    assert precise.state.keys() == {"angle", "omega"}
    for name, value in precise.state.items():
        assert float(value) == pytest.approx(getattr(gait.state, name), rel=1e-13)


def test_bounces_that_take_no_time_are_no_gait():
    """They come back to the section within rounding, in 5e-15 s."""
    (gait,) = hh.gaits.find(on_slope(3, 0.5, mu=0.1), near=2.3267753)
    assert (gait.sequence, gait.hops) == ("KSHK", 1)


@pytest.mark.parametrize(
    ("scenario", "options", "message"),
    [
        (on_slope(0, 0.5), {}, "plane.slope = 0.0 must be other than 0"),
        (on_slope(3, 0.5, mu=0.0), {}, "plane.mu = 0.0 must be above 0"),
        (on_slope(3, 0.5).replace("contact", hh.Compliant()), {}, "contact.model"),
        (on_slope(3, 0.0), {}, "hoop.load_fraction = 0.0 must be above 0: a hoop without load has no gait"),
        (on_slope(3, 0.0), {"section": "landing"}, "hoop.load_fraction = 0.0 must be above 0"),
        (on_slope(3, 0.5), {"period": 0}, "period = 0 must be an integer from 1 to 64"),
        (on_slope(3, 0.5), {"period": 65}, "from 1 to 64"),
        (on_slope(3, 0.5), {"near": -2.0}, "near = -2.0 must be a θ̇ downhill"),
        (on_slope(3, 0.5), {"near": math.nan}, "near = nan must be"),
        (on_slope(3, 0.5), {"fastest": 0.1}, "fastest = 0.1 must be above"),
        (on_slope(3, 0.5), {"section": "top"}, "section = 'top' must be one of bottom, landing"),
        (on_slope(3, 0.5), {"near": 2.0}, "No gait of period 1 was found with θ̇ from 1.8 to 2.2 rad/s .* nearest return"),
        (on_slope(0.5, 0.75), {"section": "landing"}, "none of 96 motions came near"),
    ],
)
def test_refusals(scenario, options, message):
    with pytest.raises(ValueError, match=message):
        hh.gaits.find(scenario, **options)


def test_what_a_gait_shows(usual):
    assert repr(usual) == "<Gait: RSHKR, stable, multiplier -0.768024, 1.86137 m/s, 1 hop in 1 revolution>"
    page = usual._repr_html_()
    assert "RSHKR" in page
    assert "<svg" in page
    assert usual.to_dict()["sequence"] == "RSHKR"
    assert usual.multipliers.dtype == float
    assert "j" not in page + str(usual.multipliers)
    assert usual.motion(3).sequence == "RSHKRSHKRSHKR"
    with pytest.raises(ValueError, match="periods = 0 must be an integer"):
        usual.motion(0)


@pytest.mark.long
def test_a_gait_that_a_motion_settles_on_after_more_turns_than_a_start_may_have_is_found():
    assert hh.gaits.find(hh.Scenario(plane=hh.Plane(slope=0.6)), section="landing")
