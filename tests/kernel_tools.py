"""Programs in a Python of their own, with these sources."""

import os
import subprocess
import sys
from pathlib import Path

import hophoop as hh

SHORT = "import hophoop as hh; print(hh.simulate(hh.Scenario(duration=0.1)).sequence)"


def started(*arguments, **environment):
    """What Python says and how it ends, with these sources and these variables of the environment."""
    path = os.pathsep.join([str(Path(hh.__file__).parents[1]), str(Path(__file__).parent)])
    surroundings = os.environ | {"PYTHONPATH": path} | environment
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False, env=surroundings)


def python(code, **environment):
    """The same of a program."""
    return started("-c", code, **environment)
