"""Scenarios over the whole of the supported ranges, as many as asked for, and a table of what came of them.

    python tests/fuzz/night.py --count 100000 --markdown docs/tables/fuzz.md
    python tests/fuzz/night.py --show 4711          # one of them again

Each is computed in a worker process, so that one that hangs or kills its process is found too.
"""

from __future__ import annotations

import argparse
import collections
import multiprocessing
import os
import sys
import time
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

SEED = 2026
HANGS = 300.0  # s without an answer: much more than any takes, since other work may share the machine
FILES = 50  # every so many-th motion is saved and loaded
WORDS = ("completed", "at_rest", "jammed", "undetermined", "event_limit", "refused")


def keys_of(seed: int, index: int) -> dict[str, Any]:
    """The scenario of an index."""
    from fuzz.draws import Seeded, scenario

    return scenario(Seeded(seed, index))


def work(pipe: Connection, seed: int) -> None:
    """Answer indices until there are no more."""
    import hophoop as hh
    from fuzz.checks import outcome

    for contact in (hh.Rigid(), hh.Compliant()):  # compiled or loaded before the clock runs
        hh.simulate(hh.Scenario(contact=contact, duration=0.1)).at(0.05)
    pipe.send(None)
    while (index := pipe.recv()) is not None:
        keys = keys_of(seed, index)
        pipe.send((index, keys["contact"]["model"], outcome(keys, with_file=index % FILES == 0)))


class Worker:
    """A process that computes, and when it was last heard of."""

    def __init__(self, seed: int) -> None:
        self.context = multiprocessing.get_context("spawn")
        self.seed = seed
        self.begin()

    def begin(self) -> None:
        self.pipe, other = self.context.Pipe()
        self.process = self.context.Process(target=work, args=(other, self.seed), daemon=True)
        self.process.start()
        other.close()
        self.pipe.recv()
        self.index: int | None = None
        self.since = time.monotonic()

    def ask(self, index: int) -> None:
        self.index, self.since = index, time.monotonic()
        self.pipe.send(index)

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


def run(count: int, first: int, seed: int, processes: int, seconds: float) -> tuple[list[Any], list[tuple[int, str]], float]:
    """(answers, what failed, wall time in s) of so many scenarios, or of as many as the time allows."""
    began = time.monotonic()
    workers = [Worker(seed) for _ in range(processes)]
    answers: list[Any] = []
    failed: list[tuple[int, str]] = []
    coming = iter(range(first, first + count))
    busy = []
    for worker in workers:
        if (index := next(coming, None)) is not None:
            worker.ask(index)
            busy.append(worker)
    while busy:
        ready = wait([worker.pipe for worker in busy], timeout=1.0)
        for worker in list(busy):
            if worker.pipe in ready:
                try:
                    index, contact, found = worker.pipe.recv()
                    answers.append((index, contact, found))
                    failed += [(index, problem) for problem in found.problems]
                except EOFError:
                    failed.append((worker.index or 0, "the process died"))
                    worker.end()
                    worker.begin()
            elif time.monotonic() - worker.since > HANGS:
                failed.append((worker.index or 0, f"no answer in {HANGS:g} s"))
                worker.end()
                worker.begin()
            else:
                continue
            following = next(coming, None) if time.monotonic() - began < seconds else None
            if following is None:
                busy.remove(worker)
            else:
                worker.ask(following)
    for worker in workers:
        worker.end()
    return answers, failed, time.monotonic() - began


def table(answers: list[Any], failed: list[tuple[int, str]], seed: int, wall: float) -> str:
    """What came, in Markdown."""
    import hophoop as hh

    lines = [
        f"{len(answers):,} scenarios of seed {seed} with version {hh.__version__}, in {wall:.0f} s.",
        "",
        "| | rigid | compliant |",
        "| --- | --- | --- |",
    ]
    kinds = ("rigid", "compliant")
    count = collections.Counter((contact, found.word) for _, contact, found in answers)
    lines.append("| scenarios | " + " | ".join(f"{sum(count[k, w] for w in (*WORDS, 'raised')):,}" for k in kinds) + " |")
    for word in WORDS:
        lines.append(f"| `{word}` | " + " | ".join(f"{count[kind, word]:,}" for kind in kinds) + " |")
    computed = [(contact, found) for _, contact, found in answers if found.word not in ("refused", "raised")]
    for title, pick, form in (
        ("largest ledger, of the energy range", lambda found: found.ledger, "{:.0e}"),
        ("slowest, s of the processor", lambda found: found.seconds, "{:.1f}"),
    ):
        worst = [max((pick(found) for contact, found in computed if contact == kind), default=0.0) for kind in kinds]
        lines.append(f"| {title} | " + " | ".join(form.format(number) for number in worst) + " |")
    saved = sum(index % FILES == 0 and found.word not in ("refused", "raised") for index, _, found in answers)
    lines += [f"| saved and loaded | {saved:,} in all | |", f"| **broken laws, hangs, exceptions** | {len(failed)} in all | |"]
    for index, problem in sorted(failed)[:40]:
        lines.append(f"| {index} | {problem} | |")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=100_000, help="scenarios")
    parser.add_argument("--first", type=int, default=0, help="index of the first")
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--seconds", type=float, default=float("inf"), help="begin no more after this time")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--markdown", type=Path, help="write the table to this file")
    parser.add_argument("--show", type=int, metavar="INDEX", help="compute one scenario and print it")
    given = parser.parse_args()
    if given.show is not None:
        import hophoop as hh
        from fuzz.checks import outcome

        keys = keys_of(given.seed, given.show)
        print(hh.Scenario.from_dict(keys).to_toml())
        print(outcome(keys, with_file=True))
        return 0
    os.environ["HOPHOOP_KERNELS"] = "compiled"
    answers, failed, wall = run(given.count, given.first, given.seed, given.processes, given.seconds)
    text = table(answers, failed, given.seed, wall)
    print(text)
    if given.markdown:
        given.markdown.write_text(text, encoding="utf-8")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
