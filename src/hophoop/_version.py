"""The version, for those who need only that."""

__version__ = "0.1.0"
