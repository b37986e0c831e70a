"""
Branch of gaits: folds, border collisions, unstable gaits
=========================================================

A gait followed over the slope, through two folds. Dashed gaits are unstable.
"""

import math

import matplotlib.pyplot as plt

import hophoop as hh

slope = hh.Scenario(plane=hh.Plane(slope=math.radians(1)))
gait = hh.gaits.find(slope, near=10.7)[0]  # rad/s
branch = gait.follow("plane.slope", (math.radians(0.3), math.radians(1.6)))
hh.plots.branch(branch)
plt.show()
