"""The rows of the array in which the derivatives on a panel are worked out, values at its nodes."""

from __future__ import annotations

from hophoop.kernel.native import apart
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.panels.panel import STRETCH, TIME
from hophoop.kernel.panels.slip import from_reference

# By θ̇² at the begin (of an arriving panel: by θ there), by θ at the begin (by the turning point), by the parameters.
BEGIN, SHIFT, BY_EPS, BY_KAP, BY_MU, BY_GN, BY_GT, BY_RESIST = range(8)
LOCAL = 8
# Rows of the array that a panel is worked out in.
SLOPE, INTERPOLATE, INTEGRATE, AT_BEGIN, RATES, TIMES, WEIGH, WEIGHED = range(LOCAL, LOCAL + 8)
ROWS = LOCAL + 8


@apart
def integrate_row(panel, row, growth, work):
    """What a rate of dθ̇²/dθ adds up to from the panel's reference on, grown by the factor `growth`."""
    integral = work[TIME]
    for i in range(ORDER):
        row[i] *= work[STRETCH, i] / growth[i]
    from_reference(panel, row, integral)
    for i in range(ORDER):
        row[i] = growth[i] * integral[i]
