"""The solver's tables with every entry off by up to one unit in the last place: a test that hangs on one rounding fails.

`pytest --other-tables 7 tests/rigid` draws them from the seed 7. Kernels are interpreted then, as compiled ones keep the tables
that they were compiled with. Tests of the tables themselves (numerics/test_tables.py) fail.
"""

from __future__ import annotations

import os

import numpy as np

# The tables of the elementary functions stay: their high parts have few bits, so that products are exact.
SOLVER = ("NODE", "WEIGHTS", "ANTIDERIVATIVE", "SERIES", "LEFT", "RIGHT", "WIDTHS", "END", "RADAU")


def other_table(table: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Return the table with each entry as it is or one unit above or below; 0 and ±1 stay, as every rounding has them."""
    steps = random.integers(-1, 2, table.shape)
    moved = np.where(steps > 0, np.nextafter(table, np.inf), np.where(steps < 0, np.nextafter(table, -np.inf), table))
    return np.where((table == 0.0) | (np.abs(table) == 1.0), table, moved)


def move_tables(seed: int) -> None:
    """Change the tables in place, before any module has taken something from them."""
    os.environ["HOPHOOP_KERNELS"] = "interpreted"
    from hophoop.kernel.numerics import tables

    random = np.random.default_rng(seed)
    for name, value in vars(tables).items():
        if not name.startswith(SOLVER):
            continue
        if isinstance(value, np.ndarray):
            # every other width is 0.9 over a power of 2, and a span of 0.9 rad the whole of a panel
            rows = slice(1, None, 2) if name == "WIDTHS" else slice(None)
            value[rows] = other_table(value[rows], random)
        elif isinstance(value, float):
            setattr(tables, name, float(other_table(np.array(value), random)))
