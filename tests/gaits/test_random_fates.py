"""Random scenarios each have a fate, which a much longer motion does not contradict."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.names import Fate

SEED = 7
LATE = 2000.0  # √(R/g), for which a motion is followed on from its last passage
AGES = 1e6  # √(R/g), within which a hoop must rest
PERIODS = 20  # more of a gait that must repeat itself
REPEATS = 1e-7  # relative difference of θ̇ that is a repetition


def scenario_of(seed: int, index: int) -> hh.Scenario:
    """The scenario for which (seed, index) tells everything, in units of R and g."""
    random = np.random.default_rng([seed, index])
    plane = hh.Plane(
        gravity=1.0,
        slope=float(random.choice([0.0, random.uniform(0.0, 0.1), random.uniform(0.0, 0.6)])),
        mu=float(random.uniform(0.02, 2.0)),
        restitution=float(random.choice([0.0, random.uniform(0.0, 0.9)])),
        rolling_resistance=float(random.choice([0.0, random.uniform(0.0, 0.1)])),
    )
    hoop = hh.Hoop.ideal(float(random.uniform(0.05, 0.95)))
    angle = float(random.uniform(-math.pi, math.pi))
    return hh.Scenario(hoop=hoop, plane=plane, start=hh.Start.rolling(float(random.uniform(-4.0, 4.0)), angle=angle))


def problem_of(given: hh.Scenario, fate: str, period: int, decided_at: int) -> str | None:
    """What a much longer motion does that its fate does not allow, or None."""
    if fate == "rests":
        motion = hh.simulate(given.replace("duration", AGES))
        return None if motion.status == "at_rest" else f"rests, but is {motion.status} after {AGES:g}"
    more = PERIODS * max(period, 1)
    found = hh.passages(given, decided_at + more)
    if fate == "gait":
        if len(found) < decided_at + more:
            return f"a gait that ends after {len(found)} passages: {found.status}"
        apart = np.abs(found.omega[-period:] - found.omega[-2 * period : -period]) / (1.0 + np.abs(found.omega[-period:]))
        return None if apart.max() <= REPEATS else f"a gait that differs by {apart.max():.1e} a period later"
    last = given.replace("start", found.start(-1)) if len(found) else given
    motion = hh.simulate(last.replace("duration", LATE))
    late = motion.at(np.linspace(0.5 * motion.duration, motion.duration, 400))
    if fate == "rocks" and np.ptp(late.angle) >= 2.0 * math.pi:
        return f"rocks, but turns by {np.ptp(late.angle):.2f} rad late"
    if fate in ("rolls ahead", "rolls back") and (late.omega * (1.0 if fate == "rolls ahead" else -1.0)).min() <= 0.0:
        return f"{fate}, but does not"
    if fate == "slips ever less" and not (np.ptp(np.sign(late.omega)) == 0.0 and {"S", "K"} & set(late.mode)):
        return "slips ever less, but does not"
    return None


@pytest.mark.parametrize("index", range(60))
def test_a_random_fate(index):
    """It stays, and where both sections decide what becomes of a motion, they decide the same."""
    scenario = scenario_of(SEED, index)
    judged = hh.gaits.fates([scenario])
    fate = str(judged.fates[0])
    assert fate in set(Fate)
    landing = str(hh.gaits.fates([scenario], 500, section="landing").fates[0])
    assert landing == fate or "undecided" in (landing, fate)
    if fate in ("rocks", "rests", "gait", "rolls ahead", "rolls back", "slips ever less"):
        assert problem_of(scenario, fate, int(judged.periods[0]), int(judged.passages[0])) is None


@pytest.mark.parametrize(
    ("index", "fate"),
    [(2, "gait"), (3, "runs away"), (35, "rests"), (340, "slips ever less")],
)
def test_bounces_at_landings_are_not_taken_for_a_fate(index, fate):
    """Bounces that die away are all alike, but do not rock; a revolution in flight that ends in rolling did not roll."""
    scenario = scenario_of(35, index)
    for section in ("bottom", "landing"):
        assert hh.gaits.fates([scenario], section=section).fates == (fate,)


def test_a_wrong_fate_is_found():
    """A hoop that rolls ahead for ever neither rocks nor rests, and has no gait of one passage that ends."""
    scenario = hh.Scenario(plane=hh.Plane(gravity=1.0), start=hh.Start.rolling(0.3))
    assert hh.gaits.fates([scenario]).fates == ("rolls ahead",)
    for fate in ("rocks", "rests", "rolls back"):
        assert problem_of(scenario, fate, 0, 2) is not None
