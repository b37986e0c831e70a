"""Scenarios as the numbers that the module takes, and its calls in Node."""

import json
import math
import shutil
import subprocess
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.lab import tables
from hophoop.lab.wasm import stamp
from hophoop.maps.grid.cells import make_cells

KERNEL = tables.FILE.parent / "kernel.js"
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="Node is not installed")


def answered(calls, module=stamp.MODULE):
    """What the page's kernel answers to calls, each a name with its arguments; "inf" is infinite."""
    command = ["node", Path(__file__).with_name("calls.mjs"), KERNEL, stamp.HERE / module]
    done = subprocess.run(command, input=json.dumps(calls), capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def cell_of(scenario):
    """The row of `records.cells.CELL` of one scenario."""
    return make_cells(scenario, {}, 1)[:, 0]


def given_of(scenario):
    """A scenario as the page hands it to the kernel (`Given` of web/types.d.ts)."""
    hoop, plane, start, contact = scenario.hoop, scenario.plane, scenario.start, scenario.contact
    bound = None
    if contact.model == "compliant":
        names = ("stiffness", "damping", "restitution", "law", "friction", "slip_speed", "tangential_stiffness", "rtol")
        bound = {name: getattr(contact, name) for name in names}
    numbers = {
        **{name: getattr(hoop, name) for name in ("radius", "mass", "eccentricity", "inertia_ratio")},
        "ideal": hoop.load_fraction is not None,
        **{name: getattr(plane, name) for name in hh.Plane.model_fields if name != "mu"},
        **start.state(hoop)._asdict(),
        "mode": start.mode,
        "rolling": start.speed is not None,
        "duration": scenario.duration,
        "max_events": contact.max_events,
        "contact": bound,
    }
    return {name: "inf" if one == math.inf else one for name, one in numbers.items()}
