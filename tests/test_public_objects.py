"""Objects of the public API in Python's own ways: copies, pickles, other processes; arguments of wrong types."""

import copy
import pickle
import warnings
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import filmed, hopping
from hophoop.scenario import InputError

SLOPE = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=hh.Plane(slope=0.05), duration=1.0)
GAIT = hh.Scenario(plane=hh.Plane(slope=np.radians(1.0), gravity=1.0))
WINDOW = {"plane.mu": (0.3, 1.9), "start.speed": (0.3, 4.5)}
STATE = ("x", "height", "angle", "omega", "slip")


def sampled():
    """A motion of which everything that it keeps has been asked."""
    motion = hh.simulate(hh.Scenario(duration=1.0))
    motion.at(0.5)
    for name in ("sequence", "events", "fingerprint", "ledger", "units", "doubt"):
        getattr(motion, name)
    return motion


def uncertain(correlations=None):
    found = sampled().uncertainty({"plane.mu": 0.02, "start.speed": 0.01}, correlations or {("plane.mu", "start.speed"): 0.5})
    found.deviation("end.x")
    return found


OBJECTS = {
    "start": lambda: hh.Start.of(sampled().at(0.5)),
    "hoop of parts": lambda: hh.Hoop.from_parts(0.3, [hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27)]),
    "motion": sampled,
    "errors": lambda: sampled().errors,
    "sample": lambda: sampled().at([0.1, 0.5]),
    "events": lambda: sampled().events,
    "sensitivity": lambda: sampled().sensitivity("end.x", ["plane.mu", "start.speed"]),
    "uncertainty": uncertain,
    "deviations": lambda: uncertain().at(0.5),
    "phases": lambda: tuple(hh.phases(sampled().scenario)),
    "precise motion": lambda: hh.simulate(hh.Scenario(duration=0.5), digits=15),
    "passages": lambda: hh.passages(SLOPE, 5),
    "fates": lambda: hh.gaits.fates([SLOPE]),
    "theory": lambda: hh.theory.summary(SLOPE),
    "axis quantities": lambda: dict(hh.maps.QUANTITIES),
    "entry of the catalogue": lambda: hh.maps.catalogue()[0],
    "look": lambda: hh.animate.Look(),
    "track": lambda: filmed(hopping(), rate=60.0),
    "fit": lambda: hh.fit(filmed(hopping(), rate=30.0)),
    "plan": lambda: hh.plan(hopping().scenario, rate=60.0),
    "gait": lambda: hh.gaits.find(GAIT, near=3.31)[0],
    "branch": lambda: hh.gaits.find(GAIT, near=3.31)[0].follow("plane.slope", (0.0174, 0.0176)),
    "return map": lambda: hh.gaits.return_map(GAIT, 3.3, 3.5),
    "boundary": lambda: hh.maps.boundary(None, WINDOW, one=(1.0, 3.1), other=(1.0, 3.8), step=0.2),
}


def shown(thing):
    """What a copy has to keep."""
    if isinstance(thing, hh.Trajectory):
        return thing.fingerprint, [getattr(thing.at([0.1, 0.5]), name).tolist() for name in STATE]
    return str(thing)


@pytest.mark.parametrize("name", OBJECTS)
def test_public_objects_are_copied_and_pickled(name):
    thing = OBJECTS[name]()
    for other in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
        assert type(other) is type(thing)
        assert shown(other) == shown(thing)


def test_a_process_pool_takes_and_returns_motions():
    motion = sampled()
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        assert pool.submit(shown, motion).result() == shown(motion)
        assert shown(pool.submit(hh.simulate, motion.scenario).result()) == shown(motion)


# functions, and arguments that none of them can take
WRONG = [
    (lambda t: sampled().at(t), [(10**400,), ("now",), ({},)]),
    (hh.Start.of, [(5,), (None,)]),
    (hh.Scenario.from_query, [(None,), (5,)]),
    (hh.Scenario.loads, [(None,)]),
    (hh.Scenario.from_dict, [(5,)]),
    (hh.simulate, [(5,), (hh.Hoop,)]),
    (hh.maps.sweep, [(hh.Hoop, {"plane.mu": [1.0]}), (hh.Hoop(), {"plane.mu": [1.0]}), (None, 5), (None, [])]),
    (hh.maps.points, [(5, {"plane.mu": [1.0]}), (None, 5)]),
    (hh.gaits.fates, [([],), (5,), ([SLOPE], -5), ([hh.Hoop],)]),
    (hh.passages, [(None,)]),
    (hh.gaits.find, [(hh.Hoop(),)]),
    (lambda near: hh.gaits.find(SLOPE, near=near), [(5e-324,), (1e308,), (np.nan,)]),
    (hh.maps.linear, [(0.1, np.inf, 4), (-1e308, 1e308, 4), (None, 1.0, 4), ("1", 2.0, 4)]),
    (hh.maps.logarithmic, [(0.1, np.inf, 4), ([], 1.0, 4)]),
    (hh.maps.scenario_at, [(5, {}), (SLOPE, 5)]),
    (hh.maps.borders, [(5,), ({},)]),
    (hh.maps.words_of, [(None,), ([],)]),
    (hh.phases, [(5,)]),
    (lambda: hh.phases(sampled()), [()]),
    (hh.theory.summary, [(None,), (hh.Hoop(),)]),
    (hh.cite.cite, [(5,), (SLOPE,)]),
    (hh.fit, [(5,), (None,), ([],)]),
    (hh.plan, [({}, 60.0), (hh.Hoop, 60.0)]),
    (hh.show, [(3,), (SLOPE, ["chart"])]),
    (uncertain, [({("plane.mu", "start.speed"): 0.5, ("start.speed", "plane.mu"): -0.5},)]),  # two of a pair
]


@pytest.mark.parametrize(("call", "given"), [(call, given) for call, several in WRONG for given in several])
def test_wrong_arguments_are_one_sentence(call, given):
    warnings.simplefilter("error")  # which pytest undoes
    with pytest.raises(InputError) as refused:
        call(*given)
    assert str(refused.value).endswith(".")
    assert "\n" not in str(refused.value)
