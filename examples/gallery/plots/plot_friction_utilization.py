"""
Friction utilization
====================

The share of the possible friction that is in use: 1 where the rim slips. Here for
two speeds: the slower hoop rolls.
"""

import matplotlib.pyplot as plt

import hophoop as hh

fast = hh.simulate(hh.Scenario(duration=1.0))
slow = hh.simulate(hh.Scenario(start=hh.Start.rolling(1.5), duration=2.5))
hh.plots.friction_utilization([slow, fast], labels=["1.5 m/s", "3.1 m/s"])
plt.show()
