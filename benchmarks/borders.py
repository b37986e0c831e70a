"""Starts within a few roundings of a border that theory knows: what `simulate` answers, against 20 digits.

    python benchmarks/borders.py                       # a thousand
    python benchmarks/borders.py --motions 200 --jobs 2 --markdown docs/tables/borders.md

Each motion is computed by `simulate`, which asks for more digits where doubles cannot tell, and independently of that
in 20 digits. A sequence that the longer computation refutes is listed.
"""

from __future__ import annotations

import argparse
import collections
import multiprocessing
import sys
import time
from collections.abc import Iterable
from itertools import groupby
from pathlib import Path
from typing import Any

import hophoop as hh
from hophoop.precise import solve
from hophoop.simulation import exact_start
from hophoop.vocabulary.modes import MODE_LETTERS

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests"))
from random_scenarios import BORDERS, draw_beside_a_border, scenario_of

COLUMNS = ("motions", "decided in more digits", "undetermined", "checked", "refuted", "ledger above 1e-11")
MOST_STEPS = 200_000  # of the longer computation, at 106 bits; what needs more, beside Painlevé's threshold, is not checked


def letters(events: Iterable[tuple[str, str]]) -> str:
    """Modes in order, from (kind, mode after it); a sequence of bounces is one H, however many of them are counted."""
    found = [mode for kind, mode in events if kind not in ("rest", "turn", "apex", "jam")]
    return "".join(mode for mode, _ in groupby(found))


def work(task: tuple[int, int]) -> tuple[str, dict[str, int], str]:
    """One motion: its border, what it counts for, and a line where it is refuted."""
    seed, index = task
    border, sections = draw_beside_a_border(seed, index)
    scenario = scenario_of(sections)
    asked = []
    decide = exact_start.script_until

    def noted(*arguments: Any) -> Any:
        asked.append(arguments)
        return decide(*arguments)

    exact_start.script_until = noted
    try:
        motion = hh.simulate(scenario)
    finally:
        exact_start.script_until = decide
    ours = letters((event.kind, event.to_mode) for event in motion.events)
    truth = None
    try:
        solution = solve(scenario, 20, most_steps=MOST_STEPS)
        truth = letters((record.kind.name.lower(), MODE_LETTERS[record.after_mode]) for record in solution.records)
    except ArithmeticError:
        pass
    same = truth is None or ours == truth
    counts = {
        "motions": 1,
        "decided in more digits": int(bool(asked)),
        "undetermined": int(motion.status == "undetermined"),
        "checked": int(truth is not None),
        "refuted": int(not same),
        "ledger above 1e-11": int(not abs(motion.ledger.residual) <= 1e-11 * motion.ledger.range),
    }
    line = "" if same else f"{index} {border}: {ours}, but {truth}"
    return border, counts, line


def markdown(counts: dict[str, collections.Counter[str]], seconds: float, seed: int, jobs: int) -> str:
    """The table of docs/testing.md."""
    total = sum(counts[border]["motions"] for border in counts)
    lines = [
        f"{total:,} starts of seed {seed}, within 4 units in the last place of a border, in {seconds:.0f} s "
        f"with {jobs} processes.",
        "",
        "| border | " + " | ".join(COLUMNS) + " |",
        "| --- " * (1 + len(COLUMNS)) + "|",
    ]
    for border in BORDERS:
        if border in counts:
            lines.append(f"| {border} | " + " | ".join(f"{counts[border][name]:,}" for name in COLUMNS) + " |")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--motions", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--jobs", type=int, default=multiprocessing.cpu_count())
    parser.add_argument("--markdown", metavar="FILE", help="write the table there")
    options = parser.parse_args()
    begin = time.perf_counter()
    counts: dict[str, collections.Counter[str]] = collections.defaultdict(collections.Counter)
    tasks = [(options.seed, index) for index in range(options.motions)]
    refuted = []
    with multiprocessing.get_context("spawn").Pool(options.jobs) as pool:
        for done, (border, found, line) in enumerate(pool.imap_unordered(work, tasks, chunksize=8), 1):
            counts[border].update(found)
            if line:
                refuted.append(line)
            if done % 50 == 0:
                print(f"{done} of {options.motions}", file=sys.stderr, flush=True)
    text = markdown(counts, time.perf_counter() - begin, options.seed, options.jobs)
    print(text + "\n".join(refuted))
    if options.markdown:
        Path(options.markdown).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
