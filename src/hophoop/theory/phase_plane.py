"""The (θ, θ̇) plane of rolling states: which mode follows each, with exact borders."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from hophoop.kernel.model import MODE_LETTERS
from hophoop.kernel.native import compiled
from hophoop.scenario import Hoop, Plane
from hophoop.theory._columns import Columns
from hophoop.theory.kernels import phase_plane as kernels

_LETTERS = np.array([*MODE_LETTERS, "?"])


class RollingRange(NamedTuple):
    """The speeds at which a hoop can roll at an angle.

    Attributes
    ----------
    low, high : float or ndarray
        Magnitudes of θ̇ between which it rolls; both nan where it cannot at any speed [rad/s].
    """

    low: Any
    high: Any


def mode_of(theta: ArrayLike, omega: ArrayLike, hoop: Hoop, plane: Plane = Plane()) -> Any:
    """The mode in which a hoop goes on from contact without slip.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    omega : float or array_like
        Angular velocity [rad/s].
    hoop : Hoop
    plane : Plane

    Returns
    -------
    mode : str or ndarray of str
        R roll, S slip with v_t < 0, K with v_t > 0, H flight; M skim (massless hoop); ? where the model has no answer.

    Raises
    ------
    ValueError
        If a number is not finite or the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> hh.theory.mode_of([0.5, 2.0, 5.9], [3.0, 9.9, 4.0], hh.Hoop.ideal(0.75))
    array(['R', 'K', 'H'], dtype='<U1')
    """
    cases = Columns(hoop, plane, resisted=True, theta=theta, omega=omega)
    codes = np.empty(cases["theta"].size, dtype=np.int64)
    compiled(kernels.modes)(cases.body, cases["theta"], cases["omega"] * cases.time, codes)
    return cases.shaped(_LETTERS[codes])


def rolling_range(theta: ArrayLike, hoop: Hoop, plane: Plane = Plane()) -> RollingRange:
    """Between which angular velocities a hoop rolls at an angle: the border of roll and slip.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    hoop : Hoop
    plane : Plane

    Returns
    -------
    range : RollingRange
        low and high magnitudes of θ̇ [rad/s]; high is inf where friction holds at any speed, both are
        nan where it never does.

    Raises
    ------
    ValueError
        If theta is not finite or the shapes do not go together.

    Notes
    -----
    In rolling F and N are linear in θ̇², so that abs(F) = μs N has closed solutions at each angle.

    Examples
    --------
    >>> import hophoop as hh
    >>> low, high = hh.theory.rolling_range(0.5, hh.Hoop.ideal(0.75))
    >>> low, round(high, 6)
    (0.0, 3.572317)
    """
    cases = Columns(hoop, plane, theta=theta)
    both = cases.new(2)
    compiled(kernels.rolling_ranges)(cases.body, cases["theta"], both)
    return RollingRange(cases.shaped(both[:, 0] / cases.time), cases.shaped(both[:, 1] / cases.time))


def lift_off_speed(theta: ArrayLike, hoop: Hoop, plane: Plane = Plane()) -> Any:
    """Angular velocity at which the free rim would leave the plane, f_n = 0: the border of slip and flight.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    hoop : Hoop
    plane : Plane

    Returns
    -------
    omega : float or ndarray
        Its magnitude [rad/s]; inf where the load is not up (cos θ ≤ 0).

    Raises
    ------
    ValueError
        If theta is not finite or the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.lift_off_speed(0.0, hh.Hoop.ideal(0.75)), 6)
    3.616628
    """
    cases = Columns(hoop, plane, resisted=True, theta=theta)  # there is no contact force in it
    rates = cases.new()
    compiled(kernels.lift_off_speeds)(cases.body, cases["theta"], rates)
    return cases.shaped(rates / cases.time)
