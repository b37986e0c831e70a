"""What the decorators add to Numba's own."""

from hophoop._jit import jit


@jit
def scaled(value, factor):
    return value * factor


@jit
def summed(value):
    return scaled(value, 2) + scaled(value, 3) + scaled(value, int(value))


def test_a_constant_argument_compiles_nothing_anew():
    assert summed(2.0) == 14.0
    summed.recompile()  # where it came from the cache, nothing was asked of `scaled`
    assert [[str(kind) for kind in signature] for signature in scaled.signatures] == [["float64", "int64"]]
