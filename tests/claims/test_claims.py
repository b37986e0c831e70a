"""The claims of the literature: our numbers, computed anew and by hand, and what happens where one no longer holds."""

import dataclasses
import json
import math
import re
from pathlib import Path

import pytest
from pydantic import ValidationError
from typer.testing import CliRunner

import hophoop as hh
from hophoop.article.verdicts import AGREES, DIFFERS, FAILS, NOT_READ, VERDICTS
from hophoop.cite import references
from hophoop.claims import numbers, registry
from hophoop.claims.claim import check_claim, decimals, with_unit
from hophoop.claims.literature import FROM_ARTICLE, claims_of
from hophoop.claims.pages import END, fill_tables, works_of
from hophoop.cli import app
from hophoop.cli._tables import VERDICT_STYLES

PAGE = (Path(__file__).parents[2] / "docs" / "literature.md").read_text(encoding="utf-8")
CLAIMS = registry()
G = 9.81


# Numbers


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.key)
def test_our_number_comes_out_again(claim):
    found = check_claim(claim)
    assert (found.verdict, found.holds) == (claim.verdict, True)
    assert found.ours == f"{claim.quantity} {with_unit(claim.ours, claim.unit)}"


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.key)
def test_a_number_that_is_off_by_one_digit_fails(claim):
    places = decimals(claim.ours)
    for step in (-1, 1):
        off = dataclasses.replace(claim, ours=f"{float(claim.ours) + step * 10.0**-places:.{places}f}")
        found = check_claim(off)
        assert (found.verdict, found.holds) == (FAILS, False)
        assert with_unit(off.ours, off.unit) in found.why


@pytest.mark.parametrize("claim", [one for one in CLAIMS if one.theirs_number is not None], ids=lambda claim: claim.key)
def test_a_verdict_follows_from_the_number_of_the_work(claim):
    apart = claim.theirs_number + 2.0 * claim.reading + 1.0 if claim.verdict == AGREES else float(claim.ours)
    assert check_claim(dataclasses.replace(claim, theirs_number=apart)).verdict == FAILS


def test_a_motion_without_the_event_fails():
    lost = dataclasses.replace(CLAIMS[0], compute=lambda: numbers._skimming().find("takeoff")[0].t)
    found = check_claim(lost)
    assert (found.verdict, found.ours, found.value) == (FAILS, "–", None)


def test_numbers_by_hand():
    assert numbers.massless_skim_angle() == pytest.approx(math.degrees(math.acos(1e-6 / G)), abs=1e-9)
    assert numbers.massless_fall() == pytest.approx((math.sqrt(3.0) - 1.0) / math.sqrt(G), abs=2e-6)
    assert numbers.massless_hop_speed() == pytest.approx(math.sqrt(G), rel=1e-14)
    assert numbers.immediate_hop_speed() == pytest.approx(math.sqrt(G / 0.75), rel=1e-14)
    assert numbers.painleve_friction() == pytest.approx(math.sqrt(1.0 - 0.75**2) / 0.75, rel=1e-14)
    assert numbers.routh_reversal() == pytest.approx(115.0 / 97.0, rel=1e-12)
    assert numbers.kane_gain() == pytest.approx(257.0 / 448.0, rel=1e-12)
    assert numbers.stronge_separation() == pytest.approx(math.sqrt(20631.0) / 52.0, rel=1e-12)
    assert numbers.jam_angle() == pytest.approx(numbers.jam_angle_of_theory(), abs=1e-9)


def test_the_first_hop_is_that_of_theory():
    assert numbers.first_hop_speed() == pytest.approx(float(hh.theory.first_hop_speed(numbers.HOOP, numbers.PLANE)), abs=5e-9)


def test_the_force_at_the_quasi_jump_by_newton():
    """N of rolling from energy and Newton's law alone, at our angle, is zero: R = m = 1."""
    theta, gamma, v0, step = math.radians(numbers.quasi_jump_angle()), 0.75, 3.1, 1e-5

    def square(angle):
        return (gamma * G * (1.0 - math.cos(angle)) + v0**2 * (1.0 + gamma)) / (1.0 + gamma * math.cos(angle))

    acceleration = (square(theta + step) - square(theta - step)) / (4.0 * step)
    normal = G - gamma * (acceleration * math.sin(theta) + square(theta) * math.cos(theta))
    assert normal == pytest.approx(0.0, abs=1e-7)
    free = gamma * square(theta) * math.cos(theta) - G
    assert numbers.quasi_jump_free_acceleration() == pytest.approx(free, rel=1e-10)


# The registry


def test_keys_works_and_verdicts():
    assert len({claim.key for claim in CLAIMS}) == len(CLAIMS) >= 30
    assert set(hh.claims.works()) <= set(references())
    assert set(VERDICT_STYLES) == set(VERDICTS)
    for claim in CLAIMS:
        assert claim.verdict in VERDICTS
        assert claim.verdict != FAILS
        assert all((claim.claim, claim.theirs, claim.quantity, claim.ours, claim.why)), claim.key
        assert claim.verdict not in (DIFFERS,) or len(claim.why) > 30


ENTRY = """
[hop]
work = "Littlewood1953"
claim = "It hops."
theirs = "hop"
quantity = "the rim rises by"
ours = "0.000000"
unit = "m"
verdict = "differs"
why = "Nothing lifts it."
compute = "massless_height"
"""


def test_a_claim_is_read_from_toml():
    (claim,) = claims_of(ENTRY)
    assert (claim.key, claim.compute, claim.theirs_number, claim.reading) == ("hop", numbers.massless_height, None, 0.0)
    assert claims_of(ENTRY.replace('unit = "m"\n', ""))[0].unit == ""


@pytest.mark.parametrize(
    ("old", "new", "field", "message"),
    [
        ("why =", "because =", "because", "Unexpected keyword argument"),
        ('why = "Nothing lifts it."\n', "", "why", "Field required"),
        ("massless_height", "massless_hight", "compute", "massless_hight is no function of hophoop.claims.numbers"),
        ("massless_height", "_skimming", "compute", "_skimming is no function of hophoop.claims.numbers"),
        ("massless_height", "simulate", "compute", "simulate is no function of hophoop.claims.numbers"),
        ("massless_height", "HOOP", "compute", "HOOP is no function of hophoop.claims.numbers"),
        ("Littlewood1953", "Littlewood1935", "work", "Littlewood1935 is no key of references.bib"),
        ("differs", "differ", "verdict", "differ must be one of agrees, "),
        ('"0.000000"', "0.0", "ours", "valid string"),
        ("0.000000", "none", "ours", "should match pattern"),
        ("\ncompute", '\nreading = "1"\ncompute', "reading", "valid number"),
    ],
)
def test_a_wrong_claim_is_refused(old, new, field, message):
    assert old in ENTRY
    with pytest.raises(ValidationError) as caught:
        claims_of(ENTRY.replace(old, new))
    found = {error["loc"]: error["msg"] for error in caught.value.errors()}
    assert message in found["hop", field]


def test_the_article_is_not_written_down_twice():
    found = hh.claims.findings(["Sonnerlind2023"])
    assert len(found) == len(FROM_ARTICLE) == hh.claims.count(["Sonnerlind2023"])
    assert all(one.holds for one in found)
    assert not any(claim.work == "Sonnerlind2023" for claim in CLAIMS)


def test_progress_counts_to_the_end():
    seen = []
    hh.claims.findings(["Kane1984", "Stronge2000"], lambda done, of: seen.append((done, of)))
    assert seen == [(1, 3), (2, 3), (3, 3)]


# Pages


def test_every_work_is_on_the_page_and_the_table_is_that_of_the_registry():
    assert fill_tables(PAGE) == PAGE, "run python examples/claim_tables.py"
    (mark,) = re.findall(r"^<!-- claims: .+ -->$", PAGE, re.MULTILINE)
    compared = {claim.work for claim in CLAIMS if claim.verdict != NOT_READ}
    assert set(works_of(mark)) == compared
    assert set(hh.claims.works()) <= compared | set(re.findall(r"\{cite:t\}`(\w+)`", PAGE))


def test_the_table_has_what_was_read_of_every_work():
    rows = re.findall(r"^\| (\{cite:t\}`\w+`) \| (.+?) \| .+? \| .+? \| .+? \|$", PAGE, re.MULTILINE)
    assert len(rows) > 15
    assert all(re.match(r"not|title|abstract|in full", read) for _, read in rows)


def test_a_wrong_table_is_made_right():
    text = f"# A\n<!-- claims: Kane1984 (not) -->\n| old |\n{END}\nrest"
    once = fill_tables(text)
    assert "**0.573661 J**. | agrees" in once  # our reasons only where we differ
    assert "old" not in once
    assert once.endswith(f"\n{END}\nrest")
    assert fill_tables(once) == once
    assert fill_tables("# no mark\n") == "# no mark\n"


# The command


def run(*arguments):
    return CliRunner().invoke(app, ["claims", *arguments])


def test_the_table_has_works_numbers_and_verdicts():
    done = run("Littlewood1953", "Kane1984")
    assert done.exit_code == 0
    for text in ("Littlewood1953", "90.000000°", "differs", "0.573661 J"):
        assert text in done.stdout


def test_json_has_every_digit():
    done = run("Kane1984", "--json")
    data = json.loads(done.stdout)
    assert (data["schema"], data["version"], data["holds"]) == ("hophoop-claims/1", hh.__version__, True)
    (one,) = data["claims"]
    assert list(one) == ["key", "work", "claim", "theirs", "ours", "value", "verdict", "why"]
    assert one["value"] == numbers.kane_gain()


def test_json_has_a_word_for_a_number_that_it_does_not_have():
    found = dataclasses.replace(check_claim(CLAIMS[0]), value=math.inf)
    assert found.to_dict()["value"] == "inf"


def test_quiet_prints_nothing():
    done = run("Kane1984", "--quiet")
    assert (done.exit_code, done.stdout, done.stderr) == (0, "", "")


def test_a_number_that_no_longer_holds_ends_with_status_1(monkeypatch):
    wrong = dataclasses.replace(next(one for one in CLAIMS if one.work == "Kane1984"), ours="0.573662")
    monkeypatch.setattr("hophoop.claims.literature.registry", lambda: (wrong,))
    done = run("Kane1984")
    assert done.exit_code == 1
    assert "Numbers of ours that have changed: kane_gain." in done.stderr
    assert json.loads(run("Kane1984", "--json").stdout)["holds"] is False


def test_a_work_without_claims_is_refused():
    done = run("Newton1687")
    assert done.exit_code == 2
    assert done.stderr.startswith("Error: work = Newton1687 must be one of Routh1877, ")
