"""
A single frame
==============

The state at one time as an array of pixels, here on a dark background.
"""

import matplotlib.pyplot as plt

import hophoop as hh

motion = hh.simulate(hh.Scenario(duration=2.0))
pixels = hh.animate.picture(
    motion, 1.3, hh.animate.Look(size=(960, 540), theme="dark")
)
figure = plt.figure(figsize=(9.6, 5.4))
ax = figure.add_axes((0, 0, 1, 1))
ax.imshow(pixels)
ax.axis("off")
plt.show()
