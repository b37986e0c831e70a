"""Fast motion without its flights, against motions with gravity, and where it begins to grow."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.gaits.runaway import FALL, passage

HOOP = hh.Hoop.ideal(0.75, radius=1.0, mass=1.0)
PLANES = {
    "plastic": hh.Plane(gravity=1.0, slope=0.5),
    "bouncing": hh.Plane(gravity=1.0, slope=0.3, restitution=0.5, impact_law="newton"),
    "resisted": hh.Plane(gravity=1.0, slope=0.4, mu_static=0.7, mu_kinetic=0.5, rolling_resistance=0.05),
    "uphill": hh.Plane(gravity=1.0, slope=-0.4),
}


def without_gravity(plane):
    return hh.Plane.model_validate({**plane.model_dump(exclude={"mu"}), "gravity": 0.0})


def of_gravity_centre(state):
    eps = HOOP.eccentricity
    return (
        float(state.vx + eps * state.omega * math.cos(state.angle)),
        float(state.vy - eps * state.omega * math.sin(state.angle)),
        float(state.omega),
    )


@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize("seed", range(3))
def test_one_passage_is_that_of_fast_motion_with_gravity(name, seed):
    """From the height of the fall on the way up to the take-off after the next contact, at 10⁴ √(g R)."""
    rng = np.random.default_rng(seed)
    plane, fast = PLANES[name], 1e4
    along, away, omega = fast * np.array([rng.uniform(-1, 1), rng.uniform(0.2, 1), rng.uniform(-1, 1)])
    eps, angle = HOOP.eccentricity, rng.uniform(0, 2 * math.pi)
    start = hh.Start(
        height=FALL - eps * math.cos(angle) - 1.0,
        angle=angle,
        vx=along - eps * omega * math.cos(angle),
        vy=away + eps * omega * math.sin(angle),
        omega=omega,
    )
    flight = 2.0 * away / (plane.gravity * math.cos(plane.slope))
    motion = hh.simulate(hh.Scenario(hoop=HOOP, plane=plane, start=start, duration=flight + 2e3 / fast))
    landing = next(event for event in motion.events if event.kind == "impact")
    last = [event for event in motion.events if event.kind in ("takeoff", "impact")][-1]
    assert last.to_mode == "H"
    # when the fall begins, and where the load is then
    early = motion.at(np.linspace(landing.t - 20 / fast, landing.t, 40001))
    height = 1.0 + early.height + eps * np.cos(early.angle)
    at = float(np.interp(-FALL, -height, early.angle)) % (2.0 * math.pi)
    found = passage(HOOP, without_gravity(plane), (along, away, omega), at)
    assert np.array(found) / fast == pytest.approx(np.array(of_gravity_centre(last)) / fast, abs=1e-6)


def test_velocities_have_no_scale_and_mirror():
    plane, mirrored = (without_gravity(hh.Plane(slope=slope)) for slope in (0.4, -0.4))
    along, away, omega = passage(HOOP, plane, (0.5, 0.4, 0.3), 1.0)
    assert passage(HOOP, plane, (4.0, 3.2, 2.4), 1.0) == pytest.approx((8 * along, 8 * away, 8 * omega), rel=1e-12)
    assert passage(HOOP, mirrored, (-0.5, 0.4, -0.3), -1.0) == pytest.approx((-along, away, -omega), rel=1e-12)


def test_without_slope_and_loss_the_speed_is_kept():
    """No friction and e = 1: the kinetic energy of each passage is that of before, and on the level growth is 0."""
    plane = hh.Plane(gravity=0.0, mu=0.0, restitution=1.0)
    velocities = (0.5, 0.4, 0.3)
    for angle in np.linspace(0.0, 6.0, 7):
        found = passage(HOOP, plane, velocities, float(angle))
        energies = [one[0] ** 2 + one[1] ** 2 + HOOP.inertia_ratio * one[2] ** 2 for one in (found, velocities)]
        assert energies[0] == pytest.approx(energies[1], rel=1e-12)


def test_fast_motion_with_gravity_grows_at_the_rate():
    """More than 600 long flights from 1,000 √(g R) on, down a slope of 38°."""
    radius, gravity = 1e-3, 1e5
    hoop, plane = hh.Hoop.ideal(0.75, radius=radius, mass=1.0), hh.Plane(gravity=gravity, slope=math.radians(38.0))
    found = hh.gaits.growth(hoop, plane, 4000)
    logarithms = []
    for angle in range(6):
        start = hh.Start.rolling(1e4, angle=float(angle))
        motion = hh.simulate(hh.Scenario(hoop=hoop, plane=plane, start=start, duration=1e5, contact=hh.Rigid(max_events=2000)))
        away = gravity * math.cos(plane.slope)
        # at the top of each long flight; short ones are parts of a passage
        tops = [event for event in motion.events if event.kind == "apex" and event.height > 1e3 * radius]
        speeds = []
        for top in tops:
            flight = math.sqrt(2.0 * top.height / away)
            along = top.vx - gravity * math.sin(plane.slope) * flight  # at take-off
            turning = hoop.inertia_ratio * (radius * top.omega) ** 2
            speeds.append(math.sqrt(along**2 + 2.0 * away * top.height + turning))
        logarithms.extend(np.diff(np.log(speeds)))
    assert len(logarithms) > 600
    error = np.std(logarithms) / math.sqrt(len(logarithms))
    assert found.rate > 10 * found.error
    assert abs(np.mean(logarithms) - found.rate) < 4 * math.hypot(error, found.error)


LONG = [pytest.mark.long]


@pytest.mark.parametrize(
    ("load", "degrees", "error"),
    [(0.75, 34.31, 0.08), pytest.param(0.25, 11.13, 0.16, marks=LONG), pytest.param(0.5, 22.45, 0.14, marks=LONG)],
)
def test_the_critical_slope_is_that_of_motions_with_their_flights(load, degrees, error):
    """Numbers of 9,000 landings a slope, computed with gravity and long flights."""
    found = hh.gaits.runaway(hh.Hoop.ideal(load), hh.Plane(), 16_000)
    assert abs(math.degrees(found.slope) - degrees) < 3 * math.hypot(error, math.degrees(found.error))
    other = hh.gaits.runaway(hh.Hoop.ideal(load, radius=0.1), hh.Plane(gravity=3.0, slope=0.2), 16_000, seed=100)
    assert abs(other.slope - found.slope) < 4 * math.hypot(other.error, found.error)


@pytest.mark.parametrize(
    ("hoop", "plane", "flights", "words"),
    [
        (hh.Hoop.ideal(1.0), hh.Plane(), 20_000, "hoop.inertia_ratio = 0.0 must be above 0"),
        (HOOP, hh.Plane(mu=0.0), 20_000, "plane.mu_kinetic = 0.0 must be above 0 and finite"),
        (HOOP, hh.Plane(mu=math.inf), 20_000, "plane.mu_kinetic = inf must be above 0 and finite"),
        (HOOP, hh.Plane(), 400, "flights = 400 must be an integer from 1000 on"),
    ],
)
def test_bad_input(hoop, plane, flights, words):
    with pytest.raises(ValueError, match=words):
        hh.gaits.growth(hoop, plane, flights)


def test_too_few_flights_are_named_as_they_were_given():
    with pytest.raises(ValueError, match="flights = 4000 must be an integer from 8000 on"):
        hh.gaits.runaway(HOOP, hh.Plane(), 4000)


def test_a_hoop_of_little_load_runs_away_on_a_slope_of_little_steepness():
    """As 45° γ, below any bound of the search."""
    found = hh.gaits.runaway(hh.Hoop.ideal(1e-3), hh.Plane(), 8000)
    assert found.slope == pytest.approx(0.25 * math.pi * 1e-3, rel=0.03)


def test_progress_is_told():
    told = []
    hh.gaits.runaway(hh.Hoop.ideal(0.25), hh.Plane(), 8000, progress=told.append)
    assert told == [k / 8 for k in range(1, 9)]


@pytest.mark.parametrize("away", [1e-4, 1e-8, 1e-12])
def test_a_take_off_that_hardly_leaves_the_plane_is_a_flight_too(away):
    """Its fall takes long, its contact does not; it loses ever less, and the hoop leaves the plane with √away."""
    hoop, plane = hh.Hoop.ideal(0.05, radius=1.0, mass=1.0), without_gravity(hh.Plane(slope=0.04))
    along, leaves, omega = passage(hoop, plane, (0.72, away, 0.69), 1.6)
    assert (along, omega) == pytest.approx((0.72, 0.69), abs=2.0 * math.sqrt(away))
    assert 0.0 < leaves < math.sqrt(away)
