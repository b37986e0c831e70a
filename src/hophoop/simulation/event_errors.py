"""Error estimates of the events of a motion."""

from __future__ import annotations

import numpy as np

from hophoop._support.errors import InputError
from hophoop.results.records import EventErrors, Motion


def event_errors_watched(motion: Motion, reached: np.ndarray | None = None) -> EventErrors:
    """Compute `Trajectory.errors`, and write the progress for another thread.

    Parameters
    ----------
    motion : Motion
    reached : ndarray, shape (1,), optional
        Progress: receives the computed fraction [1].

    Returns
    -------
    errors : EventErrors

    Raises
    ------
    ValueError
        If the contact is compliant.
    """
    if motion.scenario.contact.model != "rigid":
        raise InputError("motion.errors needs rigid contact; in compliant contact contact.rtol controls the error.")
    from hophoop.kernel.rigid.errors import FIELDS, event_errors

    unit = motion.units
    events = motion.tables["events"]
    table = event_errors(motion.scenario.to_body(), events, motion.scenario.duration / unit.time, reached)
    return EventErrors(**{name: table[:, i] * unit.of(name) for i, name in enumerate(FIELDS)})
