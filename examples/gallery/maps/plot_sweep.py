"""
Map of classes over friction and speed
======================================

A map of 14,400 motions: the phases of the first turn.
"""

import matplotlib.pyplot as plt

import hophoop as hh

dataset = hh.maps.sweep(
    axes={
        "plane.mu": hh.maps.linear(0.02, 2.0, 120),
        "start.speed": hh.maps.linear(0.05, 5.0, 120),
    },
    quantities=["sequence", "hop_height"],
)
hh.plots.motion_map(dataset)
plt.show()
