"""The numbers that the page shows at a time, digit by digit, compared with Python's."""

import math

import numpy as np
import pytest

import hophoop as hh
from lab_page_tools import SHOWN, picture, wait_for
from slow_page import also_delayed

# all that is written beside the hoop, at its arrows and in the legends of the diagrams
READ = """() => {
  const lab = hophoopLab;
  const drawn = {};
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    const force = /^([NF]) = (.*) N$/.exec(text);
    if (force) drawn[force[1]] = force[2];
    return fillText.call(this, text, ...place);
  };
  lab.drawStage();
  lab.drawTime();
  CanvasRenderingContext2D.prototype.fillText = fillText;
  const values = [...document.querySelectorAll(".readout dd")].map((one) => one.textContent);
  const legends = {};
  for (const value of document.querySelectorAll("[data-plot] .plot-key .value")) {
    const { textContent } = value.parentElement;
    const name = textContent.slice(0, textContent.length - value.textContent.length).trim();
    legends[`${value.closest(".plot").dataset.plot}: ${name}`] = value.textContent;
  }
  return { time: lab.clock.time, drawn, mode: values[1], angle: values[3], v: values[4], spin: values[5], legends };
}"""
SEEK = f"""times => times.map((time) => {{ hophoopLab.clock.seek(time); return ({READ})(); }})"""

SIGNS = str.maketrans({"−": "-", "⁻": "-", **{sign: str(place) for place, sign in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")}})


def agrees(text, exact):
    """Whether a shown number is the exact one, rounded to three digits: trailing zeros are not shown, but meant."""
    if math.isnan(exact):
        return text == "–"
    mantissa, _, power = text.translate(SIGNS).partition("·10")
    found = float(mantissa) * 10.0 ** int(power or 0)
    unit = 10.0 ** (math.floor(math.log10(abs(exact))) - 2) if exact else 0.0
    return abs(found - exact) <= 0.5 * unit * (1 + 1e-6) + 1e-12


def wrong(shown, motion):
    """What of a reading is not what Python computes, to three digits, a line each."""
    state = motion.at(shown["time"])
    hoop, plane = motion.scenario.hoop, motion.scenario.plane
    exact = {
        "velocities: v (centre)": state.vx,
        "velocities: R θ̇ (rotation)": state.omega * hoop.radius,
        "energies: kinetic": state.kinetic,
        "energies: potential": state.potential,
        "energies: total": state.kinetic + state.potential,
        "forces: normal N": state.normal_force,
        "forces: friction F": state.friction_force,
        "utilization: |F| / μN": state.utilization(plane),
        "own: gap under the rim": state.height,
    }
    legends = shown["legends"]
    assert set(exact) <= set(legends), sorted(legends)
    pairs = {name: (legends[name], value) for name, value in exact.items()}
    pairs["v"] = (shown["v"].removesuffix(" m/s"), state.vx)
    pairs["R θ̇"] = (shown["spin"].removesuffix(" m/s"), state.omega * hoop.radius)
    if "N" in shown["drawn"]:
        pairs["N"] = (shown["drawn"]["N"], state.normal_force)
    if "F" in shown["drawn"]:
        pairs["F"] = (shown["drawn"]["F"], state.friction_force)
    return [
        f"t = {shown['time']!r}: {name} {text} is {value!r}"
        for name, (text, value) in pairs.items()
        if not agrees(text, float(value))
    ]


# link, and a time at which a number was wrong
CASES = {
    "": [4.9843],
    "duration=60&start.speed=2&plane.mu=0.5": [57.3425],
    "plane.slope=0.1745&start.speed=1": [1.25],
    "contact.model=compliant&duration=2": [],
}


def test_every_number_shown_at_a_time_is_right(visit):
    page = visit("", viewport={"width": 1440, "height": 5000})
    for query, known in CASES.items():
        motion = hh.simulate(hh.Scenario.from_query(query))
        # odd times, not those of the film's own samples
        times = [*(np.linspace(0.0, motion.duration, 62)[1:-1] + 1e-4 * math.pi), *known]
        times = [min(float(time), motion.duration) for time in times]
        page.evaluate("query => hophoopLab.load(query)", query)
        wait_for(page, SHOWN)
        page.evaluate("() => { for (const plot of hophoopLab.plots.plots) hophoopLab.plots.seen.set(plot.element, true); }")
        faults = [line for shown in page.evaluate(SEEK, times) for line in wrong(shown, motion)]
        assert not faults, "\n".join([f"{query}: {len(faults)} of {len(times)} instants", *faults[:20]])


@also_delayed
def test_every_number_shown_in_play_is_right(visit):
    page = visit("", viewport={"width": 1440, "height": 5000})
    wait_for(page, SHOWN)
    page.evaluate(
        f"""() => {{
          globalThis.seen = [];
          hophoopLab.afterFrame = () => {{ if (seen.length < 30) seen.push(({READ})()); }};
          hophoopLab.clock.seek(4.2);
          hophoopLab.clock.play(true);
        }}"""
    )
    page.wait_for_function("() => seen.length === 30")
    motion = hh.simulate(hh.Scenario())
    assert [line for shown in page.evaluate("seen") for line in wrong(shown, motion)] == []


def test_a_diagram_says_that_its_axis_is_cut(visit):
    """A landing on a stiff contact is a spike of thousands of newtons."""
    page = visit("?contact.model=compliant&duration=3&start.speed=3.1")
    forces = "lab.plots.plots.find(({ definition }) => definition.key === 'forces')"
    wait_for(page, f"{forces}.box && lab.plots.films.length === 1")
    heights, cut, most = page.evaluate(
        f"(() => {{ const plot = {forces.replace('lab.', 'hophoopLab.')}; const force = hophoopLab.film().columns.normal_force;"
        "return [plot.windows.y, plot.cut, Math.max(...force)]; })()"
    )
    assert most > heights[1]
    assert float(cut["high"].replace(" ", "").replace("\u202f", "")) == pytest.approx(most, rel=0.01)


DRAWN = """(key) => {
  const lab = hophoopLab;
  const plot = lab.plots.plots.find((one) => one.definition.key === key);
  const said = [];
  const pen = CanvasRenderingContext2D.prototype;
  const { fillText } = pen;
  pen.fillText = function (text, ...place) { said.push(text); fillText.call(this, text, ...place); };
  plot.draw(lab.theme.colors);
  pen.fillText = fillText;
  // how much of the box is as dark as a line
  const { data, width, height } = plot.canvas.getContext("2d").getImageData(0, 0, plot.canvas.width, plot.canvas.height);
  const brown = data.filter((_, i) => i % 4 === 0 && data[i] > 100 && data[i] < 170 && data[i + 2] < 60).length;
  return [said.includes("band: range; line: mean"), brown / (width * height)];
}"""


def test_a_diagram_of_a_long_motion_is_a_band_with_a_line(visit):
    page = visit()
    for query in ("", "duration=60", "duration=600"):
        page.evaluate("query => hophoopLab.load(query)", query)
        wait_for(page, f"lab.plots.plots.at(-2).box && lab.plots.films[0] === lab.film() && {SHOWN}")
        told, share = page.evaluate(DRAWN, "utilization")
        assert told == (query == "duration=600")
        assert 0.002 < share < 0.45, query
        picture(page, f"diagrams-{query}", full_page=True)
