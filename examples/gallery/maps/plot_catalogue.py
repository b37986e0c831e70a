"""
Catalogue of first turns
========================

All sequences of phases that the article's hoop has in its first turn, with a start
for each and the share of all starts that it fills. ``catalogued`` lists the loads
for which there is a catalogue.
"""

import matplotlib.pyplot as plt

import hophoop as hh

entries = hh.maps.catalogue()
print(len(entries), "classes; catalogues for", hh.maps.catalogued())
third = entries[2]
print(
    f"{third.sequence}, {third.ending}: μ = {third.mu:.3f}, {third.speed:.3f} m/s"
)
figure, ax = plt.subplots(figsize=(7, 7), layout="constrained")
names = [f"{entry.sequence}, {entry.ending}" for entry in entries]
ax.barh(
    names,
    [100 * entry.area for entry in entries],
    color=[hh.plots.class_color(entry.sequence) for entry in entries],
)
ax.set_xscale("log")
ax.invert_yaxis()
ax.tick_params(axis="y", labelsize=8)
ax.set_xlabel("Share of the window of friction and speed (%)")
plt.show()
