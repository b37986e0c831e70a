"""Critical speeds of a rolling start with the load up: where slip, a hop and an immediate hop begin."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from hophoop.kernel.model import Body, Mode
from hophoop.kernel.native import compiled
from hophoop.kernel.records import EVENT, SEGMENT, new_scratch, start_state
from hophoop.kernel.steps import BY_RULE, run
from hophoop.scenario import Hoop, InputError, Plane
from hophoop.theory._columns import Columns
from hophoop.theory.kernels import critical as kernels
from hophoop.theory.kernels.arcs import TURN
from hophoop.theory.kernels.phase_plane import lift_off_speeds

SLIPS = [Mode.SPIN, Mode.SKID]


class CriticalSpeeds(NamedTuple):
    """Speeds of the centre at θ = 0 from which on something happens.

    Attributes
    ----------
    first_slip : float or ndarray
        Slip somewhere in the first turn [m/s].
    first_hop : float or ndarray
        A hop in the first turn [m/s].
    immediate_hop : float or ndarray
        The hoop leaves the plane at the start [m/s].
    """

    first_slip: Any
    first_hop: Any
    immediate_hop: Any


# --- motions ---------------------------------------------------------------------------------------


class _Trials:
    """First turns of motions, called through the kernel that simulate() has compiled already."""

    def __init__(self) -> None:
        self.events = np.empty(kernels.EVENTS, EVENT)
        self.scratch = new_scratch()

    def angles(self, body: Body, speed: float) -> tuple[float, float]:
        """Angles of the first slip and the first lift-off, nan where there is none."""
        start = start_state(0.0, 0.0, 0.0, 0.0, 0.0, float(speed))
        none = np.empty(0, SEGMENT)
        _, count, _ = compiled(run)(
            body, start, BY_RULE, kernels.ANY_TIME, TURN, kernels.STOP, self.events, none, self.scratch
        )  # fmt: skip
        events = self.events[:count]
        slips = events["angle"][np.isin(events["after_mode"], SLIPS)]
        hops = events["angle"][events["after_mode"] == Mode.FLIGHT]
        return (slips[0] if len(slips) else math.nan), (hops[0] if len(hops) else math.nan)


# --- the public face -------------------------------------------------------------------------------


def _cases(hoop: Hoop, plane: Plane, **numbers: ArrayLike) -> Columns:
    cases = Columns(hoop, plane, resisted=False, **numbers)
    cases.require(lambda kap: kap > 0.0, "kap", "hoop.inertia_ratio = {} must be above 0; see massless_loss.")
    cases.require(lambda gt: gt >= 0.0, "gt", "plane.slope must be at least 0 here (level, or downhill along +x).")
    return cases


def first_slip_speed(hoop: Hoop, plane: Plane = Plane()) -> Any:
    """Smallest speed at the top with which the hoop slips somewhere in its first turn.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Level, or sloping downhill.

    Returns
    -------
    v0 : float or ndarray
        Velocity of the centre at θ = 0 [m/s]; 0 where the smallest push leads to slip (a faster
        hoop may then roll again), inf where friction is infinite.

    Raises
    ------
    ValueError
        If the hoop is massless or the plane slopes uphill.

    Notes
    -----
    In rolling the contact force at an angle is linear in v0². The margin to the friction cone is a line
    A(θ) + B(θ) v0², so that slip begins at the smallest −A/B over the turn: one extremum in θ.

    References
    ----------
    "At some marginally higher initial velocity" than 2 m/s: :cite:t:`Sonnerlind2023`.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.first_slip_speed(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0)), 9)
    2.043173912
    """
    cases = _cases(hoop, plane)
    return float(compiled(kernels.slip_speed)(cases.body)) * cases.speed


def first_hop_speed(hoop: Hoop, plane: Plane = Plane(), turns: int = 1) -> Any:
    """Smallest speed at the top with which the hoop leaves the plane within its first turns.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Level, or sloping downhill.
    turns : int, default 1
        How far the hoop is followed, at least 1 [turns].

    Returns
    -------
    v0 : float or ndarray
        Velocity of the centre at θ = 0 [m/s]; inf where no speed is enough (ε = 0).

    Raises
    ------
    ValueError
        If the hoop is massless, the plane slopes uphill, or turns is below 1.

    Notes
    -----
    The exact motion decides at every speed that is tried. The lowest change of the outcome among 32 speeds up
    to that of the immediate hop is bisected to the last bit.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.first_hop_speed(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0)), 9)
    2.908160226
    """
    if not (isinstance(turns, int | np.integer) and turns >= 1):
        raise InputError.of_field("turns", turns, "a whole number of at least 1")
    cases = _cases(hoop, plane)
    return float(compiled(kernels.hop_speed)(cases.body, float(turns))) * cases.speed


def immediate_hop_speed(hoop: Hoop, plane: Plane = Plane()) -> Any:
    r"""Speed at the top from which on the hoop leaves the plane at once: √(gR cos β/ε).

    Parameters
    ----------
    hoop : Hoop
    plane : Plane

    Returns
    -------
    v0 : float or ndarray
        Velocity of the centre at θ = 0 [m/s]; inf where ε = 0.

    Raises
    ------
    ValueError
        If the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.immediate_hop_speed(hh.Hoop.ideal(0.75)), 9)
    3.616628264
    """
    cases = Columns(hoop, plane, resisted=True)  # there is no contact force in it
    speeds = cases.new()
    compiled(lift_off_speeds)(cases.body, np.zeros_like(speeds), speeds)
    return cases.shaped(speeds * cases.speed)


def critical_speeds(hoop: Hoop, plane: Plane = Plane()) -> CriticalSpeeds:
    """The three critical speeds of a rolling start with the load up.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Level, or sloping downhill.

    Returns
    -------
    speeds : CriticalSpeeds
        first_slip, first_hop and immediate_hop [m/s].

    Raises
    ------
    ValueError
        If the hoop is massless or the plane slopes uphill.

    Examples
    --------
    >>> import hophoop as hh
    >>> [round(speed, 6) for speed in hh.theory.critical_speeds(hh.Hoop.ideal(0.75))]
    [2.043174, 2.90816, 3.616628]
    """
    return CriticalSpeeds(first_slip_speed(hoop, plane), first_hop_speed(hoop, plane), immediate_hop_speed(hoop, plane))


def slip_angle(hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Any:
    """Angle at which a hoop that rolls from the top first slips.

    Parameters
    ----------
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane
        Level, or sloping downhill.

    Returns
    -------
    angle : float or ndarray
        [rad]; nan where it does not slip within its first turn.

    Raises
    ------
    ValueError
        If the hoop is massless, the plane slopes uphill, or v0 is not finite.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.slip_angle(hh.Hoop.ideal(0.75), v0=3.1), 9)
    0.869557554
    """
    return _first_angle(hoop, v0, plane, 0)


def hop_angle(hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Any:
    """Angle at which a hoop that rolls from the top first leaves the plane.

    Parameters
    ----------
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane
        Level, or sloping downhill.

    Returns
    -------
    angle : float or ndarray
        [rad]; nan where it does not within its first turn.

    Raises
    ------
    ValueError
        If the hoop is massless, the plane slopes uphill, or v0 is not finite.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.hop_angle(hh.Hoop.ideal(0.75), v0=3.1), 9)
    5.508908425
    """
    return _first_angle(hoop, v0, plane, 1)


def _first_angle(hoop: Hoop, v0: ArrayLike, plane: Plane, which: int) -> Any:
    cases = _cases(hoop, plane, v0=v0)
    trials = _Trials()
    angles = np.array([trials.angles(cases.body, speed)[which] for speed in cases.of_speed("v0")])
    return cases.shaped(angles)
