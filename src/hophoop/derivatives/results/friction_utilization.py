"""The maximum friction utilization of a motion, and its derivatives.

Where slip takes part it is 1 and stays so. In rolling the share has its greatest values inside phases, where to first order
it does not matter that their places change, and at the ends of phases, which the change goes along with.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.layout import BEFORE_OM, KAP, MU_S, OM, STATE_ROWS, TH
from hophoop.derivatives.workspace import Pieces, Samples, new_workspace
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.panels.panel import HOLD
from hophoop.kernel.physics.body import Body, Event, Mode
from hophoop.kernel.records.layout import thread_scratch

Floats = NDArray[np.float64]
# Kernels by name: their modules write tangents on import, which compiled code does without.
KERNELS = "hophoop.derivatives."
REQUIRED = KERNELS + "pieces.required_friction."
SLIPS = (Mode.SPIN, Mode.SKID)
TIED = 1e-9  # relative to 1: maxima that differ by less are one


class Peak(NamedTuple):
    """A maximum of the friction that rolling requires; `event` is −1 for one inside a phase."""

    need: float
    event: int
    before: bool
    t: float
    rho: float


def peaks_of(body: Body, events: np.ndarray, segments: np.ndarray, index: int, scratch: Any) -> list[Peak]:
    """The peaks of the rolling phase that begins with an event.

    Parameters
    ----------
    body : Body
    events, segments : ndarray of records.EVENT, records.SEGMENT
    index : int
        Of the event.
    scratch : records.Scratch

    Returns
    -------
    peaks : list of Peak
    """
    begin, end = events["t"][index], events["t"][index + 1]
    if body.kap == 0.0:  # the force points at the load, even where it is 0: it needs most friction at an end
        rows = events[index : index + 2]
        needs = [_massless_need(float(row["theta"] + row["theta_low"])) for row in rows]
        if rows[0]["omega"] == 0.0 and rows[0]["theta"] == rows[1]["theta"]:  # at rest, with the load on the plane
            needs = [0.0, 0.0]
        return [Peak(abs(needs[0]), index, False, begin, 0.0), Peak(abs(needs[1]), index + 1, True, end, 0.0)]
    numbers = np.flatnonzero((segments["t"] >= begin) & (segments["t"] < end)).tolist()
    first = segments[numbers[0]]
    if first["kind"] == HOLD:
        need, rho = compiled(REQUIRED + "need_at_rest")(body, float(first["theta"]))
        times = [begin + part * (end - begin) for part in (0.0, 0.3, 0.5, 0.8, 1.0)]
        return [Peak(float(need), -1, False, t, float(rho)) for t in times]
    room = np.empty((3, ORDER + 2))
    found = []
    outer = -1.0  # the slope where the piece before has ended
    for number in numbers:
        row = segments[number]
        rho = float(row["direction"] * body.resist)
        count = compiled(REQUIRED + "needs_on_panel")(body, segments, number, scratch, *room)
        places, needs, slopes = room[:, :count]
        if number == numbers[0] and not slopes[0] > 0.0:
            found.append(Peak(float(needs[0]), index, False, begin, rho))
        elif outer > 0.0 and not slopes[0] > 0.0:
            found.append(Peak(float(needs[0]), -1, False, float(row["t"]), rho))
        for k in np.flatnonzero((slopes[:-1] > 0.0) & ~(slopes[1:] > 0.0)).tolist():
            need, t = compiled(REQUIRED + "peak_on_panel")(
                body, segments, number, float(places[k]), float(places[k + 1]), scratch
            )
            found.append(Peak(float(need), -1, False, float(t), rho))
        outer = slopes[-1]
    if outer > 0.0:
        found.append(Peak(float(needs[-1]), index + 1, True, end, rho))
    return found


def _massless_need(th: float) -> float:
    """Return F/N of the massless hoop, tan(θ/2)."""
    s, c = sine_and_cosine(th)
    return float(s / (1.0 + c)) if c > -1.0 else math.inf


def settled_by(body: Body, events: np.ndarray) -> tuple[float, int]:
    """Return the utilization if it is known without a search of phases, and the event from which it is; else −1.

    Parameters
    ----------
    body : Body
    events : ndarray of records.EVENT

    Returns
    -------
    use : float
    event : int
    """
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


def greatest_peaks(body: Body, events: np.ndarray, segments: np.ndarray, scratch: Any) -> list[Peak]:
    """Return the places at which a motion that only rolls requires most friction: one, except for ties.

    Parameters
    ----------
    body : Body
    events, segments : ndarray of records.EVENT, records.SEGMENT
    scratch : records.Scratch

    Returns
    -------
    peaks : list of Peak
    """
    found = [
        peak
        for k in range(len(events) - 1)
        if events["after_mode"][k] == Mode.ROLL and events["t"][k + 1] > events["t"][k]
        for peak in peaks_of(body, events, segments, k, scratch)
    ]
    most = max(peak.need for peak in found)
    return [peak for peak in found if peak.need >= most - TIED * max(most, body.mu_s)]


def use_rates(body: Body, events: np.ndarray, at_events: Floats, pieces: Pieces, peak: Peak) -> tuple[Floats, Floats]:
    """Return the derivatives of the friction utilization at a peak, towards larger and towards smaller parameters.

    Parameters
    ----------
    body : Body
    events : ndarray of records.EVENT
    at_events : ndarray, shape (events, EVENT_ROWS, n)
    pieces : Pieces
    peak : Peak

    Returns
    -------
    larger, smaller : ndarray, shape (n,)
    """
    parameter_tangents = pieces.parameter_tangents
    if peak.event >= 0:
        row = events[peak.event]
        tangents = at_events[peak.event][:STATE_ROWS].copy()
        th, om = row["theta"] + row["theta_low"], row["before_omega"] if peak.before else row["omega"]
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
    compiled(REQUIRED + "use_changes")(body, float(th), float(om), peak.rho, tangents, parameter_tangents, larger, smaller)
    if body.kap == 0.0:
        need, massless = _massless_need(float(th)), parameter_tangents[KAP] == 0.0
        turned = math.copysign(0.5 * (1.0 + need * need), need) * tangents[TH]
        rates = (turned - peak.need * parameter_tangents[MU_S] / body.mu_s) / body.mu_s
        larger[massless] = smaller[massless] = rates[massless]
    return larger, smaller
