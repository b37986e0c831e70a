"""
Velocities with uncertainty bands
=================================

Two standard deviations to both sides, where friction and the speed at the start are
known only so well.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
uncertainty = motion.uncertainty({"plane.mu": 0.02, "start.speed": 0.03})
hh.plots.velocities(motion, uncertainty=uncertainty)
plt.show()
