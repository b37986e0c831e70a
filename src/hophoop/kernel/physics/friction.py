"""Friction utilization: the fraction of the available friction that acts (docs/model.md#modes)."""

from __future__ import annotations

import math


def utilization(slips, friction, normal, mu_s, mu_k):
    """Return abs(F)/(μ N) with the μ of the phase: μk in slip, else μs.

    In slip N divides out of Coulomb's law, so the utilization is 1 also at the instant of lift-off. It is nan in slip without
    friction, and without slip if N = 0.
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
    """Fill `out` with the `utilization` of many cases; all arguments are arrays of one length."""
    for i in range(out.shape[0]):
        out[i] = utilization(slips[i], friction[i], normal[i], mu_s[i], mu_k[i])
