"""Error estimates of the events of a motion."""

from __future__ import annotations

from collections.abc import Callable

from hophoop._support.errors import InputError
from hophoop._support.progress import compute_reporting
from hophoop.results.records import EventErrors, Motion


def event_errors(motion: Motion, progress: Callable[[float], object] | None = None) -> EventErrors:
    """Compute `Trajectory.errors`.

    progress: Called with the share that is computed, 0 to 1: about ten times a second, and at the end.
    """
    if motion.scenario.contact.model != "rigid":
        raise InputError("motion.errors needs rigid contact; in compliant contact contact.rtol controls the error.")
    from hophoop.kernel.rigid import errors

    unit = motion.units
    given = (motion.scenario.to_body(), motion.tables["events"], motion.scenario.duration / unit.time)
    if progress is None:
        table = errors.event_errors(*given)
    else:
        table = compute_reporting(lambda share: errors.event_errors(*given, share), progress)
        progress(1.0)
    return EventErrors(**{name: table[:, i] * unit.of(name) for i, name in enumerate(errors.FIELDS)})
