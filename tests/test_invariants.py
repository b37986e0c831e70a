"""The checker of invariants sees each of them broken, where one number of a good motion is changed."""

import dataclasses

import numpy as np
import pytest

import hophoop as hh
from hophoop.simulation.trajectory import Trajectory
from invariants import check, findings
from symmetries import mirror_finding, mirrored, scaled, units_finding


class Changed(Trajectory):
    """A motion some of whose events, samples or properties are changed."""

    def __init__(self, motion, sample=None, **values):
        super().__init__(motion.scenario, motion._status, *motion.tables.values(), motion.version, motion._doubt)
        self.sample = sample
        self.__dict__.update({"events": motion.events} | values)

    def at(self, t, side="right"):
        sample = super().at(t, side)
        if self.sample is None or not np.shape(t):
            return sample
        name, mode, value = self.sample
        column = np.array(getattr(sample, name))
        column[np.flatnonzero(np.equal(sample.mode, mode))[-1:]] += value
        return dataclasses.replace(sample, **{name: column})


@pytest.fixture(scope="module")
def motion():
    """It rolls, skids, spins, flies and strikes, with rolling resistance."""
    scenario = hh.Scenario(plane=hh.Plane(rolling_resistance=0.01, restitution=0.3), start=hh.Start.rolling(3.1), duration=2.5)
    return hh.simulate(scenario)


def broken(motion):
    """Names of the invariants that a motion breaks."""
    return {each.invariant for each in findings(motion) if each.broken}


def with_event(motion, index, **values):
    """A motion with numbers of one event changed."""
    events = list(motion.events)
    events[index] = dataclasses.replace(events[index], **values)
    return Changed(motion, events=tuple(events))


# quantity, mode, what is added to one sample → what is broken
SAMPLES = [
    ("kinetic", "R", np.nan, "finite numbers"),
    ("slip", "R", 1e-300, "rolling"),
    ("slip", "S", 100.0, "direction of slip"),
    ("slip", "K", -100.0, "direction of slip"),
    ("height", "R", 1e-200, "contact"),
    ("vy", "R", 1e-200, "contact"),
    ("height", "H", -100.0, "contact"),
    ("normal_force", "H", 1e-9, "normal force"),
    ("friction_force", "R", 1e3, "friction cone"),
    ("friction_force", "K", 1e-9, "sliding friction"),
    ("potential", "R", 1e-8, "ledger"),
    ("rolling_resistance", "H", 1e-8, "ledger"),
]


def test_a_changed_sample_breaks_one_invariant(motion):
    assert {"R", "S", "K", "H"} <= set(motion.sequence)
    check(motion)
    for *sample, invariant in SAMPLES:
        assert broken(Changed(motion, sample)) == {invariant}, sample


def test_a_changed_event_or_sum_breaks_one_invariant(motion):
    stick = next(k for k, event in enumerate(motion.events) if event.to_mode == "R")
    changes = [
        (-1, {"t": motion.events[-2].t * 0.9}, "time"),
        (2, {"x": float("nan")}, "finite numbers"),
        (2, {"from_mode": "H"}, "modes"),
        (stick, {"slip": 1e-9}, "rolling"),
        *((-1, {name: -1e-9}, "losses") for name in ("friction", "rolling_resistance", "impact_tangential")),
    ]
    for index, values, invariant in changes:
        assert broken(with_event(motion, index, **values)) == {invariant}, values
    assert broken(Changed(motion, sequence=motion.sequence[:-1])) == {"sequence"}
    with pytest.raises(AssertionError, match=r"invariant='ledger'.*duration="):
        check(Changed(motion, ledger=dataclasses.replace(motion.ledger, residual=1e-8)))


@pytest.mark.parametrize("friction", ["tanh", "linear", "bristle"])
def test_a_compliant_contact(friction):
    scenario = hh.Scenario(start=hh.Start.rolling(3.1), duration=1.2, contact=hh.Compliant(stiffness=1e5, friction=friction))
    motion = hh.simulate(scenario)
    assert broken(motion) == set()
    mode = next(letter for letter in motion.sequence if letter in "SK")
    against = {"S": -1e3, "K": 1e3}[mode]
    assert "sliding friction" in broken(Changed(motion, ("friction_force", mode, against)))
    assert "friction cone" in broken(Changed(motion, ("friction_force", "R", 1e3)))
    assert broken(Changed(motion, ("damping", "R", 1e-3))) == {"ledger"}


def test_symmetries_see_one_last_bit(motion):
    image, (other, factors) = hh.simulate(mirrored(motion.scenario)), scaled(motion.scenario)
    same = hh.simulate(other)
    assert not mirror_finding(motion, image).broken
    assert not units_finding(motion, same, factors).broken
    index = int(np.argmax([event.x for event in motion.events]))
    others = [with_event(motion, index, x=np.nextafter(motion.events[index].x, np.inf)), with_event(motion, 2, kind="turn")]
    for changed in (*others, Changed(motion, events=motion.events[:-1])):
        assert mirror_finding(changed, image).broken
        assert units_finding(changed, same, factors).broken
