"""The command that changes the source and looks whether a test sees it."""

from __future__ import annotations

import gc
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from scipy.stats import binomtest

import mutations
from hophoop.kernel.physics import slip

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
    found = _functions({slip.__file__})
    gc.freeze()  # as it was
    assert slip.slip_displacement in found[slip.__file__, "slip_displacement"]  # Numba may have copies


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


def test_rooms_that_were_not_tried_here_keep_their_rows(tmp_path, monkeypatch):
    monkeypatch.setattr(mutations, "RESULTS", tmp_path)
    before = Path(__file__).parents[1].joinpath("docs/tables/mutations.md").read_text(encoding="utf-8")
    kept = mutations.rows_of(before)
    assert set(kept) == set(mutations.ROOMS)
    seen = {"module": "slip", "status": "seen", "explained": False, "on": "2026-01-02"}
    tried = {"room": "rigid", "there": 1, "found": [seen]}
    rows = mutations.rows_of(mutations.table([tried], before))
    assert list(rows) == list(mutations.ROOMS)
    assert [row.replace(mutations.UNBROKEN, "-") for row in rows.pop("rigid")] == [
        "| **rigid** | **1** | **1** | 0 | 0 | **100.0 %** | 2026-01-02 |",
        "| &nbsp;&nbsp;slip | 1 | 1 | 0 | 0 | 100.0 % | 2026-01-02 |",
    ]
    assert all(rows[name] == kept[name] for name in rows)
    assert sum(map(len, rows.values())) > 40
