"""The elementary functions against mpmath and NumPy, and compiled against interpreted and arrays, to the last bit."""

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from hophoop.kernel.native import mode
from hophoop.kernel.numerics import circular, elementwise
from hophoop.kernel.numerics.arcs import arccosine, arcsine, arctangent, arctangent2, hypotenuse
from hophoop.kernel.numerics.circular import cosine, sine, sine_and_cosine, tangent
from hophoop.kernel.numerics.exponentials import (
    binary_logarithm,
    exponential,
    hyperbolic_cosine,
    hyperbolic_sine,
    hyperbolic_tangent,
    inverse_hyperbolic_cosine,
    logarithm,
    logarithm_1p,
    power,
)

INF = math.inf
CIRCULAR = [sine, cosine, tangent]
# function → the same in mpmath and in NumPy
ONE = {
    sine: (mp.sin, np.sin), cosine: (mp.cos, np.cos), tangent: (mp.tan, np.tan),
    arcsine: (mp.asin, np.arcsin), arccosine: (mp.acos, np.arccos), arctangent: (mp.atan, np.arctan),
    exponential: (mp.exp, np.exp), logarithm: (mp.log, np.log), binary_logarithm: (lambda x: mp.log(x) / mp.log(2), np.log2),
    logarithm_1p: (mp.log1p, np.log1p), hyperbolic_tangent: (mp.tanh, np.tanh), hyperbolic_sine: (mp.sinh, np.sinh),
    hyperbolic_cosine: (mp.cosh, np.cosh), inverse_hyperbolic_cosine: (mp.acosh, np.arccosh),
}  # fmt: skip
TWO = {arctangent2: (mp.atan2, np.arctan2), hypotenuse: (mp.hypot, np.hypot), power: (mp.power, np.power)}
# units in the last place; 0.5001 of the others
BOUNDS = {hyperbolic_tangent: 0.51, hyperbolic_sine: 0.53, hyperbolic_cosine: 0.501, power: 0.51}
SPECIAL = [
    0.0, INF, math.nan, 5e-324, 2.2250738585072014e-308, 2.225073858507201e-308, 1e-300, 2.0**-60, 2.0**-54, 2.0**-27, 2.0**-26,
    1e-9, 1e-8, 0.125, 0.25, 0.5, 1.0, math.nextafter(1.0, 0.0), math.nextafter(1.0, 2.0), 2.0, 3.0, 20.0, 22.0, 40.0, 199.99,
    200.0, 708.0, 709.0, 709.782712893384, math.nextafter(709.782712893384, INF), 710.4758600739439, 711.0, 745.1332191019411,
    745.1332191019412, 745.1332191019413, 2.0**28, 2.0**52, 2.0**53, 2.0**53 - 1.0, 1e22, 2.0**500, 2.0**1000,
    1.7976931348623157e308,
]  # fmt: skip

functions = pytest.mark.parametrize("function", [*ONE, *TWO], ids=lambda function: function.__name__)


def values(function, *arguments, interpreted=False):
    """The values of a function at numbers or pairs of them, by Numba unless kernels are interpreted."""
    if not interpreted and mode() != "interpreted":
        from numba_tools import jitted

        function = jitted(function)
    with np.errstate(all="ignore"):
        points = zip(*(np.asarray(column, float).tolist() for column in arguments), strict=True)
        return np.array([function(*point) for point in points]).T


def same_bits(a, b):
    """Whether all numbers have the same bits, except for those of nan."""
    a, b = np.ascontiguousarray(a, float), np.ascontiguousarray(b, float)
    return bool(((a.view(np.int64) == b.view(np.int64)) | (np.isnan(a) & np.isnan(b))).all())


def error(found, exact):
    """The error of a double in units in the last place of the exact value."""
    if exact == 0:
        return abs(found)
    if math.isinf(found):
        return 0.0 if exact * math.copysign(1.0, found) >= mpf(2) ** 1024 - mpf(2) ** 970 else INF
    return float(abs(mpf(found) - exact) / mpf(2) ** max(mp.frexp(abs(exact))[1] - 53, -1074))


def check(function, *arguments):
    """Compare with mpmath, in so many bits that about 60 digits of the result are right."""
    exact = (ONE | TWO)[function][0]
    for found, *point in zip(values(function, *arguments).tolist(), *arguments, strict=True):
        near = 1e-15 < abs(point[0]) < 1e6
        with mp.workprec(250 if function is power else 2400 if function in TWO else 200 if near else 1400):
            off = error(found, exact(*(mpf(float(number)) for number in point)))
        assert off <= BOUNDS.get(function, 0.5001), [float(number).hex() for number in point]


def spread(random, low, high, count):
    """Numbers of both signs whose logarithms are uniform."""
    return 2.0 ** random.uniform(low, high, count) * random.choice([-1.0, 1.0], count)


def drawn(function, count):
    """Arguments at which a function is finite: common ones, small and large ones, and those beside 1."""
    random = np.random.default_rng(11)
    usual, large = (random.uniform(-size, size, count) for size in (7, 745))
    small, any_size = spread(random, -60, 4, count), spread(random, -1074, 1023, count // 4)
    numbers = np.concatenate([usual, usual / 7.0, small, 1.0 + spread(random, -52, -3, count), large, any_size])
    given = [numbers] if function in ONE else [numbers, random.permutation(numbers)]
    with np.errstate(all="ignore"):
        inside = np.isfinite((ONE | TWO)[function][1](*given))
    return [column[inside] for column in given]


@functions
@pytest.mark.parametrize("count", [25, pytest.param(1000, marks=pytest.mark.long)])
def test_a_function_is_that_of_mpmath(function, count):
    check(function, *drawn(function, count))


def multiples(numbers):
    """The doubles nearest to multiples of π/512, with their neighbours."""
    with mp.workprec(1400):
        near = np.array([float(int(k) * mp.pi / 512) for k in numbers])
    return np.concatenate([near, np.nextafter(near, 0.0), np.nextafter(near, INF)])


@pytest.mark.parametrize("function", CIRCULAR, ids=lambda function: function.__name__)
def test_angles_that_are_hard_to_reduce(function):
    """Between and at entries of the table, where the reduction changes, of every exponent, and next to multiples of π/2."""
    random = np.random.default_rng(21)
    check(function, multiples([*range(1, 256, 3), *range(1023, 32600, 2047), *range(256, 32600, 256)]))
    check(function, multiples([256 * int(2.0**exponent * random.uniform(1, 2)) for exponent in range(5, 1014, 24)]))
    check(function, [border for limit in (circular.NEAR, circular.TINY) for border in (limit, math.nextafter(limit, 0.0))])
    check(function, [math.ldexp(random.uniform(1, 2), exponent) for exponent in range(-30, 1024)])
    check(function, [6381956970095103.0 * 2.0**797])  # the double nearest to one (Muller 2016, table 11.1)


def arguments_anywhere(function):
    """Special arguments with both signs, alone or in pairs, and random ones."""
    random = np.random.default_rng(14)
    special = np.array([*SPECIAL, *(-value for value in SPECIAL)])
    more = [random.uniform(-size, size, 400) for size in (1, 30, 800)]
    more = np.concatenate([*more, spread(random, -1074, 1023, 400), 1.0 + 2.0 ** random.uniform(-52, 2, 400)])
    if function not in TWO:
        return (np.concatenate([special, more]),)
    pairs = np.array(np.meshgrid(special, special)).reshape(2, -1)
    return np.concatenate([pairs[0], more]), np.concatenate([pairs[1], random.permutation(more)])


@functions
def test_special_values_are_those_of_c(function):
    """As in annex F of C99, which NumPy follows: nan, infinities, zeros and their signs."""
    given = arguments_anywhere(function)
    found = values(function, *given)
    with np.errstate(all="ignore"):
        expected = (ONE | TWO)[function][1](*given)
    np.testing.assert_allclose(found, expected, rtol=1e-14, atol=1e-322)
    zero = (found == 0.0) & (expected == 0.0)
    assert np.array_equal(np.signbit(found[zero]), np.signbit(expected[zero]))


@pytest.mark.parametrize("function", [*ONE, *TWO, sine_and_cosine], ids=lambda function: function.__name__)
def test_interpreted_and_compiled_and_arrays_have_the_same_bits(function):
    given = arguments_anywhere(function)
    expected = values(function, *given)
    assert same_bits(values(function, *given, interpreted=True), expected)
    if hasattr(elementwise, function.__name__):
        assert same_bits(getattr(elementwise, function.__name__)(*given), expected)  # a warning would be an error
    if function is sine_and_cosine:
        assert same_bits(expected, [values(sine, *given), values(cosine, *given)])


def test_logarithms_and_powers_that_are_exact():
    exponents = np.arange(-1074, 1024)
    np.testing.assert_array_equal(values(binary_logarithm, np.ldexp(1.0, exponents)), exponents)
    np.testing.assert_array_equal(values(power, np.full(33, 3.0), np.arange(33.0)), [float(3**k) for k in range(33)])
    x = np.abs(spread(np.random.default_rng(15), -400, 400, 300))
    for exponent, expected in ((0.0, np.ones_like(x)), (1.0, x), (2.0, x * x), (0.5, np.sqrt(x))):
        assert same_bits(values(power, x, np.full_like(x, exponent)), expected), exponent


def test_arrays_of_any_shape_and_numbers():
    """Bits of arrays are compared above."""
    grid = np.linspace(-2.0, 300.0, 24).reshape(2, 3, 4)
    assert elementwise.hypotenuse(grid, np.ones((3, 1))).shape == grid.shape
    assert elementwise.sine(np.empty((0, 3))).shape == (0, 3)
    assert np.shape(elementwise.sine_and_cosine(grid)) == (2, *grid.shape)
    assert elementwise.sine(grid)[1, 2, 3] == elementwise.sine(300.0) == elementwise.sine(300)  # an integer is a number as well
    assert type(elementwise.arctangent2(1, 2.0)) is float
    assert elementwise.sine_and_cosine(0.3) == (elementwise.sine(0.3), elementwise.cosine(0.3))
