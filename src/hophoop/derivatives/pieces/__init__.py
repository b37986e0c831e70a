"""How derivatives go along the pieces of a motion between events."""
