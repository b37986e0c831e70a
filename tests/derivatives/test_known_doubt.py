"""What derivatives take from the motion instead of computing it again; benchmarks/speed.py measures their cost."""

import math

import numpy as np

import hophoop as hh
from hophoop.kernel.native import forced


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
    """A loaded motion finds it by a second run."""
    with forced("interpreted"):
        certain, doubtful = hh.simulate(hh.Scenario(duration=2.0)), hh.simulate(graze())
        assert certain.doubt == certain.kernel_doubt == math.inf
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
    assert np.isinf(motion.errors.t).tolist() == [event.t > motion.doubt for event in motion.events]
