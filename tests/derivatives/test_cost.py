"""What derivatives cost, and what they take from the motion instead of computing it again."""

import math
import statistics
import time

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.results.propagation import doubtful_from
from hophoop.kernel.native import forced

PATHS = (
    "hoop.load_fraction", "hoop.radius", "hoop.mass", "plane.gravity", "plane.slope", "plane.mu_static",
    "plane.mu_kinetic", "plane.restitution", "start.x", "start.angle", "start.speed", "duration",
)  # fmt: skip
QUANTITIES = (
    "takeoff.t", "takeoff.angle", "hop.height", "hop.distance", "hop.duration", "impact.slip", "end.x", "energy_lost",
)  # fmt: skip
MOST = 8.0  # plain motions


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("resistance", [0.0, 0.005])
def test_twelve_directions_of_eight_quantities_cost_less_than_eight_motions(resistance):
    """Medians of calls in turn, so that a busy machine slows both."""
    with forced("compiled"):
        scenario = hh.Scenario(plane=hh.Plane(rolling_resistance=resistance), duration=2.0)
        motion = hh.simulate(scenario)
        calls = (lambda: hh.simulate(scenario), lambda: motion.sensitivity(QUANTITIES, PATHS))
        seconds = [[], []]
        for _ in range(300):
            for call, taken in zip(calls, seconds, strict=True):
                began = time.perf_counter()
                call()
                taken.append(time.perf_counter() - began)
    plain, derived = (statistics.median(taken[20:]) for taken in seconds)
    assert derived < MOST * plain


def graze():
    """Friction that is just enough to roll on, to the last digit that doubles have."""
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.4), start=hh.Start.rolling(0.5), duration=1.6)
    low, high = 0.05, 1.0
    for _ in range(54):
        middle = 0.5 * (low + high)
        slips = hh.simulate(scenario.with_values({"plane.mu": middle})).find("slip_start")
        low, high = (middle, high) if slips else (low, middle)
    return scenario.with_values({"plane.mu": high})


def test_a_motion_keeps_from_when_on_it_is_in_doubt(tmp_path):
    """As a second run of the kernel finds it, which a loaded motion needs."""
    with forced("interpreted"):
        certain, doubtful = hh.simulate(hh.Scenario(duration=2.0)), hh.simulate(graze())
        assert certain.doubt == certain.kernel_doubt == doubtful_from(certain) == math.inf
        assert doubtful.kernel_doubt == doubtful_from(doubtful)
        assert 0.0 < doubtful.doubt == doubtful.kernel_doubt * doubtful.units.time < doubtful.duration
        doubtful.save(tmp_path / "graze.nc")
        again = hh.load(tmp_path / "graze.nc")
        assert (again.doubt, again.kernel_doubt) == (doubtful.doubt, doubtful.kernel_doubt)


def test_a_doubt_is_in_seconds():
    """It begins with the panel in which rolling needs all the friction that there is."""
    motion = hh.simulate(graze())
    times = motion.times(2001)
    tangency = times[np.argmax(motion.at(times).utilization(motion.scenario.plane))]
    assert tangency - 0.2 < motion.doubt <= tangency < motion.kernel_doubt
