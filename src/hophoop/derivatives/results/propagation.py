"""Derivatives of a motion through all its events, read in SI units."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.layout import (
    IMPACT_N,
    IMPACT_T,
    OM,
    PARAMETERS,
    ROLLING_LOSS,
    STATE_ROWS,
    VT,
    Reason,
    T,
)
from hophoop.derivatives.parameters import Directions, Floats, directions_of
from hophoop.derivatives.results.friction_utilization import (
    KERNELS,
    greatest_peaks,
    settled_by,
    use_rates,
)
from hophoop.derivatives.units import (
    DIRECT,
    ENERGY,
    SPEED,
    UNIT_OF_ROW,
    UNITS,
    sizes_and_rates,
)
from hophoop.derivatives.workspace import KnownMotion, Pieces, Samples, Solution, new_solution, new_workspace
from hophoop.kernel.model import Body, Event
from hophoop.kernel.native import compiled
from hophoop.kernel.records import thread_scratch
from hophoop.results.records import Motion
from hophoop.scenario import InputError
from hophoop.vocabulary.quantities import QUANTITIES

COLUMNS = ("x", "height", "theta", "omega", "slip", "vy")  # of a state, in the order of its tangents from row X on
ENERGIES = ("kinetic", "potential", "total", "friction")
SUMS = {"vx": ("slip", "omega"), "before.vx": ("before.slip", "before.omega")}
FIELDS = (*DIRECT, *SUMS, *ENERGIES)

BORDER = int(Reason.BORDER)


def unit_of(field: str) -> str:
    """SI unit of what can be asked of an event or a time.

    Parameters
    ----------
    field : str
        One of FIELDS.

    Returns
    -------
    unit : str
    """
    return QUANTITIES[field.removeprefix("before.")].unit


@dataclass(frozen=True)
class WithDerivatives:
    """A number, or some, in SI units, with its derivatives in all directions; `smaller` holds the other side, if given."""

    value: Any
    rates: Floats
    smaller: Floats | None = None

    def __add__(self, other: WithDerivatives) -> WithDerivatives:
        return WithDerivatives(self.value + other.value, self.rates + other.rates)

    def __sub__(self, other: WithDerivatives) -> WithDerivatives:
        return WithDerivatives(self.value - other.value, self.rates - other.rates)

    def __neg__(self) -> WithDerivatives:
        return WithDerivatives(-self.value, -self.rates)


@dataclass(frozen=True)
class TangentSolution:
    """A motion and its derivatives in some directions; made by `propagate`.

    Attributes
    ----------
    motion : Motion
    directions : Directions
    at_events : ndarray, shape (events, EVENT_ROWS, n)
    at_segments : ndarray, shape (segments, STATE_ROWS, n)
        In kernel units.
    reasons, failed : ndarray of int, shape (n,)
        Why there is no derivative, and from which event on.
    """

    motion: Motion
    directions: Directions
    at_events: Floats
    at_segments: Floats
    reasons: NDArray[np.int64]
    failed: NDArray[np.int64]

    @property
    def one_sided(self) -> list[int]:
        """The directions that may have another derivative towards smaller parameters."""
        return [k for k, reason in enumerate(self.reasons.tolist()) if reason < 0 or reason == BORDER]

    def in_si(self, value: Any, rates: Floats, exponents: tuple[int, int, int]) -> WithDerivatives:
        """A number in kernel units, with its derivatives, in SI units, which change with radius, gravity and mass."""
        size, by_units = (each[UNITS.index(exponents)] for each in self._units)
        steeper = value * by_units if np.ndim(value) == 0 else value[..., None] * by_units
        return WithDerivatives(size * value, size * (rates + steeper))

    def at_event(self, index: int, field: str) -> WithDerivatives:
        """A number of an event.

        Parameters
        ----------
        index : int
        field : str
            One of FIELDS.

        Returns
        -------
        rated : WithDerivatives
        """
        if field in DIRECT:
            values, rates = self._at_events
            place = DIRECT[field][1]
            return WithDerivatives(float(values[index, place]), rates[index, place])
        row = self.motion.tables["events"][index]
        event_tangents = self.at_events[index]
        if field in SUMS:
            (one, place, _), (other, second, _) = (DIRECT[name] for name in SUMS[field])
            return self.in_si(float(row[one] + row[other]), event_tangents[place] + event_tangents[second], SPEED)
        state = _state_of(row)
        if field == "friction":
            return self.in_si(float(row["friction"]), self._friction(state, event_tangents), ENERGY)
        return self.in_si(*self._energy(field, state, event_tangents), ENERGY)

    def at_times(self, times: Floats, fields: Sequence[str], left: bool = False) -> dict[str, tuple[Floats, Floats]]:
        """Numbers of the state at some times.

        Parameters
        ----------
        times : ndarray, shape (m,)
            [s].
        fields : sequence of str
            Of FIELDS those that are not of an event alone.
        left : bool, default False
            At an event: just before it.

        Returns
        -------
        rated : dict of str to (ndarray, ndarray)
            Values, shape (m,), and derivatives, shape (m, n), by field.
        """
        motion = self.motion
        segments = motion.tables["segments"]
        count = self.at_segments.shape[2]
        samples = Samples(np.empty((times.size, 6)), np.empty((times.size, STATE_ROWS, count)))
        states, out = samples
        clock = -self.directions.units[1]
        compiled(KERNELS + "pieces.sampling.sample_tangents")(
            motion.scenario.to_body(), Pieces(segments, self.at_segments, self.directions.parameter_tangents), clock,
            motion.units.kernel_times(segments, times), left, samples, new_workspace(thread_scratch(), count),
        )  # fmt: skip
        sample = motion.at(times, "left" if left else "right")
        result: dict[str, tuple[Floats, Floats]] = {}
        for field in fields:
            values = np.asarray(getattr(sample, field), float)
            if field == "friction":
                found = (values / motion.units.energy, self._friction(states, out), ENERGY)
            elif field in ENERGIES:
                found = (*self._energy(field, states, out), ENERGY)
            elif field == "vx":
                found = (states[:, 3] + states[:, 4], out[:, OM] + out[:, VT], SPEED)
            else:
                _, row, exponents = DIRECT[field]
                found = (values / motion.units.of(field), out[:, row], exponents)
            result[field] = (values, self.in_si(*found).rates)
        return result

    def friction_utilization(self) -> WithDerivatives:
        """The maximum friction utilization of the motion.

        Returns
        -------
        rated : WithDerivatives
            With both sides, which differ where two places need the most.
        """
        body, events, segments = self._body, self.motion.tables["events"], self.motion.tables["segments"]
        use, event = settled_by(body, events)
        if event >= 0:
            return WithDerivatives(use, 0.0 * self.at_events[event, T] + 0.0 * use)
        peaks = greatest_peaks(body, events, segments)
        pieces = Pieces(segments, self.at_segments, self.directions.parameter_tangents)
        rates = [use_rates(body, events, self.at_events, pieces, peak) for peak in peaks]
        larger, smaller = (np.array(side) for side in zip(*rates, strict=True))
        most = max(peak.need for peak in peaks)
        return WithDerivatives(min(most / body.mu_s, 1.0), larger.max(axis=0), smaller.min(axis=0))

    @cached_property
    def _at_events(self) -> tuple[Floats, Floats]:
        """Values and derivatives of all events, in SI units."""
        events = self.motion.tables["events"]
        sizes, by_units = self._units
        values = np.empty(self.at_events.shape[:2])
        for column, place, _ in DIRECT.values():
            values[:, place] = events[column]
        of_row = sizes[UNIT_OF_ROW]
        return of_row * values, of_row[:, None] * (self.at_events + values[..., None] * by_units[UNIT_OF_ROW])

    def _energy(self, field: str, state: Floats, rates: Floats) -> tuple[Any, Floats]:
        """Kinetic, potential or both, of the state at one time or many."""
        states, tangents = np.atleast_2d(state), rates.reshape(-1, *rates.shape[-2:])
        values, slopes = np.empty((len(states), 2)), np.empty((len(states), 2, rates.shape[-1]))
        compiled(KERNELS + "pieces.energies.fill_energies")(
            self._body, states, tangents, self.directions.parameter_tangents, values, slopes
        )
        part = {"kinetic": slice(1), "potential": slice(1, 2), "total": slice(2)}[field]
        value, slope = values[:, part].sum(axis=1), slopes[:, part].sum(axis=1)
        return (value, slope) if state.ndim == 2 else (value[0], slope[0])

    def _friction(self, state: Floats, rates: Floats) -> Floats:
        """Of the friction loss: the energy lost less the losses of impacts and rolling resistance."""
        lost: Floats = self._begin - self._energy("total", state, rates)[1]
        return lost - rates[..., IMPACT_N, :] - rates[..., IMPACT_T, :] - rates[..., ROLLING_LOSS, :]

    @cached_property
    def _body(self) -> Body:
        return self.motion.scenario.to_body()

    @cached_property
    def _begin(self) -> Floats:
        """Of the energy at the start."""
        return self._energy("total", _state_of(self.motion.tables["events"][0]), self.at_events[0])[1]

    @cached_property
    def _units(self) -> tuple[Floats, Floats]:
        """Sizes of UNITS and their logarithmic rates."""
        return sizes_and_rates(self.motion.units.scales, self.directions.units)


def _state_of(row: np.void) -> Floats:
    state = np.array([row[name] for name in COLUMNS])
    state[2] += row["theta_low"]
    return state


def propagate(motion: Motion, paths: Sequence[str], sign: float = 1.0) -> TangentSolution:
    """Propagate the derivatives of a motion with respect to some parameters.

    Parameters
    ----------
    motion : Motion
        With rigid contact.
    paths : sequence of str
    sign : float, default 1
        −1 for the derivatives towards smaller parameters, in the sign convention of those towards larger ones [1].

    Returns
    -------
    solution : TangentSolution

    Raises
    ------
    ValueError
        If the contact is compliant or a path is no parameter.
    """
    scenario = motion.scenario
    if scenario.contact.model != "rigid":
        raise InputError("Derivatives need rigid contact: contact.model = 'compliant' has none.")
    given = directions_of(scenario, paths)
    events, segments = motion.tables["events"], motion.tables["segments"]
    known = KnownMotion(events, segments, scenario.duration / motion.units.time, motion.kernel_doubt)
    found = propagated(scenario.to_body(), known, sign * given.parameter_tangents, sign * given.start)
    return TangentSolution(motion, given, sign * found.at_events, sign * found.at_segments, found.reasons, found.failed)


def propagated(body: Body, known: KnownMotion, parameter_tangents: Floats, tangents: Floats) -> Solution:
    """Return the derivatives of a motion in kernel units, from the tangents of its start, which are overwritten."""
    directions = tangents.shape[1]
    found = new_solution(len(known.events), len(known.segments), directions)
    workspace = new_workspace(thread_scratch(), directions)
    compiled(KERNELS + "tangents.propagate_tangents")(body, known, parameter_tangents, tangents, found, workspace)
    if known.doubt < math.inf:
        end_in_doubt(known, found)
    return found


def end_in_doubt(known: KnownMotion, found: Solution) -> None:
    """Set to nan what is after a time from which doubles do not decide what follows."""
    first = int(np.searchsorted(known.events["t"], known.doubt, "right"))
    found.at_events[first:] = math.nan
    found.at_segments[np.searchsorted(known.segments["t"], known.doubt) :] = math.nan
    later = (found.failed < 0) | (found.failed > first)
    found.failed[later], found.reasons[later] = first, BORDER


def transitions(motion: Motion, parameter_tangents: Floats) -> Iterator[tuple[int, int, Floats]]:
    """Differentiate a rigid motion from each event but an apex, which is inside a segment, to the next one.

    Parameters
    ----------
    motion : Motion
    parameter_tangents : ndarray, shape (PARAMETERS, m)
        Directions of the parameters.

    Yields
    ------
    first, last : int
        The events.
    rates : ndarray, shape (last − first, STATE_ROWS, STATE_ROWS + m)
        At the events behind `first` up to `last`, with respect to the state just after `first` and to the parameters, in kernel
        units; nan where there are no derivatives.
    """
    body, events, segments = motion.scenario.to_body(), motion.tables["events"], motion.tables["segments"]
    t_end, doubt = motion.scenario.duration / motion.units.time, motion.kernel_doubt
    parameters = np.hstack([np.zeros((PARAMETERS, STATE_ROWS)), parameter_tangents])
    start = np.eye(STATE_ROWS, parameters.shape[1])
    begin = 0
    for first, last in pairwise(np.flatnonzero(events["kind"] != Event.APEX).tolist()):
        rows = events[first : last + 1].copy()
        rows["kind"][0] = Event.TURN  # its state is the start, as it is
        before = (segments["t"][begin:] - rows["t"][-1]) + (segments["t_low"][begin:] - rows["t_low"][-1]) < 0.0
        end = begin + int(np.count_nonzero(before))
        known = KnownMotion(rows, segments[begin : end + 1], t_end, doubt)
        begin = end
        yield first, last, propagated(body, known, parameters, start.copy()).at_events[1:, :STATE_ROWS]
