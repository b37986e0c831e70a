"""Pieces of rolling, slip and flight on which a motion is a series: their solution and the search for events."""
