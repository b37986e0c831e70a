"""Write the fingerprints of kept motions (fingerprints.json): the article's and the references here.

    python tests/data/fingerprints.py

Those of the lab's presets are in its tables: `python -m hophoop.lab.tables`.

To be run after each change of the kernels' bits, which CHANGELOG.md names; `tests/test_fingerprint.py` compares.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import hophoop as hh  # noqa: E402
from oracle_program import simulate  # noqa: E402
from oracles.cases import Case  # noqa: E402

FILE = HERE / "fingerprints.json"


def kept_scenarios() -> dict[str, hh.Scenario]:
    """By name, each of which says where the scenario is kept."""
    found = {f"article {name}": scenario for name, scenario in hh.article.scenarios().items()}
    for file in sorted(HERE.glob("*.json")):
        content = json.loads(file.read_text(encoding="utf-8"))
        if "case" in content and "events" in content:
            found[f"reference {file.stem}"] = simulate(Case(**content["case"])).scenario
    return found


if __name__ == "__main__":
    made = {name: hh.simulate(scenario).fingerprint for name, scenario in kept_scenarios().items()}
    before = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    FILE.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")
    print(f"{sum(before.get(name) != one for name, one in made.items())} of {len(made)} have changed: {FILE.name}")
