"""Proofs against motions that were computed otherwise: reference data to 25 digits, and the kernel."""

from __future__ import annotations

import json
import time
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.physics.contact import most_resistance
from hophoop.prove import check, prove
from oracle_program import scenario_of
from oracles.cases import Case
from prove_tools import NUMBERS, are_enclosed, contradiction
from random_scenarios import draw
from random_scenarios import scenario_of as random_scenario

pytest.importorskip("flint")

DATA = Path(__file__).resolve().parents[1] / "data"
HOP = hh.Scenario(duration=2.0)
EVENTS = 40


@pytest.mark.parametrize("name", ["slope_10deg", "static_above_kinetic", "rolling_back", "general_body", "spinning_start"])
def test_the_reference_lies_in_the_enclosures(name):
    """The oracles integrate in time, in mpmath: nothing of a proof is in them."""
    data = json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))
    are_enclosed(prove(scenario_of(Case(**data["case"])), 15), data["events"])


def test_as_many_digits_as_asked():
    """Sixty digits of the take-off, as the oracle has 25 of them, and enclosures that get narrower."""
    rough, fine = (prove(HOP, digits) for digits in (8, 60))
    assert (rough.digits_proved, fine.digits_proved) == (8, 60)
    one = next(event for event in fine.events if event.kind == "takeoff")
    assert str(one.angle.middle).startswith("5.508908425381762464555592")
    for a, b in zip(rough.events, fine.events, strict=True):
        assert b.x.radius < Fraction(1, 10**58)
        assert all(getattr(a, name).holds(getattr(b, name).middle) for name in NUMBERS)


def test_a_graze_is_no_event():
    """Without gravity, from θ = 0 with ẏ = 0, the rim comes back to the plane once a turn with ẏ = 0, and never lands."""
    start = hh.Start(angle=0.0, vx=1.0, omega=3.0)
    proof = prove(hh.Scenario(plane=hh.Plane(gravity=0.0), start=start, duration=5.0), 10)
    assert (proof.verdict, proof.sequence) == ("proved", "H")
    assert not [event for event in proof.events if event.kind == "impact"]


def test_what_is_not_covered_stays_undecided():
    proof = prove(hh.Scenario(hoop=hh.Hoop.ideal(1.0)), 10)
    assert (proof.verdict, proof.certificate) == ("undecided", None)
    assert "massless" in proof.why


@pytest.mark.slow
def test_a_jam_stays_undecided_and_says_where():
    """The slip runs into p_σ = 0, where the contact force has no bound; what comes before it is proved."""
    start = hh.Start(angle=-2.312, vx=30.37, omega=5.654)
    scenario = hh.Scenario(plane=hh.Plane(mu_static=1.219, mu_kinetic=1.21), start=start, duration=1.0)
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
    with pytest.raises(ValueError, match="no certificate"):
        prove(hh.Scenario(hoop=hh.Hoop.ideal(1.0)), 10).save("nowhere.json")


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


@pytest.mark.long
def test_every_sequence_of_the_catalogue_exists():
    """The kept certificates are accepted, and are about the classes of the catalogue, none left out."""
    classes = set()
    for path in sorted((DATA / "proofs").glob("*.json")):
        certificate = json.loads(path.read_text(encoding="utf-8"))
        verdict = check(certificate)
        assert verdict.accepted, (path.name, verdict.why)
        assert certificate["scenario"]["hoop"] == {"radius": 1.0, "mass": 1.0, "load_fraction": 0.75}
        assert certificate["until"] == "revolution"
        classes.add((certificate["sequence"], certificate["ending"]))
    assert classes == {(entry.sequence, entry.ending) for entry in hh.maps.catalogue()}
