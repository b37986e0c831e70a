"""hophoop: exact motion of a loaded hoop on a plane.

The names below are loaded when first used, so that importing the package costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module

from hophoop._version import __version__

TYPE_CHECKING = False  # importing `typing` takes longer than all of this file

# Where each public name is defined, in a reader's order; None is a module.
_HOMES: dict[str, str | None] = {
    "Hoop": "scenario",
    "Plane": "scenario",
    "Start": "scenario",
    "Ring": "scenario",
    "Disk": "scenario",
    "PointMass": "scenario",
    "Rod": "scenario",
    "Rigid": "scenario",
    "Compliant": "scenario",
    "Scenario": "scenario",
    "simulate": "simulation.simulate",
    "sensitivity": "simulation.simulate",
    "Trajectory": "simulation.trajectory",
    "phases": "simulation.phases",
    "passages": "gaits",
    "load": "io",
    "track": "tracking",
    "read_track": "tracking",
    "Track": "tracking",
    "fit": "fitting",
    "Fit": "fitting",
    "load_fit": "fitting",
    "plan": "fitting",
    "io": None,
    "cite": None,
    "theory": None,
    "article": None,
    "maps": None,
    "gaits": None,
    "plots": None,
    "precise": None,
    "prove": None,
    "animate": None,
    "show": "lab.widget",
}

__all__ = [*_HOMES, "__version__"]  # pyright: ignore[reportUnsupportedDunderAll]

# For type checkers, which do not run this file; a test compares the names with the table.
if TYPE_CHECKING:
    from hophoop import animate as animate
    from hophoop import article as article
    from hophoop import cite as cite
    from hophoop import gaits as gaits
    from hophoop import io as io
    from hophoop import maps as maps
    from hophoop import plots as plots
    from hophoop import precise as precise
    from hophoop import prove as prove
    from hophoop import theory as theory
    from hophoop.fitting import Fit as Fit
    from hophoop.fitting import fit as fit
    from hophoop.fitting import load_fit as load_fit
    from hophoop.fitting import plan as plan
    from hophoop.gaits import passages as passages
    from hophoop.io import load as load
    from hophoop.lab.widget import show as show
    from hophoop.scenario import Compliant as Compliant
    from hophoop.scenario import Disk as Disk
    from hophoop.scenario import Hoop as Hoop
    from hophoop.scenario import Plane as Plane
    from hophoop.scenario import PointMass as PointMass
    from hophoop.scenario import Rigid as Rigid
    from hophoop.scenario import Ring as Ring
    from hophoop.scenario import Rod as Rod
    from hophoop.scenario import Scenario as Scenario
    from hophoop.scenario import Start as Start
    from hophoop.simulation.phases import phases as phases
    from hophoop.simulation.simulate import sensitivity as sensitivity
    from hophoop.simulation.simulate import simulate as simulate
    from hophoop.simulation.trajectory import Trajectory as Trajectory
    from hophoop.tracking import Track as Track
    from hophoop.tracking import read_track as read_track
    from hophoop.tracking import track as track
else:

    def __getattr__(name: str) -> object:
        if name not in _HOMES:
            raise AttributeError(f"module 'hophoop' has no attribute {name!r}")
        home = _HOMES[name]
        module = import_module(f"hophoop.{home or name}")
        value = module if home is None else getattr(module, name)
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    return sorted(__all__)
