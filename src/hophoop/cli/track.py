"""`hophoop track`: where the hoop is in each frame of a film."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Any

import typer

OUTPUT, FILM, HINTS, CAMERA = "Output", "The film", "Hints, if the hoop is not found", "Camera"


def track(
    video: Annotated[Path, typer.Argument(metavar="VIDEO", help="A film in any format of FFmpeg.", show_default=False)],
    radius: Annotated[float, typer.Option(help="Outer radius of the rim, m, for the scale.", show_default=False)],
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Folder for index.html, overlay.mp4, track.json, track.csv.", rich_help_panel=OUTPUT),
    ] = None,
    save: Annotated[
        Path | None, typer.Option(metavar="FILE", help="The track: .json (everything) or .csv.", rich_help_panel=OUTPUT)
    ] = None,
    overlay: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Film with the track drawn over it, .mp4.", rich_help_panel=OUTPUT)
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="Show no progress.", rich_help_panel=OUTPUT)] = False,
    rate: Annotated[
        float | None, typer.Option(help="Frames per second as taken, if the file is in slow motion.", rich_help_panel=FILM)
    ] = None,
    since: Annotated[float | None, typer.Option("--from", help="Time from which to track, s.", rich_help_panel=FILM)] = None,
    until: Annotated[float | None, typer.Option("--to", help="Time up to which to track, s.", rich_help_panel=FILM)] = None,
    exposure: Annotated[float, typer.Option(help="Exposure time, s.", rich_help_panel=FILM)] = 0.0,
    row_delay: Annotated[float, typer.Option(help="Rolling shutter: delay from row to row, s.", rich_help_panel=FILM)] = 0.0,
    pick: Annotated[
        bool, typer.Option("--pick", help="Click on the hoop in a still, on a page.", rich_help_panel=HINTS)
    ] = False,
    marker_color: Annotated[
        str, typer.Option(help="Colour of the marker: auto, none, a name such as red, or #rrggbb.", rich_help_panel=HINTS)
    ] = "auto",
    ring: Annotated[str, typer.Option(help="auto, dark or light.", rich_help_panel=HINTS)] = "auto",
    centre: Annotated[
        str | None, typer.Option(metavar="COLUMN,ROW", help="The hoop's centre in a frame, pixels.", rich_help_panel=HINTS)
    ] = None,
    rim: Annotated[float | None, typer.Option(help="Radius of the rim in that frame, pixels.", rich_help_panel=HINTS)] = None,
    at: Annotated[float, typer.Option(help="Time of that frame, s.", rich_help_panel=HINTS)] = 0.0,
    ground: Annotated[
        str | None,
        typer.Option(metavar="C,R,C,R", help="Two points of the ground line below the rim, pixels.", rich_help_panel=CAMERA),
    ] = None,
    level_deg: Annotated[
        float, typer.Option(help="Rise of a level line to the right in the picture, degrees.", rich_help_panel=CAMERA)
    ] = 0.0,
    slope_deg: Annotated[
        float | None, typer.Option(help="Slope of the plane, downhill to the right, degrees.", rich_help_panel=CAMERA)
    ] = None,
    tilt_deg: Annotated[
        str | None,
        typer.Option(
            metavar="A,B",
            help="Rotation of the plane of motion about the picture's horizontal and vertical axis, degrees; 0,0 without tilt. "
            "Found from the film by default.",
            rich_help_panel=CAMERA,
        ),
    ] = None,
    focal: Annotated[float | None, typer.Option(help="Focal length, pixels.", rich_help_panel=CAMERA)] = None,
) -> None:
    """Track a hoop in a film: time, centre, angle and their uncertainties per frame; status 1 if the track is doubtful."""
    from hophoop._support.progress import bar
    from hophoop.cli import NO_ANSWER, say
    from hophoop.cli._output import named_options
    from hophoop.tracking import Hints
    from hophoop.tracking import track as find
    from hophoop.tracking.doubts import DOUBT

    _check(out, save, overlay, video)
    tilt = _numbers("--tilt-deg", tilt_deg, 2)
    with named_options({"level": "--level-deg", "slope": "--slope-deg", "tilt": "--tilt-deg"}):
        hints = Hints(
            marker_color=marker_color,
            ring=ring,
            centre=_numbers("--centre", centre, 2),
            rim=rim,
            at=at,
            ground=_numbers("--ground", ground, 4),
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


def _check(out: Path | None, save: Path | None, overlay: Path | None, video: Path) -> None:
    from hophoop.cli._output import check_apart, check_ending, check_folder

    if save is not None:
        check_ending("--save", save, (".json", ".csv"))
        check_folder("--save", save)
    if overlay is not None:
        check_ending("--overlay", overlay, (".mp4",))
        check_folder("--overlay", overlay)
    named = [path for path in (out, save, overlay) if path is not None]
    check_apart(named)
    if any(path.absolute() == video.absolute() for path in named):
        from hophoop.scenario import InputError

        raise InputError(f"{video} is the film itself: name another file for the output.")


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


def _numbers(option: str, text: str | None, count: int) -> Any:
    from hophoop.scenario import InputError

    if text is None:
        return None
    try:
        values = tuple(float(word) for word in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count:
        raise InputError(f"{option} {text} must be {count} numbers with commas between them.")
    return values
