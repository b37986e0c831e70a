"""Invariants: laws that every computed motion obeys, checked independently (docs/testing.md#random-scenarios)."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.physics.body import PASSING, Event
from hophoop.results.records import ArraySample, Ledger, Sample
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.quantities import LOSSES

Floats = NDArray[np.float64]

INVARIANTS = (
    "time", "finite numbers", "modes", "sequence", "rolling", "direction of slip", "contact", "gap", "normal force",
    "friction cone", "sliding friction", "losses", "ledger",
)  # fmt: skip
SPREAD = 25  # equally spaced times, in addition to those of events and the middles between them
IN_FLIGHT = np.array([0.0, 1e-6, 1e-3, 0.03, 0.1, 0.25, 0.5, 0.75, 0.9, 0.97, 0.999, 1.0])  # of the time between events
EPSILON = float(np.finfo(float).eps)
TINY = 1e-290  # close to subnormal numbers, which have fewer digits
ROUNDED = 1e-12  # rounding of forces that cancel, relative to the forces that act
SLIPPED = 1e-13  # rounding of slip near zero, relative to the velocities before
LEDGER = 1e-11  # of the energies that take part, in rigid contact
RESOLVED = 1e-14  # of v_t and θ̇: truncation error of a panel's series
LEDGER_OF_SKIM = 1e-9  # the same for a massless hoop, whose load may round to the top
LEDGER_OF_STEPS, LEDGER_OF_STEP = 1e3, 0.1  # times rtol, in compliant contact: per motion, and per step
LIGHT, ROUGH = 1e-6, 100.0  # κ and friction beyond which a compliant contact is 1000 times less accurate
STATE = ("x", "height", "angle", "vx", "vy", "omega", "slip")
IMPULSES = ("impulse_normal", "impulse_tangential")


class Finding(NamedTuple):
    """The largest deviation of a motion from an invariant."""

    invariant: str  # one of `INVARIANTS`, 'mirror' or 'units'
    value: float  # relative to the size of the compared quantity; 1 for a yes-or-no violation [1]
    allowed: float  # from rounding, or the tolerance of a compliant contact [1]
    t: float  # [s]
    words: str

    @property
    def broken(self) -> bool:
        """Return True if the deviation exceeds the bound."""
        return not self.value <= self.allowed


def check(motion: Trajectory) -> None:
    """Fail with each invariant that a motion breaks, and with its scenario."""
    broken = [each for each in findings(motion) if each.broken]
    assert not broken, f"{broken} {motion.scenario.to_query()}"


def findings(motion: Trajectory) -> list[Finding]:
    """Largest deviation from each of `INVARIANTS`, in their order; ends with 'time' or 'finite numbers' if that is broken."""
    found = [_time(motion)]
    if found[0].broken:
        return found
    course = _course(motion)
    found.append(_finite(course))
    if found[1].broken:
        return found
    found += [_modes(course), _sequence(course), _rolling(course), _direction(course), _contact(course), _gap(course)]
    return [*found, *_forces(course), *_energies(course)]


@dataclass(frozen=True)
class _Course:
    """A motion with its events and samples as columns."""

    motion: Trajectory
    t: Floats  # of events
    ends: Floats  # of the intervals between events
    letters: list[str]  # of the intervals
    begins: list[bool]  # True if an event at the start of the interval starts a phase
    middles: ArraySample  # of the intervals
    samples: ArraySample  # all
    ledger: Ledger
    contact: str  # rigid, or the friction of a compliant contact

    def of(self, *modes: str) -> NDArray[np.bool_]:
        """Return which samples have one of these modes."""
        return np.isin(self.samples.mode, modes)

    def against_slip(self, sample: ArraySample) -> Floats:
        """Return the sign of friction that follows from the modes' letters."""
        return np.select([np.equal(sample.mode, "S"), np.equal(sample.mode, "K")], [1.0, -1.0], 0.0)


def _course(motion: Trajectory) -> _Course:
    t = np.array([event.t for event in motion.events])
    # events at different kernel times may have the same time in seconds
    kernel_t = motion.tables["events"]["t"]
    instants, first = np.unique(kernel_t, return_index=True)
    ends = np.minimum(t[first], motion.duration)
    if motion.duration > ends[-1]:
        instants, ends = np.append(instants, math.inf), np.append(ends, motion.duration)
    # a shorter interval has no middle that lies between both ends in both units
    long = np.diff(ends) > 8.0 * EPSILON * ends[1:]
    middles = (ends[:-1] + 0.5 * np.diff(ends))[long]
    spread = np.linspace(0.0, motion.duration, SPREAD)
    right = motion.at(np.concatenate((middles, spread, ends)))
    left = motion.at(ends, side="left")
    names = [each.name for each in fields(Sample)]
    middle = Sample(**{name: getattr(right, name)[: len(middles)] for name in names})
    samples = Sample(**{name: np.concatenate((getattr(right, name), getattr(left, name))) for name in names})
    modes = np.array([event.to_mode for event in motion.events])
    letters = modes[np.searchsorted(kernel_t, instants[:-1], side="right") - 1]
    letters[long] = middle.mode
    begins = {float(at) for at, event in zip(kernel_t, motion.events, strict=False) if Event[event.kind.upper()] not in PASSING}
    begin = [at in begins for at in instants[:-1].tolist()]
    contact = motion.scenario.contact
    kind = "rigid" if contact.model == "rigid" else contact.friction
    return _Course(motion, t, ends, letters.tolist(), begin, middle, samples, motion.ledger, kind)


def worst(invariant: str, words: str, t: Any, off: Any, size: Any = 1.0, allowed: Any = 0.0) -> Finding:
    """Deviation off/size at the times t [s] that exceeds its bound `allowed` most."""
    off, size, allowed, t = (each.ravel() for each in np.broadcast_arrays(*np.atleast_1d(off, size, allowed, t)))
    if not off.size:
        return Finding(invariant, 0.0, 0.0, 0.0, words)
    value = np.where(off == 0.0, 0.0, off / np.maximum(size, TINY))
    at = int(np.argmax(np.where(np.isnan(value), np.inf, value - allowed)))
    return Finding(invariant, float(value[at]), float(allowed[at]), float(t[at]), words)


def _time(motion: Trajectory) -> Finding:
    """No event or end of a segment is earlier than its predecessor."""
    pieces = motion.tables["segments"]
    second = motion.units.time
    ends = np.array([event.t for event in motion.events])
    ends = np.concatenate(([0.0], ends, [motion.duration * (1.0 + 4.0 * EPSILON)]))
    begin, end = ends[:-1], ends[1:]
    begin = np.concatenate((begin, pieces["t"] * second))
    end = np.concatenate((end, pieces["t_end"] * second))
    wrong = np.where(np.isfinite(end) & np.isfinite(begin), np.maximum(begin - end, 0.0), math.inf)
    return worst("time", "time runs backward", end, wrong, np.abs(begin) + np.abs(end))


def _finite(course: _Course) -> Finding:
    samples, events = course.samples, course.motion.events
    bad = np.zeros(samples.t.shape)
    for each in fields(Sample):
        if each.name != "mode":
            odd = ~np.isfinite(getattr(samples, each.name))
            # θ̇ of a massless ring is unbounded just before its load strikes the plane
            bad += odd & ~((each.name in ("omega", "vx", "slip")) & course.of("M"))
    names = (*STATE, *IMPULSES, *LOSSES)
    wrong = np.array([sum(not math.isfinite(getattr(event, name)) for name in names) for event in events])
    return worst("finite numbers", "numbers are not finite", np.append(samples.t, course.t), np.append(bad, wrong))


def _modes(course: _Course) -> Finding:
    """An event starts in the mode after the previous event, and the samples between them have that mode."""
    events = course.motion.events
    before = [event.from_mode for event in events[1:]]
    after = [event.to_mode for event in events]
    last = np.searchsorted(course.t, course.middles.t, side="right") - 1
    wrong = [mode != other for mode, other in zip(before, after[:-1], strict=True)]
    wrong += [mode != after[k] for mode, k in zip(course.middles.mode.tolist(), last.tolist(), strict=True)]
    where = np.concatenate((course.t[1:], course.middles.t))
    return worst("modes", "an event and the motion next to it have different modes", where, np.array(wrong, float))


def _sequence(course: _Course) -> Finding:
    """The sequence has one letter per phase of the samples; phases start at their events and when the mode changes."""
    events, given = course.motion.events, course.motion.sequence
    letters: list[tuple[str, float]] = []
    for t, begins, mode in zip(course.ends.tolist(), course.begins, course.letters, strict=False):
        if not letters or begins or letters[-1][0] != mode:
            letters.append((mode, t))
    expected = "".join(mode for mode, _ in letters) or events[-1].to_mode
    if given == expected:
        return Finding("sequence", 0.0, 0.0, 0.0, "")
    at = next(
        (k for k, (one, two) in enumerate(zip(given, expected, strict=False)) if one != two), min(len(given), len(expected))
    )
    words = f"the sequence goes on with {given[at : at + 8]!r} where the samples are {expected[at : at + 8]!r}"
    return Finding("sequence", 1.0, 0.0, letters[at][1] if at < len(letters) else course.motion.duration, words)


def _rolling(course: _Course) -> Finding:
    """Slip is 0 in rolling with rigid contact; compliant contacts creep."""
    rigid = course.contact == "rigid"
    rolls = [event for event in course.motion.events if event.to_mode == "R" and rigid]
    rolling = course.of("R") & rigid
    t = np.append(course.samples.t[rolling], [event.t for event in rolls])
    slip = np.append(course.samples.slip[rolling], [event.slip for event in rolls])
    return worst("rolling", "v_t is not zero in rolling [m/s]", t, np.abs(slip))


def _direction(course: _Course) -> Finding:
    """S slips backward, K forward; with a bristle the letter is the direction of its foot, which may differ from v_t's."""
    sample, scenario = course.middles if course.contact != "rigid" else course.samples, course.motion.scenario
    wrong = np.maximum(course.against_slip(sample) * sample.slip, 0.0) * (course.contact != "bristle")
    # v_t is a difference of velocities of this size; near an equilibrium, rounding of θ sets a hoop in motion
    every = course.samples
    speed = np.max(scenario.hoop.radius * np.abs(every.omega) + np.abs(every.vx) + np.abs(every.slip))
    size = speed + math.sqrt(scenario.plane.gravity * scenario.hoop.radius)
    if scenario.plane.mu_kinetic == 0.0 < scenario.hoop.inertia_ratio:
        # v_t may have the rounding of the rim's speed when the load was lowest
        eccentricity, inertia = scenario.hoop.eccentricity, scenario.hoop.inertia_ratio
        size *= 1.0 + (1.0 - eccentricity) * math.sqrt(4.0 * eccentricity / inertia)
    share = _shares(course)
    allowed = SLIPPED + (EPSILON / np.min(share) if share.size else 0.0)
    return worst("direction of slip", "the direction of slip contradicts the mode", sample.t, wrong, size, allowed)


def _contact(course: _Course) -> Finding:
    """In rigid contact the rim has no gap and no normal velocity."""
    samples = course.samples
    off = np.where(course.of("R", "S", "K"), np.abs(samples.height) + np.abs(samples.vy), np.maximum(-samples.height, 0.0))
    words = "the rim is not on the plane [m, m/s]"
    return worst("contact", words, samples.t, off * (course.contact == "rigid"))


def _gap(course: _Course) -> Finding:
    """In flight the gap, computed here from the parabola of G, is never negative."""
    scenario, t = course.motion.scenario, np.append(course.t, course.motion.duration)
    rigid = course.contact == "rigid"
    flying = [k for k, event in enumerate(course.motion.events) if rigid and event.to_mode == "H" and t[k + 1] > t[k]]
    events = [course.motion.events[k] for k in flying]
    end = t[np.array(flying, int) + 1][:, None]
    begin, height, angle, vy, omega = (
        np.array([getattr(event, name) for event in events])[:, None] for name in ("t", "height", "angle", "vy", "omega")
    )
    gravity = scenario.plane.gravity * math.cos(scenario.plane.slope)
    arm = scenario.hoop.radius * scenario.hoop.eccentricity
    tau = IN_FLIGHT * (end - begin)
    turn = omega * tau
    rise = vy - arm * omega * np.sin(angle)
    fall = 0.5 * gravity * tau**2
    gap = height + rise * tau - fall + 2.0 * arm * np.sin(angle + 0.5 * turn) * np.sin(0.5 * turn)
    # effect of rounding of t, θ and the velocities on the rim
    turned = np.minimum(np.abs(angle) + np.abs(omega) * end, 1.0 / EPSILON)
    size = scenario.hoop.radius + height + fall + (np.abs(rise) + np.abs(vy) + gravity * tau) * (tau + end)
    size += arm * (1.0 + np.abs(turn)) * (1.0 + turned)
    return worst("gap", "the rim penetrates the plane", begin + tau, np.maximum(-gap, 0.0), size, 16.0 * EPSILON)


def _forces(course: _Course) -> list[Finding]:
    """N ≥ 0 in contact, no force in flight, abs(F) ≤ μs N in rolling, and F = ∓μk N in slip."""
    samples, scenario = course.samples, course.motion.scenario
    static, kinetic = scenario.plane.mu_static, scenario.plane.mu_kinetic
    normal, friction = samples.normal_force, samples.friction_force
    touching, rigid = course.of("R", "S", "K"), course.contact == "rigid"
    tiny = TINY * max(course.motion.units.of("normal_force"), 1.0)
    size = scenario.hoop.mass * (scenario.plane.gravity + scenario.hoop.radius * samples.omega**2) + np.abs(normal) + tiny
    pull = np.where(touching, np.maximum(-normal, 0.0), np.abs(normal) + np.abs(friction))
    words = "the plane pulls, or a force acts without contact"
    found = [worst("normal force", words, samples.t, pull, size, ROUNDED + _loss_of_digits(course))]
    limit = static * np.maximum(normal, 0.0) if math.isfinite(static) else math.inf
    excess = np.where(course.of("R") if rigid else touching, np.maximum(np.abs(friction) - limit, 0.0), 0.0)
    reach = size * (max(1.0, static) if math.isfinite(static) else 1.0) + np.abs(friction)
    # a compliant contact reaches the edge of its cone with the accuracy of the solution
    allowed = ROUNDED if scenario.contact.model == "rigid" else 10.0 * (scenario.contact.rtol or 1e-9)
    found.append(worst("friction cone", "friction is beyond its cone", samples.t, excess, reach, allowed))
    if course.contact in ("rigid", "bristle"):
        law = course.against_slip(samples) * kinetic * normal if math.isfinite(kinetic) else friction
        off = np.where(course.of("S", "K"), np.abs(friction - law), 0.0)
        size = np.abs(friction) + tiny if rigid else reach
        return [*found, worst("sliding friction", "F is not μk N against the slip", samples.t, off, size, 8.0 * EPSILON)]
    # a slip velocity within rounding has no known sign
    known = np.abs(samples.slip) > SLIPPED * _slip_of_step(course)
    along = np.where(touching & known, np.maximum(friction * np.sign(samples.slip), 0.0), 0.0)
    return [*found, worst("sliding friction", "friction drives the slip", samples.t, along, reach, ROUNDED)]


def _loss_of_digits(course: _Course) -> Floats:
    """Return the rounding of N relative to the forces at each sample: N = −f_n/p_σ amplifies that of f_n near p_σ = 0."""
    samples, body = course.samples, course.motion.scenario.to_body()
    loss = np.zeros(samples.t.shape)
    slips = course.of("S", "K") & (course.contact == "rigid")
    if not (body.kap > 0.0 and math.isfinite(body.mu_k) and np.any(slips)):
        return loss
    sigma = -course.against_slip(samples)[slips]
    lever = body.eps * np.sin(samples.angle[slips])
    arm = 1.0 + body.eps * np.cos(samples.angle[slips])
    couple = body.resist * np.sign(samples.omega[slips])
    stiffness = 1.0 + lever * (lever + sigma * body.mu_k * arm - couple) / body.kap
    loss[slips] = 4.0 * EPSILON / np.maximum(np.abs(stiffness), EPSILON)
    return loss


def _largest_in_piece(course: _Course, values: Floats) -> Floats:
    """Return, for each sample, the value of its segment; at a boundary of two segments the larger one."""
    motion = course.motion
    begins = motion.tables["segments"]["t"]
    t = motion.units.kernel_times(motion.tables["segments"], course.samples.t)
    later = np.maximum(np.searchsorted(begins, t, side="right") - 1, 0)
    before = np.maximum(np.searchsorted(begins, t, side="left") - 1, 0)
    found: Floats = np.maximum(values[later], values[before])
    return found


def _slip_of_step(course: _Course) -> Floats:
    """Return the sum of absolute terms of the step's polynomial for v_t at each sample of a compliant motion [m/s]."""
    pieces = course.motion.tables["segments"]
    names = [name for name in pieces.dtype.names or () if name.startswith("slip_")]
    terms = np.sum([np.abs(pieces[name]) for name in names], axis=0) * course.motion.units.of("slip")
    return _largest_in_piece(course, terms)


def _unresolved(course: _Course) -> Floats:
    """Return the energy of the truncation errors of v_t and θ̇ at each sample of slip [J].

    Unlike in `rounding_energy` they do not accumulate, but they are larger: each panel is resolved to `RESOLVED`.
    """
    samples, pieces, hoop = course.samples, course.motion.tables["segments"], course.motion.scenario.hoop
    energy = np.zeros(samples.t.shape)
    slips = course.of("S", "K")
    if course.contact == "rigid" and np.any(slips):
        largest = _largest_in_piece(course, np.abs(pieces["slip"]) + np.abs(pieces["omega"])) * course.motion.units.of("slip")
        arm = hoop.radius * hoop.eccentricity * np.cos(samples.angle[slips])
        along = np.abs(samples.vx[slips] + samples.omega[slips] * arm)
        energy[slips] = hoop.mass * along * RESOLVED * largest[slips]
    return energy


def _energies(course: _Course) -> list[Finding]:
    """Losses never decrease; energy and losses add up to the energy at the start, at every sample and at the end."""
    samples, ledger = course.samples, course.ledger
    parts = [getattr(samples, name) for name in ("kinetic", "potential", "spring", "damping", *LOSSES)]
    start = sum(getattr(ledger, name) for name in ("kinetic", "potential", "spring", "damping", *LOSSES)) - ledger.residual
    size = max(ledger.range, *(float(np.max(np.abs(part))) for part in parts))
    allowed = _ledger_allowed(course, size)
    lost = np.array([(event.friction, event.rolling_resistance, event.impact_tangential) for event in course.motion.events])
    back = np.max(np.maximum(lost[:-1] - lost[1:], 0.0), axis=1, initial=0.0)
    off = np.append(np.abs(sum(parts) - start), abs(ledger.residual))
    t = np.append(samples.t, course.motion.duration)
    unresolved = _unresolved(course) / max(size, TINY)
    unresolved = np.append(unresolved, unresolved[np.argmax(samples.t)])
    return [
        worst("losses", "dissipated energy decreases", course.t[1:], back, size, allowed),
        worst("ledger", "the energy ledger does not close", t, off, size, allowed + unresolved),
    ]


def _ledger_allowed(course: _Course, size: float) -> float:
    motion, hoop, plane = course.motion, course.motion.scenario.hoop, course.motion.scenario.plane
    if motion.scenario.contact.model != "rigid":
        rtol = motion.scenario.contact.rtol or 1e-9
        allowed = 1e-8 + (LEDGER_OF_STEPS + LEDGER_OF_STEP * len(motion.tables["segments"])) * rtol
        return allowed * (LEDGER_OF_STEPS if hoop.inertia_ratio < LIGHT or plane.mu_static > ROUGH else 1.0)
    # friction in slip is μk times the load, and has μk times its rounding
    exact = LEDGER if hoop.inertia_ratio > 0.0 else LEDGER_OF_SKIM
    allowed = exact + EPSILON * (plane.mu_kinetic if math.isfinite(plane.mu_kinetic) else 0.0)
    share = _shares(course)
    lost = float(np.max(course.samples.friction)) / size if size > 0.0 else 0.0
    return allowed + (rounding_energy(motion) / size if size > 0.0 else 0.0) + lost * float(np.sum(EPSILON / share**2))


def _shares(course: _Course) -> Floats:
    """Return the fractions, if small, of their panels after which slip ends.

    The work of such a slip is a product of two quantities that grow along the panel. Its rounding is that of the whole panel's
    work, of which it is only the square of the fraction.
    """
    if course.contact != "rigid":
        return np.empty(0)
    pieces = course.motion.tables["segments"]
    share = 0.5 * (1.0 + pieces["xi"][(pieces["sigma"] != 0) & (pieces["kind"] < 3)])
    found: Floats = share[(share < 0.1) & (share > 0.0)]
    return found


def rounding_energy(motion: Trajectory) -> float:
    """Energy [J] of the rounding of the velocities, added up over the panels of a rigid motion.

    Every panel ends with v_t and θ̇ rounded to doubles. Either rounding moves the mass, whose velocity is their sum; if they
    are 10⁶ to 10⁹ times that sum, this is visible. Half a unit in the last place counts for v_t, and a whole one for θ̇, the
    root of a rounded sum.
    """
    segments, body = motion.tables["segments"], motion.scenario.to_body()
    slip, omega, theta = (segments[name] for name in ("slip", "omega", "theta"))
    slips = slip != 0.0  # in rolling they do not cancel
    along = slip + omega * (1.0 - body.eps + body.eps * (1.0 + np.cos(theta)))
    moved = np.abs(along) * (0.5 * np.spacing(np.abs(slip)) + np.spacing(np.abs(omega)))
    return float(np.sum(moved[slips])) * motion.units.energy
