"""Adapter that presents the record of an engine as a motion, for films."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from hophoop.engines.phases import WINDOW, normal_force, phases, slip_velocity, thin
from hophoop.engines.task import States, Task
from hophoop.results.records import ArraySample, Sample
from hophoop.scenario import Scenario


class RecordedMotion:
    """A record with the interface of a motion, without events.

    Parameters
    ----------
    scenario : Scenario
    task : Task
    record : States
    """

    events: tuple[Any, ...] = ()
    version = ""
    status = "completed"

    def __init__(self, scenario: Scenario, task: Task, record: States) -> None:
        self.scenario = scenario
        self.task = task
        self.states = thin(record)
        self.duration = float(min(self.states.t[-1], scenario.duration))
        self._phases, _ = phases(task, self.states)
        self.sequence = "".join(phase.letter for phase in self._phases)
        self._force = normal_force(task, self.states, WINDOW)

    def find(self, kind: str) -> tuple[Any, ...]:
        """Return no events."""
        return ()

    def at(self, t: ArrayLike, side: Literal["left", "right"] = "right") -> ArraySample:
        """Interpolate the record.

        Parameters
        ----------
        t : array_like
            [s].
        side : {'right', 'left'}
            Ignored.

        Returns
        -------
        sample : Sample
        """
        times, states, task = np.asarray(t, dtype=float), self.states, self.task
        fields = {name: np.interp(times, states.t, getattr(states, name)) for name in ("x", "angle", "vx", "vy", "omega")}
        slip = np.interp(times, states.t, slip_velocity(task, states))
        normal = np.maximum(np.interp(times, *self._force), 0.0)
        begins = np.array([phase.begin for phase in self._phases])
        letters = np.array([phase.letter for phase in self._phases])
        mode = letters[np.clip(np.searchsorted(begins, times, side="right") - 1, 0, len(letters) - 1)]
        zero = np.zeros(times.shape)
        return Sample(
            t=times, mode=mode, height=np.interp(times, states.t, states.y), slip=slip, normal_force=normal,
            friction_force=zero, kinetic=zero, potential=zero, friction=zero, impact_normal=zero, impact_tangential=zero,
            rolling_resistance=zero,
            spring=zero, damping=zero, **fields,
        )  # fmt: skip
