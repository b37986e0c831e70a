"""
A film in 3D
============

Rendered off screen, without a graphics card if need be.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
timing = hh.animate.Timing(fps=20, start=0.8, end=2.0)
path = hh.animate.film_3d(
    motion, "hop-3d.mp4", timing, hh.animate.Look3D(size=(800, 450), camera="side")
)
