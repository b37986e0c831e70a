"""The lab as a widget of a notebook."""

import pytest

import hophoop as hh
from hophoop.scenario import InputError

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


def test_the_widget_makes_files(widget):
    body = {"name": "motion.nc", "scenario": {"duration": 0.5}}
    widget._answer(widget, {"view": "a", "number": 3, "call": "file", "body": body}, [])
    ((content, buffers),) = widget.sent
    assert content == {"view": "a", "number": 3}
    assert buffers[0][1:4] == b"HDF"


def test_the_widget_says_what_is_wrong(widget):
    before = widget.motion
    body = {"name": "motion.nc", "scenario": {"hoop": {"mass": -1}}}
    widget._answer(widget, {"view": "a", "number": 4, "call": "file", "body": body}, [])
    refused = {"status": 422, "detail": "hoop.mass = -1.0 must be from 1e-12 to 1e+12 kg."}
    assert widget.sent[0][0] == {"view": "a", "number": 4, **refused}
    assert widget.motion is before


def test_show_refuses_what_is_no_motion():
    with pytest.raises(InputError, match="motion = int must be a Trajectory or a Scenario"):
        hh.show(3)
    with pytest.raises(InputError, match="panels holds 'chart'"):
        hh.show(HOP, panels=["chart"])


def test_the_widget_shows_a_defect_in_the_notebook(widget, monkeypatch):
    def broken(*_):
        raise ValueError("operands could not be broadcast together")

    monkeypatch.setattr("hophoop.lab.api.files.make", broken)
    with pytest.raises(ValueError, match="broadcast"):
        widget._answer(widget, {"view": "a", "number": 5, "call": "file", "body": {"name": "motion.nc", "scenario": {}}}, [])
    assert widget.sent == [({"view": "a", "number": 5, "status": 500}, None)]
