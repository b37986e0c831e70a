"""Generator of `elementary_constants.py`: tables of the elementary functions, computed with 60 digits.

`python -m hophoop.kernel.numerics.generate_elementary` writes the file. Every number is rounded once, to nearest, so that each
machine writes the same bytes. Only this module needs mpmath.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

FILE = Path(__file__).with_name("elementary_constants.py")
DIGITS = 60
STEPS = 128  # steps of the angle in a right angle
PARTS = 64  # parts of an octave in the table of powers of 2
SHORT = 26  # bits of a table's high parts: the product with 27 bits is exact
GRID = 128  # significands of logarithms are near multiples of 1/GRID
ARCS = 64  # tangents are near multiples of 1/ARCS
CHUNK = 30  # bits per digit of 1/2π


def _fraction(value: Any) -> Fraction:
    sign, digits, exponent, _ = value._mpf_
    return Fraction(-int(digits) if sign else int(digits)) * Fraction(2) ** exponent


def _nearest(value: Any) -> float:
    return float(_fraction(value))


def _shortened(value: Any, bits: int) -> float:
    """Return the nearest double with this many bits."""
    exact = _fraction(value)
    if exact == 0:
        return 0.0
    scale = Fraction(1)
    while abs(exact) * scale < 2 ** (bits - 1):
        scale *= 2
    while abs(exact) * scale >= 2**bits:
        scale /= 2
    return float(round(exact * scale) / scale)


def _split(value: Any, *bits: int) -> list[float]:
    """Return the value as a sum of doubles with this many bits each, and a last one with all bits."""
    from mpmath import mpf

    found = []
    for count in bits:
        found.append(_shortened(value, count))
        value -= mpf(found[-1])
    return [*found, _nearest(value)]


def _coarse(value: Any, unit: float) -> list[float]:
    """Return the value as a multiple of a unit, and the remainder."""
    from mpmath import mpf

    high = float(round(_fraction(value) / Fraction(unit)) * Fraction(unit))
    return [high, _nearest(value - mpf(high))]


def constants() -> dict[str, Any]:
    """Compute all constants of the elementary functions.

    Returns
    -------
    constants : dict
        Name → float, int, or (nested) list of these.
    """
    import mpmath
    from mpmath import mp, mpf

    with mp.workdps(DIGITS):
        pi, ln2 = +mp.pi, mp.log(2)
        angle = pi / (2 * STEPS)
        sines = [mp.sin(j * angle) for j in range(STEPS)] + [mpf(1)]
        octave = ln2 / PARTS
        made: dict[str, Any] = {
            "PI_HIGH": _nearest(pi),
            "PI_LOW": _nearest(pi - mpf(_nearest(pi))),
            # angles: k π/256 and a remainder
            "ANGLE_INVERSE": _nearest(1 / angle),
            "ANGLE_1": 0.0, "ANGLE_2": 0.0, "ANGLE_3": 0.0,
            "SINES": [_split(value, SHORT) for value in sines],
            # 1/2π in 30-bit digits, with 2 leading zeros
            "REVOLUTIONS": [0, 0],
            # exponents: k ln 2/64 and a remainder
            "OCTAVE_INVERSE": _nearest(1 / octave),
            "OCTAVE_1": 0.0, "OCTAVE_2": 0.0,
            "POWERS": [_split(mpf(2) ** (mpf(j) / PARTS), SHORT) for j in range(PARTS)],
            # ln 2 as a multiple of 2⁻⁴² and a remainder, so that e ln 2 is exact
            "LN2_HIGH": _coarse(ln2, 2.0**-42)[0],
            "LN2_LOW": _coarse(ln2, 2.0**-42)[1],
        }  # fmt: skip
        made["ANGLE_1"], made["ANGLE_2"], made["ANGLE_3"] = _split(angle, 39, 39)
        made["OCTAVE_1"], made["OCTAVE_2"] = _split(octave, 36)
        # 1100 bits reach the largest double, plus 53 for its own bits and 210 for the digits after the point
        with mp.workprec(1600):
            bits = int(mp.floor(mp.ldexp(1 / (2 * mp.pi), CHUNK * 46)))
        made["REVOLUTIONS"] += [bits >> CHUNK * (45 - i) & (1 << CHUNK) - 1 for i in range(46)]
        # for m near j/128 from √½ to √2: c near 1/m with 10 bits, and −log c as a multiple of 2⁻⁴² and a remainder
        first, last = 90, 182
        rows = []
        for j in range(first, last + 1):
            inverse = _shortened(mpf(GRID) / j, 10)
            rows.append([inverse, *_coarse(-mp.log(mpf(inverse)), 2.0**-42)])
        made["LOGARITHMS"] = rows
        made["LOG2_E_HIGH"], made["LOG2_E_LOW"] = _nearest(1 / ln2), _nearest(1 / ln2 - mpf(_nearest(1 / ln2)))
        made["ARCTANGENTS"] = [
            [_nearest(v), _nearest(v - mpf(_nearest(v)))] for v in (mp.atan(mpf(j) / ARCS) for j in range(ARCS + 1))
        ]
        # tanh x = x + x³ (c0 + c1 x² + …), sinh likewise
        made["TANH_SERIES"] = [_nearest(value) for value in mpmath.taylor(mp.tanh, 0, 23)[3::2]]
        made["SINH_SERIES"] = [_nearest(1 / mp.factorial(2 * k + 3)) for k in range(7)]
    return made


def _written(value: Any, indent: str = "") -> str:
    if isinstance(value, list):
        inner = indent + "    "
        if value and not isinstance(value[0], list):
            return "[" + ", ".join(_written(item) for item in value) + "]"
        return "[\n" + "".join(f"{inner}{_written(item, inner)},\n" for item in value) + indent + "]"
    return f'_h("{value.hex()}")' if isinstance(value, float) else str(value)


def text() -> str:
    """Write the module.

    Returns
    -------
    text : str
    """
    lines = [
        '"""Tables of elementary functions, made by `python -m hophoop.kernel.numerics.generate_elementary`; do not edit."""',
        "",
        "# fmt: off",
        "# ruff: noqa: E501",
        "from __future__ import annotations",
        "",
        "import numpy as np",
        "",
        "_h = float.fromhex",
        "",
        "",
        "def _frozen(rows, kind=np.float64):",
        "    table = np.array(rows, dtype=kind)",
        "    table.flags.writeable = False",
        "    return table",
        "",
        "",
    ]
    for name, value in constants().items():
        if isinstance(value, list):
            kind = ", np.int64" if isinstance(value[0], int) else ""
            lines.append(f"{name} = _frozen({_written(value)}{kind})")
        else:
            lines.append(f"{name} = {_written(value)}")
    return "\n".join(lines) + "\n"


def main() -> None:
    """Write the module next to this one."""
    FILE.write_text(text(), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
