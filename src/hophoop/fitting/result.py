"""A fit: parameters with their uncertainties, what they rest on, and what the data do not tell."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support import tables
from hophoop._support.files import replacing
from hophoop._version import __version__
from hophoop.fitting.guess import merge_bounces
from hophoop.fitting.judging import WORDS
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.posterior import Posterior, posterior_from_dict
from hophoop.fitting.problem import Prior, Problem, problem_of
from hophoop.fitting.solving import Choice
from hophoop.scenario import Hoop, InputError, Plane, Scenario
from hophoop.simulation.trajectory import Trajectory
from hophoop.tracking import Track
from hophoop.tracking.table import track_from_dict

Floats = NDArray[np.float64]

SCHEMA = "hophoop-fit/1"
GIVEN = " (given)"  # suffix of values that were not fitted
WORST = 2.0  # maximum chi-square over degrees of freedom of a good fit
HOPELESS = 10.0 * WORST  # above it the details of the residuals mean nothing


@dataclass(frozen=True, eq=False)
class Fit:
    """Result of a fit.

    Attributes
    ----------
    values : dict of float
        All parameters [SI units].
    free : tuple of str
        Fitted parameters that the data determine.
    covariance : ndarray, shape (len(free), len(free))
        Of these [1].
    chi_square : float
        Sum of the squared residuals over their variances [1].
    degrees_of_freedom : int
        Measured numbers minus fitted parameters [1].
    limits : dict
        One-sided limits: by name, the sign ('≥' or '≤') and the value [SI units].
    shares : dict of float
        Sequences of motions within the uncertainties, and their shares [1].
    correlated : list
        Pairs of parameters that the data hardly distinguish, with their correlation [1].
    misfits : list of dict
        Quantities and phases whose residuals have too few runs.
    notes : tuple of str
        Remarks, one sentence each.
    track : Track
        The data.
    settings : dict
        Settings of the fit: start, hoop, gravity, law, robust, sigma, sigma_angle, free, bounds, tied, priors.
    calls : int
        Number of motions computed [1].
    posterior : Posterior or None
        From a chain of `hophoop.fitting.sample`.
    """

    values: dict[str, float]
    free: tuple[str, ...]
    covariance: Floats
    chi_square: float
    degrees_of_freedom: int
    limits: dict[str, tuple[str, float]]
    shares: dict[str, float]
    correlated: list[tuple[str, str, float]]
    misfits: list[dict[str, Any]]
    notes: tuple[str, ...]
    track: Track
    settings: dict[str, Any]
    calls: int = 0
    posterior: Posterior | None = None

    @property
    def reduced(self) -> float:
        """Chi-square over the degrees of freedom, about 1 if the model explains the data [1]."""
        return self.chi_square / max(self.degrees_of_freedom, 1)

    @property
    def good(self) -> bool:
        """True if the motion explains the data: chi-square at most twice the degrees of freedom."""
        return self.reduced <= WORST

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
        if name == "mu_static":
            both = [self.free.index(part) for part in ("mu_kinetic", "mu_excess") if part in self.free]
            return self.inflation * _root(self.covariance[np.ix_(both, both)].sum())
        if name not in self.values:
            raise InputError(f"{name!r} is none of {', '.join(self.values)}.")
        if name not in self.free:
            return 0.0
        place = self.free.index(name)
        return self.inflation * _root(self.covariance[place, place])

    @cached_property
    def problem(self) -> Problem:
        """Data and model."""
        how = self.settings
        hoop = Hoop(**how["hoop"]) if isinstance(how["hoop"], dict) else how["hoop"]
        plane = Plane(gravity=how["gravity"], impact_law=how["law"])
        problem = problem_of(self.track, hoop, how["start"], plane, (how["sigma"], how["sigma_angle"]))
        return replace(problem, priors={name: Prior(*pair) for name, pair in how.get("priors", {}).items()})

    @cached_property
    def choice(self) -> Choice:
        """Free, bounded and tied parameters, including those that the data do not determine."""
        how = self.settings
        bounds = {name: (float(low), float(high)) for name, (low, high) in how["bounds"].items()}
        return Choice(self.values, tuple(how["free"]), bounds, how["tied"])

    @cached_property
    def scenario(self) -> Scenario:
        """The fitted motion's scenario, for the lab or another duration."""
        return self.problem.scenario(self.values)

    @cached_property
    def motion(self) -> Trajectory:
        """The fitted motion; its time starts at the first frame with data."""
        return self.problem.motion(self.values)

    @cached_property
    def residuals(self) -> dict[str, Floats]:
        """Data minus motion in standard deviations, by quantity [1]."""
        off, begin, result = self.problem.residuals(self.values), 0, {}
        for channel in self.problem.channels:
            result[channel.name] = off[begin : begin + len(channel.rows)]
            begin += len(channel.rows)
        return result

    def rows(self) -> list[tuple[str, str, str]]:
        """Parameters for people: name, value with uncertainty or limit, unit and meaning.

        Returns
        -------
        rows : list of (str, str, str)
        """
        result = []
        for name in self.values:
            kind = PARAMETERS[name]
            unit = "" if kind.unit == "1" else f" {kind.unit}"
            if name in self.limits:
                sign, value = self.limits[name]
                text = f"{sign} {value:.3g}{unit}" if np.isfinite(value) else "not determined"
            elif name in self.free and self.posterior is not None:
                text = f"{format_range(*self.posterior.quantiles(name))}{unit}"
            elif name in self.free:
                text = f"{format_value(self.values[name], self.error(name))}{unit}"
            else:
                text = f"{self.values[name]:.6g}{unit}{GIVEN}"
            result.append((name, text, kind.meaning))
        if "mu_static" not in self.limits and {"mu_kinetic", "mu_excess"} <= set(self.free):
            static = self.values["mu_kinetic"] + self.values["mu_excess"]
            text = format_value(static, self.error("mu_static"))
            if self.posterior is not None:
                text = format_range(*self.posterior.quantiles("mu_static"))
            result.append(("mu_static", text, "static friction, the sum of the two"))
        elif "mu_static" in self.limits:
            sign, value = self.limits["mu_static"]
            result.append(("mu_static", f"{sign} {value:.3g}", "static friction"))
        return result

    def sentences(self) -> list[str]:
        """Describe the fit.

        Returns
        -------
        sentences : list of str
        """
        sequence = merge_bounces(self.motion.sequence)
        said = [f"χ² = {self.chi_square:.1f} for {self.degrees_of_freedom} degrees of freedom ({self.reduced:.2f} each)."]
        if not self.good:
            said.append(f"No fit is good: χ² is {self.reduced:.1f} times the degrees of freedom, more than {WORST:g}.")
        elif self.inflation > 1.05:
            said.append(
                f"Errors are enlarged by {self.inflation:.2f}, since the residuals are larger than the errors of the data."
            )
        said.append(f"Sequence {sequence}: {100 * self.shares.get(sequence, 0.0):.0f} % of the posterior has it.")
        if len(self.shares) > 1:
            others = ", ".join(f"{name} {100 * part:.0f} %" for name, part in list(self.shares.items())[:4])
            said[-1] = said[-1].rstrip(".") + f" ({others})."
        if self.posterior is not None:
            said.append(_about(self.posterior))
        of_the_table = self.track.notes if self.track.view is None else ()
        if self.reduced > HOPELESS:
            return [*said[:2], *self.notes, *of_the_table]
        for first, second, size in self.correlated[:4]:
            said.append(f"{first} and {second} can hardly be distinguished (correlation {size:+.3f}).")
        for place in self.misfits:
            said.append(
                f"Residuals of {WORDS[place['quantity']]} have the same sign for long in {place['phase']} "
                f"({-place['deviation']:.0f} standard deviations fewer runs than chance): the model lacks something there."
            )
        return [*said, *self.notes, *of_the_table]

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
            "values": self.values,
            "errors": {name: self.error(name) for name in self.free},
            "free": list(self.free),
            "covariance": self.covariance.tolist(),
            "chi_square": self.chi_square,
            "degrees_of_freedom": self.degrees_of_freedom,
            "good": self.good,
            "limits": {name: list(limit) for name, limit in self.limits.items()},
            "shares": self.shares,
            "correlated": [list(pair) for pair in self.correlated],
            "misfits": self.misfits,
            "notes": list(self.notes),
            "settings": self.settings,
            "calls": self.calls,
            "posterior": None if self.posterior is None else self.posterior.to_dict(),
            "scenario": self.scenario.to_dict(),
            "track": self.track.to_dict(),
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
        file = Path(path)
        if file.suffix.lower() != ".json":
            raise InputError(f"{file} must end in .json.")
        with replacing(file) as fresh:
            text = json.dumps(plain(self.to_dict()), ensure_ascii=False, allow_nan=False)
            fresh.write_text(text + "\n", encoding="utf-8")

    def _repr_html_(self) -> str:
        return tables.html(self.rows(), left=(0, 2), before=[" ".join(self.sentences())])

    def __repr__(self) -> str:
        some = ", ".join(f"{name} = {format_value(self.values[name], self.error(name))}" for name in self.free[:4])
        return f"<Fit of {self.track.source or 'a hoop'}: {some}, χ²/dof = {self.reduced:.2f}>"


def _root(variance: float) -> float:
    """Return the square root, nan for the negative variance of a singular problem."""
    return float(np.sqrt(variance)) if variance >= 0 else float("nan")


def format_value(value: float, error: float) -> str:
    """Format a value and its uncertainty with their significant digits.

    text: such as '0.6002 ± 0.0003'.
    """
    if not (np.isfinite(error) and error > 0):
        return f"{value:.6g}"
    digits = max(0, min(12, 1 - int(np.floor(np.log10(error)))))
    return f"{value:.{digits}f} ± {error:.{digits}f}"


def format_range(low: float, middle: float, high: float) -> str:
    """Format the median of a posterior and its central two thirds.

    text: such as '0.102 +0.011 −0.013'.
    """
    size = min(high - middle, middle - low)
    if not (np.isfinite(size) and size > 0):
        return f"{middle:.6g}"
    digits = max(0, min(12, 1 - int(np.floor(np.log10(size)))))
    return f"{middle:.{digits}f} +{high - middle:.{digits}f} −{middle - low:.{digits}f}"


def _about(posterior: Posterior) -> str:
    text = f"Values and shares are from a chain of {posterior.walkers} walkers and {posterior.steps} steps"
    if posterior.long_enough:
        return f"{text}: the median, and the range of the central two thirds."
    return f"{text}, which is short: the autocorrelation time is {posterior.memory:.0f} steps, and 50 times as many are needed."


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
    try:
        data = json.loads(file.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise InputError(f"{file} is not valid JSON: {error}.") from None
    if not isinstance(data, dict) or data.get("schema") != SCHEMA:
        raise InputError(f"{file} is not a fit of hophoop ({SCHEMA}).")
    try:
        return Fit(
            data["values"],
            tuple(data["free"]),
            np.array(data["covariance"], dtype=float).reshape(len(data["free"]), -1),
            float(data["chi_square"]),
            int(data["degrees_of_freedom"]),
            {
                name: (str(limit[0]), float(limit[1]) if limit[1] is not None else np.nan)
                for name, limit in data["limits"].items()
            },
            data["shares"],
            [(pair[0], pair[1], float(pair[2])) for pair in data["correlated"]],
            data["misfits"],
            tuple(data["notes"]),
            track_from_dict(data["track"], str(file)),
            data["settings"],
            int(data["calls"]),
            None if data.get("posterior") is None else posterior_from_dict(data["posterior"]),
        )
    except InputError:
        raise
    except (KeyError, TypeError, IndexError, AttributeError, ValueError) as error:
        raise InputError(f"{file} is incomplete: {error}.") from None


def plain(value: Any) -> Any:
    """Replace nan and infinity, which JSON does not have, by None."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value
