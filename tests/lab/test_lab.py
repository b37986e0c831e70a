"""The lab without a browser: frames, limits, files, controls, the script."""

import json
import math
import re

import numpy as np
import pytest

import hophoop as hh
from hophoop.lab.api import files, limits, packing
from hophoop.lab.api.motion import columns as motion_columns
from hophoop.lab.site import controls, export
from hophoop.scenario import InputError, paths

HOP = hh.Scenario()


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(HOP)


# Frames


def test_packed_arrays_come_back():
    arrays = {
        "t": np.array([0.0, 1e-17, 3.0]),
        "vx": np.array([1.5, np.inf]),
        "modes": np.eye(3, dtype=np.uint8),
    }
    header, back = packing.unpack(packing.pack({"words": "θ̇ → ∞"}, arrays))
    assert header == {"words": "θ̇ → ∞"}
    assert back["t"].dtype == np.float64
    for name, array in arrays.items():
        np.testing.assert_array_equal(back[name], array)


def test_every_array_starts_where_a_browser_can_read_it():
    block = packing.pack({}, {"modes": np.zeros(3, np.uint8), "t": np.zeros(2), "vx": np.zeros(1)})
    length = int.from_bytes(block[:4], "little")
    assert (length + 4) % 8 == 0
    listed = json.loads(block[4 : 4 + length])["arrays"]
    assert [entry["place"] % 8 for entry in listed] == [0, 0, 0]


def test_the_film_holds_both_sides_of_each_event(motion):
    columns = motion_columns(motion)
    landing = motion.find("impact")[0]
    before, after = np.flatnonzero(columns["t"] == landing.t)
    assert columns["vy"][before] == pytest.approx(landing.before.vy)
    assert columns["vy"][after] == 0.0
    assert columns["mode"][before] == 3
    assert columns["mode"][after] == 0
    assert (np.diff(columns["t"]) >= 0.0).all()
    assert columns["t"][0] == 0.0
    assert columns["t"][-1] == motion.duration
    for event in motion.events[1:-1]:
        assert np.count_nonzero(columns["t"] == event.t) == 2, event.kind


def test_frames_are_the_motion(motion):
    columns = motion_columns(motion)
    places = np.flatnonzero(np.diff(columns["t"], append=np.inf) > 0.0)[::50]
    sample = motion.at(columns["t"][places])
    for name in ("x", "height", "angle", "omega", "normal_force", "kinetic"):
        np.testing.assert_array_equal(columns[name][places], getattr(sample, name), name)


def test_utilization_is_one_in_slip_and_nowhere_above(motion):
    columns = motion_columns(motion)
    slip = np.isin(columns["mode"], (1, 2))
    np.testing.assert_allclose(columns["utilization"][slip], 1.0, rtol=1e-12)
    assert np.isnan(columns["utilization"][columns["mode"] == 3]).all()
    assert np.nanmax(columns["utilization"]) <= 1.0 + 1e-12


def test_a_motion_without_length_has_a_frame():
    jammed = hh.simulate(hh.Scenario(start=hh.Start(angle=0.0, vx=1.0, omega=1.0), duration=1e-9))
    assert len(motion_columns(jammed)["t"]) >= 2


# Limits


def test_limits_bound_a_motion():
    with pytest.raises(limits.TooMuch, match="duration = 601 must be at most 600 s"):
        limits.within(hh.Scenario(duration=601))
    with pytest.raises(limits.TooMuch, match="65 parts"):
        limits.within(hh.Scenario(hoop=hh.Hoop.from_parts(1, [hh.PointMass(1, at=1)] + 64 * [hh.Ring(1, 0.9, 1)])))
    assert limits.within(HOP).contact.max_events == limits.EVENTS
    own = hh.Scenario(contact=hh.Rigid(max_events=7))
    assert limits.within(own) is own


# Controls


def test_controls_are_parameters_with_valid_ends():
    offered = controls.controls()
    known = set(paths())
    for group in offered["groups"].values():
        for slider in group:
            assert slider["path"] in known
            for end in (slider["least"], slider["most"]):
                value = math.radians(end) if slider["degrees"] else end
                base = HOP
                if slider["path"].startswith("contact."):
                    base = HOP.replace("contact.model", "compliant")
                if slider["path"] == "plane.mu_static":
                    base = HOP.replace("plane.mu_kinetic", 0.0)
                if slider["path"] == "plane.mu_kinetic":
                    base = HOP.replace("plane.mu", 2.0)
                base.replace(slider["path"], value)
    for choice in offered["choices"]:
        for option, _ in choice["options"]:
            base = HOP
            if choice["path"] in ("contact.law", "contact.friction"):
                base = HOP.replace("contact.model", "compliant")
            base.replace(choice["path"], option)
    for axis in offered["map_axes"]:
        assert axis["path"] in known


# Files


def test_a_file_holds_the_motion(tmp_path, motion):
    (tmp_path / "motion.nc").write_bytes(files.make("motion.nc", HOP))
    loaded = hh.load(tmp_path / "motion.nc")
    assert loaded.at(1.3).x == motion.at(1.3).x
    with pytest.raises(InputError, match="must be one of motion"):
        files.make("../motion.nc", HOP)


def test_a_film_is_made_and_has_its_limit():
    pytest.importorskip("av")
    assert files.make("motion.gif", hh.Scenario(duration=0.2))[:4] == b"GIF8"
    with pytest.raises(limits.TooMuch, match="at most 20 s for a film"):
        files.make("motion.mp4", hh.Scenario(duration=21))


# The script


def test_the_scripts_import_each_other_and_nothing_else():
    names = {name for name in export.visited() if name.endswith(".js")}
    for name in names:
        found = re.findall(r'(?:}from|(?<=[;}\n])import|\bimport\()"([^"]*)"', export.static_text(name))
        assert {other.removeprefix("./") for other in found} <= names, name
    script = export.static_text("lab.js")
    (exported,) = re.findall(r"\bexport\{([^}]*)\}", script)
    words = {"current", "languageMenu", "name", "repeat", "say", "speakFrom", "t"}  # for the page that makes tags
    assert set(re.findall(r" as (\w+)", exported)) == {"default", "mount", *words}


def test_the_page_asks_for_nothing_from_elsewhere():
    for name in (*export.visited(), "index.html"):
        if not name.endswith((".js", ".css", ".html")):
            continue
        text = export.static_text(name)
        text = text.replace("\\\n", "")  # long lines are broken, also within a string
        assert not re.findall(r"https?://(?!www\.w3\.org/(?:2000/(?:svg|xmlns)|1999/xlink)\b)[^\s\"'`]+", text)


def test_a_long_motion_is_sampled_where_its_speed_is_extreme():
    motion = hh.simulate(hh.Scenario(duration=60.0))
    found = motion_columns(motion)
    coarse = motion.at(np.linspace(0.0, motion.duration, 6001))
    fine = motion.at(np.linspace(57.0, 60.0, 60_001))
    late = found["t"] > 57.0
    steady = coarse.t > 57.0
    exact = fine.vx.max()
    assert found["vx"][late].max() == pytest.approx(exact, rel=1e-5)
    assert found["vx"][late].max() >= coarse.vx[steady].max()
    bottoms = np.mod(found["angle"][late], 2.0 * np.pi) - np.pi
    assert np.abs(bottoms).min() < 1e-3 < np.abs(np.mod(coarse.angle[steady], 2.0 * np.pi) - np.pi).min()
