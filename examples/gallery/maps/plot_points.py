"""
Scattered points: uncertain friction and speed
==============================================

``points`` computes any list of parameters: here a thousand hoops with uncertain
friction and speed. ``scenario_at`` gives one of them as a scenario.
"""

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh

draw = np.random.default_rng(7)
values = {
    "plane.mu": draw.normal(1.0, 0.05, 1000),
    "start.speed": draw.normal(3.1, 0.05, 1000),
}
found = hh.maps.points(None, values, ["hop_height"])
figure, ax = plt.subplots(figsize=(6, 3.6), layout="constrained")
shown = ax.scatter(
    values["plane.mu"], values["start.speed"], c=100 * found["hop_height"], s=8
)
figure.colorbar(shown, label="Height of the hop (cm)")
ax.set(xlabel="Friction μ", ylabel="Speed at the start $v_0$ (m/s)")

highest = int(np.nanargmax(found["hop_height"]))
print(
    hh.maps.scenario_at(
        hh.Scenario(), {path: value[highest] for path, value in values.items()}
    )
)
plt.show()
