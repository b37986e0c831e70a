"""The fate of a motion: what physics decides for ever, long before the end of time (docs/gaits.md#fates).

* On the level energy only falls, except in bounces under Newton's law. Below the potential energy of the load at the top the
  hoop never gets over it again.
* On a slope a well of energy may never be left again (`wells`).
* Rolling loses nothing: a revolution without slip on the level, or a swing between two turning points, repeats for ever.
* On the level without hops the loss of a revolution falls with the square of the speed above the first slip, so that the slip
  never ends. With less friction in slip than in rolling it falls to a loss that is not 0, and the hoop rolls in the end.
* A section that is reached in the same state again, with differences that shrink so fast that their sum is small, has a stable
  gait. A revolution of rolling on a slope is none: it loses nothing of what the slope gives.
* Down a slope a hoop runs away that has become many times as fast as it was.
"""

from __future__ import annotations

import math

from hophoop.gaits.kernels.layout import HOPS, LANDING, LETTERS, MODE, OMEGA, ROLL, SLIP, THETA, TURNS
from hophoop.gaits.kernels.wells import stays_in_well
from hophoop.kernel.model import (
    ImpactLaw,
    Mode,
    kinetic_energy,
    potential_energy,
)
from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.theory.kernels.extrema import cone_margin_line
from hophoop.vocabulary.names import FateCode

OPEN = -1  # not decided so far

LONGEST_PERIOD = 64
SAME, NEAR, NOISE = 1e-10, 1e-7, 1e-13  # differences of two passages of a gait: now, one period ago, and rounding
AHEAD = 1e-5  # the most that all differences to come may add up to
FAST, FASTER = 1e3, 1e2  # √(g/R), and times the speed of the start: a hoop that rotates so fast down a slope runs away
ANGLES, HOLDS = 64, 1e-3  # of half a revolution at which rolling is looked at, and its least margin to the friction cone [m g]
HALF = 3.0  # rad, about half a revolution: more of one passage than of rocking
BELOW = 1e-12  # m g R: by which the energy is below that of the load at the top

# What is remembered of a motion: the turning points of this phase of rolling, and all in contact.
ROLLING_TURNS, CONTACT_TURNS = range(2)
MEMORY = 2


@noinline
def fate_at_start(body, state):
    """Return the fate of a motion without friction that slides along the plane, else OPEN."""
    if body.mu_s > 0.0 or body.gn == 0.0:
        return OPEN
    c = sine_cosine(state.th, state.th_low)[1]
    drifts = state.vt + state.om * (1.0 + body.eps * c) != 0.0
    return FateCode.SLIDES_AWAY if body.gt != 0.0 or drifts else OPEN


@noinline
def fastest_of(body, state):
    """Return |θ̇| from which a motion down a slope runs away: many times the speed of its start."""
    energy = kinetic_energy(body, state.th, state.om, state.vt, state.vn, state.th_low) + body.gn * state.y
    return max(FAST, FASTER * math.sqrt(2.0 * energy))


@inline
def gains_in_impacts(body):
    """Return True if an impact can create energy, as friction may under Newton's law (Kane)."""
    return body.law == ImpactLaw.NEWTON and body.rest > 0.0 and body.mu_k > 0.0


@noinline
def fate_at_turn(body, event, memory):
    """Return the fate after a turning point in contact."""
    rolls = event["after_mode"] == Mode.ROLL
    memory[CONTACT_TURNS] += 1.0
    if rolls:
        memory[ROLLING_TURNS] += 1.0
    if body.resist == 0.0 and memory[ROLLING_TURNS] >= 2.0:
        return FateCode.ROCKS
    # The first swing may be one without slip: then the loss is known too.
    level = body.gt == 0.0 and not gains_in_impacts(body)  # `is_below_top` is enough there
    if level or (rolls and body.resist == 0.0 and memory[CONTACT_TURNS] < 2.0):
        return OPEN
    if stays_in_well(body, event["theta"], event["slip"], 0.0):
        return FateCode.ROCKS if body.resist == 0.0 else FateCode.RESTS
    return OPEN


@inline
def is_below_top(body, state):
    """Return True if a hoop on the level can never again have its load at the top."""
    if body.gt != 0.0 or body.gn == 0.0 or body.eps == 0.0 or body.mu_s == 0.0 or gains_in_impacts(body):
        return False
    potential = potential_energy(body, 0.0, state.y, state.th)
    return potential < 0.0 and potential + kinetic_energy(body, state.th, state.om, state.vt, state.vn, state.th_low) < -BELOW


@inline
def angle_between(one, other):
    """Return the angle from one passage to another [rad]."""
    return (other[TURNS] - one[TURNS]) * TWO_PI + (other[THETA] - one[THETA])


@noinline
def difference(buffers, k, period, section):
    """Return the largest difference of passage k from that a period before, relative to 1 + θ̇; inf with other phases."""
    row, other = k % len(buffers.numbers), (k - period) % len(buffers.numbers)
    last, before, words = buffers.numbers[row], buffers.numbers[other], buffers.words
    if last[MODE] != before[MODE] or words[row, 0] != words[other, 0] or words[row, 1] != words[other, 1]:
        return math.inf
    worst = 0.0
    for column in range(SLIP, OMEGA + 1):
        worst = max(worst, abs(last[column] - before[column]))
    if section == LANDING:
        turned = (last[THETA] - before[THETA]) / TWO_PI
        worst = max(worst, TWO_PI * abs(turned - math.floor(turned + 0.5)))
    return worst / (1.0 + abs(last[OMEGA]))


@noinline
def period_of(buffers, k, section):
    """Return the period of passage k, in passages, or 0: the same state and sequences came before, ever more exactly."""
    for period in range(1, min(LONGEST_PERIOD, k // 2, (len(buffers.numbers) - 1) // 2) + 1):
        now = difference(buffers, k, period, section)
        if not now <= SAME:
            continue
        past = difference(buffers, k - period, period, section)
        if past <= NEAR and is_near_limit(now, past):
            for part in range(1, period):
                if period % part == 0 and difference(buffers, k, part, section) <= NEAR:
                    return part
            return period
    return 0


@inline
def is_near_limit(now, past):
    """Return True if differences that go on as a geometric sequence have a small sum, or are rounding."""
    return past <= NOISE or (now <= NOISE and now <= past) or now * now < AHEAD * (past - now)


@noinline
def rolls_slowly(body):
    """Return True if a hoop on the level that only just gets over the top does so without slip."""
    for k in range(1, ANGLES):
        for side in (1.0, -1.0):
            if not cone_margin_line(body, PI * k / ANGLES, side)[0] > HOLDS:
                return False
    return True


@noinline
def fate_at_passage(body, buffers, k, section, fastest):
    """Return (fate, period) after passage k; the period is 0 except in a gait."""
    numbers, length = buffers.numbers, len(buffers.numbers)
    last, before = numbers[k % length], numbers[(k - 1) % length]
    om = last[OMEGA]
    if abs(om) > fastest and om * body.gt > 0.0:
        return FateCode.RUNS_AWAY, 0
    if k < 1 or (section == LANDING and body.gt == 0.0):
        return OPEN, 0
    way = math.copysign(1.0, om)
    revolved = way * angle_between(before, last) > HALF
    rolled = section != LANDING and revolved and last[LETTERS] == 1.0 and last[MODE] == ROLL
    if body.gt == 0.0:
        if rolled and body.resist == 0.0:
            return FateCode.ROLLS_AHEAD if om > 0.0 else FateCode.ROLLS_BACK, 0
        if rolled and body.gn > 0.0:
            return FateCode.RESTS, 0
        first = numbers[(k - 2) % length]
        steady = k >= 2 and revolved and first[HOPS] == last[HOPS] and body.resist == 0.0 and body.mu_k == body.mu_s
        rolls = last[MODE] == ROLL and before[MODE] == ROLL and first[MODE] == ROLL
        fell, falls = way * (first[OMEGA] - before[OMEGA]), way * (before[OMEGA] - om)
        if steady and rolls and 0.0 < falls < fell and rolls_slowly(body):
            return FateCode.SLIPS_EVER_LESS, 0
        return OPEN, 0
    if rolled and body.eps == 0.0 and way * (om - before[OMEGA]) > 0.0:
        return FateCode.RUNS_AWAY, 0
    if rolled and body.resist == 0.0:  # it gains what the slope gives, however little
        return OPEN, 0
    period = period_of(buffers, k, section)
    if period > 0 and abs(angle_between(numbers[(k - period) % length], last)) > HALF:
        return FateCode.GAIT, period
    return OPEN, 0
