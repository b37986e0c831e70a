"""Derivatives of a motion with respect to all that it depends on, through every event."""
