"""The rigid hoop's motion in as many digits as asked: the kernel's formulas, with Taylor series in integers for its panels.

`hophoop.simulate` with ``digits=`` calls it; `solve` is for those who need the numbers themselves.
"""

from hophoop.precise.agreement import Agreement, Row, compare
from hophoop.precise.result import PreciseMotion, simulate_precisely
from hophoop.precise.solver import Solution, solve

__all__ = ["Agreement", "PreciseMotion", "Row", "Solution", "compare", "simulate_precisely", "solve"]
