"""
A film that ends in a jam
=========================

The thrown hoop lands, skids, and comes to the dynamic jam: the normal force grows
without bound, its arrow leaves the picture, and rigid-body mechanics has no motion
beyond. The film stays there for a second.
"""

import hophoop as hh

motion = hh.simulate(
    hh.Hoop.ideal(load_fraction=0.85),
    hh.Plane(mu=0.8),
    hh.Start.rolling(8.9),
    duration=2.0,
)
print(motion.status)
path = hh.animate.film(
    motion,
    "jam.mp4",
    hh.animate.Timing(fps=25, slow_at="jam", slow_factor=5),
    hh.animate.Look(size=(640, 360)),
)
