"""What tests of the command line share."""

import shlex

import numpy as np
from typer.testing import CliRunner

import hophoop as hh
from hophoop.cli import app
from hophoop.tracking.table import track_of

HOP = "run --v0 3.1 --duration 2"


def run(line, *more, text=None):
    """Run a command line, as one types it behind 'hophoop'; what follows it stays as it is, such as names of files."""
    return CliRunner().invoke(app, [*shlex.split(line), *map(str, more)], input=text)


def done(line, *more):
    """The same for one that has to succeed."""
    found = run(line, *more)
    assert found.exit_code == 0, found.output
    return found


def hop():
    return hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0), hh.Start.rolling(3.1), duration=2.0)


def save_track(path):
    """A table of a hoop with a load fraction of 0.6, places and angles with errors of 1 mm and 1 mrad."""
    motion = hh.simulate(hh.Hoop.ideal(0.6, radius=0.3), hh.Plane(mu=0.8), hh.Start.rolling(1.5, angle=0.2), duration=0.4)
    t, rng = np.arange(48) / 120, np.random.default_rng(1)
    state = motion.at(t)
    columns = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    columns = {name: values + rng.normal(0, 1e-3, 48) for name, values in columns.items()}
    columns |= {f"sigma_{name}": np.full(48, 1e-3) for name in columns}
    track_of(t, columns, radius=0.3, placed=True).save(path)
    return path
