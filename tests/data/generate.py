"""Write the reference motions of this folder: every case solved twice with different digits, and the two
compared.

python tests/data/generate.py            all cases
python tests/data/generate.py NAME ...   some of them
"""

import json
import sys
from dataclasses import asdict
from itertools import pairwise
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from mpmath import mp, mpf  # noqa: E402

from oracles import precise  # noqa: E402
from oracles.cases import CASES  # noqa: E402

DIGITS, CHECK_DIGITS, WRITTEN = 40, 52, 25
AGREEMENT = mpf(10) ** -24  # largest difference allowed between the two solutions, absolute in SI


def mid_phase_times(solution):
    """Doubles well inside the pieces between events, at most about two dozen."""
    times = []
    brief = solution.case.rest_below > 0.0  # thousands of bounces need no samples
    marks = sorted({e["t"] for e in solution.events if not (brief and e["from"] == e["to"] == "H")})
    parts = 8 if len(marks) <= 3 else 2 if len(marks) <= 9 else 1
    for left, right in pairwise(marks):
        if right - left < mpf(10) ** -9:
            continue
        for part in range(parts):
            times.append(float(left + (right - left) * (part + mpf("0.437")) / parts))
    return times


def largest_difference(a, b):
    """Largest absolute difference between the numbers of two nested results of one shape."""
    if isinstance(a, dict):
        assert a.keys() == b.keys()
        return max((largest_difference(a[key], b[key]) for key in a), default=mpf(0))
    if isinstance(a, list):
        assert len(a) == len(b)
        return max((largest_difference(x, y) for x, y in zip(a, b, strict=True)), default=mpf(0))
    if isinstance(a, mpf):
        return abs(a - b)
    assert a == b, (a, b)
    return mpf(0)


def result(case, digits):
    """Events, mid-phase samples and energies of a case."""
    solution = precise.solve(case, digits)
    with mp.workdps(digits):
        samples = []
        for t in mid_phase_times(solution):
            sample = solution.at(mpf(t))
            sample["kinetic"], sample["potential"] = precise.energy(solution, sample)
            samples.append(sample)
        if case.rest_below:  # of the endless bounces the first few are enough, and those that change the mode
            solution.events[9:] = [event for event in solution.events[9:] if event["to"] != "H"]
        return {
            "status": solution.status,
            "sequence": solution.sequence,
            "events": solution.events,
            "samples": samples,
            "energy": precise.ledger(solution),
        }


def written(thing):
    """The same with every number of many digits as a string of 25 digits."""
    if isinstance(thing, dict):
        return {key: written(item) for key, item in thing.items()}
    if isinstance(thing, list):
        return [written(item) for item in thing]
    return mp.nstr(thing, WRITTEN) if isinstance(thing, mpf) else thing


def main(names):
    """Solve, compare and write."""
    for case in CASES:
        if names and case.name not in names:
            continue
        first, second = result(case, DIGITS), result(case, CHECK_DIGITS)
        with mp.workdps(CHECK_DIGITS):
            agreement = largest_difference(first, second)
            if agreement > AGREEMENT:
                raise RuntimeError(f"{case.name}: two solutions differ by {mp.nstr(agreement, 3)}")
            document = {
                "case": asdict(case),
                "digits": WRITTEN,
                "agreement": mp.nstr(agreement, 2),
                **written(second),
            }
        target = HERE / f"{case.name}.json"
        target.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        print(f"{case.name:28s} {second['sequence']:20s} agreement {mp.nstr(agreement, 2)}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
