"""Controls of the page: sliders with their ranges, and choices; units are the scenario's own."""

from __future__ import annotations

from typing import Any

from hophoop.scenario import parameter
from hophoop.scenario.ranges import RANGES, Range
from hophoop.vocabulary.laws import LATEST_FIRST, LAWS

DEGREES = {"plane.slope", "start.angle"}

# path, label, symbol, minimum, maximum, step; values beyond a slider's range can be typed
_SLIDERS: dict[str, list[tuple[str, str, str, float, float, float]]] = {
    "hoop": [
        ("hoop.load_fraction", "Load fraction", "γ", 0.0, 1.0, 0.01),
        ("hoop.eccentricity", "Eccentricity", "ε", 0.0, 1.0, 0.01),
        ("hoop.inertia_ratio", "Inertia ratio", "κ", 0.01, 1.0, 0.01),
        ("hoop.radius", "Radius", "R", 0.05, 3.0, 0.05),
        ("hoop.mass", "Mass", "m", 0.1, 10.0, 0.1),
    ],
    "plane": [
        ("plane.mu", "Friction", "μ", 0.0, 1.5, 0.01),
        ("plane.mu_static", "Static friction", "μs", 0.0, 1.5, 0.01),
        ("plane.mu_kinetic", "Kinetic friction", "μk", 0.0, 1.5, 0.01),
        ("plane.slope", "Slope", "β", -30.0, 30.0, 0.5),
        ("plane.gravity", "Gravity", "g", 0.0, 25.0, 0.01),
        ("plane.restitution", "Restitution", "e", 0.0, 1.0, 0.01),
        ("plane.rolling_resistance", "Rolling resistance", "f", 0.0, 0.2, 0.001),
    ],
    "start": [
        ("start.speed", "Speed", "v₀", -6.0, 6.0, 0.01),
        ("start.angle", "Load angle", "θ₀", -180.0, 180.0, 0.5),
        ("start.height", "Height of the gap", "y₀", 0.0, 2.0, 0.01),
        ("start.vx", "Speed along", "ẋ₀", -8.0, 8.0, 0.01),
        ("start.vy", "Speed upwards", "ẏ₀", -5.0, 5.0, 0.01),
        ("start.omega", "Angular velocity", "θ̇₀", -15.0, 15.0, 0.05),
    ],
    "contact": [
        ("contact.stiffness", "Stiffness", "k", 1e2, 1e8, 0.0),
        ("contact.slip_speed", "Slip speed", "vₛ", 1e-7, 1e-1, 0.0),
        ("contact.restitution", "Restitution", "e", 0.0, 1.0, 0.01),
    ],
    "motion": [("duration", "Duration", "T", 0.5, 30.0, 0.5)],
}

CHOICES: dict[str, list[tuple[str, str]]] = {
    "plane.impact_law": [(name, LAWS[name].label) for name in LATEST_FIRST],
    "plane.painleve": [("flight", "flight"), ("impact", "impact")],
    "contact.model": [("rigid", "rigid"), ("compliant", "compliant")],
    "contact.law": [("kelvin-voigt", "Kelvin–Voigt"), ("hunt-crossley", "Hunt–Crossley")],
    "contact.friction": [("tanh", "smooth (tanh)"), ("linear", "linear"), ("bristle", "bristle (can hold)")],
}

CHOICE_LABELS = {
    "plane.impact_law": "Law of impact",
    "plane.painleve": "Painlevé: two solutions",
    "contact.model": "Contact model",
    "contact.law": "Normal force",
    "contact.friction": "Friction law",
}

GRAVITIES = [
    ("Earth", 9.81),
    ("Moon", 1.62),
    ("Mars", 3.71),
    ("Jupiter", 24.79),
    ("Weightless", 0.0),
]

# path, label, minimum and maximum in SI units: the possible axes of a map, with their initial range
MAP_AXES = [
    ("start.speed", "Speed v₀", 0.0, 5.0),
    ("start.angle", "Angle of the load θ₀", -3.141592653589793, 3.141592653589793),
    ("start.vx", "Speed along ẋ₀", -6.0, 6.0),
    ("start.omega", "Angular velocity θ̇₀", -8.0, 8.0),
    ("start.height", "Height of the gap y₀", 0.0, 1.0),
    ("hoop.load_fraction", "Load fraction γ", 0.05, 0.99),
    ("hoop.eccentricity", "Eccentricity ε", 0.05, 0.95),
    ("hoop.inertia_ratio", "Inertia ratio κ", 0.05, 1.0),
    ("hoop.radius", "Radius R", 0.1, 2.0),
    ("plane.mu", "Friction μ", 0.0, 1.5),
    ("plane.slope", "Slope β", -0.35, 0.35),
    ("plane.gravity", "Gravity g", 1.0, 20.0),
    ("plane.restitution", "Restitution e", 0.0, 1.0),
    ("plane.rolling_resistance", "Rolling resistance f", 0.0, 0.1),
]


def range_of(path: str) -> Range:
    """Return the allowed range of a number of a scenario.

    Parameters
    ----------
    path : str
        For example ``"plane.mu_static"``.

    Returns
    -------
    range : Range
        In the number's SI unit.
    """
    return RANGES["plane.mu" if path.startswith("plane.mu") else path]


def _allowed(allowed: Range) -> dict[str, Any]:
    also = ["inf" if value == float("inf") else value for value in allowed.also]
    return {"least": allowed.least, "most": allowed.most, "also": also}


def controls() -> dict[str, Any]:
    """Return everything that the page needs to show its controls.

    Returns
    -------
    controls : dict
        `groups` of sliders, `choices`, `gravities` and `map_axes`, ready for JSON.
    """
    groups: dict[str, list[dict[str, Any]]] = {}
    for group, rows in _SLIDERS.items():
        groups[group] = []
        for path, label, symbol, least, most, step in rows:
            info = parameter(path)
            angle = path in DEGREES
            groups[group].append(
                {
                    "path": path,
                    "label": label,
                    "symbol": symbol,
                    "unit": "°" if angle else "" if info.unit == "1" else info.unit,
                    "help": info.description,
                    "least": least,
                    "most": most,
                    "step": step,
                    "logarithmic": step == 0.0,
                    "degrees": angle,
                    "allowed": _allowed(range_of(path)),
                }
            )
    axes = []
    for path, label, low, high in MAP_AXES:
        angle = path in DEGREES
        unit = "°" if angle else "" if parameter(path).unit == "1" else parameter(path).unit
        allowed = range_of(path)
        least = min(allowed.least, 0.0) if 0.0 in allowed.also else allowed.least
        axes.append(
            {
                "path": path, "label": label, "unit": unit, "degrees": angle, "range": [low, high],
                "allowed": [least, allowed.most],
            }
        )  # fmt: skip
    return {
        "groups": groups,
        "choices": [
            {
                "path": path,
                "label": CHOICE_LABELS[path],
                "options": options,
                "help": parameter(path).description,
            }
            for path, options in CHOICES.items()
        ],
        "gravities": GRAVITIES,
        "map_axes": axes,
    }
