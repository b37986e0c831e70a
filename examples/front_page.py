"""
The moving picture of the documentation's front page
====================================================

The article's hop, 3.1 m/s from the top on μ = 1, as an SVG that moves by itself: keyframes at equal steps of time and at
every event, a few kilobytes. Lines take the colour of the text around the picture, so that it fits light and dark pages.
"""

import sys
from pathlib import Path

import numpy as np

import hophoop as hh
from hophoop.vocabulary import colors, names

SLOWER, HOLD = 2.4, 1.0  # seconds of picture for one second of motion; seconds that the last pose stays
STEPS = 64
LEFT, RIGHT, TOP, BOTTOM = -1.2, 10.0, -2.75, 0.62  # of the picture [m], y downwards from the plane

motion = hh.simulate(hh.article.scenarios()["hop"].replace("duration", 1.9))
times = np.unique(np.concatenate([np.linspace(0.0, motion.duration, STEPS), [event.t for event in motion.events]]))
state = motion.at(times)
hoop = motion.scenario.hoop
length = motion.duration * SLOWER + HOLD

# %%
# The poses: the centre is moved, the ring turned, and its colour is that of the mode.


def keyframes(name, frames):
    """CSS keyframes of (time of the motion, declaration); the last one stays to the end."""
    share = [f"{100 * time * SLOWER / length:.3f}%{{{what}}}" for time, what in frames]
    return f"@keyframes {name}{{{''.join(share)}100%{{{frames[-1][1]}}}}}"


def place(k):
    return f"translate({state.x[k]:.3f}px,{-hoop.radius - state.height[k]:.3f}px)"


def turn(k):
    return f"rotate({np.degrees(state.angle[k]):.2f}deg)"


def word(event):
    return names.mode_word(event.to_mode, event.omega)


begins = [event for event in motion.events if event.kind == "start" or event.from_mode != event.to_mode]
inks = [(event.t, f"stroke:{colors.mode_color(word(event))}") for event in begins]
style = "".join(
    [
        keyframes("hop-place", [(time, f"transform:{place(k)}") for k, time in enumerate(times)]),
        keyframes("hop-turn", [(time, f"transform:{turn(k)}") for k, time in enumerate(times)]),
        keyframes("hop-ink", inks),
        f".hop-place,.hop-turn,.hop-ink{{animation:{length:.2f}s linear infinite}}",
        ".hop-place{animation-name:hop-place}.hop-turn{animation-name:hop-turn}.hop-ink{animation-name:hop-ink;animation-timing-function:step-end}",
        ".hop-picture:hover *{animation-play-state:paused}",
        "@media (prefers-reduced-motion:reduce){.hop-picture *{animation:none!important}}",
    ]
)

# %%
# What stands still: the plane with a word for each mode, and the ways of load and centre of gravity.


def path(radius, chosen=slice(None)):
    """The way of a point on the line from the centre to the load."""
    x = state.x + radius * np.sin(state.angle)
    y = -hoop.radius - state.height - radius * np.cos(state.angle)
    return "M" + " ".join(f"{a:.2f},{b:.2f}" for a, b in np.column_stack([x, y])[chosen])


ground = []
for event, following in zip(begins, [*begins[1:], motion.events[-1]], strict=True):
    ink = colors.mode_color(word(event))
    ground.append(f'<path d="M{event.x:.3f},0.06H{following.x:.3f}" stroke="{ink}" stroke-width=".12"/>')
    middle = (event.x + following.x) / 2.0
    ground.append(f'<text x="{middle:.2f}" y=".5" fill="currentColor">{names.WORDS[word(event)].verb}</text>')

takeoff, landing = motion.find("takeoff")[0].t, motion.find("impact")[0].t
airborne = np.flatnonzero((times >= takeoff) & (times <= landing))
still = int(np.argmin(abs(times - motion.find("apex")[0].t)))  # shown where pictures are asked not to move
shift = f"translate({state.x[still]:.3f} {-hoop.radius - state.height[still]:.3f})"
spokes = "".join(f'<path d="M0,0L{np.sin(a):.3f},{-np.cos(a):.3f}"/>' for a in np.radians(np.arange(60.0, 360.0, 60.0)))

picture = f"""<svg xmlns="http://www.w3.org/2000/svg" class="hop-picture" role="img" width="100%" \
viewBox="{LEFT} {TOP} {RIGHT - LEFT:.2f} {BOTTOM - TOP:.2f}" fill="none" stroke-linecap="butt" \
font-family="sans-serif" font-size=".36" text-anchor="middle">
<title>A hoop with a load on its rim rolls, skids, rolls, spins, flies and rolls again.</title>
<style>@media(prefers-color-scheme:dark){{svg:root{{color:#ddd}}}}{style}</style>
<path d="M{LEFT},0H{RIGHT}" stroke="currentColor" stroke-opacity=".6" stroke-width=".02"/>
{"".join(ground)}
<path d="{path(hoop.radius)}" stroke="currentColor" stroke-opacity=".35" stroke-width=".025"/>
<path d="{path(hoop.eccentricity * hoop.radius)}" stroke="{colors.GRAVITY_CENTER}" stroke-width=".03"/>
<path d="{path(hoop.eccentricity * hoop.radius, airborne)}" stroke="{colors.GRAVITY_CENTER_AIRBORNE}" stroke-width=".05"/>
<g class="hop-place" transform="{shift}"><g class="hop-turn" transform="rotate({np.degrees(state.angle[still]):.2f})">
<g stroke="currentColor" stroke-opacity=".3" stroke-width=".02">{spokes}</g>
<circle r=".96" class="hop-ink" stroke="{colors.mode_color(word(begins[0]))}" stroke-width=".08"/>
<path d="M0,0V-.9" stroke="currentColor" stroke-opacity=".5" stroke-width=".03"/>
<circle cy="-.96" r=".15" fill="currentColor"/>
<circle cy="{-hoop.eccentricity:.3f}" r=".07" fill="{colors.GRAVITY_CENTER}"/>
</g></g>
</svg>
"""

# %%
# Give a file name to keep it: ``python examples/front_page.py docs/_static/hop.svg``.

if len(sys.argv) > 1:
    Path(sys.argv[1]).write_text(picture, encoding="utf-8")
