"""
The picture of a link's preview
===============================

What networks show beside a link to the lab: a computed hop, 1200 × 630 pixels in few colours.
"""

import io
import sys

import matplotlib.pyplot as plt
from PIL import Image

import hophoop as hh
from hophoop import plots

WIDE, HIGH, DPI = 1200, 630, 100  # pixels, and pixels per inch
COLORS = 64

figure = plt.figure(figsize=(WIDE / DPI, HIGH / DPI), dpi=DPI)
axes = figure.add_axes((0.0, 0.0, 1.0, 0.86))
plots.strobe(hh.simulate(hh.article.scenarios()["hop"]), start=0.7, end=1.9, every=0.2, ax=axes)
for other in figure.axes[1:]:  # the scale of speeds
    other.remove()
for named in (axes.get_legend(), *figure.legends):
    if named is not None:
        named.remove()
axes.set_axis_off()
axes.set_anchor("S")
figure.text(0.035, 0.9, "The hopping hoop", fontsize=30, fontweight="bold")
figure.text(0.965, 0.9, "exact motion, live", fontsize=24, color="#5a606a", ha="right")

# %%
# Give a file name to keep it, such as `src/hophoop/lab/static/preview.png`.

if len(sys.argv) > 1:
    drawn = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=DPI)
    Image.open(drawn).convert("RGB").quantize(COLORS, dither=Image.Dither.NONE).save(sys.argv[1], optimize=True)
