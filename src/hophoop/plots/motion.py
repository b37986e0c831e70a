"""Curves of a motion against time or angle: velocities, energies, contact forces, friction utilization, gap."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import cycle
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from hophoop.plots.bands import draw_bands
from hophoop.plots.curves import ENERGIES, FORCES, GAP, UTILIZATION, VELOCITIES, Curve, curve, values_of
from hophoop.plots.style import Against, Axes, abscissa, as_list, check_against, check_labels, finish, new_axes, show_modes
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

if TYPE_CHECKING:
    from hophoop.derivatives.results.uncertainty import Uncertainty

DASHES = ("-", (0, (5, 2)), (0, (1, 1.4)), (0, (6, 2, 1, 2)))  # of several motions


def velocities(
    motion: Trajectory,
    against: Against = "time",
    ax: Axes | None = None,
    modes: bool = True,
    uncertainty: Uncertainty | None = None,
) -> Axes:
    """Draw the velocity of the centre and the angular velocity times the radius; they coincide in rolling.

    Parameters
    ----------
    motion : Trajectory
    against : {'time', 'angle'}
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    modes : bool, default True
        Whether modes are shaded and events marked.
    uncertainty : Uncertainty, optional
        Uncertainty of the motion, drawn as bands of two standard deviations, against time only.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `against` is neither, or an angle with an uncertainty.
    ImportError
        If Matplotlib is missing.
    """
    factors = {"vx": (1.0, colors.CENTER_SPEED), "omega": (motion.scenario.hoop.radius, colors.ROTATION_SPEED)}
    return _draw(motion, VELOCITIES, against, ax, quantities.VELOCITY, modes, uncertainty=uncertainty, bands=factors)


def energies(motion: Trajectory, against: Against = "angle", ax: Axes | None = None, modes: bool = True) -> Axes:
    """Draw kinetic and potential energy, their sum, and the losses to friction and impacts.

    The tangential loss of an impact counts as friction, so that rigid and compliant contact show the same.

    Parameters
    ----------
    motion : Trajectory
    against : {'angle', 'time'}
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    modes : bool, default True
        Whether modes are shaded and events marked.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `against` is neither.
    ImportError
        If Matplotlib is missing.
    """
    return _draw(motion, ENERGIES, against, ax, quantities.ENERGY, modes, zero=True)


def contact_forces(
    motions: Trajectory | Sequence[Trajectory],
    against: Against = "angle",
    ax: Axes | None = None,
    labels: Sequence[str] | None = None,
    modes: bool = True,
) -> Axes:
    """Draw the normal force and friction on the hoop.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
        One motion, or several to compare.
    against : {'angle', 'time'}
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    labels : sequence of str, optional
        One per motion.
    modes : bool, default True
        Whether modes are shaded and events marked, for a single motion.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `against` is neither, there is no motion, or the numbers of labels and motions differ.
    ImportError
        If Matplotlib is missing.
    """
    return _draw(motions, FORCES, against, ax, quantities.FORCE, modes, labels, zero=True)


def friction_utilization(
    motions: Trajectory | Sequence[Trajectory],
    against: Against = "angle",
    ax: Axes | None = None,
    labels: Sequence[str] | None = None,
    modes: bool = True,
) -> Axes:
    """Draw the friction utilization with the sign of the friction, F/(μ N); the hoop slips at ±1.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
        One motion, or several to compare.
    against : {'angle', 'time'}
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    labels : sequence of str, optional
        One per motion.
    modes : bool, default True
        Whether modes are shaded and events marked, for a single motion.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `against` is neither, there is no motion, or the numbers of labels and motions differ.
    ImportError
        If Matplotlib is missing.

    Notes
    -----
    In slip μ is the kinetic friction, otherwise the static one, so that 1 is the limit in both cases.
    """
    label = rf"{quantities.UTILIZATION}, $F/(\mu N)$"
    ax = _draw(motions, UTILIZATION, against, ax, label, modes, labels, zero=True, limits=(-1.0, 1.0))
    ax.set_ylim(-1.15, 1.15)
    return ax


def gap(
    motion: Trajectory,
    against: Against = "time",
    ax: Axes | None = None,
    modes: bool = True,
    uncertainty: Uncertainty | None = None,
) -> Axes:
    """Draw the gap between rim and plane; the hoop hops where it is positive.

    Parameters
    ----------
    motion : Trajectory
    against : {'time', 'angle'}
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    modes : bool, default True
        Whether modes are shaded and events marked.
    uncertainty : Uncertainty, optional
        Uncertainty of the motion, drawn as bands of two standard deviations, against time only.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `against` is neither, or an angle with an uncertainty.
    ImportError
        If Matplotlib is missing.
    """
    ax = _draw(motion, GAP, against, ax, quantities.GAP, modes, uncertainty=uncertainty, bands={"height": (1.0, colors.BLACK)})
    ax.set_ylim(bottom=min(0.0, float(np.min(curve(motion).height))))
    return ax


def _draw(
    motions: Trajectory | Sequence[Trajectory],
    curves: Sequence[Curve],
    against: Against,
    ax: Axes | None,
    up: str,
    modes: bool,
    labels: Sequence[str] | None = None,
    zero: bool = False,
    limits: Sequence[float] = (),
    uncertainty: Uncertainty | None = None,
    bands: Mapping[str, tuple[float, str]] = MappingProxyType({}),
) -> Axes:
    """Draw curves of one or several motions; `up` is the label of the axis, `bands` the fields with an uncertainty."""
    check_against(against)
    many = as_list(motions)
    names = _names(many, labels)
    ax = new_axes(ax)
    for level in limits:
        ax.axhline(level, color=colors.LIMIT, lw=1.0, ls=(0, (4, 2)))
    if zero:
        ax.axhline(0.0, color=colors.GRAY, lw=0.7)
    for motion, name, dashes in zip(many, names, cycle(DASHES), strict=False):
        sample = curve(motion)
        draw_bands(ax, uncertainty, sample, against, bands)
        across = sample.t if against == "time" else np.degrees(sample.angle)
        for one in curves:
            values = values_of(one.field, sample, motion.scenario)
            if one.always or np.any(values != 0.0):
                loss = quantities.normal_loss(motion.scenario.contact.model) if one.field == "normal_loss" else one.label
                label = (loss + name).removeprefix(", ") or None
                ls = one.dashes if len(many) == 1 else dashes
                ax.plot(across, values, color=one.color, lw=one.width, ls=ls, label=label)
    across_label = abscissa(ax, against)
    if modes and len(many) == 1:
        show_modes(ax, many[0], against)
    finish(ax, across_label, up)
    return ax


def _names(motions: Sequence[Trajectory], labels: Sequence[str] | None) -> list[str]:
    check_labels(labels, motions)
    if labels is None:
        return [""] if len(motions) == 1 else [f", motion {k + 1}" for k in range(len(motions))]
    return [f", {label}" if label else "" for label in labels]
