"""What tests of `hophoop run` share."""

from typer.testing import CliRunner

import hophoop as hh
from hophoop.cli import app

HOP = ["--v0", "3.1", "--duration", "2"]


def run(*arguments, text=None):
    return CliRunner().invoke(app, [str(one) for one in arguments], input=text)


def hop():
    return hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0), hh.Start.rolling(3.1), duration=2.0)
