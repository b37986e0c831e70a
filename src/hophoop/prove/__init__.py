"""Proofs: enclosures of every event of a rigid motion, every decision certain, and thresholds.

docs/proofs.md describes what is proved, and what is trusted.
"""

from hophoop.prove.solver import Enclosure, Proof, prove
from hophoop.prove.thresholds import ProvedNumber, thresholds
from hophoop.results.records import EventRecord as ProvedEvent

__all__ = ["Enclosure", "Proof", "ProvedEvent", "ProvedNumber", "prove", "thresholds"]
