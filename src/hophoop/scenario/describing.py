"""One-line description of a scenario, for the headings of figures, films and tables."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

from hophoop.scenario.scenario import Scenario


def describe(scenario: Scenario, without: Collection[str] = ()) -> str:
    """Return the main parameters of a scenario in one line.

    Parameters
    ----------
    scenario : Scenario
    without : collection of str
        Paths of parameters to omit, such as those of a map's axes.

    Returns
    -------
    line : str
        Such as 'v₀ = 3.1 m/s, μ = 1, γ = 0.75'.
    """
    words = [text for paths, text in _parts(scenario) if not set(paths) & set(without)]
    return ", ".join(words).replace("inf", "∞")


def _parts(scenario: Scenario) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield the texts of a line, each after the paths of the parameters in it."""
    start, plane, hoop = scenario.start, scenario.plane, scenario.hoop
    if start.speed is not None:
        yield ("start.speed",), f"v₀ = {start.speed:g} m/s"
    if start.height:
        yield ("start.height",), f"gap {start.height:g} m"
    if start.angle:
        yield ("start.angle",), f"θ₀ = {math.degrees(start.angle):.4g}°"
    if start.speed is None:
        yield ("start.vx", "start.vy"), f"v = ({start.vx:g}, {start.vy:g}) m/s"
        yield ("start.omega",), f"θ̇ = {start.omega:g} rad/s"
    if plane.mu is not None:
        yield ("plane.mu",), f"μ = {plane.mu:g}"
    else:
        yield ("plane.mu", "plane.mu_static"), f"μs = {plane.mu_static:g}"
        yield ("plane.mu", "plane.mu_kinetic"), f"μk = {plane.mu_kinetic:g}"
    if hoop.load_fraction is not None:
        yield ("hoop.load_fraction",), f"γ = {hoop.load_fraction:g}"
    else:
        yield ("hoop.eccentricity",), f"ε = {hoop.eccentricity:.4g}"
        yield ("hoop.inertia_ratio",), f"κ = {hoop.inertia_ratio:.4g}"
    if plane.slope:
        yield ("plane.slope",), f"β = {math.degrees(plane.slope):.3g}°"
    if plane.restitution:
        yield ("plane.restitution",), f"e = {plane.restitution:g}"
    if scenario.contact.model != "rigid":
        yield (), f"{scenario.contact.model} contact"
