"""
Two plots in one figure
=======================

Every function takes ``ax=``. Left, three motions drawn by hand, in the inks that
:mod:`hophoop.plots.colors` has for lines that mean no mode.
"""

import matplotlib.pyplot as plt

import hophoop as hh

figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.6), layout="constrained")
for speed, ink, dashes in zip(
    (2.8, 3.1, 3.4), hh.plots.colors.SERIES, ("-", "--", "-."), strict=False
):
    motion = hh.simulate(hh.Scenario(start=hh.Start.rolling(speed), duration=2.0))
    state = motion.at(motion.times(400))
    left.plot(
        state.x,
        state.height,
        dashes,
        color=ink,
        label=f"{speed} m/s: {motion.sequence}",
    )
left.set(xlabel="Place along the plane (m)", ylabel="Gap under the rim (m)")
left.legend(loc="upper left", frameon=False)
hh.plots.gap(motion, ax=right)
plt.show()
