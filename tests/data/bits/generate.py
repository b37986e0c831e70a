"""Compute the motions of all scenarios of this folder and write the hashes of their bits.

The scenarios were drawn once, of all kinds mixed, so that any part of them is a sample. Doubles do not decide those of the
kind `doubt`.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bits_tools
import hophoop as hh

if __name__ == "__main__":
    text = bits_tools.hashes_text([bits_tools.bits_of(hh.simulate(each.scenario)) for each in bits_tools.kept_scenarios()])
    bits_tools.HASHES.write_text(text, encoding="utf-8")
    print(text.partition('\n "motions"')[0])
