"""Forces of a compliant contact: from energy, symmetry, differences, and masses that bounce."""

import math

import pytest
from scipy.integrate import solve_ivp

from hophoop.kernel.physics import compliant
from hophoop.kernel.physics.compliant import Compliance, FrictionLaw, NormalLaw

MU_S, MU_K = 0.6, 0.4
EXCESS = compliant.static_excess(MU_S, MU_K)
SOFT = [
    Compliance(law, friction, 900.0, 7.0, 0.3, 0.02, MU_S, MU_K, EXCESS, 300.0, 5.0)
    for law in NormalLaw
    for friction in FrictionLaw
]


def slope(function, at, step=1e-6):
    return (function(at + step) - function(at - step)) / (2.0 * step)


@pytest.mark.parametrize("comp", SOFT)
def test_normal_force(comp):
    y, vn = -0.02, 0.3
    force, by_y, by_v = compliant.normal_force(comp, y, vn)
    assert by_y == pytest.approx(slope(lambda value: compliant.normal_force(comp, value, vn)[0], y), rel=1e-7)
    assert by_v == pytest.approx(slope(lambda value: compliant.normal_force(comp, y, value)[0], vn), rel=1e-7)
    # at rest it is what the spring's energy pushes with; the damper takes energy both ways
    assert compliant.normal_force(comp, y, 0.0)[0] == pytest.approx(
        -slope(lambda at: compliant.spring_energy(comp, at, 0.0), y)
    )
    assert force < compliant.normal_force(comp, y, 0.0)[0] < compliant.normal_force(comp, y, -vn)[0]
    if comp.law == NormalLaw.KELVIN_VOIGT:
        assert compliant.normal_force(comp, 0.0, -1.0)[0] == comp.c
    else:
        assert compliant.normal_force(comp, y, 1.0 / comp.d)[0] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("comp", SOFT)
def test_spring_energy(comp):
    assert compliant.spring_energy(comp, 0.1, 0.0) == 0.0  # above the plane
    stretched = compliant.spring_energy(comp, 0.1, 0.02)
    assert stretched == (pytest.approx(0.06) if comp.friction == FrictionLaw.BRISTLE else 0.0)


@pytest.mark.parametrize("comp", [one for one in SOFT if one.friction != FrictionLaw.BRISTLE])
def test_creeping_friction(comp):
    edge = compliant.creep_speed(comp)
    for vt in (0.3 * comp.v_s, 0.9 * comp.v_s, 1.4 * comp.v_s, 5.0 * comp.v_s):
        for sign in (1, -1):
            regime = 0 if comp.friction == FrictionLaw.LINEAR and vt < comp.v_s else sign
            phi, rate = compliant.traction(comp, regime, sign * vt)
            assert phi * sign > 0.0
            assert compliant.traction(comp, -regime, -sign * vt) == (-phi, rate)  # odd
            assert rate == pytest.approx(
                slope(lambda at, r=regime: compliant.traction(comp, r, at)[0], sign * vt), rel=1e-5, abs=1e-6
            )
            # the force opposes the slip, and its derivatives are those of itself
            force, by_n, by_v, by_z = compliant.friction_force(comp, regime, 3.0, 0.01, sign * vt)
            assert force == pytest.approx(-3.0 * phi)
            assert by_n == pytest.approx(-phi)
            assert by_v == pytest.approx(-3.0 * rate)
            assert by_z == 0.0
    assert compliant.traction(comp, 1, 1e3 * comp.v_s)[0] == pytest.approx(MU_K, rel=1e-12)
    greatest = max(compliant.traction(comp, 1 if k > 200 else 0, 0.005 * k * comp.v_s)[0] for k in range(2400))
    assert greatest == pytest.approx(MU_S, rel=1e-4)
    assert [compliant.first_regime(comp, 1.0, 0.0, vt) for vt in (0.9 * edge, -0.9 * edge, 1.1 * edge, -1.1 * edge)] == [
        0,
        0,
        1,
        -1,
    ]


@pytest.mark.parametrize("regime", [1, -1])
@pytest.mark.parametrize("beyond", [0.0, 0.4, 1.0, 2.5])
def test_the_linear_law_beyond_its_slip_speed(regime, beyond):
    """From μs where its line ends it falls to μk, as exp(−ξ²) of the slip speeds ξ beyond."""
    comp = next(one for one in SOFT if one.friction == FrictionLaw.LINEAR)
    phi, rate = compliant.traction(comp, regime, regime * (1.0 + beyond) * comp.v_s)
    decay = (MU_S - MU_K) * math.exp(-(beyond**2))
    assert phi == pytest.approx(regime * (MU_K + decay), rel=1e-13)
    assert rate == pytest.approx(-2.0 * beyond * decay / comp.v_s, rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("comp", [one for one in SOFT if one.friction == FrictionLaw.BRISTLE])
def test_bristle(comp):
    z, vt, normal = 0.004, 0.11, 5.0
    assert compliant.bristle_rate(comp, 0, normal, z, vt) == vt  # its foot sticks
    force, by_n, by_v, by_z = compliant.friction_force(comp, 0, normal, z, vt)
    assert force == pytest.approx(-(comp.k_t * z + comp.c_t * vt))
    assert by_n == 0.0
    assert by_v == pytest.approx(slope(lambda at: compliant.friction_force(comp, 0, normal, z, at)[0], vt))
    assert by_z == pytest.approx(slope(lambda at: compliant.friction_force(comp, 0, normal, at, vt)[0], z))
    for regime in (1, -1):
        # its foot slides: spring and damper carry what Coulomb's law gives
        rate = compliant.bristle_rate(comp, regime, normal, z, vt)
        assert comp.k_t * z + comp.c_t * rate == pytest.approx(regime * MU_K * normal)
        force, by_n, by_v, by_z = compliant.friction_force(comp, regime, normal, z, vt)
        assert (force, by_n) == pytest.approx((-regime * MU_K * normal, -regime * MU_K))
        assert (by_v, by_z) == (0.0, 0.0)
    assert compliant.first_regime(comp, normal, z, vt) == 0
    assert compliant.first_regime(comp, 0.1, z, vt) == 1
    assert compliant.first_regime(comp, 0.1, -z, -vt) == -1
    assert compliant.first_regime(comp, 0.1, 0.1 * z, 0.0) == 1  # 0.12 of 0.06: forces below 1 as well
    assert compliant.first_regime(comp, 0.1, -0.1 * z, 0.0) == -1
    # just inside and just outside the cone: spring and damper together decide
    edge = (comp.k_t * z + comp.c_t * vt) / MU_S
    assert compliant.first_regime(comp, edge * 1.001, z, vt) == 0
    assert compliant.first_regime(comp, edge * 0.999, z, vt) == 1


def bounce(force):
    """Restitution of a unit mass with the speed 1 on a contact that ends where its force does."""

    def ends(_, state):
        return force(*state)

    ends.terminal, ends.direction = True, -1.0
    done = solve_ivp(lambda _, state: (state[1], force(*state)), (0.0, 50.0), (-1e-12, -1.0),
                     events=ends, rtol=1e-10, atol=1e-13)  # fmt: skip
    return done.y_events[0][0][1]


@pytest.mark.parametrize("ratio", [0.05, 0.4, 0.9, 1.0, 1.2, 1.5])
def test_restitution_of_kelvin_and_voigt(ratio):
    rebound = bounce(lambda y, v: -y - 2.0 * ratio * v)
    assert compliant.ratio_restitution(ratio) == pytest.approx(rebound, rel=1e-6)
    assert compliant.damping_ratio(rebound) == pytest.approx(ratio, rel=1e-5)


def test_restitution_one_needs_no_damping():
    assert compliant.damping_ratio(1.0) == compliant.hunt_crossley_number(1.0) == 0.0


@pytest.mark.parametrize("restitution", [0.2, 0.6, 0.95])
def test_restitution_of_hunt_and_crossley(restitution):
    d = compliant.hunt_crossley_number(restitution)
    assert bounce(lambda y, v: -y * (1.0 - d * v) if y < 0.0 else -1.0) == pytest.approx(restitution, rel=1e-5)


def test_static_excess():
    assert compliant.static_excess(0.5, 0.5) == 0.0
    excess = compliant.static_excess(0.9, 0.3)
    heights = [
        math.tanh(x) * (0.3 + excess * math.exp(-((x / compliant.STRIBECK) ** 2))) for x in [0.001 * k for k in range(9000)]
    ]
    assert max(heights) == pytest.approx(0.9, rel=1e-6)


def test_the_couple_of_a_slow_rotation():
    """It grows over 10⁻⁶ √(g/R) where nothing else is said, and is f N from there on, against the rotation."""
    couple = 0.02 * 5.0
    for om, part in ((1e-6, math.tanh(1.0)), (-1e-6, -math.tanh(1.0)), (1e-3, 1.0), (-1e-3, -1.0), (0.0, 0.0)):
        found, by_force, by_speed = compliant.resisting_couple(SOFT[0], 0.02, 5.0, om)
        assert found == pytest.approx(-couple * part, rel=1e-14)
        by = slope(lambda normal, om=om: compliant.resisting_couple(SOFT[0], 0.02, normal, om)[0], 5.0)
        assert by_force == pytest.approx(by, rel=1e-8)
        by = slope(lambda value: compliant.resisting_couple(SOFT[0], 0.02, 5.0, value)[0], om, 1e-10)
        assert by_speed == pytest.approx(by, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("k", [4.0, 1e6])
def test_how_far_a_rim_sinks(k):
    """½ k δ² = ½ v², v also from the fall, and the weight's 1/k; without gravity nothing falls."""
    for falls, height, speed in ((True, 0.0, 3.0), (True, 8.0, 3.0), (False, 8.0, 3.0), (True, 0.5, 0.0)):
        met = speed + (math.sqrt(2.0 * height) if falls else 0.0)
        depth = compliant.sinking(k, falls, height, speed) - 1.0 / k
        assert k * depth * depth == pytest.approx(met * met, rel=1e-9)


def test_a_restitution_near_zero_is_at_the_pole():
    assert compliant.hunt_crossley_number(1e-3) == pytest.approx(1e3, rel=1e-12)


def test_codes_of_the_laws():
    assert {law.name: int(law) for law in NormalLaw} == {"KELVIN_VOIGT": 0, "HUNT_CROSSLEY": 1}
    assert {law.name: int(law) for law in FrictionLaw} == {"TANH": 0, "LINEAR": 1, "BRISTLE": 2}
    assert compliant.STRIBECK == 3.0  # static friction in the tanh law falls off over three slip speeds
