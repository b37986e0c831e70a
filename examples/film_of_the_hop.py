"""The hop on film: in 2D with plots beside it and slow motion, compared with less friction, in 3D, and as a still.

Run it as it is, or with a folder to write to and the width of the films in pixels:

    python examples/film_of_the_hop.py films 1280
"""

import sys
from pathlib import Path

import hophoop as hh
from hophoop.animate import Look, Look3D, Timing

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "films")
folder.mkdir(parents=True, exist_ok=True)
width = int(sys.argv[2]) if len(sys.argv) > 2 else 320
size = (width, width * 9 // 16 // 2 * 2)

hoop = hh.Hoop.ideal(load_fraction=0.75)
motion = hh.simulate(hoop, hh.Plane(mu=1.0), hh.Start.rolling(speed=3.1), duration=2.0)
slippery = hh.simulate(hoop, hh.Plane(mu=0.5), hh.Start.rolling(speed=3.1), duration=2.0)

panels = ("velocity", "energy", "utilization", "phase")
# Real time, but eight times slower around the take-off.
hh.animate.film(motion, folder / "hop.mp4", Timing(fps=30, slow_at="takeoff"), Look(size=size, panels=panels))

# What friction changes: the same start on two planes, in one view, as a gif.
hh.animate.film([motion, slippery], folder / "friction.gif", look=Look(size=size, layout="overlay", camera="hold"))

# In 3D: a film, and a page that plays and turns in any browser.
hh.animate.film_3d(motion, folder / "hop-3d.mp4", Timing(fps=10), Look3D(size=size, camera="orbit"))
hh.animate.scene(motion, folder / "hop.html", Timing(slow_at="takeoff"))

# For print: the hoop every 45 degrees.
hh.plots.strobe(motion, every_deg=45).figure.savefig(folder / "hop.png", dpi=150)

for path in sorted(folder.iterdir()):
    print(f"{path}: {path.stat().st_size / 1000:.0f} kB")
