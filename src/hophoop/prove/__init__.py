"""Proofs: enclosures of every event of a rigid motion, and certificates that its sequence is the one stated.

What they rest on, and how to check one without trusting the program, is said in docs/proofs.md.
"""

from hophoop.prove.checker import Verdict, check
from hophoop.prove.proof import Enclosure, Proof, ProvedEvent, prove

__all__ = ["Enclosure", "Proof", "ProvedEvent", "Verdict", "check", "prove"]
