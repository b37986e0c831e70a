"""Parts of a real hoop, and ε and κ of their sum."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Discriminator, model_validator

from hophoop.kernel.records import DISK, POINT_MASS, RADIAL_ROD, RING, TANGENTIAL_ROD, combined, part_inertia, part_reach
from hophoop.scenario.checking import Frozen, quantity, refuse, say
from hophoop.vocabulary.parameters import RANGES, Range

MASS, LENGTH = RANGES["hoop.parts.mass"], RANGES["hoop.parts.length"]

Row = tuple[int, float, float, float, float]

_LENGTHS = ("inner_radius", "outer_radius", "radius", "length")
_KINDS = {
    "ring": RING, "disk": DISK, "point_mass": POINT_MASS,
    "radial": RADIAL_ROD, "tangential": TANGENTIAL_ROD,
}  # fmt: skip

# Tolerance for a part that touches the rim, since its position is rounded.
TOUCH = 1e-12


class _Part(Frozen):
    """Base of all parts; a negative mass is a hole."""

    place: ClassVar[str] = "hoop.parts: "
    in_order: ClassVar[bool] = True

    @property
    def row(self) -> Row:
        """Its row in the table of parts of `kernel.records.cells`."""
        part: Any = self
        first, second, *_ = *(getattr(part, name) for name in _LENGTHS if hasattr(part, name)), 0.0, 0.0
        return _KINDS[getattr(part, "direction", part.shape)], part.mass, first, second, part.at

    @property
    def inertia(self) -> float:
        """Moment of inertia about its own centre [kg m²]."""
        shape, weight, first, second, _ = self.row
        return float(part_inertia(shape, weight, first, second))

    @property
    def reach(self) -> float:
        """Distance of its farthest point from C [m]."""
        shape, _, first, second, at = self.row
        return float(part_reach(shape, first, second, at))


class Ring(_Part):
    """A flat ring about the rim's centre C; thin if both radii are equal.

    Parameters
    ----------
    mass : float
        Its mass; negative for a hole [kg].
    inner_radius, outer_radius : float
        Its radii [m].

    Raises
    ------
    ValueError
        If outer_radius is not positive, or inner_radius is negative or exceeds outer_radius.
    """

    mass: float = quantity(..., "Mass of the ring", "kg", MASS)
    # of a full disk it is 0
    inner_radius: float = quantity(..., "Inner radius of the ring", "m", Range(0.0, LENGTH.most))
    outer_radius: float = quantity(..., "Outer radius of the ring", "m", LENGTH)
    shape: Literal["ring"] = quantity("ring", "Kind of part", "")

    @model_validator(mode="after")
    def _ordered(self) -> Ring:
        if self.inner_radius > self.outer_radius:
            raise refuse(say("ring_radii", inner=self.inner_radius, outer=self.outer_radius))
        return self

    @property
    def at(self) -> float:
        """Distance of its centre from C: 0 [m]."""
        return 0.0


class Disk(_Part):
    """A uniform disk, such as a cylindrical load seen from its end, or a round hole.

    Parameters
    ----------
    mass : float
        Its mass; negative for a hole [kg].
    radius : float
        Its radius [m].
    at : float, default 0
        Signed distance of its centre from C, on the line from C to the load [m].

    Raises
    ------
    ValueError
        If radius is not positive.
    """

    mass: float = quantity(..., "Mass of the disk", "kg", MASS)
    radius: float = quantity(..., "Radius of the disk", "m", LENGTH)
    at: float = quantity(0.0, "Signed distance of the disk's centre from C", "m")
    shape: Literal["disk"] = quantity("disk", "Kind of part", "")


class PointMass(_Part):
    """A small load.

    Parameters
    ----------
    mass : float
        Its mass; negative for a hole [kg].
    at : float
        Signed distance from C, on the line from C to the load [m].

    Raises
    ------
    ValueError
        If a number is not finite.
    """

    mass: float = quantity(..., "Mass of the load", "kg", MASS)
    at: float = quantity(..., "Signed distance of the load from C", "m")
    shape: Literal["point_mass"] = quantity("point_mass", "Kind of part", "")


class Rod(_Part):
    """A thin uniform rod in the plane of motion; an axial one counts as a `PointMass`.

    Parameters
    ----------
    mass : float
        Its mass; negative for a slot [kg].
    length : float
        Its length [m].
    at : float, default 0
        Signed distance of its middle from C, on the line from C to the load [m].
    direction : {'radial', 'tangential'}, default 'radial'
        Whether it lies along that line (a spoke) or across it.

    Raises
    ------
    ValueError
        If length is not positive, or the direction is not one of the two.
    """

    mass: float = quantity(..., "Mass of the rod", "kg", MASS)
    length: float = quantity(..., "Length of the rod", "m", LENGTH)
    at: float = quantity(0.0, "Signed distance of the rod's middle from C", "m")
    direction: Literal["radial", "tangential"] = quantity("radial", "Along the line from C or across it", "")
    shape: Literal["rod"] = quantity("rod", "Kind of part", "")


Part = Annotated[Ring | Disk | PointMass | Rod, Discriminator("shape")]


def combine(radius: float, parts: Sequence[Ring | Disk | PointMass | Rod]) -> tuple[float, float, float]:
    """Return mass [kg], ε and κ [1] of a hoop of rim radius `radius` [m] made of parts; κ by the parallel axis theorem.

    ε is never negative: if the centre of gravity G is on the negative side of C, the line from C is reversed, so that θ is the
    angle to G. A part that reaches beyond the rim is refused.
    """
    for index, part in enumerate(parts):
        if part.reach > radius * (1.0 + TOUCH):
            raise refuse(say("beyond_the_rim", index=index, shape=part.shape, reach=part.reach, radius=radius))
    whole, eccentricity, inertia_ratio = combined(radius, np.array([part.row for part in parts]))
    return float(whole), float(eccentricity), float(inertia_ratio)
