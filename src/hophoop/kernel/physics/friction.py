"""How much of the friction that is possible acts (docs/model.md#modes)."""

from __future__ import annotations

import math


def utilization(slips, friction, normal, mu_s, mu_k):
    """abs(F)/(μ N), μ being that of the phase: μk in slip, else μs.

    In slip N divides out of Coulomb's law, so that it is 1 also at the instant of lift-off; nan where slip has no
    friction at all, and without slip where nothing presses.
    """
    limit = (mu_k if slips else mu_s) * normal
    if limit > 0.0:
        return abs(friction) / limit
    if slips:
        return 1.0 if mu_k > 0.0 else math.nan
    if not normal > 0.0:
        return math.nan
    return 0.0 if friction == 0.0 else math.inf


def utilizations(slips, friction, normal, mu_s, mu_k, out):
    """`utilization` of many cases; all arguments are arrays of one length."""
    for i in range(out.shape[0]):
        out[i] = utilization(slips[i], friction[i], normal[i], mu_s[i], mu_k[i])
