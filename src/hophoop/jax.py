"""Motions inside programs of JAX: `simulate` is a function that JAX differentiates, forwards and backwards, by our derivatives.

Needs the extra ``jax``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.extras import need
from hophoop.derivatives.results.sensitivity import names_of, sensitivity_of
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate as simulate_motion

__all__ = ["simulate"]

Floats = NDArray[np.float64]


def simulate(parameters: Mapping[str, ArrayLike], of: str | Sequence[str], scenario: Scenario | None = None) -> Any:
    """Quantities of a motion as a differentiable function of some parameters.

    Parameters
    ----------
    parameters : mapping of str to float or jax.Array
        Values by path, such as ``{"start.speed": 3.1}`` [their units].
    of : str or sequence of str
        Quantities, as `Trajectory.sensitivity` takes them.
    scenario : Scenario, optional
        All else; the reference case by default.

    Returns
    -------
    values : jax.Array, shape (n,)
        nan, and so their derivatives, where the motion has no such event or the values are not allowed; derivatives
        are nan as well where there are none [their units].

    Raises
    ------
    ValueError
        If nothing is asked for or nothing is given.
    ImportError
        If JAX is missing (extra ``jax``).

    Notes
    -----
    In single precision, which is what JAX computes in unless ``jax_enable_x64`` is set, the motion is still
    computed in double precision and rounded at the end.

    Examples
    --------
    >>> import jax, hophoop as hh  # doctest: +SKIP
    >>> def height(speed):  # doctest: +SKIP
    ...     return hh.jax.simulate({"start.speed": speed}, of="hop.height", scenario=hh.Scenario(duration=2.0))[0]
    >>> jax.grad(height)(3.1)  # doctest: +SKIP
    Array(1.5118343, dtype=float32)
    """
    numpy = need("jax.numpy", "jax")
    paths, names = names_of(tuple(parameters), "parameters"), names_of(of, "of")
    kind = numpy.result_type(float)
    values = numpy.stack([numpy.asarray(parameters[path], kind) for path in paths])
    return _function(scenario or Scenario(), names, paths, kind)(values)


def _function(scenario: Scenario, names: tuple[str, ...], paths: tuple[str, ...], kind: Any) -> Any:
    jax = need("jax", "jax")
    shape, square = (jax.ShapeDtypeStruct(size, kind) for size in ((len(names),), (len(names), len(paths))))

    def only_values(values: Any) -> Any:
        return _computed(scenario, names, paths, values, False)[0].astype(kind)

    def with_slopes(values: Any) -> Any:
        found, slopes = _computed(scenario, names, paths, values, True)
        return found.astype(kind), slopes.astype(kind)

    def called(values: Any) -> Any:
        return jax.pure_callback(only_values, shape, values, vmap_method="sequential")

    def pushed(primals: Any, tangents: Any) -> Any:
        found, slopes = jax.pure_callback(with_slopes, (shape, square), primals[0], vmap_method="sequential")
        return found, slopes @ tangents[0]

    function = jax.custom_jvp(called)
    function.defjvp(pushed)
    return function


def _computed(
    scenario: Scenario, names: Sequence[str], paths: Sequence[str], values: Any, slopes: bool
) -> tuple[Floats, Floats]:
    """Values of the quantities and their derivatives; nan where there are none."""
    found, rates = np.full(len(names), np.nan), np.full((len(names), len(paths)), np.nan)
    given = {path: float(value) for path, value in zip(paths, np.asarray(values, float), strict=True)}
    try:
        motion = simulate_motion(scenario.with_values(given))
    except InputError:
        return found, rates
    for i, name in enumerate(names):
        try:
            result = sensitivity_of(motion, name, paths if slopes else paths[:1])
        except InputError:
            continue
        found[i] = result.values[0]
        if slopes:
            rates[i] = result.derivatives[0]
    return found, rates
