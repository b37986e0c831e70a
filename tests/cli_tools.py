"""What tests of the command line share."""

import shlex

from typer.testing import CliRunner

import hophoop as hh
from fitting_tools import filmed
from hophoop.cli import app

HOP = "run --v0 3.1 --duration 2"


def run(line, *more, text=None):
    """Run a command line, as one types it behind 'hophoop'; what follows it stays as it is, such as names of files."""
    return CliRunner().invoke(app, [*shlex.split(line), *map(str, more)], input=text)


def done(line, *more, status=0):
    """The same for one that has to end with this status."""
    found = run(line, *more)
    assert found.exit_code == status, found.output
    return found


def hop():
    return hh.simulate(hh.Scenario(duration=2.0))


def save_track(path):
    """A table of a hoop with a load fraction of 0.6, places and angles with errors of 1 mm and 1 mrad."""
    motion = hh.simulate(
        hh.Scenario.from_query(
            "duration=0.4&hoop.radius=0.3&hoop.load_fraction=0.6&plane.mu=0.8&start.angle=0.2&start.speed=1.5"
        )
    )
    filmed(motion, rate=120.0, sigma_angle=1e-3).save(path)
    return path
