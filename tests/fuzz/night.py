"""Scenarios over the whole of the supported ranges, as many as asked for, and a table of what came of them.

    python tests/fuzz/night.py --count 100000 --markdown table.md
    python tests/fuzz/night.py --show 4711          # one of them again

Each is computed in a worker process, so that one that hangs or kills its process is found too.
"""

from __future__ import annotations

import argparse
import math
import multiprocessing
import os
import sys
import time
from collections.abc import Callable, Iterable
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from fuzz.checks import Outcome

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

SEED = 2026
HANGS = 1200.0  # s without an answer: much more than any takes, since other work may share the machine
EXTREME = 10  # every so many-th scenario is extreme
FEW = 50  # every so many-th motion is saved and loaded, and another one computed elsewhere too
WRITTEN = 120.0  # s between two tables of a run that goes on
KINDS = ("rigid", "compliant", "extreme")
WORDS = ("completed", "at_rest", "jammed", "undetermined", "event_limit", "refused")


class Answer(NamedTuple):
    """What came of a scenario."""

    index: int
    contact: str
    found: Outcome
    spent: float  # s of the processor, with all checks


class Night(NamedTuple):
    """What came of all of them."""

    answers: list[Answer]
    failed: list[tuple[int, str]]
    wall: float  # s


def extreme(index: int) -> bool:
    """Whether a scenario has numbers of any magnitude, at the ends of their ranges and next to them alone."""
    return index % EXTREME == EXTREME - 1


def keys_of(seed: int, index: int, turns: float | None) -> dict[str, Any]:
    """The scenario of an index."""
    from fuzz import draws

    kinds = draws.EXTREME if extreme(index) else draws.USUAL
    return draws.scenario(draws.Seeded(seed, index, kinds), turns=turns)


def work(pipe: Connection, seed: int, turns: float | None) -> None:
    """Answer indices until there are no more."""
    from fuzz.checks import outcome, warm_up

    warm_up()
    pipe.send(None)
    while (index := pipe.recv()) is not None:
        keys = keys_of(seed, index, turns)
        began = time.process_time()
        found = outcome(keys, with_file=index % FEW == 0, elsewhere=moved(index))
        pipe.send(Answer(index, keys["contact"]["model"], found, time.process_time() - began))


def moved(index: int) -> bool:
    """Whether a scenario is computed by threads, a forked and another spawned process as well."""
    return index % FEW == FEW // 2


class Worker:
    """A process that computes, and when it was last heard of."""

    def __init__(self, seed: int, turns: float | None) -> None:
        self.context = multiprocessing.get_context("spawn")
        self.given = seed, turns
        self.begin()

    def begin(self) -> None:
        self.pipe, other = self.context.Pipe()
        self.process = self.context.Process(target=work, args=(other, *self.given), daemon=True)
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


def run(
    indices: Iterable[int], seed: int, turns: float | None, processes: int, seconds: float, watch: Callable[[Night], None]
) -> Night:
    """Compute these scenarios, or as many as the time allows; `watch` sees what has come now and then."""
    began = written = time.monotonic()
    workers = [Worker(seed, turns) for _ in range(processes)]
    answers: list[Answer] = []
    failed: list[tuple[int, str]] = []
    coming = iter(indices)
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
                    answer = worker.pipe.recv()
                    answers.append(answer)
                    failed += [(answer.index, problem) for problem in answer.found.problems]
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
        if time.monotonic() - written > WRITTEN:
            written = time.monotonic()
            watch(Night(answers, failed, written - began))
    for worker in workers:
        worker.end()
    return Night(answers, failed, time.monotonic() - began)


def again(night: Night, seed: int, turns: float | None) -> Night:
    """The same with some scenarios computed once more, by a process that has just been spawned."""
    first = {answer.index: answer.found.digest for answer in night.answers if moved(answer.index)}
    second = run(first, seed, turns, 1, math.inf, lambda _: None)
    differ = [
        (one.index, "a spawned process gives other bits") for one in second.answers if one.found.digest != first[one.index]
    ]
    lost = [] if len(second.answers) == len(first) else second.failed
    return Night(night.answers, night.failed + differ + lost, night.wall + second.wall)


def table(night: Night, seed: int) -> str:
    """What came, in Markdown."""
    import hophoop as hh
    from invariants import INVARIANTS

    answers, failed = night.answers, night.failed
    spent = sum(answer.spent for answer in answers)
    lines = [
        f"{len(answers):,} scenarios of seed {seed} with version {hh.__version__}, in {night.wall:,.0f} s; they took "
        f"{spent:,.0f} s of one processor.",
        "",
        "| | " + " | ".join(KINDS) + " |",
        "| --- |" + " --- |" * len(KINDS),
    ]
    of_kind = [[one for one in answers if kind_of(one) == kind] for kind in KINDS]

    def row(title: str, cell: Callable[[list[Answer]], str]) -> None:
        lines.append(f"| {title} | " + " | ".join(map(cell, of_kind)) + " |")

    row("scenarios", lambda ones: f"{len(ones):,}")
    for word in WORDS:
        row(f"`{word}`", lambda ones, word=word: f"{sum(one.found.word == word for one in ones):,}")
    row("slowest, s of the processor", lambda ones: f"{max((one.found.seconds for one in ones), default=0.0):.1f}")
    row("saved and loaded", lambda ones: f"{sum(bool(one.found.deviations) for one in ones if one.index % FEW == 0):,}")
    row(
        "in eight threads, forked and spawned",
        lambda ones: f"{sum(bool(one.found.deviations) for one in ones if moved(one.index)):,}",
    )
    lines += ["", "| breaches; largest deviation | " + " | ".join(KINDS) + " |", "| --- |" + " --- |" * len(KINDS)]
    for name in (*INVARIANTS, "mirror", "units"):

        def cell(ones: list[Answer], name: str = name) -> str:
            found = [one.found.deviations[name] for one in ones if name in one.found.deviations]
            largest = max((value for value, _ in found), default=0.0)
            return f"{sum(broken for _, broken in found):,}; {largest:.0e}".replace("; 0e+00", "; 0")

        row(name, cell)
    others = [problem for _, problem in failed if problem.partition(":")[0] not in (*INVARIANTS, "mirror", "units")]
    lines += [
        "",
        f"Exceptions, hangs, other bits: {len(others)}. Scenarios with a breach: {len({index for index, _ in failed}):,}.",
    ]
    if failed:
        lines += ["", "| scenario | breach |", "| --- | --- |"]
        lines += [f"| {index} | {problem} |" for index, problem in sorted(failed)[:40]]
    return "\n".join(lines) + "\n"


def kind_of(answer: Answer) -> str:
    """The column of the table that an answer is in."""
    return KINDS[2] if extreme(answer.index) else answer.contact


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=100_000, help="scenarios")
    parser.add_argument("--first", type=int, default=0, help="index of the first")
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--turns", type=float, help="shorten each to about so many revolutions")
    parser.add_argument("--seconds", type=float, default=math.inf, help="begin no more after this time")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--markdown", type=Path, help="write the table to this file")
    parser.add_argument("--show", type=int, metavar="INDEX", help="compute one scenario and print it")
    given = parser.parse_args()
    if given.show is not None:
        import hophoop as hh
        from fuzz.checks import outcome

        keys = keys_of(given.seed, given.show, given.turns)
        print(hh.Scenario.from_dict(keys).to_toml())
        print(outcome(keys, with_file=True, elsewhere=True))
        return 0
    os.environ["HOPHOOP_KERNELS"] = "compiled"

    def write(night: Night) -> str:
        text = table(night, given.seed)
        if given.markdown:
            given.markdown.write_text(text, encoding="utf-8")
        return text

    indices = range(given.first, given.first + given.count)
    night = again(run(indices, given.seed, given.turns, given.processes, given.seconds, write), given.seed, given.turns)
    print(write(night))
    return 1 if night.failed else 0


if __name__ == "__main__":
    sys.exit(main())
