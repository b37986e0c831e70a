"""
Velocities
==========

The velocity of the centre and the angular velocity. The ribbon at the top names the
phases.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.velocities(motion)
plt.show()
