"""Parts of a real hoop, and ε and κ of their sum."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Discriminator, model_validator

from hophoop.kernel.physics import mass
from hophoop.scenario.base import Frozen, NonNegative, Number, Positive, plain_init, quantity, refuse
from hophoop.scenario.ranges import inside, schema_of
from hophoop.scenario.texts import say

PartMass = Annotated[Positive, inside("hoop.parts.mass", "kg"), schema_of("hoop.parts.mass")]
Length = Annotated[Positive, inside("hoop.parts.length", "m"), schema_of("hoop.parts.length")]

Row = tuple[int, float, float, float, float]

# Tolerance for a part that touches the rim, since its position is rounded.
TOUCH = 1e-12


class _Body:
    """Common base of all parts."""

    @property
    def row(self) -> Row:
        """Its numbers for `physics.mass`."""
        raise NotImplementedError

    @property
    def inertia(self) -> float:
        """Moment of inertia about its own centre [kg m²]."""
        shape, weight, first, second, _ = self.row
        return float(mass.part_inertia(shape, weight, first, second))

    @property
    def reach(self) -> float:
        """Distance of its farthest point from C [m]."""
        shape, _, first, second, at = self.row
        return float(mass.part_reach(shape, first, second, at))


class Ring(Frozen, _Body):
    """A flat ring about the rim's centre C; thin if both radii are equal.

    Parameters
    ----------
    mass : float
        Its mass [kg].
    inner_radius, outer_radius : float
        Its radii [m].

    Raises
    ------
    ValueError
        If the mass or outer_radius is not positive, inner_radius is negative or exceeds outer_radius.
    """

    place: ClassVar[str] = "hoop.parts: "

    shape: Literal["ring"] = quantity("ring", "Kind of part", "")
    mass: PartMass = quantity(..., "Mass of the ring", "kg")
    inner_radius: NonNegative = quantity(..., "Inner radius of the ring", "m")
    outer_radius: Length = quantity(..., "Outer radius of the ring", "m")

    @plain_init
    def __init__(self, mass: float, inner_radius: float, outer_radius: float, **shape: Any) -> None:
        super().__init__(mass=mass, inner_radius=inner_radius, outer_radius=outer_radius, **shape)

    @model_validator(mode="after")
    def _ordered(self) -> Ring:
        if self.inner_radius > self.outer_radius:
            raise refuse(say("ring_radii", inner=self.inner_radius, outer=self.outer_radius))
        return self

    @property
    def at(self) -> float:
        """Distance of its centre from C: 0 [m]."""
        return 0.0

    @property
    def row(self) -> Row:
        """Its numbers for `physics.mass`."""
        return mass.RING, self.mass, self.inner_radius, self.outer_radius, 0.0


class Disk(Frozen, _Body):
    """A uniform disk, such as a cylindrical load seen from its end.

    Parameters
    ----------
    mass : float
        Its mass [kg].
    radius : float
        Its radius [m].
    at : float, default 0
        Signed distance of its centre from C, on the line from C to the load [m].

    Raises
    ------
    ValueError
        If mass or radius is not positive.
    """

    place: ClassVar[str] = "hoop.parts: "

    shape: Literal["disk"] = quantity("disk", "Kind of part", "")
    mass: PartMass = quantity(..., "Mass of the disk", "kg")
    radius: Length = quantity(..., "Radius of the disk", "m")
    at: Number = quantity(0.0, "Signed distance of the disk's centre from C", "m")

    @plain_init
    def __init__(self, mass: float, radius: float, at: float = 0.0, **shape: Any) -> None:
        super().__init__(mass=mass, radius=radius, at=at, **shape)

    @property
    def row(self) -> Row:
        """Its numbers for `physics.mass`."""
        return mass.DISK, self.mass, self.radius, 0.0, self.at


class PointMass(Frozen, _Body):
    """A small load.

    Parameters
    ----------
    mass : float
        Its mass [kg].
    at : float
        Signed distance from C, on the line from C to the load [m].

    Raises
    ------
    ValueError
        If the mass is not positive.
    """

    place: ClassVar[str] = "hoop.parts: "

    shape: Literal["point_mass"] = quantity("point_mass", "Kind of part", "")
    mass: PartMass = quantity(..., "Mass of the load", "kg")
    at: Number = quantity(..., "Signed distance of the load from C", "m")

    @plain_init
    def __init__(self, mass: float, at: float, **shape: Any) -> None:
        super().__init__(mass=mass, at=at, **shape)

    @property
    def row(self) -> Row:
        """Its numbers for `physics.mass`."""
        return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at


class Rod(Frozen, _Body):
    """A thin uniform rod in the plane of motion; an axial one counts as a `PointMass`.

    Parameters
    ----------
    mass : float
        Its mass [kg].
    length : float
        Its length [m].
    at : float, default 0
        Signed distance of its middle from C, on the line from C to the load [m].
    direction : {'radial', 'tangential'}, default 'radial'
        Whether it lies along that line (a spoke) or across it.

    Raises
    ------
    ValueError
        If mass or length is not positive, or the direction is not one of the two.
    """

    place: ClassVar[str] = "hoop.parts: "

    shape: Literal["rod"] = quantity("rod", "Kind of part", "")
    mass: PartMass = quantity(..., "Mass of the rod", "kg")
    length: Length = quantity(..., "Length of the rod", "m")
    at: Number = quantity(0.0, "Signed distance of the rod's middle from C", "m")
    direction: Literal["radial", "tangential"] = quantity("radial", "Along the line from C or across it", "")

    @plain_init
    def __init__(
        self,
        mass: float,
        length: float,
        at: float = 0.0,
        direction: Literal["radial", "tangential"] = "radial",
        **shape: Any,
    ) -> None:
        super().__init__(mass=mass, length=length, at=at, direction=direction, **shape)

    @property
    def row(self) -> Row:
        """Its numbers for `physics.mass`."""
        kind = mass.RADIAL_ROD if self.direction == "radial" else mass.TANGENTIAL_ROD
        return kind, self.mass, self.length, 0.0, self.at


Part = Annotated[Ring | Disk | PointMass | Rod, Discriminator("shape")]


def combine(radius: float, parts: Sequence[Ring | Disk | PointMass | Rod]) -> tuple[float, float, float]:
    """Mass, eccentricity and inertia ratio of a hoop made of parts.

    Parameters
    ----------
    radius : float
        Rim radius R [m].
    parts : sequence of Ring, Disk, PointMass or Rod
        At least one; all within the rim.

    Returns
    -------
    mass : float
        Their sum [kg].
    eccentricity : float
        ε = distance of the centre of gravity G from C over R [1]. Never negative: if G is on the negative side of
        C, the line from C is reversed, so that θ is the angle to G.
    inertia_ratio : float
        κ = moment of inertia about G over m R² [1], by the parallel axis theorem.

    Raises
    ------
    ValueError
        If a part reaches beyond the rim.
    """
    for index, part in enumerate(parts):
        if part.reach > radius * (1.0 + TOUCH):
            raise refuse(say("beyond_the_rim", index=index, shape=part.shape, reach=part.reach, radius=radius))
    whole, eccentricity, inertia_ratio = mass.combined(radius, np.array([part.row for part in parts]))
    return float(whole), float(eccentricity), float(inertia_ratio)
