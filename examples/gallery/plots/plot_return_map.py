"""
Return map: from one revolution to the next
===========================================

Down a slope of 4° the hoop never repeats itself. The line walks between map
and diagonal, one step per revolution.
"""

import math

import matplotlib.pyplot as plt

import hophoop as hh

slope = hh.Scenario(plane=hh.Plane(slope=math.radians(4)))
found = hh.gaits.return_map(slope, 8.0, 11.3)  # rad/s
hh.plots.return_map(found, start=10.5, passages=200)
plt.show()
