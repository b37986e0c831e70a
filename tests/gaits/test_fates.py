"""Fates: decided early by physics, checked by following the motion much longer."""

import math

import pytest

import hophoop as hh
from hophoop.vocabulary.names import Fate


def scenario(speed=3.1, angle=0.0, gamma=0.75, **plane):
    """A rolling start, in units of R and g."""
    plane = hh.Plane(gravity=1.0, **plane)
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=plane, start=hh.Start.rolling(speed, angle=angle))


CRITICAL = float(hh.theory.first_slip_speed(hh.Hoop(), hh.Plane(gravity=1.0)))  # 0.652335 √(g R)
THREE, FOUR, FIVE, TEN = (math.radians(degrees) for degrees in (3.0, 4.0, 5.0, 10.0))


@pytest.mark.parametrize(
    ("given", "fate"),
    [
        (scenario(0.999 * CRITICAL), Fate.ROLLS_AHEAD),
        (scenario(-0.999 * CRITICAL), Fate.ROLLS_BACK),
        (scenario(1.02 * CRITICAL), Fate.SLIPS_EVER_LESS),
        (scenario(3.0, restitution=0.5), Fate.ROLLS_BACK),  # launched ahead, it comes back
        (scenario(0.1, angle=2.0), Fate.ROCKS),
        (scenario(0.0, angle=3.13, slope=0.02), Fate.ROCKS),  # small swings that do not pass θ = π
        (scenario(0.1, angle=2.0, slope=0.02), Fate.ROCKS),
        (scenario(1.0, rolling_resistance=0.01), Fate.RESTS),
        (scenario(0.0), Fate.RESTS),
        (scenario(1.0, mu=0.2, slope=0.5), Fate.SLIDES_AWAY),
        (scenario(1.0, mu=0.0), Fate.SLIDES_AWAY),
        (scenario(2.7, angle=math.pi, gamma=0.5, slope=THREE), Fate.GAIT),
        (scenario(3.4, angle=math.pi, slope=FOUR), Fate.CHAOTIC),
        (scenario(1.0, gamma=0.0, slope=FIVE), Fate.RUNS_AWAY),
        (scenario(3.0, angle=math.pi, slope=TEN), Fate.ROCKS),  # hops itself to a standstill
    ],
)
def test_fates(given, fate):
    """Also of motions that land no more, which the bottom decides."""
    assert hh.passages(given, 2000).fate == fate
    if fate not in (Fate.CHAOTIC, Fate.GAIT):
        for section in ("bottom", "landing"):
            assert hh.passages(given, 300, section=section).decided == fate
            assert hh.gaits.fates([given], 300, section=section).fates == (fate,)


def test_a_gait_without_a_hop_has_its_period_at_the_bottom():
    given = scenario(3.3, angle=math.pi, slope=math.radians(0.5))
    for section in ("bottom", "landing"):
        judged = hh.gaits.fates([given], 300, section=section)
        assert (judged.fates, judged.periods.tolist()) == ((Fate.GAIT,), [1])


def test_a_short_run_is_undecided():
    """Nothing is called chaotic for want of patience."""
    assert hh.passages(scenario(3.4, angle=math.pi, slope=FOUR), 50).fate == "undecided"


def test_beside_an_unstable_gait_nothing_is_chaotic_yet():
    """Its multiplier is −1.00003: the exponent is above 0 with hardly an error, and yet the motion settles near by."""
    found = hh.passages(scenario(2.781, angle=math.pi, gamma=0.5, slope=math.radians(4.0009)), 3000)
    assert found.lyapunov.value > 5.0 * found.lyapunov.error > 0.0
    assert found.fate == "undecided"


def test_with_less_friction_in_slip_the_slip_ends():
    """Each slip loses a least amount then, although the losses fall: 74 revolutions later it rolls."""
    given = scenario(1.1 * CRITICAL, mu_static=1.0, mu_kinetic=0.9)
    found = hh.passages(given, 1000)
    assert found.decided == Fate.ROLLS_AHEAD
    assert found.sequences[-1] == "R"
    assert found.sequences[20] != "R"


def test_gears_are_told_apart():
    """γ = 0.15 on 3°: one hop in 1, 2 and 3 revolutions, each a gait of one passage."""
    gears = [scenario(speed, angle=math.pi, gamma=0.15, slope=THREE) for speed in (3.5, 6.1, 8.0)]
    judged = hh.gaits.fates(gears)
    assert judged.revolutions.tolist() == [1, 2, 3]
    assert judged.hops.tolist() == [1, 1, 1]
    mixed = hh.gaits.fates([gears[0], scenario(0.3)])
    assert (mixed.revolutions.tolist(), mixed.periods.tolist(), mixed.hops.tolist()) == ([1, 0], [1, 0], [1, 0])


FAST = 2_000.0  # √(g R)


@pytest.mark.parametrize(
    ("given", "fate"),
    [
        (scenario(FAST), Fate.ROCKS),
        (scenario(-2.5 * FAST, gamma=0.3, restitution=0.5), Fate.ROLLS_BACK),
        (scenario(-FAST, slope=0.1), Fate.ROCKS),
        (scenario(FAST, gamma=0.0, slope=0.1), Fate.RUNS_AWAY),
        (scenario(20.0, slope=math.radians(40)), Fate.RUNS_AWAY),
    ],
)
def test_a_fast_start_alone_does_not_run_away(given, fate):
    """On the level, uphill and on a gentle slope fast motion slows down."""
    assert hh.passages(given, 300, until_decided=True).decided == fate


def test_under_newtons_law_bounces_may_lift_the_hoop_over_the_top():
    """Kane's gain: it starts 0.02 m g R below the load at the top, and goes over it 10 units of time later."""
    plane = hh.Plane(gravity=1.0, mu=2.86, restitution=0.91, impact_law="newton")
    start = hh.Start(height=1.09, angle=2.79, vx=-1.34, omega=-1.84)
    given = hh.Scenario(hoop=hh.Hoop.ideal(0.87), plane=plane, start=start)
    found = hh.passages(given, 100)
    assert found.decided == Fate.ROCKS
    assert found.angle == pytest.approx(3.0 * math.pi, abs=1e-9)
    assert len(hh.passages(given, 100, until_decided=True)) > 0  # not at the start, where it is below the top


@pytest.mark.parametrize("slope", [1e-11, 3e-12, 1e-15])
def test_rolling_that_gains_speed_in_each_revolution_is_no_gait(slope):
    """On so gentle a slope two revolutions hardly differ, and the gait is far away."""
    given = scenario(0.3, slope=slope)
    found = hh.passages(given, 200)
    assert set(found.sequences) == {"R"}
    assert found.fate == Fate.UNDECIDED
    assert hh.gaits.fates([given], 200).fates == (Fate.UNDECIDED,)
