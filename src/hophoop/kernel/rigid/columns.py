"""Columns of a sample, in kernel units."""

COLUMNS = (
    "mode", "x", "height", "angle", "vx", "vy", "omega", "slip",
    "friction_force", "normal_force", "friction", "impact_normal", "impact_tangential", "theta", "theta_low",
    "rolling_resistance", "kinetic", "potential",
)  # fmt: skip
