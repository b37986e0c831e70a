"""Simulation of a motion with either contact model: simulate(hoop, plane, start, …) → Trajectory."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, overload

from hophoop._support.progress import compute_reporting
from hophoop._version import __version__
from hophoop.kernel.records import Until
from hophoop.scenario import Compliant, Hoop, InputError, Plane, Rigid, Scenario, Start
from hophoop.simulation.rigid import simulate_rigid
from hophoop.simulation.trajectory import Trajectory
from hophoop.simulation.until import NOTHING, read_until

if TYPE_CHECKING:
    from hophoop.derivatives.results.sensitivity import Sensitivity
    from hophoop.precise import PreciseMotion

Progress = Callable[[float], object]


@overload
def simulate(scenario: Scenario, /, *, until: str | None = ..., progress: Progress | None = ...) -> Trajectory: ...


@overload
def simulate(
    scenario: Scenario, /, *, digits: int, until: str | None = ..., progress: Progress | None = ...
) -> PreciseMotion: ...


@overload
def simulate(
    hoop: Hoop,
    plane: Plane | None = ...,
    start: Start | None = ...,
    duration: float | None = ...,
    contact: Rigid | Compliant | None = ...,
    *,
    until: str | None = ...,
    progress: Progress | None = ...,
) -> Trajectory: ...


@overload
def simulate(
    hoop: Hoop,
    plane: Plane | None = ...,
    start: Start | None = ...,
    duration: float | None = ...,
    contact: Rigid | Compliant | None = ...,
    *,
    digits: int,
    until: str | None = ...,
    progress: Progress | None = ...,
) -> PreciseMotion: ...


def simulate(
    hoop: Hoop | Scenario,
    plane: Plane | None = None,
    start: Start | None = None,
    duration: float | None = None,
    contact: Rigid | Compliant | None = None,
    *,
    digits: int | None = None,
    until: str | None = None,
    progress: Progress | None = None,
) -> Trajectory | PreciseMotion:
    """Compute a motion.

    Parameters
    ----------
    hoop : Hoop or Scenario
        The hoop, with the four arguments that follow; or a whole scenario, without them. To change a part of a scenario, call
        `Scenario.replace` or `Scenario.with_values` first.
    plane : Plane, optional
        The reference plane by default.
    start : Start, optional
        At rest with the load at the top by default.
    duration : float, optional
        Above 0; 6 s by default [s].
    contact : Rigid or Compliant, optional
        Rigid() by default.
    digits : int, optional
        Solve with this many digits, 15 to 1000, by a method independent of the kernel's; the given doubles count as exact.
        Takes a few tenths of a second [1].
    until : str, optional
        What ends the motion before its duration: ``revolutions:N`` (θ has changed by so many revolutions), ``landings:N``
        (just after the N-th landing), ``angle:RADIANS`` (θ next passes this angle, in any revolution), ``takeoff`` (after the
        start) or ``reversal``. Rigid contact only; `Trajectory.ending` says what ended the motion.
    progress : callable, optional
        Called with the computed fraction, 0 to 1: about ten times a second in compliant contact, and at the end.

    Returns
    -------
    motion : Trajectory or PreciseMotion
        Returned even if the model has no answer: see its `status`. With `digits` it is a `PreciseMotion`, with events only.

    Raises
    ------
    ValueError
        If the duration is not positive, the parts contradict each other, a scenario is given together with a part, until is
        unknown, digits is out of range or given for the massless hoop, or digits or until is given with a compliant contact.

    Examples
    --------
    >>> import hophoop as hh
    >>> motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    >>> motion.sequence
    'RKRSHR'
    >>> round(motion.find("takeoff")[0].t, 9)
    1.044713027
    >>> exact = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0, digits=30)
    >>> exact.find("takeoff")[0].t
    Decimal('1.04471302680335833630776765131')
    """
    if isinstance(hoop, Scenario):
        scenario = hoop
        if plane is not None or start is not None or duration is not None or contact is not None:
            _refuse_parts(plane=plane, start=start, duration=duration, contact=contact)
    else:
        scenario = Scenario(
            hoop=hoop,
            plane=Plane() if plane is None else plane,
            start=Start() if start is None else start,
            duration=6.0 if duration is None else duration,
            contact=Rigid() if contact is None else contact,
        )
    if digits is None:
        motion: Trajectory | PreciseMotion = _simulate(scenario, until, progress)
    else:
        motion = _simulate_precisely(scenario, digits, until)
    if progress is not None:
        progress(1.0)
    return motion


def _simulate_precisely(scenario: Scenario, digits: int, until: str | None) -> PreciseMotion:
    if until is None:
        from hophoop.precise import simulate_precisely

        return simulate_precisely(scenario, digits, __version__)
    from hophoop.simulation.precise_until import simulate_precisely_until

    return simulate_precisely_until(scenario, digits, until, _asked(scenario, until))


def _asked(scenario: Scenario, until: str | None) -> Until:
    if until is None:
        return NOTHING
    if isinstance(scenario.contact, Compliant):
        raise InputError(f"until = {until!r} needs rigid contact: a compliant motion ends at its duration.", field="until")
    return read_until(until)


def _refuse_parts(**parts: Any) -> None:
    given = [name for name, part in parts.items() if part is not None]
    values = ", ".join(f'"{name}": …' for name in given)
    raise InputError(
        f"{' and '.join(given)} cannot be given together with a scenario: simulate scenario.with_values({{{values}}}) instead."
    )


def _simulate(scenario: Scenario, until: str | None, progress: Progress | None) -> Trajectory:
    doubt = None
    end = _asked(scenario, until)
    if isinstance(scenario.contact, Compliant):
        from hophoop.simulation.compliant import simulate_compliant

        if progress is None:
            status, events, segments = simulate_compliant(scenario)
        else:
            status, events, segments = compute_reporting(lambda share: simulate_compliant(scenario, share), progress)
    else:
        status, events, segments, doubt = simulate_rigid(scenario, end)
    return Trajectory(scenario, status, events, segments, __version__, doubt, until)


def sensitivity(scenario: Scenario, of: str | Sequence[str], wrt: str | Sequence[str]) -> Sensitivity:
    """Return derivatives of quantities of a motion with respect to parameters, through all events.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.
    of, wrt : str or sequence of str
        Quantities such as ``"takeoff.angle"`` and paths such as ``"plane.mu"``; see `Trajectory.sensitivity`.

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
    >>> result = hh.sensitivity(hh.Scenario(duration=2.0), of="hop.height", wrt=["start.speed", "plane.mu"])
    >>> [round(float(rate), 6) for rate in result.derivatives[0]]
    [1.511834, -0.328315]
    """
    return simulate(scenario).sensitivity(of, wrt)
