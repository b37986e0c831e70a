"""
A film with plots that run along
================================

What is still to come is pale. ``bar`` shows on a terminal how far the film is.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
look = hh.animate.Look(size=(960, 480), panels=("velocity", "energy", "phase"))
with hh.animate.bar("film") as progress:
    path = hh.animate.film(
        motion, "panels.mp4", hh.animate.Timing(fps=20), look, progress
    )
