"""Time of a proof of the article's hop, verification by the checker included.

python benchmarks/proofs.py
"""

from __future__ import annotations

import json
import time

import hophoop as hh
from hophoop.prove import check, prove

HOP = hh.Scenario(duration=2.0)
REPEATS = 5


def best(function) -> float:
    """The least time of some calls [s]."""
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def main() -> None:
    """Print a line for each number of digits."""
    prove(HOP, 3)  # loads python-flint
    for digits in (15, 18, 30, 60, 100):
        certificate = prove(HOP, digits).certificate
        size = len(json.dumps(certificate, separators=(",", ":")))
        took, verified = best(lambda digits=digits: prove(HOP, digits)), best(lambda one=certificate: check(one))
        print(f"{digits:4} digits  {took:6.2f} s, of which the checker {verified:5.2f} s; certificate {size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
