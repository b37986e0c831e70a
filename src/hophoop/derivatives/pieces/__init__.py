"""Propagation of derivatives along the pieces of a motion between events."""
