"""The lab without a browser: frames, limits, files, controls, the script."""

import math
import re

import hophoop as hh
from hophoop.lab import export, limits
from model.test_page_model import answers
from web_tools import english, needs_node

HOP = hh.Scenario()


# Limits


def test_limits_bound_the_events_of_a_motion():
    assert limits.within(HOP).contact.max_events == limits.EVENTS
    own = hh.Scenario(contact=hh.Rigid(max_events=7))
    assert limits.within(own) is own


# The script


def test_the_page_asks_for_nothing_from_elsewhere():
    for name in (*export.visited(), "index.html"):
        if not name.endswith((".js", ".css", ".html")):
            continue
        text = export.static_text(name)
        text = text.replace("\\\n", "")  # long lines are broken, also within a string
        assert not re.findall(r"https?://(?!www\.w3\.org/(?:2000/(?:svg|xmlns)|1999/xlink)\b)[^\s\"'`]+", text)


# What theory says


@needs_node
def test_theory_says_what_can_be_said_on_every_slope():
    scenarios = [{"plane": {"slope": math.radians(23.0)}}, {"plane": {"slope": -0.1}}, {}]
    asked = [{"scenario": keys} for keys in scenarios]
    said = [answer["value"] for answer in answers("theory", asked)]
    steep, uphill, level = ({row["key"]: english(row["text"]) for row in rows} for rows in said)
    assert steep["first_slip"] == "would slip: any push is enough"
    for text in steep.values():
        assert "e-" not in text
    assert "no single threshold uphill" in uphill["uphill"]
    assert level["first_slip"] == "would slip above 2.043 m/s"
    assert "uphill" not in level
