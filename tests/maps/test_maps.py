"""Maps against single motions: every cell is what `simulate` gives, whatever the axes are."""

import math
from functools import partial

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import hophoop as hh
from hophoop import maps
from hophoop.kernel.records.cells import CELL
from hophoop.kernel.records.layout import LETTERS_PER_INTEGER
from hophoop.maps.grid import kernel
from hophoop.maps.grid.axes import linear, logarithmic, make_axes, parse_axis
from hophoop.maps.grid.cells import make_cells
from hophoop.scenario import cell_of, paths
from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import RANGES

LONGEST = LETTERS_PER_INTEGER * kernel.INTEGERS - 1  # letters of a kept sequence


# Cells


VALUES = {
    "duration": st.floats(0.1, 9.0),
    "hoop.radius": st.floats(0.1, 3.0),
    "hoop.mass": st.floats(0.1, 3.0),
    "hoop.load_fraction": st.floats(0.0, 1.0),
    "hoop.eccentricity": st.sampled_from([0.1, 0.5, 1.0]),
    "hoop.inertia_ratio": st.sampled_from([0.0, 0.3, 1.0]),
    "plane.gravity": st.sampled_from([0.0, 1.62, 9.81]),
    "plane.slope": st.floats(-1.0, 1.0),
    "plane.mu": st.floats(0.0, 2.0) | st.just(math.inf),
    "plane.mu_static": st.floats(0.0, 2.0),
    "plane.mu_kinetic": st.floats(0.0, 2.0),
    "plane.restitution": st.floats(0.0, 1.0),
    "plane.rolling_resistance": st.sampled_from([0.0, 0.01, 1.0]),
    "plane.impact_law": st.sampled_from(sorted(LAW_CODES)),
    "plane.painleve": st.sampled_from(["flight", "impact"]),
    "start.x": st.floats(-3.0, 3.0),
    "start.height": st.floats(0.0, 2.0),
    "start.angle": st.floats(-4.0, 4.0),
    "start.speed": st.floats(-5.0, 5.0),
    "start.vx": st.floats(-5.0, 5.0),
    "start.vy": st.floats(-5.0, 5.0),
    "start.omega": st.floats(-5.0, 5.0),
    "contact.max_events": st.integers(1, 999),
}
# Two ways of saying the same, which cannot both be axes.
OVERRIDING = [("plane.mu", "plane.mu_static"), ("plane.mu", "plane.mu_kinetic")]
OVERRIDING += [("start.speed", f"start.{name}") for name in ("height", "vx", "vy", "omega")]
OVERRIDING += [("hoop.load_fraction", f"hoop.{name}") for name in ("eccentricity", "inertia_ratio")]
BASES = [
    hh.Scenario(),
    hh.Scenario.from_query("start.height=0.5&start.angle=0.3&start.vx=1&start.vy=0.2&start.omega=2"),
    hh.Scenario(hoop=hh.Hoop.from_parts(0.3, [hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.25)])),
]


def test_every_parameter_of_a_rigid_scenario_can_be_varied():
    other = {f"contact.{name}" for name in hh.Compliant.model_fields if name != "max_events"} | {"hoop.parts"}
    assert set(VALUES) == set(paths()) - other


@settings(max_examples=300)
@given(
    st.sampled_from(BASES),
    st.lists(st.sampled_from(list(VALUES)), min_size=2, max_size=5, unique=True).flatmap(
        lambda names: st.fixed_dictionaries({name: VALUES[name] for name in names})
    ),
)
@example(BASES[0], {"start.omega": 2.0, "hoop.radius": 0.4})
@example(BASES[2], {"hoop.parts.1.mass": 0.1, "hoop.radius": 0.4})
def test_cells_are_the_scenarios_that_they_stand_for(base, values):
    assume(sum(values.keys() >= {a, b} for a, b in OVERRIDING) == 0)
    try:
        scenario = maps.scenario_at(base, values)
    except ValueError:
        assume(False)
    cells = make_cells(base, {path: np.array([value] * 2) for path, value in values.items()}, 2)
    for cell in cells.T:
        assert dict(zip(CELL, cell, strict=True)) == dict(zip(CELL, cell_of(scenario), strict=True))


@pytest.mark.parametrize("speed", [1.0, 3.1])
@pytest.mark.parametrize(
    "path", ["start.speed", "start.vx", "start.omega", "start.height", "start.vy", "start.angle", "start.x", "plane.mu"]
)
def test_cells_of_a_start_that_goes_on_from_a_state(path, speed):
    """A number of the start in another way, or a velocity, ends its slip velocity or its mode, as in a scenario.

    In rolling or in slip; on less friction rolling cannot go on.
    """
    motion = hh.simulate(hh.Scenario(start=hh.Start.rolling(speed)))
    onward = motion.scenario.replace("start", hh.Start.of(motion.at(0.5)))
    for value in (0.0, 1e-3, 0.7):
        (cell,) = make_cells(onward, {path: np.array([value])}, 1).T
        try:
            wanted = cell_of(maps.scenario_at(onward, {path: value}))
        except ValueError:
            assert dict(zip(CELL, cell, strict=True))["allowed"] == 0.0
        else:
            assert dict(zip(CELL, cell, strict=True)) == dict(zip(CELL, wanted, strict=True))


# Motions


close = partial(pytest.approx, rel=1e-9, abs=1e-12)


def cells_of(span, step, duration=2.0, resistance=0.0):
    """Cells of a map of all quantities, codes as words, each with the scenario that it stands for."""
    base = hh.Scenario(duration=duration).replace("plane.mu_kinetic", 0.6).replace("plane.rolling_resistance", resistance)
    axes = {"plane.mu_static": np.linspace(0.65, 1.95, 12), "start.speed": np.linspace(-5.0, 5.0, 24)}
    dataset = maps.sweep(base, axes, list(maps.QUANTITIES), span)
    stacked = dataset.stack(cell=tuple(axes))
    words = {name: maps.words_of(array) for name, array in dataset.items() if "flag_values" in array.attrs}
    for k in range(0, stacked.sizes["cell"], step):
        cell = {name: array.values[k].item() for name, array in stacked.items()}
        cell |= {name: table[cell[name]] for name, table in words.items()}
        yield cell, maps.scenario_at(base, dict(zip(axes, stacked["cell"].values[k], strict=True)))


@pytest.mark.parametrize("resistance", [0.0, 0.01])
def test_a_map_over_the_duration_holds_what_simulate_gives(resistance):
    hops = 0
    for cell, scenario in cells_of("duration", 5, resistance=resistance):
        motion = hh.simulate(scenario)
        events, last, ledger = motion.events, motion.events[-1], motion.ledger
        kinds = [event.kind for event in events if event.kind != "apex"]
        lost = ledger.friction + ledger.impact_normal + ledger.impact_tangential + ledger.rolling_resistance
        sample = motion.at(motion.times(5001))
        used = np.nanmax(sample.utilization(scenario.plane))
        expected = {
            "sequence": motion.sequence, "status": motion.status, "first_event": kinds[1], "ending": "duration",
            "hop": "yes" if "H" in motion.sequence else "no",
            "painleve": "yes" if any(kind.startswith("painleve") for kind in kinds) else "no",
            "time": close(motion.duration), "end_angle": last.angle, "end_speed": close(last.vx), "distance": close(last.x),
            "energy_lost": close(lost),
            # sampling misses the very end of a rolling phase
            "greatest_utilization": pytest.approx(used, abs=0.05),
            "revolutions_to_rolling": pytest.approx(math.nan, nan_ok=True),
        }  # fmt: skip
        assert cell["greatest_utilization"] >= used - 1e-10
        roll = sample.mode == "R"
        steps = np.abs(np.diff(sample.x))
        rolled = steps[roll[1:] & roll[:-1]].sum()
        assert abs(cell["distance_rolled"] - rolled) <= steps.max() * len(events)
        if motion.sequence[-1] == "R":
            begun = [event for event in events if event.to_mode == "R" and event.from_mode != "R"][-1]
            expected["revolutions_to_rolling"] = close(abs(begun.angle) / (2 * math.pi))
        takeoffs = [event for event in events if event.to_mode == "H" and event.kind != "apex"]
        landings = [event for event in motion.find("impact") if event.collision]
        if takeoffs and landings:
            hops += 1
            takeoff, landing = takeoffs[0], landings[0]
            before = events[events.index(landing) - 1]
            loss = landing.impact_normal + landing.impact_tangential - before.impact_normal - before.impact_tangential
            expected |= {
                "takeoff_time": close(takeoff.t), "takeoff_angle": takeoff.angle, "landing_angle": close(landing.angle),
                "hop_height": close(next(event.height for event in motion.find("apex") if event.t < landing.t)),
                "flight_time": close(landing.t - takeoff.t), "flight_distance": close(landing.x - takeoff.x),
                "landing_loss": pytest.approx(loss, rel=1e-8, abs=1e-12),
            }  # fmt: skip
        assert {name: cell[name] for name in expected} == expected, scenario.to_query()
    assert hops > 10


def test_infinite_friction_is_never_used_up():
    speeds = np.linspace(2.0, 5.0, 300)  # many end where N = 0, the quasi-jump
    found = maps.points(None, {"plane.mu": np.inf, "start.speed": speeds}, ["greatest_utilization", "sequence"])
    assert set(found["sequence"]) == {"R", "H"}
    used = found["greatest_utilization"]
    np.testing.assert_array_equal(used, np.where(found["sequence"] == "H", np.nan, 0.0))


@pytest.mark.parametrize("span", ["first_revolution", "takeoff", "reversal", "revolutions:1"])
def test_a_span_ends_where_it_says(span):
    untils = ["revolutions:1", "takeoff", "reversal"] if span == "first_revolution" else [span]
    endings = set()
    for cell, scenario in cells_of(span, 7, duration=30.0):
        ends = {until: hh.simulate(scenario, until=until) for until in untils}
        first = min(ends, key=lambda until: ends[until].duration)
        endings.add(cell["ending"])
        if "takeoff" in ends and ends[first].sequence[0] == "H":  # at the start itself
            assert (cell["time"], cell["sequence"], cell["ending"]) == (0.0, "H", "takeoff")
            continue
        ended = ends[first].status == "completed" and ends[first].duration < 30.0
        ending = first.split(":")[0] if ended else "duration"
        assert (cell["time"], cell["ending"]) == (close(ends[first].duration), ending)
        assert cell["sequence"] == ends[first].sequence + "H" * (ending == "takeoff")
    assert len(endings) > (span != "revolutions:1")


def test_cells_whose_values_do_not_go_together_are_marked():
    axes = {"plane.mu_static": [0.2, 0.8], "plane.mu_kinetic": [0.1, 0.5, 0.9]}
    dataset = maps.sweep(None, axes, ["status", "sequence", "time"])
    outside = np.array([[False, True, True], [False, False, True]])
    np.testing.assert_array_equal(dataset["status"].values == -1, outside)
    words = np.array(maps.words_of(dataset["sequence"]))[dataset["sequence"].values]
    np.testing.assert_array_equal(words == "not_allowed", outside)
    np.testing.assert_array_equal(np.isnan(dataset["time"].values), outside)


REFUSED = [
    (path, value)
    for path, allowed in RANGES.items()
    if path in VALUES and path != "contact.max_events"
    for value in (math.nan, -math.inf, allowed.least - 0.5 * (abs(allowed.least) or 1.0), 2.0 * allowed.most + 1.0)
]
REFUSED += [("plane.impact_law", "x"), ("plane.painleve", "x"), *(("contact.max_events", value) for value in (0, 1.5, 10**9))]


@pytest.mark.parametrize(("path", "value"), REFUSED)
def test_points_refuse_what_a_scenario_refuses(path, value):
    """A value outside the range of its own parameter; the sentence is that of a scenario."""
    usual = {"plane.mu_static": 1.0, "plane.mu_kinetic": 0.0}.get(path, value)
    with pytest.raises(ValueError) as refused:
        hh.Scenario().replace(path, value)
    with pytest.raises(ValueError) as found:
        maps.points(None, {path: [usual, value] if usual != value else [value]})
    assert str(found.value) == str(refused.value)


@pytest.mark.parametrize("path", ["start.slip", "start.mode", "contact.stiffness", "contact.model"])
def test_what_cannot_be_varied(path):
    for compute in (
        lambda: maps.points(None, {path: [1.0]}),
        lambda: make_axes(hh.Scenario(), {path: [1.0], "plane.mu": [1.0]}),
    ):
        with pytest.raises(ValueError, match="cannot be an axis"):
            compute()


def test_points_of_lists_that_do_not_go_together_name_them():
    with pytest.raises(ValueError, match=r"plane\.mu \(3,\), start\.speed \(2,\)"):
        maps.points(None, {"plane.mu": [1.0, 2.0, 3.0], "start.speed": [1.0, 2.0]})


def test_points_of_a_start_that_goes_on_from_a_state():
    """Another radius contradicts its slip velocity; of a compliant contact there are none."""
    onward = hh.Scenario(start=hh.Start.of(hh.simulate(hh.Scenario()).at(0.5)))
    assert maps.points(onward, {"hoop.radius": [1.0, 2.0]})["sequence"].tolist()[1] == ""
    with pytest.raises(ValueError, match=r"^contact\.model = 'compliant'"):
        maps.points(hh.Scenario(contact=hh.Compliant()), {"plane.mu": [1.0]})


def test_a_full_buffer_is_taken_up_with_a_larger_one():
    base = hh.Scenario(duration=60.0).replace("plane.restitution", 0.9)
    base = base.replace("start", hh.Start(height=1.0, omega=3.0))
    found = maps.points(base, {"contact.max_events": [20, 3000]}, ["status", "sequence", "time"], "duration")
    short, whole = (base.replace("contact.max_events", most) for most in (20, 3000))
    assert found["status"].tolist() == [hh.simulate(short).status, hh.simulate(whole).status]
    motion = hh.simulate(whole)
    assert len(motion.events) > kernel.FIRST_EVENTS
    assert found["sequence"][1].rstrip("+") == motion.sequence[:LONGEST]


# Axes


def test_axes_as_text():
    path, values = parse_axis("start.speed=0.1:10:3:log")
    assert path == "start.speed"
    np.testing.assert_allclose(values, [0.1, 1.0, 10.0])
    assert parse_axis("plane.mu=1,0.5,inf")[1].tolist() == [1.0, 0.5, math.inf]


@pytest.mark.parametrize("count", [0, 1_000_000_000_000, math.inf, math.nan, 1.5])
def test_the_number_of_values_of_an_axis_has_its_bounds(count):
    """A million million ended with the size of an array of NumPy."""
    for spaced in (linear, logarithmic):
        with pytest.raises(ValueError, match=r"must be an integer from 1 to 100,000,000\.$"):
            spaced(0.1, 1.0, count)


@pytest.mark.parametrize("text", ["plane.mu", "plane.mu=", "plane.mu=1:2", "plane.mu=1:2:3:lin", "plane.mu=a:b:3"])
def test_bad_axes_as_text(text):
    with pytest.raises(ValueError, match="must read path=first:last:count"):
        parse_axis(text)


@pytest.mark.parametrize(
    ("axes", "message"),
    [
        ({}, "at least one"),
        ({"plane.mu": [1.0], "start.speeed": [1.0]}, "start.speeed"),
        ({"plane.mu": [1.0, -0.5], "start.speed": [1.0]}, "plane.mu = -0.5 must be from 0 to 1e\\+06, or inf"),
        ({"plane.mu": [1.0, math.nan], "start.speed": [1.0]}, "plane.mu = nan"),
        ({"plane.mu": [1.0, 1.0], "start.speed": [1.0]}, "plane.mu must not hold a value twice"),
        ({"plane.mu": [], "start.speed": [1.0]}, "plane.mu must be a list of values"),
        ({"plane.mu": ["much"], "start.speed": [1.0]}, "plane.mu must hold numbers"),
        ({"plane.mu": [1.0], "plane.mu_static": [1.0, 2.0]}, "cannot both be axes"),
        ({"start.omega": [1.0], "start.speed": [1.0, 2.0]}, "cannot both be axes"),
        ({"plane.impact_law": ["newton", "hertz"], "start.speed": [1.0]}, "hertz"),
        ({"contact.stiffness": [1e5], "start.speed": [1.0]}, "rigid"),
        ({"hoop.inertia_ratio": [0.0, 0.5], "start.speed": [1.0]}, "hoop.inertia_ratio = 0"),
    ],
)
def test_bad_axes(axes, message):
    with pytest.raises(ValueError, match=message):
        make_axes(hh.Scenario(), axes)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"quantities": ["hop_hight"]}, "'hop_hight' must be one of"),
        ({"quantities": []}, "at least one"),
        ({"quantities": ["time", "time"]}, "twice"),
        ({"span": "two_revolutions"}, "span = 'two_revolutions'"),
        ({"span": "revolutions:0"}, "with N above 0"),
        ({"threads": 0}, "threads = 0"),
        ({"scheduler": "tcp://x"}, "out must name a file"),
        ({"resume": True}, "out must name the file"),
        ({"out": "map.txt"}, "must end in .zarr or .nc"),
    ],
)
def test_bad_options(options, message):
    with pytest.raises(ValueError, match=message):
        maps.sweep(None, {"plane.mu": [1.0], "start.speed": [1.0]}, **options)


def test_a_logarithmic_axis_has_equal_ratios_and_exact_decades():
    assert logarithmic(0.001, 1000.0, 7).tolist() == [0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0]
    values = logarithmic(0.1, 5.0, 50)
    np.testing.assert_allclose(values, np.geomspace(0.1, 5.0, 50), rtol=4e-15)
    np.testing.assert_allclose(values[1:] / values[:-1], 50.0 ** (1 / 49), rtol=4e-15)
