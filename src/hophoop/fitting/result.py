"""A fit: parameters with their uncertainties, what they rest on, and what the data leave open."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from hophoop._support import tables
from hophoop._support.extras import need
from hophoop._version import __version__
from hophoop.fitting.channels import KINDS, Floats, Values
from hophoop.fitting.covariance import correlated_frames
from hophoop.fitting.judging import WORDS, correlations, misfits, shares
from hophoop.fitting.parameters import SHARED, parts_of, spec
from hophoop.fitting.problem import Prior, Problem, problem_of, run_of
from hophoop.fitting.solving import parameters
from hophoop.scenario import Hoop, InputError, Plane, Scenario
from hophoop.scenario.formats import read_text
from hophoop.simulation.trajectory import Trajectory
from hophoop.tracking import Track
from hophoop.tracking.doubts import DOUBT
from hophoop.tracking.table import complete, track_from_dict, write_json

if TYPE_CHECKING:
    from lmfit import Parameters

SCHEMA = "hophoop-fit/1"
GIVEN = " (given)"  # suffix of values that were not fitted
WORST = 2.0  # maximum chi-square over degrees of freedom of a good fit
CERTAIN, LEVEL = 3.0, 0.5  # minimum roll of a turned camera [standard deviations, °]
UNLIKELY = 0.003  # probability below which runs do not agree
HOPELESS = 10.0 * WORST  # above it the numbers of a fit mean nothing
# For data without errors of their own: maximum chi-square over degrees of freedom, and minimum von Neumann ratio, of use.
FAR, SCATTER = 3.0 * WORST, 1.2
# And those above which their scatter is doubted: over the radius, or in rad, and the von Neumann ratio of at least so many.
COARSE, ALTERNATING, MANY = 0.05, 3.0, 100
# What a file has as it is.
SAVED = (
    "values", "errors", "free", "chi_square", "degrees_of_freedom", "good", "limits", "shares", "correlated", "misfits",
    "notes", "settings", "mistaken",
)  # fmt: skip
# Relative errors, and what they are enough for.
ACCURACIES = {
    0.01: "Known to 1 %, enough to test the theory",
    0.1: "Known to 10 %, enough to predict another run",
    float("inf"): "Known only roughly",
}


@dataclass(frozen=True, eq=False)
class Fit:
    """Result of a fit.

    Attributes
    ----------
    values : dict of float
        All parameters; with several runs those of a run end in its number, such as speed_2 [SI units].
    free : tuple of str
        Fitted parameters that the data determine.
    covariance : ndarray, shape (len(free), len(free))
        Of these [1].
    limits : dict
        One-sided limits: by name, the sign ('≥' or '≤') and the value [SI units].
    notes : tuple of str
        Remarks, one sentence each.
    tracks : tuple of Track
        The data of each run; errors that they lack are their scatter.
    settings : dict
        Settings of the fit: starts, hoop, gravity, law, robust, derived, free, bounds, tied, priors.
    alone : tuple of Fit
        With several runs, the fit of each alone.
    mistaken : bool
        Whether a motion fits much better without a usual mistake, which the notes name.
    """

    values: Values
    free: tuple[str, ...]
    covariance: Floats
    limits: dict[str, tuple[str, float]]
    notes: tuple[str, ...]
    tracks: tuple[Track, ...]
    settings: dict[str, Any]
    alone: tuple[Fit, ...] = ()
    mistaken: bool = False

    @property
    def track(self) -> Track:
        """The data of the first run."""
        return self.tracks[0]

    @cached_property
    def chi_square(self) -> float:
        """Sum of the squared residuals over their variances [1]."""
        return float((self._off**2).sum())

    @property
    def degrees_of_freedom(self) -> int:
        """Measured numbers minus fitted parameters [1]."""
        return self.problem.count - len(self.free)

    @property
    def reduced(self) -> float:
        """Chi-square over the degrees of freedom, about 1 if the model explains the data [1]."""
        return self.chi_square / max(self.degrees_of_freedom, 1)

    @property
    def good(self) -> bool:
        """True if the motion explains the data: chi-square at most twice the degrees of freedom."""
        return self.reduced <= WORST

    @property
    def usable(self) -> bool:
        """True if the fit is good or not perfect; false if no motion fits, and its numbers mean nothing.

        Data without errors of their own have those that they scatter by: residuals that do not scatter show another motion,
        as does a mistake without which one fits.
        """
        if self._scatters:
            return self.good or (self.reduced <= FAR and self.von_neumann >= SCATTER and not self.mistaken)
        return self.reduced <= HOPELESS

    @property
    def _scatters(self) -> bool:
        """True if errors of the data are their scatter."""
        return any(KINDS.keys() & derived for derived in self.settings["derived"])

    @property
    def inflation(self) -> float:
        """Factor of the errors, above 1 if the residuals are larger than the data's errors [1]."""
        return max(1.0, float(np.sqrt(self.reduced)))

    def error(self, name: str) -> float:
        """Standard deviation of a parameter.

        Parameters
        ----------
        name : str

        Returns
        -------
        error : float
            In the unit of the parameter; 0 if it was not fitted [1].

        Raises
        ------
        ValueError
            If there is no such parameter.
        """
        parts = parts_of(name)
        if not set(parts) <= set(self.values):
            raise InputError(f"{name!r} is none of {', '.join(self.values)}.")
        places = np.isin(self.free, parts)
        variance = float(self.covariance[np.ix_(places, places)].sum())
        # a singular problem has negative variances
        return self.inflation * variance**0.5 if variance >= 0 else float("nan")

    @property
    def errors(self) -> Values:
        """Standard deviations of the fitted parameters that the data determine [SI units]."""
        return {name: self.error(name) for name in self.free}

    @property
    def least_static_friction(self) -> float:
        """Lower limit of the static friction at 95 %, if the hoop never slips; otherwise nan [1]."""
        return self.limits.get("mu_static", ("", np.nan))[1]

    @cached_property
    def problem(self) -> Problem:
        """Data and model."""
        how = self.settings
        hoop = Hoop(**how["hoop"]) if isinstance(how["hoop"], dict) else how["hoop"]
        plane = Plane(gravity=how["gravity"], impact_law=how["law"])
        runs = [
            replace(run_of(track, hoop, start, plane), priors={name: Prior(*pair) for name, pair in priors.items()})
            for track, start, priors in zip(self.tracks, how["starts"], how["priors"], strict=True)
        ]
        return problem_of(runs, how["robust"])

    @property
    def params(self) -> Parameters:
        """Parameters of lmfit: the values with their limits and ties, free also where the data do not determine them."""
        return parameters(self.values, self.settings["free"], self.settings["bounds"], self.settings["tied"])

    @cached_property
    def scenario(self) -> Scenario:
        """The fitted motion's scenario, for the lab or another duration; that of the first run."""
        return self.motion.scenario

    @cached_property
    def motions(self) -> list[Trajectory]:
        """The fitted motion of each run."""
        return self.problem.motions(self.values)

    @property
    def motion(self) -> Trajectory:
        """The fitted motion, of the first run; its time starts at the first frame with data."""
        return self.motions[0]

    @cached_property
    def _off(self) -> Floats:
        """Data and priors minus motion, shape (count,) [standard deviations]."""
        return self.problem.residuals(self.values)

    @cached_property
    def residuals(self) -> dict[str, Floats]:
        """Data minus motion in standard deviations, by quantity, with the number of the run if there are several [1]."""
        return {channel.name + self.problem.runs[k].suffix: self._off[part] for k, channel, part in self.problem.pieces}

    @cached_property
    def shares(self) -> Values:
        """Sequences of motions within the uncertainties, and their shares [1]."""
        return shares(self.problem, self.values, self.free, self.inflation**2 * self.covariance)

    @property
    def correlated(self) -> list[tuple[str, str, float]]:
        """Pairs of parameters that the data hardly distinguish, with their correlation [1]."""
        return correlations(self.free, self.covariance, self.problem.priors)

    @property
    def misfits(self) -> list[dict[str, Any]]:
        """Quantities and phases whose residuals have too few runs."""
        return misfits(self.problem, self.motions, self._off)

    @property
    def von_neumann(self) -> float:
        """Squares of the differences of neighbouring residuals over those of the residuals: 2 for scatter alone [1]."""
        ratios = [(np.diff(off) ** 2).sum() / max((off**2).sum(), 1e-300) for off in self.residuals.values()]
        return float(np.mean(ratios))

    def rows(self, given: bool = True) -> list[tuple[str, str, str]]:
        """Parameters for people: name, value with uncertainty or limit, unit and meaning.

        Parameters
        ----------
        given : bool, default True
            Also those that were not fitted.

        Returns
        -------
        rows : list of (str, str, str)
        """
        names = list(self.values)
        if "mu_static" in self.limits or self._determined("mu_static"):
            names.append("mu_static")
        rows = [(name, self._text(name), spec(name).meaning) for name in names]
        return [row for row in rows if given or not row[1].endswith(GIVEN)]

    def _text(self, name: str) -> str:
        """Return a value with its uncertainty, or the limit of a parameter, with the unit."""
        unit = "" if spec(name).unit == "1" else f" {spec(name).unit}"
        if self._determined(name):
            return format_value(self._value(name), self.error(name)) + unit
        if name not in self.limits:
            return f"{self.values[name]:.6g}{unit}{GIVEN}"
        sign, limit = self.limits[name]
        return f"{sign} {limit:.3g}{unit}" if sign else "not determined"

    def _determined(self, name: str) -> bool:
        return set(parts_of(name)) <= set(self.free)

    def _value(self, name: str) -> float:
        return sum(self.values[part] for part in parts_of(name))

    def comparison(self) -> list[list[str]]:
        """Parameters that several runs share, of all together and of each alone.

        Returns
        -------
        rows : list of list of str
            The first is the head.
        """
        head = ["parameter", "together", *(f"run {k}: {one.source}" for k, one in enumerate(self.alone, 1)), "agree"]
        rows = []
        for name in SHARED:
            texts = [one._text(name) for one in (self, *self.alone) if name in one.values]
            if not all(text.endswith(GIVEN) for text in texts):
                chance = self.agreement(name)
                rows.append([name, *texts, "" if np.isnan(chance) else "yes" if chance > UNLIKELY else f"no ({chance:.1g})"])
        return [head, *rows]

    def agreement(self, name: str) -> float:
        """Probability that several runs differ in a parameter by more than they do, if it is the same in all.

        Parameters
        ----------
        name : str

        Returns
        -------
        probability : float
            nan if fewer than two runs determine the parameter [1].
        """
        known = [one for one in self.alone if name in one.free]
        if len(known) < 2:
            return float("nan")
        values, weights = [one.values[name] for one in known], [one.error(name) ** -2 for one in known]
        apart = np.dot(weights, np.subtract(values, np.average(values, weights=weights)) ** 2)
        return float(need("scipy.special", "fit").gammaincc(0.5 * (len(known) - 1), 0.5 * apart))

    def _of_runs(self) -> list[str]:
        """Describe whether several runs agree."""
        said = [
            f"Run {k} ({one.source}) alone is {'not perfect' if one.usable else 'wrong'}: no motion explains its data."
            for k, one in enumerate(self.alone, 1)
            if not one.good
        ]
        chances = {name: self.agreement(name) for name in SHARED}
        if off := ", ".join(name for name, chance in chances.items() if chance <= UNLIKELY):
            said.append(f"The runs do not agree in {off}: look at the table of runs, and for the run that differs.")
        elif seen := ", ".join(name for name, chance in chances.items() if chance > UNLIKELY):
            said.append(f"The runs agree in {seen}.")
        return said

    def sentences(self) -> list[str]:
        """Describe the fit: whether it is good, how accurate each parameter is and for what, and what to do.

        Returns
        -------
        sentences : list of str
        """
        if self.good:
            said = ["The motion explains the data."]
        elif self.usable:
            said = [
                f"Not perfect, but usable: the data are {self.inflation:.1f} times as far from the motion as their errors let "
                "expect; the uncertainties allow for that."
            ]
        else:
            said = [f"Wrong: no motion fits. The data are {self.inflation:.0f} times as far from the best one as their errors."]
        if self.usable:
            said += [*self._doubts(), *self._accuracies(), *self._turned()]
        # of a film, what its track is doubted for; of a table, how it was read
        of_the_tracks = [note for track in self.tracks for note in track.notes if track.view is None or note.startswith(DOUBT)]
        return [*said, *self._of_runs(), *self.notes, *of_the_tracks]

    def _doubts(self) -> list[str]:
        """Doubt a scatter that is large, or that alternates from row to row."""
        said = []
        for run, derived in zip(self.problem.runs, self.settings["derived"], strict=True):
            if (size := max(derived.get("places", 0.0) / run.radius, derived.get("angles", 0.0))) > COARSE:
                said.append(f"The data scatter by {100 * size:.0f} % of the radius: are their times and rows right?")
        if self._scatters and self.problem.count >= MANY and self.von_neumann > ALTERNATING:
            said.append(f"The residuals alternate (von Neumann ratio {self.von_neumann:.1f}): is each row there twice?")
        return said

    def _accuracies(self) -> list[str]:
        """Group the parameters of hoop and contact by their accuracy, and say what it is good for."""
        found: dict[str, list[str]] = {text: [] for text in ACCURACIES.values()}
        for name in (*SHARED, "mu_static"):
            if name != "mu_excess" and self._determined(name) and (error := self.error(name)) > 0:
                share = error / max(abs(self._value(name)), 1e-300)
                word = next(text for limit, text in ACCURACIES.items() if share <= limit)
                found[word].append(f"{name} (to {error:.1g})")
        return [f"{text}: {', '.join(names)}." for text, names in found.items() if names]

    def _turned(self) -> list[str]:
        """Report the slope of the plane and the roll of the camera, which a film shows together, if both are fitted."""
        said = []
        for run, track in zip(self.problem.runs, self.tracks, strict=True):
            name = run.named("slope")
            if track.view is not None and name in self.free:
                slope = self.values[name]
                fall, roll, error = np.degrees([slope, slope + track.view.rise, self.error(name)]).tolist()
                if abs(roll) > max(CERTAIN * error, LEVEL):
                    said.append(
                        f"The camera is turned by {format_value(roll, error)}°, and the plane falls by "
                        f"{format_value(fall, error)}° to the right: gravity along the plane tells them apart."
                    )
        return said

    def details(self) -> list[str]:
        """Describe the statistics of the fit; nothing where no motion fits.

        Returns
        -------
        sentences : list of str
        """
        said = [
            f"χ² = {self.chi_square:.1f} for {self.degrees_of_freedom} degrees of freedom ({self.reduced:.2f} each); "
            f"von Neumann ratio of the residuals {self.von_neumann:.2f} (2 for scatter alone)."
        ]
        for run, derived in zip(self.problem.runs, self.settings["derived"], strict=True):
            of_run = f" of run {run.suffix[1:]}" if run.suffix else ""
            if rate := derived.get("rate"):
                said.append(f"Times{of_run} are rounded: those of an even grid of {rate:.4g} per second are used.")
            said += [
                f"{kind.words}{of_run} scatter by {1e3 * derived[name]:.2g} {kind.unit}, found from the residuals."
                for name, kind in KINDS.items()
                if name in derived
            ]
        if not self.usable:
            return said
        if self.inflation > 1.05:
            said.append(f"Errors are enlarged by {self.inflation:.2f}, since the residuals are larger than those of the data.")
        sequence, seen = self.problem.sequence(self.values), self.shares
        others = ", ".join(f"{name} {100 * part:.0f} %" for name, part in list(seen.items())[:4])
        said.append(
            f"Sequence {sequence}: {100 * seen[sequence]:.0f} % of the motions within the uncertainties have it"
            + (f" ({others})." if len(seen) > 1 else ".")
        )
        said += [
            f"{first} and {second} can hardly be distinguished (correlation {size:+.3f})."
            for first, second, size in self.correlated[:4]
        ]
        said += [
            f"Residuals of {WORDS[place['quantity']]} have the same sign for long in {place['phase']} "
            f"({-place['deviation']:.0f} standard deviations fewer runs than chance): the model lacks something there."
            for place in self.misfits
        ]
        return said + [
            f"Errors of {WORDS[piece.channel.name]} are correlated ({frames:.1f} frames have the information of one); "
            "the uncertainties include that."
            for piece, frames in zip(self.problem.pieces, correlated_frames(self.problem, self._off), strict=True)
            if frames > 1.0
        ]

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary, including the data.

        Returns
        -------
        fit : dict
            Ready for `json.dumps`; SI units and radians.
        """
        return {
            "schema": SCHEMA,
            "version": __version__,
            **{name: getattr(self, name) for name in SAVED},
            "covariance": self.covariance.tolist(),
            "scenario": self.scenario.to_dict(),
            "tracks": [track.to_dict() for track in self.tracks],
            "alone": [{name: part for name, part in one.to_dict().items() if name != "tracks"} for one in self.alone],
        }

    def save(self, path: str | Path) -> None:
        """Write the fit with its data, for `load_fit`.

        Parameters
        ----------
        path : str or Path
            Ends in .json.

        Raises
        ------
        ValueError
            If it ends otherwise.
        OSError
            If it cannot be written.
        """
        write_json(path, self.to_dict())

    def _repr_html_(self) -> str:
        return tables.html(self.rows(), left=(0, 2), before=[" ".join(self.sentences())])

    def __repr__(self) -> str:
        return tables.report(f"Fit of {self.source}", self.rows(given=False), self.sentences()[:1], left=(0, 1, 2))

    @property
    def source(self) -> str:
        """Names of the films or files."""
        return ", ".join(track.source for track in self.tracks if track.source) or "a hoop"


def format_value(value: float, error: float) -> str:
    """Format a value and its uncertainty with two significant digits, such as '0.60020 ± 0.00031'."""
    if not (np.isfinite(error) and error > 0):
        return f"{value:.6g}"
    return f"{need('uncertainties', 'fit').ufloat(value, error):.2ufP}".replace("±", " ± ")


def load_fit(path: str | Path) -> Fit:
    """Read a saved fit.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    fit : Fit

    Raises
    ------
    ValueError
        If the file is not a fit.
    OSError
        If it cannot be read.
    """
    file = Path(path)
    data = read_text(file.read_text(encoding="utf-8"), "json", str(file))
    if data.get("schema") != SCHEMA:
        raise InputError(f"{file} is not a fit of hophoop ({SCHEMA}).")
    with complete(str(file)):
        tracks = [track_from_dict(one, str(file)) for one in data["tracks"]]
        alone = [_from_dict(one, [track]) for one, track in zip(data["alone"], tracks, strict=False)]
        return replace(_from_dict(data, tracks), alone=tuple(alone))


def _from_dict(data: dict[str, Any], tracks: list[Track]) -> Fit:
    return Fit(
        values=data["values"],
        free=tuple(data["free"]),
        covariance=np.array(data["covariance"], dtype=float).reshape(len(data["free"]), -1),
        limits={name: (sign, np.nan if value is None else float(value)) for name, (sign, value) in data["limits"].items()},
        notes=tuple(data["notes"]),
        tracks=tuple(tracks),
        settings=data["settings"],
        mistaken=data["mistaken"],
    )
