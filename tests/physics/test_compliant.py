"""Forces of a compliant contact: from energy, symmetry, and masses that bounce; test_compliant_laws.py has derivatives."""

import math

import pytest
from scipy.integrate import solve_ivp

from hophoop.kernel.physics import compliant
from hophoop.kernel.physics.compliant import Compliance, FrictionLaw, NormalLaw

MU_S, MU_K = 0.6, 0.4
EXCESS = compliant.static_excess(MU_S, MU_K)
NORMAL = [Compliance(law, 0, 900.0, 7.0, 0.3, 0.02, MU_S, MU_K, EXCESS, 300.0, 5.0) for law in NormalLaw]
TANH, LINEAR, BRISTLE = (NORMAL[0]._replace(friction=law) for law in FrictionLaw)


def slope(function, at, step=1e-6):
    return (function(at + step) - function(at - step)) / (2.0 * step)


@pytest.mark.parametrize("comp", NORMAL)
def test_normal_force(comp):
    y, vn = -0.02, 0.3
    force = compliant.normal_force(comp, y, vn)[0]
    # at rest it is what the spring's energy pushes with; the damper takes energy both ways
    still = compliant.normal_force(comp, y, 0.0)[0]
    assert still == pytest.approx(-slope(lambda at: compliant.spring_energy(comp, at, 0.0), y))
    assert force < still < compliant.normal_force(comp, y, -vn)[0]
    if comp.law == NormalLaw.KELVIN_VOIGT:
        assert compliant.normal_force(comp, 0.0, -1.0)[0] == comp.c
    else:
        assert compliant.normal_force(comp, y, 1.0 / comp.d)[0] == pytest.approx(0.0, abs=1e-12)


def test_energy_of_the_springs_above_the_plane():
    assert [compliant.spring_energy(comp, 0.1, 0.02) for comp in (TANH, LINEAR, BRISTLE)] == pytest.approx([0.0, 0.0, 0.06])


@pytest.mark.parametrize("comp", [TANH, LINEAR])
def test_creeping_friction(comp):
    edge = compliant.creep_speed(comp)
    for sign in (1, -1):
        for vt in (0.3 * comp.v_s, 0.9 * comp.v_s, 1.4 * comp.v_s, 5.0 * comp.v_s):
            regime = 0 if comp is LINEAR and vt < comp.v_s else sign
            phi, rate = compliant.traction(comp, regime, sign * vt)
            assert compliant.traction(comp, -regime, -sign * vt) == (-phi, rate)
            # the force opposes the slip
            force = compliant.friction_force(comp, regime, 3.0, 0.01, sign * vt)
            assert phi * sign > 0.0
            assert force == pytest.approx((-3.0 * phi, -phi, -3.0 * rate, 0.0))
        assert [compliant.first_regime(comp, 1.0, 0.0, sign * part * edge) for part in (0.9, 1.1)] == [0, sign]
    assert compliant.traction(comp, 1, 1e3 * comp.v_s)[0] == pytest.approx(MU_K, rel=1e-12)
    greatest = max(compliant.traction(comp, 1 if k > 200 else 0, 0.005 * k * comp.v_s)[0] for k in range(2400))
    assert greatest == pytest.approx(MU_S, rel=1e-4)


@pytest.mark.parametrize("regime", [1, -1])
@pytest.mark.parametrize("beyond", [0.0, 0.4, 2.5])
def test_the_linear_law_beyond_its_slip_speed(regime, beyond):
    """From μs where its line ends it falls to μk, as exp(−ξ²) of the slip speeds ξ beyond."""
    phi = compliant.traction(LINEAR, regime, regime * (1.0 + beyond) * LINEAR.v_s)[0]
    assert phi == pytest.approx(regime * (MU_K + (MU_S - MU_K) * math.exp(-(beyond**2))), rel=1e-13)


def test_bristle():
    z, vt, normal = 0.004, 0.11, 5.0
    pull = BRISTLE.k_t * z + BRISTLE.c_t * vt
    # its foot sticks: spring and damper pull
    assert compliant.bristle_rate(BRISTLE, 0, normal, z, vt) == vt
    assert compliant.friction_force(BRISTLE, 0, normal, z, vt) == pytest.approx((-pull, 0.0, -BRISTLE.c_t, -BRISTLE.k_t))
    for way in (1, -1):
        # its foot slides: they carry what Coulomb's law gives
        rate = compliant.bristle_rate(BRISTLE, way, normal, z, vt)
        assert BRISTLE.k_t * z + BRISTLE.c_t * rate == pytest.approx(way * MU_K * normal)
        found = compliant.friction_force(BRISTLE, way, normal, z, vt)
        assert found == pytest.approx((-way * MU_K * normal, -way * MU_K, 0.0, 0.0))
        # just inside and just outside the cone: spring and damper together decide
        for part, expected in ((1.001, 0), (0.999, way)):
            assert compliant.first_regime(BRISTLE, part * pull / MU_S, way * z, way * vt) == expected
        assert compliant.first_regime(BRISTLE, 0.1, way * 0.1 * z, 0.0) == way  # 0.12 of 0.06: forces below 1 as well


def bounce(force):
    """Restitution of a unit mass with the speed 1 on a contact that ends where its force does."""

    def ends(_, state):
        return force(*state)

    ends.terminal, ends.direction = True, -1.0
    done = solve_ivp(lambda _, state: (state[1], force(*state)), (0.0, 50.0), (-1e-12, -1.0),
                     events=ends, rtol=1e-10, atol=1e-13)  # fmt: skip
    return done.y_events[0][0][1]


@pytest.mark.parametrize("ratio", [0.05, 0.4, 0.9, 1.0, 1.5])
def test_restitution_of_kelvin_and_voigt(ratio):
    rebound = bounce(lambda y, v: -y - 2.0 * ratio * v)
    assert compliant.ratio_restitution(ratio) == pytest.approx(rebound, rel=1e-6)
    assert compliant.damping_ratio(rebound) == pytest.approx(ratio, rel=1e-5)


@pytest.mark.parametrize("restitution", [0.2, 0.6, 0.95])
def test_restitution_of_hunt_and_crossley(restitution):
    d = compliant.hunt_crossley_number(restitution)
    assert bounce(lambda y, v: -y * (1.0 - d * v) if y < 0.0 else -1.0) == pytest.approx(restitution, rel=1e-5)


def test_restitutions_at_their_ends():
    assert compliant.damping_ratio(1.0) == compliant.hunt_crossley_number(1.0) == 0.0
    assert compliant.hunt_crossley_number(1e-3) == pytest.approx(1e3, rel=1e-12)  # at the pole


def test_static_excess():
    """The tanh law falls off over three slip speeds, from μs exactly."""
    assert compliant.static_excess(0.5, 0.5) == 0.0
    excess = compliant.static_excess(0.9, 0.3)
    heights = [math.tanh(x) * (0.3 + excess * math.exp(-((x / 3.0) ** 2))) for x in [0.001 * k for k in range(9000)]]
    assert max(heights) == pytest.approx(0.9, rel=1e-6)


@pytest.mark.parametrize("om", [1e-6, -1e-6, 1e-3, -1e-3, 0.0])
def test_the_couple_of_a_slow_rotation(om):
    """It grows over v_s/R, and is f N from there on, against the rotation."""

    def couple(normal, rate):
        return -0.02 * normal * math.tanh(rate / TANH.v_s)

    found = compliant.resisting_couple(TANH, 0.02, 5.0, om)
    by_speed = slope(lambda rate: couple(5.0, rate), om, 1e-10)
    assert found[:2] == pytest.approx((couple(5.0, om), couple(1.0, om)), rel=1e-14)
    assert found[2] == pytest.approx(by_speed, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("k", [4.0, 1e6])
def test_how_far_a_rim_sinks(k):
    """½ k δ² = ½ v², v also from the fall, and the weight's 1/k; without gravity nothing falls."""
    for falls, height, speed, met in ((True, 0.0, 3.0, 3.0), (True, 8.0, 3.0, 7.0), (False, 8.0, 3.0, 3.0)):
        depth = compliant.sinking(k, falls, height, speed) - 1.0 / k
        assert k * depth * depth == pytest.approx(met * met, rel=1e-9)


def test_codes_of_the_laws():
    assert [*map(int, NormalLaw), *map(int, FrictionLaw)] == [0, 1, 0, 1, 2]
