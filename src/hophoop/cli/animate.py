"""`hophoop animate`: a film of one or several motions, in 2D or 3D, or an interactive scene for a browser."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._options import Quiet, assigned, panel, value_of, with_scenario
from hophoop.cli._output import check_folder, named_options

in_picture, in_pace, in_compare = panel("Picture"), panel("Pace"), panel("Comparison")


@with_scenario
def animate(
    scenario: Any,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            metavar="FILE",
            help="Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures; with --3d also .html, "
            "an interactive scene.",
            show_default=False,
        ),
    ],
    three_d: Annotated[bool, in_picture("--3d", help="In three dimensions.")] = False,
    size: Annotated[str, in_picture(metavar="WxH", help="Width and height in pixels.")] = "1280x720",
    theme: Annotated[str, in_picture(help="light, dark or print.")] = "light",
    camera: Annotated[
        str | None,
        in_picture(
            help="follow or hold; with --3d chase, side, orbit or hold.",
        ),
    ] = None,
    panel: Annotated[
        list[str] | None,
        in_picture(
            help="An animated plot, not with --3d: velocity, energy, forces, utilization or phase; may be repeated.",
        ),
    ] = None,
    traces: Annotated[bool, in_picture(help="Draw the traces.")] = True,
    forces: Annotated[bool, in_picture(help="Draw the contact forces.")] = True,
    shadows: Annotated[bool, in_picture(help="Cast shadows, with --3d.")] = True,
    fps: Annotated[
        float | None,
        in_pace(help="Pictures per second; by default 60, with --3d 30, in a gif 25."),
    ] = None,
    speed: Annotated[float, in_pace(help="Seconds of motion per second of film.")] = 1.0,
    slow_at: Annotated[
        list[str] | None,
        in_pace(
            metavar="EVENT|TIME",
            help="Slow motion around events of a kind, such as takeoff, or a time in s; may be repeated.",
        ),
    ] = None,
    slow_factor: Annotated[float, in_pace(help="Factor of the slow motion.")] = 8.0,
    slow_width: Annotated[
        float | None,
        in_pace(
            help="Duration of the slow motion before and after, in the motion's time, s.",
        ),
    ] = None,
    begin: Annotated[float, in_pace("--from", help="First time to show, s.")] = 0.0,
    end: Annotated[
        float | None,
        in_pace("--to", help="Last time to show, s."),
    ] = None,
    others: Annotated[
        list[str] | None,
        in_compare(
            "--with",
            metavar="FILE",
            help="Another scenario to show; may be repeated.",
        ),
    ] = None,
    vary: Annotated[
        str | None,
        in_compare(
            metavar="PATH=A,B,…",
            help="Show the scenario for several values of a parameter, such as plane.mu=0.3,1.",
        ),
    ] = None,
    overlay: Annotated[bool, in_compare("--overlay", help="Show all in one view.")] = False,
    step: Annotated[str, in_compare(help="Common quantity of the motions in a frame: time or angle.")] = "time",
    label: Annotated[
        list[str] | None,
        in_compare(help="Label of a motion, in their order; may be repeated."),
    ] = None,
    quiet: Quiet = False,
) -> None:
    """Make a film of one motion or of several, with traces and forces to scale."""
    from hophoop._support.extras import need
    from hophoop.cli import NO_ANSWER, say
    from hophoop.scenario import InputError, Scenario
    from hophoop.simulation.simulate import simulate

    match = re.fullmatch(r"(\d+)[x×](\d+)", size)
    if match is None:
        raise InputError(f"--size = {size} must be a width and a height, such as 1280x720.", field="--size", value=size)
    if three_d and (panel or overlay):
        raise InputError("--panel and --overlay cannot be given together with --3d.")
    if out.suffix:  # otherwise a folder for pictures, which is created
        check_folder("--out", out)
    scenarios = [*_variations(scenario, vary), *(Scenario.load(file) for file in others or ())]
    motions = [simulate(each) for each in scenarios]

    need("matplotlib", "films")  # in the extra 'plots', which 'films' includes
    from hophoop import animate as films

    with named_options({"start": "--from", "panels": "--panel", "labels": "--label"}):
        slow = tuple(_mark(text) for text in slow_at or ())
        timing = films.Timing(
            fps=fps,
            speed=speed,
            slow_at=slow,
            slow_factor=slow_factor,
            slow_width=slow_width,
            start=begin,
            end=end,
            step=step,
        )
        common: dict[str, Any] = {
            "size": (int(match[1]), int(match[2])),
            "theme": theme,
            "labels": label or None,
            "traces": traces,
            "forces": forces,
        }
        with films.bar(out.name, quiet=quiet) as progress:
            if not three_d:
                look = films.Look(
                    camera=camera or "follow", panels=panel or (), layout="overlay" if overlay else "side", **common
                )
                films.film(motions, out, timing, look, progress)
            else:
                space = films.Look3D(camera=camera or "chase", shadows=shadows, **common)
                if out.suffix.lower() == ".html":
                    films.scene(motions, out, timing, space)
                else:
                    films.film_3d(motions, out, timing, space, progress)
    if not quiet:
        say(f"Wrote {out}.")
    for motion in motions:
        if not motion.ok:
            say(f"A motion ends at t = {motion.duration:.9g} s: {motion.status}.")
            raise typer.Exit(NO_ANSWER)


def _variations(scenario: Any, vary: str | None) -> list[Any]:
    if vary is None:
        return [scenario]
    path, values = assigned("--vary", vary, "a path and values, such as plane.mu=0.3,1")
    return [scenario.replace(path, value_of(word.strip())) for word in values.split(",")]


def _mark(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text
