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


def sampled(**parts):
    """A motion of which everything that it keeps has been asked."""
    motion = hh.simulate(hh.Scenario(duration=1.0, **parts))
    motion.at(0.5)
    for name in ("sequence", "events", "fingerprint", "ledger", "units", "doubt"):
        getattr(motion, name)
    return motion


def uncertain():
    found = sampled().uncertainty({"plane.mu": 0.02, "start.speed": 0.01}, {("plane.mu", "start.speed"): 0.5})
    found.deviation("end.x")
    return found


OBJECTS = {
    "scenario": lambda: SLOPE,
    "start": lambda: hh.Start.of(sampled().at(0.5)),
    "hoop of parts": lambda: hh.Hoop.from_parts(0.3, [hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27)]),
    "motion": sampled,
    "compliant motion": lambda: sampled(contact=hh.Compliant(stiffness=1e5)),
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
    "article": lambda: hh.article.scenarios(),
    "look": lambda: hh.animate.Look(),
    "track": lambda: filmed(hopping(), rate=60.0),
    "fit": lambda: hh.fit(filmed(hopping(), rate=30.0)),
    "plan": lambda: hh.plan(hopping().scenario, rate=60.0),
    "gait": lambda: hh.gaits.find(GAIT, near=3.31)[0],
    "branch": lambda: hh.gaits.find(GAIT, near=3.31)[0].follow("plane.slope", (0.0174, 0.0176)),
    "return map": lambda: hh.gaits.return_map(GAIT, 3.3, 3.5),
    "boundary": lambda: hh.maps.boundary(None, WINDOW, one=(1.0, 3.1), other=(1.0, 3.8), step=0.2),
    "bad input": lambda: InputError.of_field("threads", 0, "at least 1"),
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


WRONG = {
    "at(10**400)": lambda: sampled().at(10**400),
    "at('now')": lambda: sampled().at("now"),
    "at(None)": lambda: sampled().at({}),
    "Start.of(5)": lambda: hh.Start.of(5),
    "Start.of(None)": lambda: hh.Start.of(None),
    "from_query(None)": lambda: hh.Scenario.from_query(None),
    "from_query(5)": lambda: hh.Scenario.from_query(5),
    "loads(None)": lambda: hh.Scenario.loads(None),
    "from_dict(5)": lambda: hh.Scenario.from_dict(5),
    "simulate(5)": lambda: hh.simulate(5),
    "simulate(Hoop)": lambda: hh.simulate(hh.Hoop),
    "sweep(base=Hoop)": lambda: hh.maps.sweep(hh.Hoop, {"plane.mu": [1.0]}),
    "sweep(base=Hoop())": lambda: hh.maps.sweep(hh.Hoop(), {"plane.mu": [1.0]}),
    "sweep(axes=5)": lambda: hh.maps.sweep(None, 5),
    "sweep(axes=[])": lambda: hh.maps.sweep(None, []),
    "points(base=5)": lambda: hh.maps.points(5, {"plane.mu": [1.0]}),
    "points(values=5)": lambda: hh.maps.points(None, 5),
    "fates([])": lambda: hh.gaits.fates([]),
    "fates(5)": lambda: hh.gaits.fates(5),
    "fates(count=-5)": lambda: hh.gaits.fates([SLOPE], count=-5),
    "fates([Hoop])": lambda: hh.gaits.fates([hh.Hoop]),
    "passages(None)": lambda: hh.passages(None),
    "find(Hoop())": lambda: hh.gaits.find(hh.Hoop()),
    "find(near=5e-324)": lambda: hh.gaits.find(SLOPE, near=5e-324),
    "find(near=1e308)": lambda: hh.gaits.find(SLOPE, near=1e308),
    "find(near=nan)": lambda: hh.gaits.find(SLOPE, near=np.nan),
    "linear(0, inf)": lambda: hh.maps.linear(0.1, np.inf, 4),
    "linear(-1e308, 1e308)": lambda: hh.maps.linear(-1e308, 1e308, 4),
    "logarithmic(1, inf)": lambda: hh.maps.logarithmic(0.1, np.inf, 4),
    "linear(None, 1)": lambda: hh.maps.linear(None, 1.0, 4),
    "linear('1', 2)": lambda: hh.maps.linear("1", 2.0, 4),
    "logarithmic([], 1)": lambda: hh.maps.logarithmic([], 1.0, 4),
    "scenario_at(5)": lambda: hh.maps.scenario_at(5, {}),
    "scenario_at({}, 5)": lambda: hh.maps.scenario_at(SLOPE, 5),
    "borders(5)": lambda: hh.maps.borders(5),
    "borders({})": lambda: hh.maps.borders({}),
    "words_of(None)": lambda: hh.maps.words_of(None),
    "words_of([])": lambda: hh.maps.words_of([]),
    "phases(5)": lambda: hh.phases(5),
    "phases(motion)": lambda: hh.phases(sampled()),
    "summary(None)": lambda: hh.theory.summary(None),
    "summary(Hoop())": lambda: hh.theory.summary(hh.Hoop()),
    "cite(5)": lambda: hh.cite.cite(5),
    "cite(scenario)": lambda: hh.cite.cite(SLOPE),
    "fit(5)": lambda: hh.fit(5),
    "fit(None)": lambda: hh.fit(None),
    "fit([])": lambda: hh.fit([]),
    "plan({})": lambda: hh.plan({}, rate=60.0),
    "plan(Hoop)": lambda: hh.plan(hh.Hoop, rate=60.0),
    "two correlations of a pair": lambda: sampled().uncertainty(
        {"plane.mu": 0.1, "start.speed": 0.1},
        {("plane.mu", "start.speed"): 0.5, ("start.speed", "plane.mu"): -0.5},
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_arguments_are_one_sentence(name):
    warnings.simplefilter("error")  # which pytest undoes
    with pytest.raises(InputError) as refused:
        WRONG[name]()
    assert str(refused.value).endswith(".")
    assert "\n" not in str(refused.value)


def test_equal_planes_have_equal_links():
    for mu in (0.5, 1.0, np.inf):
        one, other = (hh.Scenario(plane=plane) for plane in (hh.Plane(mu=mu), hh.Plane(mu_static=mu, mu_kinetic=mu)))
        assert one == other
        assert (one.to_query(), one.to_toml()) == (other.to_query(), other.to_toml())
    apart = hh.Scenario(plane=hh.Plane(mu_static=0.5, mu_kinetic=0.4))
    assert hh.Scenario.from_query(apart.to_query()) == apart
