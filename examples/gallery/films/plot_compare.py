"""
Compare two motions in one film
===============================

The same hoop on a rough and on a smoother floor.
"""

import hophoop as hh

rough = hh.simulate(hh.Scenario(duration=2.0))
smooth = hh.simulate(hh.Scenario(plane=hh.Plane(mu=0.4), duration=2.0))
look = hh.animate.Look(size=(640, 480), labels=("μ = 1", "μ = 0.4"))
path = hh.animate.film(
    [rough, smooth], "friction.mp4", hh.animate.Timing(fps=25), look
)
