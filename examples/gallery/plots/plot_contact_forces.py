"""
Contact forces
==============

Normal force and friction of the ground, over the angle of the load.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.contact_forces(motion)
plt.show()
