"""Figures of the pages on formulas, method, proofs, films, the article, filming a hoop, a phone in it, and the code."""

from __future__ import annotations

import math
from itertools import islice
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image, ImageDraw, ImageFont

import hophoop as hh
from hophoop.animate import Look, Timing
from hophoop.animate.film2d import Film2D
from hophoop.plots import colors
from hophoop.tracking import Reading, drawing
from hophoop.tracking.video import pictures, rgb

FILM, PHONE = (Path(__file__).parents[1] / name for name in ("film", "phone"))
SIZE = (7.6, 2.9)
WIDE = {"frameon": False, "fontsize": 10}


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def draw_required_friction(path: Path) -> None:
    """|F|/N over one revolution, for three speeds."""
    figure, ax = plt.subplots(figsize=SIZE, layout="constrained")
    angles = np.linspace(0.0, 2.0 * math.pi, 1441)
    hoop = hh.Hoop.ideal(0.75)
    for speed, color, dashes in ((0.1, colors.SERIES[1], "-"), (2.0, colors.SERIES[2], "--"), (2.5, colors.SERIES[4], "-.")):
        forces = hh.theory.rolling_forces(angles, hoop, v0=speed)
        needed = np.abs(forces.friction) / np.where(forces.normal > 0.0, forces.normal, np.nan)
        ax.plot(np.degrees(angles), needed, dashes, color=color, label=f"{speed:g} m/s")
        most = hh.theory.needed_friction(hoop, v0=speed)
        if math.isfinite(most.mu):
            ax.plot(math.degrees(most.angle), most.mu, "o", color=color)
    ax.axhline(1.0, color=colors.GRAY, lw=1.0)
    ax.set(xlim=(0.0, 360.0), ylim=(0.0, 1.6), xlabel="Rotation angle θ (°)", ylabel="Required friction |F|/N")
    ax.set_xticks(range(0, 361, 60))
    ax.legend(loc="upper center", **WIDE)
    save(figure, path)


def draw_phases(path: Path) -> None:
    """Phases and events of the reference hop."""
    figure, ax = plt.subplots(figsize=SIZE, layout="constrained")
    motion = hh.simulate(hh.Scenario(duration=2.0))
    marks = [event for event in motion.events if event.kind != "apex"]
    modes = {"R": "roll", "K": "skid", "S": "spin", "H": "flight"}
    named: set[str] = set()
    for letter, first, last in zip(motion.sequence, marks, marks[1:], strict=False):
        times = np.linspace(first.t, last.t, 400)[1:-1]
        word = modes[letter]
        label = word if word not in named else None
        named.add(word)
        ax.plot(times, motion.at(times).omega, color=colors.mode_color(word), lw=3, label=label)
    low, high = ax.get_ylim()
    high += 4.0  # for the names of events
    for event in marks[1:-1]:
        ax.axvline(event.t, color=colors.GRAY, lw=0.8)
        words = {"slip_start": "slip starts", "stick": "sticks", "takeoff": "take-off", "impact": "landing"}[event.kind]
        ax.annotate(words, (event.t, high), (3, -2), textcoords="offset points", fontsize=9, rotation=90, va="top")
    ax.set(xlim=(0.0, 2.0), ylim=(low, high), xlabel="Time (s)", ylabel="Angular velocity θ̇ (rad/s)")
    ax.legend(loc="center left", bbox_to_anchor=(0.0, 0.62), **WIDE)
    save(figure, path)


def draw_widths(path: Path) -> None:
    """Widths of the proved enclosures of the events' times."""
    figure, ax = plt.subplots(figsize=SIZE, layout="constrained")
    for digits, mark, color in ((18, "o", colors.SERIES[1]), (30, "s", colors.SERIES[2])):
        proof = hh.prove.prove(hh.Scenario(duration=2.0), digits=digits)
        inner = [event for event in proof.events if event.kind not in ("start", "end")]
        times = [float(event.t.middle) for event in inner]
        ax.semilogy(times, [2.0 * float(event.t.radius) for event in inner], mark, color=color, label=f"digits = {digits}")
    ulp = [math.ulp(time) for time in times]
    ax.semilogy(times, ulp, "_", ms=14, color=colors.GRAY, label="spacing of doubles there")
    ax.set(xlim=(0.0, 2.0), xlabel="Time of the event (s)", ylabel="Width of its enclosure (s)")
    ax.legend(loc="center right", **WIDE)
    save(figure, path)


def draw_track(path: Path) -> None:
    """What tracking finds in the sample film, and the fitted motion."""
    figure, ax = plt.subplots(figsize=SIZE, layout="constrained")
    track = hh.read_track(FILM / "track.json")
    found = hh.fit(track)
    since = track.t - track.t[0]  # the fitted motion starts with the first frame
    seen = np.isfinite(track.angle) & (since <= found.motion.duration)
    times, measured = track.t[seen], track.angle[seen]
    fitted = np.asarray(found.motion.at(since[seen]).angle)
    off = measured - fitted
    off -= np.round(np.median(off) / (2.0 * math.pi)) * 2.0 * math.pi
    ax.plot(times, np.degrees(fitted), color=colors.SERIES[2], lw=3, alpha=0.6, label="fitted motion")
    ax.plot(times[::4], np.degrees(fitted + off)[::4], ".", color=colors.BLACK, ms=5, label="film, every fourth frame")
    ax.set(xlabel="Time (s)", ylabel="Marker's angle (°)")
    ax.legend(**WIDE)
    save(figure, path)


def draw_phone(path: Path) -> None:
    """The sample record of a phone in the hoop, and the fitted motion."""
    figure, ax = plt.subplots(figsize=SIZE, layout="constrained")
    track = hh.read_track(PHONE / "gyroscope.csv", Reading(radius=0.3))
    found = hh.fit(track)
    t = np.linspace(0.0, float(track.t[-1]), 1500)
    ax.plot(t, found.motion.at(t).omega, color=colors.SERIES[2], lw=3, alpha=0.6, label="fitted motion")
    ax.plot(track.t, track.omega - found.values["omega_offset"], ".", color=colors.BLACK, ms=4, label="record (computed)")
    for kind, words in (("takeoff", "takes off"), ("impact", "lands")):
        event = next(event for event in found.motion.events if event.kind == kind)
        ax.axvline(event.t, color=colors.GRAY, lw=1.0)
        ax.text(event.t, 0.95, f" {words}", transform=ax.get_xaxis_transform(), va="top", fontsize=10)
    ax.set(xlabel="Time (s)", ylabel="Angular velocity (rad/s)")
    ax.legend(loc="upper left", **WIDE)
    save(figure, path)


def draw_marked_frame(path: Path) -> None:
    """A frame of the sample film, cut out around the hoop and enlarged, with what tracking finds in it."""
    row, half, zoom = 118, np.array([240.0, 130.0]), 1.5  # half the size of the cutting [pixels]
    track = hh.read_track(FILM / "track.json")
    view, centre, angle = track.view, track.centre[row], float(track.angle[row])
    image = Image.fromarray(rgb(next(islice(pictures(FILM / "hoop.mp4", view.rate), row, None))))
    drawing.draw(ImageDraw.Draw(image), view, track.radius, centre, angle)
    ways = np.array([[math.sin(turn), math.cos(turn)] for turn in (angle, angle + 2.4)])
    reach = track.radius * np.array([[view.marker_ratio], [1.0]])
    marker, rim, hub = view.to_picture(np.vstack([centre + reach * ways, centre]), track.radius)
    box = tuple(float(value) for value in (*(hub - half), *(hub + half)))
    size = tuple(int(value) for value in 2.0 * half * zoom)
    shown = image.resize(size, Image.Resampling.LANCZOS, box=box)
    pen, font = ImageDraw.Draw(shown), ImageFont.load_default(20)
    for words, spot, off, color in (
        ("marker", marker, (-120.0, -50.0), drawing.MARK),
        ("rim", rim, (110.0, 30.0), drawing.RIM),
        ("centre", hub, (190.0, 60.0), drawing.RIM),
    ):
        start = zoom * (spot - hub + half)
        end = tuple(start + off)
        pen.line([*start, *end], fill=color, width=2)
        side = "lm" if off[0] > 0 else "rm"
        pen.text(end, f" {words} ", fill=color, font=font, anchor=side, stroke_width=3, stroke_fill=drawing.DARK)
    shown.save(path, quality=88)


def draw_film(path: Path) -> None:
    """A picture of the film that the page on films makes first."""
    motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    film = Film2D([motion], Timing(slow_at="takeoff"), Look(panels=("velocity", "energy", "phase")))
    k = int(np.argmin(np.abs(film.clock.times[0] - 1.4)))
    Image.fromarray(film.draw(k)[..., :3]).quantize(160, dither=Image.Dither.NONE).save(path, optimize=True)


def draw_article(path: Path) -> None:
    """Two of the article's statements on the hop, and the computed motion."""
    figure, (gap, energy) = plt.subplots(1, 2, figsize=(7.6, 3.1), layout="constrained")
    motion = hh.simulate(hh.article.scenarios()["hop"].replace("duration", 2.0))
    takeoff, landing = motion.find("takeoff")[0], motion.find("impact")[0]
    times = np.linspace(0.85, 1.85, 1001)
    sample = motion.at(times)
    angles = np.degrees(sample.angle)
    ends = np.degrees([takeoff.angle, landing.angle])
    gap.axvline(360.0, color=colors.GRAY, lw=1.0, ls="--")
    gap.plot(angles, 100.0 * sample.height, color=colors.SERIES[1])
    gap.plot(ends, [0.0, 0.0], "o", color=colors.SERIES[1])
    gap.annotate(f"{ends[0]:.1f}°", (ends[0], 0.0), (2, 10), textcoords="offset points", ha="right", fontsize=10)
    gap.text(356.0, 28.0, "article: jumps\nbefore this", ha="right", va="top", fontsize=10)
    gap.set(xlabel="Rotation angle θ (°)", ylabel="Gap (cm)", xlim=(260.0, 520.0), ylim=(-2.0, 31.0))
    scenario = motion.scenario
    weight = scenario.hoop.mass * scenario.plane.gravity
    fraction, radius = scenario.hoop.eccentricity, scenario.hoop.radius
    potential = weight * (sample.height + fraction * radius * (np.cos(sample.angle) - 1.0))
    energy.axhline(0.0, color=colors.GRAY, lw=1.0)
    energy.axvspan(350.0, 395.0, color=colors.LIGHT_GRAY)
    energy.plot(angles, potential, color=colors.SERIES[2])
    energy.text(372.5, -3.6, "article:\nabove zero\n350° to 395°", ha="center", va="top", fontsize=10)
    turns = np.flatnonzero(np.diff(np.sign(potential)))
    bounds = angles[turns] - potential[turns] * np.diff(angles)[turns] / np.diff(potential)[turns]
    for bound, side in zip(bounds, ("right", "left"), strict=True):
        energy.plot([bound], [0.0], "o", color=colors.SERIES[2])
        energy.annotate(f"{bound:.1f}°", (bound, 0.0), (0, 6), textcoords="offset points", ha=side, fontsize=10)
    energy.set(xlabel="Rotation angle θ (°)", ylabel="Potential energy (J)", xlim=(315.0, 435.0), ylim=(-7.0, 1.2))
    for ax in (gap, energy):
        ax.set_xticks(range(260, 521, 60) if ax is gap else range(320, 441, 30))
    save(figure, path)


def draw_camera(path: Path) -> None:
    """Hoop, tape and camera, seen from above and from the side; not to scale."""
    figure, (top, side) = plt.subplots(1, 2, figsize=(7.6, 3.1), layout="constrained")
    ink, thin = {"color": colors.BLACK}, {"arrowstyle": "<->", "lw": 0.8, "color": colors.GRAY}
    for ax, title in ((top, "from above"), (side, "from the side, behind the camera")):
        ax.set_title(title, fontsize=10, loc="left")
        ax.set_aspect("equal")
        ax.axis("off")
    top.plot([0.0, 4.0], [0.0, 0.0], color=colors.GRAY, lw=5, solid_capstyle="butt")
    top.plot([1.0, 1.6], [0.0, 0.0], lw=7, **ink)
    top.annotate("", (2.6, 0.0), (1.7, 0.0), arrowprops={"arrowstyle": "->", "color": colors.BLACK})
    top.fill([1.85, 2.15, 2.15, 1.85], [-3.2, -3.2, -2.9, -2.9], **ink)
    top.plot([0.1, 2.0, 3.9], [0.0, -2.9, 0.0], ":", color=colors.GRAY)
    top.plot([0.0, 4.0], [0.5, 0.5], lw=2, color=colors.SERIES[1])
    top.annotate("", (4.25, 0.0), (4.25, -2.9), arrowprops=thin)
    top.text(4.35, -1.5, "4 m\nor more,\nzoomed in", fontsize=10, va="center")
    top.text(2.0, 0.65, "white card", fontsize=10, ha="center")
    top.text(1.3, -0.15, "hoop", fontsize=10, ha="center", va="top")
    top.text(2.25, -3.05, "camera on a tripod", fontsize=10, va="center")
    top.set(xlim=(-0.1, 5.9), ylim=(-3.4, 1.0))
    side.plot([0.0, 4.0], [0.0, 0.0], lw=2, **ink)
    side.add_patch(plt.Circle((1.3, 0.8), 0.8, fill=False, lw=4, **ink))
    angle = math.radians(40.0)
    side.plot([1.3, 1.3 + 0.7 * math.sin(angle)], [0.8, 0.8 + 0.7 * math.cos(angle)], lw=0.8, color=colors.GRAY)
    side.plot([1.3], [0.8], "o", ms=6, color=colors.SERIES[5])
    side.plot(1.3 + 0.62 * math.sin(angle), 0.8 + 0.62 * math.cos(angle), "o", ms=8, color=colors.SERIES[5])
    side.plot(1.3 + 0.8 * math.sin(angle), 0.8 + 0.8 * math.cos(angle), "s", ms=9, **ink)
    side.annotate(
        "dot on the line\nto the load", (1.78, 1.3), (2.3, 1.75), fontsize=10, arrowprops={"arrowstyle": "-", "lw": 0.6}
    )
    side.annotate("dot in\nthe centre", (1.3, 0.8), (2.3, 0.95), fontsize=10, arrowprops={"arrowstyle": "-", "lw": 0.6})
    side.plot([0.3, 3.7], [-0.3, -0.3], color=colors.SERIES[2], lw=5)
    side.text(2.0, -0.45, "metre rule", fontsize=10, ha="center", va="top")
    side.set(xlim=(-0.1, 4.3), ylim=(-0.9, 2.4))
    save(figure, path)


# The packages: each imports only from those to its right and from the rows below, as the contract in pyproject.toml says.
CODE = (
    (("cli", "commands"), ("lab", "page, server"), ("web/", "the page's scripts")),
    (("fitting", "parameters"), ("article", "reproduction"), ("animate", "films"), ("plots", "figures")),
    (
        ("maps", "sweeps"),
        ("tracking", "films to tracks"),
        ("gaits", "long term"),
        ("prove", "enclosures"),
        ("theory", "thresholds"),
    ),
    (("simulation", "4  Trajectory"), ("derivatives", "through events"), ("precise", "extended precision")),
    (("results", "5  Sample, events"), ("scenario", "1  input, checked"), ("vocabulary", "tables of facts")),
    (
        ("rigid", "3  event loop"),
        ("compliant", "spring"),
        ("records", "2  cell, tables"),
        ("panels", "roll, slip"),
        ("physics", "model"),
    ),
)
ON_THE_WAY = ("scenario", "records", "rigid", "simulation", "results")  # of one motion


def draw_code(path: Path) -> None:
    """The packages in rows, with the way of one motion."""
    figure, ax = plt.subplots(figsize=(7.6, 4.4), layout="constrained")
    for i, row in enumerate(CODE):
        width = 1.0 / len(row)
        for k, (name, words) in enumerate(row):
            on_the_way = name in ON_THE_WAY
            color = colors.SERIES[1] if on_the_way else colors.GRAY
            place = (k * width + 0.006, -i + 0.1)
            ax.add_patch(plt.Rectangle(place, width - 0.012, 0.8, fill=False, ec=color, lw=2.5 if on_the_way else 1.0))
            middle = (k + 0.5) * width
            ax.text(middle, -i + 0.64, name, ha="center", va="center", fontsize=11, family="monospace")
            ax.text(middle, -i + 0.32, words, ha="center", va="center", fontsize=10, color=color)
    kernel = len(CODE) - 1
    ax.text(-0.015, -kernel + 0.5, "kernel/", ha="right", va="center", fontsize=11, family="monospace")
    ax.set(xlim=(-0.11, 1.0), ylim=(-kernel, 1.0))
    ax.axis("off")
    save(figure, path)


FIGURES = {
    "required-friction.svg": draw_required_friction,
    "phases.svg": draw_phases,
    "proof-widths.svg": draw_widths,
    "track-fit.svg": draw_track,
    "track-frame.jpg": draw_marked_frame,
    "phone-record.svg": draw_phone,
    "film-frame.png": draw_film,
    "article-hop.svg": draw_article,
    "camera.svg": draw_camera,
    "code.svg": draw_code,
}


def draw(folder: Path) -> None:
    """All of them."""
    for name, draw_one in FIGURES.items():
        draw_one(folder / name)
