"""Figures of a motion: one function each, which takes ``ax=None`` and returns the Axes without showing it.

Matplotlib is in the extra ``plots`` and loaded when a figure is drawn.
"""

from hophoop.plots.branch import branch
from hophoop.plots.diagram import diagram
from hophoop.plots.maps import motion_map
from hophoop.plots.motion import contact_forces, energies, friction_utilization, gap, velocities
from hophoop.plots.over_time import track
from hophoop.plots.overview import overview
from hophoop.plots.path import geometry, path
from hophoop.plots.plane import phase_plane
from hophoop.plots.return_map import return_map
from hophoop.plots.strobe import strobe
from hophoop.vocabulary import colors
from hophoop.vocabulary.colors import class_color

__all__ = [
    "velocities",
    "energies",
    "contact_forces",
    "friction_utilization",
    "gap",
    "path",
    "strobe",
    "phase_plane",
    "branch",
    "diagram",
    "return_map",
    "geometry",
    "motion_map",
    "class_color",
    "overview",
    "track",
    "colors",
]
