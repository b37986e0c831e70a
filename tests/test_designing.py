"""The best of many motions: inside a class, at its border, at a limit, and across borders."""

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.scenario import InputError


@pytest.fixture(autouse=True)
def _interpreted():
    with forced("interpreted"):
        yield


@pytest.mark.slow
def test_the_highest_hop_lies_beside_the_speed_that_hops_at_once():
    """The faster the higher, up to v² = g R/γ, from where the hop at once is a small one."""
    scenario = hh.Scenario(duration=1.9)
    best = hh.design(scenario, maximise="hop_height", over={"start.speed": (3.4, 4.0)}, tries=2, climbs=1)
    assert best.at_border
    assert best.parameters["start.speed"] == pytest.approx(np.sqrt(9.81 / 0.75), rel=1e-8)
    assert best.value == best.motion.find("apex")[0].height > 0.89
    assert best.scenario.start.speed == best.parameters["start.speed"]
    assert best.motions < 150


def test_a_maximum_inside_a_class_is_where_the_derivative_is_zero():
    scenario = hh.Scenario(start=hh.Start(height=0.3, vx=1.0, omega=4.0), plane=hh.Plane(mu=0.4), duration=0.26)
    best = hh.design(scenario, maximise="impact.omega", over={"start.angle": (0.5, 5.0)}, tries=6, climbs=1)
    assert not best.at_border
    slope = best.motion.sensitivity("impact.omega", "start.angle").derivatives[0, 0]
    assert slope == pytest.approx(0.0, abs=1e-5)
    for angle in np.linspace(0.5, 5.0, 19).tolist():
        impacts = hh.simulate(scenario.with_values({"start.angle": angle})).find("impact")
        assert not impacts or impacts[0].omega <= best.value


def test_climbs_with_rolling_resistance():
    """How far a push takes the hoop in a while, by the angle that it begins at: at the best the derivative is zero."""
    scenario = hh.Scenario(
        hoop=hh.Hoop.ideal(0.2), plane=hh.Plane(rolling_resistance=0.1), start=hh.Start.rolling(1.5), duration=0.8
    )  # fmt: skip
    best = hh.design(scenario, maximise="end.x", over={"start.angle": (-1.0, 3.0)}, tries=3, climbs=1)
    assert not best.at_border
    assert best.motion.sequence == "R"
    assert best.motion.sensitivity("end.x", "start.angle").derivatives[0, 0] == pytest.approx(0.0, abs=1e-5)
    for angle in np.linspace(-1.0, 3.0, 9).tolist():
        assert hh.simulate(scenario.with_values({"start.angle": angle})).events[-1].x <= best.value


@pytest.mark.slow
def test_the_most_friction_that_hops_in_time_lies_at_the_border_of_its_class():
    scenario = hh.Scenario(duration=1.05)
    over, limits = {"plane.mu": (0.9, 1.5)}, {"takeoff.t": (0.0, None)}
    best = hh.design(scenario, maximise="plane.mu", over=over, subject_to=limits, tries=2, climbs=1)

    def hops(mu):
        return bool(hh.simulate(scenario.with_values({"plane.mu": mu})).find("takeoff"))

    assert best.at_border
    assert hops(best.value)
    assert not hops(best.value * (1 + 1e-8))


@pytest.mark.slow
def test_a_limit_on_another_quantity_is_kept_and_used_up():
    scenario = hh.Scenario(duration=1.9)
    limits = {"hop.duration": (None, 0.7)}
    best = hh.design(scenario, maximise="hop.height", over={"start.speed": (2.9, 3.2)}, subject_to=limits, tries=4, climbs=1)
    landing, takeoff = best.motion.find("impact")[0].t, best.motion.find("takeoff")[0].t
    assert landing - takeoff == pytest.approx(0.7, abs=1e-7)
    assert not best.at_border


@pytest.mark.slow
def test_it_goes_on_across_the_border_of_a_class():
    """All tries lie in one class; the best friction lies in another."""
    scenario = hh.Scenario(duration=1.9)
    best = hh.design(scenario, maximise="hop_height", over={"start.speed": (2.5, 4.6), "plane.mu": (0.3, 3.0)}, tries=16)
    assert len({climb.sequence for climb in best.climbs}) > 1
    values = [climb.value for climb in best.climbs]
    assert values == sorted(values, reverse=True)
    random = np.random.default_rng(1)
    for _ in range(60):
        values = {"start.speed": float(random.uniform(2.5, 4.6)), "plane.mu": float(random.uniform(0.3, 3.0))}
        motion = hh.simulate(scenario.with_values(values))
        if "H" in motion.sequence and motion.find("apex") and motion.find("impact"):
            assert motion.find("apex")[0].height <= best.value


@pytest.mark.slow
def test_landing_with_the_load_on_top():
    over = {"start.speed": (2.5, 4.6), "hoop.load_fraction": (0.6, 0.9)}
    best = hh.design(hh.Scenario(duration=2.2), maximise="hop.load_up", over=over, tries=12, climbs=3)
    assert best.value == pytest.approx(1.0, abs=1e-9)
    assert np.cos(best.motion.find("impact")[0].angle) == best.value


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"over": {"start.speed": (1, 2)}}, "either maximise or minimise"),
        ({"over": {"start.speed": (1, 2)}, "maximise": "hop_height", "minimise": "end.x"}, "and not both"),
        ({"over": {"start.speed": (2, 1)}, "maximise": "hop_height"}, "the lower one first"),
        ({"over": {}, "maximise": "hop_height"}, "at least one"),
        ({"over": {"start.pace": (1, 2)}, "maximise": "hop_height"}, "is not a known key"),
        ({"over": {"start.speed": (0.1, 0.2)}, "maximise": "hop_height", "tries": 2}, "None of the 2 motions"),
        ({"over": {"start.speed": (0.1, 0.2)}, "maximise": "leap_height", "tries": 2}, "is no quantity"),
        (
            {"over": {"start.speed": (3, 4)}, "maximise": "end.x", "subject_to": {"end.t": (None, None)}},
            "one of which may be None",
        ),
        (
            {"over": {"start.speed": (3, 4)}, "maximise": "end.x", "subject_to": {"end.x": (1e9, None)}, "tries": 2},
            "within the limits",
        ),
    ],
)
def test_what_is_refused(arguments, sentence):
    with pytest.raises(ValueError, match=sentence):
        hh.design(hh.Scenario(duration=0.5), **arguments)


def test_a_quantity_that_none_of_the_motions_tried_has():
    """The scenario itself has it as little as they do."""
    scenario = hh.Scenario(duration=0.1)
    with pytest.raises(InputError, match=r"^None of the 2 motions tried has 'revolutions_to_rolling'; widen"):
        hh.design(
            scenario.replace("start.speed", 3.95),
            maximise="revolutions_to_rolling",
            over={"start.speed": (3.9, 4.0)},
            tries=2,
            climbs=1,
        )
    with pytest.raises(InputError, match=r"^None of the 2 motions tried has 'impact\.t'; widen"):
        hh.design(scenario, maximise="impact.t", over={"start.speed": (0.9, 1.0)}, tries=2, climbs=1)
    with pytest.raises(InputError, match=r"^of = .impact\.weight.: an event has t, "):
        hh.design(scenario, maximise="impact.weight", over={"start.speed": (0.9, 1.0)}, tries=2, climbs=1)
