"""`hophoop diagram`: on what a hoop settles, over a parameter."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from hophoop.gaits.diagram import Diagram

STORES = (".nc", ".csv")


def diagram(
    scenario: Any,
    how: Annotated[Any, "hophoop.gaits.diagram:diagram"],
    axis: str,
    file: Any = None,
    out: Path | None = None,
    plot: Path | None = None,
    quiet: bool = False,
) -> None:
    """Compute on what a hoop settles, over a parameter and from several starts; Ctrl-C keeps the values that are done.

    Options
    -------
    axis
        path=first:last:count, path=first:last:count:log or path=a,b,c.
    starts
        Starts for each value.
    passages
        The most passages of each motion.
    section
        bottom (load at the bottom) or landing.
    out
        File of the attractors, ending in .nc or .csv.
    plot, quiet
    """
    from hophoop._support.progress import bar
    from hophoop.cli._output import PICTURES, check_outputs, named_options
    from hophoop.gaits.diagram import diagram as computed
    from hophoop.maps.grid.axes import parse_axis
    from hophoop.scenario import InputError

    if out is None and plot is None:
        raise InputError("--out or --plot must name a file for the diagram.")
    check_outputs({"--out": (out, STORES), "--plot": (plot, PICTURES)}, file)
    with named_options({"count": f"--axis {axis}: count"}):
        path, values = parse_axis(axis)
    if values.dtype.kind != "f":
        raise InputError(f"--axis {axis} must have numbers.")
    with bar(path, quiet=quiet, share=True) as progress:
        found = computed(scenario, path, values, progress=progress, **how)
    _write(found, out, plot)
    if not found.complete:
        raise KeyboardInterrupt


def _write(found: Diagram, out: Path | None, plot: Path | None) -> None:
    from hophoop._support.files import netcdf_errors, replacing
    from hophoop.cli._output import save_picture

    if plot is not None:
        from hophoop.plots.diagram import diagram as drawn

        save_picture(drawn(found), plot)
    if out is not None:
        with replacing(out) as place:
            if out.suffix == ".nc":
                with netcdf_errors(place):
                    found.to_xarray().to_netcdf(place, engine="netcdf4")
            else:
                place.write_text(found.to_csv(), encoding="utf-8")
    names = " and ".join(str(path) for path in (out, plot) if path is not None)
    typer.echo(f"{len(found.values)} values of {found.path} in {names}", err=True)
