"""
Stroboscope picture
===================

The hoop every 30 degrees. The ring is coloured by the speed of its points.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.strobe(motion, every_deg=30)
plt.show()
