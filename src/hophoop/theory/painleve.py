"""Painlevé's paradox: its required friction, its region, the states of the dynamic jam and an energy bound for it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from hophoop.kernel.model import most_resistance
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.elementwise import cosine
from hophoop.scenario import Hoop, InputError, Plane, time_unit, to_body
from hophoop.theory._columns import Columns, require_no_resistance
from hophoop.theory.kernels import painleve as kernels
from hophoop.theory.kernels.arcs import TURN
from hophoop.theory.kernels.phase_plane import lift_off
from hophoop.vocabulary.parameters import RANGES


class PainleveMinimum(NamedTuple):
    """The minimum friction with which the paradox exists at all.

    Attributes
    ----------
    mu : float or ndarray
        Kinetic friction [1]; inf where ε = 0.
    angle : float or ndarray
        θ where it is needed for spin; 2π − θ for skid [rad].
    """

    mu: Any
    angle: Any


@dataclass(frozen=True)
class JamState:
    """A state in which slip runs into p_σ = 0 and f_n = 0 together.

    Attributes
    ----------
    mode : str
        S spin or K skid.
    angle : float
        θ [rad].
    omega : float
        Magnitude of θ̇ [rad/s].
    """

    mode: str
    angle: float
    omega: float


def painleve_threshold(theta: ArrayLike, hoop: Hoop) -> Any:
    r"""Return the kinetic friction from which slip at an angle meets Painlevé's paradox, p_σ ≤ 0, without rolling resistance.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad]. The paradox is one of spin for sin θ > 0 and of skid for sin θ < 0, on any slope.
    hoop : Hoop

    Returns
    -------
    mu : float or ndarray
        [1]; inf if no friction is enough.

    Raises
    ------
    ValueError
        If theta is not finite or the shapes do not go together.

    Notes
    -----
    :math:`\mu = (\kappa + \varepsilon^2 \sin^2\theta)
    / (\varepsilon |\sin\theta| (1 + \varepsilon \cos\theta))`.

    References
    ----------
    The paradox in general: :cite:t:`Painleve1895`, :cite:t:`ChampneysVarkonyi2016`.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.painleve_threshold(1.0, hh.Hoop.ideal(0.75)), 9)
    0.942434192
    """
    cases = Columns(hoop, Plane(), theta=theta)
    thresholds = cases.new()
    compiled(kernels.thresholds)(cases.body, cases["theta"], thresholds)
    return cases.shaped(thresholds)


def painleve_minimum(hoop: Hoop) -> PainleveMinimum:
    r"""Return the minimum friction with which Painlevé's paradox exists at any angle, without rolling resistance.

    Parameters
    ----------
    hoop : Hoop

    Returns
    -------
    minimum : PainleveMinimum
        mu [1] and angle [rad].

    Raises
    ------
    ValueError
        If hoop is not a Hoop.

    Notes
    -----
    For the ideal hoop :math:`\mu = \sqrt{1 - \gamma^2}/\gamma` at :math:`\cos\theta = \gamma`; in general
    cos θ is the root of a cubic.

    Examples
    --------
    >>> import hophoop as hh
    >>> mu, angle = hh.theory.painleve_minimum(hh.Hoop.ideal(0.75))
    >>> round(mu, 6), round(angle, 6)
    (0.881917, 0.722734)
    """
    return PainleveMinimum(*compiled(kernels.minimum)(Columns(hoop, Plane()).body))


def painleve_region(
    theta: ArrayLike, mu: ArrayLike, hoop: Hoop, *, rolling_resistance: ArrayLike = 0.0, omega: ArrayLike | None = None
) -> Any:
    """Return the direction of slip that meets Painlevé's paradox at an angle.

    Parameters
    ----------
    theta : float or array_like
        Angle [rad].
    mu : float or array_like
        Kinetic friction, at least 0 [1].
    hoop : Hoop
    rolling_resistance : float or array_like, default 0
        Couple against the rotation over R N [1].
    omega : float or array_like, optional
        Angular velocity, of which only the sign counts [rad/s]. Required with rolling resistance, whose couple changes
        sign with it.

    Returns
    -------
    direction : int or ndarray of int
        σ = sign(v_t) with p_σ ≤ 0: −1 spin, +1 skid, 0 neither, 2 both (only with rolling resistance) [1].

    Raises
    ------
    ValueError
        If a number is not finite, mu is negative, rolling_resistance is not possible for the hoop or given without omega, or
        the shapes do not go together.

    Examples
    --------
    >>> import hophoop as hh
    >>> hh.theory.painleve_region([0.7, -0.7, 2.0], 1.0, hh.Hoop.ideal(0.75))
    array([-1,  1,  0])
    >>> hh.theory.painleve_region(0.7, 0.9, hh.Hoop.ideal(0.75), rolling_resistance=0.1, omega=[1.0, -1.0])
    array([-1,  0])
    """
    rates = 0.0 if omega is None else omega
    cases = Columns(hoop, Plane(), theta=theta, mu=mu, rolling_resistance=rolling_resistance, omega=rates)
    if (cases["mu"] < 0.0).any():
        raise InputError.of_field("mu", float(cases["mu"].min()), "at least 0")
    frictions, kinds = np.unique(np.stack((cases["mu"], cases["rolling_resistance"])), axis=1, return_inverse=True)
    for resist in np.unique(frictions[1]).tolist():
        if resist != 0.0:
            _check_resistance(hoop, resist)
            if omega is None:
                raise InputError.of_field("omega", None, "given: with rolling resistance the direction of rotation counts")
    directions = np.empty(kinds.size, dtype=np.int64)
    for k, (friction, resist) in enumerate(frictions.T.tolist()):
        chosen = np.flatnonzero(kinds.reshape(-1) == k)
        found = np.empty_like(chosen)
        body = cases.body._replace(mu_s=friction, mu_k=friction, resist=resist)
        compiled(kernels.regions)(body, cases["theta"][chosen], cases["omega"][chosen], found)
        directions[chosen] = found
    return cases.shaped(directions)


def _check_resistance(hoop: Hoop, given: float) -> None:
    """Refuse a rolling resistance that the hoop cannot have."""
    allowed = RANGES["plane.rolling_resistance"]
    if not allowed.least <= given <= allowed.most:
        raise InputError.of_field("rolling_resistance", given, allowed.words())
    if hoop.inertia_ratio == 0.0:
        raise InputError.of_field("rolling_resistance", given, "0 for the massless hoop (hoop.inertia_ratio = 0)")
    most = most_resistance(hoop.eccentricity, hoop.inertia_ratio)
    if not given < most:
        raise InputError.of_field("rolling_resistance", given, f"below {most:.6g} for this hoop")


def jam_states(hoop: Hoop, plane: Plane = Plane()) -> tuple[JamState, ...]:
    """The states that a dynamic jam ends in: p_σ = 0 with θ̇² = g cos β/(εR cos θ).

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Its kinetic friction counts.

    Returns
    -------
    states : tuple of JamState
        By angle from 0 to 2π; empty where friction is too small. Which of them a motion can end in depends on
        how it slips towards them.

    Raises
    ------
    ValueError
        If the hoop is massless, or the plane has rolling resistance.

    References
    ----------
    :cite:t:`GenotBrogliato1999`.

    Examples
    --------
    >>> import hophoop as hh
    >>> for state in hh.theory.jam_states(hh.Hoop.ideal(0.75)):
    ...     print(state.mode, round(state.angle, 6), round(state.omega, 6))
    S 0.445561 3.807254
    S 1.125235 5.509132
    K 5.15795 5.509132
    K 5.837624 3.807254
    """
    if hoop.massless:
        raise InputError("hoop.inertia_ratio = 0 must be above 0: the massless hoop never slips.")
    require_no_resistance(plane)
    body = to_body(hoop, plane)
    second = time_unit(hoop, plane)
    found = []
    if hoop.eccentricity > 0.0 and math.isfinite(plane.mu_kinetic):
        for high_side in (False, True):
            border = float(compiled(kernels.border)(body, plane.mu_kinetic, high_side))
            if math.isnan(border):
                continue
            for mode, angle in (("S", border), ("K", TURN - border)):
                rate = float(compiled(lift_off)(body, angle))
                if math.isfinite(rate):
                    found.append(JamState(mode, angle, rate / second))
    return tuple(sorted(found, key=lambda state: state.angle))


def least_jam_speed(hoop: Hoop, plane: Plane = Plane()) -> float:
    r"""Return the speed at the top below which energy forbids every jam that an open set of motions ends in.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Level; only its kinetic friction and gravity matter.

    Returns
    -------
    speed : float
        Of the centre, with v_t = 0 and the load at the top [m/s]; inf where there is no such jam.

    Raises
    ------
    ValueError
        If the plane slopes or the hoop is massless.

    Notes
    -----
    Slip draws a whole range of motions into p_σ = 0, f_n = 0 only where v_t and θ̇ have one sign. Then the kinetic
    energy is at least that of rolling with the same θ̇, so that with c = cos θ of the jam

    .. math::
        \begin{aligned}
        &\tfrac12\bigl((1 + \varepsilon)^2 + \kappa\bigr) v_0^2 \ge \\
        &\quad gR\left[\frac{1 + \kappa + \varepsilon^2 + 2 \varepsilon c}{2 \varepsilon c} - \varepsilon (1 - c)\right].
        \end{aligned}

    At :math:`v_0^2 = gR/\varepsilon` the right side exceeds the left for every body: a hoop that can roll at the top
    never has the energy. The sum of all losses is never negative, except under Newton's law.

    Examples
    --------
    >>> import hophoop as hh
    >>> round(hh.theory.least_jam_speed(hh.Hoop.ideal(0.75)), 6)
    4.533926
    >>> round(hh.theory.immediate_hop_speed(hh.Hoop.ideal(0.75)), 6)
    3.616628
    """
    if plane.slope != 0.0:
        raise InputError.of_field("plane.slope", plane.slope, "0: on a slope the energy grows with the distance")
    eps, kappa = hoop.eccentricity, hoop.inertia_ratio
    for state in jam_states(hoop, plane):
        if state.mode == "K" and painleve_region(state.angle + 1e-7, plane.mu_kinetic, hoop) == 1:
            up = cosine(state.angle)
            need_of_it = (1.0 + kappa + eps * eps + 2.0 * eps * up) / (2.0 * eps * up) - eps * (1.0 - up)
            return math.sqrt(2.0 * plane.gravity * hoop.radius * need_of_it / ((1.0 + eps) * (1.0 + eps) + kappa))
    return math.inf
