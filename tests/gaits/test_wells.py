"""Wells of energy: what a hoop on a slope never leaves is proved by bounds, which long motions test."""

import math

import numpy as np

import hophoop as hh
from hophoop.gaits.kernels.wells import rolling_potential, stays_in_well


def on_slope(slope, gamma, **plane):
    """A hoop on a slope, in units of R and g."""
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(gravity=1.0, slope=slope, **plane))


def sliding(scenario, angle, slip, omega=0.0):
    """The same with a start in contact."""
    return scenario.replace("start", hh.Start(angle=angle, vx=slip + omega, omega=omega, slip=slip))


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
