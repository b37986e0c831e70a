"""
An interactive 3D page
======================

A page of its own that plays in any browser, without the network: drag to turn,
space to play.
"""

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
page = hh.animate.scene(motion, "hop-scene.html")
