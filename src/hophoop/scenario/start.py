"""The start of a motion: rolling, any state, or a state of another motion that goes on."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, ClassVar, Literal, NamedTuple

from pydantic import model_validator

from hophoop._support.errors import InputError
from hophoop.scenario.checking import Frozen, alone, field_of, quantity, refuse, say
from hophoop.scenario.models import Hoop
from hophoop.vocabulary.parameters import RANGES


class StartState(NamedTuple):
    """Position and velocities of a hoop at one instant.

    Attributes
    ----------
    x, height : float
        Position of the centre along the plane, and gap between rim and plane [m].
    angle : float
        θ [rad].
    vx, vy : float
        Velocity of the centre along the plane and away from it [m/s].
    omega : float
        Angular velocity [rad/s].
    slip : float
        Slip velocity [m/s], stored because a rolling start has exactly 0, not v − R (v/R).
    """

    x: float
    height: float
    angle: float
    vx: float
    vy: float
    omega: float
    slip: float


class Start(Frozen):
    """Position and velocity of the hoop at the start.

    Either a rolling start, with `speed`, or any state; `Start()` is at rest with the load at the top.

    Parameters
    ----------
    x : float, default 0
        Position of the centre along the plane [m].
    height : float, default 0
        Gap between rim and plane, at least 0 [m].
    angle : float, default 0
        θ, from the plane's outward normal to the line C→G, clockwise [rad].
    speed : float, optional
        Velocity of the centre of a hoop that rolls [m/s]; its slip velocity is exactly zero.
    vx : float, default 0
        Velocity of the centre along the plane [m/s].
    vy : float, default 0
        Velocity of the centre away from the plane [m/s].
    omega : float, default 0
        Angular velocity θ̇ [rad/s]; None in a rolling start, where it is speed over the hoop's radius.
    slip : float, optional
        Slip velocity v_t, which vx − R omega gives only to rounding [m/s].
    mode : {'R', 'S', 'K', 'H'}, optional
        Phase in which the motion goes on; by default it follows from the state. It needs slip: 0 in R, at most 0 in S, at
        least 0 in K.

    Raises
    ------
    ValueError
        If height is negative, a number is not finite, speed is given together with a height or velocity, or mode and slip
        contradict each other.
    """

    place: ClassVar[str] = "start."

    x: float = field_of("start.x")
    height: float = field_of("start.height")
    angle: float = field_of("start.angle")
    speed: float | None = field_of("start.speed")
    vx: float = field_of("start.vx")
    vy: float = field_of("start.vy")
    omega: float | None = field_of("start.omega")
    slip: float | None = quantity(None, "Slip velocity", "m/s", RANGES["start.vx"])
    mode: Literal["R", "S", "K", "H"] | None = quantity(None, "Phase in which the motion goes on", "")

    @model_validator(mode="after")
    def _complete(self) -> Start:
        mode, slip = self.mode, self.slip
        if mode is not None:
            if slip is None:
                raise refuse(f"start.mode = {mode!r} needs start.slip, the slip velocity.")
            if mode != "H" and (self.height != 0.0 or self.vy != 0.0):
                raise refuse(f"start.mode = {mode!r} needs start.height = 0 and start.vy = 0.")
            if slip != _slip_within(mode, slip):
                raise refuse(f"start.slip = {slip!r} must be {_SLIPS[mode]} with start.mode = {mode!r}.")
        if self.speed is not None:
            alone("start", "speed", [name for name in (*_FREE, "slip", "mode") if name in self.model_fields_set])
            self._settle(vx=self.speed, omega=None)
        elif self.omega is None:
            raise refuse(say("no_omega"))
        return self

    def _written(self) -> Iterable[str]:
        return type(self).model_fields if self.speed is None else ("x", "angle", "speed")

    @classmethod
    def rolling(cls, speed: float, angle: float = 0.0, x: float = 0.0) -> Start:
        """A start in contact, without slip.

        Parameters
        ----------
        speed : float
            Velocity of the centre along +x [m/s].
        angle : float, default 0
            θ [rad].
        x : float, default 0
            Position of the centre along the plane [m].

        Returns
        -------
        start : Start

        Raises
        ------
        ValueError
            If a number is not finite.
        """
        return cls(speed=speed, angle=angle, x=x)

    @classmethod
    def of(cls, state: Any) -> Start:
        """A start that goes on from a state of a motion, with its own slip velocity and mode.

        Parameters
        ----------
        state : Sample or EventRecord
            At one time, as `Trajectory.at` and `Trajectory.events` return it.

        Returns
        -------
        start : Start
            With the same hoop and plane the motion goes on as the one that was not interrupted, within rounding. Its time and
            losses start from 0.

        Raises
        ------
        ValueError
            If it is no state, that of many times, of a massless hoop that skims the plane, or not finite.

        Examples
        --------
        >>> import hophoop as hh
        >>> scenario = hh.Scenario()
        >>> motion = hh.simulate(scenario)
        >>> onward = hh.simulate(scenario.replace("start", hh.Start.of(motion.at(1.0))).replace("duration", 5.0))
        >>> abs(onward.events[-1].angle - motion.events[-1].angle) < 1e-12
        True
        """
        if not all(hasattr(state, name) for name in ("t", *_STATE)):
            raise InputError(
                f"state must be a Sample or an EventRecord, not {type(state).__name__}.", field="state", value=state
            )
        if getattr(state.t, "ndim", 0):
            raise InputError("A start is the state at one time: take motion.at(t) with a single t.", field="start")
        mode = str(getattr(state, "mode", getattr(state, "to_mode", None)))
        if mode == "M":
            raise InputError("A start cannot skim the plane: mode 'M' depends on the strike that ends it.", field="start")
        given: dict[str, Any] = {name: float(getattr(state, name)) for name in _STATE}
        given["height"] = max(given["height"], 0.0)  # a compliant rim is below the plane
        paradox = str(getattr(state, "kind", "")).startswith("painleve")  # another event follows at the same instant
        if not paradox and (mode == "H" or given["height"] == given["vy"] == 0.0):
            given["mode"] = mode
            given["slip"] = _slip_within(mode, given["slip"])
        return cls(**given)

    def state(self, hoop: Hoop) -> StartState:
        """The start as numbers, for a given hoop.

        Parameters
        ----------
        hoop : Hoop
            Its radius turns a rolling speed into an angular velocity.

        Returns
        -------
        state : StartState
            x, height [m], angle [rad], vx, vy [m/s], omega [rad/s], slip [m/s]; the slip velocity of a
            rolling start is exactly 0.
        """
        if self.speed is not None:
            omega, slip = self.speed / hoop.radius, 0.0
        else:
            omega = self.omega or 0.0
            slip = self.vx - hoop.radius * omega if self.slip is None else self.slip
        return StartState(self.x, self.height, self.angle, self.vx, self.vy, omega, slip)


_FREE = ("height", "vx", "vy", "omega")
_STATE = ("x", "angle", *_FREE, "slip")
_SLIPS = {"R": "0", "S": "at most 0", "K": "at least 0"}


def _slip_within(mode: str, slip: float) -> float:
    """Return a slip velocity that its mode allows: at the end of slip a sample has 0 within rounding [m/s]."""
    if mode == "S":
        return min(slip, 0.0)
    return max(slip, 0.0) if mode == "K" else 0.0 if mode == "R" else slip
