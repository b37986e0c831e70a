"""
The gap below the hoop
======================

How high the rim is above the ground. With restitution the landing is followed by smaller hops.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(plane=hh.Plane(restitution=0.5), duration=3.0))
hh.plots.gap(motion)
