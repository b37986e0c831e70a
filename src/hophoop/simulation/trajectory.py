"""Trajectory: a computed motion, its events, samples at any time and energy ledger, in SI units."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.fingerprint import STATE, fingerprint
from hophoop.kernel.model import EVENT_NAMES, MODE_LETTERS, STATUS_NAMES, energies_after
from hophoop.results.records import (
    ArraySample,
    EventErrors,
    Events,
    Ledger,
    Sample,
    ScalarSample,
    Side,
    event_record,
)
from hophoop.results.units import Units
from hophoop.scenario import InputError, Rigid, Scenario
from hophoop.vocabulary.names import STATUSES, plain, sequence_of
from hophoop.vocabulary.quantities import LOSSES

if TYPE_CHECKING:
    import xarray

    from hophoop.derivatives.results.sensitivity import Sensitivity
    from hophoop.derivatives.results.uncertainty import Uncertainty

Floats = NDArray[np.float64]


class Trajectory:
    """A computed motion: exact events, and the state at any time between them.

    Returned by `hophoop.simulate`. Nothing is interpolated from a table: to sample a time, its segment is solved again.
    """

    def __init__(
        self,
        scenario: Scenario,
        status: int,
        events: np.ndarray,
        segments: np.ndarray,
        version: str,
        doubt: float | None = None,
        until: str | None = None,
    ) -> None:
        self.scenario = scenario
        self.version = version
        self._status = status
        self._events = events
        self._segments = segments
        self._doubt = doubt
        self.until = until

    # --- events ------------------------------------------------------------------------------------

    @property
    def status(self) -> str:
        """How the motion ended: completed, at_rest, jammed, undetermined or event_limit."""
        return STATUS_NAMES[self._status]

    @property
    def ending(self) -> str:
        """What ended the motion: 'duration', what `until` asked for, such as 'landings:2', or else its status."""
        if self.status != "completed":
            return str(self.status)
        return self.until if self.until is not None and self.duration < self.scenario.duration else "duration"

    @property
    def ok(self) -> bool:
        """True if the motion reached its end: completed or at rest."""
        return STATUSES[self.status].ok

    @cached_property
    def sequence(self) -> str:
        """One letter per phase: R roll, S slip with v_t < 0, K with v_t > 0, H flight (hop), M skim."""
        return sequence_of(*(self._events[name].tolist() for name in ("kind", "after_mode", "t")))

    @cached_property
    def events(self) -> Events:
        """All events in order: a tuple of `EventRecord`, printed as a table."""
        return Events(event_record(row, self.units, self._seconds(float(row["t"]))) for row in self._events)

    def find(self, kind: str) -> Events:
        """Return the events of one kind.

        Parameters
        ----------
        kind : str
            For example 'takeoff'.

        Returns
        -------
        events : tuple of EventRecord
            Printed as a table.

        Raises
        ------
        ValueError
            If there is no such kind.
        """
        if kind not in EVENT_NAMES:
            raise InputError.of_field("kind", kind, ", ".join(EVENT_NAMES), rule="is not one of")
        return Events(event for event in self.events if event.kind == kind)

    @property
    def duration(self) -> float:
        """Time from the start to the end of the motion, however it ended [s]."""
        return self._seconds(float(self._events["t"][-1]))

    @cached_property
    def fingerprint(self) -> str:
        """Hash of the bits of all events; the same on every machine and in the browser for one version of hophoop.

        Notes
        -----
        The first 16 hexadecimal digits of the SHA-256 of the events in order: for each the name of its kind in UTF-8 and
        t, x, height, angle, vx, vy, omega and slip as little-endian binary64, in SI units and radians. −0 is hashed as 0,
        any nan as the quiet nan 0x7ff8000000000000.

        Examples
        --------
        >>> import hophoop as hh
        >>> scenario = hh.Scenario(duration=2.0)
        >>> hh.simulate(scenario).fingerprint == hh.simulate(scenario).fingerprint
        True
        """
        events, unit = self._events, self.units
        times = np.array([self._seconds(t) for t in events["t"].tolist()])
        columns = [times, *(events[name] * unit.of(name) for name in STATE[1:])]
        return fingerprint((EVENT_NAMES[kind] for kind in events["kind"]), np.column_stack(columns))

    # --- states ------------------------------------------------------------------------------------

    @overload
    def at(self, t: float, side: Side = ...) -> ScalarSample: ...

    @overload
    def at(self, t: Floats | Sequence[float], side: Side = ...) -> ArraySample: ...

    @overload
    def at(self, t: ArrayLike, side: Side = ...) -> Sample[Any, Any]: ...

    def at(self, t: ArrayLike, side: Side = "right") -> Sample[Any, Any]:
        """Return the state at any time.

        Parameters
        ----------
        t : float or array_like
            Times from 0 to `duration` [s].
        side : {'right', 'left'}, default 'right'
            At the instant of an event: just after all events of that instant, or just before the first of them.

        Returns
        -------
        sample : Sample

        Raises
        ------
        ValueError
            If a time is outside the motion, or `side` is neither.

        Notes
        -----
        A time belongs to an event if it equals the event's `t`. At an event that starts a phase the sample is the event's own
        state, to the last bit. Just before the load of a massless hoop strikes the plane, `omega` and `vx` are infinite,
        because θ̇ of the rim is unbounded. The energy is then that of the load. At a jam, where N is infinite, both sides are
        the state before it.
        """
        if side not in ("left", "right"):
            raise InputError.of_field("side", side, "'left' or 'right'")
        try:
            times = np.asarray(t, dtype=float)
        except (TypeError, ValueError, OverflowError):
            raise InputError("t must be a time in seconds, or an array of times.", field="t", value=t) from None
        end = self.duration
        bad = ~((times >= 0.0) & (times <= end * (1 + 1e-15)))
        if bad.any():
            raise InputError.of_field("t", times[bad].flat[0], f"from 0 to the motion's end at {end!r} s")
        raw = self._sample(self.units.kernel_times(self._segments, times.ravel()), side == "left")
        names, factors = self._sampled
        values: dict[str, Any]
        if times.ndim == 0:
            values = dict(zip(names, (raw[0] * factors).tolist(), strict=True))
            values["mode"], values["t"] = MODE_LETTERS[int(raw[0, 0])], float(times)
        else:
            table = np.ascontiguousarray((raw * factors).T)
            values = {name: column.reshape(times.shape) for name, column in zip(names, table, strict=True)}
            values["mode"], values["t"] = _LETTERS[raw[:, 0].astype(int)].reshape(times.shape), times
        for name in _INTERNAL:
            values.pop(name, None)
        if "spring" not in values:
            values["spring"], values["damping"] = (0.0 if times.ndim == 0 else np.zeros(times.shape) for _ in range(2))
        return Sample(**values)

    def times(self, n: int = 1000) -> Floats:
        """Return equally spaced times over the motion, both ends included.

        Parameters
        ----------
        n : int, default 1000
            Number of times, at least 2.

        Returns
        -------
        t : ndarray, shape (n,)
            [s].

        Raises
        ------
        ValueError
            If n is below 2.
        """
        if n < 2:
            raise InputError.of_field("n", n, "at least 2")
        return np.linspace(0.0, self.duration, n)

    @cached_property
    def errors(self) -> EventErrors:
        """Estimated error of each event, rounding amplified by the motion; correct to a factor of 10 in 99 of 100 numbers.

        Errors as large as the numbers themselves mean that doubles do not follow the motion.

        Raises
        ------
        ValueError
            If the contact is compliant: its errors follow from its rtol.
        """
        from hophoop.simulation.event_errors import event_errors

        return event_errors(self)

    @cached_property
    def ledger(self) -> Ledger:
        """Energies at the end, the losses so far, and the residual of the balance."""
        unit = self.units
        first, last = self._events[0], self._events[-1]
        begin_kinetic, begin_potential = self._energies(first)
        kinetic, potential = self._energies(last)
        friction, normal, tangential, rolling = (float(last[name]) * unit.energy for name in LOSSES)
        begin_spring, spring, damping = 0.0, 0.0, 0.0
        if self.scenario.contact.model != "rigid":
            begin_spring = self._stored(0.0, True)["spring"]
            # many steps may share the last digit of a late time: take the state after all of them
            end = self._stored(float(last["t"]), False)
            spring, damping, kinetic, potential = (end[name] for name in ("spring", "damping", "kinetic", "potential"))
            friction, rolling = end["friction"], end["rolling_resistance"]
        # in the order of operations of `lab.wasm.motions.write_energies`
        residual = (kinetic + potential + spring + damping + friction + normal + tangential + rolling) - (
            begin_kinetic + begin_potential + begin_spring
        )
        hoop, plane = self.scenario.hoop, self.scenario.plane
        weight = hoop.mass * plane.gravity * hoop.radius
        size = max(abs(begin_kinetic), kinetic, abs(potential), friction, rolling, weight, spring, abs(damping))
        return Ledger(kinetic, potential, friction, normal, tangential, rolling, spring, damping, residual, size)

    @property
    def tables(self) -> dict[str, np.ndarray]:
        """Structured arrays of events and segments as the kernel wrote them, in the units of `units` [1]."""
        return {"events": self._events, "segments": self._segments}

    @cached_property
    def units(self) -> Units:
        """SI values of the kernel units."""
        return Units.of_scenario(self.scenario)

    @property
    def doubt(self) -> float:
        """Time from which double precision cannot decide the motion; inf if everything is certain [s].

        There a quantity only touches the value that would cause an event, or the motion is on the boundary of two classes. Only
        with rigid contact.
        """
        return self._seconds(self.kernel_doubt)

    @property
    def kernel_doubt(self) -> float:
        """`doubt` in the kernel's unit of time, to compare with `tables` [`units`]."""
        if self._doubt is None:  # for a loaded motion
            from hophoop.simulation.rigid import simulate_rigid
            from hophoop.simulation.until import NOTHING, read_until

            rigid = isinstance(self.scenario.contact, Rigid)
            until = NOTHING if self.until is None else read_until(self.until)
            self._doubt = simulate_rigid(self.scenario, until).doubt if rigid else math.inf
        return self._doubt

    def sensitivity(self, of: str | Sequence[str], wrt: str | Sequence[str]) -> Sensitivity:
        """Return derivatives of quantities of the motion with respect to parameters, through all events.

        Parameters
        ----------
        of : str or sequence of str
            Of an event, ``"takeoff.angle"``, ``"impact[1].t"``, ``"stick[-1].omega"``; of a hop, ``"hop.height"``,
            ``"hop[1].distance"``; of a time in s, ``"at(0.8).angle"``; of the whole motion, ``"end.x"``,
            ``"distance"``, ``"energy_lost"``; and a map's names such as ``"hop_height"``.
        wrt : str or sequence of str
            Paths of the scenario's numbers, such as ``"start.speed"``, ``"hoop.load_fraction"``, ``"plane.mu"``.

        Returns
        -------
        sensitivity : Sensitivity
            Derivatives in SI units; nan, with the reason, if there is none.

        Raises
        ------
        ValueError
            If a name is unknown, the motion has no such event, or its contact is compliant.

        Examples
        --------
        >>> import hophoop as hh
        >>> motion = hh.simulate(hh.Scenario(duration=2.0))
        >>> print(motion.sensitivity("takeoff.angle", ["hoop.load_fraction", "plane.mu"]))
        takeoff.angle  by hoop.load_fraction: -5.14606248 rad
        takeoff.angle  by plane.mu: +0.221788164 rad
        """
        from hophoop.derivatives.results.sensitivity import sensitivity_of

        return sensitivity_of(self, of, wrt)

    def uncertainty(
        self, spread: Mapping[str, float], correlations: Mapping[tuple[str, str], float] | None = None
    ) -> Uncertainty:
        """Return the uncertainty of the motion from uncertain parameters, to first order.

        Parameters
        ----------
        spread : mapping of str to float
            Standard deviations of parameters by path, such as ``{"plane.mu": 0.02, "start.speed": 0.01}`` [their units].
        correlations : mapping of (str, str) to float, optional
            From −1 to 1; none by default [1].

        Returns
        -------
        uncertainty : Uncertainty

        Raises
        ------
        ValueError
            If a standard deviation is negative, a path is not a parameter, the correlations are impossible, or the contact is
            compliant.

        Examples
        --------
        >>> import hophoop as hh
        >>> motion = hh.simulate(hh.Scenario(duration=2.0))
        >>> spread = motion.uncertainty({"plane.mu": 0.02, "start.speed": 0.01})
        >>> [round(float(each), 4) for each in spread.deviation(["takeoff.angle", "hop.height"])]
        [0.0111, 0.0165]
        """
        from hophoop.derivatives.results.uncertainty import uncertainty_of

        return uncertainty_of(self, spread, correlations)

    # --- export ------------------------------------------------------------------------------------

    def to_dict(self) -> dict[str, Any]:
        """Return the motion as JSON: scenario, status, sequence, fingerprint, events, final state and energies.

        Returns
        -------
        result : dict
            Ready for `json.dumps`; SI units and radians.
        """
        final = self.events[-1]
        ledger = self.ledger
        energy = {name: getattr(ledger, name) for name in ("kinetic", "potential", *LOSSES, "residual")}
        if self.scenario.contact.model != "rigid":
            energy |= {"spring": ledger.spring, "damping": ledger.damping}
        return {
            "schema": "hophoop/1",
            "version": self.version,
            "scenario": self.scenario.to_dict(),
            "status": self.status,
            **({} if self.until is None else {"ending": self.ending}),
            "sequence": self.sequence,
            "fingerprint": self.fingerprint,
            "events": [event.to_dict() for event in self.events],
            "final": {"t": final.t, "mode": final.to_mode, **final.state_to_dict()},
            "energy": energy,
        }

    def to_xarray(self, n: int = 1000, t: ArrayLike | None = None) -> xarray.Dataset:
        """Return the motion as an xarray.Dataset over time.

        Parameters
        ----------
        n : int, default 1000
            Number of equally spaced times.
        t : array_like, optional
            Times to use instead [s].

        Returns
        -------
        dataset : xarray.Dataset
            Every variable has units and long_name.

        Raises
        ------
        ValueError
            If a time is outside the motion or n is below 2.
        ImportError
            If xarray is missing.
        """
        from hophoop.results import save as export

        return export.to_xarray(self, self.times(n) if t is None else np.asarray(t, dtype=float))

    def save(self, path: str | Path) -> None:
        """Write the motion to a file that `hophoop.load` reads back, with the same samples to the last bit.

        Parameters
        ----------
        path : str or Path
            Ends in .nc (netCDF) or .zarr.

        Raises
        ------
        ValueError
            If it has another ending.
        ImportError
            If the library that writes it is missing.
        """
        from hophoop.results import save as export

        export.save(self, path)

    def _repr_html_(self) -> str:
        from hophoop.results import notebook as portrait

        return portrait.html(self)

    def __str__(self) -> str:
        from hophoop.results import notebook as portrait

        ending = f"{plain(self.status)} after {self.duration:.6g} s"
        return f"{self.events!r}\n\nphases {portrait.shortened(self.sequence, 60)}, {ending}"

    def __repr__(self) -> str:
        return f"<Trajectory {self.sequence} {self.status}: {len(self._events)} events in {self.duration:.6g} s>"

    # --- internal ----------------------------------------------------------------------------------

    @property
    def _model(self) -> Any:
        """The module of the contact model; not kept, since modules cannot be pickled."""
        if self.scenario.contact.model == "rigid":
            from hophoop.simulation import rigid

            return rigid
        from hophoop.simulation import compliant

        return compliant

    @cached_property
    def _sampled(self) -> tuple[tuple[str, ...], Floats]:
        """Return names and SI units of a sample's fields in this contact model, the mode first."""
        names = self._model.COLUMNS
        return names, np.array([1.0 if name in ("mode", *_INTERNAL) else self.units.of(name) for name in names])

    def _sample(self, times: Floats, left: bool) -> Floats:
        result: Floats = self._model.sampled(self.scenario, self._segments, times, left)
        return result

    def _seconds(self, t: float) -> float:
        # the end of the motion is the given duration, without its rounding through kernel units
        if t == self.scenario.duration / self.units.time:
            return self.scenario.duration
        return t * self.units.time

    def _energies(self, row: np.void) -> tuple[float, float]:
        """Return kinetic and potential energy just after an event."""
        kinetic, potential = energies_after(self.scenario.to_body(), row)
        return float(kinetic) * self.units.energy, float(potential) * self.units.energy

    def _stored(self, t: float, left: bool) -> dict[str, float]:
        """Return the energies of the state at a time in kernel units."""
        (raw,) = self._sample(np.array([t]), left).tolist()
        return {name: value * self.units.energy for name, value in zip(self._model.COLUMNS, raw, strict=True)}


_INTERNAL = ("theta", "theta_low")  # columns that a sample does not contain
_LETTERS = np.array(list(MODE_LETTERS))
