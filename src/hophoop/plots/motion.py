"""Curves of a motion against time or angle: velocities, energies, contact forces, friction utilization, gap."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle
from typing import TYPE_CHECKING, Any, NamedTuple

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

DASHES = ("-", (0, (5, 2)), (0, (1, 1.4)), (0, (6, 2, 1, 2)))  # of several motions
BROKEN, THIN = (0, (4, 1.6)), 1.0


class Curve(NamedTuple):
    """A line of a figure: its field of a sample, what it shows, and how."""

    field: str
    label: str
    color: str
    dashes: Any = "-"
    width: float = LINE
    always: bool = True  # also where it is zero throughout


ENERGIES = (
    Curve("kinetic", "kinetic", colors.KINETIC),
    Curve("potential", "potential", colors.POTENTIAL, BROKEN),
    Curve("total", "kinetic + potential", colors.TOTAL, (0, (7, 1.5, 1.2, 1.5))),
    Curve("friction_loss", "lost to friction", colors.FRICTION_LOSS, (0, (1.2, 1.2)), always=False),
    Curve("normal_loss", "", colors.IMPACT_LOSS, (0, (3, 1.2, 1, 1.2, 1, 1.2)), always=False),
    Curve("rolling_resistance", "lost to rolling resistance", colors.GRAY, (0, (2, 1, 1, 1)), always=False),
    Curve("spring", "in the contact's spring", colors.GRAY, width=THIN, always=False),
)
FORCES = (
    Curve("normal_force", "normal force", colors.NORMAL_FORCE),
    Curve("friction_force", "friction", colors.FRICTION_FORCE),
)


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
    radius = motion.scenario.hoop.radius
    draw_bands(ax, uncertainty, sample, against, {"vx": (1.0, colors.CENTER_SPEED), "omega": (radius, colors.ROTATION_SPEED)})
    across = _across(sample, against)
    _line(ax, across, sample.vx, Curve("vx", "centre, $v$", colors.CENTER_SPEED))
    _line(ax, across, radius * sample.omega, Curve("omega", r"rotation, $R\dot\theta$", colors.ROTATION_SPEED, BROKEN))
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
    ax.axhline(0.0, color=colors.GRAY, lw=0.7)
    sample = curve(motion)
    for one in ENERGIES:
        values = getattr(sample, one.field)
        if one.always or np.any(values != 0.0):
            label = one.label or quantities.normal_loss(motion.scenario.contact.model)
            _line(ax, _across(sample, against), values, one._replace(label=label))
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
    for motion, name, dashes in zip(many, names, cycle(DASHES), strict=False):
        sample = curve(motion)
        for one in FORCES:
            told = one._replace(label=one.label + name, dashes=dashes)
            _line(ax, _across(sample, against), getattr(sample, one.field), told)
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
    for motion, name, dashes in zip(many, names, cycle(DASHES), strict=False):
        sample = curve(motion)
        used = sample.utilization(motion.scenario.plane, signed=True)
        _line(ax, _across(sample, against), used, Curve("", name.removeprefix(", "), colors.FRICTION_FORCE, dashes))
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
    _line(ax, _across(sample, against), sample.height, Curve("height", "", colors.BLACK))
    ax.set_ylim(bottom=min(0.0, float(np.min(sample.height))))
    _frame(ax, motion, against, quantities.GAP, modes)
    return ax


def _line(ax: Axes, across: Any, values: Any, one: Curve) -> None:
    ax.plot(across, values, color=one.color, lw=one.width, ls=one.dashes, label=one.label or None)


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
