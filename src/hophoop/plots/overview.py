"""A whole motion at a glance: the page of `hophoop run --plot`, and the little picture of a notebook."""

from __future__ import annotations

import base64
import io
import math
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hophoop._extras import need
from hophoop._files import replacing
from hophoop.plots.curves import turning
from hophoop.plots.motion import contact_forces, energies, friction_utilization, velocities
from hophoop.plots.path import path
from hophoop.plots.style import Against
from hophoop.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.figure import Figure
else:
    Figure = Any

MOST_ROWS = 12


def overview(motion: Trajectory) -> Figure:
    """Path, velocities, energies, forces and friction of a motion on one page.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    figure : matplotlib.figure.Figure
        Not known to pyplot: save it with its own ``savefig``.

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    figure: Figure = need("matplotlib.figure", "plots").Figure(figsize=(11.0, 11.0), layout="constrained")
    grid = figure.add_gridspec(3, 2, height_ratios=[0.85, 1.0, 1.0])
    path(motion, ax=figure.add_subplot(grid[0, :]))
    across: Against = "time" if turning(motion) else "angle"
    velocities(motion, "time", ax=figure.add_subplot(grid[1, 0]))
    energies(motion, across, ax=figure.add_subplot(grid[1, 1]))
    contact_forces(motion, across, ax=figure.add_subplot(grid[2, 0]))
    friction_utilization(motion, across, ax=figure.add_subplot(grid[2, 1]))
    figure.suptitle(f"{describe(motion)}    phases {_short(motion.sequence)}    {motion.status}", fontsize=11)
    return figure


def save_overview(motion: Trajectory, path: str | Path) -> None:
    """Write `overview` to a picture, whole or not at all.

    Parameters
    ----------
    motion : Trajectory
    path : str or Path
        Its ending is one that Matplotlib knows, such as .png, .svg or .pdf.

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    OSError
        If the file cannot be written.
    """
    with replacing(Path(path)) as temporary:
        overview(motion).savefig(temporary, dpi=150)


def describe(motion: Trajectory) -> str:
    """The scenario in a line: hoop, friction, start.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    line : str
    """
    hoop, plane, start = motion.scenario.hoop, motion.scenario.plane, motion.scenario.start
    body = (
        f"γ = {hoop.load_fraction:g}"
        if hoop.load_fraction is not None
        else f"ε = {hoop.eccentricity:.4g}, κ = {hoop.inertia_ratio:.4g}"
    )
    if plane.mu_static == plane.mu_kinetic:
        friction = f"μ = {plane.mu_static:g}"
    else:
        friction = f"μs = {plane.mu_static:g}, μk = {plane.mu_kinetic:g}"
    parts = [body, friction]
    if plane.slope != 0.0:
        parts.append(f"slope {math.degrees(plane.slope):.4g}°")
    if start.speed is not None:
        parts.append(f"v₀ = {start.speed:g} m/s")
    else:
        omega = start.omega or 0.0
        parts.append(f"starts with v = ({start.vx:g}, {start.vy:g}) m/s, θ̇ = {omega:g} rad/s")
    return ", ".join(parts)


def notebook(motion: Trajectory) -> str:
    """A small picture and a short table, for a notebook.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    html : str
        Without Matplotlib the table alone.
    """
    rows = "".join(
        f"<tr><td>{event.t:.6g}</td><td style='text-align:left'>{escape(event.kind.replace('_', ' '))}</td>"
        f"<td>{event.from_mode or ''} → {event.to_mode}</td><td>{math.degrees(event.angle):.5g}</td>"
        f"<td>{event.x:.5g}</td><td>{event.vx:.5g}</td><td>{event.omega:.5g}</td></tr>"
        for event in motion.events[:MOST_ROWS]
    )
    more = len(motion.events) - MOST_ROWS
    if more > 0:
        rows += f"<tr><td colspan='7' style='text-align:left'>… and {more} more</td></tr>"
    table = (
        "<table><thead><tr><th>t (s)</th><th>event</th><th>mode</th><th>θ (°)</th><th>x (m)</th>"
        f"<th>v (m/s)</th><th>θ̇ (rad/s)</th></tr></thead><tbody>{rows}</tbody></table>"
    )
    head = (
        f"<b>{escape(describe(motion))}</b><br>phases <code>{escape(_short(motion.sequence))}</code>, "
        f"{escape(motion.status.replace('_', ' '))} after {motion.duration:.6g} s"
    )
    return f"<div>{head}{_picture(motion)}{table}</div>"


def _picture(motion: Trajectory) -> str:
    try:
        figure_class = need("matplotlib.figure", "plots").Figure
    except ImportError:
        return ""
    figure = figure_class(figsize=(8.0, 2.6), layout="constrained")
    path(motion, ax=figure.subplots())
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=100)
    code = base64.b64encode(file.getvalue()).decode("ascii")
    return f"<br><img alt='The path of the hoop' src='data:image/png;base64,{code}'>"


def _short(sequence: str) -> str:
    return sequence if len(sequence) <= 24 else sequence[:23] + "…"
