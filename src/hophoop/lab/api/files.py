"""Files of a motion that need Python: netCDF and films, made in a temporary folder."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final

from hophoop._support.stopping import temporary_folder
from hophoop.lab.api.limits import FILM, LAB, TooMuch, within
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory

TYPES: Final = {"motion.nc": "application/x-netcdf", "motion.mp4": "video/mp4", "motion.gif": "image/gif"}
"""Name of a file → its media type."""

FILM_SIZE, FILM_RATE = (960, 540), 25


def make(name: str, scenario: Scenario) -> bytes:
    """Compute a motion and return it as a file.

    Parameters
    ----------
    name : {'motion.nc', 'motion.mp4', 'motion.gif'}
    scenario : Scenario

    Returns
    -------
    content : bytes

    Raises
    ------
    ValueError
        If there is no such file, or the motion exceeds the lab's limits.
    ImportError
        If a library of an extra is missing.
    """
    if name not in TYPES:
        raise InputError.of_field("name", name, f"one of {', '.join(TYPES)}")
    write: Callable[[Trajectory, Path], object] = Trajectory.save
    if name != "motion.nc":
        if scenario.duration > FILM:
            raise TooMuch(LAB["film_too_long"].format(duration=scenario.duration, most=FILM))
        from hophoop.animate import Look, Timing, film

        write = lambda motion, path: film(motion, path, Timing(fps=FILM_RATE), Look(size=FILM_SIZE))  # noqa: E731
    motion = simulate(within(scenario))
    with temporary_folder("hophoop-lab-") as folder:
        write(motion, folder / name)
        return (folder / name).read_bytes()
