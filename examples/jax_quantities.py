"""Quantities of a motion and their derivatives in a program of JAX, which calls hophoop for both."""

import jax
import numpy as np

import hophoop as hh

scenario = hh.Scenario(duration=2.0)
OF, WRT = ["hop.height", "takeoff.angle"], ["plane.mu", "start.speed"]


def computed(values):
    """Quantities and their derivatives, in the precision of the argument."""
    given = dict(zip(WRT, np.asarray(values, float).tolist(), strict=True))
    result = hh.sensitivity(scenario.with_values(given), OF, WRT)
    kind = values.dtype
    return result.values.astype(kind), result.derivatives.astype(kind)


def called(values):
    shapes = [(len(OF),), (len(OF), len(WRT))]
    kinds = tuple(jax.ShapeDtypeStruct(shape, values.dtype) for shape in shapes)
    return jax.pure_callback(computed, kinds, values, vmap_method="sequential")


@jax.custom_jvp
def quantities(values):
    return called(values)[0]


@quantities.defjvp
def pushed(values, changes):
    found, derivatives = called(*values)
    return found, derivatives @ changes[0]


jax.jacrev(quantities)(jax.numpy.array([1.0, 3.1]))
# [[-0.3283148   1.5118344 ]
#  [ 0.22178827 -1.0212977 ]]
