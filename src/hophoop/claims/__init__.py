"""What the literature claims about the loaded hoop, our number beside it, computed anew, and the verdict."""

from hophoop.claims.claim import Claim, Finding
from hophoop.claims.literature import count, findings, registry, works

__all__ = ["registry", "works", "findings", "count", "Claim", "Finding"]
