"""A motion whose first events are given: the same events, and the same motion between them."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from bits_tools import kept_scenarios
from hophoop.kernel.panels.anchor import FREE, ROLLING
from hophoop.kernel.panels.panel import FLY, HOLD
from hophoop.kernel.physics.body import Event, Mode
from hophoop.kernel.records.layout import EVENT, EVENTS, SEGMENT, SEGMENTS
from hophoop.kernel.records.scratch import new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import new_log, write_plain_event
from hophoop.kernel.rigid import script as scripts
from hophoop.kernel.rigid.columns import COLUMNS
from hophoop.kernel.rigid.run import run
from hophoop.kernel.rigid.sampling import sample
from hophoop.simulation.rigid import segments_of_script

# (hoop, plane, start in units of R and √(g R), duration)
MOTIONS = {
    "hop": (hh.Hoop.ideal(0.75), hh.Plane(), (0.0, 0.0, 0.0, 0.0, 0.0, 0.99), 4.0),
    "bounces": (hh.Hoop.ideal(0.5), hh.Plane(restitution=0.5, mu=0.3), (0.0, 0.4, 0.5, 0.0, 0.0, -1.5), 2.0),
    "spun": (hh.Hoop.ideal(0.75), hh.Plane(mu_static=0.6, mu_kinetic=0.4), (0.0, 0.0, 0.5, 0.0, 0.0, 0.7), 3.0),
    "slid without rotation": (
        hh.Hoop(eccentricity=0.5, inertia_ratio=0.75),
        hh.Plane(mu=0.5),
        (0.0, 0.0, -0.5 * math.pi, 1.0, 0.0, 0.0),
        3.0,
    ),
    "slid on a slope": (hh.Hoop.ideal(0.0), hh.Plane(mu=0.0, slope=0.25), (0.0, 0.0, 0.0, 1.0, 0.0, 0.0), 3.0),
    "resisted": (hh.Hoop.ideal(0.3), hh.Plane(mu=0.5, rolling_resistance=0.05), (0.0, 0.0, 2.0, 0.0, 0.0, 0.3), 6.0),
}


def motion_of(body, start, t_end, script=None):
    events, segments = np.zeros(100, EVENT), np.zeros(2000, SEGMENT)
    state = start_state(*start)
    script = events[:0] if script is None else script
    with np.errstate(all="ignore"):  # numbers of a table are NumPy's, which warn where a kernel gives up a panel
        status, count, pieces = run(body, state, t_end, math.nan, 0, events, segments, new_scratch(), script)
    # `run` writes the segments after the script
    return status, events[:count], np.concatenate([segments_of_script(body, script), segments[:pieces]])


def samples(body, segments, times):
    out = np.empty((len(times), len(COLUMNS)))
    sample(body, segments, times, False, out)
    return out


def check(body, t_end, whole, again):
    assert again[0] == whole[0]
    assert again[1]["kind"].tolist() == whole[1]["kind"].tolist()
    for name in EVENT.names:
        np.testing.assert_allclose(again[1][name], whole[1][name], rtol=1e-11, atol=1e-12, err_msg=name)
    pieces = again[2]
    assert (pieces["t"][1:] == pieces["t_end"][:-1]).all()
    assert (pieces["t"][0], pieces["t_end"][-1]) == (0.0, t_end)
    times = np.linspace(0.0, t_end, 23)[1:-1]
    np.testing.assert_allclose(samples(body, pieces, times), samples(body, whole[2], times), rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("name", MOTIONS)
def test_a_script_of_any_length_gives_the_same_motion(name):
    """The last event twice: from there on it is computed. Of what follows the end nothing is asked."""
    hoop, plane, start, t_end = MOTIONS[name]
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    whole = motion_of(body, start, t_end)
    assert len(whole[1]) > 2 or name == "slid on a slope"
    for last in range(len(whole[1]) - 1):
        if (last and whole[1]["t"][last] == whole[1]["t"][last + 1]) or whole[1]["kind"][last] == Event.REST:
            continue  # what comes next at the same time has its own reason
        script = whole[1][[*range(last + 1), last]]
        check(body, t_end, whole, motion_of(body, start, t_end, script))


@pytest.mark.parametrize("name", ["hop", "bounces", "spun", "resisted"])
def test_a_script_may_end_inside_of_a_phase(name):
    """In a state of the motion, halfway to the next event."""
    hoop, plane, start, t_end = MOTIONS[name]
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    whole = motion_of(body, start, t_end)
    for last in range(len(whole[1]) - 1):
        begin, end = whole[1]["t"][last : last + 2]
        if not begin < end or whole[1]["kind"][last] == Event.REST:
            continue
        inside = whole[1][last : last + 1].copy()
        state = dict(zip(COLUMNS, samples(body, whole[2], np.array([0.5 * (begin + end)]))[0], strict=True))
        inside["t"], inside["t_low"], inside["x_low"], inside["kind"] = 0.5 * (begin + end), 0.0, 0.0, Event.TURN
        inside["before_mode"] = inside["after_mode"]
        for column in ("x", "height", "angle", "vx", "vy", "omega", "slip", "friction", "impact_normal", "impact_tangential"):
            inside[column] = state[column]
        inside["theta"], inside["theta_low"] = state["theta"], state["theta_low"]
        inside["turns"] = round((state["angle"] - state["theta"]) / (2.0 * math.pi))
        inside["rolling_resistance"] = state["rolling_resistance"]
        check(body, t_end, whole, motion_of(body, start, t_end, np.concatenate([whole[1][: last + 1], inside])))


def filled(body, mode, state, until, until_low=0.0):
    """The segments of one phase."""
    segments, scratch = np.zeros(50, SEGMENT), new_scratch()
    log = new_log(np.zeros(0, EVENT), segments, scratch)
    scripts.fill_phase(body, mode, state, until, until_low, log, scratch)
    return segments[: scratch.counts[SEGMENTS]]


def numbers_of(row, *names):
    return tuple(row[name].item() for name in names)


@pytest.mark.parametrize(("mode", "sigma"), [(Mode.SKID, 1), (Mode.SPIN, -1)])
def test_a_phase_of_slip_without_rotation_is_one_piece(mode, sigma):
    """On a slope, with the load where friction and weight have no torque: sin θ = −σ μ (1 + ε cos θ)/ε, here at cos θ = 0."""
    hoop, plane = hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), hh.Plane(mu=0.5, slope=0.25)
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    state = start_state(0.0, 0.0, -sigma * 0.5 * math.pi, sigma * 1.0, 0.0, 0.0)
    state = state._replace(th_low=-sigma * math.cos(0.5 * math.pi))  # what π/2 lacks: it is a hilltop, left within some 40 s
    (piece,) = filled(body, int(mode), state, 0.75)
    assert numbers_of(piece, "t", "t_end", "mode", "kind", "sigma", "way", "xi") == (0.0, 0.75, mode, HOLD, sigma, 0.0, 0.0)
    assert piece["opening"] == pytest.approx(math.sin(0.25) - sigma * 0.5 * math.cos(0.25), rel=1e-15)


def test_a_phase_of_rest_is_one_piece():
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=hh.Plane(mu=0.5)).to_body()
    (piece,) = filled(body, int(Mode.ROLL), start_state(0.0, 0.0, math.pi, 0.0, 0.0, 0.0), 0.75)
    expected = (0.0, 0.75, Mode.ROLL, HOLD, 0, 0.0, 0.0, 0.0)
    assert numbers_of(piece, "t", "t_end", "mode", "kind", "sigma", "way", "xi", "opening") == expected


def test_slip_that_is_too_brief_for_a_panel_is_one_piece():
    plane = hh.Plane(mu=0.5, rolling_resistance=0.01)
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=plane).to_body()
    state = start_state(0.0, 0.0, 0.5 * math.pi, 1.12e8, 0.0, -1.12e8)
    (piece,) = filled(body, int(Mode.SKID), state, 4e-25)
    assert numbers_of(piece, "t", "t_end", "mode", "kind", "sigma", "slip") == (0.0, 4e-25, Mode.SKID, HOLD, 1, 1.12e8)


def test_a_phase_lasts_until_a_time_of_two_doubles():
    """What one double rounds away is a hundredth of this slip."""
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(mu=0.5)).to_body()
    low = 0.4 * math.ulp(1.0)
    begin = 1.0 - 40.0 * low
    state = start_state(0.0, 0.0, 1.0, 1.0, 0.0, 1e8)._replace(t=begin)
    pieces = [filled(body, int(Mode.SKID), state, 1.0, each)[-1] for each in (-low, 0.0, low)]
    turned = [piece["extent"] * 0.5 * (1.0 + piece["xi"]) for piece in pieces]
    expected = [1e8 * (40.0 * low + each) for each in (-low, 0.0, low)]
    np.testing.assert_allclose(turned, expected, rtol=1e-3)


def test_events_at_one_time_have_no_piece_between_them():
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75)).to_body()
    script = np.zeros(4, EVENT)
    script["t"] = [0.0, 0.5, 0.5, 1.0]
    script["after_mode"] = Mode.FLIGHT
    script["height"], script["vy"] = 1.0, 1.0
    pieces = segments_of_script(body, script)
    assert [numbers_of(piece, "t", "t_end") for piece in pieces] == [(0.0, 0.5), (0.5, 1.0)]
    for piece in pieces:  # of a flight, with the load at the top
        assert numbers_of(piece, "kind", "sigma", "way", "xi", "opening") == (FLY, 0, 0.0, 0.0, -1.0)


def repeated(body, state, kinds, mode, times):
    """The phase in which a script ends, and how many events it has written."""
    script, scratch = np.zeros(len(kinds), EVENT), new_scratch()
    log = new_log(script, np.zeros(0, SEGMENT), scratch)
    for kind in kinds:
        write_plain_event(log, kind, 0, mode, state)
    script["t"] = times
    log = new_log(np.zeros(20, EVENT), np.zeros(0, SEGMENT), scratch)
    phase = scripts.repeat(body, script, log, scratch)
    return phase, scratch.counts[EVENTS]


def test_a_script_that_ends_inside_of_a_phase_goes_on_there():
    """Nothing begins there, no bounce was before; what rolling conserves is measured anew, in flight there is nothing."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=hh.Plane(mu=0.5)).to_body()
    state = start_state(0.0, 0.0, 2.0, 0.0, 0.0, 0.5)
    phase, count = repeated(body, state, [Event.START, Event.TURN], int(Mode.ROLL), [0.0, 0.5])
    assert (phase.mode, phase.begins, phase.bounce, count) == (Mode.ROLL, False, 0.0, 1)
    assert phase.state.anchor.kind == ROLLING
    # D θ̇² + 2 ε cos θ is conserved; from the bottom it is what there is above 2 ε cos π
    energy = (1.0 + 0.75 + 0.25 + math.cos(2.0)) * 0.25 + math.cos(2.0) + 1.0
    assert phase.state.anchor.excess == pytest.approx(energy, rel=1e-14)
    phase, count = repeated(body, state._replace(y=1.0), [Event.START, Event.APEX], int(Mode.FLIGHT), [0.0, 0.5])
    assert (phase.mode, phase.begins, phase.bounce, count) == (Mode.FLIGHT, False, 0.0, 1)
    assert phase.state.anchor.kind == FREE


@pytest.mark.parametrize(("plane", "zeros"), [(hh.Plane(mu=0.5), 2), (hh.Plane(mu_static=0.5, mu_kinetic=0.25), 1)])
def test_a_script_that_ends_with_an_event_begins_the_phase_after_it(plane, zeros):
    """Slip from the friction cone begins with no speed, and without acceleration if both frictions are one."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=plane).to_body()
    state = start_state(0.0, 0.0, 2.0, 0.0, 0.0, 0.5)
    kinds = [Event.START, Event.TURN, Event.SLIP_START, Event.SLIP_START]
    phase, count = repeated(body, state, kinds, int(Mode.SKID), [0.0, 0.0, 0.5, 0.5])
    assert (phase.mode, phase.begins, phase.zeros, phase.bounce, count) == (Mode.SKID, True, zeros, 0.0, 3)
    kinds = [Event.START, Event.SLIP_START, Event.IMPACT, Event.IMPACT]
    phase, _ = repeated(body, state, kinds, int(Mode.SKID), [0.0, 0.0, 0.5, 0.5])
    assert (phase.begins, phase.zeros, phase.bounce) == (True, 1, 0.0)


def test_no_decided_event_is_after_the_end():
    """The duration in the kernel's units is rounded, and the digits go on to the exact one: time ran back by its last digit."""
    digits = [one for one in kept_scenarios() if one.kind == "digits"]
    assert len(digits) > 10
    for one in digits:
        tables = hh.simulate(one.scenario).tables
        assert np.all(np.diff(tables["events"]["t"]) >= 0.0), one.index
        assert tables["segments"]["t_end"][-1] <= max(tables["events"]["t"][-1], tables["segments"]["t"][-1]), one.index
