"""Maps against single motions: every cell is what `simulate` gives, whatever the axes are."""

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import hophoop as hh
from hophoop import maps
from hophoop.kernel.records.cells import CELL, Cell
from hophoop.kernel.records.layout import LETTERS_PER_INTEGER, unpacked_sequence
from hophoop.kernel.records.writing import add_letter
from hophoop.maps.grid import kernel
from hophoop.maps.grid.axes import Axis, chunk_shape, linear, logarithmic, make_axes, ordered, parse_axis
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.evaluate import Plan, run_cells
from hophoop.maps.grid.quantities import make_span
from hophoop.scenario import paths
from hophoop.vocabulary.names import LAW_CODES

SPEEDS = np.linspace(0.05, 5.0, 23)
FRICTIONS = np.linspace(0.05, 1.95, 17)
LONGEST = LETTERS_PER_INTEGER * kernel.INTEGERS - 1  # letters of a kept sequence


# Cells


def cell_of(scenario):
    """The kernel's numbers of a scenario by name, taken from its public face."""
    hoop, plane, state = scenario.hoop, scenario.plane, scenario.start.state(scenario.hoop)
    return {
        **{name: getattr(hoop, name) for name in ("radius", "mass", "eccentricity", "inertia_ratio")},
        **{name: getattr(plane, name) for name in ("gravity", "slope", "mu_static", "mu_kinetic", "restitution")},
        **{name: getattr(state, name) for name in ("x", "height", "angle", "vy", "omega", "slip")},
        "mode": -1.0,  # by the rule
        "rolling_resistance": plane.rolling_resistance,
        "law": LAW_CODES[plane.impact_law],
        "painleve_impact": plane.painleve == "impact",
        "duration": scenario.duration,
        "max_events": scenario.contact.max_events,
        "ideal": hoop.load_fraction is not None,
        "allowed": 1.0,
    }


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
    hh.Scenario(start=hh.Start(height=0.5, angle=0.3, vx=1.0, vy=0.2, omega=2.0)),
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
    wrapped = {path: np.array([value, value]) for path, value in values.items()}
    try:
        cells = make_cells(base, {path: wrapped[path] for path in ordered(wrapped)}, 2)
        scenario = maps.scenario_at(base, values)
    except ValueError:
        # what is wrong with one value alone is found when the axes are made
        assume(all(_fits(base, {path: value}) for path, value in values.items()))
        assert (cells[Cell.ALLOWED] == 0.0).all()
        return
    assert dict(zip(CELL, cells[:, 0], strict=True)) == cell_of(scenario)
    np.testing.assert_array_equal(cells[:, 1], cells[:, 0])


def _fits(base, values):
    try:
        maps.scenario_at(base, values)
    except ValueError:
        return False
    return True


# Motions


def small_map(span, duration=2.0, **options):
    base = hh.Scenario(duration=duration).replace("plane.mu_kinetic", 0.6)
    axes = {"plane.mu_static": FRICTIONS[FRICTIONS > 0.6], "start.speed": SPEEDS}
    return base, maps.sweep(base, axes, list(maps.QUANTITIES), span, **options)


def scenarios_of(base, dataset, step=1):
    for i, mu in enumerate(dataset["plane.mu_static"].values):
        for j, speed in enumerate(dataset["start.speed"].values):
            if (i * dataset["start.speed"].size + j) % step == 0:
                yield (
                    dataset.isel({"plane.mu_static": i, "start.speed": j}),
                    maps.scenario_at(base, {"plane.mu_static": mu, "start.speed": speed}),
                )


def test_a_map_over_the_duration_holds_what_simulate_gives():
    base, dataset = small_map("duration")
    words = {name: maps.words_of(dataset[name]) for name in ("sequence", "status", "first_event", "hop", "painleve")}
    hops = 0
    for cell, scenario in scenarios_of(base, dataset, step=2):
        motion = hh.simulate(scenario)
        told = {name: table[int(cell[name])] for name, table in words.items()}
        assert told["sequence"] == motion.sequence, scenario.to_query()
        assert told["status"] == motion.status
        kinds = [event.kind for event in motion.events]
        assert told["first_event"] == [kind for kind in kinds if kind != "apex"][1]
        assert (told["hop"] == "yes") == ("H" in motion.sequence)
        assert (told["painleve"] == "yes") == any(kind.startswith("painleve") or kind == "jam" for kind in kinds)
        last = motion.events[-1]
        np.testing.assert_allclose(cell["time"], motion.duration, rtol=1e-15)
        assert float(cell["end_angle"]) == last.angle
        np.testing.assert_allclose(cell["end_speed"], last.vx, rtol=1e-15)
        np.testing.assert_allclose(cell["distance"], last.x, rtol=1e-15)
        lost = motion.ledger.friction + motion.ledger.impact_normal + motion.ledger.impact_tangential
        np.testing.assert_allclose(cell["energy_lost"], lost, rtol=1e-13, atol=1e-13)
        takeoffs = [event for event in motion.events if event.to_mode == "H" and event.kind != "apex"]
        landings = [event for event in motion.find("impact") if event.collision]
        if takeoffs and landings:
            hops += 1
            takeoff, landing = takeoffs[0], landings[0]
            np.testing.assert_allclose(cell["takeoff_time"], takeoff.t, rtol=1e-15)
            assert float(cell["takeoff_angle"]) == takeoff.angle
            apexes = [event.height for event in motion.find("apex") if event.t < landing.t]
            np.testing.assert_allclose(cell["hop_height"], apexes[0], rtol=1e-9, atol=1e-12)
            np.testing.assert_allclose(cell["flight_time"], landing.t - takeoff.t, rtol=1e-9, atol=1e-12)
            np.testing.assert_allclose(cell["flight_distance"], landing.x - takeoff.x, rtol=1e-9, atol=1e-12)
            np.testing.assert_allclose(cell["landing_angle"], landing.angle, rtol=1e-9)
            before = motion.events[motion.events.index(landing) - 1]
            loss = landing.impact_normal + landing.impact_tangential
            loss -= before.impact_normal + before.impact_tangential
            np.testing.assert_allclose(cell["landing_loss"], loss, rtol=1e-8, atol=1e-12)
    assert hops > 20


def test_what_is_rolled_and_used_of_the_friction_against_samples_of_the_motion():
    base, dataset = small_map("duration", duration=1.5)
    checked = set()
    for cell, scenario in scenarios_of(base, dataset, step=5):
        motion = hh.simulate(scenario)
        sample = motion.at(motion.times(20001))
        roll = sample.mode == "R"
        rolled = np.abs(np.diff(sample.x))[roll[1:] & roll[:-1]].sum()
        step = np.abs(np.diff(sample.x)).max()
        assert abs(float(cell["distance_rolled"]) - rolled) <= step * len(motion.events)
        used = np.nanmax(sample.utilization(scenario.plane))
        assert float(cell["greatest_utilization"]) >= used - 1e-12
        # the sampling misses the very end of a rolling phase
        np.testing.assert_allclose(cell["greatest_utilization"], used, atol=0.02)
        if motion.sequence[-1] == "R":
            begun = [event for event in motion.events if event.to_mode == "R" and event.from_mode != "R"][-1]
            expected = abs(begun.angle) / (2 * math.pi)
            np.testing.assert_allclose(cell["revolutions_to_rolling"], expected, rtol=1e-15)
            checked.add("rolling")
        else:
            assert np.isnan(cell["revolutions_to_rolling"])
            checked.add("other")
    assert checked == {"rolling", "other"}


def test_infinite_friction_is_never_used_up():
    speeds = np.linspace(2.0, 5.0, 300)  # many end where N = 0, the quasi-jump
    found = maps.points(None, {"plane.mu": np.inf, "start.speed": speeds}, ["greatest_utilization", "sequence"])
    assert set(found["sequence"]) == {"R", "H"}
    used = found["greatest_utilization"]
    np.testing.assert_array_equal(used, np.where(found["sequence"] == "H", np.nan, 0.0))


@pytest.mark.parametrize("span", ["first_revolution", "takeoff", "reversal", "revolutions:1"])
def test_a_span_ends_where_it_says(span):
    base, dataset = small_map(span, duration=30.0)
    endings, sequences = (maps.words_of(dataset[name]) for name in ("ending", "sequence"))
    seen = set()
    for cell, scenario in scenarios_of(base, dataset, step=7):
        motion = hh.simulate(scenario)
        ending = endings[int(cell["ending"])]
        sequence = sequences[int(cell["sequence"])]
        seen.add(ending)
        takeoffs = [e.t for e in motion.events if e.to_mode == "H" and e.kind not in ("apex", "turn")]
        turns = [event.t for event in motion.find("turn")]
        ends = {"duration": motion.duration}
        if motion.status in ("jammed", "undetermined"):
            ends["jam"] = motion.duration
        if span in ("first_revolution", "takeoff") and takeoffs:
            ends["takeoff"] = takeoffs[0]
        if span in ("first_revolution", "reversal") and turns:
            ends["reversal"] = turns[0]
        expected = min(ends.values())
        if ending == "revolutions":
            time = float(cell["time"])
            assert time <= expected
            assert abs(abs(motion.at(time).angle) - 2 * math.pi) < 1e-9
            # slow starts take longer than the motion that is compared with
        else:
            assert ending == min(ends, key=ends.get) or motion.status == "undetermined"
            np.testing.assert_allclose(cell["time"], expected, rtol=1e-12)
        assert motion.sequence.startswith(sequence)
        assert (sequence[-1] == "H") == (ending == "takeoff") or span in ("reversal", "revolutions:1")
    expected = {
        "first_revolution": {"revolutions", "takeoff"},
        "takeoff": {"takeoff", "duration"},
        "reversal": {"reversal", "duration"},
        "revolutions:1": {"revolutions"},
    }[span]
    assert expected <= seen


def test_the_article_over_the_first_revolution():
    found = maps.points(
        None,
        {"start.speed": [0.1, 2.0, 2.8, 3.1], "plane.mu": 1.0},
        ["sequence", "ending", "takeoff_angle", "hop_height"],
    )
    assert found["sequence"].tolist() == ["R", "R", "RKRSR", "RKRSH"]
    assert found["ending"].tolist() == ["revolutions", "revolutions", "revolutions", "takeoff"]
    assert np.isnan(found["hop_height"][:3]).all()
    motion = hh.simulate(hh.Scenario(duration=2.0))
    assert found["takeoff_angle"][3] == motion.find("takeoff")[0].angle
    assert found["hop_height"][3] == pytest.approx(motion.find("apex")[0].height, rel=1e-14)


def test_a_start_that_hops_at_once():
    found = maps.points(None, {"start.speed": [4.5]}, ["sequence", "time", "hop", "first_event", "landing_angle"])
    assert found["sequence"][0] == "H"
    assert found["time"][0] == 0.0
    assert found["first_event"][0] == "takeoff"
    landing = hh.simulate(hh.Scenario(start=hh.Start.rolling(4.5))).find("impact")[0]
    assert found["landing_angle"][0] == pytest.approx(landing.angle, rel=1e-14)


def test_cells_whose_values_do_not_go_together_are_marked():
    axes = {"plane.mu_static": [0.2, 0.8], "plane.mu_kinetic": [0.1, 0.5, 0.9]}
    dataset = maps.sweep(None, axes, ["status", "sequence", "time"])
    outside = np.array([[False, True, True], [False, False, True]])
    np.testing.assert_array_equal(dataset["status"].values == -1, outside)
    np.testing.assert_array_equal(dataset["sequence"].values == -1, outside)
    np.testing.assert_array_equal(np.isnan(dataset["time"].values), outside)
    assert dataset["status"].attrs["flag_meanings"].split()[0] == "not_allowed"


def test_a_full_buffer_is_taken_up_with_a_larger_one():
    base = hh.Scenario(duration=60.0).replace("plane.restitution", 0.9)
    base = base.replace("start", hh.Start(height=1.0, omega=3.0))
    found = maps.points(base, {"contact.max_events": [20, 3000]}, ["status", "sequence", "time"], "duration")
    short, whole = (base.replace("contact.max_events", most) for most in (20, 3000))
    assert found["status"].tolist() == [hh.simulate(short).status, hh.simulate(whole).status]
    motion = hh.simulate(whole)
    assert len(motion.events) > kernel.FIRST_EVENTS
    assert found["sequence"][1].rstrip("+") == motion.sequence[:LONGEST]


def test_long_sequences_are_cut_and_say_so():
    keys = np.zeros((1, kernel.INTEGERS), np.uint64)
    length = 0
    for i in range(LONGEST + 5):
        length = add_letter(keys, 0, length, i % 5)
    expected = ("RSKHM" * 30)[:LONGEST] + "+"
    assert unpacked_sequence(keys[0]) == expected


# One thread and many


def test_equal_bits_for_one_thread_and_many():
    rng = np.random.default_rng(4)
    values = {"plane.mu": rng.uniform(0, 2, 3000), "start.speed": rng.uniform(0, 5, 3000)}
    cells = make_cells(hh.Scenario(), values, 3000)
    span = make_span("first_revolution")
    wanted = kernel.FLIGHT_REQUESTED | kernel.UTILIZATION_REQUESTED
    alone = run_cells(cells, span, wanted)
    with ThreadPoolExecutor(4) as pool:
        many = run_cells(cells, span, wanted, pool)
    for a, b in zip(alone, many, strict=True):
        assert a.tobytes() == b.tobytes()


# Axes


def test_mirrored_motions_are_alike():
    speeds = np.linspace(0.3, 4.9, 60)
    ahead = maps.points(None, {"start.speed": speeds}, ["sequence", "hop_height", "energy_lost"])
    back = maps.points(None, {"start.speed": -speeds}, ["sequence", "hop_height", "energy_lost"])
    swap = str.maketrans("SK", "KS")
    assert [text.translate(swap) for text in back["sequence"]] == ahead["sequence"].tolist()
    np.testing.assert_allclose(back["hop_height"], ahead["hop_height"], rtol=1e-10)
    np.testing.assert_allclose(back["energy_lost"], ahead["energy_lost"], rtol=1e-10, atol=1e-14)


@given(
    st.lists(st.integers(1, 700), min_size=2, max_size=4).filter(lambda shape: math.prod(shape) < 3e6),
    st.integers(1, 100_000),
)
def test_chunks_cover_the_grid_once(shape, cells):
    chunk = chunk_shape(shape, cells)
    assert math.prod(chunk) <= max(cells, 1)
    names = ("plane.mu", "start.speed", "plane.slope", "hoop.load_fraction")
    axes = tuple(Axis(name, np.zeros(size), "", "") for name, size in zip(names, shape, strict=False))
    plan = Plan(hh.Scenario(), axes, (), make_span("duration"), chunk)
    assume(math.prod(plan.chunks) < 3000)
    seen = np.zeros(shape, np.int8)
    for index in np.ndindex(*plan.chunks):
        seen[plan.region(index)] += 1
    assert (seen == 1).all()


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
        ({"plane.mu": [1.0, 2.0]}, "at least two"),
        ({"plane.mu": [1.0], "start.speeed": [1.0]}, "start.speeed"),
        ({"plane.mu": [1.0, -0.5], "start.speed": [1.0]}, "plane.mu = -0.5 must be at least 0"),
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


def test_rolling_resistance_is_an_axis():
    given, speeds = [0.01, 0.3], [1.0, 3.1]
    base = hh.Scenario(duration=2.0)
    found = maps.sweep(
        base,
        {"plane.rolling_resistance": given, "start.speed": speeds},
        ["sequence", "energy_lost", "greatest_utilization", "status"],
        span="duration",
    )
    for i, f in enumerate(given):
        for k, speed in enumerate(speeds):
            motion = hh.simulate(base.with_values({"plane.rolling_resistance": f, "start.speed": speed}))
            ledger, cell = motion.ledger, found.isel({"plane.rolling_resistance": i, "start.speed": k})
            lost = ledger.friction + ledger.impact_normal + ledger.impact_tangential + ledger.rolling_resistance
            assert float(cell.energy_lost) == pytest.approx(lost, rel=1e-13, abs=1e-13)
            used = motion.at(motion.times(2001)).utilization(motion.scenario.plane)
            assert float(cell.greatest_utilization) == pytest.approx(np.nanmax(used), rel=1e-5)
            assert float(cell.greatest_utilization) >= np.nanmax(used) - 1e-10


@pytest.mark.parametrize(("angle", "speed"), [(0.0, 1.0), (1.0, 0.0)])
def test_a_massless_hoop_needs_the_tangent_of_half_the_angle(angle, speed):
    """Where its force vanishes, too: the rim skims from there, and rests with the load on the plane."""
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(1.0), start=hh.Start.rolling(speed, angle=angle), duration=3.0)
    friction = np.array([1.0, 2.0])
    motions = [hh.simulate(scenario.with_values({"plane.mu": mu})) for mu in friction]
    assert [motion.sequence for motion in motions] == ["RMR", "RMR"]
    needs = np.tan([0.5 * motion.events[1].angle for motion in motions])
    found = maps.points(scenario, {"plane.mu": friction}, ["greatest_utilization"], span="duration")
    assert found["greatest_utilization"] == pytest.approx(needs / friction, rel=1e-9)


def test_a_logarithmic_axis_has_equal_ratios_and_exact_decades():
    assert logarithmic(0.001, 1000.0, 7).tolist() == [0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0]
    values = logarithmic(0.1, 5.0, 50)
    np.testing.assert_allclose(values, np.geomspace(0.1, 5.0, 50), rtol=4e-15)
    np.testing.assert_allclose(values[1:] / values[:-1], 50.0 ** (1 / 49), rtol=4e-15)
