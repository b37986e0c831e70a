"""Parameters of a scenario, one row of a table each: meaning, unit, range, and how people set and see them.

A new parameter needs its field in `scenario.models` and a row of `TABLE`. Its option of the command line, its slider and axis
in the lab, its entry in tables.json and its axis in maps follow. A parameter of the kernel also needs a row of
`kernel.records.cells.Cell`, in the order of this table; docs/architecture.md has the recipe.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from hophoop.kernel.physics.body import INERTIA_RANGE, MASS_RANGE, SLIP_SPEED_RANGE, SLOPE_RANGE, STIFFNESS_RANGE
from hophoop.vocabulary.names import LAWS, NAMED_LAWS

WORD: Final = ""
"""The unit of a parameter that is a word."""


class Range(NamedTuple):
    """Allowed values of a number.

    Attributes
    ----------
    least, most : float
        Both ends, which are allowed, in the number's SI unit.
    also : tuple of float
        Further single values: 0 or inf.
    """

    least: float
    most: float
    also: tuple[float, ...] = ()

    def holds(self, value: float) -> bool:
        """Whether a value is allowed.

        value: in the number's SI unit.
        """
        return self.least <= value <= self.most or value in self.also

    def words(self, unit: str = "") -> str:
        """The range in words.

        unit: of its numbers; "1" for a pure number; words: such as '0 or from 1e-06 to 1e+06 m/s²'.
        """
        span = f"from {self.least:g} to {self.most:g}" + (f" {unit}" if unit not in ("", "1") else "")
        zero = "0 or " if 0.0 in self.also else ""
        return zero + span + (", or inf" if float("inf") in self.also else "")


class Option(NamedTuple):
    """An option of the command line."""

    flag: str
    help: str
    in_degrees: bool = False
    rare: bool = False  # among the advanced ones of the help


class Slider(NamedTuple):
    """A slider of the lab, in the unit that people see; values beyond it can be typed."""

    low: float
    high: float
    step: float  # 0 for a logarithmic slider


class Axis(NamedTuple):
    """An axis of the lab's maps, with the range it starts from in SI units."""

    low: float
    high: float
    label: str = ""  # by default the parameter's label and symbol
    rank: int = 0  # order within the section: lower ones first, equal ones as in the table


class Parameter(NamedTuple):
    """A parameter of a scenario."""

    path: str
    meaning: str
    unit: str = "1"
    default: float | str | None = None
    range: Range | None = None
    label: str = ""  # in the lab
    symbol: str = ""
    options: tuple[Option, ...] = ()
    slider: Slider | None = None
    axis: Axis | None = None
    figure: str = ""  # on the axes of figures, by default the meaning
    column: str = ""  # the column of the kernel's cell that holds it
    derivative: bool = False  # of a motion with respect to it exists; by default with the rate 1 of its column
    choices: tuple[tuple[str, str], ...] = ()  # of a word: each with its label in the lab
    degrees: bool = False  # shown in degrees in the lab
    left_out: bool = False  # of files and links where it has its default

    @property
    def names(self) -> list[str]:
        """Other names that people may give it: its symbol, its options and everyday words, in lower case."""
        flags = [option.flag.removeprefix("--") for option in self.options]
        words = [self.symbol, *flags, *_EVERYDAY.get(self.path, ())]
        return [word.lower().replace(" ", "_").replace("-", "_") for word in words if word]


_EVERYDAY: Final = {
    "hoop.load_fraction": ("load",),
    "hoop.eccentricity": ("epsilon",),
    "hoop.inertia_ratio": ("kappa", "inertia"),
    "plane.mu": ("friction", "friction_coefficient"),
    "plane.mu_static": ("static_friction",),
    "plane.mu_kinetic": ("kinetic_friction",),
    "plane.slope": ("beta", "angle", "incline", "inclination", "tilt"),
    "plane.restitution": ("bounciness",),
    "plane.impact_law": ("law", "law_of_impact"),
    "start.speed": ("velocity", "v"),
    "start.angle": ("theta", "load_angle"),
    "start.height": ("gap",),
    "start.omega": ("spin", "angular_velocity"),
    "duration": ("time", "t_end"),
    "contact.model": ("contact_model",),
    "contact.law": ("normal_force",),
    "contact.friction": ("friction_law",),
}


_FRICTION = Range(0.0, 1e6, (math.inf,))
_SPEED = Range(-1e6, 1e6)
_RATIO = Range(0.0, 1.0)

TABLE: Final = (
    Parameter(
        "hoop.load_fraction", "Share of the mass in the load of an ideal hoop", "1", None, _RATIO,
        "Load fraction", "γ", (Option("--gamma", "Share of the mass in the load of an ideal hoop, γ."),),
        Slider(0.0, 1.0, 0.01), Axis(0.05, 0.99), "Load fraction γ", derivative=True,
    ),
    Parameter(
        "hoop.eccentricity", "Distance of the centre of gravity from the centre, over the radius", "1", 0.75, _RATIO,
        "Eccentricity", "ε", (Option("--eccentricity", "Distance of G from the centre over R, ε.", rare=True),),
        Slider(0.0, 1.0, 0.01), Axis(0.05, 0.95), "Eccentricity ε", "eccentricity", derivative=True,
    ),
    Parameter(
        "hoop.inertia_ratio", "Moment of inertia about the centre of gravity over m R²", "1", 0.4375,
        Range(*INERTIA_RANGE, (0.0,)), "Inertia ratio", "κ",
        (Option("--inertia-ratio", "Moment of inertia about G over m R², κ.", rare=True),),
        Slider(0.01, 1.0, 0.01), Axis(0.05, 1.0), "Inertia ratio κ", "inertia_ratio", derivative=True,
    ),
    Parameter(
        "hoop.radius", "Rim radius", "m", 1.0, Range(1e-6, 1e6), "Radius", "R", (Option("--radius", "Rim radius, m."),),
        Slider(0.05, 3.0, 0.05), Axis(0.1, 2.0), column="radius", derivative=True,
    ),
    Parameter(
        "hoop.mass", "Total mass", "kg", 1.0, Range(*MASS_RANGE), "Mass", "m", (Option("--mass", "Total mass, kg."),),
        Slider(0.1, 10.0, 0.1), column="mass", derivative=True,
    ),
    Parameter(
        "plane.mu", "Friction, static and kinetic", "1", None, _FRICTION,
        "Friction", "μ", (Option("--mu", "Friction, static and kinetic."),),
        Slider(0.0, 1.5, 0.01), Axis(0.0, 1.5), "Friction μ", derivative=True,
    ),
    Parameter(
        "plane.mu_static", "Static friction", "1", 1.0, _FRICTION,
        "Static friction", "μs", (Option("--mu-static", "Static friction.", rare=True),),
        Slider(0.0, 1.5, 0.01), None, r"Static friction $\mu_s$", "mu_static", derivative=True,
    ),
    Parameter(
        "plane.mu_kinetic", "Kinetic friction", "1", 1.0, _FRICTION,
        "Kinetic friction", "μk", (Option("--mu-kinetic", "Kinetic friction.", rare=True),),
        Slider(0.0, 1.5, 0.01), None, r"Kinetic friction $\mu_k$", "mu_kinetic", derivative=True,
    ),
    Parameter(
        "plane.slope", "Slope of the plane, downhill along +x", "rad", 0.0, Range(*SLOPE_RANGE),
        "Slope", "β",
        (Option("--slope", "Slope, downhill ahead, rad."), Option("--slope-deg", "The same in degrees.", True)),
        Slider(-30.0, 30.0, 0.5), Axis(-0.35, 0.35), "Slope β", "slope", derivative=True, degrees=True,
    ),
    Parameter(
        "plane.gravity", "Gravity", "m/s²", 9.81, Range(1e-6, 1e6, (0.0,)),
        "Gravity", "g", (Option("--gravity", "Gravity, m/s²."),),
        Slider(0.0, 25.0, 0.01), Axis(1.0, 20.0), column="gravity", derivative=True,
    ),
    Parameter(
        "plane.restitution", "Restitution of an impact", "1", 0.0, _RATIO,
        "Restitution", "e", (Option("--restitution", "Restitution of an impact, e."),),
        Slider(0.0, 1.0, 0.01), Axis(0.0, 1.0), "Restitution e", "restitution", derivative=True,
    ),
    Parameter(
        "plane.rolling_resistance", "Rolling resistance: couple against the rotation over R N", "1", 0.0, _RATIO,
        "Rolling resistance", "f", (Option("--rolling-resistance", "Couple against the rotation over R N, f.", rare=True),),
        Slider(0.0, 0.2, 0.001), Axis(0.0, 0.1), column="rolling_resistance", derivative=True, left_out=True,
    ),
    Parameter(
        "plane.impact_law", "Law of restitution", WORD, next(iter(LAWS)).name.lower(), label="Law of impact",
        options=(Option("--law", f"Law of impact: {NAMED_LAWS}.", rare=True),),
        choices=tuple((law.name.lower(), LAWS[law]) for law in sorted(LAWS, reverse=True)),
    ),
    Parameter(
        "plane.painleve", "What follows an indeterminate contact", WORD, "flight", label="Painlevé: two solutions",
        options=(Option("--painleve", "Where Painlevé's paradox leaves both open: flight or impact.", rare=True),),
        choices=(("flight", "flight"), ("impact", "impact")),
    ),
    Parameter(
        "start.speed", "Velocity of the centre in a rolling start", "m/s", None, _SPEED,
        "Speed", "v₀", (Option("--v0", "Rolling start: velocity of the centre, m/s."),),
        Slider(-6.0, 6.0, 0.01), Axis(0.0, 5.0), r"Speed at the start $v_0$", derivative=True,
    ),
    Parameter(
        "start.angle", "Angle from the plane's normal to the centre of gravity", "rad", 0.0, Range(-1e6, 1e6),
        "Load angle", "θ₀",
        (Option("--angle", "Angle of the load from the top, rad."), Option("--angle-deg", "The same in degrees.", True)),
        Slider(-180.0, 180.0, 0.5), Axis(-math.pi, math.pi, "Angle of the load θ₀"), "Angle at the start θ", "angle",
        derivative=True, degrees=True,
    ),
    Parameter(
        "start.x", "Position of the centre along the plane", "m", 0.0, Range(-1e9, 1e9),
        options=(Option("--x", "Position of the centre along the plane, m.", rare=True),), column="x", derivative=True,
    ),
    Parameter(
        "start.height", "Gap between rim and plane", "m", 0.0, Range(0.0, 1e6),
        "Height of the gap", "y₀", (Option("--height", "Gap between rim and plane, m."),),
        Slider(0.0, 2.0, 0.01), Axis(0.0, 1.0, rank=1), column="height", derivative=True,
    ),
    Parameter(
        "start.vx", "Velocity of the centre along the plane", "m/s", 0.0, _SPEED,
        "Speed along", "ẋ₀", (Option("--vx", "Velocity of the centre along the plane, m/s."),),
        Slider(-8.0, 8.0, 0.01), Axis(-6.0, 6.0), derivative=True,
    ),
    Parameter(
        "start.vy", "Velocity of the centre away from the plane", "m/s", 0.0, _SPEED,
        "Speed upwards", "ẏ₀", (Option("--vy", "Velocity of the centre away from the plane, m/s."),),
        Slider(-5.0, 5.0, 0.01), column="vy", derivative=True,
    ),
    Parameter(
        "start.omega", "Angular velocity", "rad/s", 0.0, Range(-1e9, 1e9),
        "Angular velocity", "θ̇₀", (Option("--omega", "Angular velocity, rad/s."),),
        Slider(-15.0, 15.0, 0.05), Axis(-8.0, 8.0), r"Angular velocity at the start $\dot\theta$", "omega", derivative=True,
    ),
    Parameter(
        "duration", "Duration of the motion", "s", 6.0, Range(1e-9, 1e9),
        "Duration", "T", (Option("--duration", "Duration of the motion, s."),),
        Slider(0.5, 30.0, 0.5), column="duration", derivative=True,
    ),
    Parameter(
        "contact.model", "Contact model", WORD, "rigid", label="Contact model",
        choices=(("rigid", "rigid"), ("compliant", "compliant")),
    ),
    Parameter(
        "contact.law", "Normal force", WORD, "kelvin-voigt", label="Normal force",
        choices=(("kelvin-voigt", "Kelvin–Voigt"), ("hunt-crossley", "Hunt–Crossley")),
    ),
    Parameter(
        "contact.friction", "Regularised friction", WORD, "tanh", label="Friction law",
        choices=(("tanh", "smooth (tanh)"), ("linear", "linear"), ("bristle", "bristle (can hold)")),
    ),
    Parameter(
        "contact.stiffness", "Stiffness of the contact", "N/m", None, Range(1e-6, 1e18),
        "Stiffness", "k", slider=Slider(1e2, 1e8, 0.0),
    ),
    Parameter(
        "contact.slip_speed", "Slip velocity over which friction builds up", "m/s", None, Range(1e-12, 1e6),
        "Slip speed", "vₛ", slider=Slider(1e-7, 1e-1, 0.0),
    ),
    Parameter(
        "contact.restitution", "Restitution that the damping is chosen for", "1", None, _RATIO,
        "Restitution", "e", slider=Slider(0.0, 1.0, 0.01),
    ),
    Parameter("contact.damping", "Damping of the contact", "N s/m or s/m", None, Range(0.0, 1e12)),
    Parameter("contact.tangential_stiffness", "Stiffness of the bristle along the plane", "N/m", None, Range(1e-6, 1e18)),
    Parameter("contact.rtol", "Relative tolerance", "1", None, Range(1e-10, 0.1)),
    Parameter("contact.max_events", "Most events before the motion ends", "1", 100_000, Range(1, 1e7), column="max_events"),
)  # fmt: skip
PARAMETERS: Final = {row.path: row for row in TABLE}
"""By path."""
RANGES: Final = {
    **{row.path: row.range for row in TABLE if row.range is not None},
    # of all parts of a hoop; a negative mass is a hole
    "hoop.parts.mass": Range(-1e12, 1e12),
    "hoop.parts.length": Range(1e-12, 1e6),
}
"""Allowed values by path: within them a motion is computed or ends with a status that gives the reason.

The units of a motion are R, m and √(R/g). Outside these ranges its numbers exceed doubles or physical sense.
"""
RELATIVE_STIFFNESS, RELATIVE_SLIP_SPEED = Range(*STIFFNESS_RANGE), Range(*SLIP_SPEED_RANGE)
"""Of a compliant contact, relative to its hoop."""
FIGURE_LABELS: Final = {row.path: row.figure for row in TABLE if row.figure}
"""Short names by path, for the axes of maps."""


def section_of(row: Parameter) -> str:
    """Section of a parameter.

    section: 'hoop', 'plane', 'start' or 'contact'; 'motion' for the duration.

    Examples
    --------
    >>> section_of(PARAMETERS["plane.mu"]), section_of(PARAMETERS["duration"])
    ('plane', 'motion')
    """
    section, dot, _ = row.path.partition(".")
    return section if dot else "motion"
