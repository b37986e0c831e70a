"""The massless hoop, γ = 1: where it loses its contact force."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from hophoop.kernel.native import compiled
from hophoop.scenario import Hoop, Plane
from hophoop.theory._columns import Columns
from hophoop.theory.kernels import rolling as kernels


class ContactLoss(NamedTuple):
    """Return the angle at which a massless hoop that rolls from the top loses its contact force.

    Attributes
    ----------
    angle : float or ndarray
        θ [rad].
    omega : float or ndarray
        θ̇ there [rad/s].
    by_friction : bool or ndarray of bool
        Whether tan(θ/2) reaches μs before N reaches zero.
    """

    angle: Any
    omega: Any
    by_friction: Any


def massless_loss(v0: ArrayLike, radius: ArrayLike = 1.0, plane: Plane = Plane()) -> ContactLoss:
    r"""Where the massless hoop (γ = 1) that rolls from the top loses its contact force.

    Parameters
    ----------
    v0 : float or array_like
        Velocity of the centre at the top; 0 means the smallest push [m/s].
    radius : float or array_like, default 1
        Rim radius [m].
    plane : Plane
        Level; its static friction counts.

    Returns
    -------
    loss : ContactLoss
        angle [rad], omega [rad/s], and whether friction was the reason.

    Raises
    ------
    ValueError
        If the plane slopes, a radius is not positive, or v0 is not finite.

    Notes
    -----
    The force must point along the line from the contact to the load, F/N = tan(θ/2). N falls to zero where
    :math:`\cos\theta = v_0^2/(gR)`, always with :math:`\dot\theta = \sqrt{g/R}`: at 90° from rest
    (Littlewood), at once for :math:`v_0^2 \ge gR`.

    References
    ----------
    :cite:t:`Littlewood1953`, :cite:t:`Tokieda1997`, :cite:t:`TheronDuPlessis2001`.

    Examples
    --------
    >>> import hophoop as hh
    >>> loss = hh.theory.massless_loss(v0=[0.0, 2.0], plane=hh.Plane(mu=2.0))
    >>> loss.angle.round(6), loss.omega.round(6)
    (array([1.570796, 1.150811]), array([3.132092, 3.132092]))
    """
    radii = np.asarray(radius, dtype=float)
    for one in np.unique(radii).tolist():
        Hoop.ideal(1.0, radius=one)  # refuses what is no radius
    cases = Columns(Hoop.ideal(1.0), plane, v0=v0, radius=radii)
    cases.require(lambda gt: gt == 0.0, "gt", "plane.slope must be 0 for the massless hoop.")
    cases.require(lambda gn: gn > 0.0, "gn", "plane.gravity must be above 0 here.")
    table = cases.new(3)
    compiled(kernels.contact_losses)(cases.body, cases.of_speed("v0") / np.sqrt(cases["radius"]), table)
    return ContactLoss(
        cases.shaped(table[:, 0]),
        cases.shaped(table[:, 1] / (cases.time * np.sqrt(cases["radius"]))),
        cases.shaped(table[:, 2] > 0.0),
    )
