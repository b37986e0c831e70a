"""Claims of the literature about the loaded hoop, compared with our numbers."""

from hophoop.claims.claim import Claim, Finding
from hophoop.claims.literature import count, findings, registry, works

__all__ = ["registry", "works", "findings", "count", "Claim", "Finding"]
