"""A request of the page, as Python reads it."""

from hophoop.scenario import Scenario
from hophoop.scenario.paths import contradiction


def asked(body):
    """The scenario, or its link, with its changes; of two changes of one quantity the later counts."""
    scenario = Scenario.from_query(body["query"]) if "query" in body else Scenario.from_dict(body.get("scenario", {}))
    values = {}
    for path, value in body.get("changes", ()):
        if contradiction([*values, path]):
            scenario, values = scenario.with_values(values), {}
        values[path] = value
    return scenario.with_values(values)
