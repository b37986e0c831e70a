"""Critical speeds in closed form, case by case."""

from __future__ import annotations

import math

from hophoop._jit import jit
from hophoop.records.scratch import new_scratch
from hophoop.theory.kernels.arcs import TURN
from hophoop.theory.kernels.extrema import FORCE_ANGLE, SPEED_ANGLE, cone_margin_line, highest
from hophoop.theory.kernels.rows import body_of


@jit
def slip_speeds(bodies, out):
    scratch = new_scratch()
    for k in range(out.shape[0]):
        body = body_of(bodies[k])
        if math.isinf(body.mu_s):
            out[k] = math.inf
            continue
        end = math.pi if body.gt == 0.0 else TURN  # on the level both halves of a turn are alike
        best = math.inf
        for side in (1.0, -1.0):
            angle, _ = highest(FORCE_ANGLE, body, 0.0, 0.0, end, side, scratch)
            if angle >= math.atan(body.mu_s):
                best = 0.0  # even the smallest push
                break
            # For each θ the margin to the cone is a line in v0², not negative at 0: slip from its zero on.
            _, place = highest(SPEED_ANGLE, body, 0.0, 0.0, end, side, scratch)
            steady, rate = cone_margin_line(body, place, side)
            if rate < 0.0:
                best = min(best, math.sqrt(max(steady, 0.0) / -rate))
        out[k] = best
