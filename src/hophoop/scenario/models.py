"""Hoop, plane, start and the two contact models: frozen and validated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from types import SimpleNamespace
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Tag, model_validator

from hophoop.kernel.records import hoop_refusal, ideal_inertia, plane_refusal
from hophoop.scenario.checking import Frozen, alone, field_of, quantity, refuse, refused, say
from hophoop.scenario.parts import Disk, Part, PointMass, Ring, Rod, combine
from hophoop.vocabulary.parameters import PARAMETERS, TABLE


class Hoop(Frozen):
    """A rigid body with a circular rim: its radius, mass, eccentricity and moment of inertia.

    Given in one of three ways, which it keeps: by `load_fraction` (the ideal hoop), by `eccentricity` and
    `inertia_ratio`, or by `parts`. By default it is the ideal hoop with 75 % of its mass in the load.

    Parameters
    ----------
    radius : float, default 1
        Rim radius R [m].
    mass : float, default 1
        Total mass m [kg]; with parts it is their sum and not given.
    load_fraction : float, optional
        γ from 0 to 1, the share of the mass in a point load on a thin ring [1]; then ε = γ and κ = 1 − γ².
    parts : sequence of Ring, Disk, PointMass or Rod, optional
        Its parts, all within the rim.
    eccentricity : float, optional
        ε from 0 to 1, the distance of the centre of gravity G from the rim's centre C over R [1].
    inertia_ratio : float, optional
        κ ≥ 0, the moment of inertia about G over m R² [1]; 0 only in the massless hoop, whose whole mass is a
        point on the rim.

    Raises
    ------
    ValueError
        If a number is outside its range, two ways are mixed, or a part reaches beyond the rim.

    Examples
    --------
    >>> hoop = Hoop.ideal(load_fraction=0.5)
    >>> hoop.eccentricity, hoop.inertia_ratio
    (0.5, 0.75)
    """

    place: ClassVar[str] = "hoop."

    radius: float = field_of("hoop.radius")
    mass: float = field_of("hoop.mass")
    load_fraction: float | None = field_of("hoop.load_fraction")
    eccentricity: float = field_of("hoop.eccentricity")
    inertia_ratio: float = field_of("hoop.inertia_ratio")
    parts: tuple[Part, ...] | None = quantity(None, "What the hoop is made of", "")

    @model_validator(mode="after")
    def _complete(self) -> Hoop:
        fields = self.model_fields_set
        given = [name for name in _HOOP_WAYS if name in fields and getattr(self, name) is not None]
        if self.parts is not None:
            if not self.parts:
                raise refuse(say("no_parts"))
            alone("hoop", "parts", [*given, *({"mass"} & fields)])
            mass, eccentricity, inertia_ratio = combine(self.radius, self.parts)
            self._settle(mass=mass, eccentricity=eccentricity, inertia_ratio=inertia_ratio)
        elif self.load_fraction is not None or not given:
            alone("hoop", "load_fraction", given)
            gamma = 0.75 if self.load_fraction is None else self.load_fraction
            # a product, since 1 − γ² loses half its digits near γ = 1
            self._settle(load_fraction=gamma, eccentricity=gamma, inertia_ratio=ideal_inertia(gamma))
        elif len(given) == 1:
            missing = "inertia_ratio" if given == ["eccentricity"] else "eccentricity"
            raise refuse(say("half_a_hoop", missing=missing, given=given[0]))
        code = hoop_refusal(self.mass, self.eccentricity, self.inertia_ratio, self.load_fraction is not None)
        if code:
            raise refused(code, SimpleNamespace(hoop=self))
        return self

    def _written(self) -> Iterable[str]:
        if self.parts is not None:
            return ("radius", "parts")
        if self.load_fraction is not None:
            return ("radius", "mass", "load_fraction")
        return ("radius", "mass", "eccentricity", "inertia_ratio")

    @classmethod
    def ideal(cls, load_fraction: float = 0.75, radius: float = 1.0, mass: float = 1.0) -> Hoop:
        """A thin ring with a point load on it.

        Parameters
        ----------
        load_fraction : float, default 0.75
            γ, the share of the mass in the load [1].
        radius : float, default 1
            Rim radius R [m].
        mass : float, default 1
            Total mass m [kg].

        Returns
        -------
        hoop : Hoop
            With ε = γ and κ = 1 − γ².

        Raises
        ------
        ValueError
            If load_fraction is not from 0 to 1, or radius or mass is not positive.
        """
        return cls(load_fraction=load_fraction, radius=radius, mass=mass)

    @classmethod
    def from_parts(cls, radius: float, parts: Sequence[Ring | Disk | PointMass | Rod]) -> Hoop:
        """A real hoop: a thick ring, a load inside the rim, spokes.

        Parameters
        ----------
        radius : float
            Rim radius R [m].
        parts : sequence of Ring, Disk, PointMass or Rod
            Each at a signed distance from C on the line towards the load. If the centre of gravity is on the
            negative side, the line is reversed: θ is the angle to G. A part of negative mass is a hole.

        Returns
        -------
        hoop : Hoop
            Its ε and κ follow from the parallel axis theorem.

        Raises
        ------
        ValueError
            If there is no part, one reaches beyond the rim, or all together are no body: mass and κ must be above 0, ε at
            most 1.

        Examples
        --------
        >>> hoop = Hoop.from_parts(radius=0.3, parts=[Ring(0.4, 0.28, 0.3), Disk(0.5, 0.02, at=0.27)])
        >>> round(hoop.eccentricity, 6), round(hoop.inertia_ratio, 6)
        (0.5, 0.617037)
        """
        return cls(radius=radius, parts=tuple(parts))

    @property
    def massless(self) -> bool:
        """Whether all mass is a point on the rim (ε = 1, κ = 0)."""
        return self.inertia_ratio == 0.0

    @property
    def gyration_radius(self) -> float:
        """Radius of gyration about G, R√κ [m]."""
        return self.radius * math.sqrt(self.inertia_ratio)

    @property
    def inertia(self) -> float:
        """Moment of inertia about G, κ m R² [kg m²]."""
        return self.inertia_ratio * self.mass * (self.radius * self.radius)


_HOOP_WAYS = ("load_fraction", "eccentricity", "inertia_ratio")


class Plane(Frozen):
    """The plane of the motion: gravity, slope, friction and impacts.

    Parameters
    ----------
    gravity : float, default 9.81
        g ≥ 0 [m/s²].
    slope : float, default 0
        β between −π/2 and π/2; downhill is +x [rad].
    mu_static, mu_kinetic : float, default 1
        Coulomb friction [1]; the kinetic one never exceeds the static one, and inf is a plane without slip.
    mu : float, optional
        Sets both [1].
    restitution : float, default 0
        e from 0 (plastic) to 1 [1].
    impact_law : {'stronge', 'newton', 'poisson'}, default 'stronge'
        Criterion that ends the restitution of an impact.
    painleve : {'flight', 'impact'}, default 'flight'
        What follows if Painlevé's paradox leaves the motion indeterminate.
    rolling_resistance : float, default 0
        f from 0 to 1: in contact the couple f R N acts against the rotation [1].

    Raises
    ------
    ValueError
        If a number is outside its range or mu is given together with one of the two.
    """

    place: ClassVar[str] = "plane."

    gravity: float = field_of("plane.gravity")
    slope: float = quantity(0.0, PARAMETERS["plane.slope"].meaning, "rad")  # the kernel has two rules for it
    mu: float | None = field_of("plane.mu")
    mu_static: float = field_of("plane.mu_static")
    mu_kinetic: float = field_of("plane.mu_kinetic")
    restitution: float = field_of("plane.restitution")
    impact_law: Literal["stronge", "newton", "poisson"] = field_of("plane.impact_law")
    painleve: Literal["flight", "impact"] = field_of("plane.painleve")
    rolling_resistance: float = field_of("plane.rolling_resistance")

    @model_validator(mode="after")
    def _complete(self) -> Plane:
        # derived values were not given: pydantic runs this again when a plane becomes part of a scenario
        if self.mu is not None and "mu" in self.model_fields_set:
            alone("plane", "mu", [name for name in _FRICTIONS if name in self.model_fields_set])
            self._settle(mu_static=self.mu, mu_kinetic=self.mu)
        elif self.mu_static == self.mu_kinetic:
            self._settle(mu=self.mu_static)
        code = plane_refusal(self.mu_static, self.mu_kinetic, self.slope)
        if code:
            raise refused(code, SimpleNamespace(plane=self))
        return self

    def _written(self) -> Iterable[str]:
        left_out = {"mu"} if self.mu is None else set(_FRICTIONS)  # equal planes are written alike
        left_out |= {name for name, usual in LEFT_OUT.items() if getattr(self, name) == usual}
        return [name for name in type(self).model_fields if name not in left_out]


_FRICTIONS = ("mu_static", "mu_kinetic")
LEFT_OUT = {row.path.removeprefix("plane."): row.default for row in TABLE if row.left_out}


class Rigid(Frozen):
    """Rigid contact: exact rolling, Coulomb slip, flight and impacts.

    Parameters
    ----------
    max_events : int, default 100000
        Maximum number of events; the motion ends at the last one with status 'event_limit'. From 1 to 10 million [1].

    Raises
    ------
    ValueError
        If max_events is not an integer in that range.
    """

    place: ClassVar[str] = "contact."

    model: Literal["rigid"] = field_of("contact.model")
    max_events: int = field_of("contact.max_events")


class Compliant(Frozen):
    """Compliant contact: a unilateral spring and damper with regularised friction.

    Values that are None follow from radius, mass and gravity (1 m/s² without gravity).

    Parameters
    ----------
    stiffness : float, optional
        k of the normal spring; by default 10⁶ m g/R [N/m].
    damping : float, optional
        Of the normal damper: c [N s/m] in Kelvin-Voigt's law, d [s/m] in Hunt and Crossley's.
    restitution : float, optional
        e from 0 to 1 that the damping is chosen for, in place of damping; by default the plane's. It is that
        of the whole mass on the contact, for Hunt and Crossley's law landing at √(g R). No finite damping
        gives 0, so that smaller values count as √(m g/(k R)), at most 0.1 [1].
    law : {'kelvin-voigt', 'hunt-crossley'}, default 'kelvin-voigt'
        Normal force at the depth δ: N = kδ + cδ̇ or N = kδ(1 + dδ̇), never below 0.
    friction : {'tanh', 'linear', 'bristle'}, default 'tanh'
        Regularised Coulomb law; only 'bristle' can hold a load at rest.
    slip_speed : float, optional
        v_s, over which friction builds up: F = -μ N tanh(v_t/v_s), or linear up to v_s; the bristle's damper
        is μs m g/v_s. By default √(g R) m g/(k R), for the first two from 10⁻⁹ to 10⁻³ of √(g R) [m/s].
    tangential_stiffness : float, optional
        Of the bristle; by default k [N/m].
    rtol : float, optional
        Relative tolerance of the integration, above 0 and at most 0.1; by default 10⁻⁹ [1].
    max_events : int, default 100000
        Maximum number of events; the motion ends at the last one with status 'event_limit'. From 1 to 10 million [1].

    Raises
    ------
    ValueError
        If a number is outside its range, or damping and restitution are both given.
    """

    place: ClassVar[str] = "contact."

    model: Literal["compliant"] = quantity("compliant", "Contact model", "")
    stiffness: float | None = field_of("contact.stiffness")
    damping: float | None = field_of("contact.damping")
    restitution: float | None = field_of("contact.restitution")
    law: Literal["kelvin-voigt", "hunt-crossley"] = field_of("contact.law")
    friction: Literal["tanh", "linear", "bristle"] = field_of("contact.friction")
    slip_speed: float | None = field_of("contact.slip_speed")
    tangential_stiffness: float | None = field_of("contact.tangential_stiffness")
    rtol: float | None = field_of("contact.rtol")
    max_events: int = field_of("contact.max_events")

    @model_validator(mode="after")
    def _one_damping(self) -> Compliant:
        if self.damping is not None and self.restitution is not None:
            alone("contact", "damping", ["restitution"])
        return self


def _model_of(value: Any) -> Any:
    # a table without the key `model` is rigid; other values have no model
    if isinstance(value, dict):
        return value.get("model", "rigid")
    return getattr(value, "model", None)


Contact = Annotated[Annotated[Rigid, Tag("rigid")] | Annotated[Compliant, Tag("compliant")], Discriminator(_model_of)]
