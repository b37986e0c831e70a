"""
Starts that meet Painlevé's paradox
===================================

Hoops that are thrown faster than they can roll, over friction and load.
``least_jam_speed`` is the speed below which energy forbids a jam.
"""

import matplotlib.pyplot as plt

import hophoop as hh

found = hh.maps.paradoxes(
    hh.maps.linear(0.8, 0.99, 20),
    hh.maps.linear(0.05, 1.0, 20),
    speeds=hh.maps.linear(4.0, 12.0, 12),
    hops=True,
)
speed = hh.maps.least_jam_speed(hh.Hoop.ideal(0.75))
print(f"with three quarters in the load: no jam below {speed:.3f} m/s")
figure, ax = plt.subplots(figsize=(6, 3.8), layout="constrained")
shown = ax.pcolormesh(
    found["load_fraction"],
    found["friction"],
    100 * found["jammed"].T,
    shading="nearest",
    rasterized=True,
)
figure.colorbar(shown, label="Thrown hoops that end in a jam (%)")
ax.set(xlabel="Load fraction γ", ylabel="Friction μ")
plt.show()
