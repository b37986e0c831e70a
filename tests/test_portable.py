"""No source between a scenario and the results of its motion calls anything that rounds otherwise elsewhere."""

from __future__ import annotations

from pathlib import Path

from portable_lint import findings

PACKAGE = Path(__file__).parents[1] / "src" / "hophoop"
# From the numbers of a scenario to all that reads, maps or writes its motion.
COVERED = (
    "kernel/numerics", "kernel/physics", "kernel/panels", "kernel/records", "kernel/rigid", "kernel/compliant",
    "scenario", "precise", "derivatives", "theory", "maps", "lab/wasm", "results/records.py", "results/units.py",
    "results/poses.py", "results/save.py", "simulation/simulate.py", "simulation/rigid.py", "simulation/compliant.py",
    "simulation/event_errors.py", "simulation/trajectory.py", "_support/fingerprint.py",
)  # fmt: skip
WHOLE = "whole numbers"
WRITTEN_OUT = "products and quotients of complex numbers are written out in compliant/radau.py"
EXACT = "integers, fractions and numbers of mpmath"
# File or folder → what it does → why that is the same everywhere.
ALLOWED = {
    "kernel/numerics/circular.py": {"**": "powers of −1 and of 2"},
    "kernel/compliant/records.py": {"numpy.complex128": WRITTEN_OUT},
    "kernel/compliant/radau.py": {"complex": WRITTEN_OUT},
    "kernel/numerics/tables.py": {"numpy.complex128": WRITTEN_OUT},
    "derivatives/results/uncertainty.py": {"numpy.linalg": "decides only whether correlations that were given are refused"},
    "maps/grid/sweeping.py": {"sum": WHOLE},
    "maps/grid/memory.py": {"sum": WHOLE},
    "precise": {
        "**": EXACT,
        "sum": EXACT,
        "math.log2": "how many digits to compute with, or how long a step is",
        "math.log10": "how many digits to print",
    },
}


WRONG = {
    "import math\ny = math.sin(x)": "math.sin",
    "import math as m\ny = m.hypot(a, b)": "math.hypot",
    "from math import sqrt, exp": "math.exp",
    "import numpy as np\ny = np.exp(x)": "numpy.exp",
    "import numpy as np\ny = np.linalg.inv(a)": "numpy.linalg",
    "import numpy as np\ny = np.polynomial.legendre.leggauss(8)": "numpy.polynomial",
    "from numpy.polynomial import Polynomial": "numpy.polynomial",
    "import numpy as np\ny = np.dot(a, b)": "numpy.dot",
    "import numpy as np\ny = np.einsum('i,i', a, b)": "numpy.einsum",
    "import numpy as np\ny = np.interp(x, a, b)": "numpy.interp",
    "import numpy as np\ny = np.random.default_rng(1)": "numpy.random",
    "import numpy as np\ny = np.geomspace(a, b, 10)": "numpy.geomspace",
    "import numpy as np\ny = np.argsort(keys)": "argsort",
    "import numpy as np\ny = np.arange(0.0, 1.0, 0.1)": "arange",
    "y = keys.argsort()": "argsort",
    "y = a.dot(b)": ".dot",
    "y = a @ b": "@",
    "y @= b": "@",
    "y = x**2": "**",
    "y = 0.5**k": "**",
    "y = 10.0**-3": "**",
    "y = 2.0**0.5": "**",
    "x **= 3": "**",
    "y = pow(x, 3)": "pow",
    "y = sum(losses)": "sum",
    "y = sum(x * x for x in row)": "sum",
    "import cmath": "cmath",
    "from scipy.integrate import quad": "scipy.integrate",
    "y = complex(a, b)": "complex",
    "y = 0.0j": "complex",
    "import numpy as np\ny = np.zeros(3, np.complex128)": "numpy.complex128",
}
RIGHT = [
    "import math\ny = math.sqrt(x) + math.floor(x) + math.copysign(math.pi, x) + math.ldexp(x, 3)",
    "import numpy as np\ny = np.sqrt(np.sum(a)) + np.mean(a) + np.add.accumulate(a)[-1] + a.sum()",
    "import numpy as np\ny = np.argsort(keys, kind='stable')",
    "import numpy as np\ny = np.arange(26.0, 0.0, -1.0)",
    "y = 2**53 + 2.0**-30 + 0.25**3",
    "y = sum(1 for x in row) + sum(len(x) for x in row) + sum(x > 0.0 for x in row)",
    "from hophoop.kernel.numerics.circular import sine\ny = sine(x)",
    "y = row.sin",
]


def test_nothing_depends_on_the_machine() -> None:
    found, used = [], set()
    for name in COVERED:
        path = PACKAGE / name
        assert path.exists(), name
        for file in [path] if path.is_file() else sorted(path.rglob("*.py")):
            place = file.relative_to(PACKAGE).as_posix()
            for line, what in findings(file.read_text(encoding="utf-8")):
                allowed = [(where, what) for where, reasons in ALLOWED.items() if place.startswith(where) and what in reasons]
                used.update(allowed)
                if not allowed:
                    found.append(f"{place}:{line}: {what}")
    assert not found, "\n".join(found)
    assert used == {(place, what) for place, reasons in ALLOWED.items() for what in reasons}  # each is still needed


def test_what_depends_on_the_machine_is_found() -> None:
    for source, what in WRONG.items():
        assert [found.what for found in findings(source)] == [what], source
    assert {source: found for source in RIGHT if (found := findings(source))} == {}
    assert [found.line for found in findings("import math\n\n\ny = math.exp(1.0)\n")] == [4]
