"""The massless hoop: it skims instead of hopping; and how hoops with ever lighter rims come to it.

Usage: python examples/massless_hoop.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

GRAVITY = 9.81
SPEED = 1.0  # of the centre at the top [m/s]
POWERS = range(1, 13)


def roll(gamma: float, mu: float, speed: float = SPEED, duration: float = 6.0, angle: float = 0.0) -> hh.Trajectory:
    """A rolling start."""
    start = hh.Start.rolling(speed, angle=angle)
    return hh.simulate(hh.Hoop.ideal(gamma), hh.Plane(mu=mu), start, duration=duration)


def losses() -> None:
    """Where and why the massless hoop loses its contact force, and when its load strikes the plane."""
    print("| $v_0$ (m/s) | μ | force gone at | θ̇ there (rad/s) | by | load strikes the plane | phases |")
    for speed, mu in ((0.001, 2.0), (0.01, 2.0), (0.1, 2.0), (1.0, 2.0), (3.0, 2.0), (3.2, 2.0), (0.1, 1.0), (0.1, 0.5)):
        motion = roll(1.0, mu, speed, 12.0)
        skim, strike = motion.find("skim")[0], motion.find("impact")[0]
        by = "friction" if hh.theory.massless_loss(speed, plane=hh.Plane(mu=mu)).by_friction else "N = 0"
        print(
            f"| {speed:g} | {mu:g} | {math.degrees(skim.angle):.7f}° | {skim.omega:.7f} | {by} "
            f"| {strike.t - skim.t:.6f} s later, at {math.degrees(strike.angle):.4f}° | {motion.sequence} |"
        )
    lost = roll(1.0, 2.0, 4.0, angle=math.radians(-80.0))
    print(f"Rolling at 4 m/s with the load at −80°, on its way up: {lost.status} after {lost.duration:g} s")


def skimming(folder: Path) -> None:
    """Path of the load, and the contact force, of the massless hoop and of two light rims."""
    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
    for gamma, color, dashes in ((0.9, colors.SERIES[1], "-."), (0.99, colors.SERIES[2], "--"), (1.0, colors.BLACK, "-")):
        motion = roll(gamma, 1.0)
        end = next((event.t for event in motion.events if event.angle >= math.pi - 1e-9), motion.duration)
        sample = motion.at(np.linspace(0.3, end * (1 - 1e-9), 4000))
        down = sample.angle <= math.pi
        label = "massless, γ = 1" if gamma == 1.0 else f"γ = {gamma:g}"
        x, y = sample.x + np.sin(sample.angle), 1 + np.cos(sample.angle) + sample.height
        axes[0].plot(x[down], y[down], dashes, color=color, label=label)
        axes[1].plot(np.degrees(sample.angle[down]), sample.normal_force[down], dashes, color=color, label=label)
    skim = roll(1.0, 1.0).find("skim")[0]
    axes[0].plot(skim.x + math.sin(skim.angle), 1 + math.cos(skim.angle), "o", color=colors.BLACK, ms=5)
    axes[0].annotate(
        f"the force is gone at {math.degrees(skim.angle):.2f}°:\nfree fall, the rim skims",
        (skim.x + math.sin(skim.angle), 1 + math.cos(skim.angle)), (1.2, 0.45), fontsize=9,
        arrowprops={"arrowstyle": "-", "color": colors.GRAY},
    )  # fmt: skip
    axes[0].set_xlabel("Place of the load (m)")
    axes[0].set_ylabel("Height of the load (m)")
    axes[0].set_aspect("equal")
    axes[1].set_xlabel("Rotation angle (°)")
    axes[1].set_ylabel("Normal force (N)")
    axes[1].set_xticks(range(0, 181, 30))
    axes[1].set_xlim(0.0, 182.0)
    axes[1].set_ylim(-1.0, 30.0)
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    save(figure, folder / "massless-skim.svg")


def limit(folder: Path) -> None:
    """First slip, stick, second slip and hop of γ = 1 − 10⁻ᵏ beside the massless loss of contact."""
    figure, axes = plt.subplots(1, 2, figsize=(10.1, 4.2), layout="constrained")
    cases = ((1.0, 1.0, "o", colors.SERIES[1]), (1.0, 5.0, "s", colors.SERIES[2]), (3.0, 1.0, "^", colors.BLACK))
    for speed, mu, mark, color in cases:
        massless = math.degrees(roll(1.0, mu, speed).find("skim")[0].angle)
        print(f"v0 = {speed:g} m/s, μ = {mu:g}: the massless hoop loses contact at {massless:.9f}°")
        print("| γ | first slip | later by | sticks at | slips again | takes off | phases, 3 s |")
        gaps, sticks, residuals = [], [], []
        for k in POWERS:
            motion = roll(1 - 10.0**-k, mu, speed, 3.0)
            slips, hops = motion.find("slip_start"), motion.find("takeoff")
            stick = math.degrees(motion.find("stick")[0].angle)
            gaps.append(math.degrees(slips[0].angle) - massless)
            sticks.append(180.0 - stick)
            residuals.append(abs(motion.ledger.residual) / motion.ledger.range)
            letters = motion.sequence
            print(
                f"| 1 − 10{power(-k)} | {math.degrees(slips[0].angle):.9f}° | {gaps[-1]:.1e}° | {stick:.5f}° "
                f"| {math.degrees(slips[1].angle):.5f}° | {f'{math.degrees(hops[0].angle):.4f}°' if hops else '–'} "
                f"| {letters if len(letters) <= 8 else letters[:8] + '…'} |"
            )
        print(f"ledger's residual over the range: {max(residuals[:5]):.0e} up to k = 5, {max(residuals):.0e} up to k = 12")
        label = f"$v_0$ = {speed:g} m/s, μ = {mu:g}"
        for ax, values in zip(axes, (gaps, sticks), strict=True):
            ax.semilogy(list(POWERS), values, mark, ms=5, color=color, label=label)
    axes[0].set_ylabel("First slip, after the massless\nloss of contact (°)")
    axes[1].set_ylabel("End of the first slip, before 180° (°)")
    for ax in axes:
        ax.set_xlabel("k, where γ = 1 − 10⁻ᵏ")
        ax.set_xticks(range(2, 13, 2))
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    save(figure, folder / "massless-limit.svg")


def beyond() -> None:
    """What the bottom takes: energy lost up to the end of the first slip, beside that of the load's travel along the plane."""
    print("| $v_0$ (m/s) | γ | lost (J) | travel (J) | θ̇ at the stick (rad/s) | highest load later (m) |")
    for speed in (1.0, 3.0):
        skim = roll(1.0, 1.0, speed).find("skim")[0]
        travel = 0.5 * (skim.omega * (1 + math.cos(skim.angle))) ** 2
        for k in (3, 6, 9, 12, None):
            motion = roll(1.0 if k is None else 1 - 10.0**-k, 1.0, speed, 3.0)
            if k is None:
                strike = motion.find("impact")[0]
                lost, rate, first = strike.impact_normal + strike.impact_tangential, math.nan, strike.t
            else:
                stick = motion.find("stick")[0]
                lost, rate, first = stick.friction, stick.omega, stick.t
            sample = motion.at(np.linspace(first, 3.0, 4000))
            top = float(np.max(1 + np.cos(sample.angle) + sample.height))
            name = "1" if k is None else f"1 − 10{power(-k)}"
            print(f"| {speed:g} | {name} | {lost:.6f} | {travel:.6f} | {'–' if k is None else f'{rate:.4g}'} | {top:.4f} |")


def hops(folder: Path) -> None:
    """Speeds at which ever lighter rims hop."""
    immediate = math.sqrt(GRAVITY)
    figure, ax = plt.subplots(figsize=(7.2, 4.0), layout="constrained")
    print("| γ | first slip (m/s) | first hop (m/s) | hop at once (m/s) | difference (m/s) |")
    for mu, mark, color in ((1.0, "o", colors.SERIES[1]), (5.0, "s", colors.SERIES[2])):
        windows = []
        for k in range(1, 10):
            speeds = hh.theory.critical_speeds(hh.Hoop.ideal(1 - 10.0**-k), hh.Plane(mu=mu))
            windows.append(speeds.immediate_hop - speeds.first_hop)
            if mu == 1.0:
                print(
                    f"| 1 − 10{power(-k)} | {speeds.first_slip:.6f} | {speeds.first_hop:.6f} | {speeds.immediate_hop:.6f} "
                    f"| {windows[-1]:.6f} |"
                )
        ax.semilogy(range(1, 10), windows, mark, ms=5, color=color, label=f"μ = {mu:g}")
        ratio = windows[-2] / windows[-1]
        print(f"μ = {mu:g}: from k = 8 to 9 the difference shrinks by {ratio:.3f}, and 10^(1/4) is {10**0.25:.3f}")
    print(f"√(gR) = {immediate:.6f} m/s")
    ax.set_xlabel("k, where γ = 1 − 10⁻ᵏ")
    ax.set_ylabel("Range of speeds with a later hop (m/s)")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    save(figure, folder / "massless-hops.svg")


def power(exponent: int) -> str:
    return str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def main(folder: Path) -> None:
    """Draw the figures and print the numbers of the page."""
    folder.mkdir(parents=True, exist_ok=True)
    plt.rcParams["svg.hashsalt"] = "hophoop"
    losses()
    skimming(folder)
    limit(folder)
    beyond()
    hops(folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parent.parent / "docs" / "figures")
    main(parser.parse_args().folder)
