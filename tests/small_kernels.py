"""Kernels that compile in a second; a module of its own, so that another process can import it."""

from __future__ import annotations

import numpy as np

from hophoop._jit import apart_jit, aside_jit, inline_jit, jit, lean_jit, outer_jit, unit_jit

FACTOR = 3.0


@lean_jit
def tripled(value):
    return FACTOR * value


@jit
def passed(value):
    return tripled(value) / 3.0


@jit
def summed(count, out):
    """The sum of 0 to count − 1; interpreted it takes some 0.5 µs a step."""
    total = 0.0
    for i in range(count):
        total += passed(float(i))
    out[0] = total
    return total


@unit_jit
def by_itself(value):
    return FACTOR * value


@jit
def with_a_unit(value):
    return by_itself(value) + 1.0


@jit
def quotient(a, b):
    return a / b


@jit
def root(value):
    return np.sqrt(value)


@jit
def scaled(value, factor):
    return value * factor


@jit
def with_constants(value):
    return scaled(value, 2) + scaled(value, 3) + scaled(value, int(value))


@apart_jit
def halved(value):
    return 0.5 * value


@inline_jit
def above(value):
    return halved(value) + 1.0


@outer_jit
def beyond(value):
    return halved(above(value))


@apart_jit
def between(value):
    return above(value) - beyond(value)


@jit
def woven(value):
    return between(value) + beyond(value) + halved(value)


@aside_jit
def aside(value):
    return above(value)


@outer_jit
def further(value):
    return beyond(value)


@inline_jit
def both(value):
    return aside(value) + further(value)


@jit
def layered(value):
    return both(value)


def put_sum(queue):
    """What a process of `multiprocessing` does in the tests."""
    queue.put(float(summed(1000, np.empty(1))))
