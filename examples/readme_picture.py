"""
The picture of the README
=========================

A stroboscopic still of the article's hop: rolling from the top at 3.1 m/s on μ = 1.
"""

import sys

import hophoop as hh
from hophoop import plots

scenario = hh.article.scenarios()["hop"].replace("duration", 2.0)
axes = plots.strobe(hh.simulate(scenario))

# %%
# Give a file name to keep it.

if len(sys.argv) > 1:
    axes.figure.savefig(sys.argv[1], dpi=110)
