"""
The path
========

Traces of the load (black) and of the centre of gravity (green, red while airborne).
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.path(motion)
