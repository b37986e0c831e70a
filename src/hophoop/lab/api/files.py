"""Files of a motion for download, made in memory or in a temporary folder."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from hophoop._support.stopping import temporary_folder
from hophoop.io import write_csv
from hophoop.lab.api.limits import Limits, TooMuch, within
from hophoop.scenario import Scenario
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary.sentences import LAB

SAMPLES_PER_SECOND = 200
FILM_SIZE, FILM_RATE = (960, 540), 25


class Kind(NamedTuple):
    """How a file is made, and its media type; a slow one takes many seconds."""

    make: Callable[[Scenario, Limits], bytes]
    media_type: str
    slow: bool = False


def toml(scenario: Scenario, limits: Limits) -> bytes:
    """Return the scenario file."""
    return scenario.to_toml().encode()


def result(scenario: Scenario, limits: Limits) -> bytes:
    """Return the result file in JSON."""
    return json.dumps(simulate(within(scenario, limits)).to_dict(), indent=1, ensure_ascii=False).encode()


def table(scenario: Scenario, limits: Limits) -> bytes:
    """Return sampled states as CSV; each column's heading contains the unit."""
    motion = simulate(within(scenario, limits))
    count = min(max(int(motion.duration * SAMPLES_PER_SECOND) + 1, 2), limits.samples)
    return _through_file(lambda path: write_csv(motion, path, motion.times(count)), "motion.csv")


def netcdf(scenario: Scenario, limits: Limits) -> bytes:
    """Return the motion as netCDF for `hophoop.load`."""
    return _through_file(simulate(within(scenario, limits)).save, "motion.nc")


def mp4(scenario: Scenario, limits: Limits) -> bytes:
    """Return a film."""
    return _film(scenario, limits, "motion.mp4")


def gif(scenario: Scenario, limits: Limits) -> bytes:
    """Return a film as GIF."""
    return _film(scenario, limits, "motion.gif")


def _film(scenario: Scenario, limits: Limits, name: str) -> bytes:
    if scenario.duration > limits.film:
        raise TooMuch(
            LAB["film_too_long"].format(duration=scenario.duration, most=limits.film),
            field="duration",
            value=scenario.duration,
        )
    from hophoop.animate import Look, Timing, film

    motion = simulate(within(scenario, limits))
    return _through_file(lambda path: film(motion, path, Timing(fps=FILM_RATE), Look(size=FILM_SIZE)), name)


def _through_file(write: Callable[[Path], object], name: str) -> bytes:
    with temporary_folder("hophoop-lab-") as folder:
        path = folder / name
        write(path)
        return path.read_bytes()


KINDS = {
    "motion.toml": Kind(toml, "application/toml"),
    "motion.json": Kind(result, "application/json"),
    "motion.csv": Kind(table, "text/csv; charset=utf-8"),
    "motion.nc": Kind(netcdf, "application/x-netcdf"),
    "motion.mp4": Kind(mp4, "video/mp4", slow=True),
    "motion.gif": Kind(gif, "image/gif", slow=True),
}
