"""The lab as a widget of a notebook."""

import gzip

import pytest

import hophoop as hh

HOP = hh.Scenario()


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(HOP)


@pytest.fixture
def widget(motion):
    pytest.importorskip("anywidget")
    made = hh.show(motion)
    made.sent = []
    made.send = lambda content, buffers=None: made.sent.append((content, buffers))
    return made


def test_the_widget_carries_its_motion(widget, motion):
    assert widget.given == widget.query == motion.scenario.to_query()  # the page computes it
    assert widget.motion is motion
    other = hh.simulate(HOP.replace("start.speed", 2.0))
    widget.motion = other
    assert widget.motion is other
    assert widget.given == widget.query == "start.speed=2"


def test_all_that_the_page_needs_travels_with_the_notebook(widget):
    assert {"given", "panels", "scripts", "module", "words", "query"} <= set(widget.get_state())


def test_the_widget_sends_the_module_of_fates_when_it_is_asked_for(widget):
    widget._answer(widget, {"number": 0.5}, [])
    ((content, buffers),) = widget.sent
    assert content == {"number": 0.5}
    assert gzip.decompress(buffers[0])[:4] == b"\0asm"
