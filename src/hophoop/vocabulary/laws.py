"""Laws of impact, one row of a table each.

A new law needs a member of the kernel's `ImpactLaw`, its name in `Plane.impact_law`, a row of `LAWS` and its mechanics.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from hophoop.kernel.physics.body import ImpactLaw


class Law(NamedTuple):
    """A law of impact: what ends its restitution."""

    code: int  # the kernels' number
    label: str  # in the lab
    reference: tuple[str, str] | None = None  # key of the reference, and what it is cited for


LAWS: Final[dict[str, Law]] = {
    "stronge": Law(int(ImpactLaw.STRONGE), "Stronge (energy)", ("Stronge2000", "energetic restitution")),
    "newton": Law(int(ImpactLaw.NEWTON), "Newton (velocity)"),
    "poisson": Law(int(ImpactLaw.POISSON), "Poisson (impulse)"),
}
"""By name in scenarios, the default first."""
LATEST_FIRST: Final = tuple(sorted(LAWS, key=lambda name: -LAWS[name].code))
"""Names in the order of the lab."""
NAMED: Final = f"{', '.join(list(LAWS)[:-1])} or {list(LAWS)[-1]}"
"""All names in words, for help texts."""
