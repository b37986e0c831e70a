"""A scenario in a line of words, for the heads of figures, films and tables."""

from __future__ import annotations

import math

from hophoop.scenario.scenario import Scenario


def describe(scenario: Scenario) -> str:
    """The parameters of a scenario that matter most, in a line.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    line : str
        Such as 'v₀ = 3.1 m/s, μ = 1, γ = 0.75'.
    """
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start
    words = []
    if start.speed is not None:
        words.append(f"v₀ = {start.speed:g} m/s")
        if start.angle:
            words.append(f"θ₀ = {math.degrees(start.angle):.4g}°")
    else:
        words.append(f"v = ({start.vx:g}, {start.vy:g}) m/s, θ̇ = {start.omega:g} rad/s")
    if plane.mu_static == plane.mu_kinetic:
        words.append(f"μ = {plane.mu_static:g}".replace("inf", "∞"))
    else:
        words.append(f"μs = {plane.mu_static:g}, μk = {plane.mu_kinetic:g}".replace("inf", "∞"))
    if hoop.load_fraction is not None:
        words.append(f"γ = {hoop.load_fraction:g}")
    else:
        words.append(f"ε = {hoop.eccentricity:.4g}, κ = {hoop.inertia_ratio:.4g}")
    if plane.slope:
        words.append(f"β = {math.degrees(plane.slope):.3g}°")
    if plane.restitution:
        words.append(f"e = {plane.restitution:g}")
    if scenario.contact.model != "rigid":
        words.append(f"{scenario.contact.model} contact")
    return ", ".join(words)
