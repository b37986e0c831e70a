"""The elementary functions against mpmath, against C's special values, and compiled against interpreted, to the last bit."""

import inspect
import math

import numpy as np
import pytest

from elementary_kernels import NAMES, ONE, TWO
from elementary_tools import BOUNDS, interpreted_values, same_bits, values, worst
from hophoop.kernel.numerics import arcs, circular, elementwise, exponentials, tables

INF, NAN = math.inf, math.nan
MODULES = {name: module for module in (circular, arcs, exponentials) for name in NAMES if hasattr(module, name)}
MODULES |= {name: arcs for name in NAMES if name.startswith(("arc", "hypo"))}
MODULES |= {name: exponentials for name in NAMES if name in ("exponential", "logarithm")}
SPECIAL = [
    0.0, INF, NAN, 5e-324, 2.2250738585072014e-308, 2.225073858507201e-308, 1e-300, 2.0**-60, 2.0**-54, 2.0**-27, 2.0**-26,
    1e-9, 1e-8, 0.125, 0.25, 0.5, 1.0, math.nextafter(1.0, 0.0), math.nextafter(1.0, 2.0), 2.0, 3.0, 20.0, 22.0, 40.0, 199.99,
    200.0, 708.0, 709.0, 709.782712893384, math.nextafter(709.782712893384, INF), 710.4758600739439, 711.0, 745.1332191019411,
    745.1332191019412, 745.1332191019413, 2.0**28, 2.0**52, 2.0**53, 2.0**53 - 1.0, 1e22, 2.0**500, 2.0**1000,
    1.7976931348623157e308,
]  # fmt: skip


def spread(random, low, high, count):
    """Numbers of both signs whose logarithms are uniform."""
    return 2.0 ** random.uniform(low, high, count) * random.choice([-1.0, 1.0], count)


def points(name, random, count):
    """Arguments of a function: common ones, small and large ones."""
    if name in ("sine", "cosine", "tangent"):
        return np.concatenate(
            [random.uniform(-7, 7, count), spread(random, -30, 30, count), spread(random, -1074, 1023, count // 8)]
        )
    if name in ("arcsine", "arccosine"):
        near = np.copysign(1.0 - 2.0 ** random.uniform(-53, -2, count), random.uniform(-1, 1, count))
        return np.concatenate([random.uniform(-1, 1, count), spread(random, -40, 0, count), near])
    if name == "arctangent":
        return np.concatenate(
            [random.uniform(-3, 3, count), spread(random, -50, 60, count), spread(random, -1074, 1023, count // 8)]
        )
    if name in ("logarithm", "binary_logarithm"):
        near = 1.0 + spread(random, -52, -3, count)
        return np.concatenate([random.uniform(0.4, 2.5, count), near, 2.0 ** random.uniform(-1074, 1023, count)])
    if name == "logarithm_1p":
        return np.concatenate(
            [random.uniform(-1, 2, count), spread(random, -80, -1, count), 2.0 ** random.uniform(-3, 1023, count)]
        )
    if name == "inverse_hyperbolic_cosine":
        return np.concatenate([1.0 + 2.0 ** random.uniform(-52, 30, 2 * count), 2.0 ** random.uniform(1, 1023, count)])
    largest = 745.0 if name == "exponential" else 710.0
    return np.concatenate(
        [random.uniform(-2, 2, count), spread(random, -60, 4, count), random.uniform(-largest, largest, count)]
    )


def pairs(name, random, count):
    """Arguments of a function of two."""
    if name == "power":
        x, y = 2.0 ** random.uniform(-30, 30, count), spread(random, -3, 4.8, count)
        return np.concatenate([x, 2.0 ** random.uniform(-1, 1, count)]), np.concatenate([y, spread(random, 4, 9.8, count)])
    x, y = random.uniform(-1, 1, (2, count))
    wide = spread(random, -900, 900, count)
    return np.concatenate([x, wide]), np.concatenate([y, wide * spread(random, -60, 60, count)])


@pytest.mark.parametrize("name", ONE)
def test_functions_of_one_number(name):
    largest, at = worst(name, points(name, np.random.default_rng(11), 150))
    assert largest <= BOUNDS[name], float(at).hex()


@pytest.mark.parametrize("name", TWO)
def test_functions_of_two_numbers(name):
    largest, at = worst(name, *pairs(name, np.random.default_rng(12), 150))
    assert largest <= BOUNDS[name], float(at).hex()


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES)
def test_many_arguments(name):
    random = np.random.default_rng(13)
    given = pairs(name, random, 600) if name in TWO else (points(name, random, 1000),)
    largest, at = worst(name, *given)
    assert largest <= BOUNDS[name], float(at).hex()


def everywhere():
    """Arguments for all functions: special ones with both signs, and random ones."""
    random = np.random.default_rng(14)
    special = np.array([*SPECIAL, *(-value for value in SPECIAL)])
    x, y = (values.reshape(-1) for values in np.meshgrid(special, special))
    random_ones = [random.uniform(-1, 1, 400), random.uniform(-30, 30, 400), random.uniform(-800, 800, 400)]
    random_ones += [spread(random, -1074, 1023, 400), 1.0 + 2.0 ** random.uniform(-52, 2, 400)]
    more = np.concatenate(random_ones)
    return np.concatenate([x, more]), np.concatenate([y, random.permutation(more)])


@pytest.fixture(scope="module")
def compiled_everywhere():
    """Arguments, and the values of all functions."""
    x, y = everywhere()
    return x, y, values(x, y)


@pytest.mark.parametrize("name", [*NAMES, "sine_and_cosine"])
def test_interpreted_and_compiled_and_arrays_have_the_same_bits(compiled_everywhere, name):
    x, y, found = compiled_everywhere
    given = (x, y) if name in TWO else (x,)
    expected = found[name]
    plain = interpreted_values(MODULES.get(name, circular), name, *given)
    assert same_bits(plain, expected).all(), x[~np.atleast_2d(same_bits(plain, expected)).all(0)][:5]
    if hasattr(elementwise, name):
        whole = np.asarray(getattr(elementwise, name)(*given))  # a warning would be an error
        assert same_bits(whole, expected).all(), x[~np.atleast_2d(same_bits(whole, expected)).all(0)][:5]


def test_both_at_once_are_each_alone(compiled_everywhere):
    _, _, found = compiled_everywhere
    assert same_bits(found["sine_and_cosine"][0], found["sine"]).all()
    assert same_bits(found["sine_and_cosine"][1], found["cosine"]).all()


def test_odd_functions_are_odd_and_even_ones_even(compiled_everywhere):
    x, y, found = compiled_everywhere
    other = values(-x, y)
    for name in ("sine", "tangent", "arcsine", "arctangent", "hyperbolic_tangent", "hyperbolic_sine"):
        assert same_bits(other[name], -found[name]).all(), name
    for name in ("cosine", "hyperbolic_cosine", "hypotenuse"):
        assert same_bits(other[name], found[name]).all(), name
    assert same_bits(other["arctangent2"], -found["arctangent2"]).all()
    assert same_bits(values(y, x)["hypotenuse"], found["hypotenuse"]).all()


SAME = [(x, x) for x in (0.0, -0.0, 5e-324, -5e-324, NAN)]
LOGARITHMS = [(0.0, -INF), (-0.0, -INF), (1.0, 0.0), (-1.0, NAN), (INF, INF), (-INF, NAN), (NAN, NAN)]
# as in annex F of C99
ANNEX_F = {
    "sine": [*SAME, (INF, NAN), (-INF, NAN)],
    "cosine": [(INF, NAN), (-INF, NAN), (0.0, 1.0), (-0.0, 1.0), (NAN, NAN)],
    "tangent": [*SAME, (INF, NAN), (-INF, NAN)],
    "arcsine": [*SAME, (1.0, math.pi / 2), (-1.0, -math.pi / 2), (1.0000000000000002, NAN), (INF, NAN)],
    "arccosine": [(1.0, 0.0), (-1.0, math.pi), (0.0, math.pi / 2), (-2.0, NAN), (NAN, NAN)],
    "arctangent": [*SAME, (INF, math.pi / 2), (-INF, -math.pi / 2)],
    "exponential": [
        (0.0, 1.0), (-0.0, 1.0), (INF, INF), (-INF, 0.0), (NAN, NAN), (1e300, INF), (-1e300, 0.0), (709.79, INF),
        (-745.1332191019412, 0.0), (-745.1332191019411, 5e-324),
    ],
    "logarithm": LOGARITHMS,
    "binary_logarithm": LOGARITHMS,
    "logarithm_1p": [*SAME, (-1.0, -INF), (-1.5, NAN), (INF, INF), (-INF, NAN)],
    "hyperbolic_tangent": [*SAME, (INF, 1.0), (-INF, -1.0), (30.0, 1.0)],
    "hyperbolic_sine": [*SAME, (INF, INF), (-INF, -INF), (-711.0, -INF)],
    "hyperbolic_cosine": [(0.0, 1.0), (-INF, INF), (NAN, NAN), (711.0, INF)],
    "inverse_hyperbolic_cosine": [(1.0, 0.0), (0.9999, NAN), (INF, INF), (-INF, NAN), (NAN, NAN)],
}  # fmt: skip


ANNEX_F_OF_TWO = {
    "arctangent2": [
        (0.0, 0.0, 0.0), (-0.0, 0.0, -0.0), (0.0, -0.0, math.pi), (-0.0, -0.0, -math.pi), (0.0, 1.0, 0.0),
        (-0.0, -1.0, -math.pi),
        (1.0, 0.0, math.pi / 2), (-1.0, -0.0, -math.pi / 2), (INF, INF, math.pi / 4), (INF, -INF, 3 * math.pi / 4),
        (-INF, -INF, -3 * math.pi / 4), (INF, 1.0, math.pi / 2), (1.0, -INF, math.pi), (1.0, INF, 0.0), (-1.0, INF, -0.0),
        (NAN, 1.0, NAN), (1.0, NAN, NAN), (5e-324, 1.0, 5e-324), (5e-324, 2.0, 0.0),
    ],
    "hypotenuse": [
        (INF, NAN, INF), (NAN, -INF, INF), (NAN, 0.0, NAN), (-3.0, 4.0, 5.0), (0.0, -0.0, 0.0), (1.7e308, 1.7e308, INF),
        (1e308, 1e308, math.sqrt(2.0) * 1e308), (3e-320, 4e-320, 5e-320), (5e-324, 0.0, 5e-324),
    ],
    "power": [
        *((x, y, 1.0) for x, y in ((NAN, 0.0), (0.0, -0.0), (INF, 0.0), (1.0, NAN), (1.0, INF), (-1.0, INF), (-1.0, -INF))),
        (NAN, 1.0, NAN), (2.0, NAN, NAN), (-8.0, 1.0 / 3.0, NAN), (-2.0, 3.0, -8.0), (-2.0, 4.0, 16.0), (0.0, 3.0, 0.0),
        (-0.0, 3.0, -0.0), (-0.0, 4.0, 0.0), (-0.0, 0.5, 0.0), (0.0, -3.0, INF), (-0.0, -3.0, -INF), (-0.0, -2.0, INF),
        (-0.0, -0.3, INF), (0.0, INF, 0.0), (-0.0, -INF, INF), (INF, 2.5, INF), (INF, -2.5, 0.0), (-INF, 3.0, -INF),
        (-INF, -3.0, -0.0), (-INF, 0.5, INF), (-INF, 2.5, INF), (0.5, INF, 0.0), (0.5, -INF, INF), (-3.0, INF, INF),
        (-3.0, -INF, 0.0), (2.0, 1023.0, 2.0**1023), (2.0, 1024.0, INF), (2.0, -1074.0, 5e-324), (2.0, -1076.0, 0.0),
        (-2.0, -1073.0, -1e-323), (-2.0, 9007199254740993.0, INF), (0.9, 1e300, 0.0), (1.1, 1e300, INF),
        (1.1, 0.5, math.sqrt(1.1)), (1.1, 2.0, 1.1 * 1.1), (-1.1, 1.0, -1.1), (10.0, 22.0, 1e22),
    ],
}  # fmt: skip


@pytest.mark.parametrize("name", [*ANNEX_F, *ANNEX_F_OF_TWO])
def test_special_values(name):
    *given, expected = np.array((ANNEX_F | ANNEX_F_OF_TWO)[name]).T
    same = same_bits(values(*given)[name], expected)
    assert same.all(), [case for case, right in zip(zip(*given, strict=True), same, strict=True) if not right]


def test_binary_logarithms_of_powers_of_two_are_exact():
    exponents = np.arange(-1074, 1024)
    found = values([math.ldexp(1.0, int(e)) for e in exponents])
    np.testing.assert_array_equal(found["binary_logarithm"], exponents)


def test_powers_that_are_exact():
    random = np.random.default_rng(15)
    x = np.abs(spread(random, -400, 400, 300))
    for exponent, expected in ((0.0, np.ones_like(x)), (1.0, x), (2.0, x * x), (0.5, np.sqrt(x))):
        assert same_bits(values(x, np.full_like(x, exponent))["power"], expected).all(), exponent
    whole = np.array([float(3**k) for k in range(33)])
    np.testing.assert_array_equal(values(np.full(33, 3.0), np.arange(33.0))["power"], whole)


@pytest.mark.parametrize(
    ("name", "breaks", "rising"),
    [
        ("sine", [k * math.pi / 512 for k in range(256)], True),
        ("cosine", [k * math.pi / 512 for k in range(1, 512)], False),
        ("tangent", [k * math.pi / 512 for k in range(256)], True),
        ("arcsine", [0.0, 1e-8, *(math.sin(k * math.pi / 512) for k in range(1, 256, 7)), 0.7071067811865475], True),
        ("arccosine", [1e-8, *(math.cos(k * math.pi / 512) for k in range(1, 256, 7)), 0.7071067811865475], False),
        ("arctangent", [*((j + 0.5) / 64 for j in range(64)), 1.0, *(64 / (j + 0.5) for j in range(64)), 2.0**-40], True),
        ("exponential", [k * math.log(2) / 128 for k in range(-200, 200)] + [-708.0, -708.3964185322641, 709.0], True),
        ("logarithm", [2.0**-1022, math.sqrt(0.5), math.sqrt(2.0), *((j + 0.5) / 128 for j in range(64, 512))], True),
        ("binary_logarithm", [(j + 0.5) / 128 for j in range(64, 512)] + [math.sqrt(0.5), math.sqrt(2.0)], True),
        ("logarithm_1p", [1e-9, -1e-9, *((j + 0.5) / 128 for j in range(64))], True),
        ("hyperbolic_tangent", [0.125, 20.0, *(k * math.log(2) / 256 for k in range(50, 200))], True),
        ("hyperbolic_sine", [0.25, 40.0, *(k * math.log(2) / 128 for k in range(50, 200))], True),
        ("hyperbolic_cosine", [40.0, *(k * math.log(2) / 128 for k in range(1, 200))], True),
        ("inverse_hyperbolic_cosine", [1.0000001, 2.0**28, *np.cosh(np.linspace(0.01, 3, 60))], True),
    ],
)  # fmt: skip
def test_functions_are_monotonic_across_breakpoints(name, breaks, rising):
    for point in breaks:
        x = np.array([point])
        for _ in range(4):
            x = np.unique(np.concatenate([x, np.nextafter(x, -INF), np.nextafter(x, INF)]))
        steps = np.diff(values(x)[name])
        assert np.all(steps >= 0.0 if rising else steps <= 0.0), point


def test_arrays_of_any_shape_and_numbers():
    grid = np.linspace(-2.0, 300.0, 24).reshape(2, 3, 4)
    names = ("sine", "cosine", "tangent", "arcsine", "arccosine", "arctangent2", "hypotenuse", "exponential", "logarithm")
    for name in names:
        function = getattr(elementwise, name)
        given = (grid, grid[..., ::-1]) if name in TWO else (grid,)
        found = function(*given)
        assert found.shape == grid.shape, name
        for index in ((0, 0, 0), (1, 2, 3), (0, 1, 2)):
            one = function(*(float(value[index]) for value in given))
            assert type(one) is float, name
            assert same_bits(found[index], one).all(), name
        assert function(*(np.empty((0, 3)) for _ in given)).shape == (0, 3)
    assert elementwise.arctangent2(grid, 2.0).shape == grid.shape
    assert elementwise.hypotenuse(grid[0, 0], np.ones((5, 1))).shape == (5, 4)
    assert elementwise.sine(3).hex() == elementwise.sine(3.0).hex()  # an integer is a number as well
    both = elementwise.sine_and_cosine(grid)
    assert both[0].shape == both[1].shape == grid.shape
    assert elementwise.sine_and_cosine(0.3) == (elementwise.sine(0.3), elementwise.cosine(0.3))
    many = np.random.default_rng(16).uniform(-500, 500, 20000)
    assert same_bits(elementwise.sine(many[::-1])[::-1], elementwise.sine(many)).all()
    assert same_bits(elementwise.sine_and_cosine(many)[1], elementwise.cosine(many)).all()


def test_kernels_use_nothing_of_the_c_library():
    """Only what IEEE 754 prescribes is called by name; what the interpreter calls instead is exact too."""
    exact = {"sqrt", "floor", "copysign", "inf", "nan", "ldexp", "frexp", "factorial"}
    for module in (circular, arcs, exponentials):
        source = inspect.getsource(module)
        named = {
            word.split("(")[0] for line in source.splitlines() for word in line.split("math.")[1:] for word in [word.split()[0]]
        }
        assert {name.rstrip(",.:)") for name in named} <= exact, module.__name__
        assert "np." not in source.replace("np.array(", "")


def bits_of(value):
    """The number of bits of a double from its first to its last one that is set."""
    significand = abs(value.as_integer_ratio()[0])
    return 0 if significand == 0 else significand.bit_length() - ((significand & -significand).bit_length() - 1)


def test_tables_are_short_enough_for_exact_products():
    assert max(bits_of(high) for high, _ in tables.SINES.tolist()) <= 26
    assert max(bits_of(high) for high, _ in tables.POWERS.tolist()) <= 26
    assert max(bits_of(row[0]) for row in tables.LOGARITHMS.tolist()) <= 10
    assert all((row[1] * 2.0**42).is_integer() for row in tables.LOGARITHMS.tolist())
    assert (tables.LN2_HIGH * 2.0**42).is_integer()
    largest = round(circular.NEAR * tables.ANGLE_INVERSE)
    assert largest < 2**14
    assert max(bits_of(tables.ANGLE_1), bits_of(tables.ANGLE_2)) <= 39
    assert bits_of(tables.OCTAVE_1) <= 36
    assert round(800 * tables.OCTAVE_INVERSE) < 2**17
