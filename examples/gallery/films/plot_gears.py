"""
Gears: three stable gaits of one hoop
=====================================

A light load on a gentle slope has many stable gaits. Here the same hoop
hops once in 1, 2 and 5 revolutions.
"""

import math

import hophoop as hh

plane = hh.Plane(slope=math.radians(3))
light = hh.Scenario(hoop=hh.Hoop.ideal(load_fraction=0.15), plane=plane)
rates = (11.3, 19.3, 32.8)  # rad/s
gears = [hh.gaits.find(light, near=rate)[0].motion(12) for rate in rates]
look = hh.animate.Look(
    size=(960, 540), labels=("1 revolution", "2 revolutions", "5 revolutions")
)
path = hh.animate.film(gears, "gears.mp4", hh.animate.Timing(fps=25, end=5.0), look)
