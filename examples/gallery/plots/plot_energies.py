"""
Energies
========

Where the energy is, and where it goes. The sum of all curves stays the same.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.energies(motion, against="time")
plt.show()
