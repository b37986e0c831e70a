"""What a motion is read as: units, words, samples and the table of events."""

import dataclasses
import math
import pickle
import re

import pytest

import hophoop as hh
from cli_tools import run
from hophoop._support import tables
from hophoop.derivatives.units import DIRECT
from hophoop.kernel.records.cells import scales_from
from hophoop.results import event_table
from hophoop.results.records import EventErrors, EventRecord, Ledger, Sample, Velocity
from hophoop.results.units import Units
from hophoop.vocabulary import quantities


def test_a_quantity_has_its_unit():
    units = Units(length=2.0, time=0.5, mass=3.0)
    sizes = {"height": 2.0, "vy": 4.0, "omega": 2.0, "angle": 1.0, "normal_force": 24.0, "impulse_normal": 12.0, "gain": 48.0}
    assert {name: units.of(name) for name in sizes} == sizes


@pytest.mark.parametrize("name", ["heigth", "", "mode", "energy", "before_vx", "residuals"])
def test_another_name_has_none(name):
    """It was an energy."""
    units = hh.simulate(hh.Scenario(duration=0.1)).units
    with pytest.raises(ValueError, match="^'" + name + "' has no unit: the quantities are t, x, height, angle, vx, "):
        units.of(name)


@pytest.mark.parametrize("result", [EventErrors, EventRecord, Ledger, Sample, Velocity])
def test_the_table_of_quantities_has_the_numbers_of_each_result(result):
    words = {"kind", "from_mode", "to_mode", "before", "collision", "stable", "digits_right"}
    names = {field.name for field in dataclasses.fields(result)} - (words if result is EventRecord else set())
    held = set(quantities.held_by(result.__name__))
    # a sum of two columns is computed where it is asked for
    assert held - {name for name in held if isinstance(getattr(result, name, None), property)} == names


def test_derivatives_have_the_units_of_the_table():
    scales = scales_from(2.0, 3.0, 5.0)
    sizes = quantities.sizes(scales)
    for column, _, exponents in DIRECT.values():
        size = math.prod(unit**power for unit, power in zip((2.0, 3.0, 5.0), exponents, strict=True))
        assert size == pytest.approx(sizes[column.removeprefix("before_")], rel=1e-15)


@pytest.fixture(scope="module")
def hop():
    return hh.simulate(hh.Scenario(duration=2.0))


# Kinds, letters and statuses


@pytest.fixture(scope="module", params=[None, 20], ids=["doubles", "digits"])
def motion(request):
    scenario = hh.Scenario(duration=2.0)
    return hh.simulate(scenario) if request.param is None else hh.simulate(scenario, digits=request.param)


def test_words_are_plain_strings(motion):
    (takeoff,) = motion.find("takeoff")
    words = [motion.status, takeoff.kind, takeoff.from_mode, takeoff.to_mode]
    assert words == ["completed", "takeoff", "S", "H"]
    assert {type(word) for word in words} == {str}
    assert repr(motion.find("takeoff")[0]).startswith("<takeoff at t = 1.0447130")
    assert ", S → H: x = 5.4155" in repr(motion.find("takeoff")[0])
    assert motion.events[0].from_mode is None


# Samples


def test_the_types_of_a_sample_are_those_of_its_fields(hop):
    one, many = hop.at(1.0), hop.at(hop.times(5))
    for field in dataclasses.fields(Sample):
        kind = str if field.name == "mode" else float
        assert type(getattr(one, field.name)) is kind, field.name
        assert issubclass(getattr(many, field.name).dtype.type, kind), field.name
    assert type(one.total) is type(one.friction_loss) is type(one.utilization(hop.scenario.plane)) is float


# The table of events


def words_in(line):
    """What a line has between gaps of two spaces and more."""
    return re.split(r"\s{2,}", line.strip())


def test_events_are_printed_as_the_command_line_does(hop):
    head, _, *rows = repr(hop.events).splitlines()
    told = run("run --duration 2").stdout.splitlines()
    first = next(number for number, line in enumerate(told) if "t (s)" in line)
    assert words_in(head) == words_in(told[first])
    assert [words_in(row) for row in rows] == [words_in(line) for line in told[first + 2 : first + 2 + len(hop.events)]]
    assert str(hop.events) == repr(hop.events)
    assert str(hop).startswith(repr(hop.events))
    assert str(hop).endswith("\n\nphases RKRSHR, completed after 2 s")
    assert repr(hop).count("\n") == 0


def test_events_are_a_tuple_still(hop):
    events = hop.events
    assert isinstance(events, tuple)
    assert events == tuple(events) == pickle.loads(pickle.dumps(events))
    assert "315.6372" in repr(hop.find("takeoff"))
    assert repr(hop.find("jam")) == "()"


def test_a_wide_table_leaves_columns_out():
    """The numbers of a hoop of 1000 km are long."""
    scenario = hh.Scenario.from_query("duration=6000&hoop.radius=1000000&start.speed=3100")
    motion = hh.simulate(scenario)
    lines = repr(motion.events).splitlines()
    assert max(map(tables.length, lines)) <= 100
    assert "slip (m/s)" not in lines[0]
    assert lines[-1] == "Not shown for want of width: slip (m/s)."
    assert "slip (m/s)" in event_table.text_table(motion.events, width=1000)


def test_a_long_table_has_its_first_and_last_rows():
    motion = hh.simulate(hh.Scenario(start=hh.Start.rolling(2.8), duration=60.0))
    count = len(motion.events)
    _, _, *rows, last = repr(motion.events).splitlines()
    assert last == f"… {count - 80} events are left out where the dots are."
    assert set(rows[60].split()) == {"…"}
    times = [float(row.split()[0]) for row in rows if "…" not in row]
    kept = [*motion.events[:60], *motion.events[-20:]]
    assert times == [float(f"{event.t:.6f}") for event in kept]


# What results print


PRINTED = {
    "ledger": lambda hop: hop.ledger,
    "sample": lambda hop: hop.at(1.9),
    "samples": lambda hop: hop.at(hop.times(500)),
    "no samples": lambda hop: hop.at([]),
    "errors": lambda hop: hop.errors,
    "phase": lambda hop: next(iter(hh.phases(hop.scenario))),
    "margins": lambda hop: next(iter(hh.phases(hop.scenario))).begin,
    "plan": lambda hop: hh.plan(hop.scenario, rate=10.0),
    "sensitivity": lambda hop: hop.sensitivity(["takeoff.angle", "hop.height"], ["start.speed", "plane.mu"]),
    "deviations": lambda hop: hop.uncertainty({"plane.mu": 0.01}).at(hop.times(50)),
    "proof": lambda hop: hh.prove.prove(hh.Scenario(duration=0.5)),
    "part of a proof": lambda hop: hh.prove.prove(hh.Scenario(duration=60.0, start=hh.Start.rolling(2.8)), seconds=1e-9),
    "agreement": lambda hop: hh.precise.compare(hop, hh.simulate(hop.scenario, digits=20)),
    "event": lambda hop: hop.events[1],
}


@pytest.mark.parametrize("name", PRINTED)
def test_a_result_prints_a_few_lines_and_is_a_table_in_notebooks(hop, name):
    result = PRINTED[name](hop)
    text = repr(result)
    assert text.startswith("<")
    assert len(text) < 1200
    assert len(text.splitlines()) <= 15
    assert max(map(len, text.splitlines())) <= 160
    assert not re.search(r"array|dtype|np\.|Decimal", text)
    if name in ("ledger", "sample", "samples", "plan", "sensitivity", "proof"):
        page = result._repr_html_()
        assert page.count("<table>") == page.count("</table>") == 1
        assert 2 <= page.count("<tr>") <= 25
        assert len({row.count("<td") for row in page.split("<tr>")[2:]}) == 1


def test_the_two_losses_to_friction_have_two_names(hop):
    text = repr(hop.ledger)
    assert re.search(r"friction +1\.3938 J +Energy lost in slip so far\n", text)
    assert re.search(
        r"friction_loss +3\.75269 J +Energy lost to friction, in slip and in the tangential part of impacts\n", text
    )


def test_the_table_of_a_motion_in_notebooks_has_the_height(hop):
    page = hop._repr_html_()
    titles = re.findall(r"<th[^>]*>([^<]*)</th>", page)
    assert titles == list(event_table.TITLES)
    apex = next(row for row in page.split("<tr>") if ">apex<" in row)
    assert "<td>0.2918</td>" in apex
