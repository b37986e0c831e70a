"""Reasons to doubt a track: a hoop that is none, a marker that does not turn with it, a film whose times are wrong."""

from __future__ import annotations

import numpy as np

from hophoop._support.extras import need
from hophoop.tracking.hints import TINY
from hophoop.tracking.scatter import Complexes, Flags, Floats, spread, third_differences

LEAST_TURN = 0.25  # minimum rotation of a marker per radius that the hoop goes; rolling has 1, a skid less [rad]
MOSTLY = 0.5  # minimum share of the frames in which a marker is visible, and of a rim that is seen in half of the frames
UNSTEADY = 0.005  # change of the step between frames above which a hoop may be none, over the radius
STEEP = 15.0  # tilt of the plane of motion that is unusual [degrees]
FAST = 10.0  # speed that is unusual, over the root of gravity times radius
GRAVITY = 9.81  # [m/s²]
CHANGED = 1.7  # ratio of times or steps between frames that is no scatter
STILL = 0.3  # change of a repeated picture over the usual change
LIVELY = 0.9  # share of the pictures that change less than usual, or repeat the one before
SHAKES = 0.15  # step of a repeated picture, as found again, over those before and after it
EVEN, MOST = 1.2, 0.8  # ratio of times between pictures of one rate, and the minimum share of these
MOVES = 1.0  # step between frames that is seen [pixel]
DOUBLE = 1.5  # ratio of the step after a repeated picture to a usual one, if the film has lost a picture there
NO_ACCIDENT = 3  # repeated pictures that are no accident
FEWEST_ROWS = 10  # of a table from which its scatter is judged
ROUNDING = 0.3  # standard deviation of a number by its rounding, over the last digit
NEAR, ON_GRID = 20.0, 0.05  # squares of distances on a square grid, over that of its points: range, error as an integer
CLEAR = 8.0  # step of the hoop, over the scatter of its places, that neither scatter nor rounding hides
MOSTLY_CLEAR = 0.25  # minimum share of the equal rows that are clear copies; others may be equal by rounding
DOUBT = "Doubtful: "


def doubt_hoop(centre: Complexes, agreement: Floats, step: float, radius: float, tilt: float) -> list[str]:
    """Doubt that the circles are those of a hoop.

    centre: shape (n,), in the complex plane, nan where lost, over the radius [1]; agreement: shape (n,), share of the rim that
    is seen [1]; step: usual time between frames [s]; radius: of the hoop [m]; tilt: of the plane of motion [rad].
    """
    ways, changes = np.abs(np.diff(centre)), np.abs(np.diff(centre, 2))
    seen = np.nanmedian(agreement)
    said = [f"only {100 * seen:.0f} % of a rim are seen in half of the frames"] if seen < MOSTLY else []
    if np.isfinite(changes).any() and np.nanmedian(changes) > max(UNSTEADY, 0.5 * np.nanmedian(ways)):
        said.append("the circle jumps back and forth")
    speed = radius / step * np.nanquantile(ways, 0.9) if np.isfinite(ways).any() else 0.0
    if speed > FAST * np.sqrt(GRAVITY * radius):
        said.append(f"it moves at {speed:.0f} m/s")
    if not said:
        return []
    if np.degrees(tilt) > STEEP:
        said.append(f"its plane is tilted by {np.degrees(tilt):.0f}°")
    return [f"{DOUBT}perhaps this is no hoop: {', and '.join(said)}. Look at the overlay, and show the hoop by --pick."]


def doubt_marker(x: Floats, angle: Floats) -> list[str]:
    """Doubt that the patch taken for the marker turns with the hoop, from positions in radii and angles."""
    there, marked = np.isfinite(x).sum(), np.isfinite(angle)
    distance, turned = (np.ptp(values[marked]) if marked.any() else 0.0 for values in (x, angle))
    if distance > 1.0 and turned < LEAST_TURN * distance:
        said = f"the hoop moves by {distance:.1f} radii while the patch taken for the marker turns by {turned:.2f} rad"
    elif marked.sum() < MOSTLY * there:
        said = f"the marker is visible in only {marked.sum()} of {there} frames with the hoop"
    else:
        return []
    return [f"{DOUBT}{said}. Look at the overlay, and give the marker's colour (--marker-color) or use --marker-color none."]


def steps_of(centre: Complexes, mark: Complexes, radius: float) -> Floats:
    """Distance that the rim goes from one frame to the next, shape (n − 1,), nan where it is lost; all in pixels."""
    arrow = mark - centre
    turned = np.angle(arrow[1:] * arrow[:-1].conj())
    steps: Floats = np.hypot(np.abs(np.diff(centre)), radius * np.nan_to_num(turned))
    return steps


def repeated(changes: Floats, steps: Floats) -> Flags:
    """Return True for each picture that repeats the one before while the hoop moves.

    changes: shape (n,), mean change of luma from the picture before [1]; steps: shape (n − 1,), as `steps_of` returns them.
    """
    # also where most pictures repeat, and of a rim that coding moves a little
    quiet = changes[1:] < STILL * np.nanquantile(changes, LIVELY)
    still = quiet & ((steps < 0.3 * MOVES) | shakes(steps))
    clear = copies(still, steps > MOVES)
    return copies(still, ~still) if clear.sum() >= NO_ACCIDENT else clear  # then also in slow parts


def shakes(steps: Floats) -> Flags:
    """Return True for steps that are much smaller than those before and after them."""
    padded = np.pad(steps, 1)
    return np.asarray(steps < SHAKES * np.fmin(padded[:-2], padded[2:]))


def copies(same: Flags, moves: Flags) -> Flags:
    """Return True for each row that is a copy of the one before, of a hoop that moves before and after the copies.

    A run of equal rows at an end is one of copies if it is no longer than another one; a hoop at rest stays longer.

    same, moves: shape (n − 1,), whether a row equals the one before, and whether the hoop moves in between; again: shape (n,).
    """
    again, ends = np.append(False, same), np.flatnonzero(np.diff(np.pad(same, 1).astype(int)))
    runs = ends.reshape(-1, 2)
    inside = np.pad(moves, 1)[runs + np.array([0, 1])]
    whole = inside.all(axis=1)
    length = np.diff(runs, axis=1)[:, 0]
    at_end = (runs == [0, len(same)]) | inside
    whole |= at_end.all(axis=1) & (length <= length[whole].max(initial=0))
    for first, last in runs[~whole]:
        again[first + 1 : last + 1] = False
    return again


def repeated_rows(places: list[Complexes], count: int) -> tuple[Floats, Flags]:
    """Return steps of the hoop over the scatter of its places, and which rows of a table are copies of the one before.

    Rows that are equal by rounding are none: there the hoop moves by no more than that.

    places: of each point in the complex plane and an angle, shape (count,), nan where unknown, each in any unit; steps: shape
    (count − 1,) [1]; again: shape (count,).
    """
    steps, again = np.zeros(count - 1), np.zeros(count, dtype=bool)
    there = np.flatnonzero(np.isfinite(places).any(axis=0)) if places else np.zeros(0, dtype=int)
    if len(there) < FEWEST_ROWS:
        return steps, again
    values = np.array(places)[:, there]
    ways, unknown = np.abs(np.diff(values)), np.isnan(values)
    same = ((ways == 0) | (unknown[:, 1:] & unknown[:, :-1])).all(axis=0)
    fresh = np.append(True, ~same)
    numbers = there[fresh].astype(float), np.arange(fresh.sum(), dtype=float)  # if copies replace others, or are added
    moves = np.zeros(len(same))
    for way, known in zip(ways, values[:, fresh], strict=True):
        scatter = min(max(_scatter(number, known.real), _scatter(number, known.imag)) for number in numbers)
        moves = np.fmax(moves, way / max(scatter, ROUNDING * _grid(way), TINY))
    clear, equal = copies(same, moves > CLEAR).sum(), copies(same, ~same).sum()
    if clear >= max(NO_ACCIDENT, MOSTLY_CLEAR * equal):
        again[there] = copies(same | shakes(moves), ~same)  # also in slow parts, and those marked by hand a second time
    steps[there[1:] - 1] = moves
    return steps, again


def _scatter(t: Floats, values: Floats) -> float:
    """Standard deviation of values about a smooth motion, inf if there are too few; t: shape (n,), and values with nan."""
    found = third_differences(t, values)
    return spread(found) if len(found) >= FEWEST_ROWS else np.inf


def _grid(ways: Floats) -> float:
    """Distance of the points of a square grid between which these ways are, 0 if there is none; nan where unknown."""
    known = ways[ways > 0]
    least = float(known.min(initial=np.inf))
    near = (known / least) ** 2
    near = near[near < NEAR]
    return least if len(near) >= FEWEST_ROWS and (np.abs(near - np.round(near)) < ON_GRID).all() else 0.0


def doubt_copies(t: Floats, steps: Floats, again: Flags, rows: str) -> list[str]:
    """Report copies that are left out, and doubt times which are uneven without them.

    t: shape (n,), times [s]; steps: shape (n − 1,), of the hoop from row to row [1]; again: as `copies` returns it; rows: their
    name.
    """
    count, first, last = again.sum(), again.argmax(), len(again) - 1 - again[::-1].argmax()
    if not count:
        return []
    within = slice(first - 1, last + 1)
    waits = np.diff(t[within][~again[within]]) / np.median(np.diff(t))
    usual = np.median(waits) if len(waits) else 1.0
    even = usual > EVEN and np.mean(np.abs(waits / usual - 1.0) < EVEN - 1.0) > MOST  # each picture as often
    if count >= NO_ACCIDENT and not even and not _double_after(steps, again):
        rate = (last - first + 1 - count) / (t[last] - t[first])
        return [
            f"{DOUBT}{count} of {len(t)} {rows} repeat the one before, the first at {t[first]:.3f} s, as in a "
            f"film that was converted to another rate. Give the rate at which it was taken, about --rate {rate:.0f}."
        ]
    return [f"{count} {rows} that repeat the one before are left out."]


def doubt_times(t: Floats, steps: Floats, again: Flags) -> list[str]:
    """Doubt the times of a film: two speeds, repeated pictures and dropped ones.

    t: shape (n,), times of the pictures [s]; steps: as `steps_of` returns them; again: as `repeated` returns it.
    """
    waits = np.diff(t)
    if len(waits) < 12:
        return []
    usual = need("scipy.ndimage", "track").median_filter(waits, 5, mode="nearest")
    if usual.max() > CHANGED * usual.min():
        slow = usual > np.sqrt(usual.min() * usual.max())
        fast = f"{1 / usual.min():.0f}"
        return [
            f"{DOUBT}the film plays at two speeds, {fast} and {1 / usual.max():.0f} frames per second, "
            f"which change at {t[np.argmax(slow != slow[0])]:.3f} s. "
            f"If it was taken at one rate, give that, such as --rate {fast}; otherwise keep to one part by --from and --to."
        ]
    said = doubt_copies(t, steps, again, "pictures")
    gaps = waits > CHANGED * usual
    if gaps.any():
        missing = np.round(waits[gaps] / usual[gaps] - 1).sum()
        said.append(
            f"{missing:.0f} pictures are missing in the film, the first after {t[gaps.argmax()]:.3f} s; "
            "its times allow for that."
        )
    speeds = steps / waits
    ratio = speeds[1:-1] / np.maximum(speeds[:-2], speeds[2:])
    leaps = (ratio > CHANGED) & (np.minimum(steps[:-2], steps[2:]) > MOVES) & ~again[1:-2] & ~gaps[1:-1]
    if leaps.any():
        k = leaps.argmax() + 1
        said.append(
            f"{DOUBT}between {t[k]:.3f} s and {t[k + 1]:.3f} s the hoop goes {steps[k]:.1f} pixels, "
            f"{ratio[k - 1]:.1f} times as fast as before and after. Look at the overlay there: if pictures are "
            "missing, keep to one side by --from or --to."
        )
    return said


def count_taken(steps: Floats, again: Flags) -> Floats:
    """Return numbers of pictures at the rate at which they were taken: copies that were added are between them.

    steps, again: as in `doubt_copies`; shape (n,).
    """
    rows = np.arange(len(again), dtype=float)
    fresh = rows[~again]
    return rows if _double_after(steps, again) else np.interp(rows, [*fresh, len(rows)], np.arange(len(fresh) + 1))


def _double_after(steps: Floats, again: Flags) -> bool:
    """Return True if the step after a repeated picture is double: the camera lost one, and the times are right."""
    fresh = ~again[1:]
    ways, after = steps[fresh], again[:-1][fresh][1:]
    return bool(after.any()) and bool(np.nanmedian((ways[1:] / np.maximum(ways[:-1], 1e-9))[after]) > DOUBLE)
