"""The ranges of a scenario's numbers as a table of the documentation.

python tests/fuzz/ranges_table.py > docs/tables/ranges.md
"""

from __future__ import annotations

from hophoop.kernel.physics.body import MOST_DEPTH
from hophoop.scenario import parameter
from hophoop.vocabulary.parameters import RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS

SECTIONS = ("duration", "hoop", "plane", "start", "contact")
PARTS = {"hoop.parts.mass": "kg", "hoop.parts.length": "m"}


def ranges_table() -> str:
    """In Markdown."""
    lines = ["| number | unit | may be |", "| --- | --- | --- |"]
    for path, allowed in sorted(RANGES.items(), key=lambda item: SECTIONS.index(item[0].partition(".")[0])):
        if path in ("plane.mu_static", "plane.mu_kinetic"):
            assert allowed == RANGES["plane.mu"]
            continue
        unit = PARTS.get(path) or parameter(path).unit
        names = "`plane.mu`, `plane.mu_static`, `plane.mu_kinetic`" if path == "plane.mu" else f"`{path}`"
        lines.append(f"| {names} | {'' if unit == '1' else unit} | {allowed.words()} |")
    lines += [
        f"| `contact.stiffness`, `contact.tangential_stiffness`, also | m g/R | {RELATIVE_STIFFNESS.words()} |",
        f"| `contact.slip_speed`, also | √(g R) | {RELATIVE_SLIP_SPEED.words()} |",
        f"| depth to which the speeds of a start press the rim of a compliant contact | R | up to {MOST_DEPTH:g} |",
    ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(ranges_table(), end="")
