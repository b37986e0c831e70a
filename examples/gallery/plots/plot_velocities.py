"""
Velocities
==========

The velocity of the centre and the angular velocity. The ribbon at the top names the phases.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.velocities(motion)
