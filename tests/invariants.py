"""Invariants: laws that every computed motion obeys, checked independently (docs/testing.md#random-scenarios)."""

import math
from dataclasses import fields
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from hophoop.kernel.physics.body import PASSING, Event
from hophoop.results.records import Sample
from hophoop.vocabulary.quantities import LOSSES

SPREAD = 25  # equally spaced times, in addition to those of events and between them
BETWEEN = np.array([0.001, 0.03, 0.25, 0.5, 0.75, 0.97, 0.999])  # of the time between events
EPSILON = float(np.finfo(float).eps)
TINY = 1e-290  # close to subnormal numbers, which have fewer digits
ROUNDED = 1e-12  # rounding of forces that cancel, relative to the forces that act
CONE = 2e-11  # the same for the force at the end of rolling, which has the truncation of a margin's series on a panel
PARADOX = 1e-3  # the same of N in slip: N = −f_n/p_σ has few digits near p_σ = 0
SLIPPED = 1e-9  # rounding of slip near zero, relative to the velocities before
LEDGER = 1e-11  # of the energies that take part, in rigid contact
LEDGER_OF_SKIM = 1e-9  # the same for a massless hoop, whose load may round to the top
LEDGER_OF_STEPS, LEDGER_OF_STEP = 1e3, 0.1  # times rtol, in compliant contact: per motion, and per step
LIGHT, ROUGH = 1e-6, 100.0  # κ and friction beyond which a compliant contact is 1000 times less accurate
STATE = ("x", "height", "angle", "vx", "vy", "omega", "slip")
IMPULSES = ("impulse_normal", "impulse_tangential")
ENERGIES = ("kinetic", "potential", "spring", "damping", *LOSSES)


class Finding(NamedTuple):
    """The largest deviation of a motion from an invariant."""

    invariant: str
    value: float  # relative to the size of the compared quantity; 1 for a yes-or-no violation [1]
    allowed: float  # from rounding, or the tolerance of a compliant contact [1]
    t: float  # [s]

    @property
    def broken(self):
        """Return True if the deviation exceeds the bound."""
        return not self.value <= self.allowed


def check(motion):
    """Fail with each invariant that a motion breaks, and with its scenario."""
    broken = [each for each in findings(motion) if each.broken]
    assert not broken, f"{broken} {motion.scenario.to_query()}"


def worst(invariant, t, off, size=1.0, allowed=0.0):
    """Deviation off/size at the times t [s] that exceeds its bound `allowed` most."""
    off, size, allowed, t = (each.ravel() for each in np.broadcast_arrays(*np.atleast_1d(off, size, allowed, t)))
    if not off.size:
        return Finding(invariant, 0.0, 0.0, 0.0)
    value = np.where(off == 0.0, 0.0, off / np.maximum(size, TINY))
    at = int(np.argmax(np.where(np.isnan(value), np.inf, value - allowed)))
    return Finding(invariant, float(value[at]), float(allowed[at]), float(t[at]))


def findings(motion):
    """Largest deviation from each invariant; ends with 'time' or 'finite numbers' if that is broken."""
    found = [_time(motion)]
    if found[0].broken:
        return found
    samples, count = _sampled(motion)
    found.append(_finite(motion, samples))
    if found[1].broken:
        return found
    found += [_modes(motion, samples.t[:count], samples.mode[:count]), _sequence(motion), _direction(motion, samples, count)]
    return [*found, *_contact(motion, samples), *_forces(motion, samples), *_energies(motion, samples)]


def _of(samples, *modes):
    """Return which samples have one of these modes."""
    return np.isin(samples.mode, modes)


def _against_slip(samples):
    """Return the sign of friction that follows from the modes' letters."""
    return np.select([_of(samples, "S"), _of(samples, "K")], [1.0, -1.0], 0.0)


def _sampled(motion):
    """Samples between events, whose number is given as well, spread over the motion, and at both sides of events."""
    instants = np.unique(np.minimum([*(event.t for event in motion.events), motion.duration], motion.duration))
    # in a shorter interval the times between do not lie between both ends in both units
    long = np.diff(instants) > 1e4 * EPSILON * instants[1:]
    between = (instants[:-1][long] + np.outer(BETWEEN, np.diff(instants)[long])).ravel()
    right = motion.at(np.concatenate((between, np.linspace(0.0, motion.duration, SPREAD), instants)))
    left = motion.at(instants, side="left")
    names = [each.name for each in fields(Sample)]
    return Sample(**{name: np.concatenate((getattr(right, name), getattr(left, name))) for name in names}), len(between)


def _time(motion):
    """No event or end of a segment is earlier than its predecessor."""
    pieces, second = motion.tables["segments"], motion.units.time
    ends = np.array([0.0, *(event.t for event in motion.events), motion.duration * (1.0 + 4.0 * EPSILON)])
    begin = np.concatenate((ends[:-1], pieces["t"] * second))
    end = np.concatenate((ends[1:], pieces["t_end"] * second))
    wrong = np.where(np.isfinite(end) & np.isfinite(begin), np.maximum(begin - end, 0.0), math.inf)
    return worst("time", end, wrong, np.abs(begin) + np.abs(end))


def _finite(motion, samples):
    bad = np.zeros(samples.t.shape)
    for name in (each.name for each in fields(Sample) if each.name != "mode"):
        # θ̇ of a massless ring is unbounded just before its load strikes the plane
        bad += ~np.isfinite(getattr(samples, name)) & ~(_of(samples, "M") & (name in ("omega", "vx", "slip")))
    names = (*STATE, *IMPULSES, *LOSSES)
    wrong = [sum(not math.isfinite(getattr(event, name)) for name in names) for event in motion.events]
    return worst("finite numbers", [*samples.t, *(event.t for event in motion.events)], [*bad, *wrong])


def _modes(motion, t, modes):
    """An event starts in the mode after the previous event, and the samples between them have that mode."""
    events = motion.events
    times = np.array([event.t for event in events])
    last = np.searchsorted(times, t, side="right") - 1
    wrong = [event.from_mode != before.to_mode for before, event in pairwise(events)]
    wrong += [mode != events[k].to_mode for mode, k in zip(modes.tolist(), last.tolist(), strict=True)]
    return worst("modes", [*times[1:], *t], np.array(wrong, float))


def _sequence(motion):
    """One letter per phase: phases start at their events and when the mode changes, and last."""
    times = motion.tables["events"]["t"].tolist()  # events at different kernel times may have the same time in seconds
    after = [*times[1:], math.inf if motion.duration > motion.events[-1].t else times[-1]]
    letters, begins = "", False
    for event, now, later in zip(motion.events, times, after, strict=True):
        begins |= Event[event.kind.upper()] not in PASSING
        if later > now:
            if begins or letters[-1:] != event.to_mode:
                letters += event.to_mode
            begins = False
    return worst("sequence", 0.0, float(motion.sequence != (letters or motion.events[-1].to_mode)))


def _direction(motion, samples, count):
    """S slips backward, K forward; with a bristle the letter is the direction of its foot, which may differ from v_t's."""
    scenario = motion.scenario
    wrong = np.maximum(_against_slip(samples) * samples.slip, 0.0)
    if scenario.contact.model != "rigid":  # whose events are found within a tolerance
        wrong[count:] = 0.0
        wrong *= scenario.contact.friction != "bristle"
    # v_t is a difference of velocities of this size; near an equilibrium, rounding of θ sets a hoop in motion
    speed = np.max(scenario.hoop.radius * np.abs(samples.omega) + np.abs(samples.vx) + np.abs(samples.slip))
    size = speed + math.sqrt(scenario.plane.gravity * scenario.hoop.radius)
    return worst("direction of slip", samples.t, wrong, size, SLIPPED)


def _contact(motion, samples):
    """With rigid contact slip is 0 in rolling, the rim has no gap and no normal velocity, and does not penetrate the plane."""
    if motion.scenario.contact.model != "rigid":
        return []
    rolling = [(event.t, event.slip) for event in motion.events if event.to_mode == "R"]
    rolls = _of(samples, "R")
    t, slip = np.array([*rolling, *zip(samples.t[rolls], samples.slip[rolls], strict=True)]).reshape(-1, 2).T
    touching = _of(samples, "R", "S", "K")
    off = np.where(touching, np.abs(samples.height) + np.abs(samples.vy), np.maximum(-samples.height, 0.0))
    # effect of rounding of t, θ and the velocities on the rim
    radius = motion.scenario.hoop.radius
    size = radius * (1.0 + np.abs(samples.angle)) + (np.abs(samples.vy) + radius * np.abs(samples.omega)) * samples.t
    allowed = np.where(touching, 0.0, 16.0 * EPSILON)
    return [worst("rolling", t, np.abs(slip)), worst("contact", samples.t, off, size, allowed)]


def _forces(motion, samples):
    """N ≥ 0 in contact, no force in flight, abs(F) ≤ μs N in rolling, and F = ∓μk N in slip."""
    scenario, contact = motion.scenario, motion.scenario.contact
    static, kinetic = scenario.plane.mu_static, scenario.plane.mu_kinetic
    normal, friction = samples.normal_force, samples.friction_force
    touching, slips, rigid = _of(samples, "R", "S", "K"), _of(samples, "S", "K"), contact.model == "rigid"
    tiny = TINY * max(motion.units.of("normal_force"), 1.0)
    size = scenario.hoop.mass * (scenario.plane.gravity + scenario.hoop.radius * samples.omega**2) + np.abs(normal) + tiny
    pull = np.where(touching, np.maximum(-normal, 0.0), np.abs(normal) + np.abs(friction))
    found = [worst("normal force", samples.t, pull, size, np.where(slips & rigid, PARADOX, ROUNDED))]
    limit = static * np.maximum(normal, 0.0) if math.isfinite(static) else math.inf
    excess = np.where(_of(samples, "R") if rigid else touching, np.maximum(np.abs(friction) - limit, 0.0), 0.0)
    reach = size * (max(1.0, static) if math.isfinite(static) else 1.0) + np.abs(friction)
    # a compliant contact reaches the edge of its cone with the accuracy of the solution
    found.append(worst("friction cone", samples.t, excess, reach, CONE if rigid else 10.0 * (contact.rtol or 1e-9)))
    if rigid or contact.friction == "bristle":
        law = _against_slip(samples) * kinetic * normal if math.isfinite(kinetic) else friction
        off = np.where(slips, np.abs(friction - law), 0.0)
        found.append(worst("sliding friction", samples.t, off, np.abs(friction) + tiny if rigid else reach, 8.0 * EPSILON))
    else:  # friction does not drive the slip, where that is not rounding
        known = touching & (np.abs(samples.slip) > SLIPPED * np.max(np.abs(samples.slip)))
        along = known * np.maximum(friction * np.sign(samples.slip), 0.0)
        found.append(worst("sliding friction", samples.t, along, reach, ROUNDED))
    return found


def _energies(motion, samples):
    """Losses never decrease; energy and losses add up to the energy at the start, at every sample and at the end."""
    ledger = motion.ledger
    parts = [getattr(samples, name) for name in ENERGIES]
    start = sum(getattr(ledger, name) for name in ENERGIES) - ledger.residual
    size = max(ledger.range, *(float(np.max(np.abs(part))) for part in parts), TINY)
    allowed = _ledger_allowed(motion, size)
    lost = np.array([(event.friction, event.rolling_resistance, event.impact_tangential) for event in motion.events])
    back = np.max(np.maximum(lost[:-1] - lost[1:], 0.0), axis=1, initial=0.0)
    off = np.append(np.abs(sum(parts) - start), abs(ledger.residual))
    return [
        worst("losses", [event.t for event in motion.events[1:]], back, size, allowed),
        worst("ledger", np.append(samples.t, motion.duration), off, size, allowed),
    ]


def _ledger_allowed(motion, size):
    hoop, plane, contact = motion.scenario.hoop, motion.scenario.plane, motion.scenario.contact
    pieces, body = motion.tables["segments"], motion.scenario.to_body()
    if contact.model != "rigid":
        allowed = 1e-8 + (LEDGER_OF_STEPS + LEDGER_OF_STEP * len(pieces)) * (contact.rtol or 1e-9)
        return allowed * (LEDGER_OF_STEPS if hoop.inertia_ratio < LIGHT or plane.mu_static > ROUGH else 1.0)
    # friction in slip is μk times the load, and has μk times its rounding
    exact = LEDGER if hoop.inertia_ratio > 0.0 else LEDGER_OF_SKIM
    exact += EPSILON * (plane.mu_kinetic if math.isfinite(plane.mu_kinetic) else 0.0)
    # v_t and θ̇ of each panel in slip are rounded; the mass moves with their sum, which may be 10⁶ to 10⁹ times smaller
    slip, omega = pieces["slip"], pieces["omega"]
    along = np.abs(slip + omega * (1.0 + body.eps * np.cos(pieces["theta"])))
    moved = np.where(slip != 0.0, along * (np.abs(slip) + np.abs(omega)), 0.0)
    rounding = 2.0 * EPSILON * float(np.sum(moved)) + 1e-13 * float(np.max(moved, initial=0.0))
    return exact + rounding * motion.units.energy / size
