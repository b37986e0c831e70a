"""The kept scenarios of data/bits have the kept bits: events, samples and ledgers, compiled and interpreted.

benchmarks/bits.py tries other surroundings, such as an older processor; tests/module has the module and other processors.
"""

import bits_tools
import hophoop as hh
from bits_tools import differing, kept_hashes, kept_scenarios, of_kinds
from checkout import text_of
from hophoop.kernel.native import forced

SAY = "bits have changed: python tests/data/bits/generate.py, and a line in CHANGELOG.md"


def computed(kept, mode):
    with forced(mode):
        return {each.index: bits_tools.bits_of(hh.simulate(each.scenario)) for each in kept}


def test_all_bits_are_the_kept_ones():
    found = computed(kept_scenarios(), "compiled")
    assert differing(found) == [], SAY
    assert bits_tools.hashes_text(list(found.values())) == bits_tools.HASHES.read_text(encoding="utf-8"), SAY


def test_interpreted_motions_have_the_kept_bits():
    kept = of_kinds(kept_scenarios(every=24), "rigid", "border", "paradox", "resisted", "massless")
    assert len(kept) > 35
    assert differing(computed(kept, "interpreted")) == []


def test_the_changelog_names_the_kept_bits():
    """Bits do not change without a line that says so."""
    assert f"`{kept_hashes()['events'][:12]}`" in text_of("CHANGELOG.md")
