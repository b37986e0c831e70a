"""Tracks from files: our own, and tables of any program."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from hophoop.scenario import InputError
from hophoop.tracking.columns import TableError, read_columns
from hophoop.tracking.quantities import Reading, Sheet, track_from_sheet
from hophoop.tracking.table import Track, parse_json, track_from_dict

MOST_BYTES = 500_000_000
TRACKER, TABLES, OWN = (".trk", ".trz"), (".csv", ".txt", ".tsv", ".dat"), (".json",)
SHEETS = (".xlsx", ".xls", ".xlsm", ".ods", ".numbers")
UTF_16 = (b"\xff\xfe", b"\xfe\xff")


def read_track(path: str | Path, reading: Reading | None = None) -> Track:
    """Read a track.

    Parameters
    ----------
    path : str or Path
        A track of `track` (.json or .csv), or a table with named columns as programs export it: times, and x and y of the
        centre, those of the marker, the angle, or the angular velocity.
    reading : Reading, optional
        Quantities that the file lacks.

    Returns
    -------
    track : Track

    Raises
    ------
    ValueError
        If the file has another format.
    OSError
        If it cannot be read.
    """
    file, how = Path(path), reading or Reading()
    size, ending = file.stat().st_size, file.suffix.lower()
    if ending in TRACKER:
        raise InputError(f"{file} is a project of Tracker: open it there and save its points with File, Export, Data.")
    if size > MOST_BYTES:
        raise InputError(f"{file} is larger than {MOST_BYTES // 1_000_000} MB, which no track is.")
    if ending in SHEETS:
        raise InputError(f"{file} is a spreadsheet: save the sheet as CSV.")
    text = _text(file)
    if ending in OWN:
        data = parse_json(text, str(file))
        if how.columns or how.units or how.rate:
            raise InputError(
                f"{file} is a track of hophoop, with columns and times of its own: columns, units and rate are for tables."
            )
        track = track_from_dict(data, str(file))
    elif ending in TABLES:
        try:
            track = track_from_sheet(Sheet(how, *read_columns(text, how.rate)), file.name)
        except TableError as error:
            raise InputError(f"{file} {error}") from None
    else:
        raise InputError(f"{file} must end in {', '.join((*OWN, *TABLES[:-1]))} or {TABLES[-1]}.")
    radius = track.radius if how.radius is None else how.radius  # which the file may lack
    return replace(track, radius=radius).between(how.since, how.until)


def _text(file: Path) -> str:
    """Return a file's text in an encoding of spreadsheets: a name such as 'angle (°)' is not ASCII."""
    data = file.read_bytes()
    for encoding in ("utf-16",) if data.startswith(UTF_16) else ("utf-8-sig", "cp1252"):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise InputError(f"{file} is not text: a track is a table or JSON.")
