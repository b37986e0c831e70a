"""One-line description of a scenario, for the headings of figures, films and tables."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

from hophoop.scenario.models import Hoop, Plane
from hophoop.scenario.scenario import Scenario
from hophoop.scenario.start import Start


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
    parts = (*_start(scenario.start), *_friction(scenario.plane), *_hoop(scenario.hoop), *_plane(scenario.plane))
    words = [text for paths, text in parts if not set(paths) & set(without)]
    if scenario.contact.model != "rigid":
        words.append(f"{scenario.contact.model} contact")
    return ", ".join(words)


Part = tuple[tuple[str, ...], str]  # paths of the parameters in a text


def _start(start: Start) -> Iterator[Part]:
    if start.speed is not None:
        yield ("start.speed",), f"v₀ = {start.speed:g} m/s"
    elif start.height:
        yield ("start.height",), f"gap {start.height:g} m"
    if start.angle:
        yield ("start.angle",), f"θ₀ = {math.degrees(start.angle):.4g}°"
    if start.speed is None:
        yield ("start.vx", "start.vy"), f"v = ({start.vx:g}, {start.vy:g}) m/s"
        yield ("start.omega",), f"θ̇ = {start.omega:g} rad/s"


def _friction(plane: Plane) -> Iterator[Part]:
    if plane.mu_static == plane.mu_kinetic:
        yield ("plane.mu",), f"μ = {plane.mu_static:g}".replace("inf", "∞")
    else:
        yield ("plane.mu", "plane.mu_static"), f"μs = {plane.mu_static:g}".replace("inf", "∞")
        yield ("plane.mu", "plane.mu_kinetic"), f"μk = {plane.mu_kinetic:g}".replace("inf", "∞")


def _hoop(hoop: Hoop) -> Iterator[Part]:
    if hoop.load_fraction is not None:
        yield ("hoop.load_fraction",), f"γ = {hoop.load_fraction:g}"
    else:
        yield ("hoop.eccentricity",), f"ε = {hoop.eccentricity:.4g}"
        yield ("hoop.inertia_ratio",), f"κ = {hoop.inertia_ratio:.4g}"


def _plane(plane: Plane) -> Iterator[Part]:
    if plane.slope:
        yield ("plane.slope",), f"β = {math.degrees(plane.slope):.3g}°"
    if plane.restitution:
        yield ("plane.restitution",), f"e = {plane.restitution:g}"
