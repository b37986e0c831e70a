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


def changed(states, **columns):
    return states._replace(**columns)


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


@pytest.mark.parametrize("name", truths())
def test_the_height_of_the_centre_is_not_the_gap(name):
    """It would be scored as 1,000 mm too high, and everything else as right."""
    states = exact(name)
    with pytest.raises(ValueError, match=r"y = .* m.*height of the centre.*must be the gap.*subtract the radius, 1 m"):
        scores(name, changed(states, y=states.y + 1.0))
    scores(name, changed(states, y=states.y - 0.02))  # an engine that lets the rim sink is scored


def mass_center(s):
    return s._replace(x=s.x + 0.75 * np.sin(s.angle), y=s.y + 0.75 * np.cos(s.angle))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda s: s._replace(angle=-s.angle, omega=-s.omega), r"starts with omega = -3\.1, .* with 3\.1; .*rolls towards \+x"),
        (lambda s: s._replace(angle=s.angle + np.pi), r"starts with theta = 3\.14159, .* with 0; .*load at the top"),
        (lambda s: s._replace(omega=np.degrees(s.omega), angle=np.degrees(s.angle)), r"starts with omega = 177.*in rad/s"),
        (lambda s: s._replace(x=1e3 * s.x, vx=1e3 * s.vx), r"starts with vx = 3100, .*in m/s"),
        (lambda s: s._replace(x=s.x + 3.0), r"starts with x = 3, .* with 0"),
        (mass_center, r"starts with y = 0\.75, .*gap between rim and plane"),
    ],
)
def test_a_record_that_starts_elsewhere_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        scores("hop", change(exact("hop")))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda s: s._replace(angle=-s.angle), "theta changes by -1 times the integral of omega"),
        (lambda s: s._replace(angle=np.degrees(s.angle)), r"theta changes by 57\.3 times"),
        (lambda s: s._replace(t=1e3 * s.t), r"x changes by 0\.001 times the integral of vx over t"),
        (lambda s: s._replace(angle=np.mod(s.angle, 2.0 * np.pi)), r"theta jumps by -6\.28 rad after t = 1\.\d+ s"),
    ],
)
def test_a_file_whose_columns_disagree_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        score_file(change(exact("hop")), "hop")


@pytest.mark.parametrize("spacing", [SPACING, 1e-3, 1.0 / 32.0])
@pytest.mark.parametrize("name", truths())
def test_a_right_file_is_scored(name, spacing):
    score_file(exact(name, spacing), name)


def test_columns_without_meaning_are_empty():
    found = scores("rolling", exact("rolling"))
    assert (found.takeoff_angle, found.hop_height, found.landing_time, found.impact_loss) == (None,) * 4
    assert scores("drop", exact("drop")).takeoff_angle is None


def test_a_missing_phase_is_a_wrong_sequence():
    task, states = truths()["slip"].task, exact("slip")
    stuck = np.where(states.t > 0.8, task.radius * states.omega, states.vx)  # no slip behind the first
    found, measures = score(Record(changed(states, vx=stuck)), truths()["slip"])
    assert not found.sequence_right
    assert measures.sequence == "RKR"


def test_a_wrong_mode_of_slip_is_a_wrong_sequence():
    task, states = truths()["slip"].task, exact("slip")
    mirrored = 2.0 * task.radius * states.omega - states.vx
    found, measures = score(Record(changed(states, vx=mirrored)), truths()["slip"])
    assert not found.sequence_right
    assert measures.sequence.startswith("RSRK")


def later(states, by):
    """The same motion, that much later, as the rule sees it."""
    shifted = [np.interp(states.t - by, states.t, column) for column in states[1:]]
    return States(states.t, *shifted)


def test_a_late_take_off_and_landing():
    found = scores("hop", later(exact("hop"), 0.01))
    assert found.takeoff_time == pytest.approx(0.01, abs=2e-4)
    assert found.landing_time == pytest.approx(0.01, abs=2e-4)
    assert abs(found.takeoff_angle) < 0.1


def test_a_motion_that_takes_off_at_another_angle():
    # a little faster: its own exact events say by how much it is off
    scenario = scenario_of(HOP.task)
    other = scenario.replace("start.speed", 3.11)
    found = scores("hop", sample_motion(other))
    right, wrong = hh.simulate(scenario), hh.simulate(other)
    for kind, column in (("takeoff", "takeoff"), ("impact", "landing")):
        off = wrong.find(kind)[0].angle - right.find(kind)[0].angle
        assert abs(off) > 1e-3
        assert getattr(found, f"{column}_angle") == pytest.approx(math.degrees(off), abs=1e-3)
    higher = wrong.find("apex")[0].height - right.find("apex")[0].height
    assert found.hop_height == pytest.approx(higher, abs=1e-6)


def test_a_low_hop():
    states = exact("hop")
    found = scores("hop", changed(states, y=0.9 * states.y))
    assert found.hop_height == pytest.approx(-0.0292, abs=1e-4)
    assert found.place_error == pytest.approx(0.0292, abs=1e-3)


def test_no_hop_is_missing():
    t, speed = np.arange(0.0, 2.0 + SPACING, SPACING), 3.1
    rolling = States(t, speed * t, 0.0 * t, speed * t, 0.0 * t + speed, 0.0 * t, 0.0 * t + speed)
    found = scores("hop", rolling)
    assert not found.sequence_right
    assert math.isnan(found.takeoff_angle)
    assert math.isnan(found.hop_height)
    assert found.to_dict()["landing_time"] == "missing"


def test_energy_that_drifts_while_rolling():
    states = exact("rolling")
    faster = np.sqrt(1.0 + 0.01 * states.t)
    found = scores("rolling", changed(states, vx=faster * states.vx, omega=faster * states.omega))
    # kinetic energy is 7 J at the top, and 12.445 J at the end, where it is 3 % too high
    kinetic = 7.0 + 0.75 * 9.81 * (1.0 - np.cos(states.angle))
    assert found.energy_drift == pytest.approx(float(np.max(0.01 * states.t * kinetic)), rel=1e-3)
    assert found.total_loss == pytest.approx(-0.03 * 12.445, rel=0.01)


def test_energy_lost_in_slip_and_impact():
    states = exact("hop")
    faster = np.where(states.t > 0.5, 1.01, 1.0)
    found = scores("hop", changed(states, vx=faster * states.vx, vy=faster * states.vy, omega=faster * states.omega))
    task = HOP.task
    k = int(np.searchsorted(states.t, 1.0447))
    sine, cosine = math.sin(states.angle[k]), math.cos(states.angle[k])
    speed = (states.vx[k] + task.arm * states.omega[k] * cosine) ** 2 + (states.vy[k] - task.arm * states.omega[k] * sine) ** 2
    kinetic = 0.5 * task.mass * speed + 0.5 * task.inertia * states.omega[k] ** 2
    # N, read off the faster velocities, is zero a little earlier; of slower ones it would be positive in flight, too
    assert found.slip_loss == pytest.approx((1 - 1.01**2) * kinetic, rel=0.03)
    after = np.where(states.t > 1.8041, 0.9, 1.0)
    found = scores("hop", changed(states, vx=after * states.vx, vy=after * states.vy, omega=after * states.omega))
    assert found.slip_loss == pytest.approx(0.0, abs=1e-5)
    assert found.impact_loss > 0.5
    assert found.total_loss > 0.5


def test_depth_in_the_plane():
    states = exact("rolling")
    found = scores("rolling", changed(states, y=states.y - 0.004 * np.sin(states.t) ** 2))
    assert found.penetration == pytest.approx(0.004, rel=1e-3)


def test_chatter_is_counted():
    states = exact("rolling")
    rattle = states.vx + 0.05 * (np.sin(2 * math.pi * 60.0 * states.t) > 0.9)
    found = scores("rolling", changed(states, vx=rattle))
    assert found.chatter > 100
    assert found.sequence_right


def test_place_and_angle_anywhere():
    states = exact("rolling")
    found = scores("rolling", changed(states, x=states.x + 0.02 * states.t, angle=states.angle - 0.01 * states.t))
    assert found.place_error == pytest.approx(0.06, rel=1e-6)
    assert found.angle_error == pytest.approx(math.degrees(0.03), rel=1e-6)


def test_steps_and_wall_time_are_the_records_own():
    found = scores("rolling", exact("rolling"), wall_seconds=1.25, steps=42)
    assert (found.wall_seconds, found.steps) == (1.25, 42)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda s: States(*(column[s.t < 1.0] for column in s)), "the record ends at"),
        (lambda s: s._replace(vx=np.where(s.t > 1.0, np.nan, s.vx)), "vx must be finite"),
        (lambda s: s._replace(t=s.t[::-1]), "t must start at 0 and increase"),
        (lambda s: States(*(column[:2] for column in s)), "needs at least 3"),
    ],
)
def test_records_that_cannot_be_used(change, message):
    with pytest.raises(ValueError, match=message):
        scores("hop", change(exact("hop")))


def test_a_dense_record_scores_like_a_thin_one():
    dense, thin = scores("hop", exact("hop", 1e-5)), scores("hop", exact("hop"))
    assert dense.takeoff_angle == pytest.approx(thin.takeoff_angle, abs=2e-4)
    assert dense.hop_height == pytest.approx(thin.hop_height, abs=1e-6)


# The file


def test_a_record_goes_through_its_file():
    record = Record(exact("hop"), 0.5, 7, {"engine": "mine", "scenario": "hop"})
    again = read_record(record_text(record))
    for mine, theirs in zip(record.states, again.states, strict=True):
        np.testing.assert_array_equal(mine, theirs)
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
    same = limit_of(steps, [0.2] * 4)
    assert (same.limit, same.order) == (0.2, None)
    assert limit_of(steps[:3], [1.0, 2.0, 3.0]) is None
    assert limit_of(steps, [math.nan, 1.0, 2.0, 3.0]) is None
