"""Files that the served page keeps."""

import hophoop as hh
from lab_page_tools import follow


def test_it_is_kept(visit):
    page = visit("?start.speed=2.5")
    follow(page, [
        "click .share summary",
        "save Save a picture (PNG)",
        "is kept.startsWith('\\x89PNG\\r\\n\\x1a\\n')",
        "click .share summary",
        "save Save the states (CSV)",
        "is kept.startsWith('t [s],')",
        "press p",
        "until text('.code-dialog[open] pre').includes('hh.Start.rolling(speed=2.5)')",
        "press Escape",
        "click .share summary",
        "save Save the scenario (TOML)",
    ])  # fmt: skip
    assert hh.Scenario.loads(page.evaluate("kept")) == hh.Scenario(start=hh.Start.rolling(2.5))
