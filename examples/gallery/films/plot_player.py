"""
A film in a notebook
====================

In a notebook the film plays in its cell and is part of the page; nothing is
fetched.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(plane=hh.Plane(restitution=0.5), duration=2.5))
hh.animate.player(
    motion, hh.animate.Timing(fps=25), hh.animate.Look(size=(640, 360))
)
