"""
Share of each class, by refinement
==================================

``refine`` halves only those squares whose corners differ, and says which share of
the window each class has.
"""

import matplotlib.pyplot as plt

import hophoop as hh

refined = hh.maps.refine(
    None, {"plane.mu": (0.02, 2.0), "start.speed": (0.05, 5.0)}, levels=4, cells=16
)
shares = sorted(refined.shares().items(), key=lambda entry: -entry[1][0])[:8]
figure, ax = plt.subplots(figsize=(6, 3.2), layout="constrained")
ax.barh(
    [name for name, _ in shares],
    [100 * share for _, (share, _) in shares],
    color=[hh.plots.class_color(name) for name, _ in shares],
)
ax.invert_yaxis()
ax.set_xlabel("Share of the window (%)")
plt.show()
