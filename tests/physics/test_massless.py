"""The massless hoop: its load is a particle, which falls freely while the rim skims the plane."""

import math

import pytest

from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.closed_forms import skim_duration, skim_state, strike

BETA = 0.2
BODY = Body(1.0, 0.0, 0.5, 0.4, math.cos(BETA), math.sin(BETA), 0.0, 0, False, BETA)
LEVEL = BODY._replace(gn=1.0, gt=0.0, slope=0.0)
TURN = 2.0 * math.pi


@pytest.mark.parametrize("gravity", [1.0, 0.5, 0.0])
def test_the_load_has_fallen_its_height_when_it_strikes(gravity):
    """ẏ t + ½ g t² = 1 + cos θ, also of a fast one that gravity hardly moves; one that nothing moves never strikes."""
    body = BODY._replace(gn=gravity)
    for height in (0.1, 2.0):
        for sink in (-0.2, 0.0, 0.5, 30.0, 1e8):
            if sink > 0.0 or gravity > 0.0:
                t = skim_duration(body, height, sink)
                assert t > 0.0
                assert sink * t + 0.5 * gravity * t * t == pytest.approx(height, rel=1e-14)
        assert gravity > 0.0 or skim_duration(body, height, 0.0) == math.inf


def load(x, th, vt, om):
    """Place and velocity of the load of a hoop on the plane."""
    return x + math.sin(th), 1.0 + math.cos(th), vt + om + math.cos(th) * om, -math.sin(th) * om


@pytest.mark.parametrize(
    ("th", "om", "way"), [(1.0, 0.8, 1), (2.0, 0.3, 1), (5.0, -0.9, -1), (1.0 + TURN, 0.8, 1), (5.0 - TURN, -0.9, -1)]
)
def test_state_while_skimming(th, om, way):
    tau = 0.35
    found = skim_state(BODY, 0.3, th, -0.2, om, way, tau)
    x, y, vx, vy = load(0.3, th, -0.2, om)
    later = x + vx * tau + 0.5 * BODY.gt * tau**2, y + vy * tau - 0.5 * BODY.gn * tau**2, vx + BODY.gt * tau, vy - BODY.gn * tau
    assert load(*found) == pytest.approx(later, rel=1e-12)
    assert 0.0 < way * (found[1] - th) < 1.0


@pytest.mark.parametrize(("way", "begin"), [(1, 0.0), (-1, 0.0), (1, TURN), (1, -2.0 * TURN)])
def test_skimming_from_the_top_goes_the_way_that_it_is_sent(way, begin):
    """The load falls by τ²/2 = 1/8, so that cos θ = 7/8, also where whole turns lie behind."""
    _, th, _, om = skim_state(LEVEL, 0.0, begin, 0.0, 0.0, way, 0.5)
    assert th - begin == pytest.approx(way * math.acos(0.875), rel=1e-12)
    assert om == pytest.approx(way * 0.5 / math.sin(math.acos(0.875)), rel=1e-12)


@pytest.mark.parametrize("way", [1, -1])
def test_edges_of_skimming(way):
    # at the very start the load rests at the top: θ̇² tends to g_n, since ½ θ̇² τ² is what the load has fallen
    for tau in (0.0, 1e-9):
        _, th, _, om = skim_state(BODY, 0.0, 0.0, 0.0, 0.0, way, tau)
        assert 0.0 <= way * th < 1e-8
        assert om == pytest.approx(way * math.sqrt(BODY.gn), rel=1e-6)
    # 1 − cos θ would be −10⁻¹⁹: the top
    assert skim_state(LEVEL, 0.0, 1e-9, 0.0, -1.5, 1, 1.5e-9)[1::2] == (0.0, 1.0)
    # where the load strikes the plane, after a fall by 2, the rim turns infinitely fast
    assert skim_state(LEVEL, 0.0, 0.0, 0.0, 0.0, way, 2.0)[1::2] == (pytest.approx(way * math.pi), way * math.inf)


def test_strike():
    for vt, vn, found in (
        (0.5, -1.0, (0.0, 1.0, -0.5)),  # held by friction, at the edge of the cone
        (-0.3, -1.0, (0.0, 1.0, 0.3)),
        (0.9, -2.0, (0.0, 2.0, -0.9)),  # twice the push, twice the friction
        (0.9, -1.0, (0.5, 1.0, -0.4)),
        (-1.7, -2.0, (-0.9, 2.0, 0.8)),
    ):
        assert strike(BODY, vt, vn) == pytest.approx(found)
