"""Slopes from which fast motion grows, as in docs/gaits.md: a flight, then a contact without gravity, from a random angle.

About six minutes.
"""

from __future__ import annotations

import math

import numpy as np

import hophoop as hh

FALL = 3.5  # height of the centre of gravity from which a fall is followed [R]; above 2, where the rim reaches the plane
BATCHES = 50


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


if __name__ == "__main__":
    runaway()
