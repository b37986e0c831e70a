"""Words, colours and the share of friction used: one meaning each, in every room that shows them."""

import json
import typing
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

import hophoop as hh
from hophoop import plots, theory
from hophoop.derivatives.parameters import directions_of
from hophoop.kernel.physics import body
from hophoop.kernel.records.cells import CELL, Cell
from hophoop.lab.site.presets import presets
from hophoop.maps.grid.cells import make_cells
from hophoop.plots.curves import curve, phases, shown_words
from hophoop.precise.problem import Problem
from hophoop.results.poses import poses_of
from hophoop.scenario import cell_of, paths
from hophoop.vocabulary import colors, names, parameters

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def rocking():
    """The article's hoop on μ = 0.3, which turns back and rolls the other way."""
    return hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=0.3), hh.Start.rolling(0.1), duration=9.0)


@pytest.fixture(scope="module")
def hop():
    return hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0), hh.Start.rolling(3.1), duration=2.0)


# Words follow the rotation


def test_each_word_is_that_of_slip_and_rotation(rocking):
    """From the definition: 'spins' where v_t θ̇ < 0, 'skids' where v_t θ̇ > 0, in samples, figures and films alike."""
    sample = curve(rocking)
    many = names.mode_words(sample.mode, sample.omega)
    assert list(many) == [names.mode_word(str(m), w) for m, w in zip(sample.mode, sample.omega, strict=True)]
    product = (sample.vx - sample.omega) * sample.omega  # R = 1 m
    clear = np.isin(sample.mode, ["S", "K"]) & (np.abs(sample.omega) > 1e-6) & (np.abs(product) > 1e-9)
    assert clear.sum() > 100
    for words in (many, shown_words(sample), poses_of(rocking, sample.t).words):
        np.testing.assert_array_equal(words[clear] == "spin", product[clear] < 0.0)
        assert {"roll", "spin", "skid"} <= set(words)
    state = rocking.at(7.5)  # it slides ahead backwards; the letter is the sign of v_t
    assert (state.vx, state.omega) == (pytest.approx(-1.283, abs=1e-3), pytest.approx(-0.791, abs=1e-3))
    assert state.mode == "S"
    assert next(piece.word for piece in phases(rocking) if piece.t < 7.5 < piece.end_t) == "skid"


def test_a_slip_in_which_the_hoop_turns_back_changes_its_word():
    start = hh.Start(vx=4.0, omega=-0.8)  # thrown ahead with backspin
    motion = hh.simulate(hh.Hoop.ideal(0.3), hh.Plane(mu=0.3), start, duration=4.0)
    pieces = phases(motion)
    turns = [event for event in motion.find("turn") if event.to_mode in ("S", "K")]
    assert turns
    for turn in turns:
        before = next(piece for piece in pieces if piece.end_t == turn.t)
        after = next(piece for piece in pieces if piece.t == turn.t)
        assert before.mode == after.mode
        assert {before.word, after.word} == {"spin", "skid"}


def test_a_direction_is_that_of_the_coming_rotation():
    np.testing.assert_array_equal(names.coming_rotation([0.0, 2.0, 0.0, -1.0, 0.0]), [1, 1, -1, -1, -1])
    np.testing.assert_array_equal(names.coming_rotation([0.0, 0.0]), [0, 0])


def test_the_plane_of_angle_and_rate_is_its_own_mirror_image():
    scenario = hh.Scenario(plane=hh.Plane(mu=0.3))
    angles, rates = np.linspace(-3.0, 3.0, 60), np.linspace(-8.0, 8.0, 40)[:, None]
    words = names.mode_words(theory.mode_of(angles, rates, scenario.hoop, scenario.plane), rates)
    np.testing.assert_array_equal(words, words[::-1, ::-1])
    letters = theory.mode_of(1.0, np.array([2.0, -2.0]), scenario.hoop, scenario.plane)
    assert set(names.mode_words(letters, [2.0, -2.0])) <= set(names.MODE_WORDS)


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
    from hophoop.kernel.physics.body import EVENT_NAMES, MODE_LETTERS, STATUS_NAMES, Mode

    assert tuple(names.MODES) == tuple(Mode)
    assert set(names.MODE_WORDS) == set(names.WORDS)
    assert len(MODE_LETTERS) == len(Mode)
    assert tuple(names.EVENTS) == EVENT_NAMES
    assert tuple(names.STATUSES) == STATUS_NAMES


def letters_of(motion):
    """The sequence from its definition: a phase lasts from an event at which the mode may change to the next."""
    begins = [event for event in motion.events[:-1] if event.kind not in ("turn", "apex", "kane_gain", "rest")]
    ends = [*begins[1:], motion.events[-1]]
    return "".join(a.to_mode for a, b in zip(begins, ends, strict=True) if b.t > a.t)


@pytest.mark.parametrize("passing", ["turn", "apex", "kane_gain", "rest"])
def test_events_that_end_no_phase_are_not_in_the_sequence(passing):
    motion = {
        "turn": lambda: hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=0.3), hh.Start.rolling(0.1), duration=9.0),
        "apex": lambda: hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0), hh.Start.rolling(3.1), duration=2.0),
        "kane_gain": lambda: hh.simulate(next(preset.scenario for preset in presets() if preset.key == "kane")),
        "rest": lambda: hh.simulate(hh.Hoop.ideal(0.5), hh.Plane(mu=1.0), hh.Start(angle=0.0), duration=1.0),
    }[passing]()
    assert motion.find(passing)
    assert motion.sequence == letters_of(motion)
    kinds, modes, times = (motion.tables["events"][name].tolist() for name in ("kind", "after_mode", "t"))
    assert names.sequence_of(kinds, modes, times) == motion.sequence


def test_a_sequence_in_another_arithmetic_and_at_its_edges():
    start, end, roll, flight = 0, 15, 0, 3
    times = [Decimal("1e-400"), Decimal("2e-400")]
    assert names.sequence_of([start, end], [roll, roll], times) == "R"
    assert names.sequence_of([start, end], [flight, roll], [1.0, 1.0]) == "R"  # nothing lasts: the last mode
    assert names.sequence_of([start, end], [roll, flight], [0.0, 1.0], takes_off=True) == "RH"
    assert names.sequence_of([], [], []) == ""


def test_every_law_of_impact_has_its_row():
    from hophoop.kernel.physics.body import ImpactLaw

    assert {law.name.lower(): law for law in ImpactLaw} == names.LAW_CODES
    assert tuple(names.LAW_CODES) == typing.get_args(hh.Plane.model_fields["impact_law"].annotation)
    described = (ROOT / "docs" / "references.bib").read_text(encoding="utf-8")
    for law in names.LAWS.values():
        assert law.reference is None or f"{{{law.reference[0]}," in described


@pytest.mark.parametrize("law", names.LAW_CODES)
def test_a_law_is_the_same_wherever_it_is_named(law):
    scenario = hh.Scenario(plane=hh.Plane(impact_law=law))
    assert scenario.to_body().law == Problem.of(scenario).law == names.LAW_CODES[law]
    cells = make_cells(hh.Scenario(), {"plane.impact_law": np.array([law])}, 1)
    assert cells[Cell.LAW, 0] == names.LAW_CODES[law]
    layout = json.loads((ROOT / "src/hophoop/lab/wasm/layout.json").read_text(encoding="utf-8"))
    assert layout["impact_laws"].index(law) == names.LAW_CODES[law]


def test_only_motions_that_reach_their_end_are_ok():
    assert [status for status, facts in names.STATUSES.items() if facts.ok] == ["completed", "at_rest"]
    jammed = hh.simulate(next(preset.scenario for preset in presets() if preset.key == "jam"))
    assert (jammed.status, jammed.ok) == ("jammed", False)
    assert hh.simulate(hh.Scenario(duration=0.1)).ok


# The share of friction in use


def test_one_utilization_everywhere(hop):
    slippery = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu_static=1.0, mu_kinetic=0.6), hh.Start.rolling(3.1), duration=2.0)
    for motion in (hop, slippery):
        plane = motion.scenario.plane
        sample = curve(motion)
        slip = np.isin(sample.mode, ["S", "K"])
        used = sample.utilization(plane)
        # Coulomb's law, from the forces themselves
        pressed = sample.normal_force > 1e-6
        mu = np.where(slip, plane.mu_kinetic, plane.mu_static)
        np.testing.assert_allclose(
            used[pressed], np.abs(sample.friction_force[pressed]) / (mu * sample.normal_force)[pressed], rtol=1e-12
        )
        np.testing.assert_allclose(used[slip], 1.0, rtol=1e-9)
        assert np.isnan(used[sample.mode == "H"]).all()
        ax = Figure().subplots()
        plots.friction_utilization(motion, "time", ax=ax)
        drawn = max(ax.get_lines(), key=lambda one: len(one.get_xdata())).get_ydata()
        np.testing.assert_array_equal(np.abs(drawn), used)
        assert np.nanmin(drawn) < -0.99


def test_no_friction_cannot_be_used():
    motion = hh.simulate(hh.Hoop.ideal(0.5), hh.Plane(mu=0.0), hh.Start.rolling(1.0), duration=1.0)
    assert np.isnan(motion.at(0.5).utilization(motion.scenario.plane))
    found = hh.maps.points(None, {"plane.mu": [0.0, 0.5], "start.speed": [3.0, 3.0]}, ["greatest_utilization"])
    assert np.isnan(found["greatest_utilization"][0])
    assert found["greatest_utilization"][1] == 1.0


def test_slip_uses_all_of_the_kinetic_friction_in_a_map_too():
    values = {"plane.mu_static": [0.8], "plane.mu_kinetic": [0.4], "start.vx": [3.0], "start.omega": [0.5]}
    found = hh.maps.points(None, values, ["greatest_utilization"])
    assert found["greatest_utilization"][0] == 1.0  # μk/μs before


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
    scenarios = pytest.importorskip("hophoop.prove.checker.scenarios", reason="the extra 'prove' is not installed")
    start = hh.Start(x=1.0, height=0.2, angle=0.5, vx=1.5, vy=-0.5, omega=2.5)
    hoop = hh.Hoop(eccentricity=0.4, inertia_ratio=0.8)
    scenario = hh.Scenario(hoop=hoop, plane=hh.Plane(mu_static=0.5, mu_kinetic=0.4), start=start)
    section, _, name = row.path.rpartition(".")
    value = getattr(getattr(scenario, section) if section else scenario, name)
    changed = 9 if name == "max_events" else 0.9 * value + 0.01
    other = scenario.replace(row.path, changed)
    assert cell_of(other) != cell_of(scenario)
    np.testing.assert_array_equal(make_cells(scenario, {row.path: np.array([changed])}, 1)[:, 0], cell_of(other))
    assert Problem.of(other) != Problem.of(scenario)
    assert scenarios.NUMBERS[row.path] == (row.range.least, row.range.most, *row.range.also)
    if row.derivative:
        found = directions_of(scenario, [row.path])
        assert found.parameter_tangents.any() or found.start.any() or found.units.any()


def test_choices_are_the_words_of_the_models():
    models = {"plane": (hh.Plane,), "contact": (hh.Rigid, hh.Compliant)}
    for row in parameters.TABLE:
        if row.choices:
            section, _, name = row.path.partition(".")
            annotations = [model.model_fields[name].annotation for model in models[section] if name in model.model_fields]
            words_of_it = {word for annotation in annotations for word in typing.get_args(annotation)}
            assert {value for value, _ in row.choices} == words_of_it
            assert row.default in words_of_it


@pytest.mark.parametrize("row", [row for row in parameters.TABLE if row.slider], ids=lambda row: row.path)
def test_sliders_and_axes_stay_in_the_range(row):
    unit = np.pi / 180.0 if row.degrees else 1.0
    ends = [row.slider.low * unit, row.slider.high * unit, *(row.axis[:2] if row.axis else ())]
    assert all(row.range.holds(end) for end in ends)


def test_a_cell_has_the_numbers_of_its_scenario():
    plane = hh.Plane(gravity=1.6, slope=0.1, mu_static=0.5, mu_kinetic=0.4, restitution=0.3, rolling_resistance=0.02)
    hoop = hh.Hoop(radius=0.3, mass=2.0, eccentricity=0.4, inertia_ratio=0.8)
    start = hh.Start(x=1.0, height=0.2, angle=0.5, vx=1.5, vy=-0.5, omega=2.5)
    scenario = hh.Scenario(hoop=hoop, plane=plane, start=start, duration=7.0, contact=hh.Rigid(max_events=9))
    cell = dict(zip(CELL, cell_of(scenario), strict=True))
    for row in parameters.TABLE:
        if row.column:
            section, _, name = row.path.rpartition(".")
            assert cell[row.column] == getattr(getattr(scenario, section) if section else scenario, name), row.path


@pytest.mark.parametrize("codes", [body.Mode, body.Event, body.Status])
def test_the_kernels_integers_are_their_enums(codes):
    for member in codes:
        name = "SKIM_START" if member is body.Event.SKIM else member.name
        assert getattr(body, name) == member
