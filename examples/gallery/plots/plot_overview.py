"""
A motion on one page
====================

Path, velocities, energies and forces together.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
hh.plots.overview(motion)
