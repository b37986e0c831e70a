"""Maps: reduced quantities of millions of motions over any parameters of a scenario.

xarray, Zarr and contourpy are in the extra ``maps``, and are loaded when a map is made; clusters are in ``cluster``.
"""

from hophoop.maps.boundaries.classes import Border
from hophoop.maps.boundaries.contours import borders
from hophoop.maps.boundaries.following import boundary
from hophoop.maps.catalog import Entry, catalogue, catalogued
from hophoop.maps.grid.axes import linear, logarithmic, scenario_at
from hophoop.maps.grid.evaluate import points
from hophoop.maps.grid.quantities import QUANTITIES, SETTLED, SPANS, Quantity, words_of
from hophoop.maps.grid.store import open_map
from hophoop.maps.grid.sweeping import sweep

__all__ = [
    "sweep",
    "points",
    "boundary",
    "borders",
    "open_map",
    "words_of",
    "linear",
    "logarithmic",
    "scenario_at",
    "QUANTITIES",
    "SETTLED",
    "SPANS",
    "Quantity",
    "catalogue",
    "catalogued",
    "Entry",
    "Border",
]
