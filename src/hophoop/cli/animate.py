"""`hophoop animate`: a film of one or several motions, in 2D or 3D, or an interactive scene for a browser."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._options import assigned, value_of
from hophoop.cli._output import check_folder, named_options


def animate(
    scenario: Any,
    out: Path,
    timing: Annotated[Any, "hophoop.animate:Timing"],
    look: Annotated[Any, "hophoop.animate:Look3D"],
    three_d: bool = False,
    size: str = "1280x720",
    camera: str | None = None,
    panel: Sequence[str] | None = None,
    others: list[str] | None = None,
    vary: str | None = None,
    overlay: bool = False,
    quiet: bool = False,
) -> None:
    """Make a film of one motion or of several, with traces and forces to scale.

    Options
    -------
    out
        Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures; with --3d also .html, an interactive scene.
    quiet

    Picture
    -------
    three_d : --3d
        In three dimensions.
    size : WxH
        Width and height in pixels.
    theme
    camera
        follow or hold; with --3d chase, side, orbit or hold.
    panel
        An animated plot, not with --3d: velocity, energy, forces, utilization or phase.
    traces, forces, shadows

    Pace
    ----
    fps, speed
    slow_at : EVENT|TIME
        Slow motion around events of a kind, such as takeoff, or a time in s.
    slow_factor, slow_width
    start : --from
    end : --to

    Comparison
    ----------
    others : --with FILE
        Another scenario to show.
    vary : PATH=A,B,…
        Show the scenario for several values of a parameter, such as plane.mu=0.3,1.
    overlay
        Show all in one view.
    step
    labels : --label
        Label of a motion, in their order.
    """
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

    with named_options({"start": "--from", "panels": "--panel"}):
        pace = films.Timing(**timing)
        shown: dict[str, Any] = {"size": (int(match[1]), int(match[2])), **({} if camera is None else {"camera": camera})}
        with films.bar(out.name, quiet=quiet) as progress:
            if not three_d:
                look.pop("shadows")
                layout = "overlay" if overlay else "side"
                films.film(motions, out, pace, films.Look(panels=panel or (), layout=layout, **shown, **look), progress)
            elif out.suffix.lower() == ".html":
                films.scene(motions, out, pace, films.Look3D(**shown, **look))
            else:
                films.film_3d(motions, out, pace, films.Look3D(**shown, **look), progress)
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
