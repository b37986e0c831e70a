"""What the page's scripts compute without a browser: windows of the map, flights, films; web/tests has the rest."""

import json
import math
import subprocess

import pytest

from hophoop.lab.site.controls import controls
from hophoop.lab.site.presets import presets
from hophoop.vocabulary.parameters import RANGES
from model.test_page_model import answers
from web_tools import bundled, english, needs_node, source

pytestmark = needs_node


@pytest.fixture(scope="module")
def js(tmp_path_factory):
    """Evaluates an expression with the exports of one of the page's modules."""
    folder = tmp_path_factory.mktemp("page")

    def evaluate(module, code, **values):
        given = "".join(f"const {name} = {json.dumps(value)};" for name, value in values.items())
        script = (folder / module).with_suffix(".mjs")
        script.write_text(bundled(source(module)), encoding="utf-8")
        program = (
            f"import * as lab from {json.dumps(script.as_uri())}; {given}"
            f"const plain = (_, value) => typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;"
            f"console.log(JSON.stringify((() => {{ {code} }})() ?? null, plain));"
        )
        done = subprocess.run(["node", "--input-type=module"], input=program, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    return evaluate


def test_the_page_knows_the_ranges_that_python_allows():
    for sliders in controls()["groups"].values():
        for info in sliders:
            allowed = RANGES[info["path"]]
            assert (info["allowed"]["least"], info["allowed"]["most"]) == (allowed.least, allowed.most), info["path"]
            assert [math.inf if value == "inf" else value for value in info["allowed"]["also"]] == list(allowed.also)


# The map


def test_a_map_stays_where_its_parameters_are_allowed(js):
    axes = controls()["map_axes"]
    code = """
      const map = new lab.MapAxes(axes);
      map.fit(600, 400);
      const seen = [];
      for (let k = 0; k < 30; k++) { map.zoom(2); seen.push(structuredClone(map.windows)); }
      map.drag(structuredClone(map.windows), -2000, 2000); seen.push(structuredClone(map.windows));
      map.drag(structuredClone(map.windows), 2000, -2000); seen.push(structuredClone(map.windows));
      return seen;
    """
    for windows in js("map_axes.ts", code, axes=axes):
        assert windows["y"][0] >= 0.0  # friction
        for name, path in (("x", "start.speed"), ("y", "plane.mu")):
            low, high = next(axis["allowed"] for axis in axes if axis["path"] == path)
            assert low <= windows[name][0] < windows[name][1] <= high
    assert js("clamp.ts", "return lab.within([-1, 2], [0, 10])") == [0, 3]
    assert js("clamp.ts", "return lab.within([8, 12], [0, 10])") == [6, 10]
    assert js("clamp.ts", "return lab.within([-5, 50], [0, 10])") == [0, 10]


def test_the_name_of_an_axis_has_room_beside_its_longest_number(js):
    code = """
      const map = new lab.MapAxes(axes);
      const wide = (text) => 6.5 * text.length;
      return [1, 1e-5, 1e-13].map((part) => {
        map.windows.y = [0.3, 0.3 + part];
        map.fit(600, 400, wide);
        return [map.left, Math.max(...map.axis('y', 9).marks.map(({ text }) => wide(text)))];
      });
    """
    for left, longest in js("map_axes.ts", code, axes=controls()["map_axes"]):
        assert left - 6 - longest > 18  # the numbers end 6 pixels beside the axis; the name takes 18


def test_a_map_says_when_its_starts_are_others(js):
    jam = next(preset for preset in presets() if preset.key == "jam").scenario.to_dict()
    code = "return [['start.speed', 'plane.mu'], ['start.vx', 'plane.mu']].map((paths) => lab.otherStart(scenario, paths))"
    said = js("map_words.ts", code, scenario=jam)
    assert [english(one) for one in said] == ["with a rolling start, unlike this motion", ""]
    said = js("map_words.ts", code, scenario={"start": {"speed": 3.1}})
    assert [english(one) for one in said] == ["", "with a start in any state; this motion starts rolling"]


# Where a flight begins


def test_a_flight_is_found_also_where_no_take_off_begins_it(js):
    import hophoop as hh

    for key in ("jam", "indeterminate", "hop"):
        scenario = next(preset for preset in presets() if preset.key == key).scenario
        motion = hh.simulate(scenario)
        assert "H" in motion.sequence, key
        events = json.loads(json.dumps(motion.to_dict()["events"]))
        found = js("events.ts", "return events.filter(lab.leaves).map(({ kind }) => kind)", events=events)
        assert found, key
        assert (found[0] == "takeoff") == (key == "hop")


# A film that is too long to be sent as densely as it is seen


def test_a_long_film_is_made_finer_where_one_looks(js):
    """Of 600 s come 6,000 samples; between two of them a fast hoop turns by a radian."""
    query = "duration=600&start.speed=2"
    (answer,) = answers("film", [{"query": query}])
    header, whole = answer["value"]["header"], answer["value"]["arrays"]
    (answer,) = answers("samples", [{"scenario": header["scenario"], "window": [299, 308]}])
    part = answer["value"]
    assert (part["t"][0], part["t"][-1]) == (299.0, 308.0)
    code = """
      const film = new lab.Film({ header, arrays: whole });
      const before = film.wanted(300);
      film.refine(part);
      return [before, [film.wanted(300), film.wanted(307, 4)],
              film.pieces().map((piece) => [piece.film === film, piece.from, piece.to])];
    """
    before, wanted, pieces = js("film.ts", code, header=header, whole=whole, part=part)
    assert before == [298.0, 306.0]
    assert wanted[0] is None
    assert wanted[1] == [305.0, 317.0]
    assert [own for own, *_ in pieces] == [True, False, True]
    t = whole["t"]
    assert t[pieces[0][2] - 1] < 299.0 <= t[pieces[0][2]]
    assert t[pieces[2][1]] > 308.0 >= t[pieces[2][1] - 1]


def test_a_short_film_asks_for_nothing(js):
    (answer,) = answers("film", [{"query": "duration=6"}])
    header, whole = answer["value"]["header"], answer["value"]["arrays"]
    assert js("film.ts", "return new lab.Film({ header, arrays: whole }).wanted(3, 4)", header=header, whole=whole) is None


# What theory and maps say


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


def test_motions_of_a_massless_hoop_are_told_apart_by_colour():
    from hophoop.vocabulary.colors import class_color

    colors = [class_color(name) for name in ("RMR", "MR", "RMKR", "MKR", "R")]
    parts = [[int(color[i : i + 2], 16) for i in (1, 3, 5)] for color in colors]
    for k, one in enumerate(parts):
        for other in parts[:k]:
            assert sum(abs(a - b) for a, b in zip(one, other, strict=True)) > 60
