"""Proofs against motions that were computed otherwise: reference data to 25 digits, and the kernel."""

from __future__ import annotations

import json
import time
from fractions import Fraction
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.prove import check, prove
from oracle_program import scenario_of
from prove_tools import NUMBERS, contradiction
from random_scenarios import draw
from random_scenarios import scenario_of as random_scenario

pytest.importorskip("flint")

DATA = Path(__file__).resolve().parents[1] / "data"
HOP = hh.Scenario(duration=2.0)
SEED = 2026
EVENTS = 40
PATIENCE = 600.0  # s, for one motion
QUICK = [0, 1, 2, 3, 6, 8, 9, 10, 11, 16, 18, 19, 21, 22, 25, 26, 28, 30, 83, 129]


class Case:
    """The scenario's numbers in a file of reference data."""

    def __init__(self, name: str) -> None:
        self.data = json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))
        self.__dict__.update(self.data["case"])


REFERENCES = ["slope_10deg", "static_above_kinetic", "rolling_back", "general_body", "spinning_start"]
MORE = [
    "article_v3.1_mu1", "article_v0.1_mu0.3", "article_v2.8_mu1", "article_v2_mu1", "immediate_hop", "skidding_start",
    "scaled_body", "dropped_with_spin", "spinning_start_hops_at_once",
]  # fmt: skip


@pytest.mark.parametrize("name", [*REFERENCES, *(pytest.param(name, marks=pytest.mark.slow) for name in MORE)])
def test_the_reference_lies_in_the_enclosures(name):
    """The oracles integrate in time, in mpmath: nothing of a proof is in them."""
    case = Case(name)
    proof = prove(scenario_of(case), 15)
    assert proof.proved, proof.why
    events = [event for event in proof.events if event.kind not in ("apex", "rest")]
    expected = [event for event in case.data["events"] if event["kind"] not in ("apex", "rest")]
    said = [(e["kind"], None if e["kind"] == "start" else e["from"], e["to"]) for e in expected]
    found = [(e.kind, None if e.kind == "start" else e.from_mode, e.to_mode) for e in events]
    assert found[: len(said)] == said[: len(found)]
    for event, one in zip(events, expected, strict=False):
        for number in NUMBERS:
            assert getattr(event, number).holds(Fraction(one[number])), (event.kind, number)


def test_as_many_digits_as_asked():
    """Thirty digits of the take-off, as the oracle has 25 of them, and enclosures that get narrower."""
    rough, fine = (prove(HOP, digits) for digits in (8, 30))
    assert (rough.digits_proved, fine.digits_proved) == (8, 30)
    one = next(event for event in fine.events if event.kind == "takeoff")
    assert one.angle.radius < Fraction(1, 10**28)
    assert str(one.angle.middle).startswith("5.508908425381762464555592")
    for a, b in zip(rough.events, fine.events, strict=True):
        assert all(getattr(a, name).holds(getattr(b, name).middle) for name in NUMBERS)


def test_eighteen_digits_of_the_hop_take_less_than_a_second():
    """Of processor time, the checker included."""
    times = []
    for _ in range(3):
        begin = time.process_time()
        assert prove(HOP, 18).digits_proved == 18
        times.append(time.process_time() - begin)
    assert min(times) < 1.0


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


def test_sixty_digits_of_the_hop():
    """The checker finds the angle at the end of the time to as many digits as are asked for."""
    proof = prove(HOP, 60)
    assert (proof.verdict, proof.digits_proved) == ("proved", 60), proof.why
    assert all(event.x.radius < Fraction(1, 10**58) for event in proof.events)


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


def test_a_proof_that_takes_too_long_is_given_up():
    """A ring of 10⁻⁸ of the mass needs some hundred bits, and minutes."""
    _, sections = draw(SEED, 175)
    begin = time.monotonic()
    proof = prove(random_scenario(sections, max_events=EVENTS), 10, max_events=EVENTS, seconds=0.5)
    assert (proof.verdict, proof.why) == ("undecided", "there was no time for it")
    assert time.monotonic() - begin < 20
    with pytest.raises(ValueError, match="seconds"):
        prove(HOP, 10, seconds=0.0)


def contradicted(index: int) -> str:
    """What `contradiction` says of a random motion."""
    _, sections = draw(SEED, index)
    return contradiction(random_scenario(sections, max_events=EVENTS), EVENTS, PATIENCE)


@pytest.mark.parametrize("index", QUICK)
def test_random_motion(index):
    """Twenty of every kind that take no longer than a second."""
    assert contradicted(index) == ""


@pytest.mark.slow
def test_two_hundred_random_motions():
    """No proof contradicts the kernel, and at least 95 % are proved."""
    found = {index: contradicted(index) for index in range(200)}
    assert {index: said for index, said in found.items() if said not in ("", "undecided")} == {}
    assert list(found.values()).count("undecided") <= 10


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
