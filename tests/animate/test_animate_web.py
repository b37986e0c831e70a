"""Scenes that turn: the page is whole without the network, and glTF holds the motion."""

import base64
import json
import re
import struct
from itertools import pairwise

import numpy as np
import pytest

from animate_tools import motion, places
from hophoop.animate import scene
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look3D
from hophoop.animate.web import scene_data


def page_data(path):
    text = path.read_text(encoding="utf-8")
    return text, json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)[1])


def numbers(packed):
    return np.frombuffer(base64.b64decode(packed["f32"]), "<f4").reshape(packed["shape"])


def test_the_page_is_whole(tmp_path):
    path = scene(motion(), tmp_path / "hop.html")
    assert [entry.name for entry in tmp_path.iterdir()] == ["hop.html"]
    text, data = page_data(path)
    # nothing is fetched: no address at all stands in it
    assert not re.search(r"https?://|src=|@import|url\(|<link", text)
    assert "<!--" not in text
    assert "/*DATA*/" not in text
    assert data["count"] == 121
    hoop = data["hoops"][0]
    times = numbers(hoop["t"])
    np.testing.assert_allclose(times, np.arange(121) / 60, atol=1e-6)
    center, angle = numbers(hoop["center"]), numbers(hoop["angle"])
    load = center + hoop["load"] * np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    np.testing.assert_allclose(load, places(motion(), np.minimum(times, 2.0)), atol=2e-6)
    assert [data["modes"][code][0] for code in sorted(set(hoop["mode"]))] == ["rolling", "spinning", "skidding", "in flight"]
    assert data["modes"][data["flight"]][0] == "in flight"
    assert path.stat().st_size < 200_000


def test_labels_cannot_break_the_page(tmp_path):
    label = '</script><b>"&'
    text, data = page_data(scene(motion(), tmp_path / "a.html", look=Look3D(labels=[label])))
    assert data["hoops"][0]["label"] == label
    assert "<b>" not in text.replace("<\\/script><b>", "")
    assert "<title>&lt;/script&gt;&lt;b&gt;&quot;&amp;</title>" in text


def test_slow_motion_traces_and_forces_in_the_data():
    slow = scene_data([motion()], Timing(fps=60, slow_at=("takeoff",)), Look3D(forces=False))
    assert slow["count"] > 121
    assert slow["rate"].min() < 0.13
    assert slow["newton"] is None
    track = slow["hoops"][0]["traces"]
    flown = track["t"][track["airborne"] == 1]
    assert flown.min() == pytest.approx(motion().find("takeoff")[0].t)
    plain = scene_data([motion()], Timing(fps=60), Look3D(theme="dark", traces=False))
    assert plain["hoops"][0]["traces"] is None
    force = np.maximum(plain["hoops"][0]["normalForce"], np.abs(plain["hoops"][0]["frictionForce"]))
    lengths = plain["newton"] * force
    assert lengths.max() <= 1.3 * (1.0 + 1e-12)
    assert plain["steadyNewton"] == pytest.approx(plain["newton"].min(), rel=0.05)


def test_marks_letters_and_keys_in_the_data():
    one = scene_data([motion()], Timing(fps=20), Look3D())
    off, down = motion().find("takeoff")[0], motion().find("impact")[0]
    assert one["hoops"][0]["marks"] == [[off.t, off.x, "takeoff", "take-off"], [down.t, down.x, "impact", "landing"]]
    assert one["flies"]
    assert one["hoops"][0]["tag"] == ""
    two = scene_data([motion(2.0), motion(1.0)], Timing(fps=20), Look3D())
    assert not two["flies"]
    assert [hoop["tag"] for hoop in two["hoops"]] == ["A", "B"]


def read_glb(path):
    data = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    text = json.loads(data[20 : 20 + size])
    rest, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0"
    binary = data[28 + size :]
    assert len(binary) == rest == text["buffers"][0]["byteLength"]
    assert size % 4 == rest % 4 == 0

    def values(index):
        accessor = text["accessors"][index]
        view = text["bufferViews"][accessor["bufferView"]]
        kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        count = accessor["count"] * width
        assert view["byteOffset"] % 4 == 0
        assert view["byteLength"] == 4 * count
        found = np.frombuffer(binary, kind, count, view["byteOffset"]).reshape(-1, width)
        if "min" in accessor:
            np.testing.assert_array_equal(found.min(axis=0), np.float32(accessor["min"]))
            np.testing.assert_array_equal(found.max(axis=0), np.float32(accessor["max"]))
        return found

    return text, values


def turned(quaternion, vector):
    """A vector turned by x, y, z, w."""
    axis, w = quaternion[:3], quaternion[3]
    return vector + 2 * np.cross(axis, np.cross(axis, vector) + w * vector)


@pytest.mark.parametrize("slope", [0.0, 0.2])
def test_gltf_moves_the_load_as_the_motion_does(tmp_path, slope):
    run = motion(1.0, 1.0, 1.5, slope)
    text, values = read_glb(scene(run, tmp_path / "hop.glb"))
    names = [node["name"] for node in text["nodes"]]
    hoop = next(i for i, name in enumerate(names) if name.startswith("hoop"))
    (animation,) = text["animations"]
    tracks = {}
    for channel in animation["channels"]:
        if channel["target"]["node"] == hoop:
            sampler = animation["samplers"][channel["sampler"]]
            tracks[channel["target"]["path"]] = values(sampler["output"])
            times = values(sampler["input"])[:, 0]
    np.testing.assert_allclose(times, np.arange(len(times)) / 60, atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(tracks["rotation"], axis=1), 1.0, atol=1e-6)
    assert text["nodes"][hoop]["translation"] == pytest.approx(tracks["translation"][0], abs=1e-6)
    load = text["nodes"][names.index("load")]["translation"]
    wanted = places(run, np.minimum(times, 1.5))
    for k in range(0, len(times), 7):
        place = tracks["translation"][k] + turned(tracks["rotation"][k], np.array(load))
        np.testing.assert_allclose(place, [*wanted[k], 0.0], atol=1e-5)


def test_gltf_traces_are_whole_and_change_colour_in_flight(tmp_path):
    text, values = read_glb(scene(motion(), tmp_path / "hop.glb"))
    parts, paint = [], []
    for node in text["nodes"]:
        if node["name"].startswith("trace of the centre"):
            (part,) = text["meshes"][node["mesh"]]["primitives"]
            parts.append(values(part["attributes"]["POSITION"]))
            paint.append(tuple(text["materials"][part["material"]]["pbrMetallicRoughness"]["baseColorFactor"]))
    assert len(parts) == 3
    assert paint[0] == paint[2] != paint[1]
    for before, after in pairwise(parts):
        np.testing.assert_array_equal(before[-1], after[0])
    event = motion().find("takeoff")[0]
    np.testing.assert_allclose(parts[1][0][0], event.x + 0.75 * np.sin(event.angle), atol=0.05)


def test_gltf_meshes_are_sound(tmp_path):
    text, values = read_glb(scene([motion(), motion(2.0)], tmp_path / "two.glb"))
    for mesh in text["meshes"]:
        for part in mesh["primitives"]:
            points = values(part["attributes"]["POSITION"])
            assert np.isfinite(points).all()
            if "indices" in part:
                assert values(part["indices"]).max() < len(points)
            if "NORMAL" in part["attributes"]:
                normals = values(part["attributes"]["NORMAL"])
                np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
    for node in text["nodes"]:
        assert all(child < len(text["nodes"]) for child in node.get("children", ()))
    for sampler in text["animations"][0]["samplers"]:
        assert len(values(sampler["input"])) == len(values(sampler["output"]))


def test_pyvista_reads_the_gltf(tmp_path):
    """A reader that is not ours."""
    pyvista = pytest.importorskip("pyvista")
    blocks = pyvista.read(scene(motion(), tmp_path / "hop.glb"))
    assert blocks.combine().n_points > 2000


def test_what_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"must end in \.html or \.glb"):
        scene(motion(), tmp_path / "a.obj")
    with pytest.raises(ValueError, match="must be the same in all motions"):
        scene([motion(), motion(2.0, slope=0.1)], tmp_path / "a.html")
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_the_page_plays_in_a_browser(tmp_path):
    """With the network cut: it draws, plays, and turns when dragged."""
    sync_api = pytest.importorskip("playwright.sync_api")
    import shutil

    browser_path = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser_path is None:
        pytest.skip("no browser")
    path = scene(motion(), tmp_path / "hop.html")
    with sync_api.sync_playwright() as play:
        browser = play.chromium.launch(
            executable_path=browser_path,
            args=["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
        )
        page = browser.new_context(offline=True).new_page()
        problems = []
        page.on("pageerror", lambda error: problems.append(str(error)))
        page.on("console", lambda message: problems.append(message.text) if message.type == "error" else None)
        page.goto(path.as_uri() + "#t=1.2")
        page.wait_for_function("document.querySelector('.word') !== null")
        page.wait_for_timeout(500)
        assert page.inner_text(".word") == "in flight"
        assert page.inner_text(".t") == "t = 1.200 s"
        still = page.screenshot()
        page.mouse.move(500, 300)
        page.mouse.down()
        page.mouse.move(700, 300, steps=4)
        page.mouse.up()
        page.wait_for_timeout(300)
        assert page.screenshot() != still
        page.click("#play")
        page.wait_for_function("document.querySelector('.t').textContent.split(' ')[2] > 1.2")
        # also between two frames the numbers are those of one
        page.select_option("#rate", "0.1")
        read = """() => new Promise((done) => {
          const seen = [];
          const take = () => {
            seen.push([".t", ".angle"].map((name) => document.querySelector(name).textContent));
            if (seen.length < 15) requestAnimationFrame(take);
            else done(seen);
          };
          take();
        })"""
        times = numbers(page_data(path)[1]["hoops"][0]["t"])
        angles = np.degrees(motion().at(np.minimum(times, 2.0)).angle)
        frames = {f"t = {t:.3f} s": f"θ = {angle:.1f}°" for t, angle in zip(times, angles, strict=True)}
        page.evaluate("document.getElementById('time').value = 70; document.getElementById('time').oninput()")
        page.click("#play")
        readings = page.evaluate(read)
        assert len({time for time, _ in readings}) > 1
        assert [(time, angle) for time, angle in readings if frames.get(time) != angle] == []
        assert problems == []
        browser.close()
