"""
Stroboscope picture with forces
===============================

Every tenth of a second, coloured by the mode, with the forces of the ground.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.strobe(motion, every=0.1, color="mode", forces=True)
plt.show()
