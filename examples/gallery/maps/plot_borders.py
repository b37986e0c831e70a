"""
Boundaries between classes of motion
====================================

``borders`` finds every border that the cells of a map see, and follows it to
rounding.
"""

import matplotlib.pyplot as plt

import hophoop as hh

dataset = hh.maps.sweep(
    axes={
        "plane.mu": hh.maps.linear(0.2, 1.2, 40),
        "start.speed": hh.maps.linear(2.0, 3.4, 40),
    }
)
lines = hh.maps.borders(dataset, step=0.05)
hh.plots.motion_map(dataset, borders=lines)
plt.show()
