"""Figures of the model's page: the body with its forces, contact space, and the push that Painlevé's paradox comes from."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP, PLANE = hh.Hoop.ideal(0.75), hh.Plane(mu=1.0)
SPEED = 3.1  # at the top [m/s]
PANELS = (
    ("30°: the hoop rolls", 30.0, "roll"),
    ("240°: it would slip", 240.0, "spin"),
    ("−45° in a skid: no answer", -45.0, "skid"),
)


def contact_matrix(angle: float) -> np.ndarray:
    """W of the contact point [1/kg]; rows and columns tangential, normal."""
    eps, kappa = HOOP.eccentricity, HOOP.inertia_ratio
    arm = np.array([-(1.0 + eps * math.cos(angle)), eps * math.sin(angle)])
    return (np.eye(2) + np.outer(arm, arm) / kappa) / HOOP.mass


def free_acceleration(angle: float, omega: float) -> np.ndarray:
    """f of the contact point [m/s²]."""
    turn = HOOP.eccentricity * HOOP.radius * omega**2
    return np.array([turn * math.sin(angle), -PLANE.gravity + turn * math.cos(angle)])


def rolling_force(angle: float, omega: float) -> np.ndarray:
    """The force (F, N) that keeps the contact point at rest [N]."""
    return -np.linalg.solve(contact_matrix(angle), free_acceleration(angle, omega))


def contact_space(ax: Any, title: str, degrees: float, word: str) -> None:
    """Forces of the contact: the cone that friction allows, and where the contact point would not accelerate."""
    angle = math.radians(degrees)
    omega = 0.0 if degrees < 0 else float(hh.theory.rolling_speed(angle, HOOP, v0=SPEED))
    matrix, free = contact_matrix(angle), free_acceleration(angle, omega)
    size = 16.0
    ax.fill(
        [0, -size, size], [0, size, size], color=colors.mode_color("roll"), alpha=colors.SHADE, lw=0, label="cone: |F| ≤ μN"
    )
    across = np.array([-size, size])
    steep = abs(matrix[0, 1]) < 1e-12
    if not steep:
        ax.plot(across, (-free[0] - matrix[0, 0] * across) / matrix[0, 1], color=colors.GRAY, ls="--", label="$\\dot v_t = 0$")
    ax.plot(across, (-free[1] - matrix[0, 1] * across) / matrix[1, 1], color=colors.NORMAL_FORCE, label="$\\dot v_n = 0$")
    for sign in (-1, 1):
        ax.plot([0, sign * size], [0, size], color=colors.FRICTION_FORCE, lw=1)
    if word == "roll":
        ax.plot(*rolling_force(angle, omega), "o", color=colors.mode_color("roll"), ms=9, zorder=5)
        ax.annotate(
            "both: it rolls", rolling_force(angle, omega), (-14.5, 1.2), fontsize=9, arrowprops={"arrowstyle": "-", "lw": 0.6}
        )
    elif word == "spin":
        normal = -free[1] / (matrix[1, 1] + PLANE.mu_kinetic * matrix[0, 1])
        ax.plot(normal, normal, "o", color=colors.mode_color("spin"), ms=9, zorder=5)
        ax.annotate(
            "on the edge: it slips", (normal, normal), (-14.5, 1.2), fontsize=9, arrowprops={"arrowstyle": "-", "lw": 0.6}
        )
    else:
        ax.annotate("never meets\nthis edge", (-9.5, 9.5), (-15.5, 1.2), fontsize=9, arrowprops={"arrowstyle": "->", "lw": 0.6})
    ax.set(xlim=(-size, size), ylim=(0, size), xlabel="Friction $F$ (N)", aspect="equal")
    ax.set_title(title, fontsize=10, loc="left")


def draw_contact_space(path: Path) -> None:
    """Three states, three answers."""
    figure, axes = plt.subplots(1, 3, figsize=(10.0, 2.9), sharey=True, layout="constrained")
    for ax, panel in zip(axes, PANELS, strict=True):
        contact_space(ax, *panel)
    axes[0].set_ylabel("Normal force $N$ (N)")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncol=3, frameon=False, fontsize=9)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def draw_push(path: Path) -> None:
    """What a push does to the lowest point: lifted with G, pressed down by the rotation that friction brings."""
    angle = math.radians(-45.0)
    figure, ax = plt.subplots(figsize=(5.6, 3.6), layout="constrained")
    ax.add_patch(plt.Circle((0, 1), 1, fill=False, lw=4, color="#3A4654"))
    load = np.array([math.sin(angle), 1 + math.cos(angle)])
    ax.plot(*load, "o", color=colors.LOAD, ms=13)
    ax.plot(0.75 * load[0], 1 + 0.75 * (load[1] - 1), "o", color=colors.GRAVITY_CENTER, ms=8)
    ax.text(0.75 * load[0] + 0.1, 1 + 0.75 * (load[1] - 1), "G", color=colors.GRAVITY_CENTER, fontsize=12, va="center")
    ax.axhline(0, color="black", lw=1.2)
    arrow = {"arrowstyle": "-|>", "lw": 2.2, "mutation_scale": 16}
    ax.annotate("", (0, 0.75), (0, 0), arrowprops={**arrow, "color": colors.NORMAL_FORCE})
    ax.text(0.07, 0.55, "N", color=colors.NORMAL_FORCE, fontsize=13)
    ax.annotate("", (-0.75, 0.02), (0, 0.02), arrowprops={**arrow, "color": colors.FRICTION_FORCE})
    ax.text(-0.95, 0.08, "μN", color=colors.FRICTION_FORCE, fontsize=13)
    ax.annotate("", (1.75, 1.0), (1.15, 1.0), arrowprops={**arrow, "color": "black"})
    ax.text(1.8, 1.0, "slides ahead", va="center", fontsize=11)
    ax.annotate(
        "", (-1.02, 1.55), (-1.12, 0.75), arrowprops={**arrow, "color": colors.PURPLE, "connectionstyle": "arc3,rad=-0.25"}
    )
    ax.text(-1.25, 1.15, "friction\nturns it", ha="right", va="center", fontsize=11, color=colors.PURPLE)
    ax.annotate("", (0.35, -0.42), (0.35, 0.0), arrowprops={**arrow, "color": colors.PURPLE})
    ax.text(0.47, -0.28, "so this point goes down", fontsize=11, va="center", color=colors.PURPLE)
    ax.set(xlim=(-2.3, 3.0), ylim=(-0.55, 2.15), aspect="equal")
    ax.axis("off")
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def draw_body(path: Path) -> None:
    """Lengths, angle, velocities and forces."""
    ax = hh.plots.geometry(HOOP, angle=0.9)
    ax.figure.savefig(path, metadata={"Date": None})
    plt.close(ax.figure)


def draw(folder: Path) -> None:
    """All of them."""
    draw_body(folder / "model-body.svg")
    draw_contact_space(folder / "contact-space.svg")
    draw_push(folder / "painleve-push.svg")
