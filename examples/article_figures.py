"""
The hop, drawn
==============

The article's motion at 3.1 m/s: the path with the hoop at its events, its velocities, its energy balance and
its way through the (θ, θ̇) plane.
"""

import math

import matplotlib.pyplot as plt

import hophoop as hh
from hophoop import plots

motion = hh.simulate(hh.article.scenarios()["hop"])
print(motion)

# %%
# Each function draws on the axes that it is given, or on those of a new figure, and returns them.

plots.path(motion)

# %%
# In flight the rotation is constant; the centre's velocity is not, since it goes round the centre of gravity.

figure, (above, below) = plt.subplots(2, 1, figsize=(7.5, 8.0), layout="constrained")
plots.velocities(motion, "angle", ax=above)
plots.energies(motion, "angle", ax=below)

# %%
# The hoop takes off where its path, spinning, crosses the border of lift-off.

plots.phase_plane(motions=[motion], labels=["3.1 m/s"], angles=(0.0, math.radians(540.0)))

plt.show()
