"""Propagation of derivatives through events: their conditions, impacts, and the state after them."""
