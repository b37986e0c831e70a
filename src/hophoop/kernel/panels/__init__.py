"""Pieces of rolling, slip and flight over which a motion is a series: solved, and searched for events."""
