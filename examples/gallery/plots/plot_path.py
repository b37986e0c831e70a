"""
Path of centre, load and centre of gravity
==========================================

Traces of the load (black) and of the centre of gravity (green, red while airborne).
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.path(motion)
plt.show()
