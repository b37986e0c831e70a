"""Compute the fingerprints in the shipped catalogue again (src/hophoop/maps/catalogue.json).

    python tests/data/catalogue_fingerprints.py

To be run after each change of the kernels' bits, which CHANGELOG.md names; `tests/maps/test_maps_catalogue.py` compares.
"""

import json
from pathlib import Path

import hophoop as hh

FILE = Path(__file__).resolve().parents[2] / "src" / "hophoop" / "maps" / "catalogue.json"


def renew(file):
    """Write all fingerprints anew, with one line per hoop; return how many have changed, in words."""
    catalogue = json.loads(file.read_text(encoding="utf-8"))
    changed = count = 0
    for gamma, hoop in catalogue["hoops"].items():
        for entry in hoop["entries"]:
            before = entry.get("fingerprint")
            example = hh.maps.Entry(**{**entry, "load_fraction": float(gamma), "fingerprint": ""})
            entry["fingerprint"] = hh.simulate(example.scenario()).fingerprint
            changed += entry["fingerprint"] != before
            count += 1
    lines = [f"{json.dumps(gamma)}:{json.dumps(hoop, separators=(',', ':'))}" for gamma, hoop in catalogue["hoops"].items()]
    text = f'{{"hophoop":{json.dumps(catalogue["hophoop"])},"hoops":{{\n' + ",\n".join(lines) + "\n}}\n"
    file.write_text(text, encoding="utf-8")
    return f"{changed} fingerprints of {count} have changed: {file.name}"


if __name__ == "__main__":
    print(renew(FILE))
