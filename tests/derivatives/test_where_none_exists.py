"""Where a derivative does not exist: nan, the reason, and one-sided derivatives against one-sided differences."""

import math

import numpy as np
import pytest

import hophoop as hh
from differences import halved
from hophoop.derivatives.layout import REASONS, Reason
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from hophoop.kernel.native import forced
from hophoop.vocabulary.names import LAW_CODES
from oracles.derivatives import one_sided

GRAZES = (REASONS[Reason.BORDER], REASONS[Reason.GRAZE])


pytestmark = pytest.mark.usefixtures("interpreted")


def test_a_start_without_slip_on_ice_has_one():
    scenario = hh.Scenario.from_query("duration=0.7&plane.mu=0&start.vx=1&start.omega=1")
    assert hh.sensitivity(scenario, "end.x", "start.vx").derivatives[0, 0] == pytest.approx(0.7, rel=1e-12)


ROLLS, SLIPS, FAST = "start.speed=1", "start.vx=2&start.omega=-1&plane.mu=0.3", "start.speed=3.9&start.angle=0.1"
NO_SLIP = "start.vx=1&start.omega=1&plane.mu=0.1"
TOP = "hoop.load_fraction=0.25&plane.gravity=1&start.speed=2"  # N = m (g − ε v²/R) = 0 at the top


@pytest.mark.parametrize(
    ("query", "path", "reason"),
    [
        # with the rim lifted or thrown it would bounce
        *((query, path, Reason.CONTACT) for query in (ROLLS, SLIPS, FAST) for path in ("start.height", "start.vy")),
        # with a little slip it begins otherwise, whether it then rolls or slips
        *((f"{NO_SLIP}&start.angle={angle}", path, Reason.BORDER) for angle in (0, 1) for path in ("start.vx", "start.omega")),
        # a little faster it hops at once, a little slower it rolls
        *((f"{TOP}&plane.mu={mu}", "hoop.load_fraction", Reason.BORDER) for mu in (1, "inf")),
        # infinite friction stops the slip, which lifts the hoop on one side and not on the other
        ("plane.mu=inf&start.vx=6&start.omega=1", "start.angle", Reason.BORDER),
        ("plane.mu=0&start.speed=0", "start.angle", Reason.FRICTIONLESS),
        ("hoop.load_fraction=1&start.speed=1", "hoop.load_fraction", Reason.MASSLESS),
    ],
)
def test_there_is_none_to_either_side(query, path, reason):
    result = hh.sensitivity(hh.Scenario.from_query(f"duration=3&{query}"), ["end.x", "end.angle"], path)
    assert result.reasons == ((REASONS[reason],),) * 2
    assert np.isnan([result.derivatives, result.smaller, result.larger]).all()


@pytest.mark.parametrize("law", LAW_CODES)
@pytest.mark.parametrize(
    ("path", "mu", "angle", "sided"),
    [("start.vx", 0.9, 0.6, False), ("start.vx", 0.2, 2.0, True), ("start.omega", 0.2, 2.0, True)],
)
def test_a_hoop_dropped_without_rotation_lands_without_slip(law, path, mu, angle, sided):
    """v_t = 0 at the landing: a little slip is ended by the impact, by the same impulse on either side.

    With little friction it starts to slide, and the sides differ: a little slip against the one to come is stopped first.
    """
    plane = hh.Plane(mu=mu, restitution=0.4, impact_law=law)
    scenario = hh.Scenario(start=hh.Start(height=0.3, angle=angle), plane=plane, duration=0.3)
    of = ["impact.omega", "impact.vy", "impact.slip"]
    result = hh.sensitivity(scenario, of, path)
    assert result.reasons[0] == (SIDED if sided else "",)
    for step, found in ((-(2.0**-26), result.smaller), (2.0**-26, result.larger)):
        assert found[:, 0] == pytest.approx(one_sided(scenario, path, step, of), rel=1e-7 if sided else 1e-8, abs=1e-12)


def test_the_edge_of_what_is_allowed():
    motion = hh.simulate(hh.Scenario(duration=2.0))
    result = motion.sensitivity("takeoff.angle", ["plane.mu_static", "plane.mu_kinetic", "plane.restitution", "plane.mu"])
    assert result.reasons[0] == (EDGE, EDGE, EDGE, "")
    assert np.isnan(result.derivatives[0, :3]).all()
    # μs may only grow and μk may only fall; both together are what μ does
    assert np.isnan(result.smaller[0, 0])
    assert np.isnan(result.larger[0, 1])
    assert result.larger[0, 0] + result.smaller[0, 1] == pytest.approx(result["takeoff.angle", "plane.mu"], rel=1e-12)
    assert result.larger[0, 2] == 0.0  # the take-off is before any impact


@pytest.mark.parametrize(
    ("query", "path", "sides"),
    [
        ("start.speed=1e6&duration=1e-9", "start.speed", (True, False)),
        ("plane.slope=-1.57&duration=1e-3", "plane.slope", (False, True)),
        ("plane.gravity=0&duration=1e-3", "plane.gravity", (False, True)),
        ("plane.mu=1e6&duration=1e-3", "plane.mu", (True, False)),
        # neither coefficient can be another one alone
        ("plane.mu=0&start.speed=1&duration=0.4", "plane.mu_kinetic", (False, False)),
        # the massless hoop has its load at the rim, and rolls on a level plane only
        ("hoop.load_fraction=1&start.speed=1&duration=0.2", "hoop.eccentricity", (False, False)),
        ("hoop.load_fraction=1&start.speed=1&duration=0.2", "plane.slope", (False, False)),
    ],
)
def test_the_edge_is_that_of_the_ranges(query, path, sides):
    result = hh.sensitivity(hh.Scenario.from_query(query), "end.x", path)
    assert (math.isfinite(result.smaller[0, 0]), math.isfinite(result.larger[0, 0])) == sides
    assert np.isnan(result.derivatives[0, 0])
    assert result.reasons == ((EDGE,),)


def reason_of(scenario, of, wrt):
    result = hh.sensitivity(scenario, of, wrt)
    assert np.isnan(result.derivatives).all()
    return result.reasons[0][0]


@pytest.mark.parametrize("law", LAW_CODES)
def test_restitution_that_is_zero(law):
    """Up to the landing, its time and place included, nothing changes; from there on there is no derivative."""
    scenario = hh.Scenario(plane=hh.Plane(impact_law=law), duration=1.95)
    before = ["takeoff.t", "apex.height", "impact.t", "impact.angle", "at(1.2).x", "hop.distance"]
    after = ["impact.omega", "impact.vy", "impact.impact_normal", "impact.impulse_normal", "at(1.9).x", "end.angle", "end.t"]
    result = hh.sensitivity(scenario, [*before, *after], "plane.restitution")
    assert (result.larger[: len(before), 0] == 0.0).all()
    assert np.isnan(result.larger[len(before) :]).all()
    assert np.isnan([result.smaller, result.derivatives]).all()
    assert result.reasons == ((EDGE,),) * len(before) + ((REASONS[Reason.PLASTIC],),) * len(after)


def test_restitution_that_is_zero_and_a_hoop_that_rests_where_it_lands():
    motion = hh.simulate(hh.Scenario(start=hh.Start(height=0.1), duration=0.5))
    assert motion.status == "at_rest"
    assert np.isnan(motion.sensitivity(["at(0.45).angle", "end.x"], "plane.restitution").larger).all()
    assert np.isnan(motion.uncertainty({"plane.restitution": 0.1}).at(0.45).x).all()


@pytest.fixture(scope="module")
def grazes():
    """Motions with the friction that is just enough to roll on, to the last digit, and just not."""
    scenario = hh.Scenario.from_query("duration=1.6&hoop.load_fraction=0.4&start.speed=0.5")

    def with_friction(mu):
        return hh.simulate(scenario.with_values({"plane.mu": mu}))

    with forced("interpreted"):
        return [with_friction(mu) for mu in halved(0.05, 1.0, lambda mu: bool(with_friction(mu).find("slip_start")))]


def test_a_graze_of_the_friction_cone(grazes):
    """Its margin touches zero in passing."""
    for motion in grazes:
        assert reason_of(motion.scenario, "end.angle", "plane.mu") in GRAZES
    more = grazes[1].scenario.with_values({"plane.mu": 1.01 * grazes[1].scenario.plane.mu_static})
    assert hh.sensitivity(more, "end.angle", "plane.mu").derivatives[0, 0] == 0.0


def test_a_motion_keeps_from_when_on_it_is_in_doubt(grazes, tmp_path):
    """From the panel in which rolling needs all the friction that there is; a loaded motion finds it by a second run."""
    motion = grazes[1]
    times = motion.times(2001)
    tangency = times[np.argmax(motion.at(times).utilization(motion.scenario.plane))]
    assert tangency - 0.2 < motion.doubt <= tangency < motion.kernel_doubt
    assert motion.doubt == motion.kernel_doubt * motion.units.time
    assert np.isinf(motion.errors.t).tolist() == [event.t > motion.doubt for event in motion.events]
    assert hh.simulate(hh.Scenario(duration=2.0)).doubt == math.inf
    motion.save(tmp_path / "graze.nc")
    assert hh.load(tmp_path / "graze.nc").doubt == motion.doubt


@pytest.mark.parametrize("step", [-1, 0, 1])
def test_two_events_that_fall_together(step):
    """At the least speed that hops, the slip stops as the rim lifts off: from there on there is no derivative."""
    speed = float(hh.theory.first_hop_speed(hh.Hoop.ideal(0.75)))
    speed += step * math.ulp(speed)
    of = ["slip_start[1].t", "end.x"]
    result = hh.sensitivity(hh.Scenario(start=hh.Start.rolling(speed), duration=1.4), of, "start.speed")
    assert result.reasons[0] == ("",)
    assert result.reasons[1][0] in GRAZES
    assert np.isnan([result.derivatives[1], result.smaller[1], result.larger[1]]).all()
    beside = hh.sensitivity(hh.Scenario(start=hh.Start.rolling(speed + 1e-8), duration=1.4), of, "start.speed")
    assert beside.reasons == (("",), ("",))
    assert beside.derivatives[0] == pytest.approx(result.derivatives[0], rel=1e-6)


def test_the_rim_that_touches_the_plane_in_flight_without_approach():
    """A hoop that spins so fast that its rim comes down and goes up again: at one height it touches the plane."""
    hoop, plane = hh.Hoop(eccentricity=0.9, inertia_ratio=0.1), hh.Plane(mu=0.5)

    def thrown(height):
        return hh.Scenario(hoop=hoop, plane=plane, start=hh.Start(height=height, vy=1.3, omega=9.5, angle=3.88), duration=0.3)

    low, high = halved(0.1, 0.3, lambda height: bool(hh.simulate(thrown(height)).find("impact")))
    assert reason_of(thrown(high), "end.x", "start.height") == REASONS[Reason.GRAZE]
    assert abs(hh.sensitivity(thrown(low), "end.x", "start.height").derivatives[0, 0]) > 1e6
    assert hh.sensitivity(thrown(high + 1e-6), "end.x", "start.height").reasons == (("",),)


def test_a_motion_without_an_answer():
    motion = hh.simulate(hh.Scenario.from_query("duration=1&hoop.load_fraction=1&start.height=0.1"))
    assert motion.status == "undetermined"
    found = motion.sensitivity("end.t", "start.angle")["end.t", "start.angle"]
    assert math.isnan(found) or found == 0.0


HOP, FREE, PARTS = "duration=2", "hoop.eccentricity=0.5&hoop.inertia_ratio=0.6&start.vx=1&start.omega=2&duration=0.5", "parts"
FREE += "&plane.mu_static=0.6&plane.mu_kinetic=0.5"


@pytest.mark.parametrize(
    ("query", "of", "wrt", "sentence"),
    [
        (HOP, "takeoff.colour", "plane.mu", "an event has t, x"),
        (HOP, "leap.t", "plane.mu", "is no quantity"),
        (HOP, "nothing", "plane.mu", "is no quantity"),
        (HOP, "takeoff[3].t", "plane.mu", "has 1 takeoff"),
        (HOP, "stick.t", "plane.colour", "plane.colour is not a parameter"),
        (HOP, "stick.t", "plane.impact_law", "is not a number that the motion depends on"),
        (HOP, "stick.t", "contact.max_events", "is not a number that the motion depends on"),
        (HOP, "at(9).angle", "plane.mu", r"from 0 to the motion's end"),
        (HOP, "at(soon).angle", "plane.mu", "is no time in seconds"),
        (HOP, "at(0.1).t", "plane.mu", "a time has x"),
        (HOP, "hop.colour", "plane.mu", "a hop has height"),
        (HOP, "hop[1].height", "plane.mu", "has 1 hop"),
        (HOP, [], "plane.mu", "at least one"),
        (HOP, "stick.t", ["plane.mu", "plane.mu"], "none twice"),
        (HOP, "stick.t", "hoop.parts.0.mass", "has 0 parts"),
        ("duration=0.5", "revolutions_to_rolling", "start.speed", "does not end in rolling"),
        *((FREE, "end.x", path, "is not what this") for path in ("hoop.load_fraction", "start.speed", "plane.mu")),
        (PARTS, "end.x", "hoop.mass", "mass follows from"),
        ("plane.mu=inf&duration=0.1", "end.x", "plane.mu", "inf has no derivative"),
        ("contact.model=compliant&duration=0.01", "end.x", "plane.mu", "rigid contact"),
        (
            "hoop.load_fraction=1&start.speed=1&duration=0.2", "end.x", "plane.rolling_resistance",
            "the massless hoop, which can have none of it",
        ),
    ],
)  # fmt: skip
def test_what_is_refused(query, of, wrt, sentence):
    parts = hh.Scenario(hoop=hh.Hoop.from_parts(1.0, [hh.Ring(1.0, 0.9, 1.0)]), duration=0.5)
    motion = hh.simulate(parts if query == PARTS else hh.Scenario.from_query(query))
    with pytest.raises(ValueError, match=sentence):
        motion.sensitivity(of, wrt)


def test_a_result_reads_as_text_and_as_json():
    result = hh.simulate(hh.Scenario(duration=2.0)).sensitivity(
        ["hop.height", "takeoff.angle"], ["plane.mu", "plane.mu_static"]
    )
    text = str(result).splitlines()
    assert len(text) == 4
    assert text[0].startswith("hop.height")
    assert "none, the parameter is at the edge" in text[1]
    told = result.to_dict()
    assert told["derivatives"][0]["derivative"] == result["hop.height", "plane.mu"]
    assert told["derivatives"][1]["derivative"] is None
    assert told["derivatives"][1]["larger"] == result.larger[0, 1]
    assert told["quantities"][1] == {"of": "takeoff.angle", "value": result.values[1], "unit": "rad"}
    assert result.relative()[1, 0] == pytest.approx(result["takeoff.angle", "plane.mu"] / result.values[1])
    with pytest.raises(KeyError, match="was not asked for"):
        result["hop.height", "start.speed"]
