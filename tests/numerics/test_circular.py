"""Sines and cosines where rounding or reducing the angle is hard, and other hard cases."""

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from elementary_tools import BOUNDS, EXACT, same_bits, values, worst
from hophoop.kernel.numerics import circular, elementwise

# Arguments whose result is next to a double or to the middle of two: V. Lefèvre and J.-M. Muller, Worst cases for correct
# rounding of the elementary functions in double precision (2001), and J.-M. Muller, Elementary functions (2016), chapter 12.
HARD = {
    "exponential": [
        "0x1.9e9cbbfd6080bp-31", "-0x1.ed318efb627eap-27", "-0x1.3475ac05cead7p-29", "0x1.83d4bcdebb3f4p+2",
        "0x1.c7206c1b753e4p+8", "0x1.accfbe46b4ef0p-1",
    ],
    "sine": [
        "0x1.fe767739d0f6dp-2", "0x1.e0000000001c2p-20", "0x1.9283586503fep-5", "0x1.d7bdcd778049fp-5",
        "0x1.a202b3fb84788p-4", "0x1.598bae9e632f6p-7",
    ],
    "cosine": ["0x1.8000000000009p-23", "0x1.34ec2f9fc9c00p+1", "0x1.06b505550e6b2p-9", "0x1.4000000000004p-22"],
    "tangent": ["0x1.dffffffffff1fp-22", "0x1.50486b2f87014p-5", "0x1.d696bfa988db9p-2"],
    "arccosine": ["0x1.fd737be914578p-11", "0x1.53ea6c7255e88p-4"],
    "arctangent": ["0x1.6298b5896ed3cp+1", "0x1.dffffffffff1fp-22"],
}  # fmt: skip


@pytest.mark.parametrize(("name", "text"), [(name, text) for name, texts in HARD.items() for text in texts])
def test_hard_cases(name, text):
    x = float.fromhex(text)
    with mp.workprec(400):
        exact = EXACT[name](mpf(x))
        halves = exact / mpf(2) ** (mp.frexp(abs(exact))[1] - 54)
        distance = abs(halves - mp.nint(halves))
        assert distance < mpf(2) ** -32  # hard indeed
        next_to_a_double = int(mp.nint(halves)) % 2 == 0
    largest, _ = worst(name, [x] if name in ("exponential", "arccosine") else [x, -x])
    assert largest <= (2.0**-30 if next_to_a_double else BOUNDS[name])


def test_the_angle_next_to_a_multiple_of_half_pi():
    """6381956970095103 2^797 is the double nearest to one, relative to its size (Kahan; Muller 2016, table 11.1)."""
    x = 6381956970095103.0 * 2.0**797
    found = values([x, -x])
    with mp.workprec(1400):
        rest = mp.cos(mpf(x))
        assert mpf(2) ** -61 < abs(rest) < mpf(2) ** -60
    for name in ("sine", "cosine", "tangent"):
        assert worst(name, [x, -x])[0] <= BOUNDS[name]
    assert found["cosine"][0] == found["cosine"][1] == -4.6871659242546277e-19
    assert found["sine"].tolist() == [1.0, -1.0]


def multiples(numbers):
    """The doubles nearest to multiples of π/512, with their neighbours."""
    found = []
    with mp.workprec(1400):
        for k in numbers:
            near = float(int(k) * mp.pi / 512)
            found += [math.nextafter(near, 0.0), near, math.nextafter(near, math.inf)]
    return found


@pytest.mark.parametrize("name", ["sine", "cosine", "tangent"])
def test_angles_next_to_breakpoints(name):
    """Odd ones are between two entries of the table; multiples of 256 are those of π/2, up to where the reduction changes."""
    near = multiples([*range(1, 256, 3), *range(1023, 32600, 2047), *range(256, 32600, 256)])
    change = [circular.NEAR, math.nextafter(circular.NEAR, 0.0), circular.TINY, math.nextafter(circular.TINY, 1.0)]
    assert worst(name, [*near, *change])[0] <= BOUNDS[name]


@pytest.mark.parametrize("name", ["sine", "cosine", "tangent"])
def test_far_angles_next_to_multiples_of_half_pi(name):
    random = np.random.default_rng(21)
    numbers = [256 * int(2.0**exponent * random.uniform(1, 2)) for exponent in range(5, 1014, 24)]
    assert worst(name, multiples(numbers))[0] <= BOUNDS[name]


def test_all_exponents():
    """Every exponent has its own digits of 1/2π."""
    random = np.random.default_rng(22)
    x = np.array([math.ldexp(random.uniform(1, 2), exponent) for exponent in range(-30, 1024)])
    for name in ("sine", "cosine"):
        assert worst(name, x)[0] <= BOUNDS[name]
    largest = [math.ldexp(2.0 - 2.0**-52, exponent) for exponent in range(6, 1024, 5)]
    assert worst("sine", largest)[0] <= BOUNDS["sine"]


def test_arrays_of_far_angles_have_the_same_bits():
    random = np.random.default_rng(23)
    x = np.concatenate([2.0 ** random.uniform(0, 1023.9, 3000), multiples(256 * 2 ** np.arange(1, 40))])
    x *= random.choice([-1.0, 1.0], x.size)
    found = values(x)
    assert same_bits(elementwise.sine(x), found["sine"]).all()
    assert same_bits(elementwise.cosine(x), found["cosine"]).all()
    assert same_bits(elementwise.tangent(x), found["tangent"]).all()
