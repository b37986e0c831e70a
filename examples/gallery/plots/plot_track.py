"""
A track over time
=================

What a film or a table of positions holds. Here the table is computed: 60 pictures a
second with errors of 1 mm.
"""

from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.tracking import Reading

scenario = hh.Scenario(
    hoop=hh.Hoop.ideal(0.6, radius=0.3), start=hh.Start.rolling(1.9)
)
t = np.arange(0.0, 1.0, 1 / 60)
state = hh.simulate(scenario).at(t)
errors = np.random.default_rng(1).normal(0.0, 1e-3, (2, len(t)))
columns = [t, state.x + errors[0], state.height + 0.3 + errors[1], state.angle]
with TemporaryDirectory() as folder:
    file = Path(folder) / "table.csv"
    head = "t (s),x (m),y (m),angle (rad)"
    np.savetxt(file, np.transpose(columns), delimiter=",", header=head, comments="")
    track = hh.read_track(file, Reading(radius=0.3))
hh.plots.track(track)
plt.show()
