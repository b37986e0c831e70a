"""
A film of a motion
==================

A second of film is a second of motion; it slows down around the take-off.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
path = hh.animate.film(
    motion,
    "hop.mp4",
    hh.animate.Timing(fps=25, slow_at="takeoff", slow_factor=4),
    hh.animate.Look(size=(640, 360)),
)
