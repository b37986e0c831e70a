"""What becomes of a hoop in the end: return maps, the diagram over the slope, branches of gaits, and slip that dies away.

Usage: python examples/in_the_end.py [FOLDER]      (default: docs/figures; about two minutes)
       python examples/in_the_end.py --runaway     (the slopes from which fast motion grows; about six minutes)
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP = hh.Hoop.ideal(0.75)
SLOPES = (0.5, 1.0, 1.15, 2.0, 4.0, 10.0)  # degrees

FALL = 3.5  # height of the centre of gravity from which a fall is followed [R]; above 2, where the rim reaches the plane
BATCHES = 50


def on_slope(degrees: float, hoop: hh.Hoop = HOOP, **plane: float) -> hh.Scenario:
    """A hoop on a slope, in units of R, m and g."""
    return hh.Scenario(hoop=hoop, plane=hh.Plane(slope=math.radians(degrees), gravity=1.0, **plane))


def return_maps(folder: Path) -> None:
    """Return maps of the reference hoop at six slopes, each with the motion that it settles on."""
    figure, grid = plt.subplots(2, 3, figsize=(9.6, 6.6), layout="constrained", sharex=True, sharey=True)
    for ax, degrees in zip(grid.flat, SLOPES, strict=True):
        found = hh.gaits.return_map(on_slope(degrees), 3.0, 3.6)
        hh.plots.return_map(found, ax, start=3.4, passages=80, skip=0 if degrees == 10.0 else 300)
        ax.set_title(f"{degrees:g}°", fontsize=10)
        ax.set_ylim(2.9, 3.8)
        ax.set_xlim(3.0, 3.6)
        ax.get_legend().remove()
        ax.set_xlabel("")
        ax.set_ylabel("")
        print(degrees, found)
    figure.supxlabel(r"$\dot\theta$ at the bottom ($\sqrt{g/R}$)", fontsize=10)
    figure.supylabel(r"$\dot\theta$ one passage later ($\sqrt{g/R}$)", fontsize=10)
    handles, names = grid[0, 1].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=2, frameon=False, fontsize=10)
    save(figure, folder / "gaits-maps.svg")


def diagram(folder: Path) -> None:
    """On what the reference hoop settles, from 0 to 20°."""
    slopes = np.radians(np.linspace(0.02, 20.0, 1000))
    found = hh.gaits.diagram(on_slope(1.0), "plane.slope", slopes)
    ax = hh.plots.diagram(found)
    ax.set_ylabel(r"$\dot\theta$ at the bottom ($\sqrt{g/R}$)")
    ax.figure.savefig(folder / "gaits-diagram.png", dpi=160, metadata={"Software": None})
    plt.close(ax.figure)


def branches(folder: Path) -> None:
    """The branch of gaits of period 1, that of period 2 born on it, and their special points."""
    first = hh.gaits.find(on_slope(1.0), near=3.408)[0].follow("plane.slope", (math.radians(0.3), math.radians(1.5)))
    corner = next(one for one in first.special if one.kind == "border collision" and abs(np.diff(one.multipliers)[0]) > 0.5)
    second = corner.switch().follow("plane.slope", (math.radians(1.02), math.radians(1.5)))
    doubling = next(one for one in second.special if one.kind == "period doubling")
    fourth = doubling.switch().follow("plane.slope", (math.radians(1.19), math.radians(1.3)))
    steep = next(gait for gait in hh.gaits.find(on_slope(15.2), 2, near=3.14) if gait.stable)
    steep_branch = steep.follow("plane.slope", (math.radians(15.0), math.radians(16.5)))
    for branch in (first, second, fourth, steep_branch):
        print(branch)
        for one in branch.special:
            factors = " → ".join(f"{factor:.6f}" for factor in one.multipliers)
            print(f"| {math.degrees(one.parameter):.9f}° | {one.kind} | {one.event} | {one.omega:.12f} | {factors} |")
    ax = hh.plots.branch([first, second])
    ax.set_xlim(0.7, 1.4)
    ax.set_ylim(3.37, 3.48)
    ax.set_ylabel(r"$\dot\theta$ at the bottom ($\sqrt{g/R}$)")
    save(ax.figure, folder / "gaits-branch.svg")


def gears() -> None:
    """All gaits of one hop of a light load on 3°."""
    for gait in hh.gaits.find(on_slope(3.0, hh.Hoop.ideal(0.15)), fastest=18.0):
        if gait.hops == 1:
            print(
                f"| {gait.revolutions} | {gait.speed:.6f} | {gait.hop_height:.5f} | {gait.multipliers[0].real:+.6f} "
                f"| {'yes' if gait.stable else 'no'} |"
            )


def slip(folder: Path) -> None:
    """How slip dies away on the level, next to the derived law."""
    plane = hh.Plane(gravity=1.0)
    decay = hh.theory.slip_decay(HOOP, plane)
    figure, ax = plt.subplots(figsize=(7.2, 3.8), layout="constrained")
    for first, color in ((0.3, colors.SERIES[0]), (0.03, colors.SERIES[1]), (0.003, colors.SERIES[2])):
        start = hh.Start.rolling(decay.omega + first, angle=math.pi)
        found = hh.passages(hh.Scenario(hoop=HOOP, plane=plane, start=start), 10_000)
        number = np.arange(1, len(found) + 1)
        shown = np.unique(np.geomspace(1, len(found), 40).astype(int)) - 1
        ax.loglog(number[shown], found.omega[shown] - decay.omega, "o", ms=4, color=color, label=f"from {first:g}")
        ax.loglog(number, first / (1 + first * decay.rate * number), color=color, linewidth=1.0)
        print(first, found.omega[-1] - decay.omega, decay.excess(first, len(found)))
    ax.set_xlabel("Revolutions")
    ax.set_ylabel(r"$\dot\theta$ above the first slip ($\sqrt{g/R}$)")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    save(figure, folder / "gaits-slip.svg")


def real_hoop() -> None:
    """The hoop of 30 cm that hops for ever: its gait, its range of slopes, and how it depends on slope and friction."""
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.5, radius=0.3), plane=hh.Plane(slope=math.radians(3)))
    gait = hh.gaits.find(scenario, near=15.8)[0]
    print(gait, f"hop {100 * gait.hop_height:.3f} cm, {gait.time:.4f} s, {gait.distance:.4f} m")
    for path, step in (("plane.slope", math.radians(0.1)), ("plane.mu", 0.01), ("hoop.load_fraction", 0.01)):
        value = 0.5 if path.startswith("hoop") else {"plane.slope": math.radians(3), "plane.mu": 1.0}[path]
        found = []
        for sign in (1, -1):
            changed = scenario.replace(path, value + sign * step)
            found.append(hh.gaits.find(changed, near=gait.state.omega)[0])
        print(path, "hop changes by", 1e3 * (found[0].hop_height - found[1].hop_height) / 2, "mm per", step)
    branch = gait.follow("plane.slope", (math.radians(0.3), math.radians(5)))
    for one in branch.special:
        print(f"{math.degrees(one.parameter):.6f}° {one.kind} {one.event} {one.multipliers}")


# Fast motion down a slope, as in docs/gaits.md: a flight, and then a contact without gravity, from a random angle.


def passage(hoop: hh.Hoop, slope: float, bare: hh.Plane, velocities: np.ndarray, angle: float) -> np.ndarray:
    """Velocities with which the hoop leaves the plane next, from those of a take-off: ẋ, ẏ of the centre of gravity, and θ̇.

    `bare` is the plane without gravity, and the angle that at which the centre of gravity falls past the height FALL; R is 1.
    """
    eps = hoop.eccentricity
    along, away, omega = velocities
    along, away = along + 2.0 * away * math.tan(slope), -away
    height = min(FALL, 1.0 + eps + abs(away))  # the rim reaches the plane below 1 + ε
    if height < FALL:
        angle = math.remainder(angle + omega * (FALL - height) / abs(away), 2.0 * math.pi)
    start = hh.Start(
        height=height - eps * math.cos(angle) - 1.0,
        angle=angle,
        vx=along - eps * omega * math.cos(angle),
        vy=away + eps * omega * math.sin(angle),
        omega=omega,
    )
    for duration in 50.0 * 10.0 ** np.arange(6):
        motion = hh.simulate(hh.Scenario(hoop=hoop, plane=bare, start=start, duration=float(duration)))
        if motion.status != "completed":
            break
        end = motion.events[-1]
        away = end.vy - eps * end.omega * math.sin(end.angle)
        if away > 0.0 and end.height + eps * math.cos(end.angle) > eps:  # nothing brings it back but gravity
            return np.array([end.vx + eps * end.omega * math.cos(end.angle), away, end.omega])
    raise ValueError(f"Fast motion on this plane ends with {motion.status}, so it has no growth.")


def growth(hoop: hh.Hoop, plane: hh.Plane, slope: float, flights: int, seed: int) -> tuple[float, float]:
    """Mean of the logarithm of speed over speed, a flight, and its standard error; gravity does not matter."""
    hoop = hh.Hoop(radius=1.0, mass=1.0, eccentricity=hoop.eccentricity, inertia_ratio=hoop.inertia_ratio)
    bare = hh.Plane.model_validate({**plane.model_dump(exclude={"mu"}), "slope": slope, "gravity": 0.0})
    weights = np.array([1.0, 1.0, hoop.inertia_ratio])
    velocities, settling = np.array([1.0, 0.3, 1.0]), flights // 50
    logarithms = []
    for angle in np.random.default_rng(seed).uniform(0.0, 2.0 * math.pi, flights + settling):
        found = passage(hoop, slope, bare, velocities, float(angle))
        speed = math.sqrt(weights @ found**2)
        logarithms.append(math.log(speed / math.sqrt(weights @ velocities**2)))
        velocities = found / speed
    batches = [batch.mean() for batch in np.array_split(logarithms[settling:], BATCHES)]
    return float(np.mean(logarithms[settling:])), float(np.std(batches, ddof=1) / math.sqrt(BATCHES))


def critical_slope(hoop: hh.Hoop, plane: hh.Plane, flights: int, seed: int) -> tuple[float, float]:
    """The slope from which fast motion grows, and its standard error [rad]: the root of a parabola through eight rates."""
    low, high, middle = 0.0, 0.5 * math.pi, 0.25 * math.pi * hoop.eccentricity
    for _ in range(12):
        rate, error = growth(hoop, plane, middle, 2_000, seed)
        if abs(rate) < 2.0 * error:
            break
        low, high = (low, middle) if rate > 0.0 else (middle, high)
        middle = 0.5 * (low + high)
    away = 0.03 * middle * np.linspace(-1.0, 1.0, 8)
    rates, errors = np.transpose([growth(hoop, plane, middle + off, flights // 8, seed + 1 + k) for k, off in enumerate(away)])
    parabola, covariance = np.polyfit(away, rates, 2, w=1.0 / errors, cov="unscaled")
    scatter = float(np.sum(((rates - np.polyval(parabola, away)) / errors) ** 2)) / (len(away) - 3)
    root = float(min(np.roots(parabola), key=abs).real)
    powers = np.array([root * root, root, 1.0])
    error = math.sqrt(powers @ covariance @ powers * max(1.0, scatter)) / abs(np.polyval(np.polyder(parabola), root))
    return middle + root, error


def runaway() -> None:
    """The table of slopes from which the hoop runs away."""
    cases = [(gamma, hh.Plane()) for gamma in (0.05, 0.1, 0.25, 0.5, 0.75)]
    for gamma, plane in [*cases, (0.5, hh.Plane(mu=0.5)), (0.5, hh.Plane(restitution=0.5))]:
        found = [critical_slope(hh.Hoop.ideal(gamma), plane, 200_000, seed) for seed in (7, 23)]
        cells = " | ".join(f"{math.degrees(slope):.3f}° ± {math.degrees(error):.3f}°" for slope, error in found)
        print(f"| {gamma}, μ = {plane.mu_kinetic:g}, e = {plane.restitution:g} | {cells} |", flush=True)


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def main(folder: Path) -> None:
    """Draw the figures and print the numbers of the page."""
    folder.mkdir(parents=True, exist_ok=True)
    plt.rcParams["svg.hashsalt"] = "hophoop"
    return_maps(folder)
    branches(folder)
    gears()
    slip(folder)
    real_hoop()
    diagram(folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parent.parent / "docs" / "figures")
    parser.add_argument("--runaway", action="store_true")
    given = parser.parse_args()
    if given.runaway:
        runaway()
    else:
        main(given.folder)
