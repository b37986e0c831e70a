"""
Overview of a motion
====================

Path, velocities, energies and forces together.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.overview(motion)
plt.show()
