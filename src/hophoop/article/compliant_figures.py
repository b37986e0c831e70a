"""Figures of compliant contact compared with rigid contact."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from hophoop._support.extras import need
from hophoop.article.convergence import (
    Landing,
    landing,
    landing_scenario,
    order,
    touch_scenario,
    with_contact,
)
from hophoop.plots.motion import energies
from hophoop.plots.style import finish, set_title
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary import colors

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MARKS = "osD^vPX"
_STIFFNESS = "Stiffness $k$ over $mg/R$"
_LOST = "Energy lost in the landing (J)"
_PARTS = (("o", colors.IMPACT_LOSS, "normal"), ("s", colors.FRICTION_LOSS, "friction"))


def error_lines(
    errors: dict[str, Any],
    stiffnesses: ArrayLike,
    ax: Axes | None = None,
    fit_from: float = 1e5,
    fit_to: float = 1e9,
) -> Axes:
    """Plot the maximum difference of θ against stiffness, one line per motion, with the fitted order.

    Parameters
    ----------
    errors : dict of array_like
        Name of the motion and its errors [rad].
    stiffnesses : array_like
        Over m g / R [1].
    ax : matplotlib Axes, optional
        A new one by default.
    fit_from, fit_to : float
        Range of the fit of the order [1].

    Returns
    -------
    ax : matplotlib Axes
    """
    ax = _axes(ax)
    k = np.asarray(stiffnesses, dtype=float)
    inside = (k >= fit_from * 0.99) & (k <= fit_to * 1.01)
    for index, (name, values) in enumerate(errors.items()):
        values = np.asarray(values)
        label = f"{name}: order {order(k[inside], values[inside]):.2f}"
        ax.loglog(k, values, marker=_MARKS[index], ms=4, lw=1.2, color=colors.SERIES[index], label=label)
    finish(ax, _STIFFNESS, "Largest difference of θ (rad)")
    return ax


def landing_against_stiffness(stiffnesses: ArrayLike, ax: Axes | None = None) -> Axes:
    """Plot the energy lost by the landing at v₀ = 3.1 m/s against stiffness (e = 0), with that of the rigid plane.

    Parameters
    ----------
    stiffnesses : array_like
        Over m g / R [1].
    ax : matplotlib Axes, optional
        A new one by default.

    Returns
    -------
    ax : matplotlib Axes
    """
    ax = _axes(ax)
    k = np.asarray(stiffnesses, dtype=float)
    soft = [landing(simulate(with_contact(touch_scenario(), value))) for value in k]
    _losses(ax, k, soft)
    _rigid_lines(ax, landing(simulate(touch_scenario())))
    ax.set_xscale("log")
    _finish_losses(ax, _STIFFNESS)
    return ax


def landing_against_slip_speed(slip_speeds: ArrayLike, stiffness: float = 1e8, ax: Axes | None = None) -> Axes:
    """Plot the same against the slip speed: a creeping friction law, and a bristle as stiff as the normal spring.

    Parameters
    ----------
    slip_speeds : array_like
        Over √(g R) [1].
    stiffness : float, default 1e8
        Over m g / R [1].
    ax : matplotlib Axes, optional
        A new one by default.

    Returns
    -------
    ax : matplotlib Axes
    """
    ax = _axes(ax)
    speeds = np.asarray(slip_speeds, dtype=float)
    one = touch_scenario()
    for friction in ("tanh", "bristle"):
        soft = [landing(simulate(with_contact(one, stiffness, speed, friction=friction))) for speed in speeds]
        _losses(ax, speeds, soft, line="-" if friction == "tanh" else ":", what=friction)
    _rigid_lines(ax, landing(simulate(touch_scenario())))
    ax.set_xscale("log")
    _finish_losses(ax, r"Slip speed $v_s$ over $\sqrt{gR}$")
    return ax


def landing_against_restitution(restitutions: ArrayLike, stiffness: float = 1e6, ax: Axes | None = None) -> Axes:
    """Plot the same against restitution: the rigid plane's three laws, and the compliant plane's nominal value.

    Parameters
    ----------
    restitutions : array_like
        e [1].
    stiffness : float, default 1e6
        Over m g / R [1].
    ax : matplotlib Axes, optional
        A new one by default.

    Returns
    -------
    ax : matplotlib Axes
    """
    ax = _axes(ax)
    e = np.asarray(restitutions, dtype=float)
    for law, dashes in (("stronge", "-"), ("poisson", "--"), ("newton", ":")):
        rigid = [landing(simulate(touch_scenario(value, law))) for value in e]
        ax.plot(e, [one.normal for one in rigid], dashes, color=colors.IMPACT_LOSS, lw=1.2)
        ax.plot(e, [one.tangential for one in rigid], dashes, color=colors.FRICTION_LOSS, lw=1.2)
        ax.plot([], [], dashes, color=colors.BLACK, lw=1.2, label=f"rigid, {law.capitalize()}")
    soft = [landing(simulate(with_contact(touch_scenario(value), stiffness))) for value in e]
    _losses(ax, e, soft, line="")
    _finish_losses(ax, "Restitution $e$")
    return ax


def energy_balance(ax_rigid: Axes | None = None, ax_soft: Axes | None = None, stiffness: float = 1e6) -> Any:
    """Plot the article's energy balance at v₀ = 3.1 m/s in both models.

    Parameters
    ----------
    ax_rigid, ax_soft : matplotlib Axes, optional
        Two new ones by default.
    stiffness : float, default 1e6
        Of the compliant model, over m g / R [1].

    Returns
    -------
    axes : tuple of matplotlib Axes
    """
    if ax_rigid is None or ax_soft is None:
        figure = need("matplotlib.pyplot", "plots").figure(figsize=(9.5, 4.0), layout="constrained")
        ax_rigid, ax_soft = figure.subplots(1, 2, sharey=True)
    assert ax_rigid is not None
    assert ax_soft is not None
    scenario = landing_scenario()
    soft = with_contact(scenario, stiffness)
    power = round(math.log10(stiffness))
    for ax, one, title in (
        (ax_rigid, scenario, f"rigid, $e$ = {scenario.plane.restitution:g}"),
        (ax_soft, soft, rf"compliant, $k = 10^{{{power}}}\,mg/R$"),
    ):
        energies(simulate(one), "angle", ax=ax)
        set_title(ax, title)
        # two columns, half a page wide
        ax.legend(frameon=False, fontsize=8.5, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2, handlelength=2.8)
    low, high = ax_rigid.get_ylim()
    ax_rigid.set_ylim(low, high)
    ax_soft.set_ylabel("")
    return ax_rigid, ax_soft


def _losses(ax: Axes, at: Any, landings: list[Landing], line: str = "-", what: str = "compliant") -> None:
    face = "white" if line == ":" else None
    for mark, color, part in _PARTS:
        lost = [one.normal if part == "normal" else one.tangential for one in landings]
        ax.plot(at, lost, line + mark, color=color, ms=4, lw=1.0, label=f"{what}, {part}", markerfacecolor=face)


def _finish_losses(ax: Axes, across: str) -> None:
    values = np.concatenate([np.asarray(each.get_ydata(), dtype=float) for each in ax.lines])
    low, high = min(0.0, float(np.nanmin(values))), max(0.1, float(np.nanmax(values)))
    # Newton's law can gain energy: show negative values
    ax.set_ylim(low - (0.06 * (high - low) if low < 0.0 else 0.0), high + 0.12 * (high - low))
    if low < 0.0:
        ax.axhline(0.0, color=colors.GRAY, lw=0.7, zorder=0)
    finish(ax, across, _LOST)


def _rigid_lines(ax: Axes, rigid: Landing) -> None:
    for _, color, part in _PARTS:
        ax.axhline(rigid.normal if part == "normal" else rigid.tangential, color=color, ls="--", lw=1.0, label=f"rigid, {part}")


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    figure = need("matplotlib.pyplot", "plots").figure(figsize=(5.2, 4.0), layout="constrained")
    made: Axes = figure.subplots()
    return made
