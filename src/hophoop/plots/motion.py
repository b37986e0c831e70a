"""Curves of a motion against time or angle: velocities, energies, contact forces, friction utilization, gap."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from hophoop.plots.bands import draw_bands
from hophoop.plots.curves import curve
from hophoop.plots.style import LINE, Against, abscissa, as_list, check_against, finish, new_axes, show_modes
from hophoop.results.records import ArraySample
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hophoop.derivatives.results.uncertainty import Uncertainty
else:
    Axes = Any

LOOK = [
    ("-", LINE, 1.0),
    ((0, (5, 2)), LINE, 1.0),
    ((0, (1, 1.4)), LINE, 1.0),
    ((0, (6, 2, 1, 2)), LINE, 1.0),
]


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
    check_against(against)
    ax = new_axes(ax)
    sample = curve(motion)
    across = _across(sample, against)
    radius = motion.scenario.hoop.radius
    draw_bands(ax, uncertainty, sample, against, {"vx": (1.0, colors.CENTER_SPEED), "omega": (radius, colors.ROTATION_SPEED)})
    ax.plot(across, sample.vx, color=colors.CENTER_SPEED, lw=LINE, label="centre, $v$")
    ax.plot(
        across, radius * sample.omega, color=colors.ROTATION_SPEED, lw=LINE, ls=(0, (4, 1.6)),
        label=r"rotation, $R\dot\theta$",
    )  # fmt: skip
    _frame(ax, motion, against, quantities.VELOCITY, modes)
    return ax


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
    check_against(against)
    ax = new_axes(ax)
    sample = curve(motion)
    across = _across(sample, against)
    ax.axhline(0.0, color=colors.GRAY, lw=0.7)
    ax.plot(across, sample.kinetic, color=colors.KINETIC, lw=LINE, label="kinetic")
    ax.plot(across, sample.potential, color=colors.POTENTIAL, lw=LINE, ls=(0, (4, 1.6)), label="potential")
    ax.plot(
        across,
        sample.total,
        color=colors.TOTAL,
        lw=LINE,
        ls=(0, (7, 1.5, 1.2, 1.5)),
        label="kinetic + potential",
    )
    if np.any(sample.friction_loss > 0.0):
        ax.plot(
            across,
            sample.friction_loss,
            color=colors.FRICTION_LOSS,
            lw=LINE,
            ls=(0, (1.2, 1.2)),
            label="lost to friction",
        )
    if np.any(sample.normal_loss != 0.0):
        ax.plot(
            across,
            sample.normal_loss,
            color=colors.IMPACT_LOSS,
            lw=LINE,
            ls=(0, (3, 1.2, 1, 1.2, 1, 1.2)),
            label=quantities.normal_loss(motion.scenario.contact.model),
        )
    if np.any(sample.rolling_resistance > 0.0):
        ax.plot(
            across,
            sample.rolling_resistance,
            color=colors.GRAY,
            lw=LINE,
            ls=(0, (2, 1, 1, 1)),
            label="lost to rolling resistance",
        )
    if np.any(sample.spring > 0.0):
        ax.plot(across, sample.spring, color=colors.GRAY, lw=1.0, label="in the contact's spring")
    _frame(ax, motion, against, quantities.ENERGY, modes)
    return ax


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
    check_against(against)
    many = as_list(motions)
    names = _names(many, labels)
    ax = new_axes(ax)
    ax.axhline(0.0, color=colors.GRAY, lw=0.7)
    for k, (motion, name) in enumerate(zip(many, names, strict=True)):
        sample = curve(motion)
        across = _across(sample, against)
        dash, width, _ = LOOK[k % len(LOOK)]
        ax.plot(
            across,
            sample.normal_force,
            color=colors.NORMAL_FORCE,
            lw=width,
            ls=dash,
            label=f"normal force{name}",
        )
        ax.plot(
            across,
            sample.friction_force,
            color=colors.FRICTION_FORCE,
            lw=width,
            ls=dash,
            label=f"friction{name}",
        )
    _frame(ax, _widest(many, against), against, quantities.FORCE, modes and len(many) == 1)
    return ax


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
    check_against(against)
    many = as_list(motions)
    names = _names(many, labels)
    ax = new_axes(ax)
    for level in (-1.0, 1.0):
        ax.axhline(level, color=colors.LIMIT, lw=1.0, ls=(0, (4, 2)))
    ax.axhline(0.0, color=colors.GRAY, lw=0.7)
    for k, (motion, name) in enumerate(zip(many, names, strict=True)):
        sample = curve(motion)
        dash, width, _ = LOOK[k % len(LOOK)]
        label = name.removeprefix(", ") or None
        ax.plot(
            _across(sample, against),
            sample.utilization(motion.scenario.plane, signed=True),
            color=colors.FRICTION_FORCE,
            lw=width,
            ls=dash,
            label=label,
        )
    ax.set_ylim(-1.15, 1.15)
    _frame(ax, _widest(many, against), against, rf"{quantities.UTILIZATION}, $F/(\mu N)$", modes and len(many) == 1)
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
    check_against(against)
    ax = new_axes(ax)
    sample = curve(motion)
    draw_bands(ax, uncertainty, sample, against, {"height": (1.0, colors.BLACK)})
    ax.plot(_across(sample, against), sample.height, color=colors.BLACK, lw=LINE)
    ax.set_ylim(bottom=min(0.0, float(np.min(sample.height))))
    _frame(ax, motion, against, quantities.GAP, modes)
    return ax


def _frame(ax: Axes, motion: Trajectory, against: Against, up: str, modes: bool) -> None:
    label = abscissa(ax, motion, against)
    if modes:
        show_modes(ax, motion, against)
    finish(ax, label, up)


def _across(sample: ArraySample, against: Against) -> Any:
    return sample.t if against == "time" else np.degrees(sample.angle)


def _names(motions: Sequence[Trajectory], labels: Sequence[str] | None) -> list[str]:
    if labels is None:
        return [""] if len(motions) == 1 else [f", motion {k + 1}" for k in range(len(motions))]
    if len(labels) != len(motions):
        raise InputError.of_field("labels", list(labels), f"one for each of the {len(motions)} motions")
    return [f", {label}" if label else "" for label in labels]


def _widest(motions: Sequence[Trajectory], against: Against) -> Trajectory:
    if against == "time":
        return max(motions, key=lambda motion: motion.duration)
    return max(motions, key=lambda motion: abs(motion.events[-1].angle - motion.events[0].angle))
