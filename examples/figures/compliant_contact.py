"""Figures of the page on compliant contact: its convergence to the rigid plane, and its landings."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from hophoop.article.compliant_figures import (
    Landing,
    energy_balance,
    finish_losses,
    landing,
    landing_against_restitution,
    touch_scenario,
)
from hophoop.plots.style import finish
from hophoop.scenario import Compliant, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary import colors

Floats = NDArray[np.float64]

# The article's runs: speed at the top [m/s], friction, and a duration with their first cycles [s].
RUNS: dict[str, tuple[float, float, float]] = {
    "v₀ = 0.1 m/s": (0.1, 1.0, 4.0),
    "v₀ = 2 m/s": (2.0, 1.0, 3.0),
    "v₀ = 2.8 m/s": (2.8, 1.0, 3.0),
    "v₀ = 3.1 m/s, to the landing": (3.1, 1.0, 1.8),
    "v₀ = 3.1 m/s, beyond it": (3.1, 1.0, 2.0),
    "v₀ = 0.1 m/s, μ = 0.3": (0.1, 0.3, 6.0),
}
# over m g / R
STIFFNESSES: Floats = 10.0 ** np.arange(3.0, 10.5, 0.5)
MARKS = "osD^vPX"
STIFFNESS_LABEL = "Stiffness $k$ over $mg/R$"


def draw(folder: Path) -> None:
    """Draw all figures."""
    k = STIFFNESSES

    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.6), layout="constrained", sharey=True)
    for ax, title, contact in (
        (axes[0], "slip speed 1/k (default)", {}),
        (axes[1], "slip speed fixed at 10⁻⁴ √(g R)", {"slip_speed": 1e-4}),
    ):
        errors = convergence(k, **contact)
        error_lines(errors, k, ax)
        ax.set_title(title, fontsize="medium")
    axes[1].set_ylabel("")
    keep(figure, folder / "compliant-convergence.svg")

    figure, axes = plt.subplots(1, 3, figsize=(10.0, 4.2), layout="constrained")
    landing_against_stiffness(10.0 ** np.arange(1.0, 10.5, 0.5), axes[0])
    landing_against_slip_speed(10.0 ** np.arange(-8.0, 0.25, 0.25), axes[1])
    landing_against_restitution(np.linspace(0.0, 1.0, 11), axes[2])
    keep(figure, folder / "compliant-landing.svg")

    draw_energy(folder)


def draw_energy(folder: Path) -> None:
    """Energies of both models, narrow enough for their text to be read."""
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 4.4), layout="constrained", sharey=True)
    energy_balance(*axes)
    for ax in axes:
        title = ax.get_title(loc="left")
        ax.set_title(title, loc="left", pad=26, fontsize=12)  # above the marks of events
        for words in ax.get_legend().get_texts():
            words.set_fontsize(9)
    keep(figure, folder / "compliant-energy.svg")


def keep(figure: Figure, path: Path) -> None:
    """Save a figure without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def error_lines(
    errors: dict[str, Any],
    stiffnesses: ArrayLike,
    ax: Axes,
    fit_from: float = 1e5,
    fit_to: float = 1e9,
) -> Axes:
    """Plot the maximum difference of θ against stiffness, one line per motion, with the order fitted in a range."""
    k = np.asarray(stiffnesses, dtype=float)
    inside = (k >= fit_from * 0.99) & (k <= fit_to * 1.01)
    for index, (name, values) in enumerate(errors.items()):
        values = np.asarray(values)
        label = f"{name}: order {order(k[inside], values[inside]):.2f}"
        ax.loglog(k, values, marker=MARKS[index], ms=4, lw=1.2, color=colors.SERIES[index], label=label)
    finish(ax, STIFFNESS_LABEL, "Largest difference of θ (rad)")
    return ax


def landing_against_stiffness(stiffnesses: ArrayLike, ax: Axes) -> Axes:
    """Plot the energy lost by the landing at v₀ = 3.1 m/s against stiffness (e = 0), with that of the rigid plane."""
    k = np.asarray(stiffnesses, dtype=float)
    soft = [landing(simulate(with_contact(touch_scenario(), value))) for value in k]
    draw_losses(ax, k, soft)
    rigid_lines(ax, landing(simulate(touch_scenario())))
    ax.set_xscale("log")
    finish_losses(ax, STIFFNESS_LABEL)
    return ax


def landing_against_slip_speed(slip_speeds: ArrayLike, ax: Axes, stiffness: float = 1e8) -> Axes:
    """Plot the same against the slip speed: a creeping friction law, and a bristle as stiff as the normal spring."""
    speeds = np.asarray(slip_speeds, dtype=float)
    one = touch_scenario()
    for friction in ("tanh", "bristle"):
        soft = [landing(simulate(with_contact(one, stiffness, speed, friction=friction))) for speed in speeds]
        draw_losses(ax, speeds, soft, line="-" if friction == "tanh" else ":", what=friction)
    rigid_lines(ax, landing(simulate(touch_scenario())))
    ax.set_xscale("log")
    finish_losses(ax, r"Slip speed $v_s$ over $\sqrt{gR}$")
    return ax


def with_contact(scenario: Scenario, stiffness: float, slip_speed: float | None = None, **others: Any) -> Scenario:
    """A scenario with compliant contact: stiffness over m g / R, slip speed over √(g R); others as in `Compliant`."""
    hoop, gravity = scenario.hoop, scenario.plane.gravity
    if slip_speed is not None:
        others["slip_speed"] = slip_speed * math.sqrt(gravity * hoop.radius)
    return scenario.replace("contact", Compliant(stiffness=stiffness * hoop.mass * gravity / hoop.radius, **others))


def draw_losses(ax: Axes, at: Any, landings: list[Landing], line: str = "-", what: str = "compliant") -> None:
    """Plot both losses of some landings against a quantity."""
    face = "white" if line == ":" else None
    for mark, color, part in (("o", colors.IMPACT_LOSS, "normal"), ("s", colors.FRICTION_LOSS, "friction")):
        lost = [one.normal if part == "normal" else one.tangential for one in landings]
        ax.plot(at, lost, line + mark, color=color, ms=4, lw=1.0, label=f"{what}, {part}", markerfacecolor=face)


def rigid_lines(ax: Axes, rigid: Landing) -> None:
    for color, part in ((colors.IMPACT_LOSS, "normal"), (colors.FRICTION_LOSS, "friction")):
        ax.axhline(rigid.normal if part == "normal" else rigid.tangential, color=color, ls="--", lw=1.0, label=f"rigid, {part}")


def article_run(name: str) -> Scenario:
    """One of `RUNS` with rigid contact."""
    speed, mu, duration = RUNS[name]
    return Scenario(plane=Plane(mu=mu), start=Start.rolling(speed), duration=duration)


def angle_error(scenario: Scenario, compliant: Scenario, times: int = 400) -> float:
    """The maximum difference of θ between a rigid and a compliant motion of equal duration [rad]."""
    rigid, soft = simulate(scenario), simulate(compliant)
    t = np.linspace(0.0, min(rigid.duration, soft.duration), times)
    return float(np.max(np.abs(soft.at(t).angle - rigid.at(t).angle)))


def convergence(stiffnesses: ArrayLike = STIFFNESSES, **contact: Any) -> dict[str, Floats]:
    """For each run and stiffness, over m g / R, the maximum difference of θ [rad]; further arguments as in `with_contact`."""
    ladder = np.asarray(stiffnesses, dtype=float)
    result = {}
    for name in RUNS:
        rigid = article_run(name)
        result[name] = np.array([angle_error(rigid, with_contact(rigid, k, **contact)) for k in ladder])
    return result


def order(stiffnesses: ArrayLike, errors: ArrayLike) -> float:
    """The order of convergence, minus the slope of the logarithms."""
    return float(-np.polyfit(np.log(np.asarray(stiffnesses)), np.log(np.asarray(errors)), 1)[0])
