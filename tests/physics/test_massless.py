"""The massless hoop: its load is a particle, which falls freely while the rim skims the plane."""

import math

import pytest

from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.closed_forms import skim_duration, skim_state, strike

BETA = 0.2
BODY = Body(1.0, 0.0, 0.5, 0.4, math.cos(BETA), math.sin(BETA), 0.0, 0, False, BETA)
LEVEL = BODY._replace(gn=1.0, gt=0.0, slope=0.0)
TURN = 2.0 * math.pi


def load_after(x, th, vt, om, tau):
    """Place of a falling particle: along the plane and above it."""
    vx, vy = vt + om + math.cos(th) * om, -math.sin(th) * om
    along = x + math.sin(th) + vx * tau + 0.5 * BODY.gt * tau**2
    return along, 1.0 + math.cos(th) + vy * tau - 0.5 * BODY.gn * tau**2


@pytest.mark.parametrize("gravity", [1.0, BODY.gn, 0.5, 0.0])
def test_the_load_has_fallen_its_height_when_it_strikes(gravity):
    """ẏ t + ½ g t² = 1 + cos θ, also of a fast one that gravity hardly moves; one that nothing moves never strikes."""
    body = BODY._replace(gn=gravity)
    for height in (0.1, 1.3, 2.0):
        for sink in (-0.2, 0.0, 0.5, 30.0, 1e8):
            if sink > 0.0 or gravity > 0.0:
                t = skim_duration(body, height, sink)
                assert t > 0.0
                assert sink * t + 0.5 * gravity * t * t == pytest.approx(height, rel=1e-14)
        assert gravity > 0.0 or skim_duration(body, height, 0.0) == math.inf


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


@pytest.mark.parametrize("turns", [0, 1, -2])
def test_skimming_from_the_top_goes_the_way_that_it_is_sent(turns):
    """θ grows for way = 1, also where whole turns lie behind, and falls for way = −1, also from θ = 0."""
    begin = TURN * turns
    for way in (1, -1) if turns == 0 else (1,):  # the kernel's θ is within the turn; 2π itself is no double
        _, th, _, om = skim_state(LEVEL, 0.0, begin, 0.0, 0.0, way, 0.5)
        # the load falls by τ²/2 = 1/8, so that cos θ = 7/8
        assert th - begin == pytest.approx(way * math.acos(0.875), rel=1e-12)
        assert om == pytest.approx(way * 0.5 / math.sin(math.acos(0.875)), rel=1e-12)


def test_edges_of_skimming():
    # at the very start the load rests at the top: θ̇² tends to g_n, since ½ θ̇² τ² is what the load has fallen
    for way in (1, -1):
        _, th, _, om = skim_state(BODY, 0.0, 0.0, 0.0, 0.0, way, 1e-9)
        assert 0.0 < way * th < 1e-8
        assert om == pytest.approx(way * math.sqrt(BODY.gn), rel=1e-6)
    assert skim_state(BODY, 0.0, 0.0, 0.0, 0.0, 1, 0.0)[3] == pytest.approx(math.sqrt(BODY.gn))
    # 1 − cos θ would be −10⁻¹⁹: the top
    assert skim_state(LEVEL, 0.0, 1e-9, 0.0, -1.5, 1, 1.5e-9)[1::2] == (0.0, 1.0)
    # where the load strikes the plane, after a fall by 2, the rim turns infinitely fast
    for way in (1, -1):
        assert skim_state(LEVEL, 0.0, 0.0, 0.0, 0.0, way, 2.0)[1::2] == (pytest.approx(way * math.pi), way * math.inf)
    tau = skim_duration(BODY, 1.0 + math.cos(1.0), math.sin(1.0) * 0.8) * (1.0 + 1e-12)
    for th, om, way in ((1.0, 0.8, 1), (TURN - 1.0, -0.8, -1)):
        assert skim_state(BODY, 0.0, th, 0.0, om, way, tau)[3] == way * math.inf


def test_strike():
    for vt, vn, found in (
        (0.3, -1.0, (0.0, 1.0, -0.3)),  # held by friction
        (-0.3, -1.0, (0.0, 1.0, 0.3)),
        (0.5, -1.0, (0.0, 1.0, -0.5)),  # at the edge of the cone
        (0.9, -2.0, (0.0, 2.0, -0.9)),  # twice the push, twice the friction
        (0.9, -1.0, (0.5, 1.0, -0.4)),
        (-1.7, -2.0, (-0.9, 2.0, 0.8)),
    ):
        assert strike(BODY, vt, vn) == pytest.approx(found)
