"""Random scenarios each have a fate, which a much longer motion does not contradict."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.names import Fate
from random_scenarios import rolling

SEED = 7
LATE = 2000.0  # √(R/g), for which a motion is followed on from its last passage
AGES = 1e6  # √(R/g), within which a hoop must rest
PERIODS = 20  # more of a gait that must repeat itself
REPEATS = 1e-7  # relative difference of θ̇ that is a repetition


def holds(given, fate, period, decided_at):
    """Whether a much longer motion does what its fate says."""
    if fate == "rests":
        return hh.simulate(given.replace("duration", AGES)).status == "at_rest"
    found = hh.passages(given, decided_at + PERIODS * max(period, 1))
    if fate == "gait":
        apart = np.abs(found.omega[-period:] - found.omega[-2 * period : -period]) / (1.0 + np.abs(found.omega[-period:]))
        return len(found) == decided_at + PERIODS * period and apart.max() <= REPEATS
    last = given.replace("start", found.start(-1)) if len(found) else given
    motion = hh.simulate(last.replace("duration", LATE))
    late = motion.at(np.linspace(0.5 * motion.duration, motion.duration, 400))
    does = {
        "rocks": np.ptp(late.angle) < 2.0 * math.pi,
        "rolls ahead": late.omega.min() > 0.0,
        "rolls back": late.omega.max() < 0.0,
        "slips ever less": np.ptp(np.sign(late.omega)) == 0.0 and bool({"S", "K"} & set(late.mode)),
    }
    return bool(does[fate])


@pytest.mark.parametrize("index", range(60))
def test_a_random_fate(index):
    """It stays, and where both sections decide what becomes of a motion, they decide the same."""
    scenario = rolling(SEED, index)
    judged = hh.gaits.fates([scenario])
    fate = str(judged.fates[0])
    assert fate in set(Fate)
    landing = str(hh.gaits.fates([scenario], 500, section="landing").fates[0])
    assert landing == fate or "undecided" in (landing, fate)
    if fate not in ("runs away", "slides away", "chaotic", "undecided"):
        assert holds(scenario, fate, int(judged.periods[0]), int(judged.passages[0]))


@pytest.mark.parametrize(
    ("index", "fate"),
    [(2, "gait"), (107, "runs away"), (35, "rests"), (340, "slips ever less")],
)
def test_bounces_at_landings_are_not_taken_for_a_fate(index, fate):
    """Bounces that die away are all alike, but do not rock; a revolution in flight that ends in rolling did not roll."""
    scenario = rolling(35, index)
    for section in ("bottom", "landing"):
        assert hh.gaits.fates([scenario], section=section).fates == (fate,)
