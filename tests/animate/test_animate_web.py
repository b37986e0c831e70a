"""Scenes that turn: the page is whole without the network."""

import base64
import json
import re

import numpy as np
import pytest

from animate_tools import motion, places
from hophoop.animate import scene
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look3D
from hophoop.animate.web import scene_data
from hophoop.vocabulary.names import FLIGHT, MODE_WORDS


def page_data(path):
    text = path.read_text(encoding="utf-8")
    return text, json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)[1])


def numbers(packed):
    return np.frombuffer(base64.b64decode(packed["f32"]), "<f4").reshape(packed["shape"])


def test_the_page_is_whole(tmp_path):
    label = '</script><b>"&'
    path = scene(motion(), tmp_path / "hop.html", look=Look3D(labels=[label]))
    assert [entry.name for entry in tmp_path.iterdir()] == ["hop.html"]
    text, data = page_data(path)
    # nothing is fetched: no address at all stands in it; and a label cannot break it
    assert not re.search(r"https?://|src=|@import|url\(|<link|<!--|/\*DATA\*/", text)
    assert "<title>&lt;/script&gt;&lt;b&gt;&quot;&amp;</title>" in text
    hoop = data["hoops"][0]
    assert hoop["label"] == label
    frames = hoop["frames"]
    times = numbers(frames["t"])
    np.testing.assert_allclose(times, np.arange(121) / 60, atol=1e-6)
    angle = numbers(frames["angle"])
    center = np.stack([numbers(frames["x"]), numbers(frames["height"]) + hoop["radius"]], axis=-1)
    load = center + hoop["load"] * np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    np.testing.assert_allclose(load, places(motion(), np.minimum(times, 2.0)), atol=2e-6)
    assert [data["modes"][code][0] for code in sorted(set(frames["mode"]))] == ["rolling", "spinning", "skidding", "in flight"]
    assert path.stat().st_size < 200_000


def test_slow_motion_traces_and_forces_in_the_data():
    slow = scene_data([motion()], Timing(fps=60, slow_at=("takeoff",)), Look3D(forces=False))
    assert slow["rate"].min() < 0.13
    assert slow["newton"] is None
    path = slow["hoops"][0]["path"]
    flown = path["t"][path["mode"] == MODE_WORDS.index(FLIGHT)]
    assert flown.min() == pytest.approx(motion().find("takeoff")[0].t)
    plain = scene_data([motion()], Timing(fps=60), Look3D(theme="dark", traces=False))
    hoop = plain["hoops"][0]
    assert hoop["path"] is None
    force = np.maximum(hoop["frames"]["normal_force"], np.abs(hoop["frames"]["friction_force"]))
    assert (plain["newton"] * force).max() == pytest.approx(1.3, rel=0.03)
    off, down = motion().find("takeoff")[0], motion().find("impact")[0]
    assert hoop["marks"] == [[off.t, off.x, "takeoff", "take-off"], [down.t, down.x, "impact", "landing"]]
    assert (hoop["tag"], slow["flies"]) == ("", True)


def test_several_hoops_in_the_data(tmp_path):
    two = scene_data([motion(2.0), motion(1.0)], Timing(fps=20), Look3D())
    assert not two["flies"]
    assert [hoop["tag"] for hoop in two["hoops"]] == ["A", "B"]
    with pytest.raises(ValueError, match="must be the same in all motions"):
        scene([motion(), motion(2.0, slope=0.1)], tmp_path / "a.html")
    with pytest.raises(ValueError, match=r"must end in \.html\.$"):
        scene(motion(), tmp_path / "a.obj")
    assert not list(tmp_path.iterdir())


@pytest.mark.long
def test_the_page_plays_in_a_browser(tmp_path, new_page):
    """With the network cut: it draws, plays, and turns when dragged."""
    path = scene(motion(), tmp_path / "hop.html")
    page, problems = new_page(offline=True), []
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.on("console", lambda message: problems.append(message.text) if message.type == "error" else None)
    page.goto(path.as_uri() + "#t=1.2")
    page.wait_for_function("document.querySelector('.word') !== null")
    page.wait_for_timeout(500)
    assert page.inner_text(".word") == "in flight"
    assert page.inner_text(".t") == "t = 1.200 s"
    assert page.inner_text(".angle") == f"θ = {np.degrees(motion().at(1.2).angle):.1f}°"
    still = page.screenshot()
    page.mouse.move(500, 300)
    page.mouse.down()
    page.mouse.move(700, 300, steps=4)
    page.mouse.up()
    page.wait_for_timeout(300)
    assert page.screenshot() != still
    page.click("#play")
    page.wait_for_function("document.querySelector('.t').textContent.split(' ')[2] > 1.2")
    assert problems == []
