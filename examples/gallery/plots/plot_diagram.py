"""
Bifurcation diagram: gaits and chaos over the slope
===================================================

What the hoop settles on from 0.5° to 6°: a gait, two gaits, four, chaos, and
no way on.
"""

import math

import matplotlib.pyplot as plt

import hophoop as hh

slopes = hh.maps.linear(math.radians(0.5), math.radians(6), 120)
found = hh.gaits.diagram(hh.Scenario(), "plane.slope", slopes)
hh.plots.diagram(found)
plt.show()
