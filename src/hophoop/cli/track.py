"""`hophoop track`: where the hoop is in each frame of a film."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._output import check_outputs


def track(
    video: Path,
    radius: float,
    hints: Annotated[Any, "hophoop.tracking:Hints"],
    out: Path | None = None,
    save: Path | None = None,
    overlay: Path | None = None,
    quiet: bool = False,
    pick: bool = False,
) -> None:
    """Track a hoop in a film: time, centre, angle and their uncertainties per frame; status 1 if the track is doubtful.

    Arguments
    ---------
    video : VIDEO
        A film in any format of FFmpeg.

    Options
    -------
    radius
        Outer radius of the rim, m, for the scale.

    Output
    ------
    out : DIR
        Folder for overlay.mp4, track.svg, track.json, track.csv.
    save
        The track: .json (everything) or .csv.
    overlay
        Film with the track drawn over it, .mp4.
    quiet

    The film
    --------
    rate
    since : --from
    until : --to
    exposure, row_delay

    Hints, if the hoop is not found
    -------------------------------
    pick
        Click on the hoop in a still, on a page.
    marker_color, ring
    centre : COLUMN,ROW
    rim, at

    Camera
    ------
    ground : C,R,C,R
    level : --level-deg
    slope : --slope-deg
    tilt : --tilt-deg A,B
    focal
    """
    from hophoop._support.progress import bar
    from hophoop.cli import NO_ANSWER, say
    from hophoop.tracking import Hints
    from hophoop.tracking import track as find
    from hophoop.tracking.doubts import DOUBT

    outputs = {"--out": (out, None), "--save": (save, (".json", ".csv")), "--overlay": (overlay, (".mp4",))}
    check_outputs(outputs, video, "the film")
    known = Hints(**hints)
    if pick:
        from hophoop.lab.pick import pick as picked

        known = picked(video, known)
    with bar("tracking", quiet=quiet) as progress:
        found = find(video, radius, known, progress)
    say(f"Found in {int(found.found.sum())} of {len(found.t)} frames. " + " ".join(found.notes))
    _write(found, video, out, save, overlay, quiet)
    if any(note.startswith(DOUBT) for note in found.notes):
        raise typer.Exit(NO_ANSWER)


def _write(found: Any, video: Path, out: Path | None, save: Path | None, overlay: Path | None, quiet: bool) -> None:
    from hophoop._support.extras import need
    from hophoop._support.files import replacing
    from hophoop._support.progress import bar
    from hophoop.cli import say
    from hophoop.plots import track as plot
    from hophoop.tracking import overlay as draw

    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
        found.save(out / "track.json")
        found.save(out / "track.csv")
        with replacing(out / "track.svg") as figure:
            plot(found, need("matplotlib.figure", "track").Figure()).savefig(figure)
        overlay = overlay or out / "overlay.mp4"
    if save is not None:
        found.save(save)
    if overlay is not None:
        with bar("drawing", quiet=quiet) as progress:
            draw(video, found, overlay, progress)
    if out is not None:
        say(f"Look at {overlay} and {out / 'track.svg'}")
    if out is None and save is None and overlay is None:
        _print(found)


def _print(found: Any) -> None:
    import csv
    import sys

    csv.writer(sys.stdout, lineterminator="\n").writerows(found.rows())
