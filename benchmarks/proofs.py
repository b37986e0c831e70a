"""Time of a proof of the article's hop, verification by the checker included; of gaits and chaos with their certificates.

python benchmarks/proofs.py
"""

from __future__ import annotations

import json
import math
import time

import hophoop as hh
from hophoop.prove import check, prove, prove_chaos, prove_gait

HOP = hh.Scenario(duration=2.0)
REPEATS = 5
GAITS = [(0.5, 0.75, 3.3141, 3.3146), (1, 0.75, 3.408, 3.4084), (3, 0.5, 2.7714, 2.7716), (5, 0.25, 3.02, 3.05)]
CHAOS = [(3.2, 3.375), (3.43, 3.522)]  # √(g/R), at 4° for γ = 3/4


def best(function) -> float:
    """The least time of some calls [s]."""
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def slope(degrees: float, gamma: float) -> hh.Scenario:
    """A plane with R = 1 m and g = 1 m/s²."""
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(gravity=1.0, slope=math.radians(degrees)))


def certified(name: str, proof) -> None:
    """Print the time of one proof with a certificate, and of the checker."""
    begin = time.perf_counter()
    certificate = proof().certificate
    took = time.perf_counter() - begin
    size = len(json.dumps(certificate, separators=(",", ":")))
    verified = best(lambda: check(certificate))
    print(f"{name}  {took:6.2f} s with a certificate of {size / 1000:.1f} kB; the checker alone {verified:5.2f} s")


def main() -> None:
    """Print a line for each number of digits."""
    prove(HOP, 3)  # loads python-flint
    for digits in (15, 18, 30, 60, 100):
        certificate = prove(HOP, digits).certificate
        size = len(json.dumps(certificate, separators=(",", ":")))
        took, verified = best(lambda digits=digits: prove(HOP, digits)), best(lambda one=certificate: check(one))
        print(f"{digits:4} digits  {took:6.2f} s, of which the checker {verified:5.2f} s; certificate {size / 1000:.0f} kB")
    for degrees, gamma, low, high in GAITS:
        ends = slope(degrees, gamma), low, high
        certified(f"gait at {degrees}°", lambda ends=ends: prove_gait(*ends, certify=True))
    certified("chaos at 4°", lambda: prove_chaos(slope(4, 0.75), CHAOS, certify=True))


if __name__ == "__main__":
    main()
