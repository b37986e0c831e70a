"""Which natural motions meet Painlevé's paradox: a search over load, friction and speed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from hophoop._extras import need
from hophoop.maps.quantities import QUANTITIES
from hophoop.maps.sweeping import sweep
from hophoop.scenario import InputError, Scenario

if TYPE_CHECKING:
    import xarray


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
        How much of each motion is searched, as in `sweep`.
    base : Scenario, optional
        All else; by default the article's hoop for 6 s.
    hops : bool, default False
        Whether starts count that are too fast to roll at all, v0² > g R cos β/γ, and hop at once.

    Returns
    -------
    dataset : xarray.Dataset
        Over load_fraction and friction: `starts`, how many starts counted; `met`, the share of them that
        meet p_σ ≤ 0 or the jam, and `jammed`, the share that end in a jam [1]; `lowest_speed`, the slowest that meets
        it, nan where none does [m/s].

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
    weight = base.plane.gravity * math.cos(base.plane.slope) * base.hoop.radius
    rolls = fast[None, :] ** 2 * gammas[:, None] <= weight
    counted = np.broadcast_to((rolls | hops)[:, None, :], (gammas.size, mus.size, fast.size))
    met = counted & (cells["painleve"].values == QUANTITIES["painleve"].words.index("yes"))
    jammed = counted & (cells["status"].values == QUANTITIES["status"].words.index("jammed"))
    starts = counted.sum(axis=2)
    with np.errstate(invalid="ignore"):
        shares = {"met": met.sum(axis=2) / starts, "jammed": jammed.sum(axis=2) / starts}
    lowest = np.where(met, fast, np.inf).min(axis=2)
    lowest[~np.isfinite(lowest)] = np.nan
    over = ("load_fraction", "friction")
    dataset: xarray.Dataset = library.Dataset(
        {
            "starts": (over, starts, {"long_name": "Starts searched", "units": "1"}),
            "met": (over, shares["met"], {"long_name": "Share that meets Painlevé's paradox", "units": "1"}),
            "jammed": (over, shares["jammed"], {"long_name": "Share that ends in a jam", "units": "1"}),
            "lowest_speed": (over, lowest, {"long_name": "Slowest start that meets it", "units": "m/s"}),
        },
        {
            "load_fraction": ("load_fraction", gammas, {"long_name": "Share of the mass in the load", "units": "1"}),
            "friction": ("friction", mus, {"long_name": "Friction", "units": "1"}),
        },
    )
    return dataset
