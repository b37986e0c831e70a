"""`hophoop track`: where the hoop is in each frame of a film."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._options import numbers, panel
from hophoop.cli._output import check_outputs, named_options

in_output, in_film = panel("Output"), panel("The film")
in_hints, in_camera = panel("Hints, if the hoop is not found"), panel("Camera")


def track(
    video: Annotated[Path, typer.Argument(metavar="VIDEO", help="A film in any format of FFmpeg.", show_default=False)],
    radius: Annotated[float, typer.Option(help="Outer radius of the rim, m, for the scale.", show_default=False)],
    out: Annotated[
        Path | None,
        in_output(metavar="DIR", help="Folder for index.html, overlay.mp4, track.json, track.csv."),
    ] = None,
    save: Annotated[Path | None, in_output(metavar="FILE", help="The track: .json (everything) or .csv.")] = None,
    overlay: Annotated[Path | None, in_output(metavar="FILE", help="Film with the track drawn over it, .mp4.")] = None,
    quiet: Annotated[bool, in_output("--quiet", help="Show no progress.")] = False,
    rate: Annotated[float | None, in_film(help="Frames per second as taken, if the file is in slow motion.")] = None,
    since: Annotated[float | None, in_film("--from", help="Time from which to track, s.")] = None,
    until: Annotated[float | None, in_film("--to", help="Time up to which to track, s.")] = None,
    exposure: Annotated[float, in_film(help="Exposure time, s.")] = 0.0,
    row_delay: Annotated[float, in_film(help="Rolling shutter: delay from row to row, s.")] = 0.0,
    pick: Annotated[bool, in_hints("--pick", help="Click on the hoop in a still, on a page.")] = False,
    marker_color: Annotated[str, in_hints(help="Colour of the marker: auto, none, a name such as red, or #rrggbb.")] = "auto",
    ring: Annotated[str, in_hints(help="auto, dark or light.")] = "auto",
    centre: Annotated[str | None, in_hints(metavar="COLUMN,ROW", help="The hoop's centre in a frame, pixels.")] = None,
    rim: Annotated[float | None, in_hints(help="Radius of the rim in that frame, pixels.")] = None,
    at: Annotated[float, in_hints(help="Time of that frame, s.")] = 0.0,
    ground: Annotated[
        str | None,
        in_camera(metavar="C,R,C,R", help="Two points of the ground line below the rim, pixels."),
    ] = None,
    level_deg: Annotated[float, in_camera(help="Rise of a level line to the right in the picture, degrees.")] = 0.0,
    slope_deg: Annotated[float | None, in_camera(help="Slope of the plane, downhill to the right, degrees.")] = None,
    tilt_deg: Annotated[
        str | None,
        in_camera(
            metavar="A,B",
            help="Rotation of the plane of motion about the picture's horizontal and vertical axis, degrees; 0,0 without tilt. "
            "Found from the film by default.",
        ),
    ] = None,
    focal: Annotated[float | None, in_camera(help="Focal length, pixels.")] = None,
) -> None:
    """Track a hoop in a film: time, centre, angle and their uncertainties per frame; status 1 if the track is doubtful."""
    from hophoop._support.progress import bar
    from hophoop.cli import NO_ANSWER, say
    from hophoop.tracking import Hints
    from hophoop.tracking import track as find
    from hophoop.tracking.doubts import DOUBT

    outputs = {"--out": (out, None), "--save": (save, (".json", ".csv")), "--overlay": (overlay, (".mp4",))}
    check_outputs(outputs, video, "the film")
    tilt = None if tilt_deg is None else numbers("--tilt-deg", tilt_deg, 2)
    with named_options({"level": "--level-deg", "slope": "--slope-deg", "tilt": "--tilt-deg"}):
        hints = Hints(
            marker_color=marker_color,
            ring=ring,
            centre=None if centre is None else numbers("--centre", centre, 2),
            rim=rim,
            at=at,
            ground=None if ground is None else numbers("--ground", ground, 4),
            level=math.radians(level_deg),
            slope=None if slope_deg is None else math.radians(slope_deg),
            exposure=exposure,
            row_delay=row_delay,
            rate=rate,
            since=since,
            until=until,
            tilt=None if tilt is None else (math.radians(tilt[0]), math.radians(tilt[1])),
            focal=focal,
        )
        if pick:
            hints = _pick(video, hints)
        with bar("tracking", quiet=quiet) as progress:
            found = find(video, radius, hints, progress)
    say(f"Found in {int(found.found.sum())} of {len(found.t)} frames. " + " ".join(found.notes))
    _write(found, video, out, save, overlay, quiet)
    if any(note.startswith(DOUBT) for note in found.notes):
        raise typer.Exit(NO_ANSWER)


def _write(found: Any, video: Path, out: Path | None, save: Path | None, overlay: Path | None, quiet: bool) -> None:
    from hophoop._support.progress import bar
    from hophoop.cli import say
    from hophoop.tracking import overlay as draw

    page = None
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
        found.save(out / "track.json")
        found.save(out / "track.csv")
        page, overlay = out / "index.html", overlay or out / "overlay.mp4"
    if save is not None:
        found.save(save)
    if overlay is not None:
        with bar("drawing", quiet=quiet) as progress:
            draw(video, found, overlay, page, progress)
    if out is not None:
        say(f"The page: {out / 'index.html'}")
    if out is None and save is None and overlay is None:
        _print(found)


def _print(found: Any) -> None:
    import csv
    import sys

    csv.writer(sys.stdout, lineterminator="\n").writerows(found.rows())


def _pick(video: Path, hints: Any) -> Any:
    from hophoop.lab.server.pick import pick

    return pick(video, hints)
