"""Kernels that compile in a second; a module of its own, so that another process can import it."""

from __future__ import annotations

import numpy as np

from hophoop._native import apart, inline

FACTOR = 3.0


def tripled(value):
    return FACTOR * value


def passed(value):
    return tripled(value) / 3.0


def summed(count, out):
    """The sum of 0 to count − 1; interpreted it takes some 0.5 µs a step."""
    total = 0.0
    for i in range(count):
        total += passed(float(i))
    out[0] = total
    return total


def by_itself(value):
    return FACTOR * value


def with_a_unit(value):
    return by_itself(value) + 1.0


def quotient(a, b):
    return a / b


def root(value):
    return np.sqrt(value)


def scaled(value, factor):
    return value * factor


def with_constants(value):
    return scaled(value, 2) + scaled(value, 3) + scaled(value, int(value))


@apart
def halved(value):
    return 0.5 * value


@inline
def above(value):
    return halved(value) + 1.0


@inline
def beyond(value):
    return halved(above(value))


@apart
def between(value):
    return above(value) - beyond(value)


def woven(value):
    return between(value) + beyond(value) + halved(value)


@apart
def aside(value):
    return above(value)


@inline
def further(value):
    return beyond(value)


@inline
def both(value):
    return aside(value) + further(value)


def layered(value):
    return both(value)


def put_sum(queue):
    """What a process of `multiprocessing` does in the tests."""
    queue.put(float(summed(1000, np.empty(1))))
