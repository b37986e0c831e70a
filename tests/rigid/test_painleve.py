"""Painlevé's paradox and the dynamic jam: what keeps a hoop from it, and what is in doubt beside it."""

import math

import pytest

import hophoop as hh
from random_scenarios import AT_PAINLEVE, at_painleve

HOOP = hh.Hoop.ideal(0.75)
SKID = {"angle": -0.7, "vx": 3.0, "omega": 1.0}  # f_n < 0: pressed down


@pytest.mark.parametrize(("hoop", "mu"), [(HOOP, 1.0), (hh.Hoop(radius=0.7, eccentricity=0.9, inertia_ratio=0.1), 0.7)])
def test_energy_keeps_rolling_hoops_from_the_jam(hoop, mu):
    """The bound is the energy of rolling where f_n = 0, above the speed of the immediate hop."""
    plane, e, kap = hh.Plane(mu=mu), hoop.eccentricity, hoop.inertia_ratio
    c = math.cos(max(state.angle for state in hh.theory.jam_states(hoop, plane) if state.mode == "S"))
    rolling = (1 + kap + e**2 + 2 * e * c) / (2 * e * c) - e * (1 - c)
    by_hand = math.sqrt(2 * 9.81 * hoop.radius * rolling / ((1 + e) ** 2 + kap))
    assert hh.theory.least_jam_speed(hoop, plane) == pytest.approx(by_hand, rel=1e-12)
    assert by_hand > hh.theory.immediate_hop_speed(hoop)
    with pytest.raises(ValueError, match=r"plane\.slope"):
        hh.theory.least_jam_speed(hoop, hh.Plane(slope=0.1))


@pytest.mark.parametrize("index", AT_PAINLEVE)
def test_a_start_at_the_threshold_is_in_doubt(index):
    """Within 4 units in the last place of it the sign of κ p_σ decides whether it jams, turns, or is thrown up by 1e-9."""
    motion = hh.simulate(at_painleve(index))
    assert motion.doubt == 0.0
    assert abs(motion.ledger.residual) < 1e-12 * motion.ledger.range


def test_slow_slip_away_from_the_threshold_is_in_doubt():
    """θ̇² changes by its own size over less than the narrowest panel: 20 digits find that it slips on, doubles a jam."""
    start = hh.Start(vx=-8.68, omega=-0.043)
    assert hh.simulate(hh.Hoop.ideal(1.0 - 4.1e-11), hh.Plane(mu=0.71), start, duration=1.25).doubt == 0.0


@pytest.mark.parametrize("factor", [1.0 - 1e-9, 1.0 + 1e-9])
def test_a_start_beside_the_threshold_is_not(factor):
    """Slip has an answer below the friction of the paradox alone."""
    mu = float(hh.theory.painleve_threshold(-0.7, HOOP)) * factor
    motion = hh.simulate(HOOP, hh.Plane(mu=mu), hh.Start(**SKID), duration=0.1)
    assert motion.doubt > 0.0
    assert bool(motion.find("painleve_inconsistent")[:1]) is (factor > 1.0)
