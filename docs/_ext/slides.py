"""Slides for a class: one page with its films beside it, made from computed motions, without the network.

Sphinx makes them with the other pages. By itself: python docs/_ext/slides.py FOLDER
"""

from __future__ import annotations

import math
import shutil
import sys
from pathlib import Path
from typing import Any

from typeset import mathml

import hophoop as hh
from hophoop.animate import Look, Timing
from hophoop.theory import critical_speeds, rolling_forces, rolling_speed

STATIC = Path(__file__).parents[1] / "_static"
FONTS = Path(hh.__file__).parent / "article" / "fonts"  # the one of the report serves all pages
FILES = (STATIC / "slides.css", STATIC / "slides.js", FONTS / "hoop-math.woff2")
SIZE = (960, 440)
HOOP, PLANE = hh.Hoop.ideal(load_fraction=0.75, radius=0.4), hh.Plane(mu=1.0)  # the worksheet's
HOPS, ROLLS = 2.0, 1.25  # speeds that hop and that only roll [m/s]
DOWN_AND_UP = [math.radians(100), math.radians(260)]
ENERGY = r"\gamma m g\cdot 2R=(1-\gamma)\,m\,v^2"
NORMAL = r"N=m\left(g-\gamma\,\frac{v_0^2}{R}\right)"
AT_ONCE, CIRCLE, CONE = r"v_0=\sqrt{gR/\gamma}", r"\gamma R", r"\mu N"
FILMS: dict[str, tuple[tuple[float, float], ...]] = {  # speed [m/s] and friction of each motion
    "hop": ((HOPS, 1.0),),
    "roll": ((ROLLS, 1.0),),
    "friction": ((1.7, 0.02), (1.7, 0.2), (1.7, 1.0)),
}


def motion(speed: float, mu: float) -> hh.Trajectory:
    """The hoop of slides, worksheet and lessons."""
    return hh.simulate(HOOP, hh.Plane(mu=mu), hh.Start.rolling(speed), duration=1.3)


def make_films(folder: Path) -> None:
    """The films of the slides; the one of the hop also slowly."""
    for name, runs in FILMS.items():
        motions = [motion(*run) for run in runs]
        labels = [f"μ = {mu:g}" for _, mu in runs] if len(runs) > 1 else None
        look = Look(size=SIZE, forces=name == "roll", labels=labels)
        # the first slide asks what the hoop will do, so its film ends before the hoop takes off
        timing = Timing(fps=25, speed=0.5, end=0.9 * motions[0].find("takeoff")[0].t if name == "hop" else None)
        hh.animate.film(motions, folder / f"{name}.mp4", timing, look)
    slow = Timing(fps=25, speed=0.25, start=0.38, end=0.85)
    hh.animate.film(motion(HOPS, 1.0), folder / "slow.mp4", slow, Look(size=SIZE))


def film(name: str, words: str) -> str:
    """A film that is looped while its slide is shown."""
    return f'<video src="{name}.mp4" controls loop muted playsinline preload="metadata" aria-label="{words}"></video>'


def formula(latex: str) -> str:
    """By itself on its line."""
    return f'<div class="formula">{mathml(latex, display=True)}</div>'


def answer(words: str) -> str:
    """What is shown on demand, and not on paper."""
    return f"<details><summary>Answer</summary><p>{words}</p></details>"


def m(latex: str) -> str:
    """In a sentence."""
    return mathml(latex, display=False)


def slides() -> list[str]:
    """What stands on each; numbers are computed."""
    speeds = critical_speeds(HOOP, PLANE)
    bottom = float(rolling_speed(math.pi, HOOP, v0=0.0)) * HOOP.radius
    stone = (2 * PLANE.gravity * 2 * HOOP.radius) ** 0.5
    takeoff = motion(HOPS, 1.0).find("takeoff")[0]
    rolled = float(rolling_speed(takeoff.angle, HOOP, v0=HOPS))
    forces = rolling_forces(math.radians(260), HOOP, v0=ROLLS)
    ways = ["forwards" if force > 0 else "backwards" for force in rolling_forces(DOWN_AND_UP, HOOP, v0=ROLLS).friction]
    hop = " and ".join(f"{mu:g}" for speed, mu in FILMS["friction"] if "H" in motion(speed, mu).sequence)
    return [
        f"<h1>The hoop that hops</h1>{film('hop', 'A loaded hoop starts to roll')}"
        "<p class='quiet'>A ring with a heavy load on its rim. Three quarters of all mass is in the load.</p>",
        "<h2>Predict</h2><p class='ask'>You push the hoop. Where is the load when the hoop leaves the floor?</p>"
        "<ol type='A'><li>At the top</li><li>On the way down</li><li>At the bottom</li><li>On the way up</li></ol>"
        f"<p class='quiet'>Vote. Write down one reason.</p>{answer(f'At {math.degrees(takeoff.angle):.0f}°, on the way up.')}",
        f"<h2>First slowly: it only rolls</h2>{film('roll', 'The hoop rolls; arrows show the forces')}"
        "<p class='ask'>Which way does friction point on the way down, and on the way up?</p>"
        f"{answer(f'Down: {ways[0]}. Up: {ways[1]}, and so it brakes the rotation.')}",
        "<h2>Who has the energy?</h2><p>When the load is at the bottom, it is at rest: it is the point that touches the floor. "
        f"The ring has all the energy.</p>{formula(ENERGY)}"
        f"<p>The centre moves at {bottom:.2f} m/s. A stone that falls as far has {stone:.2f} m/s.</p>",
        "<h2>What would lift it?</h2><p>At the top the centre of gravity moves on a circle of radius "
        f"{m(CIRCLE)}. The floor carries what is left of the weight:</p>{formula(NORMAL)}"
        f"<p>It is zero at {m(AT_ONCE)} = {speeds.immediate_hop:.2f} m/s, for a hoop of 0.4 m radius.</p>"
        "<p class='ask'>So slower hoops stay on the floor?</p>"
        f"{answer(f'No: from {speeds.first_hop:.2f} m/s on they hop, because they slip first.')}",
        f"<h2>At {HOPS:g} m/s, four times slower</h2>{film('slow', 'The hoop takes off before the load is at the top')}"
        f"<p>It takes off at {math.degrees(takeoff.angle):.1f}°, before the load is at the top.</p>",
        "<h2>Three speeds</h2><table><tr><th>from</th><th>the hoop</th></tr>"
        f"<tr><td>{speeds.first_slip:.2f} m/s</td><td>slips</td></tr><tr><td>{speeds.first_hop:.2f} m/s</td><td>hops</td></tr>"
        f"<tr><td>{speeds.immediate_hop:.2f} m/s</td><td>is off the floor at once</td></tr></table>"
        "<p class='quiet'>R = 0.4 m, friction 1, the load starts at the top.</p>",
        "<h2>Why does it hop?</h2><ol><li>On the way up, friction has to brake the rotation.</li>"
        f"<li>It is at most {m(CONE)}, and {m('N')} is small there: {float(forces.normal):.1f} N of a weight of "
        f"{HOOP.mass * PLANE.gravity:.1f} N, at 260° and {ROLLS:g} m/s.</li>"
        "<li>So the rim slips, and the hoop keeps turning fast: "
        f"{takeoff.omega:.2f} rad/s where a rolling one would have {rolled:.2f} rad/s.</li>"
        "<li>The load comes up fast and lifts the hoop.</li></ol>",
        "<h2>More friction, more hop?</h2>"
        "<p class='ask'>1.7 m/s on ice, on a smooth and on a rough floor: which hops?</p>"
        f"{film('friction', 'Three hoops at the same speed on floors of different friction')}"
        f"{answer(f'With μ = {hop}: there is a best friction in between.')}",
        "<h2>Your turn</h2><ul><li>Worksheet, A1 to A9</li><li>The lab: <code>play.html</code> or <code>hophoop lab</code></li>"
        "<li>Build one: a bicycle rim, steel plates, cable ties</li></ul>"
        "<p class='quiet'>Computed with hophoop, after H. Sönnerlind, The physics of a hopping hoop (2023).</p>",
    ]


def make(folder: Path) -> Path:
    """Write slides, films, font and style into a folder; returns the page."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in FILES:
        shutil.copy(path, folder)
    make_films(folder)
    body = "\n".join(f"<section>{slide}</section>" for slide in slides())
    page = folder / "index.html"
    page.write_text(
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        '<title>The hoop that hops: slides</title><link rel="stylesheet" href="slides.css"></head><body>\n'
        f'<main>{body}</main>\n<footer aria-live="polite"></footer><script src="slides.js"></script></body></html>\n',
        encoding="utf-8",
    )
    return page


def after_the_pages(app: Any, error: Exception | None) -> None:
    """Make them where the page that links to them expects them."""
    if error is None and app.builder.name == "html":
        make(Path(app.outdir) / "teach" / "slides")


def setup(app: Any) -> dict[str, Any]:
    """When all pages are written."""
    app.connect("build-finished", after_the_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    print(make(Path(sys.argv[1])))
