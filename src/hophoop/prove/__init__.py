"""Proofs: enclosures of every event of a rigid motion, certificates that its sequence is the one stated, gaits and chaos.

docs/proofs.md describes their assumptions, and how to check one without trusting the program.
"""

from hophoop.prove.boxes import Box, ProvedMap, prove_box, prove_map
from hophoop.prove.checker import Verdict, check
from hophoop.prove.gaits import ProvedChaos, ProvedGait, prove_chaos, prove_gait
from hophoop.prove.proof import Enclosure, Proof, ProvedEvent, prove
from hophoop.prove.statements import ProvedStatement, statements
from hophoop.prove.thresholds import ProvedNumber, thresholds

__all__ = [
    "Box",
    "Enclosure",
    "Proof",
    "ProvedChaos",
    "ProvedEvent",
    "ProvedGait",
    "ProvedMap",
    "ProvedNumber",
    "ProvedStatement",
    "Verdict",
    "check",
    "prove",
    "prove_box",
    "prove_chaos",
    "prove_gait",
    "prove_map",
    "statements",
    "thresholds",
]
