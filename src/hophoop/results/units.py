"""SI values of the kernel units: the hoop's radius and mass, and √(R/g)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.model import Scales, scales_from
from hophoop.kernel.native import compiled
from hophoop.kernel.records import kernel_times
from hophoop.scenario import Scenario
from hophoop.scenario.scenario import time_unit
from hophoop.vocabulary.quantities import sizes


@dataclass(frozen=True)
class Units:
    """SI values of the kernel units."""

    length: float
    time: float
    mass: float

    @classmethod
    def of_scenario(cls, scenario: Scenario) -> Units:
        """Return the units of a scenario."""
        return cls(scenario.hoop.radius, time_unit(scenario.hoop, scenario.plane), scenario.hoop.mass)

    @cached_property
    def scales(self) -> Scales:
        """All units, as the kernels have them."""
        found: Scales = scales_from(self.length, self.time, self.mass)
        return found

    @property
    def energy(self) -> float:
        """Unit of energy [J]."""
        return self.scales.energy

    def kernel_times(self, segments: np.ndarray, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """Convert times to kernel units, on the same side of each event as in seconds.

        segments: segments of the motion; times [s]; result: at most the end of the motion [√(R/g)].
        """
        found: NDArray[np.float64] = np.empty(times.shape)
        compiled(kernel_times)(np.ascontiguousarray(segments["t"]), float(segments["t_end"][-1]), times, self.time, found)
        return found

    def of(self, name: str) -> float:
        """Return the unit of a quantity by its name.

        name: name of a column or of an event's field, such as 'vx'; unit: size of a kernel unit in the SI unit [1].
        """
        found: float | None = self._sizes.get(name)
        if found is None:
            raise ValueError(f"{name!r} has no unit: the quantities are {', '.join(self._sizes)}.")
        return found

    @cached_property
    def _sizes(self) -> dict[str, float]:
        return sizes(self.scales)
