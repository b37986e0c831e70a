"""The command that changes the source and looks whether a test sees it."""

from __future__ import annotations

import gc
import json
import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from scipy.stats import binomtest

import mutations
from hophoop.kernel.physics import closed_forms
from mutants import SOURCE, Key, mutants
from mutations_explained import EXPLAINED, Entry, explained

READS = "import os; from mutation_reach import silence\nwith silence(): os._exit(len(os.read(0, 1)))"


@pytest.mark.skipif(os.name != "posix", reason="forks")
def test_a_change_that_reads_from_the_terminal_does_not_wait_for_it():
    """As where '-' is no longer told from a path: the run stood still for minutes at each such change."""
    words = [sys.executable, "-c", READS]
    with subprocess.Popen(words, stdin=subprocess.PIPE, cwd=Path(__file__).parent) as process:
        assert process.wait(timeout=20.0) == 0  # nothing is written to it, nor is it closed


@pytest.mark.skipif(os.name != "posix", reason="forks")
def test_a_kernel_that_was_imported_as_tests_were_collected_is_found():
    from mutation_runs import _functions

    gc.freeze()
    found = _functions({closed_forms.__file__})
    gc.freeze()  # as it was
    assert closed_forms.slip_displacement in found[closed_forms.__file__, "slip_displacement"]  # Numba may have copies


@pytest.mark.parametrize(("seen", "tried"), [(0, 10), (7, 10), (380, 400), (400, 400)])
def test_the_range_of_a_share(seen, tried):
    expected = binomtest(seen, tried).proportion_ci(0.95, "wilson")
    assert mutations.interval(seen, tried) == pytest.approx((expected.low, expected.high), abs=1e-6)


def test_the_table_keeps_rooms_that_were_tried_before(tmp_path, monkeypatch):
    monkeypatch.setattr(mutations, "RESULTS", tmp_path)
    seen = {"module": "slip", "status": "seen", "explained": False, "on": "2026-01-02"}
    told = {"module": "roll", "status": "unseen", "explained": True, "on": "2026-01-01"}
    for name, there, found in (("io", 2, [seen, told]), ("physics", 9, [seen, told, {**told, "explained": False}])):
        mutations.file_of(name).write_text(json.dumps({"room": name, "there": there, "found": found}), encoding="utf-8")
    rows = mutations.table(mutations.last_results()).replace(mutations.UNBROKEN, "-").splitlines()[4:]
    low, high = (100.0 * end for end in mutations.interval(2, 3))
    assert rows == [
        f"| **physics** | **3 of 9** | **1** | 1 | 1 | **66.7 %** ({low:.1f} to {high:.1f} %) | 2026-01-01 |",
        "| &nbsp;&nbsp;roll | 2 | 0 | 1 | 1 | 50.0 % | 2026-01-01 |",
        "| &nbsp;&nbsp;slip | 1 | 1 | 0 | 0 | 100.0 % | 2026-01-02 |",
        "| **io** | **2** | **1** | 1 | 0 | **100.0 %** | 2026-01-01 |",
        "| &nbsp;&nbsp;roll | 1 | 0 | 1 | 0 | 100.0 % | 2026-01-01 |",
        "| &nbsp;&nbsp;slip | 1 | 1 | 0 | 0 | 100.0 % | 2026-01-02 |",
    ]


MODULE = """
def first(x):
    return x + 1.0 - (2.0 if x < 3.0 else x)


class Second:
    def third(self):
        return [k for k in range(5) if k < 4 and k < 2]
"""


def test_a_change_keeps_its_name_when_lines_move_or_have_other_names(tmp_path, monkeypatch):
    monkeypatch.setattr("mutants.SOURCE", tmp_path)
    path = tmp_path / "folder" / "module.py"
    path.parent.mkdir()
    path.write_text(MODULE, encoding="utf-8")
    before = {one.key: one.changed for one in mutants(path)}
    assert before[Key("folder/module", "first", "NumberReplacer", 4)] == "return x + 1.0 - ( 1.0 if x < 3.0 else x)"
    assert before[Key("folder/module", "Second.third", "Lt_LtE", 2)] == "return [k for k in range(5) if k < 4 and k <= 2]"
    renamed = (
        MODULE.replace("x", "speed").replace(" + 1.0", "\\\n        + 1.0").replace("def first", "A = None\n\n\ndef first")
    )
    path.write_text(renamed, encoding="utf-8")
    after = {one.key: one.changed for one in mutants(path)}
    assert set(after) == set(before)
    assert after[Key("folder/module", "first", "NumberReplacer", 4)] == "+ 1.0 - ( 1.0 if speed < 3.0 else speed)"
    chosen = [one.key for one in mutants(path, {("Second.third", "Lt_LtE")})]
    assert chosen == [key for key in after if key[1:3] == ("Second.third", "Lt_LtE")]


def test_explanations_are_read():
    text = '["a reason"]\n"a/b:f" = { Lt_LtE = "1 3 of 4" }\n"a/b" = { AddNot = "2 of 2" }\n'
    entry = Entry("a reason", 4)
    assert explained(text) == {
        Key("a/b", "f", "Lt_LtE", 1): entry,
        Key("a/b", "f", "Lt_LtE", 3): entry,
        Key("a/b", "", "AddNot", 2): Entry("a reason", 2),
    }
    with pytest.raises(ValueError, match="a/b:f has Lt_LtE 3 twice: a reason; another"):
        explained(text + '["another"]\n"a/b:f" = { Lt_LtE = "3 of 4" }\n')


@pytest.mark.long
@pytest.mark.parametrize("module", sorted({key.module for key in EXPLAINED}))
def test_every_explanation_is_of_a_change_that_there_is(module):
    path = SOURCE / f"{module}.py"
    assert any(path in mutations.paths_of(room) for room in mutations.ROOMS.values())
    entries = {key: entry for key, entry in EXPLAINED.items() if key.module == module}
    counts = Counter(one.key[:3] for one in mutants(path, {key[1:3] for key in entries}))
    wrong = {
        f"{key.function} has {counts[key[:3]]} changes by {key.operator}, not {entry.count}"
        for key, entry in entries.items()
        if not 1 <= key.ordinal <= entry.count == counts[key[:3]]
    }
    assert not wrong, "look at these entries of mutations_explained.toml again"
