"""Proofs against motions that were computed otherwise: reference data to 25 digits, and the kernel."""

import json
import time
from decimal import Decimal, localcontext
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.physics.contact import most_resistance
from hophoop.prove import prove
from oracle_program import highest_apexes, scenario_of
from oracles.cases import Case
from prove_tools import NUMBERS, are_enclosed, contradiction
from random_scenarios import draw
from random_scenarios import scenario_of as random_scenario

pytest.importorskip("flint")

DATA = Path(__file__).resolve().parents[1] / "data"
HOP = hh.Scenario(duration=2.0)
EVENTS = 40


REFERENCES = sorted(path.stem for path in DATA.glob("*.json") if '"case"' in path.read_text(encoding="utf-8"))
LONG = (
    "reversal_in_impact", "skidding_start", "static_above_kinetic", "accumulation_newton", "accumulation_poisson",
    "article_v2.8_mu1", "bounces_newton", "bounces_stronge", "bounces_poisson", "dropped_with_spin", "frictionless_fast",
    "narrow_escape_slope",
)  # fmt: skip


@pytest.mark.parametrize("name", [pytest.param(one, marks=[pytest.mark.long] * (one in LONG)) for one in REFERENCES])
def test_the_references_lie_in_the_enclosures(name):
    """The oracles integrate in time, in mpmath: nothing of a proof is in them. They have 25 digits, after ten events 22."""
    data = json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))
    true = data["events"]
    if any(event["kind"] == "apex" for event in true):
        true = highest_apexes([{**event, "height": Fraction(event["height"])} for event in true])
    # to the end of these bounces a proof takes minutes; bounces_stronge is closed under the same law
    most = 120 if name == "accumulation_stronge" else EVENTS * 20
    proof = prove(scenario_of(Case(**data["case"])), 15, max_events=most)
    assert proof.proved, proof.why
    rounded = Fraction(1, 10**21)
    assert are_enclosed(proof, [event for event in true if event["kind"] != "kane_gain"], rounded) >= 14
    if proof.status != "event_limit" and not any(event.kind == "bounce_limit" for event in proof.events):
        for loss in ("friction", "impact_normal", "impact_tangential"):
            known, exact = getattr(proof.events[-1], loss), Fraction(data["energy"][loss])
            assert abs(Fraction(known.middle) - exact) <= Fraction(known.radius) + rounded * max(1, abs(exact)), loss


@pytest.mark.parametrize("plane", [
    {"mu": 0.3, "restitution": 0.4, "slope": 0.1}, {"mu": 0.8, "restitution": 0.6, "impact_law": "poisson"},
    {"mu": 0.8, "restitution": 0.6, "impact_law": "newton"}, {"mu_static": 0.6, "mu_kinetic": 0.4, "rolling_resistance": 0.05},
])  # fmt: skip
def test_forty_digits_lie_in_the_enclosures(plane):
    """With apex, velocities before, impulses and losses, for each law, on slopes and with resistance."""
    start = hh.Start(height=0.3, vx=2.0, omega=4.0, angle=0.5)
    scenario = hh.Scenario(plane=hh.Plane(**plane), start=start, duration=1.0, contact=hh.Rigid(max_events=14))
    true = [
        {**vars(event), "before": vars(event.before), "to": event.to_mode} for event in hh.simulate(scenario, digits=40).events
    ]
    for event in true:
        event["impulse"] = {"normal": event["impulse_normal"], "tangential": event["impulse_tangential"]}
    assert are_enclosed(prove(scenario, 15), true, Fraction(1, 10**36)) > 100


def test_as_many_digits_as_asked():
    """Sixty digits of the take-off, as the oracle has 25 of them, and enclosures that get narrower."""
    rough, fine = (prove(HOP, digits) for digits in (8, 60))
    assert (rough.digits_proved, fine.digits_proved) == (8, 60)
    one = next(event for event in fine.events if event.kind == "takeoff")
    assert str(one.angle.middle).startswith("5.508908425381762464555592")
    for a, b in zip(rough.events, fine.events, strict=True):
        assert b.x.radius < Fraction(1, 10**58)
        assert all(getattr(a, name).holds(getattr(b, name).middle) for name in NUMBERS)


def test_what_is_not_covered_stays_undecided():
    proof = prove(hh.Scenario(hoop=hh.Hoop.ideal(1.0)), 10)
    assert (proof.verdict, proof.events) == ("undecided", ())
    assert "massless" in proof.why


@pytest.mark.slow
def test_a_jam_stays_undecided_and_says_where():
    """The slip runs into p_σ = 0, where the contact force has no bound; what comes before it is proved."""
    scenario = hh.Scenario.from_query(
        "duration=1&plane.mu_static=1.219&plane.mu_kinetic=1.21&start.angle=-2.312&start.vx=30.37&start.omega=5.654"
    )
    assert hh.simulate(scenario).status == "jammed"
    proof = prove(scenario, 5)
    assert (proof.verdict, [event.kind for event in proof.events]) == ("undecided", ["start"])
    assert "p_σ = 0" in proof.why


def test_bad_input_is_refused():
    for wrong in (0, 201, 1.5, True):
        with pytest.raises(ValueError, match="digits"):
            prove(HOP, wrong)
    with pytest.raises(ValueError, match="until"):
        prove(HOP, 10, until="tomorrow")
    with pytest.raises(ValueError, match="rigid"):
        prove(hh.Scenario(contact=hh.Compliant()), 10)


def random_motion(seed, index):
    """A random motion; of the second seed with a rolling resistance from 3·10⁻⁴ to 0.5, within what the hoop allows."""
    sections = draw(seed, index)
    if seed == 2027:
        random = np.random.default_rng([seed, index, 2])
        hoop = hh.Hoop(**sections["hoop"])
        most = min(0.9 * most_resistance(hoop.eccentricity, hoop.inertia_ratio), 1.0)
        sections["plane"]["rolling_resistance"] = float(min(10 ** random.uniform(-3.5, -0.3), most))
    return random_scenario(sections, max_events=EVENTS)


def test_a_proof_that_takes_too_long_is_given_up():
    """A ring of 10⁻⁸ of the mass needs some hundred bits, and minutes."""
    begin = time.monotonic()
    hoop = hh.Hoop.ideal(0.999999995406766)
    scenario = hh.Scenario(
        hoop=hoop, plane=hh.Plane(mu=1.1, impact_law="newton"), start=hh.Start(angle=4.0, vx=0.04, omega=-10.7)
    )
    proof = prove(scenario, 10, max_events=EVENTS, seconds=0.5)
    assert (proof.verdict, proof.why) == ("undecided", "there was no time for it")
    assert time.monotonic() - begin < 20
    with pytest.raises(ValueError, match="seconds"):
        prove(HOP, 10, seconds=0.0)


QUICK = {
    2026: (0, 1, 2, 3, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 19, 20, 22, 24, 25),
    2027: (0, 1, 2, 3, 4, 5, 6, 7, 9, 10, 11),
}


@pytest.mark.parametrize(("seed", "index"), [(seed, index) for seed, indices in QUICK.items() for index in indices])
def test_random_motion(seed, index):
    """Of every kind, those that take no longer than a second."""
    assert contradiction(random_motion(seed, index), EVENTS) == ""


@pytest.mark.parametrize("speed", [1.0, 2.5])
def test_a_revolution_ends_at_its_angle(speed):
    """Also where it ends in another phase than the first."""
    found = prove(hh.Scenario(start=hh.Start.rolling(speed, angle=0.25)), 25, until="revolution")
    assert (found.verdict, found.ending) == ("proved", "revolutions")
    with localcontext() as context:
        context.prec = 40
        assert found.events[-1].angle.holds(2 * Decimal("3.14159265358979323846264338327950288419717") + Decimal("0.25"))
    assert found.events[-1].angle.radius < Fraction(1, 10**24)


def test_turns_that_are_counted_at_once_are_as_turns_one_by_one():
    """On the level all turns are equal; 40 digits take every one of them."""
    scenario = hh.Scenario(start=hh.Start.rolling(1.5), duration=20.0)
    true = hh.simulate(scenario, digits=30).events[-1]
    end = prove(scenario, 20).events[-1]
    assert all(getattr(end, name).holds(getattr(true, name)) for name in ("x", "angle", "vx", "omega"))
    assert end.angle.middle > 40


@pytest.mark.long
def test_every_sequence_of_the_catalogue_exists():
    for entry in hh.maps.catalogue():
        proof = prove(entry.scenario(), 3, until="revolution")
        assert (proof.verdict, proof.sequence, proof.ending) == ("proved", entry.sequence, entry.ending), proof.why
