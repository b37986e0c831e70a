"""Long commands stopped at random moments: with which status, how soon, what is left.

`python benchmarks/stops.py [--markdown FILE]`; what is not as it should be is printed, and makes the exit status 1.
"""

from __future__ import annotations

import argparse
import signal
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from random_stops import COMMANDS, SIGNALS, drawn, prepare, stopped_at_random, whole_map

SOON = 2.0  # seconds in which a command has to end


def table(counts: dict[str, Counter[str]], slowest: dict[str, float]) -> str:
    """What came, as Markdown."""
    names = [number.name for number in SIGNALS]
    lines = [
        f"| command | {' | '.join(names)} | slowest end (s) | wrong |",
        f"| --- | {'---: | ' * len(names)}---: | ---: |",
        *(
            f"| {name} | {' | '.join(str(came[one]) for one in names)} | {slowest[name]:.2f} | {came['wrong']} |"
            for name, came in counts.items()
        ),
    ]
    total = sum(counts.values(), Counter())
    worst = max(slowest.values(), default=0.0)
    lines.append(f"| all | {' | '.join(str(total[one]) for one in names)} | {worst:.2f} | {total['wrong']} |")
    return "\n".join(lines) + "\n"


def main() -> int:
    """Stop everything and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--stops", type=int, default=len(COMMANDS) * len(SIGNALS) * 2)
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--command", action="append", choices=[*COMMANDS], help="only this; may be repeated")
    parser.add_argument("--markdown", type=Path, help="write the table to this file")
    options = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background leaves it ignored, and so would they
    names = options.command or [*COMMANDS]
    counts: dict[str, Counter[str]] = {name: Counter() for name in names}
    slowest: dict[str, float] = defaultdict(float)
    with tempfile.TemporaryDirectory() as root:
        folder = Path(root)
        (folder / "inputs").mkdir()
        prepare(folder / "inputs")
        map_whole = whole_map(folder)
        for k, (name, number, group, after) in enumerate(drawn(options.stops, names, options.seed)):
            one = stopped_at_random(name, number, group, after, folder / f"stop{k}", folder / "inputs", map_whole)
            if one.took > SOON:
                one.wrong.append(f"it took {one.took:.2f} s to end")
            slowest[name] = max(slowest[name], one.took)
            counts[name][number.name] += 1
            counts[name]["wrong"] += bool(one.wrong)
            whom = "its group" if group else "it"
            print(f"{k + 1} {name}: {number.name} to {whom} after {after:.2f} s, ended in {one.took:.2f} s", flush=True)
            for words in one.wrong:
                print(f"    WRONG: {words}", flush=True)
            if options.markdown is not None:
                options.markdown.write_text(table(counts, slowest), encoding="utf-8")
    print(table(counts, slowest))
    return 1 if any(came["wrong"] for came in counts.values()) else 0


if __name__ == "__main__":
    raise SystemExit(main())
