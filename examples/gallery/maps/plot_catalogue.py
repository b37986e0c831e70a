"""
The catalogue of first turns
============================

All sequences of phases that the article's hoop has in its first turn, with a start for each. ``catalogued`` lists the loads
for which there is a catalogue.
"""

import matplotlib.pyplot as plt

import hophoop as hh

entries = hh.maps.catalogue()
print(len(entries), "sequences; catalogues for", hh.maps.catalogued())
figure, ax = plt.subplots(figsize=(6, 3.6), layout="constrained")
for entry in entries:
    ax.plot(entry.mu, entry.speed, "o", color=hh.plots.class_color(entry.sequence))
ax.set(xlabel="friction μ", ylabel="speed at the start (m/s)")
