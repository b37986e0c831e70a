"""
The hoop and its parts
======================

Centre, centre of gravity, load and the forces of the contact, for any hoop. Here
one made of parts.
"""

import matplotlib.pyplot as plt

import hophoop as hh

hoop = hh.Hoop.from_parts(
    radius=0.3, parts=[hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27)]
)
hh.plots.geometry(hoop, angle=0.9)
plt.show()
