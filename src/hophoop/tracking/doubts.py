"""Reasons to doubt a track: a hoop that is none, a marker that does not turn with it, a film whose times are wrong."""

from __future__ import annotations

import numpy as np

from hophoop._support.extras import need
from hophoop.tracking.scatter import Complexes, Flags, Floats

LEAST_TURN = 0.25  # minimum rotation of a marker per radius that the hoop goes; rolling has 1, a skid less [rad]
MOSTLY = 0.5  # minimum share of the frames in which a marker is visible, and of a rim that is seen in half of the frames
UNSTEADY = 0.005  # change of the step between frames above which a hoop may be none, over the radius
STEEP = 15.0  # tilt of the plane of motion that is unusual [degrees]
FAST = 10.0  # speed that is unusual, over the root of gravity times radius
GRAVITY = 9.81  # [m/s²]
CHANGED = 1.7  # ratio of times or steps between frames that is no scatter
STILL = 0.3  # change of a repeated picture over the usual change
MOVES = 1.0  # step between frames that is seen [pixel]
DOUBLE = 1.5  # ratio of the step after a repeated picture to a usual one, if the film has lost a picture there
FEWEST = 3  # repeated pictures that are no accident
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
    padded = np.pad(steps, 2)
    before, after = np.fmax(padded[:-4], padded[1:-3]), np.fmax(padded[3:-1], padded[4:])
    still = (changes[1:] < STILL * np.nanmedian(changes)) & (steps < 0.3 * MOVES)
    return np.concatenate([[False], still & (np.minimum(before, after) > MOVES)])


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
    said = []
    count = again.sum()
    if count >= FEWEST and not _double_after(steps, again):
        rate = (len(t) - 1 - count) / (t[-1] - t[0])
        said.append(
            f"{DOUBT}{count} of {len(t)} pictures repeat the one before, the first at {t[again.argmax()]:.3f} s: the film "
            f"was converted to another rate. Give the rate at which it was taken, about --rate {rate:.0f}."
        )
    elif count:
        said.append(f"{count} pictures that repeat the one before are left out.")
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


def _double_after(steps: Floats, again: Flags) -> bool:
    """Return True if the step after a repeated picture is double: the camera lost one, and the times are right."""
    rows = np.flatnonzero(again)
    rows = rows[(rows >= 2) & (rows < len(steps))]
    return bool(len(rows)) and bool(np.nanmedian(steps[rows] / np.maximum(steps[rows - 2], 1e-9)) > DOUBLE)
