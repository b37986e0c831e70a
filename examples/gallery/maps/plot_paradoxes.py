"""
Starts that meet Painlevé's paradox
===================================

Hoops that are thrown faster than they can roll, over friction and load.
``least_jam_speed`` is the speed below which energy forbids a jam.
"""

import matplotlib.pyplot as plt

import hophoop as hh

found = hh.maps.sweep(
    None,
    {
        "hoop.load_fraction": hh.maps.linear(0.8, 0.99, 20),
        "plane.mu": hh.maps.linear(0.05, 1.0, 20),
        "start.speed": hh.maps.linear(4.0, 12.0, 12),
    },
    quantities=["status"],
    span="duration",
)
jams = found["status"] == hh.maps.words_of(found["status"]).index("jammed")
speed = hh.theory.least_jam_speed(hh.Hoop.ideal(0.75))
print(f"with three quarters in the load: no jam below {speed:.3f} m/s")
figure, ax = plt.subplots(figsize=(6, 3.8), layout="constrained")
shown = ax.pcolormesh(
    found["hoop.load_fraction"],
    found["plane.mu"],
    100 * jams.mean("start.speed").transpose("plane.mu", "hoop.load_fraction"),
    shading="nearest",
    rasterized=True,
)
figure.colorbar(shown, label="Thrown hoops that end in a jam (%)")
ax.set(xlabel="Load fraction γ", ylabel="Friction μ")
plt.show()
