"""`hophoop map`: a map over parameters, into a file and a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand


def _quantity_names() -> list[str]:
    from hophoop.maps.grid.quantities import QUANTITIES, SETTLED

    return [*QUANTITIES, *SETTLED]


class MapCommand(TyperCommand):
    """The command with a list of quantities in its help."""

    def get_help(self, ctx: Any) -> str:
        """Return the help; print the quantities of a map with their meaning and unit."""
        text = super().get_help(ctx)  # printed by Typer
        typer.echo(_quantity_list())
        return text


def _quantity_list() -> str:
    from hophoop.maps.grid.quantities import QUANTITIES, SETTLED
    from hophoop.vocabulary.quantities import with_unit

    wide = max(len(name) for name in QUANTITIES) + 2
    parts = {"Quantities": QUANTITIES, "Quantities of --span settled and settled:landing": SETTLED}
    lines: list[str] = []
    for title, table in parts.items():
        rows = (f"  {name:{wide}}{with_unit(quantity.meaning, quantity.unit)}" for name, quantity in table.items())
        lines += [title, "", *rows, ""]
    return "\n".join(lines)


COMMAND_CLASS = MapCommand


def map(
    how: Annotated[Any, "hophoop.maps.grid.sweeping:sweep"],
    file: str | None = None,
    axis: list[str] | None = None,
    quantity: Annotated[list[str] | None, _quantity_names] = None,
    out: Path | None = None,
    resume: bool = False,
    plot: Path | None = None,
    scheduler: str | None = None,
    quiet: bool = False,
) -> None:
    """Compute a map over parameters of a scenario (by default the reference hoop).

    Arguments
    ---------
    file : [FILE]
        Scenario to vary; '-' is standard input.

    Options
    -------
    axis
        Parameters with their values: path=first:last:count, path=first:last:count:log or path=a,b,c.
    quantity
        Quantity of the map, by default sequence, see the list below.
    span
        first_revolution, takeoff, reversal, duration, revolutions:N, settled or settled:landing.
    out
        File of the map, ending in .zarr or .nc.
    resume
        Resume a map that was stopped.
    plot
    threads
        Number of cores; by default all.
    scheduler
        Address of a Dask scheduler, whose workers compute instead.
    quiet
    """
    from hophoop._support.stopping import say_when_stopped
    from hophoop.cli._output import PICTURES, check_outputs, named_options, save_picture
    from hophoop.maps.grid.axes import parse_axis
    from hophoop.maps.grid.memory import check_memory
    from hophoop.maps.grid.sweeping import sweep
    from hophoop.scenario import InputError, Scenario

    if out is None and plot is None:
        raise InputError("--out or --plot must name a file for the map.")
    if resume and out is None:
        raise InputError("--out must name the map to resume.")
    check_outputs({"--out": (out, ()), "--plot": (plot, PICTURES)}, file)
    base = Scenario() if file is None else Scenario.load(file)
    axes = {}
    for text in axis or ():
        with named_options({"count": f"--axis {text}: count"}):
            path, values = parse_axis(text)
        if path in axes:
            raise InputError(f"--axis names {path} twice.")
        axes[path] = values
    if plot is not None and len(axes) != 2:
        raise InputError(f"--plot needs a map of two axes, not {len(axes)}.")
    quantities = quantity or ["sequence"]
    if plot is not None or out is None:
        # a picture needs its values, colours and mesh in memory
        shape = [len(values) for values in axes.values()]
        check_memory(shape, ["f8"] * 6, "use fewer values, or --out without --plot")
    say_when_stopped(lambda: _stop_message(out))
    with named_options({"axes": "--axis"}):
        dataset = sweep(base, axes, quantities, out=out, resume=resume, scheduler=scheduler, progress=not quiet, **how)
    if plot is not None:
        from hophoop.plots.maps import motion_map

        save_picture(motion_map(dataset, quantities[0]), plot, "figure")
    if out is not None:
        typer.echo(f"{dataset[quantities[0]].size:,} motions in {out}", err=True)


def _stop_message(out: Path | None) -> str:
    """Message after a stop."""
    from hophoop.maps.grid.sweeping import place_of

    place = None if out is None else place_of(out)
    kept = f"; what is done is kept in {place}, and --resume goes on" if place is not None and place.exists() else ""
    return f"Stopped{kept}."
