"""
Height of the rim above the ground
==================================

How high the rim is above the ground. With restitution the landing is followed by
smaller hops.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(plane=hh.Plane(restitution=0.5), duration=3.0))
hh.plots.gap(motion)
plt.show()
