"""Endlessly many bounces in a finite time: the gap, the limit that closes the sequence, and how exact it is.

Usage: python examples/endless_bounces.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import matplotlib.pyplot as plt
import mpmath
import numpy as np

import hophoop as hh
from hophoop.plots import colors

ROOT = Path(__file__).parent.parent
HOOP = hh.Hoop.ideal(0.6)
START = hh.Start(height=0.1, angle=2.4, vx=0.5, omega=2.0)
DISK = hh.Hoop.from_parts(radius=0.5, parts=[hh.Disk(2.0, 0.5)])


def bounces(folder: Path) -> None:
    """The gap against time, and the time that each impact leaves to the limit."""
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    print("| e | impacts | limit (s) | then | slip there (m/s) | ledger's residual |")
    for restitution, color, mark in ((0.5, colors.SERIES[1], "o"), (0.8, colors.SERIES[2], "s"), (0.9, colors.BLACK, "^")):
        plane = hh.Plane(mu=0.3, restitution=restitution)
        motion = hh.simulate(HOOP, plane, START, duration=4.0)
        (limit,) = motion.find("bounce_limit")
        impacts = [event.t for event in motion.find("impact") if event.t < limit.t]
        times = np.sort(np.concatenate([np.linspace(0.0, 2.6, 4000), impacts]))
        label = f"e = {restitution:g}"
        axes[0].plot(times, 1e3 * motion.at(times).height, color=color, lw=1.2, label=label)
        axes[0].plot([limit.t], [0.0], mark, color=color, ms=6, mfc="white", clip_on=False, zorder=5)
        left = limit.t - np.array(impacts)
        axes[1].semilogy(np.arange(1, left.size + 1), left, mark, ms=2.5, color=color, label=label)
        print(
            f"| {restitution:g} | {len(impacts)} | {limit.t:.12f} | {limit.to_mode} | {limit.slip:.6f} "
            f"| {abs(motion.ledger.residual) / motion.ledger.range:.0e} |"
        )
    axes[0].set_xlabel("Time (s)")
    axes[0].set_ylabel("Gap between rim and plane (mm)")
    axes[0].set_xlim(0.0, 2.6)
    axes[0].set_ylim(0.0, 105.0)
    axes[1].set_xlabel("Impact")
    axes[1].set_ylabel("Time left to the limit (s)")
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False)
    figure.savefig(folder / "endless-bounces.svg", metadata={"Date": None})
    plt.close(figure)


def disk() -> None:
    """A disk bounces as a point does: the limit against the geometric series, to 40 digits."""
    print("| e | impacts | t∞ (s) | error of t∞ | worst of the impacts' times | of x | of θ̇ |")
    for restitution in (0.1, 0.5, 0.9, 0.99, 0.999):
        plane = hh.Plane(mu=0.0, restitution=restitution)
        with mpmath.workdps(40):
            e = mpmath.mpf(restitution)
            first = mpmath.sqrt(2 * mpmath.mpf(0.3) / mpmath.mpf(9.81))
            end = first * (1 + e) / (1 - e)
            start = hh.Start(height=0.3, vx=1.5, omega=2.0)
            motion = hh.simulate(DISK, plane, start, duration=float(end) + 1.0, contact=hh.Rigid(max_events=100_000))
            (limit,) = motion.find("bounce_limit")
            impacts = [event for event in motion.find("impact") if event.t < limit.t]
            worst = max(abs(event.t - (t := first * (1 + 2 * e * (1 - e**k) / (1 - e)))) / t for k, event in enumerate(impacts))
            errors = abs(limit.t - end) / end, worst, abs(limit.x - mpmath.mpf(1.5) * end) / (1.5 * end)
        numbers = " | ".join(f"{float(error):.0e}" for error in errors)
        print(f"| {restitution:g} | {len(impacts)} | {limit.t:.12f} | {numbers} | {abs(limit.omega - 2.0) / 2.0:.0e} |")


def friction() -> None:
    """A disk with spin: over all its bounces friction has the impulse m g t∞ to work with."""
    print("| μ | then | ẋ at the limit (m/s) | closed form | error |")
    e, spin = 0.6, 20.0
    with mpmath.workdps(40):
        end = mpmath.sqrt(2 * mpmath.mpf(0.3) / mpmath.mpf(9.81)) * (1 + mpmath.mpf(e)) / (1 - mpmath.mpf(e))
    for mu in (0.02, 0.1, 0.5):
        motion = hh.simulate(DISK, hh.Plane(mu=mu, restitution=e), hh.Start(height=0.3, omega=spin), duration=float(end) + 0.1)
        (limit,) = motion.find("bounce_limit")
        with mpmath.workdps(40):
            true = min(mpmath.mpf(mu) * mpmath.mpf(9.81) * end, mpmath.mpf(0.5) * spin / 3)
        print(f"| {mu:g} | {limit.to_mode} | {limit.vx:.12f} | {float(true):.12f} | {float(abs(limit.vx - true)):.0e} |")


def eccentric() -> None:
    """Reference motions of 25 digits: an eccentric hoop's hundreds of bounces and what comes after them."""
    print("| law | bounces | then | t∞ (s) | time | angle | θ̇ | x | later |")
    for law in ("newton", "poisson", "stronge"):
        data = json.loads((ROOT / "tests" / "data" / f"accumulation_{law}.json").read_text(encoding="utf-8"))
        case, events = data["case"], data["events"]
        names = ("radius", "mass", "eccentricity", "inertia_ratio")
        hoop = hh.Hoop(**{name: case[name] for name in names})
        names = ("gravity", "slope", "mu_static", "mu_kinetic", "restitution", "impact_law", "painleve")
        start = hh.Start(**{name: case[name] for name in ("x", "height", "angle", "vx", "vy", "omega")})
        motion = hh.simulate(hoop, hh.Plane(**{name: case[name] for name in names}), start, duration=case["duration"])
        (limit,) = motion.find("bounce_limit")
        after = [event for event in motion.events if event.t >= limit.t and event.kind != "turn"]
        last = next(k for k, event in enumerate(events) if event["from"] == "H" and event["to"] != "H")
        true = [event for event in events[last:] if event["kind"] != "turn"]
        assert [event.to_mode for event in after][:-1] == [event["to"] for event in true][:-1]

        def error(event: hh.trajectory.EventRecord, reference: dict[str, str], name: str) -> float:
            exact = mpmath.mpf(reference[name])
            return float(abs((getattr(event, name) - exact) / exact))

        with mpmath.workdps(40):
            names = ("t", "angle", "omega", "x")
            here = " | ".join(f"{error(limit, true[0], name):.0e}" for name in names)
            later = max(error(event, reference, "angle") for event, reference in zip(after, true, strict=True))
        number = data["sequence"].count("H")
        print(f"| {law} | {number} | {limit.to_mode} | {limit.t:.12f} | {here} | {later:.0e} |")


def main(folder: Path) -> None:
    """Draw the figure and print the numbers of the page."""
    folder.mkdir(parents=True, exist_ok=True)
    plt.rcParams["svg.hashsalt"] = "hophoop"
    bounces(folder)
    disk()
    friction()
    eccentric()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "docs" / "figures")
    main(parser.parse_args().folder)
