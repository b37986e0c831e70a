"""Motions as functions that JAX differentiates."""

import sys

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced

jax = pytest.importorskip("jax")
OF, PATHS = ["hop.height", "takeoff.angle"], ("plane.mu", "start.speed")
SCENARIO = hh.Scenario(duration=2.0)


@pytest.fixture(autouse=True)
def _interpreted():
    with forced("interpreted"), jax.enable_x64(True):
        yield


def quantities(values):
    return hh.jax.simulate(dict(zip(PATHS, values, strict=True)), OF, SCENARIO)


@pytest.fixture(scope="module")
def true():
    with forced("interpreted"):
        return hh.sensitivity(SCENARIO, OF, PATHS)


def test_values_and_both_modes_of_differentiation(true):
    at = jax.numpy.array([1.0, 3.1])
    assert np.asarray(quantities(at)) == pytest.approx(true.values, rel=1e-14)
    assert np.asarray(jax.jacfwd(quantities)(at)) == pytest.approx(true.derivatives, rel=1e-13)
    assert np.asarray(jax.jacrev(quantities)(at)) == pytest.approx(true.derivatives, rel=1e-13)


def test_inside_jit_and_vmap(true):
    slope = jax.jit(jax.grad(lambda values: (quantities(values) ** 2).sum()))(jax.numpy.array([1.0, 3.1]))
    assert np.asarray(slope) == pytest.approx(2.0 * true.values @ true.derivatives, rel=1e-12)
    two = jax.vmap(quantities)(jax.numpy.array([[1.0, 3.1], [0.9, 3.0]]))
    assert np.asarray(two[0]) == pytest.approx(true.values, rel=1e-14)
    assert np.asarray(two[1]) == pytest.approx(np.asarray(quantities(jax.numpy.array([0.9, 3.0]))), rel=1e-14)


def test_what_there_is_not_is_nan():
    slow = quantities(jax.numpy.array([1.0, 0.1]))
    assert np.isnan(slow).all()
    assert np.isnan(quantities(jax.numpy.array([-1.0, 3.1]))).all()


def test_a_missing_jax_names_its_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "jax.numpy", None)
    with pytest.raises(ImportError, match=r"hophoop\[jax\]"):
        hh.jax.simulate({"plane.mu": 1.0}, "end.x")


def test_names_are_needed():
    with pytest.raises(ValueError, match="at least one"):
        hh.jax.simulate({}, "end.x")


def test_rolling_resistance():
    plane = hh.Plane(rolling_resistance=0.005)
    scenario, of, path = hh.Scenario(plane=plane, duration=1.2), "takeoff.angle", "plane.rolling_resistance"
    slope = jax.grad(lambda value: hh.jax.simulate({path: value}, of, scenario)[0])(0.005)
    assert float(slope) == pytest.approx(hh.sensitivity(scenario, of, path)[of, path], rel=1e-13)
