"""A wrong trajectory is scored wrong: each column has a file that was doctored for it."""

import math

import numpy as np
import pytest
from adapters.hophoop import sample_motion, scenario_of
from record import Record, read_record, record_text
from score import score_text
from scores import score
from table import limit_of
from task import SPACING, States
from truth import scored, truths

import hophoop as hh

HOP = truths()["hop"]


def exact(name, spacing=SPACING):
    return sample_motion(scenario_of(truths()[name].task), spacing)


def scores(name, states, **more):
    return score(Record(states, **more), truths()[name])[0]


def score_file(states, name):
    return score_text(record_text(Record(states)), f"{name}.csv").scores


@pytest.mark.parametrize("spacing", [SPACING, 1e-3])
@pytest.mark.parametrize("name", scored())
def test_the_exact_motion_scores_exact(name, spacing):
    found = scores(name, exact(name, spacing))
    assert found.sequence_right
    assert found.chatter == 0
    assert found.penetration == 0.0
    # what a record of this density resolves
    for column, most in {
        "takeoff_angle": 1e-3, "takeoff_time": 1e-5, "hop_height": 1e-6, "landing_angle": 1e-6, "landing_time": 1e-8,
        "energy_drift": 1e-12, "slip_loss": 1e-5, "impact_loss": 1e-9, "total_loss": 1e-9,
    }.items():  # fmt: skip
        value = getattr(found, column)
        assert value is None or abs(value) < most, column
    assert found.angle_error < 1e-4 if name != "bounces" else found.angle_error < 0.05
    assert found.place_error < 1e-5 if name != "bounces" else found.place_error < 1e-3


REFUSED = {
    "backwards": (lambda s: s._replace(angle=-s.angle, omega=-s.omega), r"omega = -3\.1, .* with 3\.1; .*rolls towards \+x"),
    "height of the centre": (lambda s: s._replace(y=s.y + 1.0), r"y must be the gap.*subtract the radius, 1 m"),
    "load below": (lambda s: s._replace(angle=s.angle + np.pi), r"starts with theta = 3\.14159, .* with 0; .*load at the top"),
    "mirrored angle": (lambda s: s._replace(angle=-s.angle), "theta changes by -1 times the integral of omega"),
    "falling up": (lambda s: s._replace(vy=-s.vy), "y changes by -1 times the integral of vy"),
    "ms": (lambda s: s._replace(t=1e3 * s.t), r"x changes by 0\.001 times the integral of vx over t"),
    "one turn": (lambda s: s._replace(angle=np.mod(s.angle, 2.0 * np.pi)), r"theta jumps by -6\.28 rad after t = 1\.\d+ s"),
    "short": (lambda s: States(*(column[s.t < 1.0] for column in s)), "the record ends at"),
    "nan": (lambda s: s._replace(vx=np.where(s.t > 1.0, np.nan, s.vx)), "vx must be finite"),
    "falling times": (lambda s: s._replace(t=s.t[::-1]), "t must start at 0 and increase"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_record_that_is_none_of_the_motion_is_refused(name):
    change, message = REFUSED[name]
    with pytest.raises(ValueError, match=message):
        score_file(change(exact("hop")), "hop")


def test_coarse_files_are_scored():
    for name in truths():
        score_file(exact(name, 1.0 / 32.0), name)
    states = exact("hop")
    score_file(states._replace(y=states.y - 0.02), "hop")  # an engine that lets the rim sink


def test_columns_without_meaning_are_empty():
    found = scores("rolling", exact("rolling"), wall_seconds=1.25, steps=42)
    assert (found.takeoff_angle, found.hop_height, found.landing_time, found.impact_loss) == (None,) * 4
    assert (found.wall_seconds, found.steps) == (1.25, 42)
    assert scores("drop", exact("drop")).takeoff_angle is None


def test_wrong_phases_are_a_wrong_sequence():
    states = exact("slip")
    found, measures = score(Record(states._replace(vx=2.0 * states.omega - states.vx)), truths()["slip"])
    assert not found.sequence_right
    assert measures.sequence.startswith("RSRK")


def later(s):
    return States(s.t, *(np.interp(s.t - 0.01, s.t, column) for column in s[1:]))


def scaled(s, factor):
    return s._replace(vx=factor * s.vx, vy=factor * s.vy, omega=factor * s.omega)


# Kinetic energy in `rolling` is 7 J at the top, and 12.445 J at the end, where it is 3 % too high.
ROLLING = exact("rolling")
DRIFT = float(np.max(0.01 * ROLLING.t * (7.0 + 0.75 * 9.81 * (1.0 - np.cos(ROLLING.angle)))))
LOST = (-0.3734, 4e-3)
DOCTORED = [
    ("hop", later, {"takeoff_time": (0.01, 2e-4), "landing_time": (0.01, 2e-4), "takeoff_angle": (0.0, 0.1)}),
    ("hop", lambda s: s._replace(y=0.9 * s.y), {"hop_height": (-0.0292, 1e-4), "place_error": (0.0292, 1e-3)}),
    (
        "rolling",
        lambda s: scaled(s, np.sqrt(1.0 + 0.01 * s.t)),
        {"energy_drift": (DRIFT, 1e-3), "total_loss": LOST, "slip_loss": LOST},
    ),
    ("rolling", lambda s: s._replace(y=s.y - 0.004 * np.sin(s.t) ** 2), {"penetration": (0.004, 4e-6)}),
    ("rolling", lambda s: s._replace(x=s.x + 0.02 * s.t), {"place_error": (0.06, 1e-7)}),
    ("rolling", lambda s: s._replace(angle=s.angle - 0.01 * s.t), {"angle_error": (math.degrees(0.03), 1e-5)}),
]


@pytest.mark.parametrize(("name", "change", "expected"), DOCTORED)
def test_a_doctored_column_has_its_error(name, change, expected):
    found = scores(name, change(exact(name)))
    for field, (value, tolerance) in expected.items():
        assert getattr(found, field) == pytest.approx(value, abs=tolerance), field


def test_a_motion_that_takes_off_at_another_angle():
    # a little faster: its own exact events say by how much it is off
    scenario = scenario_of(HOP.task)
    other = scenario.replace("start.speed", 3.11)
    found = scores("hop", sample_motion(other))
    right, wrong = ({event.kind: event for event in reversed(hh.simulate(one).events)} for one in (scenario, other))
    for kind, column in (("takeoff", found.takeoff_angle), ("impact", found.landing_angle)):
        off = wrong[kind].angle - right[kind].angle
        assert abs(off) > 1e-3
        assert column == pytest.approx(math.degrees(off), abs=1e-3)
    assert found.hop_height == pytest.approx(wrong["apex"].height - right["apex"].height, abs=1e-6)


def test_no_hop_is_missing():
    t, speed = np.arange(0.0, 2.0 + SPACING, SPACING), 3.1
    found = scores("hop", States(t, speed * t, 0.0 * t, speed * t, 0.0 * t + speed, 0.0 * t, 0.0 * t + speed))
    assert not found.sequence_right
    assert math.isnan(found.takeoff_angle)
    assert math.isnan(found.hop_height)
    assert found.to_dict()["landing_time"] == "missing"


def test_energy_lost_in_the_impact():
    found = scores("hop", scaled(exact("hop"), np.where(exact("hop").t > 1.8041, 0.9, 1.0)))
    assert found.slip_loss == pytest.approx(0.0, abs=1e-5)
    assert min(found.impact_loss, found.total_loss) > 0.5


def test_chatter_is_counted():
    states = exact("rolling")
    found = scores("rolling", states._replace(vx=states.vx + 0.05 * (np.sin(2 * math.pi * 60.0 * states.t) > 0.9)))
    assert found.chatter > 100
    assert found.sequence_right


# The file


def test_a_record_goes_through_its_file():
    record = Record(exact("hop"), 0.5, 7, {"engine": "mine", "scenario": "hop"})
    again = read_record(record_text(record))
    np.testing.assert_equal(again.states, record.states)
    assert (again.wall_seconds, again.steps, again.notes) == (0.5, 7, {"engine": "mine", "scenario": "hop"})
    assert score_text(record_text(again), "mine.csv").scores.sequence_right


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "must start with the header"),
        ("t,x,y\n0,0,0\n", "must start with the header t,x,y,theta,vx,vy,omega; it starts with 't,x,y'"),
        ("t,x,y,theta,vx,vy,omega\n0,0,0,0,0,0\n", "has 6 numbers in state 1"),
        ("t,x,y,theta,vx,vy,omega\n0,0,0,zero,0,0,0\n", "not a number"),
        ("# steps: many\nt,x,y,theta,vx,vy,omega\n0,0,0,0,0,0,0\n", "must be numbers"),
    ],
)
def test_files_that_are_no_records(text, message):
    with pytest.raises(ValueError, match=message):
        read_record(text)


def test_a_record_must_say_its_motion():
    with pytest.raises(ValueError, match=r"mine.csv: scenario = 'mine' is not one of rolling, slip"):
        score_text(record_text(Record(exact("hop"))), "mine.csv")


# Limits


@pytest.mark.parametrize("order", [0.5, 1.0, 2.0])
def test_limit_and_order(order):
    steps = np.array([1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4])
    found = limit_of(steps, 0.25 + 3.0 * steps**order + 40.0 * steps ** (order + 1.0))
    assert found.order == pytest.approx(order, abs=0.2)
    assert found.limit == pytest.approx(0.25, abs=6e-3)


def test_no_order_where_there_is_none():
    steps = np.array([1e-2, 1e-3, 1e-4, 1e-5])
    assert limit_of(steps, [0.3, 0.1, 0.4, 0.2]).order is None
    assert limit_of(steps, [0.2] * 4) == (0.2, None, 0.0)
    assert limit_of(steps[:3], [1.0, 2.0, 3.0]) is None
    assert limit_of(steps, [math.nan, 1.0, 2.0, 3.0]) is None
