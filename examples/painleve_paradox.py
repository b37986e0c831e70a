"""Painlevé's paradox: where it is, what an impact without collision does, and which natural starts come to it.

Usage: python examples/painleve_paradox.py [FOLDER] [--cells 60]   (default: docs/figures)
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import hophoop as hh
from hophoop.plots import colors
from hophoop.theory import least_jam_speed

GRAVITY = 9.81


def region(folder: Path) -> None:
    """The friction from which on slip at an angle meets the paradox, for several hoops."""
    figure, ax = plt.subplots(figsize=(7.2, 4.2), layout="constrained")
    angles = np.linspace(1e-3, math.pi - 1e-3, 600)
    print("| γ | least μ | at | for a jam, μ below |")
    for gamma, color, dashes in (
        (0.5, colors.SERIES[1], "-"),
        (0.75, colors.BLACK, "-"),
        (0.9, colors.SERIES[2], "--"),
        (0.99, colors.SERIES[4], "-."),
    ):
        hoop = hh.Hoop.ideal(gamma)
        ax.plot(np.degrees(angles), hh.theory.painleve_threshold(angles, hoop), dashes, color=color, label=f"γ = {gamma:g}")
        least = hh.theory.painleve_minimum(hoop)
        ax.plot(math.degrees(least.angle), least.mu, "o", ms=4, color=color)
        level = float(hh.theory.painleve_threshold(0.5 * math.pi, hoop))
        print(f"| {gamma:g} | {least.mu:.6f} | {math.degrees(least.angle):.3f}° | {level:.6f} |")
    ax.axhline(1.0, color=colors.GRAY, lw=0.8, ls=":")
    ax.text(178.0, 1.03, "μ = 1", ha="right", fontsize=9, color=colors.GRAY)
    ax.set_ylim(0.0, 4.0)
    ax.set_xlim(0.0, 180.0)
    ax.set_xticks(range(0, 181, 30))
    ax.set_xlabel("θ in a spin, 360° − θ in a skid (°)")
    ax.set_ylabel(r"Least friction with $p_\sigma$ ≤ 0")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    save(figure, folder / "painleve-region.svg")


def towards_it(folder: Path) -> None:
    """Slip with a friction just below the threshold, and the impulse that it goes over into."""
    hoop, start = hh.Hoop.ideal(0.75), hh.Start(angle=-0.7, vx=3.0, omega=1.0)
    threshold = float(hh.theory.painleve_threshold(-0.7, hoop))
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    impact = hh.simulate(hoop, hh.Plane(mu=1.000001 * threshold), start, duration=0.3).find("impact")[0]
    print(f"θ = −0.7, v_t = 2 m/s, θ̇ = 1 rad/s: threshold μ = {threshold:.6f}; just above it an impact without collision with")
    print(f"{impact.impulse_normal:.6f} N s, after which v_t = {impact.slip:g} and θ̇ = {impact.omega:.6f} rad/s")
    print("| μ below the threshold by | slip lasts (s) | N at the start (N) | impulse of N (N s) | θ̇ after it (rad/s) |")
    below = 10.0 ** -np.arange(1, 8)
    lasts, forces = [], []
    for k, share in enumerate(below):
        motion = hh.simulate(hoop, hh.Plane(mu=threshold * (1 - share)), start, duration=0.3)
        stop = motion.events[1]
        times = np.linspace(0.0, stop.t, 2001)
        sample = motion.at(times, side="left")
        force = sample.normal_force
        impulse = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(times) * (force[1:] + force[:-1]))])
        lasts.append(stop.t)
        forces.append(float(sample.normal_force[0]))
        print(f"| 10⁻{'¹²³⁴⁵⁶⁷'[k]} | {stop.t:.3e} | {forces[-1]:.4e} | {impulse[-1]:.6f} | {stop.omega:.6f} |")
        if k < 3:
            color, dashes = ((colors.SERIES[1], "-"), (colors.SERIES[2], "--"), (colors.SERIES[4], "-."))[k]
            axes[0].plot(impulse, sample.slip, dashes, color=color, label=f"slip for {1e3 * stop.t:.3g} ms at {1 - share:g} μ*")
    straight = {"color": colors.SERIES[5], "lw": 4, "alpha": 0.5, "label": "impact without collision"}
    axes[0].plot([0.0, impact.impulse_normal], [2.0, 0.0], **straight)
    axes[0].set_xlabel("Normal impulse so far (N s)")
    axes[0].set_ylabel("Slip velocity (m/s)")
    axes[1].loglog(below, 1e3 * np.array(lasts), "o", color=colors.SERIES[1], label="slip lasts (ms)")
    axes[1].loglog(below, forces, "s", color=colors.NORMAL_FORCE, label="normal force (N)")
    axes[1].set_xlabel("1 − μ/μ*")
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    save(figure, folder / "painleve-limit.svg")


def paradoxes(
    gammas: np.ndarray, frictions: np.ndarray, speeds: np.ndarray, base: hh.Scenario | None = None, hops: bool = False
) -> dict[str, np.ndarray]:
    """Over (γ, μ): `starts`, shares that have `met` p ≤ 0 or `jammed`, `lowest_speed` and `lowest_jam_speed` of those [m/s].

    With `hops` the starts that are too fast to roll at the top count as well.
    """
    base = hh.Scenario() if base is None else base
    axes = {"hoop.load_fraction": gammas, "plane.mu": frictions, "start.speed": speeds}
    found = hh.maps.sweep(base, axes, quantities=("status", "painleve"), span="duration")
    rolls = speeds**2 * gammas[:, None] <= base.plane.gravity * math.cos(base.plane.slope) * base.hoop.radius
    counted = np.broadcast_to((rolls | hops)[:, None, :], found["status"].shape)
    met, jammed = (
        counted & (found[name].values == hh.maps.words_of(found[name]).index(word))
        for name, word in (("painleve", "yes"), ("status", "jammed"))
    )

    def lowest(those: np.ndarray) -> np.ndarray:
        slowest = np.where(those, speeds, np.inf).min(axis=2)
        return np.where(np.isfinite(slowest), slowest, np.nan)

    starts = counted.sum(axis=2)
    return {
        "load_fraction": gammas, "friction": frictions, "starts": starts, "met": met.sum(axis=2) / np.maximum(starts, 1),
        "jammed": jammed.sum(axis=2) / np.maximum(starts, 1), "lowest_speed": lowest(met), "lowest_jam_speed": lowest(jammed),
    }  # fmt: skip


def search(folder: Path, cells: int) -> None:
    """Which starts from the top meet the paradox, over load and friction."""
    gammas = 1.0 - np.geomspace(0.5, 1e-3, cells)
    frictions = np.geomspace(0.04, 3.0, cells)
    slow = np.concatenate([np.geomspace(0.01, 1.0, cells // 2), np.linspace(1.02, math.sqrt(GRAVITY / 0.5), cells)])
    fast = np.linspace(3.2, 12.0, 2 * cells)

    print("| starts | searched | meet p ≤ 0 | end in a jam | slowest that jams (m/s) | γ of those that jam | μ of those |")
    table("level, roll first", level := paradoxes(gammas, frictions, slow))
    # lighter rims still, and longer
    light = 1.0 - np.geomspace(1e-3, 1e-9, cells // 2)
    table("the same, 10⁻⁹ ≤ 1 − γ ≤ 10⁻³", paradoxes(light, np.geomspace(1e-4, 1.0, cells // 2), slow[::2]))
    elastic = hh.Scenario(plane=hh.Plane(restitution=0.7))
    table("level, roll first, e = 0.7", paradoxes(gammas[::2], frictions[::2], slow[::2], base=elastic))
    thrown = paradoxes(gammas, frictions, fast, hops=True)
    table("level, thrown: hop at once", thrown)
    coarse = paradoxes(gammas[::2], frictions[::2], fast[::2], hops=True)
    table("the same, half the grid", coarse)
    slopes = {}
    for degrees in (5.0, 10.0, 15.0, 20.0, 30.0):
        base = hh.Scenario(plane=hh.Plane(slope=math.radians(degrees)))
        step = 1 if degrees == 30.0 else 2
        slopes[degrees] = paradoxes(gammas[::step], frictions[::step], slow[::2], base=base)
        table(f"{degrees:g}° downhill, roll first", slopes[degrees])
    assert not level["met"].any()

    bound = np.array([[least_jam_speed(hh.Hoop.ideal(g), hh.Plane(mu=mu)) for mu in frictions] for g in gammas])
    lowest = thrown["lowest_jam_speed"]
    jams = np.isfinite(lowest)
    ratio = np.min(lowest[jams] / bound[jams])
    print(f"In all {jams.sum()} cells with a jam on the level the slowest is {ratio:.4f} times as fast as energy asks, or more")
    print("| grid | cells with a start that meets it | with a jam |")
    for name, found in (("full", thrown), ("half", coarse)):
        print(f"| {name} | {np.mean(found['met'] > 0):.2%} | {np.mean(found['jammed'] > 0):.2%} |")

    figure, axes = plt.subplots(1, 2, figsize=(10.2, 4.7), layout="constrained", sharey=True)
    rolling = 100.0 * slopes[30.0]["met"]
    panels = (
        (thrown["lowest_speed"], "level, thrown from the top", "Slowest start that meets it (m/s)", (3.0, 12.0)),
        (rolling, "30° downhill, rolling from the top", "Starts that meet it within 6 s (%)", (0.0, 100.0)),
    )
    fine = 1.0 - np.geomspace(0.5, 1e-3, 200)
    for ax, (values, title, label, limits) in zip(axes, panels, strict=True):
        shown = np.where(values > 0.0, values, np.nan)
        mesh = ax.pcolormesh(
            frictions, 1.0 - gammas, shown, cmap="viridis", vmin=limits[0], vmax=limits[1], shading="nearest", rasterized=True
        )
        figure.colorbar(mesh, ax=ax, label=label)
        least = [hh.theory.painleve_minimum(hh.Hoop.ideal(float(gamma))).mu for gamma in fine]
        ax.plot(least, 1.0 - fine, color=colors.BLACK, lw=1.5, label="from here on p ≤ 0 at some angle")
        ax.plot(1.0 / fine, 1.0 - fine, "--", color=colors.BLACK, lw=1.5, label="up to here a jam: μ = 1/γ")
        ax.plot([1.0], [0.25], "D", color=colors.SERIES[5], ms=6, label="the article's hoop")
        ax.set_title(title, fontsize="medium")
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_xlim(frictions[0], frictions[-1])
        ax.set_ylim(1e-3, 0.5)
        ax.set_xlabel("Friction μ")
    axes[0].set_ylabel("Mass of the ring over all, 1 − γ")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncol=3, frameon=False, fontsize=9)
    figure.savefig(folder / "painleve-starts.svg", dpi=160, metadata={"Date": None})
    plt.close(figure)


def table(name: str, found: dict[str, np.ndarray]) -> None:
    """One row for a search."""
    starts = found["starts"]
    met, jammed = np.sum(found["met"] * starts), np.sum(found["jammed"] * starts)
    ends = "– | – | –"
    if jammed > 0:
        rows, columns = np.nonzero(found["jammed"] > 0)
        gammas, frictions = found["load_fraction"][rows], found["friction"][columns]
        slowest = np.nanmin(found["lowest_jam_speed"])
        ends = f"{slowest:.2f} | {gammas.min():.4f} to {gammas.max():.4f} | {frictions.min():.3f} to {frictions.max():.3f}"
    print(f"| {name} | {starts.sum():,} | {met:,.0f} | {jammed:,.0f} | {ends} |")


def close_by_scipy(gamma: float, mu: float, speed: float) -> bool:
    """Whether a throw's first slip after its first landing comes to κ m p < 10⁻⁷: equations of motion by SciPy."""
    kappa = 1 - gamma**2

    def gap(t: float) -> float:
        return gamma * (1 - math.cos(speed * t)) - 0.5 * GRAVITY * t * t

    times = np.linspace(1e-3, 2 * math.sqrt(gamma / GRAVITY) + 1e-2, 2000)
    signs = [gap(float(t)) for t in times]
    k = next(k for k in range(1, len(times)) if signs[k] < 0.0)
    landing = brentq(gap, times[k - 1], times[k], xtol=1e-15, rtol=1e-15)
    angle = speed * landing

    def matrix(angle: float) -> tuple[float, float, float]:
        arm, height = gamma * math.sin(angle), 1 + gamma * math.cos(angle)
        return 1 + height**2 / kappa, 1 + arm**2 / kappa, -arm * height / kappa

    slip = speed * (1 + gamma) - speed * (1 + gamma * math.cos(angle))
    approach = gamma * speed * math.sin(angle) - GRAVITY * landing
    tt, nn, tn = matrix(angle)
    sigma = math.copysign(1.0, slip)
    stiffness = nn - sigma * mu * tn
    if stiffness <= 0.0:
        return False  # the slip stops
    push = -approach / stiffness
    after = slip + push * (tn - sigma * mu * tt)
    if after * sigma <= 0.0:
        return False
    turn = gamma * math.sin(angle) * push + sigma * mu * (1 + gamma * math.cos(angle)) * push

    def parts(angle: float, rate: float) -> tuple[float, float]:
        arm, height = gamma * math.sin(angle), 1 + gamma * math.cos(angle)
        return kappa + arm * (arm + sigma * mu * height), GRAVITY - gamma * rate**2 * math.cos(angle)

    def flow(_: float, state: np.ndarray) -> list[float]:
        angle, rate, _ = state
        weight, pressure = parts(angle, rate)
        normal = kappa * pressure / weight
        arm, height = gamma * math.sin(angle), 1 + gamma * math.cos(angle)
        spin = normal * (arm + sigma * mu * height) / kappa
        return [rate, spin, -sigma * mu * normal + gamma * rate**2 * math.sin(angle) - height * spin]

    def stops(_: float, state: np.ndarray) -> float:
        return state[2]

    def lifts(_: float, state: np.ndarray) -> float:
        return parts(state[0], state[1])[1] - 1e-9

    def narrows(_: float, state: np.ndarray) -> float:
        return parts(state[0], state[1])[0] - 1e-7

    for event in (stops, lifts, narrows):
        event.terminal = True  # type: ignore[attr-defined]
    result = solve_ivp(
        flow, (0.0, 6.0 - landing), [angle, speed + turn / kappa, after], "LSODA", rtol=1e-11, atol=1e-12, max_step=0.02,
        events=(stops, lifts, narrows),
    )  # fmt: skip
    return bool(result.t_events[2].size)


def close(gamma: float, mu: float, speed: float) -> bool:
    """The same by the program: whether the first slip after the first landing ends where κ m p < 10⁻⁷."""
    motion = hh.simulate(hh.Hoop.ideal(gamma), hh.Plane(mu=mu), hh.Start.rolling(speed), duration=6.0)
    landed = False
    for event in motion.events:
        if event.kind == "impact" and event.collision and not landed:
            if event.to_mode not in "KS":
                return False
            landed = True
        elif landed and event.kind not in ("turn", "end"):
            sigma = 1.0 if event.from_mode == "K" else -1.0
            arm, height = gamma * math.sin(event.angle), 1 + gamma * math.cos(event.angle)
            return 1 - gamma**2 + arm * (arm + sigma * mu * height) < 1e-7
    return False


def second_way() -> None:
    """The same question to SciPy, at random and on a border."""
    random = np.random.default_rng(5)
    same = jams = 0
    number = 300
    for _ in range(number):
        gamma = 1 - 10 ** random.uniform(-2.5, -0.8)
        low, high = math.sqrt(1 - gamma**2) / gamma, 1 / gamma
        mu = low * (high / low) ** random.random()
        speed = random.uniform(1.02 * math.sqrt(GRAVITY / gamma), 12.0)
        mine = close(gamma, mu, speed)
        jams += mine
        same += mine == close_by_scipy(gamma, mu, speed)
    print(f"{number} random throws, {jams} of which come to p = 0 in the first slip: SciPy agrees in {same}")
    print("| γ | μ | border at $v_0$ (m/s) | by SciPy |")
    for gamma, mu in ((0.88, 0.8), (0.95, 0.75), (0.98, 0.4), (0.99, 0.5)):
        speeds = np.linspace(3.4, 12.0, 173)
        found = [close(gamma, mu, float(speed)) for speed in speeds]
        k = next((k for k in range(speeds.size - 1) if found[k] != found[k + 1]), None)
        if k is None:
            continue
        borders = []
        for ask in (close, close_by_scipy):
            a, b, first = float(speeds[k]), float(speeds[k + 1]), ask(gamma, mu, float(speeds[k]))
            for _ in range(40):
                middle = 0.5 * (a + b)
                a, b = (middle, b) if ask(gamma, mu, middle) == first else (a, middle)
            borders.append(b)
        print(f"| {gamma:g} | {mu:g} | {borders[0]:.9f} | {borders[1]:.9f} |")


def examples() -> None:
    """The jams of single motions."""
    print("| γ | μ | slope | $v_0$ (m/s) | phases | jams at (s) | θ | θ̇ (rad/s) | v_t (m/s) | off theory, θ and θ̇ |")
    for gamma, mu, degrees, speed in ((0.85, 0.8, 0.0, 8.6), (0.95, 0.5, 30.0, 2.0), (0.99, 0.3, 30.0, 0.5)):
        hoop, plane = hh.Hoop.ideal(gamma), hh.Plane(mu=mu, slope=math.radians(degrees))
        for trial in np.linspace(speed, speed + 2.0, 201):
            motion = hh.simulate(hoop, plane, hh.Start.rolling(float(trial)), duration=6.0)
            if motion.status == "jammed":
                break
        else:
            continue
        (jam,) = motion.find("jam")
        place = jam.angle % (2 * math.pi)
        state = min(hh.theory.jam_states(hoop, plane), key=lambda state: abs(state.angle - place))
        off = f"{abs(state.angle - place):.0e}, {abs(state.omega - jam.omega):.0e}"
        print(
            f"| {gamma:g} | {mu:g} | {degrees:g}° | {trial:.2f} | {motion.sequence} | {jam.t:.5f} | {math.degrees(place):.5f}° "
            f"| {jam.omega:.5f} | {jam.slip:.5f} | {off} |"
        )


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parent.parent / "docs" / "figures")
    parser.add_argument("--cells", type=int, default=60)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    plt.rcParams["svg.hashsalt"] = "hophoop"
    region(arguments.folder)
    towards_it(arguments.folder)
    examples()
    second_way()
    search(arguments.folder, arguments.cells)


if __name__ == "__main__":
    main()
