"""`hophoop animate`: a film of one or several motions, in 2D or 3D, or a 3D page that turns in a browser."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer


def animate(
    files: Annotated[
        list[str], typer.Argument(metavar="FILE...", help="Scenarios; '-' is standard input. Several compare.")
    ],
    out: Annotated[
        Path,
        typer.Option(
            help="Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures; "
            "with --3d also .html or .glb, a scene that turns."
        ),
    ],
    three_d: Annotated[bool, typer.Option("--3d", help="In three dimensions.")] = False,
    fps: Annotated[
        float | None, typer.Option(help="Pictures a second; 60 in 2D, 30 in 3D, 25 in a gif.")
    ] = None,
    size: Annotated[str, typer.Option(metavar="WxH", help="Width and height in pixels.")] = "1280x720",
    theme: Annotated[str, typer.Option(help="light, dark or print.")] = "light",
    camera: Annotated[
        str | None, typer.Option(help="2D: follow or hold; 3D: chase, side, orbit or hold.")
    ] = None,
    panel: Annotated[
        list[str] | None,
        typer.Option(help="2D: a plot that runs along: velocity, energy, forces, utilization or phase; "
                     "may be repeated."),
    ] = None,
    speed: Annotated[float, typer.Option(help="Seconds of motion a second of film.")] = 1.0,
    slow_at: Annotated[
        list[str] | None,
        typer.Option(help="Kind of event, such as takeoff, or time in s, with slow motion around; "
                     "may be repeated."),
    ] = None,
    slow_factor: Annotated[float, typer.Option(help="How many times slower.")] = 8.0,
    slow_width: Annotated[
        float | None, typer.Option(help="How long before and after, in the motion's time, s.")
    ] = None,
    start: Annotated[float, typer.Option(help="First time to show, s.")] = 0.0,
    end: Annotated[float | None, typer.Option(help="Last time to show, s.")] = None,
    overlay: Annotated[bool, typer.Option("--overlay", help="Several motions in one view.")] = False,
    step: Annotated[str, typer.Option(help="What several motions have in common: time or angle.")] = "time",
    label: Annotated[
        list[str] | None, typer.Option(help="A line for each motion, in their order; may be repeated.")
    ] = None,
    traces: Annotated[bool, typer.Option(help="Draw the traces.")] = True,
    forces: Annotated[bool, typer.Option(help="Draw the contact forces.")] = True,
    shadows: Annotated[bool, typer.Option(help="3D: cast shadows.")] = True,
    quiet: Annotated[bool, typer.Option("--quiet", help="Show no progress.")] = False,
) -> None:
    """Film the motion of one or several scenarios."""
    from contextlib import nullcontext

    from hophoop import animate as films
    from hophoop.scenario import InputError, Scenario
    from hophoop.simulation import simulate

    match = re.fullmatch(r"(\d+)[x×](\d+)", size)
    if match is None:
        raise InputError(f"--size = {size!r} must be a width and a height, such as 1280x720.")
    sides = int(match[1]), int(match[2])
    motions = [simulate(Scenario.load(file)) for file in files]
    scene = three_d and out.suffix.lower() in (".html", ".glb")
    common = {
        "speed": speed,
        "slow_at": [_mark(mark) for mark in slow_at or ()],
        "slow_factor": slow_factor,
        "slow_width": slow_width,
        "start": start,
        "end": end,
        "step": step,
        "theme": theme,
        "labels": label or None,
        "traces": traces,
        "forces": forces,
    }
    if scene:
        films.scene(motions, out, **common)
    else:
        with nullcontext(None) if quiet else films.bar(out.name) as progress:
            common |= {"fps": fps, "size": sides, "progress": progress}
            if three_d:
                if panel or overlay:
                    raise InputError("--panel and --overlay belong to films in 2D.")
                films.film_3d(motions, out, camera=camera or "chase", shadows=shadows, **common)
            else:
                layout = "overlay" if overlay else "side"
                films.film(
                    motions, out, camera=camera or "follow", panels=panel or (), layout=layout, **common
                )
    typer.echo(f"Wrote {out}.", err=True)
    if not all(motion.ok for motion in motions):
        raise typer.Exit(1)


def _mark(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text
