"""
In space
========

Rendered off screen, without a graphics card if need be.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
timing = hh.animate.Timing(fps=10, start=0.8, end=2.0)
path = hh.animate.film_3d(
    motion, "hop-3d.mp4", timing, hh.animate.Look3D(size=(480, 270), camera="side")
)
