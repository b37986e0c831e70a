"""
Phase plane
===========

The colours say which mode follows; the line is a motion that runs through them.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.phase_plane(motions=[motion])
plt.show()
