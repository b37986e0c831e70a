"""Critical speeds in closed form, case by case."""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.model import Mode
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.arcs import arctangent
from hophoop.kernel.records import EVENT, SEGMENT, STOP_AT_TAKEOFF, STOP_AT_TURN, new_scratch, start_state
from hophoop.kernel.steps import BY_RULE, run
from hophoop.theory.kernels.arcs import TURN
from hophoop.theory.kernels.extrema import FORCE_ANGLE, SPEED_ANGLE, cone_margin_line, highest
from hophoop.theory.kernels.phase_plane import lift_off

STOP = STOP_AT_TURN | STOP_AT_TAKEOFF
ANY_TIME = 1e9  # the turn ends the motion
TRIALS = 32  # speeds at which the outcome is looked at before the lowest change is bisected
EVENTS = 4096
SAMPLES_PER_RADIAN = 30  # of the speed at which rolling slips
NEARLY = 1.05  # times the least so far: a lower sample may lie beside a lower minimum


@noinline
def square_with_slip(body, th, side):
    """Return v² at θ = 0 from which on rolling slips at θ, on one side of the cone; infinite if it never does.

    The margin to the cone is a line in v², here of a hoop that rolls when v is small.
    """
    steady, rate = cone_margin_line(body, th, side)
    return max(steady, 0.0) / -rate if rate < 0.0 else math.inf


@noinline
def slip_from_rolling(body, scratch):
    """Return (v², θ, side): the least square of the speed at θ = 0 from which on rolling slips, where, and on which side.

    The lowest samples are refined between their neighbours. Searching the whole turn by `highest` would take 10 times as long,
    four times the rest of a fate; on random hoops it found no other place.
    """
    end = math.pi if body.gt == 0.0 else TURN  # on the level both halves of a turn are alike, with the sides exchanged
    count = round(end * SAMPLES_PER_RADIAN)
    step = end / count
    least, place, edge = math.inf, math.nan, 1.0
    for side in (1.0, -1.0):
        before = math.inf
        here = square_with_slip(body, 0.0, side)
        for k in range(count + 1):
            after = square_with_slip(body, step * (k + 1), side) if k < count else math.inf
            if here <= before and here <= after and here < NEARLY * least:
                low, high = step * max(k - 1, 0), step * min(k + 1, count)
                _, th = highest(SPEED_ANGLE, body, 0.0, low, high, side, scratch)
                square = square_with_slip(body, th, side)
                if square < least:
                    least, place, edge = square, th, side
            before, here = here, after
    return least, place, edge


@noinline
def first_slip(body, scratch):
    """Speed at θ = 0 from which on rolling slips, with the angle and the side of the cone; (0, nan, side) from any push on."""
    if math.isinf(body.mu_s):
        return math.inf, math.nan, 1.0
    end = math.pi if body.gt == 0.0 else TURN
    for side in (1.0, -1.0):
        angle, _ = highest(FORCE_ANGLE, body, 0.0, 0.0, end, side, scratch)
        if angle >= arctangent(body.mu_s):
            return 0.0, math.nan, side
    square, where, side = slip_from_rolling(body, scratch)
    return math.sqrt(square), where, side


def slip_speed(body):
    """The smallest speed at θ = 0 with slip in the first turn."""
    return first_slip(body, new_scratch())[0]


def hop_speed(body, turns):
    """The smallest speed at θ = 0 with a hop in the first turns, to the last bit; infinite where there is none."""
    most = lift_off(body, 0.0)
    if math.isinf(most) or most == 0.0:
        return most
    events = np.empty(EVENTS, EVENT)
    segments = np.empty(0, SEGMENT)
    scratch = new_scratch()
    low = 0.0
    high = most
    trial = 1
    while True:
        speed = most * trial / TRIALS if trial < TRIALS else 0.5 * (low + high)
        if not low < speed < high:
            return high
        start = start_state(0.0, 0.0, 0.0, 0.0, 0.0, speed)
        _, count, _ = run(body, start, BY_RULE, ANY_TIME, turns * TURN, STOP, events, segments, scratch)
        hops = False
        for k in range(count):
            hops = hops or events[k]["after_mode"] == Mode.FLIGHT
        if hops:
            high = speed
            trial = TRIALS
        else:
            low = speed
            trial += 1
