"""`hophoop lab`: the interactive page."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Any

import typer


def lab(
    server: Annotated[Any, "hophoop.lab.server:serve"],
    file: str | None = None,
    browser: bool = True,
    film: Path | None = None,
    export: Path | None = None,
    docs: str | None = None,
    url: str | None = None,
) -> None:
    """Play with the hoop in a browser.

    Arguments
    ---------
    file : [FILE]
        Scenario to open with, or a fit (fit.json); '-' is standard input.

    Options
    -------
    host
        Address to listen on; 0.0.0.0 answers other machines as well.
    port
        Port to listen on; 0 for a free one.
    names : --name
        Host name of the lab.
    browser
        Open the page in a browser.
    film : VIDEO
        With a fit: the tracked film, as the background.
    export : PATH
        Write the lab instead of serving it: as NAME.html one file that opens by a double click, else a folder for any web host.
    docs : URL
        With --export: address of this documentation, for teachers; a URL or a path like ../.
    url : URL
        With --export: address at which it will be, for pictures in previews of links, and for the links that a file copies.
    """
    if export is not None:
        from hophoop.lab import export as site

        typer.echo(site.summary(export, site.export(export, docs or "", url or "")))
        return
    from hophoop.scenario import InputError, Scenario

    if docs is not None:
        raise InputError("--docs needs --export: it is a link in the exported pages.")
    if url is not None:
        raise InputError("--url needs --export: it is the address of the exported pages.")
    found = fit_of_file(file)
    if found is None:
        if film is not None:
            raise InputError("--film needs a fit to a track of that film, such as fitted/fit.json.")
        from hophoop.lab.server import serve

        query = "" if file is None else Scenario.load(file).to_query()
        serve(browser=browser, query=query, **server)
        return
    open_fit(found, film, browser=browser, **server)


def fit_of_file(file: str | None) -> Any:
    """Return the fit in a file, or None."""
    if file is None or not file.lower().endswith(".json") or not Path(file).is_file():
        return None
    with open(file, "rb") as stream:
        head = stream.read(200)
    if b'"hophoop-fit/' not in head:
        return None
    from hophoop.fitting import load_fit

    return load_fit(file)


def open_fit(found: Any, film: Path | None, **server: Any) -> None:
    """Serve the lab with a fit's scenario and its film under the hoop; `server` goes to `hophoop.lab.server.serve`."""
    from hophoop._support.progress import bar
    from hophoop._support.stopping import temporary_folder
    from hophoop.lab.server import serve

    with temporary_folder() as folder:
        backdrop = None
        if film is not None:
            from hophoop.fitting import backdrop as prepare

            with bar("preparing the film") as progress:
                backdrop = prepare(found, film, folder / "film.mp4", progress)
        serve(query=rounded(found).scenario.to_query(), backdrop=backdrop, **server)


def rounded(found: Any) -> Any:
    """Return a fit with its values rounded to a part of their errors, and level if its slope is within its error."""
    from dataclasses import replace

    from hophoop.fitting.parameters import PARAMETERS

    values = dict(found.values)
    for name in found.free:
        error, value = found.error(name), values[name]
        if name == "slope" and abs(value) <= error:
            values[name] = 0.0
        elif error > 0.0:
            scale = math.pi / 180.0 if PARAMETERS[name].unit == "rad" else 1.0  # the page shows degrees
            values[name] = scale * round(value / scale, -math.floor(math.log10(error / scale / 3.0)))
    return replace(found, values=values)
