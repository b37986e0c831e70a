"""
One boundary: the least speed that hops
=======================================

``boundary`` follows the border between two points of different classes: here the
least speed that hops, over friction.
"""

import matplotlib.pyplot as plt

import hophoop as hh

border = hh.maps.boundary(
    None,
    {"plane.mu": (0.05, 1.5), "start.speed": (2.0, 3.6)},
    one=(0.5, 2.2),
    other=(0.5, 3.4),
    quantity="hop",
    step=0.05,
)
figure, ax = plt.subplots(figsize=(6, 3.6), layout="constrained")
ax.plot(border.x, border.y, color="black")
ax.set(xlabel="Friction μ", ylabel="Least speed $v_0$ that hops (m/s)")
plt.show()
