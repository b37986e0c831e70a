"""Wells of energy: what a hoop on a slope never leaves is proved by bounds, which single states and long motions test."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.gaits.kernels.wells import is_held, rolling_potential, stays_in_well
from hophoop.kernel.physics.contact import free_acceleration, kappa_p_sigma, slip_motion
from hophoop.theory.kernels.arcs import first_maximum


def on_slope(slope, gamma, **plane):
    """A hoop on a slope, in units of R and g."""
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(gravity=1.0, slope=slope, **plane))


def sliding(scenario, angle, slip, omega=0.0):
    """The same with a start in contact."""
    return scenario.replace("start", hh.Start(angle=angle, vx=slip + omega, omega=omega, slip=slip))


def potential(body, angle):
    return rolling_potential(body, math.sin(angle), math.cos(angle), angle)


def energies(scenario, sample):
    """E of the module along a motion: the kinetic energy plus V."""
    body = scenario.to_body()
    sine, cosine = np.sin(sample.angle), np.cos(sample.angle)
    along, up = sample.slip + sample.omega * (1.0 + body.eps * cosine), body.eps * sample.omega * sine
    return 0.5 * (along**2 + up**2 + body.kap * sample.omega**2) + rolling_potential(body, sine, cosine, sample.angle)


def random_state(random):
    """A hoop on a slope that friction may hold, with a state in contact near the bottom of a well."""
    gamma, slope = float(random.uniform(0.2, 0.9)), float(random.uniform(0.01, 0.3))
    mu, uphill = math.tan(slope) * float(random.uniform(1.1, 8.0)), random.random() < 0.5
    scenario = on_slope(-slope if uphill else slope, gamma, mu=mu, rolling_resistance=float(random.choice([0.0, 0.01])))
    place = math.pi + float(random.uniform(-1.5, 1.5)), float(random.uniform(-0.4, 0.4)), float(random.uniform(-0.5, 0.5))
    return sliding(scenario, *place)


def holds(body, angle, energy):
    """Whether at one angle, with up to this E, no contact opens and slip downhill loses more than it gains."""
    free = energy - potential(body, angle)
    if free < 0.0:
        return True
    sine, cosine = math.sin(angle), math.cos(angle)
    downhill, most = math.copysign(1.0, body.gt), 2.0 * free / (body.kap + (body.eps * sine) ** 2)
    if not free_acceleration(body, sine, cosine, most)[1] < 0.0:
        return False
    cases = [(square, arm) for square in (0.0, most) for arm in {-body.resist, body.resist}]
    firm = [case for case in cases if kappa_p_sigma(body, sine, cosine, downhill, case[1]) > 0.0]
    loads = [slip_motion(body, sine, cosine, square, downhill, arm)[1] for square, arm in firm]
    return all(body.mu_k * load > abs(body.gt) for load in loads)


@pytest.mark.parametrize("resistance", [0.0, 0.1])
def test_bounds_on_a_piece(resistance):
    """On a narrow piece they are what holds at its middle, on a wide one they imply it everywhere."""
    random = np.random.default_rng(3)
    narrow, wide = [], 0
    for _ in range(3000):
        slope = float(random.choice([-1.0, 1.0])) * float(random.uniform(0.01, 0.4))
        mu = math.tan(abs(slope)) * float(random.uniform(1.0, 5.0))
        body = on_slope(slope, float(random.uniform(0.1, 0.9)), mu=mu, rolling_resistance=resistance).to_body()
        angle = float(random.uniform(-math.pi, math.pi))
        energy = potential(body, angle) + float(random.uniform(-0.05, 0.6))
        known = is_held(body, angle, 1e-11, energy)
        assert holds(body, angle, energy) if resistance and known else resistance or known == holds(body, angle, energy)
        narrow.append(known)
        if is_held(body, angle, 0.4, energy):
            wide += 1
            assert all(
                holds(body, place, energy) for place in [angle - 0.4, angle + 0.4, *(angle + random.uniform(-0.4, 0.4, 20))]
            )
    assert 300 < sum(narrow) < 2700
    assert wide > 100


def test_what_is_said_to_stay_stays():
    """It neither hops nor leaves its well in 300 units of time, and its energy never grows."""
    random = np.random.default_rng(7)
    stays = slips = 0
    for _ in range(150):
        scenario = random_state(random)
        start = scenario.start
        if not stays_in_well(scenario.to_body(), start.angle, start.slip, start.omega):
            continue
        stays += 1
        motion = hh.simulate(scenario.replace("duration", 300.0))
        late = motion.at(np.linspace(0.0, motion.duration, 3000))
        assert "H" not in motion.sequence
        assert np.ptp(late.angle) < 2.0 * math.pi
        known = energies(scenario, late)
        assert np.diff(known).max() < 1e-12
        slips += bool({"S", "K"} & set(motion.sequence))
    assert stays > 40
    assert slips > 20


def test_slip_downhill_that_gains_energy_is_not_said_to_stay():
    """With little friction and the load ahead slip downhill adds to E: what would be forgotten with the sign of g_t."""
    scenario = sliding(on_slope(0.15, 0.6, mu=0.165), math.pi - 1.0, 0.3)
    motion = hh.simulate(scenario.replace("duration", 0.5))
    known = energies(scenario, motion.at(np.linspace(0.0, 0.5, 50)))
    assert motion.at(0.5).mode == "K"
    assert np.diff(known).max() > 1e-4
    assert not stays_in_well(scenario.to_body(), scenario.start.angle, scenario.start.slip, 0.0)
    steeper = scenario.replace("plane.mu", 3.0)
    assert stays_in_well(steeper.to_body(), scenario.start.angle, scenario.start.slip, 0.0)


@pytest.mark.parametrize("slope", [0.05, -0.05])
def test_the_lower_top_counts(slope):
    """Below the upper top but above the lower one a hoop rolls over it, downhill."""
    scenario = on_slope(slope, 0.75)
    body = scenario.to_body()
    top = float(first_maximum(body))
    tops = sorted((potential(body, angle), angle) for angle in (top, top + 2.0 * math.pi))
    angle = top + math.pi
    for energy, stays in ((tops[0][0] - 0.05, True), (tops[0][0] + 0.05, False)):
        free = energy - potential(body, angle)
        arm, lever = 1.0 + body.eps * math.cos(angle), body.eps * math.sin(angle)
        omega = math.copysign(math.sqrt(2.0 * free / (arm**2 + lever**2 + body.kap)), slope)
        smooth = scenario.replace("plane.mu", 50.0)
        assert stays_in_well(smooth.to_body(), angle, 0.0, omega) is stays
        motion = hh.simulate(sliding(smooth, angle, 0.0, omega).replace("duration", 60.0))
        assert (abs(motion.at(60.0).angle - angle) < 2.0 * math.pi) is stays
