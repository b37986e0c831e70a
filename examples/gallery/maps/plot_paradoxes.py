"""
Starts that meet Painlevé's paradox
===================================

Hoops that are thrown faster than they can roll, over friction and load. ``least_jam_speed`` is the speed below which energy
forbids a jam.
"""

import hophoop as hh

found = hh.maps.paradoxes(
    hh.maps.linear(0.8, 0.99, 20), hh.maps.linear(0.05, 1.0, 20), speeds=hh.maps.linear(4.0, 12.0, 12), hops=True
)
print(f"no jam below {hh.maps.least_jam_speed(hh.Hoop.ideal(0.75)):.3f} m/s for the article's hoop")
found["jammed"].plot(x="load_fraction")
