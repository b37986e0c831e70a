"""The checker of certificates: interval evaluation of the equations alone, nothing shared with what made the certificate.

It searches for nothing. A certificate says where the events are and, for slip, which polynomials θ̇² and t are; the
checker puts the polynomials into the equations, bounds what is left over, and evaluates inequalities on intervals.
"""

from hophoop.prove.checker.check import Verdict, check

__all__ = ["Verdict", "check"]
