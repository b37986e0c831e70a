"""Words, colours and the share of friction used: one meaning each, in every room that shows them."""

import json
import typing
from decimal import Decimal

import numpy as np
import pytest
from matplotlib.figure import Figure

import hophoop as hh
from animate_tools import motion
from checkout import text_of
from hophoop import plots
from hophoop.derivatives.parameters import directions_of
from hophoop.kernel.physics import body
from hophoop.kernel.records.cells import CELL, Cell
from hophoop.lab.presets import presets
from hophoop.maps.grid.cells import make_cells
from hophoop.plots.curves import curve, phases, shown_words
from hophoop.precise.problem import Problem
from hophoop.results.poses import poses_of
from hophoop.scenario import cell_of, paths
from hophoop.vocabulary import colors, names, parameters

# Words follow the rotation


def test_each_word_is_that_of_slip_and_rotation():
    """From the definition: 'spins' where v_t θ̇ < 0, 'skids' where v_t θ̇ > 0, in samples, figures and films alike."""
    rocking = motion(0.1, 0.3, 9.0)  # it turns back and rolls the other way
    sample = curve(rocking)
    many = names.mode_words(sample.mode, sample.omega)
    assert list(many) == [names.mode_word(str(m), w) for m, w in zip(sample.mode, sample.omega, strict=True)]
    product = (sample.vx - sample.omega) * sample.omega  # R = 1 m
    clear = np.isin(sample.mode, ["S", "K"]) & (np.abs(sample.omega) > 1e-6) & (np.abs(product) > 1e-9)
    for words in (many, shown_words(sample), poses_of(rocking, sample.t).words):
        np.testing.assert_array_equal(words[clear] == "spin", product[clear] < 0.0)
        assert {"roll", "spin", "skid"} <= set(words)
    # it slides ahead backwards; the letter is the sign of v_t
    assert (rocking.at(7.5).mode, words[np.searchsorted(sample.t, 7.5)]) == ("S", "skid")


def test_a_slip_in_which_the_hoop_turns_back_changes_its_word():
    thrown = hh.simulate(hh.Scenario.from_query("duration=4&hoop.load_fraction=0.3&plane.mu=0.3&start.vx=4&start.omega=-0.8"))
    turn = next(event for event in thrown.find("turn") if event.to_mode in ("S", "K"))
    before, after = (piece for piece in phases(thrown) if turn.t in (piece.t, piece.end_t))
    assert before.mode == after.mode
    assert {before.word, after.word} == {"spin", "skid"}


def test_a_direction_is_that_of_the_coming_rotation():
    np.testing.assert_array_equal(names.coming_rotation([0.0, 2.0, 0.0, -1.0, 0.0]), [1, 1, -1, -1, -1])
    np.testing.assert_array_equal(names.coming_rotation([0.0, 0.0]), [0, 0])


def test_an_unknown_letter_is_refused():
    with pytest.raises(ValueError, match=r"letter = 'X' must be one of R, S, K, H, M\."):
        names.mode_word("X", 1.0)
    with pytest.raises(ValueError, match="word = 'S' must be one of roll, spin"):
        colors.mode_color("S")


def test_a_phase_has_one_word_in_motions_and_maps():
    for letter in "RSKHM":
        assert names.LETTERS[letter] == names.mode_word(letter, 1.0)
    assert names.class_text("RSH") == "roll → spin → flight"


def test_every_kind_of_mode_event_and_status_has_its_words():
    assert tuple(names.MODES) == tuple(body.Mode)
    assert set(names.MODE_WORDS) == set(names.WORDS)
    assert len(body.MODE_LETTERS) == len(body.Mode)
    assert tuple(names.EVENTS) == body.EVENT_NAMES
    assert tuple(names.STATUSES) == body.STATUS_NAMES


def test_a_sequence_in_another_arithmetic_and_at_its_edges():
    start, end, roll, flight = 0, 15, 0, 3
    assert names.sequence_of([start, end], [roll, roll], [Decimal("1e-400"), Decimal("2e-400")]) == "R"
    assert names.sequence_of([start, end], [flight, roll], [1.0, 1.0]) == "R"  # nothing lasts: the last mode
    assert names.sequence_of([start, end], [roll, flight], [0.0, 1.0], takes_off=True) == "RH"
    assert names.sequence_of([], [], []) == ""


def test_every_law_of_impact_has_its_row():
    layout = json.loads(text_of("src/hophoop/lab/wasm/layout.json"))
    assert {law.name.lower(): law for law in body.ImpactLaw} == names.LAW_CODES
    assert tuple(names.LAW_CODES) == typing.get_args(hh.Plane.model_fields["impact_law"].annotation)
    for member in names.LAWS:
        law, code = member.name.lower(), int(member)
        scenario = hh.Scenario(plane=hh.Plane(impact_law=law))
        cells = make_cells(hh.Scenario(), {"plane.impact_law": np.array([law])}, 1)
        assert scenario.to_body().law == Problem.of(scenario).law == cells[Cell.LAW, 0] == code
        assert layout["impact_laws"].index(law) == code


def test_only_motions_that_reach_their_end_are_ok():
    assert [status for status, facts in names.STATUSES.items() if facts.ok] == ["completed", "at_rest"]
    jammed = hh.simulate(next(preset.scenario for preset in presets() if preset.key == "jam"))
    assert (jammed.status, jammed.ok) == ("jammed", False)


# The share of friction in use


def test_one_utilization_everywhere():
    plane = hh.Plane(mu_static=1.0, mu_kinetic=0.6)
    hop = hh.simulate(hh.Scenario(plane=plane, duration=2.0))
    sample = curve(hop)
    slip = np.isin(sample.mode, ["S", "K"])
    used = sample.utilization(plane)
    # Coulomb's law, from the forces themselves
    pressed = sample.normal_force > 1e-6
    limit = np.where(slip, plane.mu_kinetic, plane.mu_static) * sample.normal_force
    np.testing.assert_allclose(used[pressed], np.abs(sample.friction_force[pressed]) / limit[pressed], rtol=1e-12)
    np.testing.assert_allclose(used[slip], 1.0, rtol=1e-9)
    assert np.isnan(used[sample.mode == "H"]).all()
    ax = Figure().subplots()
    plots.friction_utilization(hop, "time", ax=ax)
    drawn = max(ax.get_lines(), key=lambda one: len(one.get_xdata())).get_ydata()
    np.testing.assert_array_equal(np.abs(drawn), used)
    assert [np.nanmin(drawn), np.nanmax(drawn)] == pytest.approx([-1.0, 1.0], abs=1e-12)


def test_no_friction_cannot_be_used_and_slip_uses_all_of_the_kinetic_friction():
    values = {"plane.mu_static": [0.0, 0.8], "plane.mu_kinetic": [0.0, 0.4], "start.vx": [3.0, 3.0], "start.omega": [0.5, 0.5]}
    found = hh.maps.points(None, values, ["greatest_utilization"])
    np.testing.assert_array_equal(found["greatest_utilization"], [np.nan, 1.0])


# Parameters


def test_every_parameter_of_a_scenario_is_a_row():
    fields = {path for path in paths() if path != "hoop.parts"}
    assert set(parameters.PARAMETERS) == fields
    assert {row.column for row in parameters.TABLE if row.column} <= set(CELL)
    for row in parameters.TABLE:
        assert (row.unit == parameters.WORD) == (row.range is None), row.path


@pytest.mark.parametrize("row", [row for row in parameters.TABLE if row.column], ids=lambda row: row.path)
def test_every_number_of_a_cell_reaches_the_other_engines(row):
    """A number that one of them ignores would silently be its default there."""
    start = hh.Start(x=1.0, height=0.2, angle=0.5, vx=1.5, vy=-0.5, omega=2.5)
    hoop = hh.Hoop(eccentricity=0.4, inertia_ratio=0.8)
    scenario = hh.Scenario(hoop=hoop, plane=hh.Plane(mu_static=0.5, mu_kinetic=0.4), start=start)
    section, _, name = row.path.rpartition(".")
    value = getattr(getattr(scenario, section) if section else scenario, name)
    changed = 9 if name == "max_events" else 0.9 * value + 0.01
    other = scenario.replace(row.path, changed)
    assert cell_of(other)[CELL.index(row.column)] == changed != value
    np.testing.assert_array_equal(make_cells(scenario, {row.path: np.array([changed])}, 1)[:, 0], cell_of(other))
    assert Problem.of(other) != Problem.of(scenario)
    if row.derivative:
        found = directions_of(scenario, [row.path])
        assert found.parameter_tangents.any() or found.start.any() or found.units.any()


def test_choices_are_the_words_of_the_models():
    models = {"plane": (hh.Plane,), "contact": (hh.Rigid, hh.Compliant)}
    for row in parameters.TABLE:
        section, _, name = row.path.partition(".")
        if row.choices:
            fields = [model.model_fields[name] for model in models[section] if name in model.model_fields]
            words = {word for field in fields for word in typing.get_args(field.annotation)}
            assert {value for value, _ in row.choices} == words
            assert row.default in words


def test_sliders_and_axes_stay_in_the_range():
    for row in parameters.TABLE:
        unit = np.pi / 180.0 if row.degrees else 1.0
        sliders = [row.slider.low * unit, row.slider.high * unit] if row.slider else []
        assert all(row.range.holds(end) for end in (*sliders, *(row.axis or ())[:2])), row.path


@pytest.mark.parametrize("codes", [body.Mode, body.Event, body.Status])
def test_the_kernels_integers_are_their_enums(codes):
    for member in codes:
        name = "SKIM_START" if member is body.Event.SKIM else member.name
        assert getattr(body, name) == member
