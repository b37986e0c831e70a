"""
Boundaries between classes of motion
====================================

``borders`` returns every border between the cells of a map. Its points are where it
crosses the lines of the grid, to rounding.
"""

import matplotlib.pyplot as plt

import hophoop as hh

dataset = hh.maps.sweep(
    axes={
        "plane.mu": hh.maps.linear(0.2, 1.2, 40),
        "start.speed": hh.maps.linear(2.0, 3.4, 40),
    }
)
lines = hh.maps.borders(dataset)
hh.plots.motion_map(dataset, borders=lines)
plt.show()
