"""Files of a motion for download, made in memory or in a folder of their own that is gone afterwards."""

from __future__ import annotations

import csv
import io
import json
import tempfile
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import NamedTuple

import numpy as np

from hophoop._extras import need
from hophoop.lab.limits import Limits, TooMuch, within
from hophoop.scenario import Scenario
from hophoop.simulation import simulate

SAMPLES_PER_SECOND = 200


class Kind(NamedTuple):
    """How a file is made, and what it is."""

    make: Callable[[Scenario, Limits], bytes]
    media_type: str


def toml(scenario: Scenario, limits: Limits) -> bytes:
    """The scenario file."""
    return scenario.to_toml().encode()


def result(scenario: Scenario, limits: Limits) -> bytes:
    """The result file in JSON."""
    return json.dumps(simulate(within(scenario, limits)).to_dict(), indent=1, ensure_ascii=False).encode()


def table(scenario: Scenario, limits: Limits) -> bytes:
    """Sampled states as CSV; the unit stands in each column's heading."""
    motion = simulate(within(scenario, limits))
    count = min(max(int(motion.duration * SAMPLES_PER_SECOND) + 1, 2), limits.samples)
    sample = motion.at(motion.times(count))
    names = [field.name for field in fields(sample)]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([f"{name} [{UNITS[name]}]" if UNITS[name] else name for name in names])
    # tolist: plain numbers, written with all their digits
    writer.writerows(zip(*(np.asarray(getattr(sample, name)).tolist() for name in names), strict=True))
    return text.getvalue().encode()


UNITS = {
    "t": "s", "mode": "", "x": "m", "height": "m", "angle": "rad", "vx": "m/s", "vy": "m/s", "omega": "rad/s",
    "slip": "m/s", "friction_force": "N", "normal_force": "N", "kinetic": "J", "potential": "J", "friction": "J",
    "impact_normal": "J", "impact_tangential": "J", "spring": "J", "damping": "J",
}  # fmt: skip


def netcdf(scenario: Scenario, limits: Limits) -> bytes:
    """The motion as netCDF, as `hophoop.load` reads it."""
    return _through_file(simulate(within(scenario, limits)).save, "motion.nc")


def mp4(scenario: Scenario, limits: Limits) -> bytes:
    """A film."""
    return _film(scenario, limits, "motion.mp4")


def gif(scenario: Scenario, limits: Limits) -> bytes:
    """A film as GIF."""
    return _film(scenario, limits, "motion.gif")


def _film(scenario: Scenario, limits: Limits, name: str) -> bytes:
    if scenario.duration > limits.film:
        raise TooMuch(
            f"duration = {scenario.duration:g} must be at most {limits.film:g} s for a film from the lab."
        )
    motion = simulate(within(scenario, limits))
    export = need("hophoop.animate", "films").animate
    return _through_file(lambda path: export(motion, path), name)


def _through_file(write: Callable[[Path], object], name: str) -> bytes:
    with tempfile.TemporaryDirectory(prefix="hophoop-lab-") as folder:
        path = Path(folder) / name
        write(path)
        return path.read_bytes()


KINDS = {
    "motion.toml": Kind(toml, "application/toml"),
    "motion.json": Kind(result, "application/json"),
    "motion.csv": Kind(table, "text/csv; charset=utf-8"),
    "motion.nc": Kind(netcdf, "application/x-netcdf"),
    "motion.mp4": Kind(mp4, "video/mp4"),
    "motion.gif": Kind(gif, "image/gif"),
}
