"""
A map stored in a file
======================

A map that is written to a file can be larger than memory, and can be continued
after a stop. ``open_map`` reads it back.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import hophoop as hh

with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "map.zarr"
    axes = {
        "plane.slope": hh.maps.linear(-0.3, 0.3, 60),
        "start.speed": hh.maps.linear(0.5, 4.0, 60),
    }
    hh.maps.sweep(axes=axes, quantities=["sequence"], out=path)
    hh.plots.motion_map(hh.maps.open_map(path))
plt.show()
