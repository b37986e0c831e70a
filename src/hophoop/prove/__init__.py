"""Proofs: enclosures of every event of a rigid motion, certificates that its sequence is the one stated, and thresholds.

docs/proofs.md describes their assumptions, and how to check one without trusting the program.
"""

from hophoop.prove.checker import Verdict, check
from hophoop.prove.proof import Enclosure, Proof, ProvedEvent, prove
from hophoop.prove.thresholds import ProvedNumber, thresholds

__all__ = [
    "Enclosure",
    "Proof",
    "ProvedEvent",
    "ProvedNumber",
    "Verdict",
    "check",
    "prove",
    "thresholds",
]
