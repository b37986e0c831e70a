"""Impacts under three laws of restitution: step by step along the impulse, what is lost, and what Newton's law creates.

A block-like body (ε = 1/2, κ = 0.39, sin θ = −4/5) strikes at v = (−1, −3) m/s and (−8, −3) m/s: its slip stops in
compression, in restitution, or reverses, and everything can be worked by hand (tests/rigid/test_impacts.py does).
"""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

BODY = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.39)
ANGLE = math.atan2(-0.8, 0.6)
ARTICLE = hh.Hoop.ideal(0.75)
LAWS = {
    "newton": ("Newton", colors.SERIES[2], "--", "s"),
    "poisson": ("Poisson", colors.SERIES[1], "-.", "^"),
    "stronge": ("Stronge", colors.BLACK, "-", "o"),
}
CASES = (
    ("slip stops in compression, then it sticks", 0.5, -1.0),
    ("slip stops in restitution, then it sticks", 0.5, -8.0),
    ("slip stops in compression and reverses", 0.125, -1.0),
)


def strike(
    law: str, restitution: float, mu: float, vx: float = -1.0, vy: float = -3.0,
    hoop: hh.Hoop = BODY, angle: float = ANGLE, omega: float = 0.0,
) -> hh.trajectory.EventRecord:  # fmt: skip
    """The impact."""
    plane = hh.Plane(mu=mu, restitution=restitution, impact_law=law)
    start = hh.Start(angle=angle, vx=vx, vy=vy, omega=omega)
    return hh.simulate(hoop, plane, start, duration=1e-6, contact=hh.Rigid(max_events=12)).find("impact")[0]


def response(hoop: hh.Hoop, angle: float) -> np.ndarray:
    """W of the contact point for m = R = 1, by the lever arms."""
    height, arm = 1 + hoop.eccentricity * math.cos(angle), hoop.eccentricity * math.sin(angle)
    levers = np.array([-height, arm])
    return np.eye(2) + np.outer(levers, levers) / hoop.inertia_ratio


def small_steps(mu: float, vt: float, vn: float, total: float, steps: int = 6_000) -> np.ndarray:
    """(p, v_t, v_n) by Coulomb's law applied to that many small normal impulses, one after another."""
    matrix = response(BODY, ANGLE)
    step = total / steps
    out = np.empty((steps + 1, 3))
    out[0] = 0.0, vt, vn
    for k in range(steps):
        # what would stop the slip within the step is what friction gives, up to its limit
        wanted = -(vt / step + matrix[0, 1]) / matrix[0, 0]
        ratio = min(max(wanted, -mu), mu)
        vt += step * (matrix[0, 1] + matrix[0, 0] * ratio)
        vn += step * (matrix[1, 1] + matrix[0, 1] * ratio)
        out[k + 1] = (k + 1) * step, vt, vn
    return out


def along_the_impulse(folder: Path) -> None:
    """Both velocities against the impulse, in small steps, and the ends that the program finds for e = 1."""
    figure, axes = plt.subplots(1, 3, figsize=(10.0, 4.1), layout="constrained")
    for ax, (title, mu, vx) in zip(axes, CASES, strict=True):
        ends = {law: strike(law, 1.0, mu, vx) for law in LAWS}
        path = small_steps(mu, vx, -3.0, 1.02 * max(end.impulse_normal for end in ends.values()))
        compression = strike("stronge", 0.0, mu, vx).impulse_normal
        ax.axvspan(0.0, compression, color=colors.LIGHT_GRAY, alpha=0.5, lw=0)
        ax.text(0.5 * compression, 3.35, "compression", ha="center", fontsize=9, color=colors.GRAY)
        ax.plot(path[:, 0], path[:, 1], color=colors.SERIES[3], lw=1.8, ls="--", label="slip velocity $v_t$")
        ax.plot(path[:, 0], path[:, 2], color=colors.SERIES[4], lw=1.8, label="separation $v_n$")
        for law, (name, color, _, mark) in LAWS.items():
            end = ends[law]
            ax.plot([end.impulse_normal] * 2, [end.slip, end.vy], mark, color=color, ms=6, label=f"{name}, e = 1")
        ax.axhline(0.0, color="black", lw=0.6)
        ax.set_title(f"μ = {mu:g}, $v_t$ = −{-vx:g} m/s:\n{title}", fontsize=9)
        ax.set_xlabel("Normal impulse (N s)")
        ax.set_ylim(min(-3.4, vx * 1.06), 3.9)
        ax.grid(alpha=0.15)
    axes[0].set_ylabel("Velocity of the contact point (m/s)")
    axes[0].legend(frameon=False, fontsize=9, loc="lower right")
    save(figure, folder / "impact-impulse.svg")


def against_restitution(folder: Path) -> None:
    """Separation and loss against e under the three laws."""
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 4.0), layout="constrained")
    grid = np.linspace(0.0, 1.0, 81)
    for law, (name, color, dashes, _) in LAWS.items():
        for mu, width in ((0.5, 2.0), (0.125, 1.0)):
            impacts = [strike(law, float(e), mu) for e in grid]
            lost = [impact.impact_normal + impact.impact_tangential for impact in impacts]
            axes[0].plot(grid, [impact.vy for impact in impacts], dashes, color=color, lw=width, label=f"{name}, μ = {mu:g}")
            axes[1].plot(grid, lost, dashes, color=color, lw=width)
    axes[0].set_ylabel("Velocity of separation (m/s)")
    axes[1].set_ylabel("Energy lost in the impact (J)")
    axes[1].axhline(0.0, color=colors.GRAY, lw=0.8)
    axes[1].annotate(
        "below zero Newton's law\ncreates energy (Kane)", (0.95, -0.4), (0.25, -0.65), fontsize=9,
        arrowprops={"arrowstyle": "-", "color": colors.GRAY},
    )  # fmt: skip
    axes[0].legend(frameon=False, fontsize=9)
    for ax in axes:
        ax.set_xlabel("Restitution e")
        ax.grid(alpha=0.15)
    save(figure, folder / "impact-laws.svg")


def gains(folder: Path) -> None:
    """Kane's gain of the article's hoop: angle and direction of the blow, beside the energy of the blow."""
    angles = np.radians(np.linspace(-180.0, 180.0, 121))
    ratios = np.linspace(-2.5, 2.5, 101)  # v_t over the speed of approach
    figure, axes = plt.subplots(1, 2, figsize=(10.4, 4.2), layout="constrained", sharey=True)
    for ax, restitution in zip(axes, (0.8, 1.0), strict=True):
        shares = np.empty((ratios.size, angles.size))
        for j, angle in enumerate(angles):
            matrix = response(ARTICLE, float(angle))
            for i, ratio in enumerate(ratios):
                v = np.array([ratio, -1.0])
                push = np.linalg.solve(matrix, v)  # gives the contact point this velocity at the least energy
                arm, height = 0.75 * math.sin(angle), 0.75 * math.cos(angle)
                omega = (arm * push[1] - (1 + height) * push[0]) / ARTICLE.inertia_ratio
                motion_of_center = push[0] - height * omega, push[1] + arm * omega
                impact = strike("newton", restitution, 1.0, *motion_of_center, ARTICLE, float(angle), omega)
                shares[i, j] = -(impact.impact_normal + impact.impact_tangential) / (0.5 * push @ v)
        mesh = ax.pcolormesh(
            np.degrees(angles), ratios, np.where(shares > 1e-12, 100 * shares, np.nan), cmap="viridis", vmin=0.0, vmax=75.0,
            shading="nearest", rasterized=True,
        )  # fmt: skip
        ax.set_title(f"e = {restitution:g}", fontsize="medium")
        ax.set_xlabel("Angle of the load θ (°)")
        ax.set_xticks(range(-180, 181, 60))
    axes[0].set_ylabel("Slip over speed of approach")
    figure.colorbar(mesh, ax=axes, label="Energy created, of the blow's (%)")
    figure.savefig(folder / "kane-gain.svg", dpi=160, metadata={"Date": None})
    plt.close(figure)


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def draw(folder: Path) -> None:
    """Draw all figures."""
    along_the_impulse(folder)
    against_restitution(folder)
    gains(folder)
