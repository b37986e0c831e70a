"""Compute all motions of scenarios.json and write the hashes of their bits.

python tests/data/bits/generate.py
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bits_tools
import hophoop as hh

if __name__ == "__main__":
    kept = bits_tools.kept_scenarios()
    told = bits_tools.hashes_of([bits_tools.bits_of(hh.simulate(each.scenario)) for each in kept], kept)
    bits_tools.HASHES.write_text(bits_tools.hashes_text(told), encoding="utf-8")
    print("events", told["events"])
