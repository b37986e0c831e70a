"""
Two plots in one figure
=======================

Every function takes ``ax=``. The colours of modes and of classes of motion are :mod:`hophoop.plots.colors` and
:func:`hophoop.plots.class_color`.
"""

import matplotlib.pyplot as plt

import hophoop as hh

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6), layout="constrained")
for speed in (2.8, 3.1, 3.4):
    motion = hh.simulate(hh.Scenario(start=hh.Start.rolling(speed), duration=2.0))
    state = motion.at(motion.times(400))
    color = hh.plots.class_color(motion.sequence)
    left.plot(state.x, state.height, color=color, label=f"{speed} m/s: {motion.sequence}")
left.set(xlabel="x (m)", ylabel="gap (m)")
left.legend()
hh.plots.gap(motion, ax=right)
right.lines[0].set_color(hh.plots.colors.BLACK)
