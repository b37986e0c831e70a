"""
Map of the hop height
=====================

The same map, with the height of the first hop. It is greatest just below the speed
at which the hoop leaves the ground at once.
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
hh.plots.motion_map(dataset, "hop_height")
plt.show()
