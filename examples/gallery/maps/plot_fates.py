"""
Fates on the level: rolls on, slips ever less, or rocks for ever
================================================================

With the span ``settled`` each of 24,000 motions is followed until its fate is
decided, however long it takes. A slow hoop rolls ahead for ever. A faster one
slips in each revolution, ever less, or has lost so much that it rocks to and
fro. Below μ = 0.37 every hoop rocks in the end.
"""

import matplotlib.pyplot as plt

import hophoop as hh

dataset = hh.maps.sweep(
    axes={
        "plane.mu": hh.maps.linear(0.02, 2.0, 120),
        "start.speed": hh.maps.linear(0.05, 12.0, 200),
    },
    quantities=["fate"],
    span="settled",
)
hh.plots.motion_map(dataset, painleve=False)
plt.show()
