"""From the columns of a table to a track: which column is which quantity, and questions where a table leaves it open."""

from __future__ import annotations

import re
import shlex
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from hophoop.scenario import InputError
from hophoop.tracking.columns import Column, TableError, several_runs, unit_factor
from hophoop.tracking.dialects import CENTRE, KIND, MARKER, PIXELS, SHOWN, UNITS
from hophoop.tracking.doubts import count_taken, doubt_copies, repeated_rows
from hophoop.tracking.hints import require_above_0
from hophoop.tracking.scatter import Flags, Floats
from hophoop.tracking.table import COLUMNS, Track, track_of

CHANNELS = ("frame", *COLUMNS)
CERTAIN = COLUMNS.keys() - {"t", "x", "y", "angle", "omega"}  # quantities whose name has only one meaning
MOST_NAMED = 12  # columns that a remark names
ALIKE = 0.97  # minimum mean resultant length of the difference between an angle and the direction to the marker [1]
PLACES = (("x", "y"), ("marker_x", "marker_y"), ("angle",))
FEWEST = 10  # rows from which steps of times are judged
STEPS = (1e-4, 1.0)  # possible steps of a camera or sensor [s]
RATES = (24, 25, 30, 50, 60, 100, 120, 200, 240, 250, 300, 400, 480, 500, 960, 1000)  # usual ones [Hz]
REACH = (0.005, 3.0)  # possible distances of a marker from the centre [m]
STEADY = 0.1  # range of the length of a ruler in all rows, over that length
STILL = 0.2  # way of a centre that does not move, and its distance from the height of the radius, over the radius


@dataclass(frozen=True)
class Reading:
    """Quantities that a file of a track may lack.

    Parameters
    ----------
    centre : str, optional
        Name of the point at the centre, or of a column of it.
    marker : str, optional
        Name of the point at the marker, or of a column of it.
    columns : dict, optional
        Columns as the file spells them, or by their numbers from 1, by quantity: t, frame, x, y, marker_x, marker_y, angle,
        omega, or another one of `Track.save`. Columns that are not given are found by their names, among those of the same
        run.
    units : dict, optional
        Units by quantity, where the file has none or a wrong one: m, cm, mm, in; s, ms, us, ns, min; rad, deg; rad/s, deg/s, or
        the size of one in SI units and radians, negative for an axis in the other direction. x and y include the marker's.
    rate : float, optional
        Frames per second as taken, if the file has frames, or one row per frame, instead of times [1].
    since : float, optional
        Time from which the motion is free [s]; earlier rows are left out.
    until : float, optional
        Time up to which it is free [s].
    radius : float, optional
        Radius of the rim [m], if the data lack it.

    Raises
    ------
    ValueError
        If a value is not allowed.
    """

    centre: str | None = None
    marker: str | None = None
    columns: Mapping[str, str] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    rate: float | None = None
    since: float | None = None
    until: float | None = None
    radius: float | None = None

    def __post_init__(self) -> None:
        for field_name, names in (("columns", self.columns), ("units", self.units)):
            for name in names:
                if name not in CHANNELS:
                    raise InputError(f"{field_name} cannot name {name!r}; it can name {', '.join(CHANNELS)}.", field=field_name)
        for name, unit in self.units.items():
            if unit_factor(unit, KIND[name]) is None:
                allowed = f"{SHOWN.get(KIND[name], 'none')}, or a number other than 0"
                raise InputError.of_field(f"units {name}", unit, allowed)
        require_above_0(radius=self.radius, rate=self.rate)


def question(said: str, *options: str) -> TableError:
    """Return the error of a table that leaves something open, with options that answer it."""
    answer = " or ".join(filter(None, options))
    return TableError(f"{said}{f': give {answer}' if answer else ''}.")


@dataclass(frozen=True)
class Sheet:
    """Columns of a table, which get their quantities."""

    how: Reading
    columns: list[Column]
    notes: list[str]
    used: dict[str, Column] = field(default_factory=dict)

    def free(self, *quantities: str) -> list[Column]:
        """Columns of some quantities, or all, that have numbers and are not used yet."""
        rest = [column for column in self.columns if column not in self.used.values() and np.isfinite(column.values).any()]
        return [column for column in rest if not quantities or column.quantity in quantities]

    def option(self, **wanted: Column) -> str:
        """Options that name columns: by their heads, or by their numbers where heads do not tell them apart."""
        labels = [column.head.casefold() for column in self.columns]
        words = []
        for channel, column in wanted.items():
            clear = labels.count(column.head.casefold()) == 1 and re.fullmatch(r"[^\W\d][^'\"\n]*", column.head)
            words.append(f"--column {shlex.quote(f'{channel}={column.head if clear else column.number}')}")
        return " ".join(words)

    def such(self, *channels: str) -> str:
        """Options that name columns without a meaning, '' if there are too few."""
        free = self.free("")
        return self.option(**dict(zip(channels, free, strict=False))) if len(free) >= len(channels) else ""

    @property
    def listed(self) -> str:
        """Its columns as the file spells them."""
        return f"its columns are {', '.join(column.label for column in self.columns)}"

    def only(self, found: list[Column], channel: str) -> Column | None:
        """Return the one column that was found, None if there is none; two are asked for."""
        if len(found) > 1:
            both = f"{found[0].label} and {found[1].label}"
            raise question(f"has the columns {both} for {channel}", *(self.option(**{channel: one}) for one in found[:2]))
        return found[0] if found else None


def track_from_sheet(sheet: Sheet, source: str) -> Track:
    """Return the track of a table; source: name of the file."""
    _use_named(sheet)
    used = sheet.used
    # points of other programs are not along and above the plane; our own table's are
    ours = {"sigma_x", "sigma_y"} <= used.keys()
    _find_rotation(sheet, _find_positions(sheet))
    for a, b in (("x", "y"), ("y", "x"), ("marker_x", "marker_y"), ("marker_y", "marker_x")):
        if a in used and b not in used:
            raise question(f"has a column {used[a].label}, but none for {b}; {sheet.listed}", sheet.such(b))
    if not {"x", "marker_x", "angle", "omega"} & used.keys():
        said = f"has neither x and y, nor marker_x and marker_y, nor angle, nor omega; {sheet.listed}"
        raise question(said, sheet.such("x", "y"))
    t, again = times(sheet)
    values = {channel: _converted(sheet, channel) for channel in used if channel not in ("t", "frame")}
    if "angle" in values:
        values["angle"] = unwrapped(values["angle"])
    if "x" in values:
        arm = [values.get(f"marker_{axis}", np.nan) - values[axis] for axis in ("x", "y")]
        towards = unwrapped(np.arctan2(*arm))
        if not ours:
            check(sheet, values, np.hypot(*arm), towards)
        apart = np.exp(1j * (values.setdefault("angle", towards) - towards))
        if np.isfinite(apart).any() and abs(np.nanmean(apart)) < ALIKE:
            values["angle"] = towards
            said = "contradicts the line from the centre to the marker: the marker is used."
            sheet.notes.append(f"{used['angle'].label} {said}")
    if "omega" in values:
        _orient(sheet, values, t)
    keep = np.isfinite(t) & ~again
    if not ours:  # a row with a time only is a frame without marks
        keep &= np.isfinite(list(values.values())).any(axis=0)
    rest = [one for one in sheet.columns if one not in used.values() and one.quantity != "polar"]
    unused = [one.label for one in rest if one.label != "state"]
    if unused:
        more = f" and {len(unused) - MOST_NAMED} more" if len(unused) > MOST_NAMED else ""
        sheet.notes.append(f"Columns of {source} that are not used: {', '.join(unused[:MOST_NAMED])}{more}.")
    rows = {channel: numbers[keep] for channel, numbers in values.items()}
    return track_of(t[keep], rows, source=source, placed=ours, notes=tuple(sheet.notes))


# --- columns ---------------------------------------------------------------------------------------


def _use_named(sheet: Sheet) -> None:
    """Use the columns that are named, and keep only the columns of one run."""
    named = {channel: _named(sheet, channel, label.strip()) for channel, label in sheet.how.columns.items()}
    if not named and not any(column.head for column in sheet.columns):
        raise _unnamed(sheet)
    chosen = named.values() or [column for column in sheet.columns if column.quantity in ("x", "y", "angle", "omega")]
    groups = list(dict.fromkeys(column.group for column in chosen if column.group))
    if len(groups) > 1 and not named:
        first = [next(column for column in sheet.columns if column.group == group) for group in groups]
        options = [sheet.option(**{column.quantity: column}) for column in first]
        raise question("has several runs, or sensors with times of their own", *options)
    if groups:
        kept = [column for column in sheet.columns if column.group in ("", *groups)]
        clocks = [column for column in kept if column.quantity == "t"]
        if any(not np.array_equal(clocks[0].values, clock.values, equal_nan=True) for clock in clocks):
            raise question("has other times for some of the columns that are named")
        sheet.columns[:] = kept + [column for column in sheet.columns if column.quantity == "t" and not clocks]
    sheet.used.update({column.quantity: column for column in sheet.columns if column.quantity in CERTAIN} | named)


def _named(sheet: Sheet, channel: str, label: str) -> Column:
    """Return the column that is named by its head or its number."""
    named = [column for column in sheet.columns if column.head.casefold() == label.casefold()]
    found = named or [column for column in sheet.columns if str(column.number) == label]
    if column := sheet.only(found, channel):
        return column
    raise question(f"has no column {label!r}; {sheet.listed}", sheet.such(channel))


def _unnamed(sheet: Sheet) -> TableError:
    """Return the question of a table without heads, with the numbers of columns and the units that read it."""
    rest, such = sheet.free(), ["--rate 240"]
    if clock := next((column for column in rest if (np.diff(column.values) > 0).all()), None):
        rest.remove(clock)
        such = [sheet.option(t=clock), f"--unit t={_unit_of_times(clock.values)}"]
    if len(rest) in (2, 4):
        such.append(sheet.option(**dict(zip(("x", "y", "marker_x", "marker_y"), rest, strict=False))))
    elif rest:
        such.append(_as_sensor(sheet, rest))
    return question("has no row of column names, to name columns by their numbers", " ".join(such))


def _as_sensor(sheet: Sheet, axes: list[Column]) -> str:
    """Options that name the axis of a gyroscope with the most rotation."""
    return sheet.option(omega=max(axes, key=_size)) + " --unit omega=rad/s"


def _size(column: Column) -> float:
    """Mean square of a column."""
    return float(np.nanmean(column.values**2))


# --- quantities ------------------------------------------------------------------------------------


def _find_positions(sheet: Sheet) -> str | None:
    """Find the columns of centre and marker; return the name of the point at the centre."""
    named = {"x", "y", "marker_x", "marker_y"} & sheet.used.keys()
    axes = [column for column in sheet.columns if column.quantity in ("x", "y", "z")]
    if not named and {column.quantity for column in axes} == {*"xyz"} and not any(column.unit for column in axes):
        if "omega" not in sheet.used:
            raise _places_or_sensor(sheet, "has three axes without units", axes)
        return None
    roles = _roles(sheet, asks=not named)
    for prefix, point in roles.items():
        for axis in ("x", "y"):
            found = [column for column in point if column.quantity == axis]
            if prefix + axis not in named and (column := sheet.only(found, prefix + axis)):
                sheet.used[prefix + axis] = column
    return next((column.point for column in roles.get("", [])), None)


def _places_or_sensor(sheet: Sheet, said: str, axes: list[Column]) -> TableError:
    """Return the question whether axes are places or those of a sensor."""
    places = {column.quantity: column for column in axes if column.quantity != "z"}
    shown = ", ".join(column.label for column in axes)
    return question(f"{said}, {shown}, of places or of a sensor", _as_sensor(sheet, axes), sheet.option(**places))


def _roles(sheet: Sheet, *, asks: bool) -> dict[str, list[Column]]:
    """Return the columns of the centre, under '', and of the marker, under 'marker_': as given, by their names or numbers.

    asks: whether one is needed.
    """
    how, free = sheet.how, sheet.free("x", "y")
    points: dict[str, list[Column]] = {}
    for column in free:
        points.setdefault(column.point, []).append(column)
    marked = any(re.search(MARKER, point.lower()) for point in points)
    alone = sorted(column.quantity for column in free) == ["x", "y"] and not marked
    if asks and alone and not (how.centre or how.marker):  # such as place x and height y
        return {"": free}
    shown = ", ".join(repr(point) if point else "one without a name" for point in points)
    roles: dict[str, list[Column]] = {}
    for prefix, said, words in (("", how.centre, CENTRE), ("marker_", how.marker, MARKER)):
        fit = [those for point, those in points.items() if re.search(words, point.lower())]
        if said is not None:
            fit = [points[one.point] for one in free if said in (one.point, one.label, re.sub(r"\s*[(\[].*", "", one.label))]
            if not fit:
                raise question(f"has no point {said!r}; its points are {shown}")
        if len(fit) == 1 or said is not None:
            roles[prefix] = fit[0]
    rest = [those for point, those in points.items() if not point or point.isdigit() or len(points) == 1]
    rest = [those for those in rest if those not in roles.values()]
    if len(rest) == 2 and not roles:
        rest.sort(key=_rise_and_fall)
        sheet.notes.append(
            f"{rest[0][0].label} is taken for the centre and {rest[1][0].label}, which rises and falls more, for the marker; "
            "--centre and --marker name others."
        )
    elif len(rest) > 1:
        rest = []
    roles |= zip([prefix for prefix in ("", "marker_") if prefix not in roles], rest, strict=False)
    if asks and points and not roles:
        centre, marker = map(shlex.quote, list(points)[:2])
        such = f"--centre {centre} --marker {marker}"
        raise question(f"has the points {shown}, and which are the centre and the marker is open", such)
    return roles


def _rise_and_fall(point: list[Column]) -> float:
    """Standard deviation of a point's y."""
    return max((float(np.nanstd(column.values)) for column in point if column.quantity == "y"), default=0.0)


def _find_rotation(sheet: Sheet, centre: str | None) -> None:
    """Find the column of the angle, or without angle and marker that of the angular velocity."""
    angles = [column for column in sheet.free("angle") if column.point in ("", centre)]
    if angles:
        sheet.used.setdefault("angle", angles[0])
    polar = sheet.free("polar")
    if polar and "angle" not in sheet.used:
        sheet.notes.append(
            f"{polar[0].label} is the direction as seen from the axes, not the rotation of the hoop: it is not used."
        )
    rates = sorted(sheet.free("omega"), key=_size, reverse=True)
    if rates and not {"angle", "marker_x", "omega"} & sheet.used.keys():
        sheet.used["omega"] = rates[0]
        if len(rates) > 1:
            sheet.notes.append(
                f"The angular velocity is that of {rates[0].label}, the axis with the most rotation; "
                f"{sheet.option(omega=rates[1])} names another one."
            )


def _converted(sheet: Sheet, channel: str) -> Floats:
    """Return values of a column in SI units and radians."""
    units, column, kind = sheet.how.units, sheet.used[channel], KIND[channel]
    given = units.get(channel, units.get(channel.removeprefix("marker_"), column.unit))
    if not kind or given in PIXELS:
        return column.values
    factor = unit_factor(given, kind)
    if factor is not None:
        return column.values * factor
    said = f"gives {column.label} in an unknown unit" if given else f"has no unit of {column.label}"
    usual = {"rad": "deg", "rad/s": "deg/s"}.get(kind, kind)
    raise question(f"{said}; known units are {SHOWN[kind]}", f"--unit {channel}={usual}")


def unwrapped(angle: Floats) -> Floats:
    """Return an angle without jumps of whole revolutions; nan stays."""
    result, there = angle.copy(), np.isfinite(angle)
    result[there] = np.unwrap(angle[there])
    return result


# --- times -----------------------------------------------------------------------------------------


def times(sheet: Sheet) -> tuple[Floats, Flags]:
    """Return times of the rows, and which are copies of the one before; from a column of times or from the numbers of frames.

    t, again: shape (n,) [s].
    """
    used = sheet.used
    named_by_unit = [column for column in sheet.free("") if column.unit in UNITS["s"].keys() - {""}]
    clock = used.get("t") or (None if "frame" in used else sheet.only(sheet.free("t") or named_by_unit, "t"))
    frames = used.get("frame") or sheet.only(sheet.free("frame"), "frame")
    points = [np.array([used[axis].values for axis in axes]) for axes in PLACES if used.keys() >= {*axes}]
    steps, again = repeated_rows([point[0] + 1j * point[1:].sum(axis=0) for point in points], len(sheet.columns[0].values))
    if sheet.how.rate:
        t = _counted(sheet, frames, clock, count_taken(steps, again)) / sheet.how.rate
        require_one_run(t)
        if again.any():
            sheet.notes.append(f"{again.sum()} rows that repeat the one before are left out.")
        return t, again
    if clock is None:
        said = "numbers of frames instead of times" if frames else "no column of times"
        growing = [column for column in sheet.free() if column is not frames and (np.diff(column.values) > 0).all()]
        rate = "--rate 240, the frames per second as taken (rate= in a Reading)"
        raise question(f"has {said}; {sheet.listed}", *(sheet.option(t=column) for column in growing[:1]), rate)
    used["t"] = clock
    t = _converted(sheet, "t")
    require_one_run(t)
    check_times(sheet, t)
    sheet.notes.extend(doubt_copies(t, steps, again, "rows"))
    return t, again


def require_one_run(t: Floats) -> None:
    """Refuse a table in which times start again; t: shape (n,), nan where unknown [s]."""
    rows = np.flatnonzero(np.isfinite(t))
    for k in np.flatnonzero(np.diff(t[rows]) < 0) + 1:
        if min(k, len(rows) - k) >= 3 and t[rows[k]] - t[rows[0]] < 0.5 * (t[rows[k - 1]] - t[rows[0]]):
            raise several_runs(rows[k] + 1, "where the times start again")


def _counted(sheet: Sheet, frames: Column | None, clock: Column | None, taken: Floats) -> Floats:
    """Return the numbers of frames: of their column, of times that are none, or of the rows."""
    column = frames or clock
    if column is not None:
        sheet.used["frame"] = column
        known = column.values[np.isfinite(column.values)]
        if (known == np.round(known)).all() and (frames or not column.unit):
            return column.values + taken - np.arange(len(taken))
        if uneven(known):
            sheet.notes.append(f"The rows are counted, since the times in {column.label} repeat or come in bursts.")
        elif taken[-1] == len(taken) - 1:
            raise question("has times, no numbers of frames: leave out --rate (rate= in a Reading)")
    return taken


def uneven(t: Floats) -> bool:
    """Return True for times that repeat, or that come in bursts."""
    steps = np.diff(t)
    long = steps > 5.0 * np.median(steps)
    return bool((steps == 0).any() or (long.sum() > 2 and long.mean() > 0.03))


def check_times(sheet: Sheet, t: Floats) -> None:
    """Ask about times that no camera or sensor has: their step, repeated ones and bursts; t: in seconds."""
    t = t[np.isfinite(t)]
    steps = np.diff(t)
    if (steps < 0).any() or not (steps > 0).any():
        return  # refused by all tracks
    clock, step = sheet.used["t"], _usual_step(t)
    if len(t) >= FEWEST and not STEPS[0] <= step < STEPS[1] and "t" not in sheet.how.units:
        frames = not clock.unit and (steps == 1).all()
        raise question(
            f"has times in {clock.label} with a step of {step:.3g} s, which no camera or sensor has",
            "--rate 240, if these are frames (rate= in a Reading)"
            if frames
            else f"--unit t={_unit_of_times(clock.values[np.isfinite(clock.values)])}",
        )
    if uneven(t):
        rate = 1.0 / step
        usual = min(RATES, key=lambda one: abs(one - rate))
        doubt = max(0.01, steps.max() / (t[-1] - t[0]))
        raise question(
            f"has times in {clock.label} that repeat or come in bursts",
            f"--rate {usual if abs(usual - rate) < doubt * rate else round(rate, 1)}, if rows are evenly spaced",
        )


def _usual_step(t: Floats) -> float:
    """Return the median step of times, or the mean one where they repeat or come in bursts."""
    return float(np.polyfit(np.arange(len(t)), t, 1)[0] if uneven(t) else np.median(np.diff(t)))


def _unit_of_times(t: Floats) -> str:
    """Return the unit with which the step of times is a usual one."""
    step = _usual_step(t)
    units = (name for name in ("s", "ms", "us", "ns", "d") if 5e-4 <= step * UNITS["s"][name] <= 0.5)
    return next(units, f"{1 / (240 * step):.3g}")


# --- values ----------------------------------------------------------------------------------------


def check(sheet: Sheet, values: dict[str, Floats], reach: Floats, angle: Floats) -> None:
    """Ask about lengths and places that no hoop has.

    reach, angle: of the marker from the centre [m], [rad].
    """
    column, x, y = sheet.used["x"], values["x"], values["y"]
    there = np.isfinite(reach)
    usual = np.median(reach[there]) if there.any() else 0.1
    if "x" not in sheet.how.units and (column.unit in PIXELS or not REACH[0] < usual < REACH[1]):
        raise _lengths(sheet, x[there], angle[there])
    radius = sheet.how.radius or 0.0
    still = np.nanmax(x) - np.nanmin(x) < STILL * radius < abs(np.nanmedian(y) - radius)
    if still and not column.unit and "x" not in sheet.how.columns:
        said = "has a centre that neither moves nor is at the height of the radius"
        raise _places_or_sensor(sheet, said, [column, sheet.used["y"]])


def _lengths(sheet: Sheet, x: Floats, angle: Floats) -> TableError:
    """Return the question for the unit of lengths, with the size and direction that rolling suggests."""
    size, rolls = 0.01, bool(sheet.how.radius and len(x) > 2 and np.ptp(angle) > 1.0)
    if sheet.how.radius and rolls:
        size = sheet.how.radius / np.polyfit(angle, x, 1)[0] * (unit_factor(sheet.used["x"].unit, "m") or 1.0)
    known = next((unit for unit in ("cm", "mm", "in") if abs(size / UNITS["m"][unit] - 1.0) < 0.1), "")
    unit = known or f"{abs(size):.2g}"
    y, down = (f"-{unit}", ", with y downwards,") if size < 0 else (unit, "")
    said = f"it, or the size of one in m, by --unit x={unit} --unit y={y}"
    if rolls and not known:
        rulers = [one for one in sheet.free("") if one.unit in PIXELS and np.ptp(one.values) < STEADY * one.values.min()]
        ruler = f" ({rulers[0].label}, about {np.median(rulers[0].values):.4g}, if it is one)" if rulers else ""
        said += (
            ". This size is only an estimate, as if the hoop never slipped: add --free scale, or give the length of a ruler in "
            f"m divided by that in the table{ruler}"
        )
    return question(f"has lengths{down} whose unit is missing or wrong", said)


def _orient(sheet: Sheet, values: dict[str, Floats], t: Floats) -> None:
    """Count an angular velocity as that of a hoop that rolls to greater x: a sensor may look to either side."""
    way = np.gradient(values["x"], t) if "x" in values else 1.0
    if np.nansum(values["omega"] * way) < 0:
        values["omega"] = -values["omega"]
        sheet.notes.append(f"The sign of {sheet.used['omega'].label} is reversed, for a hoop that rolls to the right.")
