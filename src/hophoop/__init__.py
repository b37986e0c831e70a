"""hophoop: exact motion of a loaded hoop on a plane.

The names below are loaded when first used, so that importing the package costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    import hophoop.animate as animate
    import hophoop.article as article
    import hophoop.claims as claims
    import hophoop.engines as engines
    import hophoop.jax as jax
    import hophoop.maps as maps
    import hophoop.plots as plots
    import hophoop.precise as precise
    import hophoop.prove as prove
    import hophoop.theory as theory
    from hophoop.designing import design
    from hophoop.explanation import phases
    from hophoop.fitting import Fit, fit, load_fit, plan
    from hophoop.io import load
    from hophoop.lab.widget import show
    from hophoop.scenario import (
        Compliant,
        Disk,
        Hoop,
        Plane,
        PointMass,
        Rigid,
        Ring,
        Rod,
        Scenario,
        Start,
    )
    from hophoop.simulation import sensitivity, simulate
    from hophoop.tracking import Track, read_track, track
    from hophoop.trajectory import Trajectory

# Where each public name lives; None is a module of its own.
_HOMES: dict[str, str | None] = {
    "Hoop": "hophoop.scenario",
    "Plane": "hophoop.scenario",
    "Start": "hophoop.scenario",
    "Ring": "hophoop.scenario",
    "Disk": "hophoop.scenario",
    "PointMass": "hophoop.scenario",
    "Rod": "hophoop.scenario",
    "Rigid": "hophoop.scenario",
    "Compliant": "hophoop.scenario",
    "Scenario": "hophoop.scenario",
    "simulate": "hophoop.simulation",
    "sensitivity": "hophoop.simulation",
    "Trajectory": "hophoop.trajectory",
    "design": "hophoop.designing",
    "load": "hophoop.io",
    "phases": "hophoop.explanation",
    "show": "hophoop.lab.widget",
    "track": "hophoop.tracking",
    "read_track": "hophoop.tracking",
    "Track": "hophoop.tracking",
    "fit": "hophoop.fitting",
    "Fit": "hophoop.fitting",
    "load_fit": "hophoop.fitting",
    "plan": "hophoop.fitting",
    "theory": None,
    "article": None,
    "claims": None,
    "maps": None,
    "plots": None,
    "precise": None,
    "prove": None,
    "engines": None,
    "jax": None,
    "animate": None,
}

__all__ = [
    "Hoop",
    "Plane",
    "Start",
    "Ring",
    "Disk",
    "PointMass",
    "Rod",
    "Rigid",
    "Compliant",
    "Scenario",
    "simulate",
    "sensitivity",
    "Trajectory",
    "design",
    "phases",
    "load",
    "track",
    "read_track",
    "Track",
    "fit",
    "Fit",
    "load_fit",
    "plan",
    "theory",
    "article",
    "claims",
    "maps",
    "plots",
    "precise",
    "prove",
    "engines",
    "animate",
    "jax",
    "show",
    "__version__",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'hophoop' has no attribute {name!r}")
    home = _HOMES[name]
    value = import_module(f"hophoop.{name}") if home is None else getattr(import_module(home), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
