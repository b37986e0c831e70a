"""
Logarithmic and logit axes
==========================

Logarithmic axes show little friction, and a logit axis loads with hardly any ring.
``words_of`` turns the codes of a map into words.
"""

import matplotlib.pyplot as plt

import hophoop as hh

dataset = hh.maps.sweep(
    hh.Scenario(start=hh.Start.rolling(2.5)),
    axes={
        "hoop.load_fraction": 1.0 - hh.maps.logarithmic(0.001, 0.9, 100)[::-1],
        "plane.mu": hh.maps.logarithmic(0.01, 3.0, 100),
    },
)
print(hh.maps.words_of(dataset["sequence"])[:8])
ax = hh.plots.motion_map(dataset, painleve=False)
ax.set_yscale("logit")
ax.set_yticks([0.1, 0.5, 0.9, 0.99, 0.999], ["0.1", "0.5", "0.9", "0.99", "0.999"])
ax.set_yticks([], minor=True)
plt.show()
