"""The article's figures, redrawn from computed motions, and some more."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from hophoop import plots, theory
from hophoop._support.extras import need
from hophoop.article import compliant_figures as compliant
from hophoop.article.runs import LONG, Runs
from hophoop.article.scenarios import title
from hophoop.plots.style import finish
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary import colors, quantities

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
else:
    Axes = Figure = Any

WIDE = (7.2, 4.1)


@dataclass(frozen=True)
class ArticleFigure:
    """One figure: name of its files, section, caption, and drawing function."""

    name: str
    section: str
    caption: str
    draw: Callable[[Runs, Axes], Any]
    size: tuple[float, float] = WIDE
    ours: bool = False  # not in the article
    long: bool = False  # of a long motion, or in compliant contact: drawn last


def draw_figure(figure: ArticleFigure, runs: Runs) -> Figure:
    """Draw a figure outside of pyplot."""
    sheet: Figure = need("matplotlib.figure", "plots").Figure(figsize=figure.size, layout="constrained")
    figure.draw(runs, sheet.subplots())
    return sheet


def _geometry(runs: Runs, ax: Axes) -> None:
    plots.geometry(runs.hoop, ax=ax)


def _path(name: str) -> Callable[[Runs, Axes], Any]:
    return lambda runs, ax: plots.path(runs.motion(name), ax=ax)


def _first_swing(runs: Runs, ax: Axes) -> None:
    """Path to the first turning point and back to the next; later ones would cover it."""
    motion = runs.motion("low_friction")
    back = motion.find("turn")[1].t
    plots.path(simulate(motion.scenario.replace("duration", back)), ax=ax)


def _velocity(name: str, against: Any) -> Callable[[Runs, Axes], Any]:
    return lambda runs, ax: plots.velocities(runs.motion(name), against, ax=ax)


def _energy(name: str, against: Any) -> Callable[[Runs, Axes], Any]:
    return lambda runs, ax: plots.energies(runs.motion(name), against, ax=ax)


def _compared(plot: Callable[..., Any], *names: str, one_turn: bool = True) -> Callable[[Runs, Axes], Any]:
    """Draw a quantity of motions against the angle, up to 360° with `one_turn`; of several each with its title."""

    def draw(runs: Runs, ax: Axes) -> None:
        labels = [title(name) for name in names] if len(names) > 1 else None
        plot([runs.motion(name) for name in names], ax=ax, labels=labels)
        if one_turn:
            ax.set_xlim(0.0, 360.0)

    return draw


def _phase_plane(runs: Runs, ax: Axes) -> None:
    names = ("slow", "faster", "slipping", "hop", "low_friction")
    motions = [runs.motion(name) for name in names]
    # up to the turning point: the rocking has its own figure
    motions[-1] = simulate(motions[-1].scenario.replace("duration", motions[-1].find("turn")[0].t))
    plots.phase_plane(
        runs.hoop, runs.plane, motions, [title(name) for name in names], ax=ax,
        angles=(0.0, math.radians(540.0)), speeds=(0.0, 12.0),
    )  # fmt: skip


def _phase_plane_low(runs: Runs, ax: Axes) -> None:
    motion = runs.motion("low_friction")
    plots.phase_plane(motions=[motion], ax=ax, angles=(0.0, 2.0 * math.pi), speeds=(-8.0, 8.0))


def _slow_end(runs: Runs, ax: Axes) -> None:
    """Excess energy of the motion at 2.8 m/s over that at which slip would end."""
    motion = runs.long_slipping
    floor = (1.0 + runs.hoop.eccentricity) * float(theory.first_slip_speed(runs.hoop, runs.plane)) ** 2
    t = np.array([event.t for event in motion.find("stick")])
    excess = motion.at(t).total - floor
    ax.loglog(t, excess, ".", color=colors.TOTAL, ms=3, label="after each slip")
    law = excess[-1] * t[-1]
    late = t[t > 10.0]
    ax.loglog(late, law / late, color=colors.LIMIT, lw=1.4, ls=(0, (5, 2)), label=f"{law:.0f} J s / t")
    ax.set_xlim(0.5, LONG * 1.2)
    finish(ax, quantities.TIME, "Energy above rolling at the critical speed (J)")


PART1, PART2, PART3, PART4 = (
    "A First Attempt",
    "Increase the Speed",
    "Let's Hop!",
    "Revisiting Low Friction",
)


def _both_models(runs: Runs, ax: Axes) -> None:
    sheet = ax.figure
    ax.remove()
    compliant.energy_balance(*sheet.subplots(1, 2, sharey=True))


def _landing_restitution(runs: Runs, ax: Axes) -> None:
    compliant.landing_against_restitution(np.linspace(0.0, 0.9, 10), ax=ax)


FIGURES: tuple[ArticleFigure, ...] = (
    ArticleFigure(
        "geometry",
        "The Problem",
        "The hoop on the plane: load, centre of gravity G, rotation angle θ, contact forces N and F.",
        _geometry,
        (5.6, 3.6),
    ),
    ArticleFigure(
        "path_slow",
        PART1,
        "v₀ = 0.1 m/s: path of the load (a cycloid) and of the centre of gravity.",
        _path("slow"),
        (8.6, 3.2),
    ),
    ArticleFigure(
        "velocity_time_slow",
        PART1,
        "v₀ = 0.1 m/s: velocity against time. In rolling, centre and rotation are one curve.",
        _velocity("slow", "time"),
    ),
    ArticleFigure(
        "velocity_angle_slow",
        PART1,
        "v₀ = 0.1 m/s: velocity against the rotation angle.",
        _velocity("slow", "angle"),
    ),
    ArticleFigure(
        "energy_slow",
        PART1,
        "v₀ = 0.1 m/s: energies. The potential energy is a pure cosine.",
        _energy("slow", "angle"),
    ),
    ArticleFigure("forces_slow", PART1, "v₀ = 0.1 m/s: contact forces on the hoop.", _compared(plots.contact_forces, "slow")),
    ArticleFigure(
        "friction_slow", PART1, "v₀ = 0.1 m/s: share of the friction used.", _compared(plots.friction_utilization, "slow")
    ),
    ArticleFigure("path_faster", PART2, "v₀ = 2 m/s: two turns, rolling throughout.", _path("faster"), (8.6, 2.8)),
    ArticleFigure(
        "forces_faster",
        PART2,
        "Contact forces at v₀ = 2 m/s compared with those at 0.1 m/s.",
        _compared(plots.contact_forces, "slow", "faster"),
    ),
    ArticleFigure(
        "friction_faster",
        PART2,
        "Share of the friction used, v₀ = 0.1 and 2 m/s: a little more speed, and it slips.",
        _compared(plots.friction_utilization, "slow", "faster"),
    ),
    ArticleFigure("path_slipping", PART2, "v₀ = 2.8 m/s: rolling, skidding and spinning.", _path("slipping"), (8.6, 2.8)),
    ArticleFigure(
        "friction_slipping",
        PART2,
        "v₀ = 2.8 m/s: the friction used stays at −1 in skid and at 1 in spin.",
        _compared(plots.friction_utilization, "slipping", one_turn=False),
    ),
    ArticleFigure(
        "velocity_slipping",
        PART2,
        "v₀ = 2.8 m/s: centre and rotation part while the hoop slips.",
        _velocity("slipping", "angle"),
    ),
    ArticleFigure("energy_slipping", PART2, "v₀ = 2.8 m/s: energy balance.", _energy("slipping", "angle")),
    ArticleFigure(
        "slow_end_slipping",
        PART2,
        "v₀ = 2.8 m/s, followed for long: the energy above rolling at the critical speed, after each slip. It falls as 1/t, "
        "so the slip gets weaker and never ends.",
        _slow_end,
        ours=True,
        long=True,
    ),
    ArticleFigure(
        "path_hop",
        PART3,
        "v₀ = 3.1 m/s: the hop. The path of the centre of gravity is red while the hoop is airborne.",
        _path("hop"),
        (8.6, 3.2),
    ),
    ArticleFigure(
        "velocity_hop",
        PART3,
        "v₀ = 3.1 m/s: in flight the rotation is constant, the velocity of the centre is not.",
        _velocity("hop", "angle"),
    ),
    ArticleFigure(
        "energy_hop",
        PART3,
        "v₀ = 3.1 m/s: energy balance. The tangential loss of the landing is counted as friction.",
        _energy("hop", "angle"),
    ),
    ArticleFigure(
        "energy_hop_compliant",
        PART3,
        "v₀ = 3.1 m/s: the energy balance in both contact models. The landing costs the same in each: what the article "
        "calls significantly larger than friction's share is real, not an artefact of its contact. Counted as above.",
        _both_models,
        (9.5, 4.4),
        ours=True,
        long=True,
    ),
    ArticleFigure(
        "landing_restitution",
        PART3,
        "The landing at 3.1 m/s against restitution and its law: friction's share hardly depends on either, the "
        "normal share falls with e.",
        _landing_restitution,
        ours=True,
        long=True,
    ),
    ArticleFigure(
        "phase_plane",
        PART3,
        "The (θ, θ̇) plane for γ = 3/4, μ = 1: the mode after contact without slip, and the five motions in their modes' "
        "colours. The corner of the take-off is at the upper right of a revolution; a slipping hoop leaves the plane when "
        "it crosses the dashed line (▲ take-off, ▼ landing). The motion on μ = 0.3 is dashed, up to its turning point: "
        "it has other boundaries, shown below.",
        _phase_plane,
        (8.6, 5.6),
    ),
    ArticleFigure(
        "path_low_friction",
        PART4,
        "v₀ = 0.1 m/s on μ = 0.3: the hoop does not get over the top again and rolls back; its first swing.",
        _first_swing,
        (8.6, 3.2),
    ),
    ArticleFigure(
        "velocity_low_friction",
        PART4,
        "v₀ = 0.1 m/s on μ = 0.3: velocity against time.",
        _velocity("low_friction", "time"),
    ),
    ArticleFigure(
        "energy_low_friction",
        PART4,
        "v₀ = 0.1 m/s on μ = 0.3: energy balance against time.",
        _energy("low_friction", "time"),
    ),
    ArticleFigure(
        "phase_plane_low_friction",
        PART4,
        "The (θ, θ̇) plane for μ = 0.3: rolling is limited to a band, which the motion leaves again and again.",
        _phase_plane_low,
        (8.6, 5.2),
        ours=True,
    ),
)
