"""Prove that every sequence of the catalogue for γ = 3/4 exists, and write the enclosures of its events into a folder.

    python examples/prove_catalogue.py proofs

Each proof is of a motion from rolling at the top up to the first of a whole turn, a turning point and a take-off.
"""

from __future__ import annotations

import sys
from pathlib import Path

from hophoop import prove
from hophoop.maps import catalogue

DIGITS = 3  # the sequence is the statement


def main(folder: Path) -> None:
    """Write the proofs and say how many there are."""
    folder.mkdir(parents=True, exist_ok=True)
    entries = catalogue()
    proved = 0
    for entry in entries:
        proof = prove.prove(entry.scenario(), DIGITS, until="revolution")
        if not proof.proved or (proof.sequence, proof.ending) != (entry.sequence, entry.ending):
            print(f"{entry.sequence} {entry.ending}: {proof.verdict}, {proof.why}")
            continue
        proved += 1
        proof.save(folder / f"{entry.sequence}-{entry.ending}.json")
    print(f"{proved} of {len(entries)} classes proved, {len({entry.sequence for entry in entries})} sequences")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "proofs"))
