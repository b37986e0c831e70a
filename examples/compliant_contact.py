"""Figures of the page on compliant contact: its convergence to the rigid plane, and its landings.

Usage: python examples/compliant_contact.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from hophoop.article.compliant_figures import (
    Landing,
    draw_losses,
    energy_balance,
    finish_losses,
    landing,
    landing_against_restitution,
    landing_scenario,
    touch_scenario,
    with_contact,
)
from hophoop.kernel.numerics.elementwise import arccosine, sine_and_cosine
from hophoop.kernel.physics.compliant import KELVIN_VOIGT, Compliance, FrictionLaw, normal_force
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impact import impulse_ratio, slip_rates
from hophoop.plots.style import finish
from hophoop.results.records import EventRecord
from hophoop.scenario import Hoop, Plane, Scenario, Start
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


def main(folder: Path) -> None:
    """Draw all figures and print their numbers."""
    folder.mkdir(parents=True, exist_ok=True)
    k = STIFFNESSES

    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.6), layout="constrained", sharey=True)
    for ax, title, contact in (
        (axes[0], "slip speed 1/k (default)", {}),
        (axes[1], "slip speed fixed at 10⁻⁴ √(g R)", {"slip_speed": 1e-4}),
    ):
        errors = convergence(k, **contact)
        error_lines(errors, k, ax)
        ax.set_title(title, fontsize="medium")
        for name, values in errors.items():
            print(title, name, " ".join(f"{value:.1e}" for value in values))
    axes[1].set_ylabel("")
    keep(figure, folder / "compliant-convergence.svg")

    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.2), layout="constrained")
    matched = matched_landings()
    lines = {f"e = {e}, c = {number:.3f} √(k m)": errors for e, (number, errors) in matched.items()}
    error_lines(lines, k, axes[0])
    axes[0].set_title("landing at v₀ = 3.1 m/s, damping matched to e", fontsize="medium")
    paradox = {
        "inconsistent": painleve_errors(0.0, "flight"),
        "indeterminate, impact": painleve_errors(5.0, "impact"),
        "inconsistent, Hunt–Crossley": painleve_errors(0.0, "flight", law="hunt-crossley"),
    }
    error_lines(paradox, k, axes[1])
    axes[1].set_title("slip in Painlevé's region", fontsize="medium")
    for name, values in {**lines, **paradox}.items():
        print(name, " ".join(f"{value:.1e}" for value in values))
    keep(figure, folder / "compliant-landing-order.svg")

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


def impact_restitution(hoop: Hoop, plane: Plane, touch: EventRecord, number: float, law: str) -> float:
    """Energetic restitution √(work of restitution / work of compression) of one landing on an infinitely stiff contact.

    The hoop does not move while the impulse grows, and the ratio of impulses is Coulomb's. So the landing follows Routh's
    line of impulses, and the normal law determines its end. `number` is c / √(k m), or d √(g R) in Hunt and Crossley's law.
    """
    speed = math.sqrt(plane.gravity * hoop.radius)
    kelvin = law == "kelvin-voigt"
    # in this limit only the product of time and √k matters: k = 1
    comp = Compliance(
        KELVIN_VOIGT if kelvin else 1 - KELVIN_VOIGT, int(FrictionLaw.LINEAR), 1.0,
        number if kelvin else 0.0, 0.0 if kelvin else number, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0,
    )  # fmt: skip
    body = Scenario(hoop=hoop, plane=plane).to_body()
    s, c = sine_and_cosine(touch.angle)
    arm, lever = contact_arms(body, s, c)
    y, vt, vn = 0.0, touch.before.slip / speed, touch.before.vy / speed
    compression = restitution = 0.0
    step = 0.002 / (1.0 + (number if kelvin else 0.0))
    while True:
        r, stuck = impulse_ratio(body, arm, lever, vt)
        _, drag, gain = slip_rates(body, arm, lever, r)
        length = step
        for _ in range(60):  # the midpoint rule, repeated if the slip or the contact ends in a step
            force = normal_force(comp, y, vn)[0]
            middle = vn + 0.5 * length * gain * force
            force = normal_force(comp, y + 0.5 * length * vn, middle)[0]
            rise, slid, after = y + length * middle, vt + length * drag * force, vn + length * gain * force
            share = 1.0
            if not stuck and slid * vt < -1e-14 * abs(vt):
                share = vt / (vt - slid)
            last = normal_force(comp, rise, after)[0]
            if compression > 0.0 and last < -1e-13 and after > 0.0:
                start = normal_force(comp, y, vn)[0]
                share = min(share, start / (start - last))
            if share == 1.0:
                break
            length *= share
        work = force * middle * length
        if middle < 0.0:
            compression -= work
        else:
            restitution += work
        y, vn, vt = rise, after, 0.0 if stuck or abs(slid) < 1e-10 else slid
        if vn > 0.0 and normal_force(comp, y, vn)[0] <= 1e-12:
            break
    return math.sqrt(restitution / compression)


def matched_number(hoop: Hoop, plane: Plane, touch: EventRecord, restitution: float, law: str) -> float:
    """The damping of a stiff contact that gives a landing this restitution: c / √(k m) or d √(g R)."""
    low, high = 0.0, 1.0
    while impact_restitution(hoop, plane, touch, high, law) > restitution:
        low, high = high, 2.0 * high
    for _ in range(24):
        middle = 0.5 * (low + high)
        if impact_restitution(hoop, plane, touch, middle, law) > restitution:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def matched_landings(
    restitutions: Sequence[float] = (0.2, 0.5, 0.8),
    stiffnesses: ArrayLike = STIFFNESSES,
    law: str = "kelvin-voigt",
) -> dict[float, tuple[float, Floats]]:
    """For each e of Stronge's law the matched damping, and the maximum difference of θ for each stiffness [rad].

    The hop at 3.1 m/s is compared until shortly before its second landing, whose angle gives another restitution.
    """
    result = {}
    for e in restitutions:
        rigid = landing_scenario(restitution=e)
        touch, again = simulate(rigid).find("impact")[:2]
        rigid = rigid.model_copy(update={"duration": touch.t + 0.9 * (again.t - touch.t)})
        hoop, plane = rigid.hoop, rigid.plane
        number = matched_number(hoop, plane, touch, e, law)
        speed = math.sqrt(plane.gravity * hoop.radius)
        errors = []
        for k in np.asarray(stiffnesses, dtype=float):
            stiffness = k * hoop.mass * plane.gravity / hoop.radius
            damping = number * math.sqrt(stiffness * hoop.mass) if law == "kelvin-voigt" else number / speed
            errors.append(angle_error(rigid, with_contact(rigid, k, damping=damping, law=law)))
        result[e] = (number, np.array(errors))
    return result


def painleve_scenario(omega: float = 0.0, duration: float = 0.4, painleve: str = "flight") -> Scenario:
    """The reference hoop sliding ahead at 1 m/s on its rim at θ = −41.4°, where cos θ = γ, with μ = 1.

    Its slip is in Painlevé's region: no contact force is consistent (`omega` = 0 rad/s), or several motions are possible
    (`omega` = 5 rad/s, indeterminate).
    """
    start = Start(angle=-arccosine(0.75), vx=1.0 + omega, omega=omega)
    return Scenario(plane=Plane(painleve=painleve), start=start, duration=duration)


def painleve_errors(omega: float, painleve: str, stiffnesses: ArrayLike = STIFFNESSES, **contact: Any) -> Floats:
    """Errors of compliant motions in Painlevé's region relative to the rigid one [rad]."""
    rigid = painleve_scenario(omega, painleve=painleve)
    ladder = np.asarray(stiffnesses, dtype=float)
    return np.array([angle_error(rigid, with_contact(rigid, k, **contact)) for k in ladder])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parent.parent / "docs" / "figures")
    main(parser.parse_args().folder)
