"""From a Scenario to a Trajectory."""
