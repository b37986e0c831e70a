"""The loop over contacts and flights on a compliant plane, in nopython mode."""

from __future__ import annotations

import math

import numpy as np

from hophoop._jit import jit
from hophoop.compliant.events import (
    FRICTION_CHANGE,
    GUARDS,
    NONE,
    first_exit,
    guard,
    remaining,
    sign_change,
)
from hophoop.compliant.flight import CLEAR, LANDED, fly_above, fly_below, fly_state
from hophoop.compliant.motion import rates
from hophoop.compliant.parameters import to_compliance, to_start
from hophoop.compliant.records import (
    DYNAMIC,
    FIRST,
    FLY,
    FRICTION,
    HOLD,
    KIND,
    LENGTH,
    MODE,
    OM,
    ORIGIN,
    REGIME,
    SEGMENT,
    SIZE,
    STEP,
    T_END,
    TH,
    VN,
    VT,
    WIDTH,
    T,
    X,
    Y,
    Z,
    grown,
    new_work,
)
from hophoop.compliant.step import FAILED, attempt, make_poly, poly_value, predict
from hophoop.compliant.tableau import STAGES
from hophoop.physics.body import Event, Mode, Status
from hophoop.physics.compliant import BRISTLE, TANH, first_regime, friction_force, normal_force
from hophoop.physics.contact import delassus, free_acceleration
from hophoop.records.layout import EVENT
from hophoop.records.state import moved, start_state, with_losses
from hophoop.records.writing import quiet, write_event
from hophoop.scenario import Scenario

# As NumPy's integers: Numba would compile a function again for every Python integer that it is called with.
ROLL, SPIN, SKID, FLIGHT = (np.int64(mode) for mode in (Mode.ROLL, Mode.SPIN, Mode.SKID, Mode.FLIGHT))
START, SLIP_START, STICK, TAKEOFF, IMPACT, TURN, APEX, REST, END = (
    np.int64(Event[name]) for name in ("START", "SLIP_START", "STICK", "TAKEOFF", "IMPACT", "TURN", "APEX", "REST", "END")
)
NO_MODE, AHEAD = np.int64(-1), np.int64(1)
COMPLETED, AT_REST, UNDETERMINED, EVENT_LIMIT = (
    int(end) for end in (Status.COMPLETED, Status.AT_REST, Status.UNDETERMINED, Status.EVENT_LIMIT)
)

SAFETY, SLOWER, FASTER = 0.9, 0.1, 6.0
ORDER_OF_ERROR = STAGES + 1
# A step as short as this means that the method has failed.
SHORTEST = 1e-40
# Velocities and accelerations (of order 1 in a motion) below which a stable equilibrium is called rest.
STILL = 1e-11


@jit
def mode_of(regime):
    """The mode that a regime of the friction is called."""
    if regime == 0:
        return ROLL
    return SKID if regime > 0 else SPIN


@jit
def as_state(t, u):
    """The state as events are written."""
    start = start_state(u[X], u[Y], u[TH], u[VT], u[VN], u[OM])
    there = moved(start, t, 0.0, start.x, 0.0, start.y, start.turns, start.th, start.th_low)
    return with_losses(there, u[FRICTION], 0.0, 0.0)


@jit
def note(events, count, kind, before, after, t, u):
    """Append an event that changes no velocity; -1 where the array is full."""
    state = as_state(t, u)
    cause = quiet(kind, before, state)
    count = write_event(events, count, cause, after, state, 0.0, -1)
    if count > 0 and kind == IMPACT:
        events[count - 1]["collision"] = 1
    return count


@jit
def keep(rows, pieces, t, t_end, kind, mode, regime, origin, length, work, u):
    """Append a segment; returns the array, which may be a longer copy."""
    rows = grown(rows, pieces)
    row = rows[pieces]
    row[T] = t
    row[T_END] = t_end
    row[KIND] = kind
    row[MODE] = mode
    row[REGIME] = regime
    row[ORIGIN] = origin
    row[LENGTH] = length
    for m in range(SIZE):
        for j in range(STAGES + 1):
            at = FIRST + m * (STAGES + 1) + j
            if kind == STEP:
                row[at] = work.poly[m, j]
            else:
                row[at] = u[m] if j == 0 else 0.0
    return rows


@jit
def first_step(body, comp, regime, u, rtol):
    """Length of a step that resolves the fastest transient of a contact that begins."""
    s = math.sin(u[TH])
    c = math.cos(u[TH])
    W_tt, W_nn, _ = delassus(body, s, c)
    normal, normal_y, normal_vn = normal_force(comp, u[Y], u[VN])
    friction_vt = friction_force(comp, regime, normal, u[Z], u[VT])[2]
    speed = math.sqrt(max(-normal_y, comp.k) * W_nn) + abs(normal_vn) * W_nn + abs(friction_vt) * W_tt
    if comp.friction == BRISTLE:
        speed += math.sqrt(comp.k_t * W_tt)
    speed += 1.0 + abs(u[OM])
    return 0.3 * rtol ** (1.0 / ORDER_OF_ERROR) / speed


@jit
def at_rest(body, comp, regime, u, work):
    """(whether the hoop rests, whether stably)."""
    speed = max(abs(u[VT]), abs(u[VN]), abs(u[OM]))
    if speed > STILL:
        return False, False
    rates(body, comp, regime, u, work.trial)
    speed = max(speed, abs(work.trial[VT]), abs(work.trial[VN]), abs(work.trial[OM]))
    if speed > STILL:
        return False, False
    # second derivative of the potential in rolling: −ε cos(θ + β), or no slope and no eccentricity
    bend = -body.eps * (math.cos(u[TH]) * body.gn - math.sin(u[TH]) * body.gt)
    stable = bend > 0.0 or (body.eps == 0.0 and body.gt == 0.0)
    return stable or speed < 1e-15, stable


@jit
def run(body, comp, start, touching, t_end, rtol, max_steps, events):
    """The motion from a state to the end of time.

    Parameters
    ----------
    body : Body
    comp : Compliance
    start : ndarray, shape (SIZE,)
        Not changed.
    touching : bool
        Whether the contact acts at the start.
    t_end, rtol : float
    max_steps : int
        Segments after which the motion is given up.
    events : ndarray of records.EVENT
        Filled.

    Returns
    -------
    status, number of events, segments, number of segments
    """
    work = new_work()
    rows = np.empty((256, WIDTH))
    armed = np.zeros(GUARDS, np.bool_)
    u = start.copy()
    work.atol[Y] = min(1.0, 1.0 / comp.k)
    work.atol[TH] = 1.0
    work.atol[VT] = min(1.0, comp.v_s)
    work.atol[VN] = min(1.0, 1.0 / math.sqrt(comp.k))
    work.atol[OM] = 1.0
    work.atol[Z] = 1.0
    if comp.friction == BRISTLE:
        work.atol[Z] = min(1.0, 1.0 / comp.k_t)
    for m in range(DYNAMIC, SIZE):
        work.atol[m] = 1.0
    t = 0.0
    behind = 0.0  # what rounding has kept from t so far: steps may be shorter than its last digit
    pieces = np.int64(0)
    regime = np.int64(0)
    mode = FLIGHT
    if touching:
        regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
        mode = mode_of(regime)
    count = note(events, np.int64(0), START, NO_MODE if touching else FLIGHT, mode, t, u)
    status = COMPLETED
    fresh = True  # a contact, or a regime of its friction, begins
    h = 0.0
    warm = False  # the dense output of the step before, of length `before`, starts Newton's iteration
    before = 0.0
    way = 0.0  # sign of θ̇ when it was last not 0
    while t < t_end and count >= 0:
        if pieces >= max_steps:
            status = EVENT_LIMIT
            break
        if mode == FLIGHT:
            opening = free_acceleration(body, math.sin(u[TH]), math.cos(u[TH]), u[OM] * u[OM])[1]
            apex = -1.0
            if u[Y] < 0.0:
                what, tau = fly_below(body, comp, u, opening, t_end - t, work)
            elif u[Y] == 0.0 and u[VN] < 0.0:  # a start that lands at once
                what, tau = LANDED, 0.0
            else:
                zeros = 0 if u[Y] > 0.0 else 1 if u[VN] > 0.0 else 2
                what, tau, apex = fly_above(body, u, opening, zeros, t_end - t, work)
            if 0.0 < apex < tau:
                fly_state(body, comp, u, opening, apex, work.start)
                work.start[VN] = 0.0
                count = note(events, count, APEX, FLIGHT, FLIGHT, t + apex, work.start)
            after = t + tau if what in (LANDED, CLEAR) else t_end
            rows = keep(rows, pieces, t, after, FLY, mode, regime, t, opening, work, u)
            pieces += 1
            fly_state(body, comp, u, opening, tau, work.start)
            if what == CLEAR or (what == LANDED and u[Y] >= 0.0):
                work.start[Y] = 0.0
            for m in range(SIZE):
                u[m] = work.start[m]
            t = after
            if what == LANDED:
                regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
                mode = mode_of(regime)
                count = note(events, count, IMPACT, FLIGHT, mode, t, u)
                fresh = True
            continue
        if fresh:
            for which in range(GUARDS):
                value, floor = guard(comp, regime, which, u[Y], u[VT], u[VN], u[Z])
                armed[which] = value > floor
            h = first_step(body, comp, regime, u, rtol)
            warm = False
            fresh = False
            rests, stable = at_rest(body, comp, regime, u, work)
            if rests:
                status = AT_REST
        if status == AT_REST:
            count = note(events, count, REST, mode, mode, t, u)
            if count > 0:
                events[count - 1]["stable"] = 1 if stable else 0
            rows = keep(rows, pieces, t, t_end, HOLD, mode, regime, t, 0.0, work, u)
            pieces += 1
            t = t_end
            break
        if h < SHORTEST:
            status = UNDETERMINED
            break
        left = t_end - t
        last = h >= 0.999 * left
        length = left if last else h
        predict(work, 1.0, length / before if warm else 0.0)
        error = attempt(body, comp, regime, work, u, length, rtol)
        if error >= FAILED:
            # Newton's iteration may have been sent astray by its first guess
            h = (0.25 if not warm else 0.5) * length
            warm = False
            continue
        factor = SAFETY * max(error, 1e-10) ** (-1.0 / ORDER_OF_ERROR)
        if error > 1.0:
            h = max(factor, SLOWER) * length
            continue
        h = min(factor, FASTER) * length
        make_poly(work, u)
        which, s = first_exit(comp, regime, work.poly, armed)
        if which != NONE:
            if s * length < SHORTEST:
                length = 0.0
            else:
                # again, to end where the guard falls, and until it does so to its floor
                done = False
                for _ in range(6):
                    predict(work, 0.0, s)
                    done = attempt(body, comp, regime, work, u, s * length, rtol) < FAILED
                    if not done:
                        break
                    length *= s
                    make_poly(work, u)
                    s = remaining(comp, regime, which, work.poly)
                    if s == 1.0:
                        break
                if not done:
                    h = 0.5 * s * length
                    warm = False
                    continue
                last = False
        if length > 0.0:
            after = t_end if last else t + (length + behind)
            behind = (length + behind) - (after - t)
            rows = keep(rows, pieces, t, after, STEP, mode, regime, t, length, work, u)
            pieces += 1
            spin = poly_value(work.poly, OM, 1.0)
            if way * spin < 0.0:
                s = sign_change(work.poly, OM) if work.poly[OM, 0] * spin < 0.0 else 0.0
                for m in range(SIZE):
                    work.start[m] = poly_value(work.poly, m, s)
                work.start[OM] = 0.0
                count = note(events, count, TURN, mode, mode, t + s * length, work.start)
            if spin != 0.0:
                way = 1.0 if spin > 0.0 else -1.0
            for m in range(SIZE):
                u[m] += work.stages[STAGES - 1, m] if m < DYNAMIC else work.integrals[STAGES - 1, m - DYNAMIC]
            t = after
            warm = True
            before = length
        if which == NONE:
            rests, stable = at_rest(body, comp, regime, u, work)
            if rests:
                status = AT_REST
            continue
        if which == FRICTION_CHANGE:
            was = mode
            if regime != 0:
                regime = np.int64(0)
            elif comp.friction == BRISTLE:
                regime = AHEAD if comp.k_t * u[Z] + comp.c_t * u[VT] > 0.0 else -AHEAD
            else:
                regime = AHEAD if u[VT] > 0.0 else -AHEAD
            mode = mode_of(regime)
            count = note(events, count, STICK if regime == 0 else SLIP_START, was, mode, t, u)
            if comp.friction == TANH:  # smooth across its threshold
                for index in range(GUARDS):
                    value, floor = guard(comp, regime, index, u[Y], u[VT], u[VN], u[Z])
                    armed[index] = value > floor
            else:
                fresh = True
        else:
            count = note(events, count, TAKEOFF, mode, FLIGHT, t, u)
            mode = FLIGHT
            if comp.k * abs(u[Y]) < 1e-8:
                u[Y] = 0.0
    if count >= 0:
        count = note(events, count, END, mode, mode, t, u)
    if count < 0:
        return EVENT_LIMIT, events.shape[0], rows, pieces
    return status, count, rows, pieces


FIRST_EVENTS = 256
MAX_STEPS = 1_000_000


def simulate_compliant(scenario: Scenario) -> tuple[int, np.ndarray, np.ndarray]:
    """Compute the motion of a scenario with compliant contact.

    Parameters
    ----------
    scenario : Scenario
        Its contact is Compliant.

    Returns
    -------
    status : int
        A Status.
    events : ndarray of hophoop.records.layout.EVENT
    segments : ndarray of hophoop.compliant.records.SEGMENT
        Both in units of R, m and √(R/g).
    """
    body, comp, t_end, rtol = to_compliance(scenario)
    start, touching = to_start(scenario, body, comp)
    limit = scenario.contact.max_events
    size = min(FIRST_EVENTS, limit)
    while True:
        events = np.empty(size, EVENT)
        status, count, rows, pieces = run(body, comp, start, touching, t_end, rtol, MAX_STEPS, events)
        if status != EVENT_LIMIT or count < size or size == limit:
            break
        size = min(8 * size, limit)
    if pieces == 0:  # nothing happened before the limit: a piece of no length holds the start
        pieces = 1
        rows[0] = 0.0
        rows[0, KIND] = HOLD
    segments = np.ascontiguousarray(rows[:pieces]).view(SEGMENT)[:, 0]
    return status, events[:count].copy(), segments
