"""Ends of a motion before its duration, compared with the motion that goes on."""

import math

import numpy as np
import pytest

import hophoop as hh
from interrupted import TURN, check_until, same_events
from random_scenarios import draw, scenario_of

HOPS, RETURNS, ROCKS, RESISTED, SLIDES, MASSLESS, SETTLES = map(
    hh.Scenario.from_query,
    (
        "duration=12&hoop.load_fraction=0.5&plane.slope=0.05",
        "duration=8&start.angle=3.5&start.speed=0.5",
        "duration=12&hoop.load_fraction=0.5&start.angle=2&start.speed=0.3",
        "duration=12&hoop.load_fraction=0.5&plane.rolling_resistance=0.02&start.angle=2.5&start.speed=0.8",
        "duration=12&hoop.load_fraction=0.5&plane.mu=0.05&plane.rolling_resistance=0.02&start.angle=1.5&start.speed=0",
        "hoop.load_fraction=1&plane.mu=0.3&start.speed=0.5",
        "hoop.load_fraction=1&plane.mu=0.9&start.speed=1",
    ),
)
UNTILS = ("revolutions:1", "revolutions:0.3", "landings:1", "landings:3", "angle:1.5", "angle:-2", "takeoff", "reversal")


@pytest.mark.parametrize("until", UNTILS)
def test_first_part_of_random_motions(until):
    """The motion is the first part of the one that goes on, up to the first event or passage and no further."""
    ended = sum(check_until(hh.simulate(scenario_of(draw(35, index), 300)), until) for index in range(60))
    assert 5 < ended < 60


ROCKING = [hh.Start.rolling(speed, angle=angle) for speed in (0.5, -0.5, 0.2, -0.2) for angle in (3.5, 2.5, -3.5, 2.0 + TURN)]
SLIDING = [hh.Start(angle=angle, vx=vx, omega=omega) for angle, vx, omega in ((3.5, -1.0, 1.5), (2.8, 1.0, -2.0))]
FLYING = [hh.Start(height=0.3, angle=angle, omega=omega) for angle, omega in ((2.5, 0.4), (-2.0, -0.3), (3.6, 0.0))]
PLANES = {"rolling": hh.Plane(mu=3.0), "sliding": hh.Plane(mu=0.1), "flying": hh.Plane(mu=0.3, restitution=0.5)}


@pytest.mark.parametrize("turns", [0, 2, -3])
@pytest.mark.parametrize(
    ("start", "kind"),
    [
        *((start, "rolling") for start in ROCKING),
        *((start, "sliding") for start in SLIDING),
        *((start, "flying") for start in FLYING),
    ],
)
def test_the_return_to_the_angle_of_the_start(start, kind, turns):
    """It has left it to one side, and comes back without a revolution."""
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=PLANES[kind], start=start, duration=12.0)
    motion, whole = (hh.simulate(scenario, until=until) for until in (f"angle:{start.angle + turns * TURN}", None))
    assert motion.ending.startswith("angle:")
    assert motion.events[-1].angle == pytest.approx(start.angle, abs=1e-14)
    assert whole.at(motion.duration).angle == pytest.approx(start.angle, abs=1e-12)
    away = whole.at(np.linspace(0.0, motion.duration, 400)[1:-1]).angle - start.angle
    assert away.min() >= 0.0 or away.max() <= 0.0


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(("turned", "mode"), [(0.5, "R"), (1.2, "M"), (math.pi, "R")])
def test_an_angle_that_the_massless_hoop_passes_as_its_load_falls(way, turned, mode):
    """It rolls up to 1 rad, skims, and slides on with its load at the bottom, at π."""
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(1.0), plane=hh.Plane(mu=0.5), start=hh.Start.rolling(way * 0.5), duration=12.0)
    whole = hh.simulate(scenario)
    for until in (f"angle:{way * turned}", f"revolutions:{turned / TURN}"):
        motion = hh.simulate(scenario, until=until)
        end, there = motion.events[-1], whole.at(motion.duration)
        assert (motion.ending, end.to_mode) == (until, mode)
        assert end.angle == pytest.approx(way * turned, rel=3e-16)
        assert (there.angle, there.x) == pytest.approx((end.angle, end.x), abs=1e-13)


def test_the_last_landing_has_its_gain():
    """Kane's energy gain belongs to it, and the ledger closes."""
    gaining = hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=0.4),
        plane=hh.Plane(restitution=1.0, impact_law="newton", mu_static=0.5, mu_kinetic=0.3),
        start=hh.Start(height=1.0, vx=0.2, omega=3.0),
    )
    same_events(hh.simulate(gaining, until="landings:2"), hh.simulate(gaining))


def test_other_limits_stay():
    """What comes later than the duration or the last event does not end the motion."""
    brief = HOPS.replace("duration", 1.0)
    motion = hh.simulate(brief, until="revolutions:3")
    assert (motion.ending, motion.duration) == ("duration", 1.0)
    assert motion.fingerprint == hh.simulate(brief).fingerprint
    limited = hh.simulate(HOPS.replace("contact.max_events", 4), until="landings:1")
    assert limited.ending == limited.status == "event_limit"


@pytest.mark.parametrize("number", [3, 36, 60])
def test_digits_count_the_landings_of_accumulating_bounces(number):
    """Doubles close them after fewer landings."""
    bounces = hh.Scenario(plane=hh.Plane(restitution=0.5), start=hh.Start(height=0.5, angle=math.pi), duration=2.0)
    exact = hh.simulate(bounces, until=f"landings:{number}", digits=25)
    assert (exact.ending, len(exact.find("impact")) + len(exact.find("bounce_limit"))) == (f"landings:{number}", number)


@pytest.mark.parametrize(
    ("scenario", "until"), [(HOPS, "landings:1"), (HOPS, "angle:2.5"), (ROCKS, "reversal"), (RETURNS, "angle:3.5")]
)
def test_digits(scenario, until):
    """Extended precision ends at the same instant, with all its digits."""
    rough, exact = hh.simulate(scenario, until=until), hh.simulate(scenario, until=until, digits=20)
    assert exact.ending == rough.ending == until
    assert exact.sequence == rough.sequence
    for name in ("t", "x", "height", "angle", "omega", "slip"):
        assert getattr(rough.events[-1], name) == pytest.approx(float(getattr(exact.events[-1], name)), rel=1e-12, abs=1e-13)
    assert until != "angle:2.5" or str(exact.events[-1].angle).startswith("2.50000000000000000")


def test_saved_and_loaded(tmp_path):
    """A file keeps what ended the motion, and its doubt."""
    pytest.importorskip("netCDF4")
    motion = hh.simulate(HOPS, until="landings:2")
    motion.save(tmp_path / "brief.nc")
    again = hh.load(tmp_path / "brief.nc")
    assert (again.ending, again.fingerprint, again.doubt) == (motion.ending, motion.fingerprint, motion.doubt)
    assert motion.to_dict()["ending"] == "landings:2"
    assert "ending" not in hh.simulate(HOPS).to_dict()


@pytest.mark.parametrize("bad", ["x", "landings:1.5", "landings:0", "revolutions:-1", "revolutions:", "angle:nan", "angle:1e9"])
def test_unknown_ends(bad):
    """One sentence with the field, the value and what is allowed."""
    for more in ({}, {"digits": 20}):
        with pytest.raises(ValueError, match=r"^until = '.*' must be one of revolutions:N, .*\.$"):
            hh.simulate(HOPS, until=bad, **more)


def test_compliant_contact():
    with pytest.raises(ValueError, match=r"^until = 'takeoff' needs rigid contact"):
        hh.simulate(HOPS.replace("contact.model", "compliant"), until="takeoff")


@pytest.mark.parametrize(
    ("scenario", "until"),
    [
        *((HOPS if until != "reversal" else ROCKS, until) for until in UNTILS),
        (RESISTED, "reversal"),
        (SLIDES, "reversal"),
        (MASSLESS, "landings:1"),
        (SETTLES, "landings:1"),
    ],
)
def test_the_sample_at_the_end_is_the_state_after_its_event(scenario, until):
    """Mode, state and forces; from the left those before.

    Rolling resistance turns round with the hoop; the load of the massless one lies on the plane.
    """
    motion, whole = hh.simulate(scenario, until=until), hh.simulate(scenario)
    end, after, before = motion.events[-1], motion.at(motion.duration), motion.at(motion.duration, "left")
    for name in ("x", "height", "angle", "vx", "vy", "omega", "slip"):
        assert getattr(after, name) == getattr(end, name)
    assert (motion.ending, after.mode) == (until, end.to_mode)
    for side, found in (("right", after), ("left", before)):
        same = whole.at(motion.duration, side)
        assert found.mode == same.mode or not until.startswith(("landings", "takeoff", "reversal")), side
        for name in ("normal_force", "friction_force", "kinetic", "potential", "friction", "vy", "slip"):
            assert getattr(found, name) == pytest.approx(getattr(same, name), abs=1e-9), (side, name)
    assert (before.mode != after.mode) or until.partition(":")[0] not in ("landings", "takeoff")
