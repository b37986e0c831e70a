"""Computation of motions: from a Scenario to a Trajectory."""
