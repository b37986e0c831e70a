"""`hophoop lab`: the interactive page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def lab(
    file: Annotated[str | None, typer.Argument(metavar="[FILE]", help="Scenario to open with; '-' is standard input.")] = None,
    host: Annotated[str, typer.Option(help="Address to listen on; 0.0.0.0 answers other machines as well.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on; 0 takes a free one.")] = 8765,
    workers: Annotated[int, typer.Option(help="Processes that compute.")] = 2,
    name: Annotated[
        list[str] | None, typer.Option(help="A name under which it is reached, such as a proxy's; may be given again.")
    ] = None,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the page in a browser.")] = True,
    export: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write the lab as a folder of files for any web host instead of serving it."),
    ] = None,
) -> None:
    """Play with the hoop in a browser."""
    if export is not None:
        from hophoop.lab import site

        typer.echo(site.summary(export, site.export(export)))
        return
    from hophoop.lab.app import serve
    from hophoop.scenario import Scenario

    query = "" if file is None else Scenario.load(file).to_query()
    serve(host, port, workers, browser, query, name or ())
