"""Films of a motion."""
