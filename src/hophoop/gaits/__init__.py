"""What becomes of the hoop in the end."""

from hophoop.gaits.runaway import Growth, Runaway, growth, runaway

__all__ = ["growth", "Growth", "runaway", "Runaway"]
