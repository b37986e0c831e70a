"""The checker of certificates: interval evaluation of the equations alone, nothing shared with what made the certificate.

It repeats the formulas of `kernel.physics` on purpose, so that a mistake in one of the two shows.

It searches for nothing. A certificate gives brackets of the events and, for slip, polynomials for θ̇² and t; the
checker puts the polynomials into the equations, bounds the residual, and evaluates inequalities on intervals.
"""

from hophoop.prove.checker.check import check
from hophoop.prove.checker.verdict import Verdict

__all__ = ["Verdict", "check"]
