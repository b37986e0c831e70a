"""Pure rolling: speed, forces, friction used and energies in closed form, times by the motion on infinite friction.

All motions are named by v0, the velocity of the centre at θ = 0. Friction has no say here: the formulas tell
what rolling would be, and `friction_utilization` whether friction allows it. An angle counts as reached when
it lies in the motion's past or future; v0 = 0 means the smallest push ahead.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from hophoop.kernel.model import Body, Event, Mode, Status
from hophoop.kernel.native import compiled
from hophoop.kernel.records import EVENT, SEGMENT, STOP_AT_TURN, start_state, thread_scratch
from hophoop.kernel.steps import BY_RULE, run
from hophoop.results.records import utilization_of
from hophoop.scenario import Hoop, Plane
from hophoop.theory._columns import Columns, Floats
from hophoop.theory.kernels import rolling as kernels
from hophoop.theory.kernels.arcs import TURN

EVENTS = 8  # a start, a turning point or rest, and the end
ANY_TIME = 1e9
REACHED = 1e-12  # relative: the angle at the end of a motion that gets there
LEVEL_ONLY = "plane.slope must be 0 here, where the speed has a largest value."


class Forces(NamedTuple):
    """Contact force in rolling.

    Attributes
    ----------
    friction : float or ndarray
        F along +x [N].
    normal : float or ndarray
        N; where it is negative the plane would have to pull, so that the hoop does not roll there [N].
    """

    friction: Any
    normal: Any


class Energies(NamedTuple):
    """Energies in rolling.

    Attributes
    ----------
    kinetic : float or ndarray
        W_k [J].
    potential : float or ndarray
        W_p, zero at θ = 0 [J].
    """

    kinetic: Any
    potential: Any


class NeededFriction(NamedTuple):
    """The friction that rolling needs.

    Attributes
    ----------
    mu : float or ndarray
        Largest abs(F)/N; inf where N is not positive throughout, so that no friction is enough [1].
    angle : float or ndarray
        Where it is needed, or where N is first negative by most [rad].
    """

    mu: Any
    angle: Any


def _rates(cases: Columns) -> Floats:
    """θ̇ of each case in the kernels' units."""
    rates = cases.new()
    compiled(kernels.speeds)(cases.body, cases["theta"], cases.of_speed("v0"), rates)
    return rates


def rolling_speed(theta: ArrayLike, hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Any:
    r"""Angular velocity of the rolling hoop, in closed form.

    Parameters
    ----------
    theta : float or array_like
        Angle from the outward normal to C→G [rad].
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at theta = 0; 0 means the smallest push ahead [m/s].
    plane : Plane

    Returns
    -------
    omega : float or ndarray
        Angular velocity [rad/s]; nan where the hoop does not get to theta.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    Notes
    -----
    From the energy,

    .. math::
        \begin{aligned}
        \tfrac12 (1 + \kappa + \varepsilon^2 + 2 \varepsilon \cos\theta) R^2 \dot\theta^2 & \\
        {} + \varepsilon g R \cos(\theta + \beta) - g R \theta \sin\beta &= \text{const}.
        \end{aligned}

    References
    ----------
    The ideal hoop on the level: :cite:t:`Sonnerlind2023`; any loaded wheel: :cite:t:`Theron2000`.

    Examples
    --------
    >>> import hophoop as hh
    >>> hh.theory.rolling_speed([0.0, 3.141592653589793], hh.Hoop.ideal(0.75), v0=2.0).round(6)
    array([2.      , 9.319871])
    """
    cases = Columns(hoop, plane, theta=theta, v0=v0)
    return cases.shaped(_rates(cases) / cases.time)


def max_rolling_speed(hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Any:
    """Largest angular velocity of the rolling hoop on the level: at the bottom, θ = π.

    Parameters
    ----------
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane
        Without slope.

    Returns
    -------
    omega : float or ndarray
        Angular velocity of the sign of v0 [rad/s]; inf for the massless hoop.

    Raises
    ------
    ValueError
        If the plane slopes, or a number is not finite.

    References
    ----------
    :cite:t:`Sonnerlind2023`.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.max_rolling_speed(hh.Hoop.ideal(0.75), v0=0.1), 6)
    7.676588
    """
    cases = Columns(hoop, plane, theta=math.pi, v0=v0)
    cases.require(lambda gt: gt == 0.0, "gt", LEVEL_ONLY)
    return cases.shaped(_rates(cases) / cases.time)


def rolling_forces(theta: ArrayLike, hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Forces:
    """Friction and normal force of the rolling hoop.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane

    Returns
    -------
    forces : Forces
        friction along +x and normal force [N]; nan where the hoop does not get to theta.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> forces = hh.theory.rolling_forces(1.0, hh.Hoop.ideal(0.75), v0=2.0)
    >>> round(forces.friction, 6), round(forces.normal, 6)
    (0.764174, 4.378762)
    """
    cases = Columns(hoop, plane, theta=theta, v0=v0)
    friction, normal = _force_columns(cases)
    return Forces(cases.shaped(friction * cases.force), cases.shaped(normal * cases.force))


def _force_columns(cases: Columns) -> tuple[Floats, Floats]:
    both = cases.new(2)
    compiled(kernels.forces)(cases.body, cases["theta"], _rates(cases), both)
    return both[:, 0], both[:, 1]


def friction_utilization(
    theta: ArrayLike,
    hoop: Hoop,
    v0: ArrayLike,
    plane: Plane = Plane(),
) -> Any:
    """Share of the static friction that rolling uses, abs(F)/(μs N).

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane

    Returns
    -------
    utilization : float or ndarray
        Above 1 the hoop cannot roll there [1]; inf where N ≤ 0, nan where the hoop does not get to theta.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.friction_utilization(2.0, hh.Hoop.ideal(0.75), v0=0.1), 6)
    0.29974
    """
    cases = Columns(hoop, plane, theta=theta, v0=v0)
    friction, normal = _force_columns(cases)
    share = utilization_of(False, friction, normal, cases.body.mu_s, cases.body.mu_k)
    return cases.shaped(np.where(normal <= 0.0, np.inf, share))


def rolling_energies(theta: ArrayLike, hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Energies:
    """Kinetic and potential energy of the rolling hoop; their sum does not depend on theta.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane

    Returns
    -------
    energies : Energies
        kinetic and potential, zero at θ = 0 [J]; nan where the hoop does not get to theta.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    References
    ----------
    The ideal hoop on the level: :cite:t:`Sonnerlind2023`.

    Examples
    --------
    >>> import hophoop as hh
    >>> energies = hh.theory.rolling_energies(3.141592653589793, hh.Hoop.ideal(0.75), v0=0.0)
    >>> round(energies.kinetic, 6), round(energies.potential, 6)
    (14.715, -14.715)
    """
    cases = Columns(hoop, plane, theta=theta, v0=v0)
    kinetic, start = cases.new(), cases.new()
    compiled(kernels.kinetic)(cases.body, cases["theta"], _rates(cases), kinetic)
    compiled(kernels.kinetic)(cases.body, np.zeros_like(kinetic), cases.of_speed("v0"), start)
    energy = cases.force * cases.length
    return Energies(cases.shaped(kinetic * energy), cases.shaped((start - kinetic) * energy))


def needed_friction(hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> NeededFriction:
    """The static friction that a hoop needs to roll through its first turn from θ = 0.

    Parameters
    ----------
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0; 0 means the smallest push [m/s].
    plane : Plane
        Its own friction makes no difference. Where it slopes so that the hoop turns back before a whole turn,
        the way up to there counts.

    Returns
    -------
    needed : NeededFriction
        mu, the largest abs(F)/N [1], and the angle where it is needed [rad].

    Raises
    ------
    ValueError
        If v0 is not finite or the shapes do not go together.

    Notes
    -----
    The largest angle of the contact force to the normal is found on panels in θ whose series are resolved, at
    the roots of the derivative.

    References
    ----------
    38 % at v0 = 0.1 m/s: :cite:t:`Sonnerlind2023`.

    Examples
    --------
    >>> import hophoop as hh
    >>> needed = hh.theory.needed_friction(hh.Hoop.ideal(0.75), v0=0.1)
    >>> round(needed.mu, 6), round(needed.angle, 6)
    (0.378154, 2.200825)
    """
    cases = Columns(hoop, plane, v0=v0)
    both = cases.new(2)
    compiled(kernels.needed_frictions)(cases.body, cases.of_speed("v0"), both)
    return NeededFriction(cases.shaped(both[:, 0]), cases.shaped(both[:, 1]))


def _rolled(body: Body, angle: float, rate: float, span: float) -> Any:
    """Events of a hoop that rolls on infinite friction up to the span or a turning point; None if it leaves the plane."""
    start = start_state(0.0, 0.0, float(angle), 0.0, 0.0, float(rate))
    events, body = np.empty(EVENTS, EVENT), body._replace(mu_s=math.inf, mu_k=math.inf)
    status, count, _ = compiled(run)(
        body, start, BY_RULE, ANY_TIME, float(span), STOP_AT_TURN, events, np.empty(0, SEGMENT), thread_scratch()
    )
    rolls = status in (Status.COMPLETED, Status.AT_REST) and np.all(events["after_mode"][:count] == Mode.ROLL)
    return events[:count] if rolls else None


def _time_to(body: Body, angle: float, speed: float) -> float:
    """Time from θ = 0 to an angle."""
    if angle == 0.0:
        return 0.0
    way = 1.0 if angle * speed >= 0.0 else -1.0  # the past is the future of the hoop that rolls the other way
    events = _rolled(body, 0.0, way * speed, abs(angle))
    if events is None:
        return math.nan
    end = events[-1]
    if Event.REST in events["kind"]:
        return math.inf
    return float(way * end["t"]) if abs(end["angle"] - angle) <= REACHED * abs(angle) else math.nan


def _period(body: Body, angle: float) -> float:
    """Period of rocking from rest at an angle."""
    events = _rolled(body, angle, 0.0, TURN)
    if events is None:
        return math.nan
    if Event.REST in events["kind"]:
        return math.inf
    return float(2.0 * events["t"][-1]) if Event.TURN in events["kind"] else math.nan


def rolling_time(theta: ArrayLike, hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Any:
    """Time in which the hoop rolls from θ = 0 to an angle.

    Parameters
    ----------
    theta : float or array_like
        Angle; one that lies behind has a negative time [rad].
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane

    Returns
    -------
    time : float or ndarray
        [s]; nan where the hoop does not get to theta or leaves the plane on the way, inf where it stays at θ = 0 for ever.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    Notes
    -----
    The integral ∫dθ/θ̇, elliptic on the level, is that of the simulated motion on infinite friction. Such a hoop rolls until the
    plane would have to pull it.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.rolling_time(3.141592653589793, hh.Hoop.ideal(0.75), v0=2.0), 9)
    0.888579754
    """
    cases = Columns(hoop, plane, theta=theta, v0=v0)
    times = [_time_to(cases.body, *case) for case in zip(cases["theta"], cases.of_speed("v0"), strict=True)]
    return cases.shaped(np.array(times) * cases.time)


def rolling_period(hoop: Hoop, v0: ArrayLike, plane: Plane = Plane()) -> Any:
    """Time of the first whole turn that a hoop rolls from θ = 0; on the level each turn takes as long.

    Parameters
    ----------
    hoop : Hoop
    v0 : float or array_like
        Velocity of the centre at θ = 0 [m/s].
    plane : Plane

    Returns
    -------
    period : float or ndarray
        [s]; nan where the hoop turns back or leaves the plane, inf where it rests for ever at θ = 0.

    Raises
    ------
    ValueError
        If v0 is not finite or the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.rolling_period(hh.Hoop.ideal(0.75), v0=2.0), 9)
    1.777159508
    """
    return rolling_time(np.where(np.asarray(v0, dtype=float) < 0.0, -TURN, TURN), hoop, v0, plane)


def rocking_period(theta: ArrayLike, hoop: Hoop, plane: Plane = Plane()) -> Any:
    """Period of the hoop that rocks to and fro, rolling, from rest at an angle.

    Parameters
    ----------
    theta : float or array_like
        Angle where it is let go [rad].
    hoop : Hoop
    plane : Plane

    Returns
    -------
    period : float or ndarray
        [s]; inf where it stays for ever, nan where the hoop rolls away and never comes back, or leaves the plane.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.rocking_period(1.5707963267948966, hh.Hoop.ideal(0.75)), 9)
    3.062349059
    """
    cases = Columns(hoop, plane, theta=theta)
    periods = [_period(cases.body, angle) for angle in cases["theta"]]
    return cases.shaped(np.array(periods) * cases.time)
