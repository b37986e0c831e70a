"""Generator of the kernels' tables, with 60 digits: `python tests/kernel_tables.py` writes kernel/numerics/tables.json.

Each entry is rounded once, to the nearest double, so that no table depends on a BLAS, a C library or a processor. Only mpmath
computes here; it has its own integer arithmetic. Quadrature nodes are rounded first, and all tables use the rounded nodes, at
which the kernels evaluate.
"""

import json
from functools import partial

from mpmath import mp

from hophoop.kernel.numerics.tables import FILE

DIGITS = 60
ORDER = 16  # Gauss–Legendre nodes of a panel
WIDEST = "0.9"  # rad, the widest panel
LEVELS = 96  # widths of panels, each narrower than the previous one by √2
STAGES = 5  # of Radau IIA
ZERO = "1e-45"  # a smaller entry is rounding of an exact 0
ANGLES = 128  # steps of the angle in a right angle, in the table of sines
POWERS = 64  # parts of an octave in the table of powers of 2
SHORT = 26  # bits of a table's high parts: the product with 27 bits is exact
GRID = 128  # significands of logarithms are near multiples of 1/GRID, from FIRST/GRID to LAST/GRID: √½ to √2
FIRST, LAST = 90, 182
ARCS = 64  # tangents are near multiples of 1/ARCS
CHUNK = 30  # bits per digit of 1/2π


def nearest(values):
    """Return the nearest doubles of a number, a complex number (as a pair) or nested lists of them."""
    if isinstance(values, list):
        return [nearest(value) for value in values]
    if isinstance(values, mp.mpc):
        return [nearest(values.real), nearest(values.imag)]
    return 0.0 if abs(values) < mp.mpf(ZERO) else float(values)


def tabulated(points, functions):
    """Return the values of functions (columns) at points (rows)."""
    return mp.matrix([[function(point) for function in functions] for point in points])


def from_left(polynomial):
    """Return the integral of a polynomial from −1."""
    return lambda x: mp.quad(polynomial, [-1, x], method="gauss-legendre")


def collocation():
    """Return nodes, weights, antiderivative and series of a panel, and the series of its halves."""
    guesses = [mp.cos(mp.pi * (k - mp.mpf(1) / 4) / (ORDER + mp.mpf(1) / 2)) for k in range(ORDER, 0, -1)]
    legendre = partial(mp.legendre, ORDER)  # its zeros are the nodes
    chebyshev = [partial(mp.chebyt, k) for k in range(ORDER)]
    nodes = [mp.findroot(legendre, guess, solver="newton") for guess in guesses]
    weights = [2 / ((1 - x * x) * mp.diff(legendre, x) ** 2) for x in nodes]
    rounded = [mp.mpf(nearest(x)) for x in nodes]
    series = tabulated(rounded, chebyshev) ** -1
    antiderivative = tabulated(rounded, [from_left(polynomial) for polynomial in chebyshev]) * series
    zeros = [mp.cos(mp.pi * (2 * k + 1) / (2 * ORDER)) for k in range(ORDER)]
    to_series = tabulated(zeros, chebyshev) ** -1

    def half(place):
        return to_series * tabulated([(x + place) / 2 for x in zeros], chebyshev)

    return {
        "NODES": nearest(nodes),
        "WEIGHTS": nearest(weights),
        "ANTIDERIVATIVE_T": nearest(antiderivative.T.tolist()),
        "SERIES": nearest(series.tolist()),
        "LEFT_T": nearest(half(-1).T.tolist()),
        "RIGHT_T": nearest(half(1).T.tolist()),
    }


def panels(nodes):
    """Return the widths of panels, and sine and 1 − cosine of the angles to their nodes and ends."""
    widths = [float(mp.mpf(WIDEST) * mp.mpf(2) ** (-mp.mpf(k) / 2)) for k in range(LEVELS)]
    # the angles in double precision, as a kernel computes them for a narrower panel
    offsets = [[mp.mpf(width * (1.0 + node) / 2.0) for node in nodes] for width in widths]

    def versine(angle):
        return 2 * mp.sin(angle / 2) ** 2

    return {
        "WIDTHS": list(widths),
        "NODE_SINES": nearest([[mp.sin(offset) for offset in row] for row in offsets]),
        "NODE_VERSINES": nearest([[versine(offset) for offset in row] for row in offsets]),
        "END_SINES": nearest([mp.sin(mp.mpf(width)) for width in widths]),
        "END_VERSINES": nearest([versine(mp.mpf(width)) for width in widths]),
    }


def radau_nodes():
    """Return the zeros of P_s − P_(s−1), from [−1, 1] to [0, 1]."""

    def difference(x):
        return mp.legendre(STAGES, x) - mp.legendre(STAGES - 1, x)

    return [*((1 + mp.findroot(difference, guess, solver="newton")) / 2 for guess in (-0.886, -0.446, 0.167, 0.72)), mp.mpf(1)]


def eigenvectors(matrix):
    """Return eigenvalues, and eigenvectors of length 1 whose largest component is real and positive."""
    values, vectors = mp.eig(matrix)
    for k in range(len(values)):
        largest = max(vectors[:, k], key=abs)
        vectors[:, k] *= mp.conj(largest) / (abs(largest) * mp.norm(vectors[:, k]))
    return values, vectors


def radau():
    """Return the constants of Radau IIA with 5 stages, order 9 (Hairer & Wanner, IV.8)."""
    nodes = radau_nodes()
    stages = range(STAGES)
    powers = mp.matrix([[node**q for node in nodes] for q in stages])
    # Σ_j a_ij c_j^q = c_i^(q+1)/(q+1)
    a = (powers**-1 * mp.matrix([[node ** (q + 1) / (q + 1) for node in nodes] for q in stages])).T
    inverse = a**-1
    # A⁻¹ has one real eigenvalue and two conjugate pairs, of which one member each is stored
    values, vectors = eigenvectors(inverse)
    real = min(stages, key=lambda k: abs(mp.im(values[k])))
    upper = sorted((k for k in stages if mp.im(values[k]) > 1e-6), key=lambda k: mp.re(values[k]))
    back = vectors**-1
    gamma = mp.re(values[real])
    last = vectors[STAGES - 1, real]
    # the solution of order 5 that also uses f at the start with weight 1/γ
    moments = mp.matrix([-1 / gamma, *[0] * (STAGES - 1)])
    defect = powers**-1 * moments
    error = defect.T * inverse
    dense = mp.matrix([[node ** (q + 1) for q in stages] for node in nodes]) ** -1
    return {
        "RADAU_NODES": nearest(nodes),
        "RADAU_A": nearest(a.tolist()),
        "RADAU_GAMMA": nearest(gamma),
        "RADAU_LAMBDA": nearest([mp.mpc(values[k]) for k in upper]),
        "RADAU_TO_REAL": nearest([mp.re(back[real, j] * last) for j in stages]),
        "RADAU_FROM_REAL": nearest([mp.re(vectors[i, real] / last) for i in stages]),
        "RADAU_TO_PAIR": nearest([[mp.mpc(back[k, j]) for j in stages] for k in upper]),
        "RADAU_FROM_PAIR": nearest([[mp.mpc(2 * vectors[i, k]) for k in upper] for i in stages]),
        "RADAU_DEFECT": nearest(list(defect)),
        "RADAU_ERROR": nearest(list(error)),
        "RADAU_POWERS": nearest(dense.tolist()),
    }


def split(value, *bits):
    """Return the value as a sum of doubles with this many bits each, and a last one with all bits."""
    found = []
    for count in bits:
        found.append(float(mp.mpf(value, prec=count)))
        value -= mp.mpf(found[-1])
    return [*found, float(value)]


def coarse(value):
    """Return the value as a multiple of 2⁻⁴², so that e ln 2 is exact for an exponent e, and the remainder."""
    high = float(mp.nint(value * 2**42) / 2**42)
    return [high, float(value - mp.mpf(high))]


def elementary():
    """Return the tables of sine, exponential, logarithm, arctangent and hyperbolic functions."""
    ln2, angle = mp.log(2), mp.pi / (2 * ANGLES)
    sines = [mp.sin(j * angle) for j in range(ANGLES)] + [mp.mpf(1)]
    # 1100 bits reach the largest double, plus 53 for its own bits and 210 for the digits after the point
    with mp.workprec(1600):
        bits = int(mp.floor(mp.ldexp(1 / (2 * mp.pi), CHUNK * 46)))
    logarithms = []
    for j in range(FIRST, LAST + 1):
        inverse = float(mp.mpf(mp.mpf(GRID) / j, prec=10))
        logarithms.append([inverse, *coarse(-mp.log(mp.mpf(inverse)))])
    double_doubles = {"PI": +mp.pi, "LOG2_E": 1 / ln2}
    found = {name: [float(x), float(x - mp.mpf(float(x)))] for name, x in double_doubles.items()}
    return found | {
        "ANGLE_INVERSE": float(1 / angle),
        "ANGLE": split(angle, 39, 39),
        "SINES": [split(value, SHORT) for value in sines],
        "REVOLUTIONS": [0, 0, *(bits >> CHUNK * (45 - i) & (1 << CHUNK) - 1 for i in range(46))],
        "OCTAVE_INVERSE": float(POWERS / ln2),
        "OCTAVE": split(ln2 / POWERS, 36),
        "POWERS": [split(mp.mpf(2) ** (mp.mpf(j) / POWERS), SHORT) for j in range(POWERS)],
        "LN2": coarse(ln2),
        "LOGARITHMS": logarithms,
        "ARCTANGENTS": [split(mp.atan(mp.mpf(j) / ARCS), 53) for j in range(ARCS + 1)],
        "TANH_SERIES": [float(value) for value in mp.taylor(mp.tanh, 0, 23)[3::2]],
        "SINH_SERIES": [float(1 / mp.factorial(2 * k + 3)) for k in range(7)],
    }


def tables():
    """Return all tables by name: a number, or nested lists of numbers."""
    with mp.workdps(DIGITS):
        found = collocation()
        return found | panels(found["NODES"]) | radau() | elementary()


def text():
    """Return the content of `tables.json`: a line per row, with the shortest decimals that give the same doubles."""
    lines = []
    for name, table in tables().items():
        rows = table if isinstance(table, list) and isinstance(table[0], list) else None
        content = json.dumps(table) if rows is None else "[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]"
        lines.append(f'"{name}": {content}')
    return "{\n" + ",\n".join(lines) + "\n}\n"


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8", newline="\n")
