"""Figures of compliant contact compared with rigid contact, and the landing that they show."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from hophoop.article.scenarios import GRAVITY, scenarios
from hophoop.plots.motion import energies
from hophoop.plots.style import Axes, finish
from hophoop.scenario import Compliant, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors

SOFT = Compliant(stiffness=1e6 * GRAVITY)  # 10⁶ m g/R
LONGEST = 0.02  # of a landing [s]


def landing_against_restitution(restitutions: ArrayLike, ax: Axes) -> None:
    """Plot the energy lost in the landing against restitution: the rigid plane's three laws, and a compliant plane."""
    e = np.asarray(restitutions, dtype=float)
    for law, dashes in (("stronge", "-"), ("poisson", "--"), ("newton", ":")):
        rigid = [landing(simulate(touch_scenario(value, law))) for value in e]
        ax.plot(e, [one.normal for one in rigid], dashes, color=colors.IMPACT_LOSS, lw=1.2)
        ax.plot(e, [one.tangential for one in rigid], dashes, color=colors.FRICTION_LOSS, lw=1.2)
        ax.plot([], [], dashes, color=colors.BLACK, lw=1.2, label=f"rigid, {law.capitalize()}")
    soft = [landing(simulate(touch_scenario(value).replace("contact", SOFT))) for value in e]
    ax.plot(e, [one.normal for one in soft], "o", color=colors.IMPACT_LOSS, ms=4, label="compliant, normal")
    ax.plot(e, [one.tangential for one in soft], "s", color=colors.FRICTION_LOSS, ms=4, label="compliant, friction")
    finish_losses(ax, "Restitution $e$")


def energy_balance(ax_rigid: Axes, ax_soft: Axes) -> None:
    """Plot the article's energy balance at v₀ = 3.1 m/s in both models."""
    scenario = scenarios()["hop"].replace("duration", 2.0)
    for ax, one, title in (
        (ax_rigid, scenario, "rigid, $e$ = 0"),
        (ax_soft, scenario.replace("contact", SOFT), r"compliant, $k = 10^{6}\,mg/R$"),
    ):
        energies(simulate(one), "angle", ax=ax)
        ax.set_title(title, fontsize=11, loc="left", pad=24)  # space for the ribbon and its marks
        # two columns, half a page wide
        ax.legend(frameon=False, fontsize=8.5, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2, handlelength=2.8)
    ax_rigid.set_ylim(*ax_rigid.get_ylim())
    ax_soft.set_ylabel("")


def touch_scenario(restitution: float = 0.0, impact_law: str = "stronge") -> Scenario:
    """Return the article's hop from its landing on: a start at the plane with the velocities of the rigid hoop."""
    whole = scenarios()["hop"].with_values({"plane.restitution": restitution, "plane.impact_law": impact_law})
    touch = simulate(whole).find("impact")[0]
    start = Start(angle=touch.angle, vx=touch.before.vx, vy=touch.before.vy, omega=touch.before.omega)
    return whole.with_values({"start": start, "duration": 0.05})


class Landing(NamedTuple):
    """Energy lost in a landing."""

    normal: float  # in the normal direction [J]
    tangential: float  # along the plane [J]


def landing(motion: Trajectory) -> Landing:
    """Return the landing with which a motion starts; a compliant one ends with the lift-off."""
    if motion.scenario.contact.model == "rigid":
        touch = motion.find("impact")[0]
        return Landing(touch.impact_normal, touch.impact_tangential)
    after = motion.at(min([LONGEST, *(event.t for event in motion.find("takeoff"))]), side="left")
    return Landing(after.damping + after.spring, after.friction)  # the energy of the spring is lost after the lift-off


def finish_losses(ax: Axes, across: str) -> None:
    """Set limits and labels of a plot of losses."""
    low, high = min(0.0, ax.dataLim.ymin), max(0.1, ax.dataLim.ymax)
    # Newton's law can gain energy: show negative values
    ax.set_ylim(low - (0.06 * (high - low) if low < 0.0 else 0.0), high + 0.12 * (high - low))
    if low < 0.0:
        ax.axhline(0.0, color=colors.GRAY, lw=0.7, zorder=0)
    finish(ax, across, "Energy lost in the landing (J)")
