"""The maximum friction utilization of a motion, and its derivatives.

Where slip takes part it is 1 and stays so. In rolling the share has its greatest values inside phases, where to first order
it does not matter that their places change, and at the ends of phases, which the change goes along with.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.layout import BEFORE_OM, OM, STATE_ROWS
from hophoop.derivatives.workspace import Pieces, Samples, new_workspace
from hophoop.kernel.model import Body, Event, Mode, required_ratio, resistance_arm
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.records import thread_scratch
from hophoop.kernel.steps import HOLD

Floats = NDArray[np.float64]
# Kernels by name: their modules write tangents on import, which compiled code does without.
KERNELS = "hophoop.derivatives."
SLIPS = (Mode.SPIN, Mode.SKID)
MOST = 8  # maxima of a segment
TIED = 1e-9  # relative to 1: maxima that differ by less are one


class Peak(NamedTuple):
    """A maximum of the friction that rolling requires; `event` is −1 for one inside a phase."""

    need: float
    event: int
    before: bool
    t: float
    rho: float


def peaks_of(body: Body, events: np.ndarray, segments: np.ndarray, index: int) -> list[Peak]:
    """Return the maxima inside the rolling phase that begins with an event, and both its ends."""
    begin, end = events["t"][index], events["t"][index + 1]
    first, last = np.searchsorted(segments["t"], (begin, end)).tolist()
    piece = segments[first]
    if piece["kind"] == HOLD:
        need = abs(body.gt) / body.gn if body.gn > 0.0 else 0.0
        s, c = sine_and_cosine(float(piece["theta"]))
        rho = resistance_arm(body, s, c, 0.0, 0)
        return [Peak(need, -1, False, begin + part * (end - begin), rho) for part in (0.0, 0.3, 0.5, 0.8, 1.0)]
    rho = float(piece["direction"] * body.resist)
    peaks = np.empty((MOST * (last - first), 2))
    count = compiled(KERNELS + "pieces.required_friction.fill_peaks")(body, segments, first, last, thread_scratch(), peaks)
    found = [Peak(need, -1, False, t, rho) for need, t in peaks[:count].tolist()]
    for event, before in ((index, False), (index + 1, True)):
        th, om = _state_of(events[event], before)
        s, c = sine_and_cosine(th)
        need = abs(required_ratio(body, s, c, om * om, rho))
        found.append(Peak(need, event, before, end if before else begin, rho))
    return found


def _state_of(row: np.void, before: bool) -> tuple[float, float]:
    """Return (θ, θ̇) just after an event, or before it."""
    return float(row["theta"] + row["theta_low"]), float(row["before_omega"] if before else row["omega"])


def settled_by(body: Body, events: np.ndarray) -> tuple[float, int]:
    """Return the utilization if it is known without a search of phases, and the event from which it is; else −1."""
    bounded = 0.0 < body.mu_s < math.inf
    kinds, before, after, times = (events[name].tolist() for name in ("kind", "before_mode", "after_mode", "t"))
    for k, kind in enumerate(kinds):
        if kind == Event.SLIP_START or (kind == Event.TAKEOFF and before[k] == Mode.ROLL):
            return float(bounded), k
    lasting = [k for k in range(len(kinds) - 1) if times[k + 1] > times[k]]
    for k in lasting:
        if after[k] in SLIPS and body.mu_k > 0.0:
            return 1.0, k
    rolling = [k for k in lasting if after[k] == Mode.ROLL]
    if not rolling:
        return math.nan, 0
    return 0.0, -1 if bounded else rolling[0]


def greatest_peaks(body: Body, events: np.ndarray, segments: np.ndarray) -> list[Peak]:
    """Return the places at which a motion that only rolls requires most friction: one, except for ties."""
    found = [
        peak
        for k in range(len(events) - 1)
        if events["after_mode"][k] == Mode.ROLL and events["t"][k + 1] > events["t"][k]
        for peak in peaks_of(body, events, segments, k)
    ]
    most = max(peak.need for peak in found)
    return [peak for peak in found if peak.need >= most - TIED * max(most, body.mu_s)]


def use_rates(body: Body, events: np.ndarray, at_events: Floats, pieces: Pieces, peak: Peak) -> tuple[Floats, Floats]:
    """Return the derivatives of the friction utilization at a peak, towards larger and towards smaller parameters."""
    parameter_tangents = pieces.parameter_tangents
    if peak.event >= 0:
        th, om = _state_of(events[peak.event], peak.before)
        tangents = at_events[peak.event][:STATE_ROWS].copy()
        if peak.before:
            tangents[OM] = at_events[peak.event][BEFORE_OM]
    else:
        samples = Samples(np.empty((1, 6)), np.empty((1, *pieces.at_segments.shape[1:])))
        still = np.zeros(parameter_tangents.shape[1])
        workspace = new_workspace(thread_scratch(), parameter_tangents.shape[1])
        compiled(KERNELS + "pieces.sampling.sample_tangents")(
            body, pieces, still, np.array([peak.t]), False, samples, workspace
        )
        tangents, th, om = samples.tangents[0], samples.states[0, 2], samples.states[0, 3]
    larger, smaller = np.empty((2, parameter_tangents.shape[1]))
    compiled(KERNELS + "pieces.required_friction.use_changes")(
        body, float(th), float(om), peak.rho, tangents, parameter_tangents, larger, smaller
    )
    return larger, smaller
