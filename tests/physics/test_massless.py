"""The massless hoop: its load is a particle, which falls freely while the rim skims the plane."""

import math

import pytest

from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.closed_forms import skim_duration, skim_state, strike

BETA = 0.2
BODY = Body(1.0, 0.0, 0.5, 0.4, math.cos(BETA), math.sin(BETA), 0.0, 0, False, BETA)
TURN = 2.0 * math.pi


def load_after(x, th, vt, om, tau):
    """Place of a falling particle: along the plane and above it."""
    vx, vy = vt + om + math.cos(th) * om, -math.sin(th) * om
    along = x + math.sin(th) + vx * tau + 0.5 * BODY.gt * tau**2
    return along, 1.0 + math.cos(th) + vy * tau - 0.5 * BODY.gn * tau**2


@pytest.mark.parametrize(("th", "om"), [(1.0, 0.8), (2.0, 0.3), (1.2, -0.2)])
def test_the_load_falls_for_so_long(th, om):
    tau = skim_duration(BODY, 1.0 + math.cos(th), math.sin(th) * om)
    assert tau > 0.0
    assert load_after(0.0, th, 0.0, om, tau)[1] == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize(
    ("th", "om", "way"), [(1.0, 0.8, 1), (2.0, 0.3, 1), (5.0, -0.9, -1), (1.0 + TURN, 0.8, 1), (5.0 - TURN, -0.9, -1)]
)
def test_state_while_skimming(th, om, way):
    x, vt, tau, step = 0.3, -0.2, 0.35, 1e-5

    def centre(at):
        """(x, θ) of the hoop whose load is where the particle is, its rim on the plane."""
        along, height = load_after(x, th, vt, om, at)
        angle = math.acos(height - 1.0)  # within the half turn that begins at the top
        turned = angle if way > 0 else TURN - angle
        turned += TURN * math.floor(th / TURN)
        return along - math.sin(turned), turned

    found = skim_state(BODY, x, th, vt, om, way, tau)
    place, angle = centre(tau)
    before, after = centre(tau - step), centre(tau + step)
    rate = (after[1] - before[1]) / (2 * step)
    speed = (after[0] - before[0]) / (2 * step)
    assert found[:2] == pytest.approx((place, angle), rel=1e-12)
    assert found[3] == pytest.approx(rate, rel=1e-8)
    assert found[2] == pytest.approx(speed - rate, rel=1e-7)


def test_edges_of_skimming():
    # from rest at the top: θ̇² tends to g_n, since ½ θ̇² τ² is what the load has fallen
    for way in (1, -1):
        _, th, _, om = skim_state(BODY, 0.0, 0.0, 0.0, 0.0, way, 1e-9)
        assert abs(th) < 1e-8
        assert math.copysign(1.0, th) == way
        assert om == pytest.approx(way * math.sqrt(BODY.gn), rel=1e-6)
    assert skim_state(BODY, 0.0, 0.0, 0.0, 0.0, 1, 0.0)[3] == pytest.approx(math.sqrt(BODY.gn))
    # where the load strikes the plane the rim turns infinitely fast
    tau = skim_duration(BODY, 1.0 + math.cos(1.0), math.sin(1.0) * 0.8) * (1.0 + 1e-12)
    for th, om, way in ((1.0, 0.8, 1), (TURN - 1.0, -0.8, -1)):
        assert skim_state(BODY, 0.0, th, 0.0, om, way, tau)[3] == way * math.inf


def test_strike():
    assert strike(BODY, 0.3, -1.0) == (0.0, 1.0, -0.3)  # held by friction
    assert strike(BODY, -0.3, -1.0) == (0.0, 1.0, 0.3)
    assert strike(BODY, 0.9, -2.0) == (0.0, 2.0, -0.9)  # twice the push, twice the friction
    assert strike(BODY, 0.9, -1.0) == pytest.approx((0.5, 1.0, -0.4))
    assert strike(BODY, -1.7, -2.0) == pytest.approx((-0.9, 2.0, 0.8))


@pytest.mark.parametrize("turns", [0, 1, -2])
def test_skimming_from_the_top_goes_the_way_that_it_is_sent(turns):
    """θ grows for way = 1, also where whole turns lie behind, and falls for way = −1, also from θ = 0."""
    body = Body(1.0, 0.0, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    begin = 2.0 * math.pi * turns
    for way in (1, -1) if turns == 0 else (1,):  # the kernel's θ is within the turn; 2π itself is no double
        _, th, _, om = skim_state(body, 0.0, begin, 0.0, 0.0, way, 0.5)
        # the load falls by τ²/2 = 1/8, so that cos θ = 7/8
        assert th - begin == pytest.approx(way * math.acos(0.875), rel=1e-12)
        assert om == pytest.approx(way * 0.5 / math.sin(math.acos(0.875)), rel=1e-12)
    if turns == 0:  # at the very start the load rests at the top: θ̇² = g
        assert skim_state(body, 0.0, begin, 0.0, 0.0, 1, 0.0)[3] == pytest.approx(1.0)


def test_skimming_ends_where_the_load_strikes():
    body = Body(1.0, 0.0, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    _, th, _, om = skim_state(body, 0.0, 0.0, 0.0, 0.0, 1, 2.0)  # it falls by 2, to the plane
    assert th == pytest.approx(math.pi)
    assert om == math.inf
    assert skim_state(body, 0.0, 0.0, 0.0, 0.0, -1, 2.0)[3] == -math.inf


def test_a_strike_at_the_edge_of_the_cone_sticks():
    body = Body(1.0, 0.0, 0.5, 0.25, 1.0, 0.0, 0.0, 2, False, 0.0)
    assert strike(body, 0.5, -1.0) == (0.0, 1.0, -0.5)
    assert strike(body, 0.75, -1.0) == (0.5, 1.0, -0.25)


@pytest.mark.parametrize(("th", "om"), [(1.0, 0.5), (2.5, 3.0), (5.0, -0.8)])
def test_without_gravity_the_load_goes_on_as_it_went(th, om):
    """It reaches the plane after its height over its speed; one that does not sink never does."""
    body = Body(1.0, 0.0, 0.5, 0.4, 0.0, 0.0, 0.0, 0, False, 0.0)
    height, sink = 1.0 + math.cos(th), math.sin(th) * om
    tau = skim_duration(body, 1.0 + math.cos(th), sink)
    assert height - sink * tau == pytest.approx(0.0, abs=1e-15)
    assert skim_duration(body, 1.0 + math.cos(th), 0.0) == math.inf


@pytest.mark.parametrize("gravity", [1.0, 0.5])
def test_with_gravity_it_falls(gravity):
    body = Body(1.0, 0.0, 0.5, 0.4, gravity, 0.0, 0.0, 0, False, 0.0)
    tau = skim_duration(body, 1.0 + math.cos(2.0), 0.3)
    assert 1.0 + math.cos(2.0) - 0.3 * tau - 0.5 * gravity * tau * tau == pytest.approx(0.0, abs=1e-15)


def test_a_load_that_rounding_lifts_above_the_top_stays_there():
    """1 − cos θ would be −10⁻¹⁹: the top, with θ̇² = g as from rest there."""
    body = Body(1.0, 0.0, 0.5, 0.4, 1.0, 0.0, 0.0, 0, False, 0.0)
    _, th, _, om = skim_state(body, 0.0, 1e-9, 0.0, -1.5, 1, 1.5e-9)
    assert (th, om) == (0.0, 1.0)


@pytest.mark.parametrize("sink", [0.0, 0.5, 2.0, 30.0, 1e8])
@pytest.mark.parametrize("c", [-0.9, 0.3, 1.0])
def test_the_load_has_fallen_its_height_when_it_strikes(sink, c):
    """ẏ t + ½ g t² = 1 + cos θ, also where it sinks so fast that gravity hardly counts."""
    body = Body(1.0, 0.0, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    t = skim_duration(body, 1.0 + c, sink)
    assert sink * t + 0.5 * t * t == pytest.approx(1.0 + c, rel=1e-14)
