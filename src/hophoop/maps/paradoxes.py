"""Search for Painlevé's paradox over load, friction and speed, and an energy bound for jams."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from hophoop._support.extras import need
from hophoop.kernel.numerics.elementwise import cosine
from hophoop.maps.grid.quantities import QUANTITIES
from hophoop.maps.grid.sweeping import sweep
from hophoop.scenario import Hoop, InputError, Plane, Scenario
from hophoop.theory import jam_states, painleve_region

if TYPE_CHECKING:
    import xarray


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
    >>> round(hh.maps.least_jam_speed(hh.Hoop.ideal(0.75)), 6)
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


def paradoxes(
    load_fractions: ArrayLike,
    frictions: ArrayLike,
    speeds: ArrayLike,
    span: str = "duration",
    base: Scenario | None = None,
    hops: bool = False,
) -> xarray.Dataset:
    """Search starts from the top, v_t = 0, for Painlevé's paradox and the dynamic jam.

    Parameters
    ----------
    load_fractions : array_like
        γ of ideal hoops, each from 0 to below 1 [1].
    frictions : array_like
        μs = μk [1].
    speeds : array_like
        Velocity of the centre at the top, at least two and above 0 [m/s].
    span : str, default 'duration'
        Searched part of each motion, as in `sweep`.
    base : Scenario, optional
        Everything else; by default the reference hoop for 6 s.
    hops : bool, default False
        Whether to include starts that are too fast to roll, v0² > g R cos β/γ, and hop at once.

    Returns
    -------
    dataset : xarray.Dataset
        Over load_fraction and friction: `starts`, the number of starts; `met`, the share that meets p_σ ≤ 0 or
        the jam, and `jammed`, the share that ends in a jam [1]; `lowest_speed` and `lowest_jam_speed`, the slowest of
        each, nan for none [m/s].

    Raises
    ------
    ValueError
        If an argument is out of range.
    ImportError
        If xarray is missing.

    Examples
    --------
    >>> found = paradoxes([0.5, 0.75], [0.5, 1.0], speeds=[0.1, 1.0, 2.0, 3.0])
    >>> bool(found["met"].values.max() <= 1.0)
    True
    """
    library = need("xarray", "maps")
    gammas = np.atleast_1d(np.asarray(load_fractions, dtype=float))
    mus = np.atleast_1d(np.asarray(frictions, dtype=float))
    fast = np.atleast_1d(np.asarray(speeds, dtype=float))
    if not ((gammas >= 0.0) & (gammas < 1.0)).all():
        raise InputError("load_fractions must be from 0 to below 1.")
    if fast.size < 2 or not (fast > 0.0).all():
        raise InputError("speeds must hold at least two numbers above 0.")
    base = Scenario() if base is None else base
    cells = sweep(
        base,
        {"hoop.load_fraction": gammas, "plane.mu": mus, "start.speed": fast},
        quantities=("status", "painleve"),
        span=span,
    )
    weight = base.plane.gravity * cosine(base.plane.slope) * base.hoop.radius
    rolls = (fast * fast)[None, :] * gammas[:, None] <= weight
    counted = np.broadcast_to((rolls | hops)[:, None, :], (gammas.size, mus.size, fast.size))
    met = counted & (cells["painleve"].values == QUANTITIES["painleve"].words.index("yes"))
    jammed = counted & (cells["status"].values == QUANTITIES["status"].words.index("jammed"))
    starts = counted.sum(axis=2)
    with np.errstate(invalid="ignore"):
        shares = {"met": met.sum(axis=2) / starts, "jammed": jammed.sum(axis=2) / starts}

    def slowest(found: np.ndarray) -> np.ndarray:
        lowest = np.where(found, fast, np.inf).min(axis=2)
        return np.where(np.isfinite(lowest), lowest, np.nan)

    over = ("load_fraction", "friction")
    dataset: xarray.Dataset = library.Dataset(
        {
            "starts": (over, starts, {"long_name": "Starts searched", "units": "1"}),
            "met": (over, shares["met"], {"long_name": "Share that meets Painlevé's paradox", "units": "1"}),
            "jammed": (over, shares["jammed"], {"long_name": "Share that ends in a jam", "units": "1"}),
            "lowest_speed": (over, slowest(met), {"long_name": "Slowest start that meets it", "units": "m/s"}),
            "lowest_jam_speed": (over, slowest(jammed), {"long_name": "Slowest start that jams", "units": "m/s"}),
        },
        {
            "load_fraction": ("load_fraction", gammas, {"long_name": "Share of the mass in the load", "units": "1"}),
            "friction": ("friction", mus, {"long_name": "Friction", "units": "1"}),
        },
    )
    return dataset
