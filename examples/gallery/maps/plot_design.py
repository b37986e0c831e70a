"""
The best for a purpose
======================

The slowest start whose hop lands with the load at the bottom: SciPy's SLSQP chooses
friction and speed, and ``sensitivity`` gives it exact derivatives. They hold inside
a class of motions; at a boundary the search stops. It is a search and no proof.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize

import hophoop as hh

BOTTOM = 3 * np.pi  # where the load is when the hoop lands [rad]
LIMITS = {"plane.mu": (0.1, 1.0), "start.speed": (2.6, 3.6)}
reference = hh.Scenario(duration=2.2)


def landing_angle(values):
    """The landing angle [rad], and its derivatives by friction and speed."""
    given = dict(zip(LIMITS, values.tolist(), strict=True))
    motion = hh.simulate(reference.with_values(given))
    result = motion.sensitivity("hop.landing_angle", list(LIMITS))
    return result.values[0], result.derivatives[0]


tried = [np.array([0.9, 3.2])]
best = minimize(
    lambda values: values[1],
    tried[0],
    jac=lambda values: np.array([0.0, 1.0]),
    bounds=LIMITS.values(),
    constraints={
        "type": "eq",
        "fun": lambda values: landing_angle(values)[0] - BOTTOM,
        "jac": lambda values: landing_angle(values)[1],
    },
    method="SLSQP",
    callback=lambda values: tried.append(values.copy()),
)

axes = {path: hh.maps.linear(*limits, 120) for path, limits in LIMITS.items()}
dataset = hh.maps.sweep(reference, axes, ["landing_angle"], "duration")
turned = dataset["landing_angle"].values.T / np.pi
figure, ax = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
colours = ax.contourf(*axes.values(), turned, levels=16)
figure.colorbar(colours, label="Angle at the landing (π rad)")
ax.contour(*axes.values(), turned, levels=[3.0], colors="white")
ax.plot(*np.transpose(tried), color="black", marker=".")
ax.plot(*best.x, color="white", marker="*", markersize=14, markeredgecolor="black")
ax.set_title(f"μ = {best.x[0]:.4f}, $v_0$ = {best.x[1]:.4f} m/s")
ax.set(xlabel="Friction μ", ylabel="Speed $v_0$ (m/s)")
plt.show()
