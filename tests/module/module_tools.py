"""Scenarios as the numbers that the module takes."""

import math

import hophoop as hh
from hophoop.maps.grid.cells import make_cells


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
